#include "postproc/image/font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "postproc/image/page.h"
#include "postproc/image/render_drawing.h"

namespace gouge::font_test {
namespace {

std::string picture_of(const std::string& text) {
  Drawing d;
  d.width = 300;
  d.height = 40;
  d.items.push_back(DrawnText{{5, 30}, text, 20, {0, 0, 0, 1}, TextAnchor::left, false});
  return *render_png(d);
}

TEST(Font, HasTheLettersOfEurope) {
  ASSERT_TRUE(installed_font().has_letters()) << "fonts-dejavu-core is not installed";
  for (const char32_t letter : std::u32string_view(U"AzÄßŁżőΦωЖя°µØ≤–"))
    EXPECT_TRUE(installed_font().has_letter(letter)) << static_cast<unsigned>(letter);
  EXPECT_TRUE(find_missing_letters({"Torusfräser Ø12", "Фреза", "Φ12"}).empty());
}

TEST(Font, PicturesShowLettersApart) {
  EXPECT_NE(picture_of("Torusfräser"), picture_of("Torusfraser"));
  EXPECT_NE(picture_of("Фреза"), picture_of("Дрель"));
  EXPECT_EQ(picture_of("Фреза"), picture_of("Фреза"));
}

TEST(Font, DrawsABoxForWhatItLacksAndNotesItOnce) {
  const char32_t kPrivate = 0x10FFF0;
  ASSERT_FALSE(installed_font().has_letter(kPrivate));
  const std::string lacking = "\U0010FFF0";
  const Diagnostics notes = find_missing_letters({"a" + lacking, lacking + "b", "\U0010FFF1"});
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].severity, Severity::note);
  EXPECT_EQ(notes[0].message.substr(0, 21), "2 characters of names");
  const TextMask box = installed_font().draw(lacking, 40, false, 0);
  EXPECT_GT(std::count(box.grey.begin(), box.grey.end(), 255), 50);
  EXPECT_GT(installed_font().width("a" + lacking, false), installed_font().width("a", false) + 0.5);
}

TEST(Font, WithoutFilesEverythingIsABoxAndNothingIsNoted) {
  const Font none({"no/such/font.ttf", "/dev/null"}, {});
  EXPECT_FALSE(none.has_letters());
  EXPECT_TRUE(find_missing_letters({"abc"}, none).empty());
  const TextMask boxes = none.draw("ab", 20, true, 0.5);
  EXPECT_GT(std::accumulate(boxes.grey.begin(), boxes.grey.end(), 0), 0);
}

TEST(Font, LettersKeepTheirShapeAndStandOnTheBaseLine) {
  const TextMask one = installed_font().draw("H", 100, false, 0), two = installed_font().draw("H", 100, false, 0);
  EXPECT_EQ(one.grey, two.grey);
  const auto row_is_empty = [&](int y) {
    const auto first = one.grey.begin() + static_cast<std::ptrdiff_t>(y - one.top) * one.width;
    return std::all_of(first, first + one.width, [](std::uint8_t grey) { return grey == 0; });
  };
  EXPECT_TRUE(row_is_empty(0));
  EXPECT_FALSE(row_is_empty(-1));
  EXPECT_FALSE(row_is_empty(-70));
  EXPECT_TRUE(row_is_empty(-80));
}

TEST(Fitted, CutsBetweenLettersNotWithinThem) {
  const std::string name = "球頭フライス球頭フライス球頭フライス";
  for (double width = 30; width < 400; width += 7) {
    const std::string text = fitted(name, 15, width);
    EXPECT_LE(text_width(text, 15), width);
    EXPECT_EQ(text.find('\\'), std::string::npos);
    EXPECT_TRUE(find_missing_letters({text}).empty() || !find_missing_letters({name}).empty()) << text;
    for (const char* half : {"\xE7...", "\x90..."}) EXPECT_EQ(text.find(half), std::string::npos) << text;
  }
  EXPECT_EQ(fitted("a\nb", 15, 400), "a\\nb");
}

}  // namespace
}  // namespace gouge::font_test
