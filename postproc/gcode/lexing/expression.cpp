#include "postproc/gcode/lexing/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr int kDeepest = 50;

double truth(bool value) { return value ? 1 : 0; }

// Controls compare for equality exactly or within a tolerance. Within it the answer is not known.
double equality(double a, double b, bool wanted) {
  constexpr double kWidestTolerance = 1e-3;
  const double apart = std::abs(a - b);
  if (!is_known(apart) || (apart > 0 && apart < kWidestTolerance)) return kUnknownValue;
  return truth((apart <= 0) == wanted);
}

double comparison(double a, double b, bool holds) { return is_known(a) && is_known(b) ? truth(holds) : kUnknownValue; }

bool nearly_meet(double a, double b) {
  return std::abs(a - b) < kOfControlDigits * std::max({1.0, std::abs(a), std::abs(b)});
}

// Numbers that every control holds and adds exactly: few digits, and fractions that both binary and decimal numbers have.
constexpr double kMaxExact = 1e7;
bool is_exact(double x) {
  constexpr double kParts = 1024;
  return std::abs(x) < kMaxExact && std::abs(x * kParts - std::round(x * kParts)) <= 0;
}

// Controls differ in the sign of a remainder of negative numbers.
double remainder_of(double a, double b) { return a >= 0 && b > 0 ? std::fmod(a, b) : kUnknownValue; }

class Evaluator {
 public:
  Evaluator(GcodeCursor& cursor, const GcodeSyntax& syntax, const GcodeVariables& variables)
      : c_(cursor), syntax_(syntax), variables_(variables) {}

  double value() {
    if (++c_.depth > kDeepest) c_.fail("an expression has too many brackets, signs or # in each other");
    const double found = c_.error.empty() ? value_here() : kUnknownValue;
    --c_.depth;
    return found;
  }

  double whole() { return operation(Rank::comparison); }

 private:
  double value_here() {
    c_.skip_blanks();
    const char c = c_.peek();
    if (c == '-' || c == '+') {
      ++c_.at;
      c_.skip_blanks();
      // LinuxCNC takes several signs; on the others this is an alarm.
      if (syntax_.has_macros && (c_.peek() == '-' || c_.peek() == '+')) c_.fail("two signs before a number");
      const double rest = value();
      return c == '-' ? -rest : rest;
    }
    if (c == '[') return brackets();
    if (c == '#') return variable();
    if (is_letter(c)) return function();
    return number();
  }

  enum class Rank { comparison, logic, sum, product, power, none };
  enum class Operator {
    plus,
    minus,
    times,
    divide,
    mod,
    power,
    eq,
    ne,
    gt,
    ge,
    lt,
    le,
    conjunction,
    either,
    exclusive,
    none
  };

  struct Spelling {
    std::string_view text;
    Operator meaning;
  };

  [[nodiscard]] Rank rank_of(Operator one) const {
    using enum Operator;
    switch (one) {
      case power:
        return Rank::power;
      case times:
      case divide:
      case mod:
        return Rank::product;
      case plus:
      case minus:
        return Rank::sum;
      case conjunction:
        return syntax_.binds_and_as_times ? Rank::product : Rank::logic;
      case either:
      case exclusive:
        return syntax_.binds_and_as_times ? Rank::sum : Rank::logic;
      case none:
        return Rank::none;
      default:
        return Rank::comparison;
    }
  }
  [[nodiscard]] Operator operator_at(std::size_t& length) {
    using enum Operator;
    static constexpr std::array<Spelling, 15> kOperators = {{{"**", power},
                                                             {"MOD", mod},
                                                             {"AND", conjunction},
                                                             {"XOR", exclusive},
                                                             {"OR", either},
                                                             {"EQ", eq},
                                                             {"NE", ne},
                                                             {"GT", gt},
                                                             {"GE", ge},
                                                             {"LT", lt},
                                                             {"LE", le},
                                                             {"+", plus},
                                                             {"-", minus},
                                                             {"*", times},
                                                             {"/", divide}}};
    c_.skip_blanks();
    const std::string_view rest = c_.text.substr(std::min(c_.at, c_.text.size()));
    for (const Spelling& one : kOperators) {
      const bool is_here = rest.size() >= one.text.size() && std::equal(one.text.begin(), one.text.end(), rest.begin(),
                                                                        [](char a, char b) { return a == capital(b); });
      const bool is_of_others = one.meaning == power && syntax_.has_macros;  // Fanuc and Haas have POW
      if (!is_here || is_of_others) continue;
      length = one.text.size();
      return one.meaning;
    }
    return none;
  }

