#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
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

// The neutral toolpath: the content of a cutter-location file, free of any dialect, in mm and part coordinates. Every
// move remembers the source line on which its statement begins. Readers and writers: postproc/cldata.

namespace gouge {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A count or an index below 2^32 - 1, or kNone, in half the memory of a std::size_t: a toolpath has millions of them.
/// It requires such a value; read_toolpath takes no file with more.
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

/// As a file states it: e and f are recomputed where alpha = beta = 0; an h of 0 is not given.
struct CutterStatement : AptCutter {
  int given = 0;  ///< how many numbers the statement had
};

/// A tool as the toolpath knows it.
struct PathTool {
  std::optional<int> number;              ///< LOADTL, LOAD/TOOL
  std::string name;                       ///< as in the file; may be empty
  std::optional<CutterStatement> cutter;  ///< from CUTTER or TLDATA
  double flute_length_mm = 0;             ///< 0: not given
  std::size_t line = 0;                   ///< where it is defined or loaded
  double stated_diameter_mm = 0;          ///< all that the file states about a cutter it does not define; 0: nothing
};

struct Operation {
  std::string name;  ///< may be empty
  std::size_t line = 0;
};

/// Returns a copy of `text` that lives as long as the process, for Move::not_checked_reason: moves outlive the reader
/// that names their reasons. Thread safe. Memory: each different text once.
[[nodiscard]] const char* lasting_text(std::string text);

/// The statement that a clean check still proves for a motion with a not_checked_reason.
enum class Cover : std::uint8_t {
  none,    ///< nothing
  motion,  ///< the motion holds every motion that its statement may mean
  wide     ///< the same with a tool that is wider by its own diameter (ToolVariants::wide): the tip may be beside the
           ///< motion, across the tool axis, no farther than that
};

/// One motion to one position, from the end of the move before it (Toolpath::start_of). A path holds millions, so it
/// is kept small.
struct Move {
  Pose end;
  double feed_mm = 0;  ///< per minute or revolution, as `feed_unit` states; 0: no number is known
  /// Not empty: why this motion cannot be checked, or may only be found clean (`cover`); text that is never freed.
  std::string_view not_checked_reason;
  SmallIndex line;                         ///< where its statement begins, counted from 1
  SmallIndex statement = kNone;            ///< index into Toolpath::statements
  SmallIndex tool = kNone;                 ///< index into Toolpath::tools; kNone: no tool named yet
  SmallIndex operation = kNone;            ///< index into Toolpath::operations
  SmallIndex curve;                        ///< index into Toolpath::arcs or ::splines
  CurveKind curve_kind = CurveKind::none;  ///< none: the tip runs straight
  MoveKind kind = MoveKind::feed;
  FeedUnit feed_unit = FeedUnit::not_stated;
  /// False: the position alone, the first of the file, of a tool, of a block, or after a motion whose end is unknown.
  bool has_start = false;
  /// A single position: the tool was at the end of the move before, and the file changes neither tool nor frame
  /// between both. The file does not state how it gets here.
  bool is_linked = false;
  Cover cover = Cover::none;  ///< of a motion with a not_checked_reason

  [[nodiscard]] bool is_covered() const { return cover != Cover::none && !not_checked_reason.empty(); }
  [[nodiscard]] bool needs_wide_tool() const { return cover == Cover::wide && !not_checked_reason.empty(); }
  [[nodiscard]] Feed feed() const { return {feed_mm, feed_unit}; }
  void set_feed(const Feed& feed) {
    feed_mm = feed.mm;
    feed_unit = feed.unit;
  }
};

using Moves = PagedVector<Move>;

/// A logical statement and the bytes it spans, line end included, so that a writer can leave it untouched.
struct SourceStatement {
  SmallIndex line;
  SmallIndex first_byte, last_byte;  ///< [first, last)
};

/// Place of each move of a path in its file, and the state in which it was read. A correction needs both to rewrite it.
/// Each reader keeps its own kind.
struct MoveOrigins {
  MoveOrigins() = default;
  MoveOrigins(const MoveOrigins&) = delete;
  MoveOrigins& operator=(const MoveOrigins&) = delete;
  virtual ~MoveOrigins() = default;
};

struct Toolpath {
  std::string file;     ///< as the user named it
  std::string dialect;  ///< "apt", "nx-clsf", "apt-autodesk", ...: docs/formats/apt_cl.md
  LengthUnit unit = LengthUnit::mm;
  bool is_unit_stated = false;
  SourceText source;  ///< the file's bytes
  PagedVector<SourceStatement> statements;
  std::vector<PathTool> tools;
  std::vector<Operation> operations;
  Moves moves;
  PagedVector<PathArc> arcs;        ///< of moves whose curve_kind is arc
  std::vector<PathSpline> splines;  ///< of moves whose curve_kind is spline
  /// Plane to which cycles without a height of their own retract, by the user, in the coordinates of positions, mm.
  std::optional<double> retract_plane_mm;
  std::vector<std::string> harmless_words;                  ///< the user states that they move and change nothing
  std::map<std::string, std::size_t> words_not_understood;  ///< major word -> how often; reported to the user
  Diagnostics notes;              ///< warnings and notes of reading; errors make reading fail instead
  Assumptions assumptions;        ///< unit, dialect, completeness, statements and frame of a file that was read
  bool has_turned_frame = false;  ///< the file's X, Y and Z are not the part's in some of its moves
  /// Null where the path was read without; a caller that needs them then reads the file again.
  std::shared_ptr<const MoveOrigins> origins;
  std::shared_ptr<const JointPath> joints;  ///< of the machine that it is checked for; null: none

  /// Returns where a move starts: removing moves from a path changes where those behind them start.
  /// Requires moves[move].has_start and move > 0.
  [[nodiscard]] const Pose& start_of(std::size_t move) const { return moves[move - 1].end; }
};

/// True where a motion of that tool needs ToolVariants::wide.
[[nodiscard]] bool needs_wide_tool(const Toolpath& path, std::size_t tool);

}  // namespace gouge
