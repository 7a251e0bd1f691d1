#include "postproc/cldata/nci/nci_edits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/geom/pose.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/language/text.h"
#include "postproc/cldata/nci/nci_motion.h"
#include "postproc/cldata/rewriting/change_table.h"
#include "postproc/cldata/rewriting/goto_text.h"

namespace gouge {
namespace {

// Motion pairs in the style of one NCI file: its pairs with other ends, and new pairs of the same form. Ends are in the
// file's unit. A position inserted before a pair states its end, compensation 0 (no change) and flags 0. Compensation
// and flags are events of the pair's own position. It also has the feed of the pair, with which -1 and -2 stay correct.

struct NciMotionPair {
  NciPair lines;
  std::vector<Argument> fields;
  NciMotion motion;
};

class NciText {
 public:
  /// Learns the style from the first motions of the file.
  NciText(const Toolpath& path, const MotionRecords& records);

  /// Returns the pair of a move that has a position.
  [[nodiscard]] NciMotionPair pair_of(std::size_t move) const;

  /// Returns `pair` with another end. Numbers that are equal at the file's decimals keep their bytes. The axis is used
  /// only for five axes. The distance of the second point from the tip stays the same, with as many decimals as the
  /// file has. It gets more if the axis would be read with a larger error than from the last digit of the file. The
  /// allowed error is at least 1e-6 and at most 1e-5. Requires a line, of five axes or not.
  [[nodiscard]] std::string moved(const NciMotionPair& pair, const Pose& end) const;
  /// Returns a position of the same form, to be put before `pair`. Requires a line, of five axes or not.
  [[nodiscard]] std::string inserted(const NciMotionPair& pair, const Pose& end) const;
  /// Returns a line in place of the arc `pair`, or before it.
  [[nodiscard]] std::string straight(const NciMotionPair& pair, const Vec3& tip, bool is_inserted) const;

 private:
  using Tokens = std::vector<std::string>;  // for each field; empty: the bytes of the file stay

  void learn(const NciMotionPair& pair);
  [[nodiscard]] std::size_t offset(std::string_view text) const {
    return static_cast<std::size_t>(text.data() - path_.source.data());
  }
  void put_end(const NciMotionPair& pair, const Pose& end, Tokens& tokens) const;
  void put_second_point(const NciMotionPair& pair, const Vec3& tip, const Vec3& axis, Tokens& tokens) const;
  [[nodiscard]] std::string rendered(const NciMotionPair& pair, const Tokens& tokens) const;
  [[nodiscard]] std::string with_line_end(std::string text) const;

  const Toolpath& path_;
  NumberStyle tips_, second_points_;
  // error of a point by the decimals of the file; divided by the length it is that of the axis
  double min_axis_error_ = 0;
  std::string line_end_;
};

constexpr std::size_t kPairsLearned = 5000;
constexpr int kUsualNciDecimals = 6, kMaxDecimals = 15;
constexpr double kMinAxisError = 1e-6, kMaxAxisError = 1e-5;

bool is_zero(const Argument& field) { return field.number && std::abs(*field.number) <= 0; }

// Sets compensation or flags of an inserted position to "no change" and "nothing special".
void put_nothing(const NciMotionPair& pair, std::optional<std::size_t> field, std::vector<std::string>& tokens) {
  if (field && *field < pair.fields.size() && !is_zero(pair.fields[*field])) tokens[*field] = "0";
}

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
  min_axis_error_ = std::sqrt(0.75) * std::pow(10.0, -as_it_is.decimals());
  tips_.choose_decimals(min_coordinate_decimals(path.unit), kUsualNciDecimals);
  second_points_.choose_decimals(min_coordinate_decimals(path.unit), kUsualNciDecimals);
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
  const double allowed = std::clamp(min_axis_error_ / length, kMinAxisError, kMaxAxisError);
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
    if (((read - tip).normalized() - axis).norm() <= allowed || style.decimals() >= kMaxDecimals) return;
    style.choose_decimals(style.decimals() + 1, style.decimals() + 1);
  }
}

