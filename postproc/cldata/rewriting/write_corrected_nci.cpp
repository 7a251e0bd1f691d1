#include "postproc/cldata/rewriting/rewriters.h"

#include <optional>
#include <utility>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/rewriting/change_table.h"
#include "postproc/cldata/rewriting/nci_text.h"

namespace gouge {
namespace {

constexpr double kSameNciAxis = 5e-7;
constexpr std::size_t kPointAndAxis = 6;  // numbers of a five-axis line

bool is_plain(const Vec3& axis) { return (axis - Vec3::UnitZ()).cwiseAbs().maxCoeff() <= kSameNciAxis; }

class NciCorrector {
 public:
  NciCorrector(const Toolpath& path, const std::vector<PathChange>& changes)
      : path_(path), read_(read_motion_records(path)), text_(path, read_), changes_(path.moves.size(), changes) {}

  Result<std::string> write();

 private:
  [[nodiscard]] Pose in_file(std::size_t move, const Pose& pose) const;
  [[nodiscard]] std::optional<Diagnostic> find_error(std::size_t move, const NciMotionPair& pair) const;
  [[nodiscard]] std::string insertions(std::size_t move, const NciMotionPair& pair) const;
  [[nodiscard]] std::string own_pair(std::size_t move, const NciMotionPair& pair) const;
  [[nodiscard]] Diagnostic error(const char* code, std::size_t move, const std::string& message) const {
    return make_error(code, "move " + std::to_string(move) + " " + message, path_.file, path_.moves[move].line);
  }

  const Toolpath& path_;
  MotionRecords read_;
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

Result<std::string> NciCorrector::write() {
  std::string result;
  result.reserve(path_.source.size() + path_.source.size() / 8);
  std::size_t copied = 0;
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    const bool is_straightened = changes_.is_straightened(i) && path_.moves[i].curve_kind != CurveKind::none;
    if (is_straightened || changes_.has_new_end(i) || changes_.has_insertion(i)) {
      const NciMotionPair pair = text_.pair_of(i);
      if (auto error = find_error(i, pair)) return std::move(*error);
      result.append(path_.source, copied, pair.lines.first_byte - copied);
      copied = pair.lines.last_byte;
      result += insertions(i, pair) + own_pair(i, pair);
    }
  }
  result.append(path_.source, copied);
  return result;
}

}  // namespace

Result<std::string> write_corrected_nci(const Toolpath& path, const std::vector<PathChange>& changes) {
  return NciCorrector(path, changes).write();
}

}  // namespace gouge
