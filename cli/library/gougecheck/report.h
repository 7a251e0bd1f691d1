#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

enum class State : std::uint8_t {
  clean,
  near_miss,  ///< nearer than CheckOptions::near_miss
  gouge,
  buried,         ///< inside a solid, with no surface inside the tool
  not_checked,    ///< could not be checked: see Report::reason
  not_certified,  ///< checked, but not proved within the budget
};
/// Returns clean, near, gouge, buried, not-checked or not-certified.
[[nodiscard]] GOUGECHECK_EXPORT const char* state_name(State state);

enum class Body : std::uint8_t { cutter, shank, holder, head };

/// Verdict on a whole path. It is `gouges` if a move gouges or is buried. It is `clean` if every move is clean or near,
/// and none of the facts on which this rests is open.
enum class Verdict : std::uint8_t { clean, gouges, not_fully_checked };

/// Neighbouring moves with one cause, or all moves that could not be checked or certified for one reason. The data are
/// those of its worst move, or of its first one if it was not checked. Lengths in mm.
struct Finding {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  State state = State::gouge;
  std::size_t move = 0, moves = 0;  ///< index of the move; number of moves
  std::size_t line = 0;             ///< in the file; for a path from memory the number of the move, from 1
  double depth = kNone, depth_upper = kNone, overcut = kNone;  ///< as in Report; NaN: none
  double clearance = kNone;                                    ///< distance of a near miss; else NaN
  double t = kNone;                                            ///< instant of the witness; NaN: there is no witness
  std::optional<Body> body;                                    ///< none: the whole tool
  std::string against;                     ///< name of the mesh, or "stock"; empty: there is no witness
  std::string tool, operation;             ///< number of the tool, else its name; empty: none is named
  Vec3 tip = {0, 0, 0}, axis = {0, 0, 1};  ///< the tool at the instant `t`, or at the end of the move
  std::optional<Vec3> point, normal;       ///< of the witness, as in Report
  std::string message;                     ///< one line, without the place, in the unit of the path
};

/// Result of a check: one entry for each move, in order, as a structure of arrays. For every move depth <= true depth
/// <= depth_upper. Immutable; spans are valid as long as a copy of the report exists.
class GOUGECHECK_EXPORT Report {
 public:
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] bool is_clean() const { return verdict() == Verdict::clean; }
  /// Returns the exit status of `gougecheck check` for this verdict: 0 clean, 1 gouges, 4 not fully checked.
  [[nodiscard]] int exit_status() const;
  [[nodiscard]] std::size_t count(State state) const;
  [[nodiscard]] double worst_depth() const;  ///< of all moves; 0 if no move has a depth

  [[nodiscard]] std::span<const State> state() const;
  /// Returns the depth of the deepest surface point in the tool: positive inside, 0 outside, NaN for buried and
  /// unchecked moves.
  [[nodiscard]] std::span<const double> depth() const;
  [[nodiscard]] std::span<const double> depth_upper() const;
  /// Returns the witness of `depth`: instant of the move in [0, 1], point of the surface, unit direction in which the
  /// tool must move away. NaN if there is none.
  [[nodiscard]] std::span<const double> t() const;
  [[nodiscard]] std::span<const Vec3> point() const;
  [[nodiscard]] std::span<const Vec3> normal() const;
  /// Returns data of the witness: the face of its mesh in the given numbering, the index of the mesh, and the body of
  /// the tool. Each is -1 if there is no witness.
  [[nodiscard]] std::span<const std::int64_t> triangle() const;
  [[nodiscard]] std::span<const std::int32_t> mesh() const;
  [[nodiscard]] std::span<const std::int8_t> body() const;        ///< a value of Body
  [[nodiscard]] std::span<const std::int8_t> is_fixture() const;  ///< 1: `mesh` is the index of a fixture; 0: of a part
  /// Returns a lower bound of the distance by which the tool reached below the surface; NaN if it was not measured.
  [[nodiscard]] std::span<const double> overcut() const;
  /// Returns why a move is not checked, not certified or buried. For other moves it is empty or a remark.
  [[nodiscard]] std::string reason(std::size_t move) const;
  /// Returns the gouges, buried tools and near misses in the order of the path, then the reasons of open moves.
  [[nodiscard]] std::vector<Finding> findings() const;
  /// Returns the facts on which the verdict rests. It is clean only if none of them is open.
  [[nodiscard]] std::vector<Assumption> assumptions() const;
  /// Returns exceptions to the verdict, and warnings about the inputs.
  [[nodiscard]] std::vector<Note> notes() const;

  /// Returns the report as the program prints it: one line for each finding, then the summary.
  [[nodiscard]] std::string text() const;
  /// Writes the report in the format of the file's extension: .json, .csv, .sarif, .xml (JUnit), .html (without
  /// pictures), .txt. The file appears complete or not at all.
  /// Throws   Error: another extension; a file that was read for this report; file-unwritable.
  void write(const std::string& file) const;

  /// Returns the report for `from_bytes` of this version, in this or another process. It has all that is written.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws   Error: saved-bytes.
  [[nodiscard]] static Report from_bytes(std::string_view bytes);

  struct Content;
  explicit Report(std::shared_ptr<const Content> content);

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace gougecheck
