#include <gtest/gtest.h>

#include "postproc/image/ascii_text.h"
#include "postproc/image/render_drawing.h"

namespace gouge::render_test {
namespace {

Drawing small_drawing() {
  Drawing d;
  d.width = 120;
  d.height = 80;
  d.items.push_back(DrawnShape{{{10, 10}, {60, 10}, {60, 60}}, {200, 30, 30, 0.5}});
  d.items.push_back(DrawnLine{{{0, 0}, {120, 80}}, {0, 0, 0, 1}, 2, false, {6, 3}});
  d.items.push_back(DrawnText{{60, 40}, "\xC3\x98 12 <mm> & \"x\"", 14, {0, 0, 0, 1}, TextAnchor::middle, true});
  return d;
}

TEST(RenderPng, StartsWithTheSignatureAndShowsItsSize) {
  const Result<std::string> png = render_png(small_drawing());
  ASSERT_TRUE(png);
  ASSERT_GT(png->size(), 24U);
  EXPECT_EQ(png->substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
  EXPECT_EQ((*png)[19], 120);
  EXPECT_EQ((*png)[23], 80);
}

TEST(RenderPng, IsTheSameOnEveryRun) { EXPECT_EQ(*render_png(small_drawing()), *render_png(small_drawing())); }

TEST(RenderPng, ChangesWithEveryItem) {
  const std::string whole = *render_png(small_drawing());
  for (std::size_t i = 0; i < 3; ++i) {
    Drawing less = small_drawing();
    less.items.erase(less.items.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(*render_png(less), whole) << "without item " << i;
  }
}

TEST(RenderPng, RefusesAPictureWithoutArea) {
  Drawing d;
  d.width = 0;
  const Result<std::string> png = render_png(d);
  ASSERT_FALSE(png);
  EXPECT_EQ(png.error().code, "picture-size");
  EXPECT_EQ(png.error().message, "a picture must have from 1 to 16384 pixels a side");
}

TEST(RenderPng, SurvivesPointsFarOutsideAndDegenerateItems) {
  Drawing d = small_drawing();
  d.items.push_back(DrawnLine{{{-1e9, 5}, {1e9, 5}}, {0, 0, 255, 1}, 0.2, false, {}});
  d.items.push_back(DrawnLine{{}, {0, 0, 0, 1}, 1, true, {4, 4}});
  d.items.push_back(DrawnShape{{{1, 1}}, {0, 0, 0, 1}});
  d.items.push_back(DrawnText{{1e7, -1e7}, "far", 12, {}, TextAnchor::right, false});
  EXPECT_TRUE(render_png(d));
}

TEST(RenderPng, LaysRastersUnderTheDrawing) {
  Drawing d;
  d.width = 20;
  d.height = 20;
  const std::string empty = *render_png(d);
  const PlacedRaster inside{5, 5, Raster(10, 10, 255, 0, 0)};
  const PlacedRaster outside{500, 5, Raster(10, 10, 255, 0, 0)};
  EXPECT_NE(*render_png(d, {inside}), empty);
  EXPECT_EQ(*render_png(d, {outside}), empty);
}

TEST(TextWidth, GrowsWithTextAndSize) {
  EXPECT_GT(text_width("wider text", 12), text_width("text", 12));
  EXPECT_NEAR(text_width("text", 24), 2 * text_width("text", 12), 0.5);
}

TEST(RenderSvg, HoldsEveryItemEscaped) {
  const std::string svg = render_svg(small_drawing());
  EXPECT_NE(svg.find("<polygon points=\"10,10 60,10 60,60\" fill=\"#c81e1e\" fill-opacity=\"0.5\"/>"),
            std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray=\"6 3\""), std::string::npos);
  EXPECT_NE(svg.find("\xC3\x98 12 &lt;mm&gt; &amp; &quot;x&quot;</text>"), std::string::npos);
  EXPECT_EQ(svg.find("<mm>"), std::string::npos);
  EXPECT_NE(svg.find("viewBox=\"0 0 120 80\""), std::string::npos);
}

TEST(AsciiText, TransliteratesAndNeverKeepsOtherBytes) {
  EXPECT_EQ(ascii_text("Fr\xC3\xA4ser \xC3\x98 10 \xC2\xB5m 5\xC2\xB0 \xE2\x80\x93 \xC3\x9F"),
            "Fraser O 10 um 5deg - ss");
  EXPECT_EQ(ascii_text("\xC5\x81\xC3\xB3\x64\xC5\xBA"), "Lodz");
  EXPECT_EQ(ascii_text("\xFF\xE6\x97"), "???");
  EXPECT_EQ(ascii_text("\xE6\x97\xA5"), "?");
}

}  // namespace
}  // namespace gouge::render_test
