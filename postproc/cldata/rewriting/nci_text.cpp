#include "postproc/cldata/rewriting/nci_text.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kPairsLearned = 5000;
constexpr int kUsualNciDecimals = 6, kMostDecimals = 15;
constexpr double kLeastAxisError = 1e-6, kMostAxisError = 1e-5;

bool is_zero(const Argument& field) { return field.number && std::abs(*field.number) <= 0; }

// What a position of its own says of compensation and flags: no change, nothing special.
void put_nothing(const NciMotionPair& pair, std::optional<std::size_t> field, std::vector<std::string>& tokens) {
  if (field && *field < pair.fields.size() && !is_zero(pair.fields[*field])) tokens[*field] = "0";
}

}  // namespace

NciText::NciText(const Toolpath& path, const MotionRecords& records) : path_(path) {
  line_end_ = line_end_of(path.source);
  std::size_t learned = 0;
  for (std::size_t i = 0; i < records.of_move.size() && learned < kPairsLearned; ++i) {
    if (records.of_move[i].form != PositionForm::go_to) continue;
    learn(pair_of(i));
    ++learned;
  }
  NumberStyle as_it_is = second_points_;
  as_it_is.choose_decimals(0, kUsualNciDecimals);
  least_axis_error_ = std::sqrt(0.75) * std::pow(10.0, -as_it_is.decimals());
  tips_.choose_decimals(least_coordinate_decimals(path.unit), kUsualNciDecimals);
  second_points_.choose_decimals(least_coordinate_decimals(path.unit), kUsualNciDecimals);
}

NciMotionPair NciText::pair_of(std::size_t move) const {
  const SourceStatement& span = path_.statements[path_.moves[move].statement];
  NciMotionPair pair;
  NciLines lines(std::string_view(path_.source).substr(0, span.last_byte), span.first_byte, span.line);
  if (!lines.next(pair.lines)) return pair;
  split_nci_fields(pair.lines.parameters, pair.fields);
  pair.motion = read_nci_motion(pair.lines.code.value_or(NciCode::kLinear), pair.fields);
  return pair;
}

void NciText::learn(const NciMotionPair& pair) {
  const auto learn_fields = [&](NumberStyle& style, const std::array<std::size_t, 3>& fields) {
    for (const std::size_t field : fields) {
      const std::string_view text = pair.fields[field].text;
      style.learn(text, text.size() + blanks_before(path_.source, offset(text)));
    }
  };
  learn_fields(tips_, pair.motion.tip);
  if (pair.motion.form == NciForm::five_axis) learn_fields(second_points_, kNciSecondPoint);
}

void NciText::put_second_point(const NciMotionPair& pair, const Vec3& tip, const Vec3& axis, Tokens& tokens) const {
  const double length = pair.motion.axis_length;
  const double allowed = std::clamp(least_axis_error_ / length, kLeastAxisError, kMostAxisError);
  NumberStyle style = second_points_;
  for (;;) {
    Vec3 read = Vec3::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
      const std::size_t field = kNciSecondPoint[static_cast<std::size_t>(i)];
      const double before = *pair.fields[field].number;
      const std::string token = style.text(tip[i] + length * axis[i]);
      const bool is_same = parse_number(token) == parse_number(style.text(before));
      tokens[field] = is_same ? std::string() : token;
      read[i] = is_same ? before : parse_number(token).value_or(before);
    }
    if (((read - tip).normalized() - axis).norm() <= allowed || style.decimals() >= kMostDecimals) return;
    style.choose_decimals(style.decimals() + 1, style.decimals() + 1);
  }
}

void NciText::put_end(const NciMotionPair& pair, const Pose& end, Tokens& tokens) const {
  Vec3 tip = Vec3::Zero();  // as it will be read
  for (Eigen::Index i = 0; i < 3; ++i) {
    const std::size_t field = pair.motion.tip[static_cast<std::size_t>(i)];
    const double before = *pair.fields[field].number;
    const std::string token = tips_.text(end.tip[i]);
    const bool is_same = parse_number(token) == parse_number(tips_.text(before));
    if (!is_same) tokens[field] = token;
    tip[i] = is_same ? before : parse_number(token).value_or(before);
  }
  if (pair.motion.form == NciForm::five_axis) put_second_point(pair, tip, end.axis, tokens);
}

std::string NciText::rendered(const NciMotionPair& pair, const Tokens& tokens) const {
  const std::string_view bytes = path_.source;
  std::string result;
  std::size_t copied = pair.lines.first_byte;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].empty()) continue;
    const std::size_t begin = offset(pair.fields[i].text);
    const std::size_t blanks = blanks_before(bytes, begin);
    const bool is_second = pair.motion.form == NciForm::five_axis &&
                           std::find(kNciSecondPoint.begin(), kNciSecondPoint.end(), i) != kNciSecondPoint.end();
    const bool is_tip = std::find(pair.motion.tip.begin(), pair.motion.tip.end(), i) != pair.motion.tip.end();
    std::string padding(blanks, ' ');
    if (is_second) padding = second_points_.padding(tokens[i], blanks);
    if (is_tip) padding = tips_.padding(tokens[i], blanks);
    if (padding.empty() && blanks > 0) padding = " ";  // a number wider than its column
    result += bytes.substr(copied, begin - blanks - copied);
    result += padding + tokens[i];
    copied = begin + pair.fields[i].text.size();
  }
  result += bytes.substr(copied, pair.lines.last_byte - copied);
  return result;
}

std::string NciText::moved(const NciMotionPair& pair, const Pose& end) const {
  Tokens tokens(pair.fields.size());
  put_end(pair, end, tokens);
  return rendered(pair, tokens);
}

std::string NciText::inserted(const NciMotionPair& pair, const Pose& end) const {
  Tokens tokens(pair.fields.size());
  put_end(pair, end, tokens);
  put_nothing(pair, pair.motion.comp, tokens);
  put_nothing(pair, pair.motion.flags, tokens);
  return with_line_end(rendered(pair, tokens));
}

std::string NciText::straight(const NciMotionPair& pair, const Vec3& tip, bool is_inserted) const {
  const std::string_view bytes = path_.source;
  Tokens tokens(pair.fields.size());
  put_end(pair, {tip, Vec3::UnitZ()}, tokens);
  const bool has_comp = pair.motion.comp && !is_inserted;
  std::string line(has_comp ? pair.fields[*pair.motion.comp].text : "0");
  for (const std::size_t field : pair.motion.tip) {
    const std::string token = tokens[field].empty() ? std::string(pair.fields[field].text) : tokens[field];
    const std::string padding = tips_.padding(token, 1);
    line += (padding.empty() ? " " : padding) + token;
  }
  line += " " + std::string(pair.fields[pair.motion.feed].text);
  const std::size_t flags = pair.motion.flags;
  if (flags < pair.fields.size()) line += " " + (is_inserted ? "0" : std::string(pair.fields[flags].text));

  const std::size_t code = offset(pair.lines.code_text), first = offset(pair.lines.parameters);
  std::string result(bytes.substr(pair.lines.first_byte, code - pair.lines.first_byte));
  result += std::to_string(NciCode::kLinear);
  const std::size_t after_code = code + pair.lines.code_text.size();
  result += bytes.substr(after_code, first - after_code);
  result += line;
  const std::size_t end = first + pair.lines.parameters.size();
  result += bytes.substr(end, pair.lines.last_byte - end);
  return is_inserted ? with_line_end(std::move(result)) : result;
}

std::string NciText::with_line_end(std::string text) const {
  if (text.empty() || text.back() != '\n') text += line_end_;
  return text;
}

}  // namespace gouge
