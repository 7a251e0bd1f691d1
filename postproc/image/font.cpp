#include "postproc/image/font.h"

#include <ft2build.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>

#include "lib/base/printable_text.h"
#include FT_FREETYPE_H
#include FT_ADVANCES_H
#include FT_MODULE_H
#include FT_OUTLINE_H
#include FT_SYSTEM_H

// The only file that uses FreeType.

namespace gouge {
namespace {

constexpr double kBoxAdvance = 0.6, kBoxSide = 0.05, kBoxHeight = 0.73,
                 kBoxStroke = 0.05;  // relative to the font size

// Returns whether a character without a glyph takes no room and so shows nothing. Such characters choose a variant of
// the previous one.
bool takes_no_width(std::string_view text, std::size_t at, const CodePoint& c) {
  return display_width(text.substr(at, c.bytes)) == 0;
}

std::uint8_t sum(int a, int b) { return static_cast<std::uint8_t>(std::min(a + b, 255)); }

class Pen {
 public:
  Pen(double width, double size, double shift) : size_(size), shift_(shift) {
    const int margin = static_cast<int>(std::ceil(0.5 * size)) + 1;
    mask_.left = -margin;
    mask_.top = -static_cast<int>(std::ceil(1.25 * size));
    mask_.width = static_cast<int>(std::ceil(width * size)) + 2 * margin;
    mask_.height = -mask_.top + static_cast<int>(std::ceil(0.5 * size));
    mask_.grey.assign(static_cast<std::size_t>(mask_.width) * static_cast<std::size_t>(mask_.height), 0);
  }

  void glyph(FT_Face face, FT_UInt index, double x) {
    if (FT_Set_Char_Size(face, 0, std::lround(64 * size_), 72, 72) != 0) return;
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) return;
    const double at = x * size_ + shift_;
    const double whole = std::floor(at);
    if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE)
      FT_Outline_Translate(&face->glyph->outline, std::lround(64 * (at - whole)), 0);
    if (FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0) return;
    const FT_Bitmap& bitmap = face->glyph->bitmap;
    if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return;
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
      const unsigned char* greys = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
      for (int k = 0; k < static_cast<int>(bitmap.width); ++k)
        add(static_cast<int>(whole) + face->glyph->bitmap_left + k, row - face->glyph->bitmap_top, greys[k]);
    }
  }

  void box(double x) {
    const int stroke = std::max(1, static_cast<int>(std::lround(kBoxStroke * size_)));
    const int left = static_cast<int>(std::lround((x + kBoxSide) * size_ + shift_));
    const int right = left + static_cast<int>(std::lround((kBoxAdvance - 2 * kBoxSide) * size_));
    const int top = -static_cast<int>(std::lround(kBoxHeight * size_));
    for (int py = top; py < 0; ++py) {
      for (int px = left; px < right; ++px) {
        const bool is_edge = px < left + stroke || px >= right - stroke || py < top + stroke || py >= -stroke;
        if (is_edge) add(px, py, 255);
      }
    }
  }

  [[nodiscard]] TextMask take() { return std::move(mask_); }

 private:
  void add(int x, int y, int grey) {
    const int column = x - mask_.left, row = y - mask_.top;
    if (column < 0 || row < 0 || column >= mask_.width || row >= mask_.height) return;
    std::uint8_t& value = mask_.grey[static_cast<std::size_t>(row) * static_cast<std::size_t>(mask_.width) +
                                     static_cast<std::size_t>(column)];
    value = sum(value, grey);
  }

  TextMask mask_;
  double size_, shift_;
};

}  // namespace

