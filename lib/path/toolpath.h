#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/paged_memory.h"
#include "lib/base/units.h"
#include "lib/geom/pose.h"
#include "lib/path/apt_cutter.h"
#include "lib/path/assumption.h"
#include "lib/path/curve.h"
#include "lib/path/feed.h"
#include "lib/path/joint_angles.h"
#include "lib/path/source_text.h"

// The neutral toolpath: the content of a cutter-location file, independent of any dialect, in mm and part coordinates.
// Every move has the source line on which its statement begins. Readers and writers: postproc/cldata.

namespace gouge {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A count or an index below 2^32 - 1, or kNone, in half the memory of a std::size_t: a toolpath has millions of them.
/// Requires such a value; read_toolpath accepts no file with more.
class SmallIndex {
 public:
  constexpr SmallIndex(std::size_t value = 0) : value_(static_cast<std::uint32_t>(value)) {}
  constexpr operator std::size_t() const { return value_ == kNoValue ? kNone : value_; }

 private:
  static constexpr std::uint32_t kNoValue = static_cast<std::uint32_t>(kNone);

  std::uint32_t value_;
};

enum class MoveKind : std::uint8_t { feed, rapid, arc, cycle };
[[nodiscard]] const char* kind_name(MoveKind kind);

/// A cutter as a file states it; e and f are recomputed if alpha = beta = 0; an h of 0 means that it is not stated.
struct CutterStatement : AptCutter {
  int given = 0;  ///< number of values in the statement
};

/// Facts about a tool in a tool table of the control.
struct TableTool {
  std::string file = {};                 ///< of the table; empty: it states none
  bool has_diameter = false;             ///< PathTool::stated_diameter_mm is that of the table
  std::optional<double> corner_mm = {};  ///< corner radius; many tables leave it at 0
};

/// A tool as the toolpath states it.
struct PathTool {
  std::optional<int> number;              ///< number of LOADTL or LOAD/TOOL
  std::string name;                       ///< as in the file; may be empty
  std::optional<CutterStatement> cutter;  ///< from CUTTER or TLDATA
  double flute_length_mm = 0;             ///< 0: not stated
  std::size_t line = 0;                   ///< line on which it is defined or loaded
  double stated_diameter_mm = 0;          ///< the only fact that the file states about a cutter it does not define; 0:
                                          ///< none
  std::optional<double> gauge_length_mm =
      {};                                  ///< from the gauge point of the spindle to the tip, as a set-up states it
  std::set<std::string> other_names = {};  ///< further names that the file states for it
  double stickout_mm = 0;                  ///< from the tip to the holder; 0: not stated
  double loaded_length_mm = 0;             ///< LENGTH of its loading, from the tip to the gauge line; 0: not stated
  bool has_other_length = false;           ///< another loading states another stick-out or LENGTH
  std::optional<int> other_register = {};  ///< register of its length, if it is not the number of the tool
  TableTool in_table = {};
};

struct Operation {
  std::string name;  ///< may be empty
  std::size_t line = 0;
};

/// Returns a copy of `text` that lives as long as the process. It is for Move::not_checked_reason, because moves
/// outlive the reader that states their reasons. Thread safe. Each different text is stored once.
[[nodiscard]] const char* lasting_text(std::string text);

/// Facts that a clean check still proves for a motion with a not_checked_reason.
enum class Cover : std::uint8_t {
  none,    ///< no fact
  motion,  ///< the motion contains every motion that its statement may mean
  wide     ///< as `motion`, with a tool that is wider by its own diameter (ToolVariants::wide): the tip may deviate
           ///< from the motion, across the tool axis, by at most that length
};

/// One motion to one position, from the end of the move before it (Toolpath::start_of). A path has millions of moves,
/// so a move is kept small.
struct Move {
  static constexpr float kSpindleStopped = -1;

  Pose end;
  double feed_mm = 0;  ///< per minute or revolution, as `feed_unit` states; 0: not known
  /// If not empty: the reason why this motion cannot be checked, or can only be found clean (`cover`). The text is
  /// never freed.
  std::string_view not_checked_reason;
  SmallIndex line;               ///< line on which its statement begins, counted from 1
  SmallIndex statement = kNone;  ///< index into Toolpath::statements
  SmallIndex tool = kNone;       ///< index into Toolpath::tools; kNone: no tool stated yet
  SmallIndex operation = kNone;  ///< index into Toolpath::operations
  SmallIndex curve;              ///< index into Toolpath::arcs or ::splines
  float spindle_rpm = 0;  ///< revolutions per minute that the file states; 0: not known, kSpindleStopped: it is stopped
  CurveKind curve_kind = CurveKind::none;  ///< none: the tip moves straight
  MoveKind kind = MoveKind::feed;
  FeedUnit feed_unit = FeedUnit::not_stated;
  /// False for a single position: the first of the file, of a tool or of a block, or one after a motion whose end is
  /// unknown.
  bool has_start = false;
  /// True for a single position of the tool that was at the end of the move before it. The file does not state the
  /// motion between both, and states no way home.
  bool is_linked = false;
  /// True for a single position of CL data to which the file states no way at all: the first of the file, of another tool,
  /// or after the way home. The tool leaves the position before it on a way that is not stated either.
  bool begins_stretch = false;
  /// True for a motion without tool centre point control, which programs of a machine can state: all joints run, and tip
  /// and axis follow them. False: the tip runs as the path states.
  bool runs_joints = false;
  Cover cover = Cover::none;  ///< for a motion with a not_checked_reason