  [[nodiscard]] double applied(Operator one, double a, double b) const {
    using enum Operator;
    if (syntax_.has_macros && depends_on_digits(one, a, b)) return kUnknownValue;
    switch (one) {
      case plus:
        return a + b;
      case minus:
        return a - b;
      case times:
        return a * b;
      case divide:
        return std::abs(b) > 0 ? a / b : kUnknownValue;
      case mod:
        return remainder_of(a, b);
      case power:
        return std::pow(a, b);
      case eq:
        return equality(a, b, true);
      case ne:
        return equality(a, b, false);
      case gt:
        return comparison(a, b, a > b);
      case ge:
        return comparison(a, b, a >= b);
      case lt:
        return comparison(a, b, a < b);
      case le:
        return comparison(a, b, a <= b);
      // Controls take these of truth values or of bits; both agree for 0 and 1.
      case conjunction:
        return is_truth(a) && is_truth(b) ? truth(a > 0 && b > 0) : kUnknownValue;
      case either:
        return is_truth(a) && is_truth(b) ? truth(a > 0 || b > 0) : kUnknownValue;
      case exclusive:
        return is_truth(a) && is_truth(b) ? truth((a > 0) != (b > 0)) : kUnknownValue;
      case none:
        break;
    }
    return kUnknownValue;
  }
  // The digits of variables differ between controls of macros. So a value that they round may be on either side of a limit,
  // even if doubles meet the limit exactly. Source: Fanuc B-63944EN, Logical expressions; Haas, Macros, Round off.
  [[nodiscard]] bool depends_on_digits(Operator one, double a, double b) const {
    using enum Operator;
    switch (one) {
      case plus:
      case minus:
        return std::max(std::abs(a), std::abs(b)) >= kMaxExact && is_mostly_cancelled(one == minus ? a - b : a + b, a);
      case mod:
        return is_nearly_whole(a / b) || (c_.is_rounded && std::abs(a / b - std::round(a / b)) <= 0);
      case conjunction:
      case either:
      case exclusive:
        return c_.is_rounded;
      default:
        return rank_of(one) == Rank::comparison && nearly_meet(a, b) && (c_.is_rounded || std::abs(a - b) > 0);
    }
  }
  static bool is_mostly_cancelled(double sum, double a) {
    constexpr double kShare = 1e-2;
    return std::abs(sum) < kShare * std::abs(a);
  }
  static bool is_truth(double a) { return equality(a, 0, true) > 0 || equality(a, 1, true) > 0; }

  // Operators of at least this rank; equal ranks from left to right.
  double operation(Rank least) {
    const bool was_rounded = c_.is_rounded;
    double left = value();
    while (c_.error.empty()) {
      std::size_t length = 0;
      const Operator one = operator_at(length);
      const Rank rank = rank_of(one);
      if (rank == Rank::none || rank < least) break;
      c_.at += length;
      const double right = operation(static_cast<Rank>(static_cast<int>(rank) + 1));
      const double result = applied(one, left, right);
      const bool rounds = c_.is_rounded || !is_exact(left) || !is_exact(right) || !is_exact(result);
      c_.is_rounded = rank == Rank::comparison ? was_rounded : rounds;
      left = result;
      if (std::isinf(left)) left = kUnknownValue;
    }
    return left;
  }

  double brackets() {
    ++c_.at;
    const double inner = operation(Rank::comparison);
    c_.skip_blanks();
    if (c_.peek() != ']') c_.fail("an expression without its closing bracket");
    ++c_.at;
    return inner;
  }

  double variable() {
    ++c_.at;
    const std::string name = read_variable_name(c_, syntax_, variables_);
    if (name.empty() || is_system_variable(name, syntax_)) return kUnknownValue;
    c_.is_rounded = c_.is_rounded || variables_.may_be_rounded(name);
    return variables_.value(name);
  }

  double function() {
    std::string name;
    while (is_letter(c_.peek())) name += capital(c_.text[c_.at++]);
    c_.skip_blanks();
    if (c_.peek() != '[') {
      c_.fail("'" + name + "' is no number");
      return kUnknownValue;
    }
    const bool was_rounded = std::exchange(c_.is_rounded, false);
    const double x = brackets();
    const bool is_of_fractions = std::exchange(c_.is_rounded, was_rounded);
    if (name == "FIX" || name == "FUP") return whole_beside(x, name == "FUP", is_of_fractions);
    if (name == "ROUND") return rounded(x);
    c_.is_rounded = true;
    if (name == "ABS") c_.is_rounded = was_rounded || is_of_fractions;
    if (name == "ATAN") return arc_tangent(x);
    if (name == "SIN") return std::sin(x / kDegrees);
    if (name == "COS") return std::cos(x / kDegrees);
    if (name == "TAN") return std::tan(x / kDegrees);
    if (name == "ASIN") return arc_sine(x);
    if (name == "ACOS") return std::acos(x) * kDegrees;
    if (name == "SQRT") return std::sqrt(x);
    if (name == "ABS") return std::abs(x);
    if (name == "EXP") return std::exp(x);
    if (name == "LN") return x > 0 ? std::log(x) : kUnknownValue;
    c_.fail("the function " + name + " is not known");
    return kUnknownValue;
  }

