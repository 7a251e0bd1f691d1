#include "postproc/gcode/heidenhain/q_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"

namespace gouge {
namespace {

constexpr int kMaxDepth = 50;  // brackets in each other

double finite(double value) { return std::isinf(value) ? kUnknownValue : value; }

/// Returns the value of a function; nothing known: the text has an error.
FormulaValue function_of(const std::string& name, double x) {
  if (name == "SIN") return {std::sin(x * kDegree_rad), {}};
  if (name == "COS") return {std::cos(x * kDegree_rad), {}};
  if (name == "TAN") return {std::tan(x * kDegree_rad), {}};
  if (name == "ASIN") return {std::asin(x) / kDegree_rad, {}};
  if (name == "ACOS") return {std::acos(x) / kDegree_rad, {}};
  if (name == "ATAN") return {std::atan(x) / kDegree_rad, {}};
  if (name == "SQ") return {x * x, {}};
  if (name == "SQRT") return {std::sqrt(x), {}};
  if (name == "ABS") return {std::abs(x), {}};
  if (name == "NEG") return {-x, {}};
  if (name == "INT") return {is_nearly_whole(x) ? kUnknownValue : std::trunc(x), {}};
  if (name == "FRAC") return {is_nearly_whole(x) ? kUnknownValue : x - std::trunc(x), {}};
  if (name == "LN") return {finite(std::log(x)), {}};
  if (name == "LOG") return {finite(std::log10(x)), {}};
  if (name == "EXP") return {finite(std::exp(x)), {}};
  return {kUnknownValue, "the function " + name + " is not read"};
}

class FormulaReader {
 public:
  FormulaReader(std::string_view text, const QParameters& parameters) : text_(text), parameters_(parameters) {}

  FormulaValue read() {
    const double value = sum();
    skip();
    if (!text_.empty()) fail("'" + std::string(text_.substr(0, 20)) + "' in a formula is not understood");
    return {error_.empty() ? finite(value) : kUnknownValue, error_};
  }

 private:
  void skip() { text_.remove_prefix(std::min(text_.find_first_not_of(" \t"), text_.size())); }
  [[nodiscard]] char peek() const { return text_.empty() ? '\0' : text_.front(); }
  bool take(char c) {
    skip();
    if (peek() != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  void fail(std::string reason) {
    if (error_.empty()) error_ = std::move(reason);
    text_ = {};
  }

  double sum() {
    double left = product();
    while (error_.empty()) {
      if (take('+'))
        left += product();
      else if (take('-'))
        left -= product();
      else
        break;
    }
    return left;
  }

  double product() {
    double left = power();
    while (error_.empty()) {
      if (take('*')) {
        left *= power();
      } else if (take('/')) {
        const double right = power();
        left = std::abs(right) > 0 ? left / right : kUnknownValue;
      } else {
        break;
      }
    }
    return left;
  }

  // No manual states whether a sign or a function before a power takes the base or the power.
  double power() {
    bool is_plain = true;
    double left = factor(is_plain);
    int powers = 0;
    while (error_.empty() && take('^')) {
      bool is_plain_exponent = true;
      const double right = factor(is_plain_exponent);
      left = is_plain && ++powers == 1 ? std::pow(left, right) : kUnknownValue;
    }
    return left;
  }

  double factor(bool& is_plain) {
    skip();
    if (++depth_ > kMaxDepth) {
      fail("a formula has too many brackets in each other");
      return kUnknownValue;
    }
    const double value = unbounded_factor(is_plain);
    --depth_;
    return value;
  }

  double unbounded_factor(bool& is_plain) {
    if (take('+')) return factor(is_plain);
    if (take('-')) {
      const double rest = factor(is_plain);
      is_plain = false;
      return -rest;
    }
    if (take('(')) {
      const double inner = sum();
      if (!take(')')) fail("a formula without its closing bracket");
      is_plain = true;
      return inner;
    }
    std::string_view rest = text_;
    if (const std::string name = take_parameter_name(rest); !name.empty()) {
      text_ = rest;
      return parameters_.value(name);
    }
    if (is_capital(peek())) return function(is_plain);
    return number();
  }

  double function(bool& is_plain) {
    std::string name;
    while (is_capital(peek())) {
      name += peek();
      text_.remove_prefix(1);
    }
    if (name == "PI") return std::numbers::pi;
    const double x = factor(is_plain);
    is_plain = false;
    FormulaValue value = function_of(name, x);
    if (!value.error.empty()) fail(std::move(value.error));
    return value.value;
  }

  double number() {
    std::size_t length = 0;
    while (length < text_.size() && (is_digit(text_[length]) || text_[length] == '.')) ++length;
    const auto parsed = parse_number(text_.substr(0, length));
    text_.remove_prefix(length);
    if (!parsed) fail("a formula without a value");
    return parsed.value_or(kUnknownValue);
  }

  std::string_view text_;
  const QParameters& parameters_;
  std::string error_;
  int depth_ = 0;
};

/// Returns whether a parameter is one that the control sets: Q100 to Q199.
bool is_of_control(std::string_view name) {
  constexpr long long kFirst = 100, kLast = 199;
  const auto number = parse_integer(name.substr(1));
  return number && *number >= kFirst && *number <= kLast;
}

}  // namespace

double QParameters::value(std::string_view name) const {
  if (is_of_control(name)) return kUnknownValue;
  const auto found = values_.find(name);
  return found == values_.end() ? kUnknownValue : found->second;
}

void QParameters::set(std::string_view name, double value) {
  const auto found = values_.find(name);
  if (found != values_.end())
    found->second = value;
  else
    values_.emplace(name, value);
}

std::string take_parameter_name(std::string_view& text) {
  if (text.empty() || text[0] != 'Q') return {};
  std::size_t at = 1;
  std::string name = "Q";
  if (text.size() > 1 && (text[1] == 'L' || text[1] == 'R')) name += text[at++];
  const std::size_t first = at;
  while (at < text.size() && is_digit(text[at])) ++at;
  const auto number = parse_integer(text.substr(first, at - first));
  if (!number) return {};
  text.remove_prefix(at);
  return name + std::to_string(*number);
}

FormulaValue read_formula(std::string_view text, const QParameters& parameters) {
  return FormulaReader(text, parameters).read();
}

FormulaValue read_operand(std::string_view text, const QParameters& parameters) {
  text = trim_blanks(text);
  const bool has_sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  const double sign = has_sign && text[0] == '-' ? -1 : 1;
  if (has_sign) text.remove_prefix(1);
  std::string_view rest = text;
  const std::string name = take_parameter_name(rest);
  if (!name.empty() && rest.empty()) return {sign * parameters.value(name), {}};
  const bool begins_well = !text.empty() && (is_digit(text[0]) || text[0] == '.');
  const auto number = begins_well ? parse_number(text) : std::nullopt;
  if (!number) return {kUnknownValue, "'" + std::string(text.substr(0, 20)) + "' is no value"};
  return {sign * *number, {}};
}

}  // namespace gouge
