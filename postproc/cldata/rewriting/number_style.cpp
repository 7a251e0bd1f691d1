#include "postproc/cldata/rewriting/number_style.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {

void NumberStyle::learn(std::string_view token, std::size_t field) {
  if (token.empty() || token.find_first_of("eEdD") != std::string_view::npos) return;
  const std::size_t point = token.find('.');
  const int decimals = point == std::string_view::npos ? 0 : static_cast<int>(token.size() - point - 1);
  if (count_ == 0) {
    field_ = field;
    first_length_ = token.size();
  }
  ++count_;
  decimals_ = std::max(decimals_, decimals);
  fewest_decimals_ = std::min(fewest_decimals_, decimals);
  is_aligned_ = is_aligned_ && field == field_;
  has_varying_length_ = has_varying_length_ || token.size() != first_length_;
  keeps_point_ = keeps_point_ || token.back() == '.';
  drops_zero_ = drops_zero_ || token.front() == '.' || token.starts_with("-.");
  keeps_negative_zero_ = keeps_negative_zero_ || token.starts_with("-0.");
}

void NumberStyle::choose_decimals(int least_decimals, int usual_decimals) {
  if (count_ == 0) {
    decimals_ = fewest_decimals_ = usual_decimals;
    is_aligned_ = false;
  }
  const bool is_bare_point = keeps_point_ && decimals_ == 0;  // "25.": zeros are dropped
  const bool is_fixed = fewest_decimals_ == decimals_ && !is_bare_point;
  decimals_ = std::max(decimals_, least_decimals);
  if (is_fixed) fewest_decimals_ = decimals_;
  is_aligned_ = is_aligned_ && has_varying_length_;
}

std::string NumberStyle::text(double value) const {
  std::string text = fixed_text(value, decimals_);
  if (fewest_decimals_ == decimals_) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text == "0." || text == "-0.") return keeps_point_ && !drops_zero_ ? "0." : "0";
  if (text.back() == '.' && !keeps_point_) text.pop_back();
  if (drops_zero_ && text.starts_with("0.")) text.erase(0, 1);
  if (drops_zero_ && !keeps_negative_zero_ && text.starts_with("-0.")) text.erase(1, 1);
  return text;
}

std::string NumberStyle::padding(std::string_view token, std::size_t blanks) const {
  if (is_aligned_) blanks = field_ > token.size() ? field_ - token.size() : 0;
  return std::string(blanks, ' ');
}

void append_changed_number(std::string& text, std::size_t& copied, std::string_view bytes, const Argument& argument,
                           const NumberStyle& style, double value) {
  const std::string token = style.text(value);
  if (parse_number(token) == parse_number(style.text(*argument.number))) return;
  const auto begin = static_cast<std::size_t>(argument.text.data() - bytes.data());
  const std::size_t blanks = blanks_before(bytes, begin);
  text += bytes.substr(copied, begin - blanks - copied);
  text += style.padding(token, blanks) + token;
  copied = begin + argument.text.size();
}

}  // namespace gouge
