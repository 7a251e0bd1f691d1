#include "lib/mesh/ascii_stl.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/base/file_kind.h"
#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "lib/base/stage.h"

namespace gouge::detail {
namespace {

constexpr std::size_t kLongestQuote = 40;
constexpr std::size_t kMegabyte = 1'000'000;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

bool equals(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return small(a) == b; });
}

// Returns the text of the file in quotes, suitable for a message of one line.
std::string quoted(std::string_view word) {
  if (word.empty()) return "the end of the file";
  std::string text = "'";
  text += printable(word.substr(0, kLongestQuote));
  return text + (word.size() > kLongestQuote ? "...'" : "'");
}

// The words of the file one after the other, with the line of each. LF, CRLF and CR end a line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  std::string_view next() {
    skip_space();
    const std::size_t first = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && !is_line_end(text_[at_])) ++at_;
    return text_.substr(first, at_ - first);
  }

  std::string_view peek() {
    skip_space();
    const std::size_t first = at_;
    const std::string_view word = next();
    at_ = first;
    return word;
  }

  // Skips the rest of the line: it is a name, which may be any text. Only a facet may follow it on the line, because
  // some writers use no line ends at all.
  /// Skips the name of a solid. Returns whether it is text: the header of a binary STL may begin with the same word.
  [[nodiscard]] bool skip_name() {
    for (; at_ < text_.size() && !is_line_end(text_[at_]); ++at_) {
      if (text_[at_] == '\0') return false;
      if (is_blank(text_[at_]) && is_facet_at(at_ + 1)) return true;
    }
    return true;
  }

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t bytes_read() const { return at_; }

 private:
  // Returns whether a facet begins there, and not a name with the same words. In a facet the loop follows, or three
  // numbers of a normal and then the loop.
  [[nodiscard]] bool is_facet_at(std::size_t at) const {
    if (!equals(text_.substr(at, 6), "facet ")) return false;
    Words words(text_.substr(at + 6));
    std::string_view word = words.next();
    if (equals(word, "normal")) {
      for (int k = 0; k < 3; ++k) words.next();
      word = words.next();
    }
    return equals(word, "outer") && equals(words.next(), "loop");
  }

  // Skips blanks, line ends, and lines that begin with '#', which some writers put above the solid.
  void skip_space() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '#' && is_line_start_) {
        while (at_ + 1 < text_.size() && !is_line_end(text_[at_ + 1])) ++at_;
        continue;
      }
      if (c == '\n' || (c == '\r' && text_.substr(at_ + 1, 1) != "\n")) ++line_;
      if (is_line_end(c)) is_line_start_ = true;
      if (!is_blank(c) && !is_line_end(c)) {
        is_line_start_ = false;
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool is_line_start_ = true;
};

constexpr const char* kNoText =
    "expected the name of a solid, found bytes that are no text: a binary STL may follow; give each STL as a file of its own";

class AsciiParser {
 public:
  AsciiParser(std::string_view bytes, const std::string& name, const ProgressCall& progress)
      : words_(bytes),
        stage_(progress, "reading the text of " + name + ", MB", bytes.size() / kMegabyte, bytes.size()) {
    soup_.name = name;
    soup_.format = StlFormat::ascii;
    soup_.triangles.reserve(bytes.size() / 260);
  }

  Result<TriangleSoup> parse() {
    while (!words_.peek().empty()) {
      if (!parse_statement()) return *error_;
      count_megabytes();
    }
    if (soup_.triangles.empty()) {
      return make_error("stl-no-triangles", "the ASCII STL holds no facet; expected at least one", soup_.name);
    }
    if (is_in_solid_) {
      soup_.notes.push_back(make_warning("stl-no-endsolid",
                                         "the file ends without 'endsolid' after facet " +
                                             std::to_string(soup_.triangles.size()) +
                                             "; it may be cut off, export it again to be sure",
                                         soup_.name, words_.line()));
    }
    return std::move(soup_);
  }

 private:
  void count_megabytes() {
    if (words_.bytes_read() - counted_ < kMegabyte) return;
    stage_.add(words_.bytes_read() - counted_);
    counted_ = words_.bytes_read();
  }

  bool parse_statement() {
    const std::string_view word = words_.next();
    if (equals(word, "solid")) {
      if (!words_.skip_name()) return fail(kNoText);
      is_in_solid_ = true;
      return true;
    }
    if (equals(word, "endsolid") || is_end_of(word, "solid")) {
      if (!words_.skip_name()) return fail(kNoText);
      is_in_solid_ = false;
      return true;
    }
    if (equals(word, "facet")) return parse_facet();
    return fail("expected 'facet' or 'endsolid', found " + quoted(word));
  }