class Font::Files {
 public:
  Files(const std::vector<std::string>& regular_files, const std::vector<std::string>& bold_files) {
    if (FT_New_Library(&memory_, &library_) == 0) {
      FT_Add_Default_Modules(library_);
    } else {
      library_ = nullptr;
    }
    for (const std::string& file : regular_files) open(file, regular_);
    for (const std::string& file : bold_files) open(file, bold_);
    bold_.insert(bold_.end(), regular_.begin(), regular_.end());
  }
  ~Files() {
    for (FT_Face face : all_) FT_Done_Face(face);
    if (library_ != nullptr) FT_Done_Library(library_);
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  [[nodiscard]] bool is_empty() const { return all_.empty(); }

  [[nodiscard]] std::optional<Diagnostic> trouble() const {
    if (is_short_of_memory_) return make_error("out-of-memory", "the letters of a picture could not be drawn");
    if (unreadable_.empty()) return std::nullopt;
    return make_error("file-unreadable", "the font is there, but cannot be read, so no picture can have its letters",
                      unreadable_);
  }

  [[nodiscard]] std::pair<FT_Face, FT_UInt> find(char32_t letter, bool is_bold) const {
    for (FT_Face face : is_bold ? bold_ : regular_) {
      const FT_UInt index = FT_Get_Char_Index(face, letter);
      if (index != 0) return {face, index};
    }
    return {nullptr, 0};
  }

  // Calls place(face, glyph, x) for every letter, with no face for a box, and returns the end of the text. Positions
  // are in units of the font size, from the design of the font, so that widths are exactly proportional to the size.
  template <class Place>
  double lay_out(std::string_view words, bool is_bold, const Place& place) const {
    const std::string text = printable(words);
    double x = 0;
    FT_Face before = nullptr;
    FT_UInt glyph_before = 0;
    for (std::size_t at = 0; at < text.size();) {
      const CodePoint c = decode_utf8(text, at).value_or(CodePoint{});
      const auto [face, glyph] = find(c.value, is_bold);
      if (face != nullptr) {
        if (face == before) x += kerning(face, glyph_before, glyph);
        place(face, glyph, x);
        x += advance(face, glyph);
      } else if (!takes_no_width(text, at, c)) {
        place(face, glyph, x);
        x += kBoxAdvance;
      }
      before = face;
      glyph_before = glyph;
      at += c.bytes;
    }
    return x;
  }

  // Only one thread at a time may use the faces of FreeType.
  mutable std::mutex mutex;

 private:
  void open(const std::string& file, std::vector<FT_Face>& faces) {
    if (library_ == nullptr) return;
    FT_Face face = nullptr;
    const FT_Error failure = FT_New_Face(library_, file.c_str(), 0, &face);
    std::error_code ignored;
    if (failure == FT_Err_Cannot_Open_Resource && std::filesystem::exists(file, ignored)) unreadable_ = file;
    if (failure != 0) return;
    all_.push_back(face);
    if (face->units_per_EM > 0 && FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0) faces.push_back(face);
  }

  static double advance(FT_Face face, FT_UInt glyph) {
    FT_Fixed units = 0;
    if (FT_Get_Advance(face, glyph, FT_LOAD_NO_SCALE, &units) != 0) return 0;
    return static_cast<double>(units) / face->units_per_EM;
  }

  static double kerning(FT_Face face, FT_UInt left, FT_UInt right) {
    FT_Vector units{0, 0};
    if (!FT_HAS_KERNING(face) || FT_Get_Kerning(face, left, right, FT_KERNING_UNSCALED, &units) != 0) return 0;
    return static_cast<double>(units.x) / face->units_per_EM;
  }

  // Without memory FreeType omits parts (kerning, a glyph), and the picture would differ without a message. So the
  // failure is noted.
  static void* resize(FT_Memory memory, void* block, long bytes) {
    void* const got = std::realloc(block, static_cast<std::size_t>(bytes));
    if (got == nullptr && bytes > 0) static_cast<Files*>(memory->user)->is_short_of_memory_ = true;
    return got;
  }
  static void* allocate(FT_Memory memory, long bytes) { return resize(memory, nullptr, bytes); }
  static void release(FT_Memory, void* block) { std::free(block); }
  static void* reallocate(FT_Memory memory, long, long bytes, void* block) { return resize(memory, block, bytes); }

  FT_MemoryRec_ memory_{this, allocate, release, reallocate};
  FT_Library library_ = nullptr;
  std::vector<FT_Face> all_, regular_, bold_;
  std::atomic<bool> is_short_of_memory_ = false;
  std::string unreadable_;  // a font file that cannot be read; empty: none
};

Font::Font(const std::vector<std::string>& regular_files, const std::vector<std::string>& bold_files)
    : files_(std::make_unique<Files>(regular_files, bold_files)) {}

Font::~Font() = default;

bool Font::has_letters() const { return !files_->is_empty(); }

std::optional<Diagnostic> Font::trouble() const { return files_->trouble(); }

bool Font::has_letter(char32_t letter) const {
  const std::lock_guard lock(files_->mutex);
  return files_->find(letter, false).first != nullptr;
}

double Font::width(std::string_view text, bool is_bold) const {
  const std::lock_guard lock(files_->mutex);
  return files_->lay_out(text, is_bold, [](FT_Face, FT_UInt, double) {});
}

TextMask Font::draw(std::string_view text, double size, bool is_bold, double shift) const {
  Pen pen(width(text, is_bold), size, shift);
  const std::lock_guard lock(files_->mutex);
  files_->lay_out(text, is_bold, [&](FT_Face face, FT_UInt glyph, double x) {
    if (face == nullptr)
      pen.box(x);
    else
      pen.glyph(face, glyph, x);
  });
  return pen.take();
}

const Font& installed_font() {
  // The places of the fonts in Debian, Fedora and Arch.
  static const Font font(
      {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
       "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",
       "/usr/share/fonts/wqy-microhei/wqy-microhei.ttc", "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",
       "/usr/share/fonts/opentype/unifont/unifont.otf"},
      {"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf",
       "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"});
  return font;
}

Diagnostics find_missing_letters(const std::vector<std::string>& texts, const Font& font) {
  if (!font.has_letters()) return {};
  constexpr std::size_t kShown = 8;
  std::set<char32_t> missing;
  std::string shown;
  for (const std::string& words : texts) {
    const std::string text = printable(words);
    for (std::size_t at = 0; at < text.size();) {
      const CodePoint c = decode_utf8(text, at).value_or(CodePoint{});
      const bool is_new = !font.has_letter(c.value) && !takes_no_width(text, at, c) && missing.insert(c.value).second;
      if (is_new && missing.size() <= kShown) shown += text.substr(at, c.bytes);
      at += c.bytes;
    }
  }
  if (missing.empty()) return {};
  return {make_note("picture-letters", std::to_string(missing.size()) +
                                           (missing.size() == 1 ? " character" : " characters") + " of names (" +
                                           shown + (missing.size() > kShown ? "..." : "") +
                                           ") are in no font that is installed, and drawn as boxes; install "
                                           "fonts-wqy-microhei for Chinese, Japanese and Korean")};
}

}  // namespace gouge
