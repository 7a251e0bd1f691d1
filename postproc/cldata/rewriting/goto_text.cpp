#include "postproc/cldata/rewriting/goto_text.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/lexing/statement_at.h"

namespace gouge {

namespace {

constexpr std::size_t kStatementsLearned = 5000;
constexpr int kMinAxisDecimals = 6;
constexpr int kUsualAxisDecimals = 9;
constexpr int kUsualDecimals = 6;

}  // namespace

GotoText::GotoText(const Toolpath& path, const MotionRecords& records, OpenStatements open) : path_(path), open_(open) {
  line_end_ = line_end_of(path.source);
  std::size_t learned = 0;
  for (const MotionRecord& record : records.of_move) {
    if (record.form != PositionForm::go_to || record.point != 0) continue;
    learn(record);
    if (++learned == kStatementsLearned) break;
  }
  if (learned == 0) learn_holes(records);
  coordinates_.choose_decimals(min_coordinate_decimals(path.unit), kUsualDecimals);
  components_.choose_decimals(kMinAxisDecimals, kUsualAxisDecimals);
}

// Learns from holes, for a file that only drills.
void GotoText::learn_holes(const MotionRecords& records) {
  std::size_t learned = 0, last = kNone;
  for (const MotionRecord& record : records.of_move) {
    if (record.form != PositionForm::cycle || record.numbers == 0 || record.point != 0 || record.statement == last)
      continue;
    last = record.statement;
    learn(record);
    if (++learned == kStatementsLearned) break;
  }
}

void GotoText::learn(const MotionRecord& record) {
  const Statement statement = statement_at(path_, record.statement, open_);
  std::vector<Argument> arguments;
  split_arguments(statement, arguments);
  const std::string_view bytes = path_.source;
  const auto offset = [&](const Argument& a) { return static_cast<std::size_t>(a.text.data() - bytes.data()); };
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].text.empty()) break;  // the axis in NCI is not text of the file
    const std::size_t blanks = blanks_before(bytes, offset(arguments[i]));
    const bool is_axis = i % record.numbers >= 3;
    if (is_axis && !axis_gap_) axis_gap_ = blanks;
    (is_axis ? components_ : coordinates_).learn(arguments[i].text, arguments[i].text.size() + blanks);
  }
  if (has_form_) return;
  has_form_ = true;
  const std::size_t first = offset(arguments[0]);
  first_gap_ = blanks_before(bytes, first);
  // The prefix has no sequence number, because that belongs to one statement.
  const auto begin =
      statement.is_decoded ? statement.first_byte : static_cast<std::size_t>(statement.major.data() - bytes.data());
  prefix_ = std::string(trim(bytes.substr(begin, first - first_gap_ - begin)));
  const std::size_t after = first + arguments[0].text.size();
  const std::size_t second = offset(arguments[1]);
  gap_ = blanks_before(bytes, second);
  separator_ = bytes.substr(after, second - gap_ - std::min(after, second - gap_));
}

void GotoText::append_number(std::string& text, const NumberStyle& style, double value) const {
  const std::string token = style.text(value);
  const std::size_t gap = &style == &components_ ? axis_gap_.value_or(gap_) : gap_;
  text += separator_ + style.padding(token, gap) + token;
}

bool GotoText::is_same_axis(const Vec3& a, const Vec3& b) const {
  return (a - b).cwiseAbs().maxCoeff() <= 0.5 * std::pow(10.0, -components_.decimals());
}

std::string GotoText::replaced(std::size_t index, std::size_t numbers,
                               const std::vector<std::optional<WrittenPosition>>& positions) const {
  const Statement statement = statement_at(path_, index, open_);
  std::vector<Argument> arguments;
  split_arguments(statement, arguments);
  const std::string_view bytes = path_.source;
  std::string result;
  std::size_t copied = statement.first_byte;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::optional<WrittenPosition>& position = positions[i / numbers];
    if (!position) continue;
    const std::size_t k = i % numbers;
    if (k >= 3 && !position->axis) continue;
    const NumberStyle& style = k < 3 ? coordinates_ : components_;
    const auto component = static_cast<Eigen::Index>(k % 3);
    const double value = k < 3 ? position->tip[component] : (*position->axis)[component];
    append_changed_number(result, copied, bytes, arguments[i], style, value);
    if (k == 2 && numbers == 3 && position->axis) {
      const auto end = static_cast<std::size_t>(arguments[i].text.data() - bytes.data()) + arguments[i].text.size();
      result += bytes.substr(copied, end - copied);
      for (Eigen::Index c = 0; c < 3; ++c) append_number(result, components_, (*position->axis)[c]);
      copied = end;
    }
  }
  result += bytes.substr(copied, statement.last_byte - copied);
  return result;
}

std::string GotoText::shifted(std::size_t index, std::size_t numbers, const std::vector<Vec3>& shifts) const {
  const Statement statement = statement_at(path_, index, open_);
  std::vector<Argument> arguments;
  split_arguments(statement, arguments);
  std::string result;
  std::size_t copied = statement.first_byte;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (i % numbers >= 3) continue;
    const double shift = shifts[i / numbers][static_cast<Eigen::Index>(i % numbers)];
    append_changed_number(result, copied, path_.source, arguments[i], coordinates_, *arguments[i].number + shift);
  }
  result += std::string_view(path_.source).substr(copied, statement.last_byte - copied);
  return result;
}

std::string GotoText::fresh(const WrittenPosition& position) const {
  const std::string first = coordinates_.text(position.tip.x());
  std::string text = prefix_ + coordinates_.padding(first, first_gap_) + first;
  append_number(text, coordinates_, position.tip.y());
  append_number(text, coordinates_, position.tip.z());
  if (position.axis) {
    for (Eigen::Index c = 0; c < 3; ++c) append_number(text, components_, (*position.axis)[c]);
  }
  return with_line_end(std::move(text));
}

std::string GotoText::with_line_end(std::string text) const {
  if (text.empty() || text.back() != '\n') text += line_end_;
  return text;
}

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

void NumberStyle::choose_decimals(int min_decimals, int usual_decimals) {
  if (count_ == 0) {
    decimals_ = fewest_decimals_ = usual_decimals;
    is_aligned_ = false;
  }
  const bool is_bare_point = keeps_point_ && decimals_ == 0;  // "25.": zeros are dropped
  const bool is_fixed = fewest_decimals_ == decimals_ && !is_bare_point;
  decimals_ = std::max(decimals_, min_decimals);
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