  // Reads a facet. Three vertices between 'facet' and 'endfacet' are a triangle. Some writers leave out words between
  // them, or write 'end facet'.
  bool parse_facet() {
    Vec3 normal = Vec3(0, 0, 0);  // a facet may have no normal; it is never needed
    if (!is_loop(words_.peek()) && !parse_normal(normal)) return false;
    skip("outer");
    if (!equals(words_.peek(), "vertex") && !expect("loop")) return false;
    std::array<Vec3, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      if (!expect_vertex(k) || !parse_vertex(triangle[static_cast<std::size_t>(k)])) return false;
    }
    if (equals(words_.peek(), "vertex")) {
      return fail("a fourth vertex in " + facet() + "; expected triangles only: export it triangulated");
    }
    if (!parse_ends()) return false;
    soup_.triangles.push_back(triangle);
    count_normal(soup_, soup_.triangles.size() - 1, triangle, normal);
    return true;
  }

  static bool is_loop(std::string_view word) {
    return equals(word, "outer") || equals(word, "loop") || equals(word, "vertex");
  }

  bool skip(std::string_view word) {
    if (!equals(words_.peek(), word)) return false;
    words_.next();
    return true;
  }

  // Returns whether `word`, which was read, and the next word are "end" and `what`. If so, the next word is read too.
  bool is_end_of(std::string_view word, std::string_view what) { return equals(word, "end") && skip(what); }

  // Reads 'endloop' and 'endfacet'. One of them may be missing, and both if another facet or the end of the solid
  // follows.
  bool parse_ends() {
    for (bool has_end_of_loop = false;;) {
      Words ahead = words_;
      std::string_view word = ahead.next();
      if (word.empty()) return cut_off();
      const bool is_apart = equals(word, "end");
      if (is_apart) word = ahead.next();
      const auto ends = [&](std::string_view joined) { return equals(word, is_apart ? joined.substr(3) : joined); };
      if (ends("endsolid") || (!is_apart && (equals(word, "facet") || equals(word, "solid")))) return true;
      const bool is_end_of_facet = ends("endfacet");
      if (!is_end_of_facet && (has_end_of_loop || !ends("endloop")))
        return expect(has_end_of_loop ? "endfacet" : "endloop");
      words_ = ahead;
      if (is_end_of_facet) return true;
      has_end_of_loop = true;
    }
  }

  // Reads a normal. For triangles without area writers put "nan" and similar words here; a normal is never needed.
  bool parse_normal(Vec3& normal) {
    if (!skip("normal") && !parse_number(words_.peek())) return expect("normal");
    for (int k = 0; k < 3; ++k) {
      if (is_loop(words_.peek()) || words_.peek().empty())
        return fail("the normal of " + facet() + " has " + std::to_string(k) + " numbers; expected 3");
      normal[k] = parse_number(words_.next()).value_or(0.0);
    }
    return true;
  }

  bool expect_vertex(int k) {
    if (equals(words_.peek(), "vertex")) {
      words_.next();
      return true;
    }
    const std::string_view found = words_.peek();
    if (found.empty()) return cut_off();
    return fail(facet() + " has " + std::to_string(k) + (k == 1 ? " vertex" : " vertices") + "; expected 3: found " +
                quoted(found) + " where 'vertex' should be");
  }

  bool parse_vertex(Vec3& vertex) {
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = words_.next();
      if (word.empty()) return cut_off();
      const std::optional<double> number = parse_number(word);
      if (!number) {
        return fail(facet() + ": expected a finite number as " + "xyz"[k] + " of a vertex, found " + quoted(word),
                    "stl-bad-number");
      }
      vertex[k] = *number;
    }
    return true;
  }

  bool expect(std::string_view expected) {
    const std::string_view found = words_.next();
    if (equals(found, expected)) return true;
    if (found.empty()) return cut_off();
    return fail("expected '" + std::string(expected) + "' in " + facet() + ", found " + quoted(found));
  }

  [[nodiscard]] std::string facet() const { return "facet " + std::to_string(soup_.triangles.size() + 1); }

  bool cut_off() {
    return fail("the file ends inside " + facet() + "; it is cut off, export or copy it again", "stl-truncated");
  }

  bool fail(std::string message, std::string code = "stl-syntax") {
    error_ = make_error(std::move(code), std::move(message), soup_.name, words_.line());
    return false;
  }

  Words words_;
  Stage stage_;
  std::size_t counted_ = 0;  // number of counted bytes
  TriangleSoup soup_;
  std::optional<Diagnostic> error_;
  bool is_in_solid_ = false;
};

}  // namespace

bool looks_like_ascii_stl(std::string_view bytes) {
  Words words(bytes);
  const std::string_view first = words.next();
  if (equals(first, "facet")) return true;
  if (!equals(first, "solid")) return false;
  static_cast<void>(words.skip_name());  // of a binary header it is no text
  const std::string_view second = words.peek();
  if (equals(second, "facet") || equals(second, "endsolid") || equals(second, "solid")) return true;
  // If neither word follows, only text is ASCII STL, because its errors deserve a line number. Otherwise it is a binary
  // header.
  return std::all_of(bytes.begin(),
                     bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(bytes.size(), 512)),
                     [](char c) { return is_blank(c) || is_line_end(c) || (c >= ' ' && c <= '~'); });
}

Result<TriangleSoup> parse_ascii_stl(std::string_view bytes, const std::string& name, const ProgressCall& progress) {
  return AsciiParser(bytes, name, progress).parse();
}

void count_normal(TriangleSoup& soup, std::size_t index, const TrianglePoints& triangle, const Vec3& stored_normal) {
  constexpr double kThinnest = 1e-3;  // area over longest side squared; below it rounding to float turns normals
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 cross = ab.cross(ac);
  const double longest2 = std::max(ab.squaredNorm(), ac.squaredNorm());
  const double turn = cross.dot(stored_normal);
  if (!std::isfinite(turn) || turn >= 0) return;
  if (cross.squaredNorm() < kThinnest * kThinnest * longest2 * longest2) return;
  if (soup.opposite_normals == 0) soup.first_opposite_normal = index;
  ++soup.opposite_normals;
}

}  // namespace gouge::detail