  // LinuxCNC takes the next whole number below or above, Fanuc that nearer to or farther from 0. Source: Fanuc, B-64484EN,
  // custom macro: FIX[0.002*1000] may be 1.
  [[nodiscard]] double whole_beside(double x, bool is_above, bool is_of_fractions) const {
    const bool is_whole = std::abs(x - std::round(x)) <= 0;
    const bool is_doubtful = x < 0 || (syntax_.has_macros && (is_nearly_whole(x) || (is_whole && is_of_fractions)));
    if (is_doubtful) return kUnknownValue;
    return is_above ? std::ceil(x) : std::floor(x);
  }

  // Halves below 0 differ. In an address macros round to the increment of the control, elsewhere to a whole number.
  [[nodiscard]] double rounded(double x) const {
    if (syntax_.has_macros && (c_.is_address || is_nearly_whole(x + 0.5))) return kUnknownValue;
    return x >= 0 ? std::round(x) : kUnknownValue;
  }

  // Of Fanuc a parameter chooses the range of the angle: that of -0.5 is -30 or 330 degrees.
  [[nodiscard]] double arc_sine(double x) const {
    return syntax_.has_macros && x < 0 ? kUnknownValue : std::asin(x) * kDegrees;
  }

  // Of Fanuc a parameter chooses the range of the angle.
  double arc_tangent(double y) {
    c_.skip_blanks();
    if (c_.peek() != '/') return std::atan(y) * kDegrees;
    ++c_.at;
    c_.skip_blanks();
    if (c_.peek() != '[') {
      c_.fail("ATAN needs its second value in brackets");
      return kUnknownValue;
    }
    const double angle = std::atan2(y, brackets()) * kDegrees;
    return syntax_.has_macros && angle < 0 ? kUnknownValue : angle;
  }

  double number() {
    const std::size_t begin = c_.at;
    while (is_digit(c_.peek()) || c_.peek() == '.') ++c_.at;
    const auto parsed = parse_number(c_.text.substr(begin, c_.at - begin));
    if (!parsed) c_.fail("a word without its number");
    return parsed.value_or(kUnknownValue);
  }

  GcodeCursor& c_;
  const GcodeSyntax& syntax_;
  const GcodeVariables& variables_;
};

}  // namespace

void GcodeCursor::skip_blanks() {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\r')) ++at;
}

void GcodeCursor::fail(std::string reason) {
  if (error.empty()) error = std::move(reason);
  at = text.size();
}

void GcodeCursor::fail_at_character() {
  const bool is_decimal_comma =
      peek() == ',' && at > 0 && is_digit(text[at - 1]) && at + 1 < text.size() && is_digit(text[at + 1]);
  fail("'" + std::string(1, peek()) + "' is no part of a block" +
       (is_decimal_comma ? " (a decimal comma: write a point)" : ""));
}

double read_value(GcodeCursor& cursor, const GcodeSyntax& syntax, const GcodeVariables& variables, bool& has_point) {
  cursor.skip_blanks();
  const std::size_t begin = cursor.at;
  const char sign = cursor.peek();
  if (sign == '-' || sign == '+') {
    ++cursor.at;
    cursor.skip_blanks();
  }
  if (const auto plain = read_plain_number(cursor, has_point)) return sign == '-' ? -*plain : *plain;
  cursor.at = begin;
  const bool is_expression = cursor.text.substr(begin).find_first_of("#[") != std::string_view::npos;
  const double value = Evaluator(cursor, syntax, variables).value();
  const std::string_view read = cursor.text.substr(begin, cursor.at - std::min(begin, cursor.at));
  has_point =
      (is_expression && read.find_first_of("#[") != std::string_view::npos) || read.find('.') != std::string_view::npos;
  return value;
}

double read_expression(GcodeCursor& cursor, const GcodeSyntax& syntax, const GcodeVariables& variables) {
  return Evaluator(cursor, syntax, variables).whole();
}

bool is_system_variable(const std::string& name, const GcodeSyntax& syntax) {
  const auto number = parse_integer(name);
  return number && (*number == 0 || *number >= syntax.first_system_variable);
}

std::string read_variable_name(GcodeCursor& cursor, const GcodeSyntax& syntax, const GcodeVariables& variables) {
  cursor.skip_blanks();
  if (cursor.peek() == '<' && syntax.has_named_variables) {
    const std::size_t close = cursor.text.find('>', cursor.at);
    if (close == std::string_view::npos) {
      cursor.fail("the name of a variable without its end");
      return {};
    }
    std::string name;
    for (const char c : cursor.text.substr(cursor.at, close + 1 - cursor.at)) {
      if (c != ' ' && c != '\t') name += small(c);
    }
    cursor.at = close + 1;
    return name;
  }
  bool has_point = false;
  const double number = read_value(cursor, syntax, variables, has_point);
  constexpr double kMaxVariables = 1e6;
  if (!is_known(number) || number < 0 || number > kMaxVariables || std::floor(number) < number) {
    cursor.fail("it is not known which variable is meant");
    return {};
  }
  return std::to_string(static_cast<long long>(number));
}

}  // namespace gouge
