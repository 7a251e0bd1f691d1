#include "postproc/gcode/heidenhain/klartext_words.h"

#include <cmath>
#include <optional>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

bool is_name_letter(char c) { return is_capital(c) || c == '_'; }
bool is_value_digit(char c) { return is_digit(c) || c == '.'; }

class WordReader {
 public:
  WordReader(std::string_view text, const QParameters& parameters) : text_(text), parameters_(parameters) {}

  std::string read(std::vector<KlartextWord>& words) {
    words.clear();
    while (skip()) {
      if (text_[0] == '"') {
        if (words.empty() || words.back().kind != KlartextWord::Kind::name) return "a text without its word";
        if (!take_text(words.back())) return "a text without its closing quotation mark";
        continue;
      }
      KlartextWord& word = words.emplace_back();
      if (!take_name(word))
        return "'" + std::string(text_.substr(0, 20)) + "' is not understood" +
               (is_decimal_comma(words) ? " (a decimal comma: write a point)" : "");
      if (!take_value(word)) return word.name + " has no value that is understood";
    }
    return {};
  }

 private:
  bool skip() {
    while (!text_.empty() && (text_[0] == ' ' || text_[0] == '\t')) text_.remove_prefix(1);
    return !text_.empty();
  }

  /// Returns whether the rest begins with a comma and a digit, directly after a word with a value.
  [[nodiscard]] bool is_decimal_comma(const std::vector<KlartextWord>& words) const {
    return words.size() > 1 && words[words.size() - 2].kind == KlartextWord::Kind::number && text_.size() > 1 &&
           text_[0] == ',' && is_digit(text_[1]);
  }

  // A parameter may follow its address directly: XQ5.
  bool take_name(KlartextWord& word) {
    if (!is_name_letter(text_[0])) return false;
    std::size_t length = 0;
    while (length < text_.size() && is_name_letter(text_[length])) {
      std::string_view rest = text_.substr(length);
      if (length > 0 && !take_parameter_name(rest).empty()) break;
      ++length;
    }
    word.name = text_.substr(0, length);
    text_.remove_prefix(length);
    return true;
  }

  bool take_value(KlartextWord& word) {
    const std::string_view before = text_;
    if (text_.starts_with(':') && word.name == "MODE") text_.remove_prefix(1);  // HSC-MODE:1
    skip();
    const bool has_sign = !text_.empty() && (text_[0] == '+' || text_[0] == '-');
    const double sign = has_sign && text_[0] == '-' ? -1 : 1;
    if (has_sign) text_.remove_prefix(1);
    std::string_view rest = text_;
    word.parameter = take_parameter_name(rest);
    if (!word.parameter.empty()) {
      text_ = rest;
      word.kind = KlartextWord::Kind::number;
      word.value = sign * parameters_.value(word.parameter);
      return true;
    }
    std::size_t length = 0;
    while (length < text_.size() && is_value_digit(text_[length])) ++length;
    if (length == 0) {
      if (has_sign) {
        word.kind = KlartextWord::Kind::sign;
        word.value = sign;
      } else {
        text_ = before;
      }
      return true;
    }
    const auto number = parse_number(text_.substr(0, length));
    text_.remove_prefix(length);
    word.kind = KlartextWord::Kind::number;
    word.value = sign * number.value_or(0);
    return number.has_value();
  }

  bool take_text(KlartextWord& word) {
    const std::size_t close = text_.find('"', 1);
    if (close == std::string_view::npos) return false;
    word.text = text_.substr(1, close - 1);
    word.kind = KlartextWord::Kind::text;
    text_.remove_prefix(close + 1);
    return true;
  }

  std::string_view text_;
  const QParameters& parameters_;
};

}  // namespace

std::string read_klartext_words(std::string_view text, const QParameters& parameters,
                                std::vector<KlartextWord>& words) {
  return WordReader(text, parameters).read(words);
}

std::string word_text(const KlartextWord& word) {
  switch (word.kind) {
    case KlartextWord::Kind::sign:
      return word.name + (word.value < 0 ? "-" : "+");
    case KlartextWord::Kind::number:
      return word.name + (is_known(word.value) ? exact_text(word.value) : word.parameter);
    case KlartextWord::Kind::text:
      return word.name + " \"" + word.text + "\"";
    case KlartextWord::Kind::name:
      break;
  }
  return word.name;
}

std::optional<int> whole_number(const KlartextWord& word) {
  constexpr double kMax = 1e9;
  if (word.kind != KlartextWord::Kind::number || !(std::abs(word.value) < kMax)) return std::nullopt;
  const double nearest = std::round(word.value);
  if (std::abs(nearest - word.value) > 0) return std::nullopt;
  return static_cast<int>(nearest);
}

}  // namespace gouge
