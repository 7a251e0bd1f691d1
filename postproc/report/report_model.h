#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/exit_code.h"
#include "lib/base/units.h"
#include "lib/check/check_options.h"
#include "lib/check/check_result.h"
#include "lib/cure/find_cures.h"
#include "lib/geom/vec.h"
#include "lib/path/axis_quality.h"
#include "lib/path/axis_tilt.h"
#include "lib/path/toolpath.h"
#include "lib/stickout/find_stickout.h"
#include "postproc/record/result_record.h"
#include "postproc/report/baseline_facts.h"
#include "postproc/report/sign_off.h"

// Data for all writers of a report. Lengths are in mm here, and converted to the unit of the toolpath on output. The
// model points to the toolpath and the verdicts, which must outlive it.

namespace gouge {

inline constexpr const char* kProgramVersion = "1.0.0";

/// Describes an input file, so that a reader of the report can identify it.
[[nodiscard]] InputFile describe_input(std::string role, std::string name, std::string_view bytes);

struct MeshFacts {
  std::string name;  ///< as the user named it
  std::size_t triangles = 0, vertices = 0;
  std::size_t dropped = 0;  ///< number of triangles of the file without area
  bool is_closed = false;
  std::string meaning;      ///< consequence for the result, as a sentence; may be empty
  Assumption solid = {};    ///< whether the mesh bounds a solid
  double clearance_mm = 0;  ///< distance that the tool and the heads must keep from it
};

/// Facts about one tool; one entry for each of Toolpath::tools, in its order.
struct ToolFacts {
  std::string name;
  /// "tools.json", "path.apt:12", or "memory" of a tool given to the library; empty: there is no definition, so the tool
  /// could not be checked
  std::string defined_in;
  std::string description;        ///< such as "ball D10, holder D32"; may be empty
  bool has_holder = true;         ///< false: no holder is given, so none was checked
  std::string identity = {};      ///< 32 digits, equal for tools with equal contours; empty: not defined
  std::vector<Body> bodies = {};  ///< the bodies that are checked
};

/// Smoothness of the tool axis before and after a correction. In `before`, moves are those of the original path. In
/// `after` and `tilts` they are those of the corrected path.
struct AxisFacts {
  AxisQuality before, after;
  AxisTilts tilts;
  std::optional<double> max_rotary_deg_per_min;  ///< none: not given

