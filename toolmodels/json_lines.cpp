#include "toolmodels/json_lines.h"

#include <algorithm>
#include <vector>

namespace gouge::detail {
namespace {

struct Level {
  bool is_object = false;
  std::size_t index = 0;  // in an array
  std::string key;        // in an object
  bool awaits_key = false;
  std::string pointer;  // of the container
};

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  JsonLines scan() {
    for (; at_ < text_.size(); ++at_) step(text_[at_]);
    return std::move(found_);
  }

 private:
  void step(char c) {
    if (c == '\n') ++line_;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ':') return;
    if (c == '{' || c == '[') {
      open(c == '{');
    } else if (c == '}' || c == ']') {
      if (!levels_.empty()) levels_.pop_back();
    } else if (c == ',') {
      next();
    } else if (c == '"') {
      const std::string word = read_string();
      if (!levels_.empty() && levels_.back().awaits_key)
        name(word);
      else
        note_value();
    } else {
      note_value();
      while (at_ + 1 < text_.size() &&
             std::string_view(",]} \t\r\n").find(text_[at_ + 1]) == std::string_view::npos)
        ++at_;
    }
  }

  void open(bool is_object) {
    const std::string here = pointer();
    note_value();
    levels_.push_back({is_object, 0, {}, is_object, here});
  }

  void next() {
    if (levels_.empty()) return;
    ++levels_.back().index;
    levels_.back().awaits_key = levels_.back().is_object;
  }

  void name(const std::string& word) {
    levels_.back().key = word;
    levels_.back().awaits_key = false;
    if (found_.lines.contains(pointer()) && !found_.duplicate) found_.duplicate = pointer();
  }

  std::string read_string() {
    const std::size_t first = at_ + 1;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    return std::string(text_.substr(std::min(first, text_.size()), at_ - first));
  }

  [[nodiscard]] std::string pointer() const {
    if (levels_.empty()) return "";
    const Level& top = levels_.back();
    return top.pointer + "/" + (top.is_object ? top.key : std::to_string(top.index));
  }

  void note_value() { found_.lines.emplace(pointer(), line_); }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<Level> levels_;
  JsonLines found_;
};

}  // namespace

std::size_t JsonLines::at(std::string pointer) const {
  while (true) {
    if (const auto found = lines.find(pointer); found != lines.end()) return found->second;
    const std::size_t slash = pointer.rfind('/');
    if (slash == std::string::npos) return 1;
    pointer.resize(slash);
  }
}

JsonLines find_json_lines(std::string_view text) {
  return Scanner(text).scan();
}

std::size_t line_of_byte(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace gouge::detail
