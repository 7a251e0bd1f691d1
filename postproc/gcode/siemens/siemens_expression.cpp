#include "postproc/gcode/siemens/siemens_expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kDegreesPerRad = 180 / std::numbers::pi;
constexpr int kMaxBrackets = 50;
// The control compares for relative equality. Values that nearly agree are neither equal nor different for us.
constexpr double kNearlyEqual = 1e-6;
constexpr double kMaxWhole = 1e15;

bool begins_name(char c) { return is_letter(c) || c == '_' || c == '$'; }

double truth_of(bool value) { return value ? 1 : 0; }
bool is_zero(double a) { return std::abs(a) <= 0; }
bool is_logical(double a) { return is_zero(a) || is_zero(a - 1); }

double equality_of(double a, double b, bool wanted) {
  const double apart = std::abs(a - b);
  const bool is_near = apart > 0 && apart <= kNearlyEqual * std::max({1.0, std::abs(a), std::abs(b)});
  if (!is_known(apart) || is_near) return kUnknownValue;
  return truth_of((apart <= 0) == wanted);
}

double order_of(double a, double b, bool holds, bool holds_if_equal) {
  const double equal = equality_of(a, b, true);
  if (!is_known(equal)) return kUnknownValue;
  return truth_of(equal > 0 ? holds_if_equal : holds);
}

// The manual defines DIV and MOD for INT; the sign of negative ones is not stated.
bool is_natural(double a) { return a >= 0 && a < kMaxWhole && is_zero(a - std::floor(a)); }

enum class Symbol : std::uint8_t {
  times,
  divide,
  div,
  mod,
  plus,
  minus,
  bit,
  conjunction,
  exclusive,
  either,
  join,
  equal,
  different,
  less_equal,
  greater_equal,
  less,
  greater,
  none
};

struct SymbolText {
  std::string_view text;
  Symbol symbol;
  int rank;  ///< the higher, the earlier it is applied
};

constexpr auto kSymbols = std::to_array<SymbolText>({
    {"B_AND", Symbol::bit, 7},        {"B_XOR", Symbol::bit, 6},     {"B_OR", Symbol::bit, 5},
    {"AND", Symbol::conjunction, 4},  {"XOR", Symbol::exclusive, 3}, {"OR", Symbol::either, 2},
    {"DIV", Symbol::div, 9},          {"MOD", Symbol::mod, 9},       {"<<", Symbol::join, 1},
    {"==", Symbol::equal, 0},         {"<>", Symbol::different, 0},  {"<=", Symbol::less_equal, 0},
    {">=", Symbol::greater_equal, 0}, {"<", Symbol::less, 0},        {">", Symbol::greater, 0},
    {"*", Symbol::times, 9},          {"/", Symbol::divide, 9},      {"+", Symbol::plus, 8},
    {"-", Symbol::minus, 8},
});

double combined(Symbol symbol, double a, double b) {
  switch (symbol) {
    case Symbol::times:
      return a * b;
    case Symbol::divide:
      return is_zero(b) ? kUnknownValue : a / b;
    case Symbol::div:
      return is_natural(a) && is_natural(b) && b > 0 ? std::floor(a / b) : kUnknownValue;
    case Symbol::mod:
      return is_natural(a) && is_natural(b) && b > 0 ? std::fmod(a, b) : kUnknownValue;
    case Symbol::plus:
      return a + b;
    case Symbol::minus:
      return a - b;
    case Symbol::conjunction:
      return is_logical(a) && is_logical(b) ? truth_of(a > 0 && b > 0) : kUnknownValue;
    case Symbol::either:
      return is_logical(a) && is_logical(b) ? truth_of(a > 0 || b > 0) : kUnknownValue;
    case Symbol::exclusive:
      return is_logical(a) && is_logical(b) ? truth_of((a > 0) != (b > 0)) : kUnknownValue;
    case Symbol::equal:
      return equality_of(a, b, true);
    case Symbol::different:
      return equality_of(a, b, false);
    case Symbol::less_equal:
      return order_of(a, b, a < b, true);
    case Symbol::greater_equal:
      return order_of(a, b, a > b, true);
    case Symbol::less:
      return order_of(a, b, a < b, false);
    case Symbol::greater:
      return order_of(a, b, a > b, false);
    case Symbol::bit:
    case Symbol::join:
    case Symbol::none:
      break;
  }
  return kUnknownValue;
}