  /// Returns false if the axis does not turn and no limit was given. Then a report need not mention it.
  [[nodiscard]] bool is_of_interest() const {
    return before.has_turns() || after.has_turns() || tilts.positions > 0 || max_rotary_deg_per_min;
  }
};

struct CorrectionFacts {
  std::string output_file;                  ///< empty: no file was written
  std::string_view output_bytes;            ///< the corrected toolpath as written to that file
  std::string strategy;                     ///< as requested
  double max_shift_mm = 0;                  ///< 0: no limit
  std::optional<double> max_side_shift_mm;  ///< none: it depends on the depth
  double rapid_clearance_mm = 0;
  std::size_t curves = 0;          ///< number of arcs and splines that became straight moves
  std::size_t straight_moves = 0;  ///< number of these straight moves, including those of `changes`
  std::vector<CorrectedRecord> changes;
  std::vector<Uncorrected> uncorrected;
  std::vector<Uncut> uncut;
  std::vector<StockStretch> stock;             ///< stretches with more stock than allowed
  std::vector<LowRapid> low_rapids;            ///< in path order
  std::vector<WrittenStatement> written;       ///< all other statements are equal to the byte
  std::optional<AxisFacts> axes;               ///< none: not measured
  const Toolpath* toolpath_before = nullptr;   ///< the path as read
  const CheckResult* result_before = nullptr;  ///< verdicts on that path
};

/// Result of --find-stickout for one tool.
struct StickoutFacts {
  ToolStickout found;
  std::optional<double> shank_end_mm;  ///< height up to which flutes and shank reach; none: not stated
};

struct OptionText {
  std::string name, value;
};

/// The material that is left after the path, in two meshes.
struct StockLeft {
  std::string perhaps_file, surely_file;     ///< empty: nothing is left; nothing is surely left
  std::string_view perhaps_stl, surely_stl;  ///< the content of the files
  double cell_mm = 0;                        ///< longest side of the cells
  double perhaps_mm3 = 0, surely_mm3 = 0;    ///< volumes of the meshes
  std::optional<double> apart_mm;            ///< largest distance of a vertex of the outer mesh from the inner one
  std::size_t sliver_cells = 0;              ///< cells in which slivers count as removed
};

struct ReportModel {
  SignOff sign_off;
  std::vector<InputFile> inputs;
  CheckOptions options;
  std::string placement;                   ///< 32 digits, equal for equal units and places of STL files
  std::vector<OptionText> more_options;    ///< options in force that are not in `options`: "place", "stl-units", ...
  const Toolpath* toolpath = nullptr;      ///< the checked path; for a correction the corrected path
  const CheckResult* result = nullptr;     ///< verdicts on that path
  std::vector<MeshFacts> parts, fixtures;  ///< as in Scene
  std::vector<MeshFacts> heads;            ///< the files of --head, in their order
  std::vector<ToolFacts> tools;            ///< as in Toolpath::tools
  Diagnostics notes;                       ///< warnings and notes about all inputs
  bool has_correction = false;
  CorrectionFacts correction;
  std::optional<StockLeft> stock_left;              ///< none: not requested
  const IndexedMesh* shown_stock = nullptr;         ///< what the 3D view shows of the remaining stock; null: nothing
  std::string_view certificate_bytes;               ///< content of --certificate
  double seconds = 0;                               ///< time from the first file read to this report; only JUnit has it
  std::optional<StickoutOptions> stickout_options;  ///< none: not requested
  std::vector<StickoutFacts> stickouts;
  std::vector<LawRecord> laws;              ///< laws of motion that the check compares; empty: not requested
  std::optional<CureOptions> cure_options;  ///< none: not requested
  std::vector<FindingCures> cures;          ///< for each event, in their order
  std::vector<double> chord_errors_mm;      ///< for each event: estimate of the part's mesh there; empty: not made
  BaselineFacts baseline;
};

/// Verdict on a result, in the order of verdict_words().
enum class OverallVerdict { clean, gouges, not_fully_checked, accepted_gouges, material_left };

/// Returns the verdict. Gouges and buried tools decide first, then material that is left. Next are moves that are not
/// checked, except those excluded on request, open assumptions, and places where it is open whether material is left.
[[nodiscard]] OverallVerdict overall_verdict(const CheckResult& result);
/// Returns the verdict with accepted gouges, which come last before clean, and with warnings that count as errors.
[[nodiscard]] OverallVerdict overall_verdict(const ReportModel& model);
/// Returns clean, gouges, not-fully-checked, accepted-gouges or material-left.
[[nodiscard]] const char* verdict_name(OverallVerdict verdict);
/// Returns the exit status of `check` and `correct` for a verdict.
[[nodiscard]] ExitCode exit_status(OverallVerdict verdict);

/// Returns the guarantee in the toolpath's unit, and the moves to which it does not apply, if some were not checked. It
/// begins "no gouge deeper than tolerance + resolution = 0.011 mm is missed". It ends "and where none is reported the
/// tool reaches at most 3 times that into a solid".
[[nodiscard]] std::string guarantee_text(const ReportModel& model);

/// The guarantee, and the facts that it rests on ("path-unit mm (stated), ..."), which may be empty.
struct Guarantee {
  std::string text, facts;
};
[[nodiscard]] Guarantee guarantee_of(const ReportModel& model);

/// Returns one sentence for each assumption that prevents a clean verdict, with its reason and remedy.
[[nodiscard]] std::vector<std::string> open_facts(const ReportModel& model);

/// Returns reservations about the verdict, a sentence each. (1) An option settles the reason why moves are not checked
/// (remedies.h). (2) The path may not belong to the part. (3) Tools have no holder.
[[nodiscard]] std::vector<std::string> reservations(const ReportModel& model);

/// Returns a distance of ClosestApproach, which is known to a hundredth of a millimetre: "touching", "within 0.83 mm"
/// or "not within 20 mm".
[[nodiscard]] std::string closest_approach_words(const std::optional<double>& distance_mm, LengthUnit unit);

/// Returns the name of a compared law with its moves, and what a check by it finds.
[[nodiscard]] std::string law_label(const LawRecord& law);
[[nodiscard]] std::string law_text(const ReportModel& model, const LawRecord& law);

/// Returns which clean moves are clean by any motion of the rotary joints; empty if that was not examined.
[[nodiscard]] std::string any_turn_text(const ReportModel& model);

/// Returns how many moves are clear of remaining stock, and what counts as removed; empty if that was not examined.
[[nodiscard]] std::string stock_text(const ReportModel& model);
/// Returns the volume of the material that is left, between the two meshes, and how far these are apart; empty if it was
/// not requested.
[[nodiscard]] std::string stock_left_text(const ReportModel& model);

/// Returns "seen nearest, the tool is touching; half of the 400 cutting positions examined (of 2425) are within 0.83
/// mm". Empty if there is no ClosestApproach.
[[nodiscard]] std::string closest_approach_text(const ReportModel& model);

/// Moves with the same reason for not being checked or certified, in the order of their first moves.
struct ReasonGroup {
  MoveState state = MoveState::not_checked;
  std::string reason;
  std::size_t moves = 0;
  std::size_t first_move = 0;
};
[[nodiscard]] std::vector<ReasonGroup> group_reasons(const CheckResult& result);

}  // namespace gouge
