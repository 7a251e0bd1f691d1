#include "lib/json/json_lines.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gouge {
namespace {

struct Level {
  bool is_object = false;
  bool awaits_key = false;
  std::size_t index = 0;  // index in a list
  std::string key;        // key in an object
  std::size_t value = 0;  // the container itself

  [[nodiscard]] std::string name() const { return is_object ? key : std::to_string(index); }
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
      const std::size_t value = note_value();
      levels_.push_back({c == '{', c == '{', 0, {}, value});
    } else if (c == '}' || c == ']') {
      if (!levels_.empty()) levels_.pop_back();
    } else if (c == ',') {
      next();
    } else if (c == '"') {
      const std::string_view word = read_string();
      if (!levels_.empty() && levels_.back().awaits_key)
        name(word);
      else
        note_value();
    } else {
      note_value();
      while (at_ + 1 < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_ + 1]) == std::string_view::npos)
        ++at_;
    }
  }

  void next() {
    if (levels_.empty()) return;
    ++levels_.back().index;
    levels_.back().awaits_key = levels_.back().is_object;
  }

  // Reads the key as the parser does: "\u0061" is the key "a", and the parser would silently drop the second of two
  // equal keys.
  void name(std::string_view quoted) {
    const auto key = nlohmann::json::parse(quoted, nullptr, false);
    levels_.back().key = key.is_string() ? key.get<std::string>() : std::string(quoted);
    levels_.back().awaits_key = false;
  }

  // Reads a string with its quotes.
  std::string_view read_string() {
    const std::size_t first = at_;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    return text_.substr(first, at_ + 1 - first);
  }

  [[nodiscard]] std::string pointer() const {
    std::string all;
    for (const Level& level : levels_) all += "/" + level.name();
    return all;
  }

  std::size_t note_value() {
    if (levels_.empty()) return found_.set_root(line_);
    const auto [value, is_new] = found_.add(levels_.back().value, levels_.back().name(), line_);
    if (!is_new && !found_.duplicate) found_.duplicate = {pointer(), line_};
    return value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::vector<Level> levels_;
  JsonLines found_;
};

}  // namespace

std::pair<std::size_t, bool> JsonLines::add(std::size_t parent, const std::string& key, std::size_t line) {
  const auto [found, is_new] = values_.try_emplace({parent, key}, lines_.size());
  if (is_new) lines_.push_back(line);
  return {found->second, is_new};
}

std::size_t JsonLines::set_root(std::size_t line) {
  lines_.front() = line;
  return 0;
}

// A key may contain a slash. So the shortest existing name is taken next; a key of slashes alone would otherwise take
// forever.
std::size_t JsonLines::at(std::string_view pointer) const {
  constexpr int kMaxSlashes = 100;
  std::size_t value = 0;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    auto found = values_.end();
    int slashes = 0;
    for (std::size_t end = 0; found == values_.end() && end < pointer.size() && slashes < kMaxSlashes; ++end) {
      ++slashes;
      end = std::min(pointer.find('/', end), pointer.size());
      found = values_.find({value, std::string(pointer.substr(0, end))});
      if (found != values_.end()) pointer.remove_prefix(end);
    }
    if (found == values_.end()) break;
    value = found->second;
  }
  return lines_[value];
}

JsonLines find_json_lines(std::string_view text) { return Scanner(text).scan(); }

std::size_t line_of_byte(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace gouge