void NciText::put_end(const NciMotionPair& pair, const Pose& end, Tokens& tokens) const {
  Vec3 tip = Vec3::Zero();  // the tip as it will be read
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
    if (padding.empty() && blanks > 0) padding = " ";  // for a number that is wider than its column
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

constexpr double kSameNciAxis = 5e-7;
constexpr std::size_t kPointAndAxis = 6;  // number of numbers in a five-axis line

bool is_plain(const Vec3& axis) { return (axis - Vec3::UnitZ()).cwiseAbs().maxCoeff() <= kSameNciAxis; }

class NciCorrector {
 public:
  NciCorrector(const Toolpath& path, const MotionRecords& records, const std::vector<PathChange>& changes)
      : path_(path), read_(records), text_(path, read_), changes_(path.moves.size(), changes) {}

  Result<Edits> edits();

 private:
  [[nodiscard]] Pose in_file(std::size_t move, const Pose& pose) const;
  [[nodiscard]] std::optional<Diagnostic> find_error(std::size_t move, const NciMotionPair& pair) const;
  [[nodiscard]] std::string insertions(std::size_t move, const NciMotionPair& pair) const;
  [[nodiscard]] std::string own_pair(std::size_t move, const NciMotionPair& pair) const;
  [[nodiscard]] Diagnostic error(const char* code, std::size_t move, const std::string& message) const {
    return make_error(code, "move " + std::to_string(move) + " " + message, path_.file, path_.moves[move].line);
  }

  const Toolpath& path_;
  const MotionRecords& read_;
  NciText text_;
  ChangeTable changes_;
};

Pose NciCorrector::in_file(std::size_t move, const Pose& pose) const {
  const MotionFrame& frame = *read_.of_move[move].frame;
  Pose local = frame.to_part.inverse().pose(pose);
  local.tip /= frame.mm_per_unit;
  return local;
}

std::optional<Diagnostic> NciCorrector::find_error(std::size_t move, const NciMotionPair& pair) const {
  const PathChange& change = *changes_[move];
  const std::size_t next = move + 1;
  const bool meets_arc = next < path_.moves.size() && path_.moves[next].kind == MoveKind::arc &&
                         path_.moves[next].has_start && !changes_.is_straightened(next);
  if (change.new_end && meets_arc)
    return error("write-arc", move, "ends where an arc that stays begins; expected that arc straightened as well");
  const bool is_axis_stated_next = next >= path_.moves.size() || read_.of_move[next].numbers == kPointAndAxis;
  const bool is_newly_tilted = change.new_end && is_plain(in_file(move, path_.moves[move].end).axis) &&
                               !is_plain(in_file(move, *change.new_end).axis);
  if (is_newly_tilted && !is_axis_stated_next)
    return error("write-axis", move,
                 "stands before a line or arc of NCI that has no tool axis, which would be in doubt behind a tilted "
                 "position; expected a change that keeps +Z");
  if (pair.motion.form == NciForm::five_axis) return std::nullopt;
  if (change.new_end && !is_plain(in_file(move, *change.new_end).axis))
    return error("write-axis", move,
                 "is on a line or arc of NCI that has no tool axis; expected a change that keeps +Z");
  for (const Pose& pose : change.inserted_before) {
    if (!is_plain(in_file(move, pose).axis))
      return error("write-axis", move,
                   "is on a line or arc of NCI that has no tool axis, which would be in doubt behind a tilted "
                   "position; expected positions before it that keep +Z");
  }
  return std::nullopt;
}

std::string NciCorrector::insertions(std::size_t move, const NciMotionPair& pair) const {
  std::string text;
  for (const Pose& pose : changes_[move]->inserted_before) {
    const Pose end = in_file(move, pose);
    text += pair.motion.form == NciForm::arc ? text_.straight(pair, end.tip, true) : text_.inserted(pair, end);
  }
  return text;
}

std::string NciCorrector::own_pair(std::size_t move, const NciMotionPair& pair) const {
  const PathChange& change = *changes_[move];
  const Pose end = in_file(move, change.new_end.value_or(path_.moves[move].end));
  if (pair.motion.form == NciForm::arc) return text_.straight(pair, end.tip, false);
  if (change.new_end) return text_.moved(pair, end);
  return path_.source.substr(pair.lines.first_byte, pair.lines.last_byte - pair.lines.first_byte);
}

Result<Edits> NciCorrector::edits() {
  Edits edits;
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    const bool is_straightened = changes_.is_straightened(i) && path_.moves[i].curve_kind != CurveKind::none;
    if (is_straightened || changes_.has_new_end(i) || changes_.has_insertion(i)) {
      const NciMotionPair pair = text_.pair_of(i);
      if (auto error = find_error(i, pair)) return std::move(*error);
      edits.push_back({pair.lines.first_byte, pair.lines.last_byte, insertions(i, pair) + own_pair(i, pair)});
    }
  }
  return edits;
}

}  // namespace

Result<Edits> edits_of_nci(const Toolpath& path, const MotionRecords& records, const std::vector<PathChange>& changes) {
  return NciCorrector(path, records, changes).edits();
}

}  // namespace gouge
