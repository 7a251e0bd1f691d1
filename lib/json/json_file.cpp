#include "lib/json/json_file.h"

#include <algorithm>
#include <optional>

#include "lib/base/file_kind.h"
#include "lib/base/letters.h"

namespace gouge {
namespace {

// Scan that examines only brackets and lengths, so any text is accepted.
class LimitScan {
 public:
  LimitScan(const std::string& file, std::string_view text, const std::string& what)
      : file_(file), text_(text), what_(what) {}

  [[nodiscard]] std::optional<Diagnostic> find_excess() {
    for (at_ = 0; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        if (skip_text() > kLongestText) return too_long("a text", kLongestText);
      } else if (c == '[' || c == '{') {
        if (++depth_ > kDeepestJson) return too_deep();
      } else if (c == ']' || c == '}') {
        if (depth_ > 0) --depth_;
      } else if (c == '-' || (c >= '0' && c <= '9')) {
        if (skip_number() > kLongestNumber) return too_long("a number", kLongestNumber);
      }
    }
    return std::nullopt;
  }

 private:
  // Moves from the opening quote to the closing one, which is then at `at_`.
  std::size_t skip_text() {
    begin_ = at_;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    return at_ - begin_ - 1;
  }

  std::size_t skip_number() {
    begin_ = at_;
    const std::size_t end = text_.find_first_not_of("0123456789+-.eE", at_);
    at_ = std::min(end, text_.size()) - 1;
    return at_ + 1 - begin_;
  }

  [[nodiscard]] Diagnostic too_deep() const {
    return make_error("json-too-deep",
                      "objects and lists are nested deeper than " + std::to_string(kDeepestJson) +
                          " levels; expected " + what_ +
                          ", which needs no more than ten; the file is damaged or not one",
                      file_, line_of_byte(text_, at_));
  }

  [[nodiscard]] Diagnostic too_long(const std::string& found, std::size_t most) const {
    return make_error("json-too-long",
                      found + " of more than " + std::to_string(most) + " characters; expected " + what_ +
                          "; the file is damaged or not one",
                      file_, line_of_byte(text_, begin_));
  }

  const std::string& file_;
  std::string_view text_;
  const std::string& what_;
  std::size_t at_ = 0, begin_ = 0, depth_ = 0;
};

// The parser stops at the last byte of the token that it rejected, which may be later than the mistake.
std::string mistake_at(std::string_view bytes, std::size_t byte) {
  constexpr std::size_t kMost = 30;
  if (byte >= bytes.size()) return "it ends before its last bracket is closed; the file may be cut off";
  const std::size_t begin = byte == 0 ? 0 : bytes.rfind('\n', byte - 1) + 1;
  std::string_view before = bytes.substr(begin, byte - begin + 1);
  const std::size_t column = before.size();
  if (before.size() > kMost) before.remove_prefix(before.size() - kMost);
  before.remove_prefix(std::min(before.find_first_not_of(" \t"), before.size()));
  const std::string found = before == "\n" || before.empty() ? "the end of the line" : "'" + std::string(before) + "'";
  return "there is a mistake at or before column " + std::to_string(column) + ": found " + found;
}

// Returns the usual mistake at the byte that the parser rejected, with its remedy; empty: none of these.
std::string usual_mistake(std::string_view bytes, std::size_t byte) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) return " (UTF-16: save the file as UTF-8)";
  const std::size_t line = byte > 0 && byte <= bytes.size() ? bytes.rfind('\n', byte - 1) + 1 : 0;
  for (const std::string_view marker : {"<<<<<<< ", "=======", ">>>>>>> "})
    if (bytes.substr(std::min(line, bytes.size())).starts_with(marker))
      return " (a conflict marker of git: resolve the conflict)";
  if (byte == 0 || byte >= bytes.size()) return {};
  const char rejected = bytes[byte];
  const std::size_t last = bytes.find_last_not_of(" \t\r\n", byte - 1);
  const char before = last == std::string_view::npos ? '\0' : bytes[last];
  if ((rejected == ']' || rejected == '}') && before == ',') return " (a comma before a bracket: remove it)";
  const bool is_after_digit = before == ',' && last > 0 && is_digit(bytes[last - 1]);
  if (is_after_digit && is_digit(rejected)) return " (a decimal comma: write a point)";
  if (bytes[byte - 1] == '\\') return " (a backslash in a text: write it twice, or / in names of files)";
  return {};
}

/// Returns what a file is that is no JSON at all; empty: it begins as JSON, or its kind is not known.
std::string other_kind(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || bytes[first] == '{' || bytes[first] == '[') return {};
  if (bytes.substr(first).starts_with("solid")) return "an STL mesh";
  if (looks_like_cl_data(bytes)) return "a toolpath (CL data)";
  const std::optional<FileKind> kind = recognise_file({}, bytes);
  return kind && kind->family != FileFamily::stand_in ? std::string(kind->name) : std::string();
}

/// Describes a file that holds nothing of the JSON whose name it has, such as a compressed file. Empty: it is none, or its
/// mistake is a usual one.
std::string stand_in_for_json(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool begins_as_json = first == std::string_view::npos || bytes[first] == '{' || bytes[first] == '[';
  return begins_as_json || !usual_mistake(bytes, 0).empty() ? std::string() : describe_stand_in({}, bytes);
}

}  // namespace

Result<JsonFile> parse_json(const std::string& file, std::string_view bytes, const JsonKind& kind) {
  const std::string& syntax = kind.syntax_code;
  if (bytes.empty()) return make_error(syntax, "the file is empty (0 bytes); expected " + kind.what + " (JSON)", file);
  bytes = without_byte_order_mark(bytes);
  if (const std::string other = stand_in_for_json(bytes); !other.empty()) return make_error(syntax, other, file);
  if (const auto excess = LimitScan(file, bytes, kind.what).find_excess()) return *excess;
  try {
    JsonFile parsed{nlohmann::json::parse(bytes), find_json_lines(bytes)};
    const auto& twice = parsed.lines.duplicate;
    if (twice)
      return make_error(kind.duplicate_key_code, "the key " + twice->pointer + " is there twice; remove one", file,
                        twice->line);
    return parsed;
  } catch (const nlohmann::json::parse_error& error) {
    if (const std::string other = other_kind(bytes); !other.empty())
      return make_error(syntax, "is " + other + "; expected " + kind.what + " (JSON)", file);
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    return make_error(
        syntax, "this is not JSON: " + mistake_at(bytes, byte) + usual_mistake(bytes, byte) + "; expected " + kind.what,
        file, line_of_byte(bytes, byte));
  } catch (const nlohmann::json::exception&) {
    return make_error(syntax, "a number in this file is too large to be a length; expected " + kind.what, file);
  }
}

}  // namespace gouge