class SiemensEvaluator {
 public:
  SiemensEvaluator(GcodeCursor& cursor, const SiemensVariables& variables) : c_(cursor), variables_(variables) {}

  // Operators of at least this rank; equal ranks from left to right. Several comparisons without brackets are not what
  // they seem, as comparisons come last: their value is not known.
  double operation(int least) {
    if (++depth_ > kMaxBrackets) {
      c_.fail("an expression has too many brackets in each other");
      return kUnknownValue;
    }
    double left = signed_value();
    int comparisons = 0;
    while (c_.error.empty()) {
      const SymbolText* const found = symbol();
      if (found == nullptr || found->rank < least) break;
      c_.at += found->text.size();
      const double right = operation(found->rank + 1);
      comparisons += found->rank == 0 ? 1 : 0;
      left = comparisons > 1 ? kUnknownValue : combined(found->symbol, left, right);
      if (std::isinf(left)) left = kUnknownValue;
    }
    --depth_;
    return left;
  }

 private:
  const SymbolText* symbol() {
    c_.skip_blanks();
    const std::string_view rest = c_.text.substr(std::min(c_.at, c_.text.size()));
    for (const SymbolText& one : kSymbols) {
      const bool is_here = rest.size() >= one.text.size() && std::equal(one.text.begin(), one.text.end(), rest.begin(),
                                                                        [](char a, char b) { return a == capital(b); });
      const bool is_word = begins_name(one.text[0]);
      const bool goes_on = is_word && rest.size() > one.text.size() &&
                           (begins_name(rest[one.text.size()]) || is_digit(rest[one.text.size()]));
      if (is_here && !goes_on) return &one;
    }
    return nullptr;
  }

  double signed_value() {
    c_.skip_blanks();
    const char c = c_.peek();
    if (c == '-' || c == '+') {
      ++c_.at;
      c_.skip_blanks();
      if (c_.peek() == '-' || c_.peek() == '+') {
        c_.fail("two signs before a number");
        return kUnknownValue;
      }
      const double rest = signed_value();
      return c == '-' ? -rest : rest;
    }
    if (c == '(') return brackets();
    if (begins_name(c)) return named();
    return read_siemens_number(c_);
  }

  double brackets() {
    ++c_.at;
    const double inner = operation(0);
    c_.skip_blanks();
    if (c_.peek() != ')') c_.fail("an expression without its closing bracket");
    ++c_.at;
    return inner;
  }

  double named() {
    const std::string name = read_siemens_name(c_);
    if (name == "TRUE" || name == "FALSE") return truth_of(name == "TRUE");
    if (name == "$PI") return std::numbers::pi;
    if (name[0] == '$') return system_variable();
    if (name == "NOT") {
      if (++depth_ > kMaxBrackets) {
        c_.fail("an expression has too many operators in each other");
        return kUnknownValue;
      }
      const double value = signed_value();
      --depth_;
      return is_logical(value) ? 1 - value : kUnknownValue;
    }
    if (name == "R" && c_.peek() == '[') return indexed_parameter();
    if (variables_.has(name)) return variables_.value(name);
    c_.skip_blanks();
    if (c_.peek() == '(') return function(name);
    c_.fail("'" + name + "' is no variable of the program");
    return kUnknownValue;
  }

  // The value is one of the control, whatever its index.
  double system_variable() {
    c_.skip_blanks();
    if (c_.peek() != '[') return kUnknownValue;
    const std::size_t close = c_.text.find(']', c_.at);
    if (close == std::string_view::npos) c_.fail("an index without its closing bracket");
    c_.at = close == std::string_view::npos ? c_.text.size() : close + 1;
    return kUnknownValue;
  }

  double indexed_parameter() {
    ++c_.at;
    const double index = operation(0);
    c_.skip_blanks();
    if (c_.peek() != ']') c_.fail("an index without its closing bracket");
    ++c_.at;
    constexpr double kMaxParameters = 32000;
    if (!is_natural(index) || index > kMaxParameters) return kUnknownValue;
    return variables_.value("R" + std::to_string(static_cast<int>(index)));
  }