  /// Returns whether the file stops the spindle before this motion: the cutter removes no stock.
  [[nodiscard]] bool is_spindle_stopped() const { return spindle_rpm < 0; }
  [[nodiscard]] bool is_covered() const { return cover != Cover::none && !not_checked_reason.empty(); }
  [[nodiscard]] bool needs_wide_tool() const { return cover == Cover::wide && !not_checked_reason.empty(); }
  [[nodiscard]] Feed feed() const { return {feed_mm, feed_unit}; }
  void set_feed(const Feed& feed) {
    feed_mm = feed.mm;
    feed_unit = feed.unit;
  }
};

using Moves = PagedVector<Move>;

/// A logical statement and its range of bytes, including the line end, so that a writer can leave it unchanged.
struct SourceStatement {
  SmallIndex line;
  SmallIndex first_byte, last_byte;  ///< range [first, last)
};

/// The place of each move of a path in its file, and the state in which it was read. A correction needs both to rewrite
/// the move. Each reader has its own type.
struct MoveOrigins {
  MoveOrigins() = default;
  MoveOrigins(const MoveOrigins&) = delete;
  MoveOrigins& operator=(const MoveOrigins&) = delete;
  virtual ~MoveOrigins() = default;
};

/// A rapid from a place that is not known to a height, or at a height to a place: the tip is at least at `height_mm`
/// along `axis`, in part coordinates, if the tool came from above. Minus infinity: the height is not known.
struct ApproachHeight {
  std::size_t line = 0;
  Vec3 axis = Vec3::UnitZ();  ///< unit, the tool axis
  double height_mm = 0;
};

struct Toolpath {
  std::string file;     ///< as the user named it
  std::string dialect;  ///< "apt", "nx-clsf", "apt-autodesk", ...: docs/formats/apt_cl.md
  LengthUnit unit = LengthUnit::mm;
  bool is_unit_stated = false;
  SourceText source;  ///< the bytes of the file
  PagedVector<SourceStatement> statements;
  std::vector<PathTool> tools;
  std::vector<Operation> operations;
  std::vector<ApproachHeight> approaches;  ///< rapids that are no moves; they must be above all that is checked
  Moves moves;
  PagedVector<PathArc> arcs;        ///< of moves with curve_kind arc
  std::vector<PathSpline> splines;  ///< of moves with curve_kind spline
  /// Plane to which cycles without their own height retract. The user states it, in the coordinates of positions, mm.
  std::optional<double> retract_plane_mm;
  std::vector<std::string> harmless_words;                  ///< words that, as the user states, cause no motion and no
                                                            ///< change
  std::map<std::string, std::size_t> words_not_understood;  ///< major word -> number of times; reported to the user
  Diagnostics notes;               ///< warnings and notes of the reader; an error makes reading fail instead
  Assumptions assumptions;         ///< unit, dialect, completeness, statements and frame of a file that was read
  std::string work_offset;         ///< in whose coordinates the positions of a program are; empty: in part coordinates
  std::size_t smoothing_line = 0;  ///< first line of text for the control that lets it leave the path; 0: none
  double smoothing_mm = 0;         ///< the largest distance that such text states; 0: none
  std::size_t joint_law_line = 0;  ///< first line of text by which the rotary joints run in proportion; 0: none
  bool has_turned_frame = false;   ///< in some moves the X, Y and Z of the file are not those of the part
  /// Null if the path was read without them; a caller that needs them then reads the file again.
  std::shared_ptr<const MoveOrigins> origins;
  std::shared_ptr<const JointPath> joints;  ///< for the machine of the check; null: none

  /// Returns the start of a move, which is the end of the move before it. So removing moves from a path changes the
  /// start of the next one. Requires moves[move].has_start and move > 0.
  [[nodiscard]] const Pose& start_of(std::size_t move) const { return moves[move - 1].end; }
};

/// Returns the length from the gauge point of the spindle to the tip in a move: that of its tool, else `stated_mm` if the
/// path has at most one tool. None: it is not known.
[[nodiscard]] std::optional<double> gauge_length_of_move(const Toolpath& path, std::size_t move,
                                                         const std::optional<double>& stated_mm);

/// Returns for each of Toolpath::tools whether a move uses it. Cost: O(moves).
[[nodiscard]] std::vector<bool> used_tools(const Toolpath& path);

/// Returns whether a motion of that tool needs ToolVariants::wide.
[[nodiscard]] bool needs_wide_tool(const Toolpath& path, std::size_t tool);

}  // namespace gouge
