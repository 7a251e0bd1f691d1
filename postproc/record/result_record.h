#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/units.h"
#include "lib/check/verdict.h"
#include "lib/geom/vec.h"
#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"
#include "postproc/record/correction_record.h"

// The result of a check or a correction in the form of `--json`: the data of docs/formats/report_json.md, field by
// field. result_fields.h describes the fields once for the writer, the reader and the schema. Lengths are in mm here,
// and in the unit of the toolpath in the file.

namespace gouge {

/// An input file of the run.
struct InputFile {
  std::string role;  ///< "toolpath", "machine", "part", "fixture", "head", "tools", "baseline", "project", ...
  std::string name;  ///< as the user named it
  std::uint64_t bytes = 0;
  std::string checksum;  ///< "sha256:" and 64 hexadecimal digits
};

/// Options by name, each with its texts: one, or several for a repeated option. They have the order of the file.
using OptionTexts = std::vector<std::pair<std::string, std::vector<std::string>>>;

struct OptionsRecord {
  double tolerance_mm = 0, resolution_mm = 0, stock_to_leave_mm = 0, shank_clearance_mm = 0, holder_clearance_mm = 0,
         near_miss_mm = 0;
  std::string rapid;
  OptionTexts more;  ///< options other than these
};

struct MovesByKind {
  std::size_t feed = 0, rapid = 0, arc = 0, cycle = 0;
};

struct ToolpathRecord {
  std::string file, dialect;
  bool is_unit_stated = false;
  std::size_t moves = 0;
  MovesByKind moves_by_kind;
  std::size_t operations = 0;
  std::map<std::string, std::size_t> words_not_understood;
};

struct MeshRecord {
  std::string name;
  std::size_t triangles = 0, vertices = 0, dropped = 0;
  bool is_closed = false;
  std::string meaning;
};

struct ToolRecord {
  std::optional<std::size_t> number;
  std::string name, defined_in, description;
  std::size_t line = 0;
  std::string key;                      ///< the text of tool_key
  std::optional<std::string> identity;  ///< ToolFacts::identity; none: the tool is not defined
  std::vector<Body> bodies;
};

struct TotalsRecord {
  std::size_t moves = 0, clean = 0, near = 0, gouge = 0, buried = 0, not_checked = 0, not_certified = 0,
              left_out_as_asked = 0;
  double worst_depth_mm = 0, worst_overcut_mm = 0;
  std::optional<double> worst_overcut_upper_mm;  ///< none: there is no bound
  std::optional<std::size_t> worst_move;
  std::optional<double> largest_gap_mm;  ///< none: there is no bound
  std::size_t wide_gaps = 0;
  std::optional<double> largest_overcut_gap_mm;  ///< none: there is no bound
  std::size_t wide_overcut_gaps = 0;
};

struct ClosenessRecord {
  std::size_t cuts = 0, positions = 0;
  std::optional<double> nearest_mm, median_mm;
};

struct NeedRecord {
  std::optional<double> needed_mm;
  std::optional<std::size_t> move, line;
  std::optional<Body> body;
  std::optional<MoveState> state;
};

struct OperationNeedRecord {
  std::string operation;
  NeedRecord need;
};

struct ToolNeedRecord {
  std::string tool;
  double now_mm = 0;
  NeedRecord need;
  std::vector<OperationNeedRecord> operations;
};

struct StickoutRecord {
  double step_mm = 0, max_longer_mm = 0;
  std::vector<ToolNeedRecord> tools;
};

struct CureOptionsRecord {
  double lift_step_mm = 0, max_lift_mm = 0, max_tilt_rad = 0, blend_mm = 0;
};

struct BaselineEntryRecord {
  std::string finding, by, date, reason, use, why;
};

struct BaselineRecord {
  std::string file;
  std::size_t accepted_findings = 0, accepted_moves = 0;
  std::vector<BaselineEntryRecord> entries;
};

struct AcceptanceRecord {
  bool is_accepted = false;
  std::vector<std::size_t> entries;
  std::string why_not;
};

struct TiltCureRecord {
  std::optional<double> tilt_rad;
  std::optional<std::string> reason;
};

struct LiftCureRecord {
  std::optional<double> lift_mm;
  bool is_least = false;
  double not_free_below_mm = 0;
  std::size_t move = 0, line = 0;
  Body body = Body::cutter;
  MoveState state = MoveState::gouge;
};

struct CuresRecord {
  TiltCureRecord tilt;
  LiftCureRecord lift;
};

/// A finding, or a run of moves with another state.
struct EventRecord {
  std::optional<std::size_t> number;  ///< number in finding_numbers; none: it is not a finding
  MoveState state = MoveState::gouge;
  std::size_t first_move = 0, last_move = 0;
  std::size_t moves = 1;
  std::size_t worst_move = 0, line = 0;
  std::string tool;
  std::optional<std::size_t> tool_index;  ///< index into ResultRecord::tools; none: no tool
  Body body = Body::cutter;
  Against against = Against::part;
  std::optional<std::string> obstacle;
  std::optional<AcceptanceRecord> acceptance;
  std::optional<CuresRecord> cures;
};

struct ReasonRecord {
  MoveState state = MoveState::not_checked;
  std::string reason;
  std::size_t moves = 1, first_move = 0, first_line = 0;
};

/// Shares of the ways of the rotary joints in a move; the first joint is the one nearer to the part.
struct TurnRecord {
  double first = 0, second = 0;
};

struct WitnessRecord {
  double t = 0;
  Vec3 point_mm = Vec3::Zero(), normal = Vec3::Zero();
  Body body = Body::cutter;
  Against against = Against::part;
  std::string mesh;
  std::size_t triangle = 0;
  std::optional<TurnRecord> turn{};  ///< none: the tool axis is that of the law at `t`
};

/// A body that gouges an obstacle in a move whose witness is of another body or another obstacle.
struct FurtherRecord {
  Body body = Body::cutter;
  Against against = Against::part;
  std::optional<double> depth_mm;        ///< in the body alone; none: it is open whether the body gouges
  std::optional<double> depth_upper_mm;  ///< none: there is no bound
  std::optional<WitnessRecord> witness;  ///< none: no depth
};

/// Data of a move that is not clean.
struct MoveRecord {
  std::size_t move = 0, line = 0;
  MoveKind kind = MoveKind::feed;
  std::string tool, operation, statement;
  std::string motion;  ///< the text of motion_key
  MoveState state = MoveState::gouge;
  std::optional<double> depth_mm, depth_upper_mm;      ///< none: not measured, or there is no bound
  std::optional<double> overcut_mm, overcut_upper_mm;  ///< none: not measured
  std::optional<double> clearance_mm;
  std::optional<WitnessRecord> witness;
  std::vector<FurtherRecord> further;  ///< the deepest first
  std::string reason;
};

/// Consecutive moves with the same operation and tool, up to the next run.
struct RunRecord {
  std::size_t first_move = 0;
  std::string operation, tool;
};

/// A move that meets remaining stock.
struct StockContactRecord {
  std::size_t move = 0, line = 0;
  double clear_until = 0, contact_at = 0;         ///< instants of the move, in [0, 1]
  std::optional<std::size_t> cut_move, cut_line;  ///< the earlier cut that came nearest to the witness
  std::optional<std::string> cut_file;            ///< its file if that is a program of --before; none: the path
  std::optional<double> missed_by_mm;             ///< its distance from the witness
};

/// The material that is left after the path, in two meshes.
struct StockLeftRecord {
  double cell_mm = 0;
  double perhaps_mm3 = 0, surely_mm3 = 0;  ///< volumes
  std::optional<double> apart_mm;
  std::size_t sliver_cells = 0;
};

/// The check against remaining stock.
struct StockRecord {
  double tolerance_mm = 0, resolution_mm = 0;
  std::size_t examined = 0, clear = 0;  ///< moves
  std::vector<StockContactRecord> contacts;
  std::optional<StockLeftRecord> left = {};  ///< none: not requested
};

/// A place where more material than asked may be left on a part.
struct ExcessPlaceRecord {
  std::optional<double> height_mm;  ///< none: nothing is proved
  double height_upper_mm = 0;
  Vec3 point_mm = Vec3::Zero(), normal = Vec3::Zero();
  std::string part;
  std::size_t facet = 0;
  double area_mm2 = 0, area_upper_mm2 = 0;
  std::optional<std::size_t> unknown_move, unknown_line;  ///< without a height: the move that leaves it open
  std::optional<std::string> unknown_file;                ///< its file if that is a program of --before; none: the path
};

/// The material that the whole program leaves on the parts.
struct ExcessRecord {
  double asked_mm = 0, resolution_mm = 0;
  double surface_mm2 = 0;
  std::vector<ExcessPlaceRecord> places;
};

/// Result of a law of motion that a check compares.
struct LawRecord {
  std::string law;
  bool is_rapid = false;             ///< the moves are the rapids; otherwise all other moves
  std::size_t gouges = 0, open = 0;  ///< number of moves that gouge, and of moves that are not checked or not certified
  std::optional<double> depth_mm = {};   ///< largest depth of a gouge
  std::optional<std::size_t> line = {};  ///< line of that gouge
  std::string missing = {};              ///< what the law needs and is not given; empty: the law was checked
};

struct ProgramRecord {
  std::string version;
};

inline constexpr const char* kProgramName = "gougecheck";
inline constexpr const char* kResultFormat = "gougecheck-report";
inline constexpr int kResultVersion = 1;

struct ResultRecord {
  ProgramRecord program;
  std::string verdict;  ///< the text of verdict_name
  int exit_status = 0;
  std::string guarantee;
  Assumptions assumptions;
  LengthUnit unit = LengthUnit::mm;
  std::vector<InputFile> inputs;
  OptionsRecord options;
  std::string placement;
  ToolpathRecord toolpath;
  std::vector<MeshRecord> parts, fixtures, heads;
  std::vector<ToolRecord> tools;
  TotalsRecord totals;
  std::optional<ClosenessRecord> closeness;
  std::optional<AnyTurnCounts> any_turn;  ///< none: not examined, or nothing to examine
  std::optional<StockRecord> stock;       ///< none: not requested
  std::optional<ExcessRecord> excess;     ///< none: not requested
  std::vector<LawRecord> laws;            ///< empty: not compared
  std::optional<StickoutRecord> stickout;
  std::optional<CureOptionsRecord> cures;
  std::optional<BaselineRecord> baseline;
  std::vector<EventRecord> events;
  std::vector<ReasonRecord> reasons;
  std::vector<MoveRecord> moves;  ///< moves that are not clean, in path order
  std::optional<CorrectionRecord> correction;
  Diagnostics notes;
  std::vector<RunRecord> runs;  ///< runs of all moves
  /// the first kListedDigits of each motion_key; one text has those of kMotionsOfText moves
  std::vector<std::string> motions;

  /// Returns how many moves `motions` lists.
  [[nodiscard]] std::size_t listed_motions() const;
  /// Returns the listed digits of a move. Requires move < listed_motions(), and texts that are all full except the
  /// last.
  [[nodiscard]] std::string_view motion(std::size_t move) const;
  /// Returns the listed digits of all moves. The record must outlive them.
  [[nodiscard]] std::vector<std::string_view> motion_list() const;
};

/// Form of ResultRecord::motions.
inline constexpr std::size_t kListedDigits = 12, kMotionsOfText = 1000;

}  // namespace gouge