  double function(const std::string& name) {
    ++c_.at;
    std::vector<double> x = {operation(0)};
    c_.skip_blanks();
    while (c_.error.empty() && c_.peek() == ',') {
      ++c_.at;
      x.push_back(operation(0));
      c_.skip_blanks();
    }
    if (c_.error.empty() && c_.peek() != ')') c_.fail("a function without its closing bracket");
    ++c_.at;
    if (!c_.error.empty()) return kUnknownValue;
    if (x.size() == 1) return function_of_one(name, x[0]);
    if (x.size() == 2 && name == "ATAN2") return std::atan2(x[0], x[1]) * kDegreesPerRad;
    if (x.size() == 2 && name == "MINVAL") return is_known(x[0] + x[1]) ? std::min(x[0], x[1]) : kUnknownValue;
    if (x.size() == 2 && name == "MAXVAL") return is_known(x[0] + x[1]) ? std::max(x[0], x[1]) : kUnknownValue;
    c_.fail("the function " + name + " is not known");
    return kUnknownValue;
  }

  double function_of_one(const std::string& name, double x) {
    if (name == "SIN") return std::sin(x / kDegreesPerRad);
    if (name == "COS") return std::cos(x / kDegreesPerRad);
    if (name == "TAN") return std::tan(x / kDegreesPerRad);
    if (name == "ASIN") return std::asin(x) * kDegreesPerRad;
    if (name == "ACOS") return std::acos(x) * kDegreesPerRad;
    if (name == "SQRT") return std::sqrt(x);
    if (name == "ABS") return std::abs(x);
    if (name == "POT") return x * x;
    if (name == "EXP") return std::exp(x);
    if (name == "LN") return x > 0 ? std::log(x) : kUnknownValue;
    if (name == "TRUNC") return is_nearly_whole(x) ? kUnknownValue : std::trunc(x);
    if (name == "ROUND") return x >= 0 && !is_nearly_whole(x + 0.5) ? std::round(x) : kUnknownValue;  // halves below 0
    c_.fail("the function " + name + " is not known");
    return kUnknownValue;
  }

  GcodeCursor& c_;
  const SiemensVariables& variables_;
  int depth_ = 0;
};

}  // namespace

std::size_t siemens_name_length(std::string_view text) {
  if (text.empty() || !begins_name(text[0])) return 0;
  std::size_t length = 1;
  while (length < text.size() && (begins_name(text[length]) || is_digit(text[length]))) ++length;
  return length;
}

std::string read_siemens_name(GcodeCursor& c) {
  const std::string_view rest = c.text.substr(std::min(c.at, c.text.size()));
  const std::size_t length = siemens_name_length(rest);
  c.at += length;
  return in_capitals(rest.substr(0, length));
}

double read_siemens_number(GcodeCursor& c) {
  const std::size_t begin = c.at;
  const bool is_below = c.peek() == '-';
  if (is_below || c.peek() == '+') ++c.at;
  bool has_point = false;
  const std::optional<double> plain = read_plain_number(c, has_point);
  if (plain && capital(c.peek()) != 'E') return is_below ? -*plain : *plain;
  c.at = begin;
  if (c.peek() == '-' || c.peek() == '+') ++c.at;
  while (is_digit(c.peek()) || c.peek() == '.') ++c.at;
  const std::string_view digits = c.text.substr(begin, c.at - begin);
  std::optional<double> number;
  const auto at = [&](std::size_t i) { return c.at + i < c.text.size() ? capital(c.text[c.at + i]) : '\0'; };
  const std::size_t sign = at(2) == '-' || at(2) == '+' ? 1 : 0;
  if (at(0) == 'E' && at(1) == 'X' && is_digit(at(2 + sign))) {
    c.at += 2;
    const std::size_t exponent = c.at;
    c.at += sign;
    while (is_digit(c.peek())) ++c.at;
    number = parse_number(std::string(digits) + "e" + std::string(c.text.substr(exponent, c.at - exponent)));
  } else {
    number = parse_number(digits);
  }
  if (!number) c.fail("a word without its number");
  return number.value_or(kUnknownValue);
}

double read_siemens_value(GcodeCursor& cursor, const SiemensVariables& variables) {
  return SiemensEvaluator(cursor, variables).operation(0);
}

}  // namespace gouge
