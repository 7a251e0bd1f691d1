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

// Data that all writers of a report share. Lengths are in mm here and converted to the toolpath's
// unit when they are written. The model points at the toolpath and the verdicts; they must outlive it.

namespace gouge {

inline constexpr const char* kProgramVersion = "0.1.0";

/// Describes a file that was read, so that a reader of the report can see which one it was.
[[nodiscard]] InputFile describe_input(std::string role, std::string name, std::string_view bytes);

struct MeshFacts {
  std::string name;  ///< as the user named it
  std::size_t triangles = 0, vertices = 0;
  std::size_t dropped = 0;  ///< degenerate triangles of the file that have no area
  bool is_closed = false;
  std::string meaning;      ///< what that means for the result, a sentence; may be empty
  Assumption solid = {};    ///< whether it bounds a solid
  double clearance_mm = 0;  ///< distance that the tool and the heads keep from it
};

/// One entry per Toolpath::tools, in its order.
struct ToolFacts {
  std::string name;
  std::string defined_in;         ///< "tools.json", "path.apt:12"; empty: nowhere, so it could not be checked
  std::string description;        ///< for people: "ball D10, holder D32"; may be empty
  bool has_holder = true;         ///< false: none is given, so none was checked
  std::string identity = {};      ///< the same for tools of the same dimensions, 32 digits; empty: not defined
  std::vector<Body> bodies = {};  ///< of those that are checked
};

/// Smoothness of the tool axis before and after a correction. Moves are those of the path before in `before`, and
/// of the corrected one in `after` and `tilts`.
struct AxisFacts {
  AxisQuality before, after;
  AxisTilts tilts;
  std::optional<double> max_rotary_deg_per_min;  ///< none: not given

  /// Returns false where the axis stands and no limit was given: then people need not read of it.
  [[nodiscard]] bool is_of_interest() const {
    return before.has_turns() || after.has_turns() || tilts.positions > 0 || max_rotary_deg_per_min;
  }
};

struct CorrectionFacts {
  std::string output_file;                  ///< empty: none was written
  std::string_view output_bytes;            ///< the corrected toolpath, as it goes there
  std::string strategy;                     ///< as requested
  double max_shift_mm = 0;                  ///< 0: no limit
  std::optional<double> max_side_shift_mm;  ///< none: by the depth
  double rapid_clearance_mm = 0;
  std::size_t curves = 0;          ///< arcs and splines that became straight moves ...
  std::size_t straight_moves = 0;  ///< ... and how many, those of `changes` among them
  std::vector<CorrectedRecord> changes;
  std::vector<Uncorrected> uncorrected;
  std::vector<Uncut> uncut;
  std::vector<StockStretch> stock;             ///< more than is allowed of each stretch
  std::vector<LowRapid> low_rapids;            ///< in path order
  std::vector<WrittenStatement> written;       ///< every other statement is the same to the byte
  std::optional<AxisFacts> axes;               ///< none: not measured
  const Toolpath* toolpath_before = nullptr;   ///< the path as read
  const CheckResult* result_before = nullptr;  ///< its verdicts
};

/// Result of --find-stickout for one tool.
struct StickoutFacts {
  ToolStickout found;
  std::optional<double> shank_end_mm;  ///< how far its flutes and shank reach; none: not stated
};

struct OptionText {
  std::string name, value;
};

struct ReportModel {
  SignOff sign_off;
  std::vector<InputFile> inputs;
  CheckOptions options;
  std::string placement;                   ///< the same for equal units and places of STL files, 32 digits
  std::vector<OptionText> more_options;    ///< in force beside `options`: "place", "stl-units", ...
  const Toolpath* toolpath = nullptr;      ///< what was checked; for a correction the corrected path
  const CheckResult* result = nullptr;     ///< its verdicts
  std::vector<MeshFacts> parts, fixtures;  ///< as in Scene
  std::vector<MeshFacts> heads;            ///< the files of --head, in their order
  std::vector<ToolFacts> tools;            ///< as in Toolpath::tools
  Diagnostics notes;                       ///< warnings and notes of all inputs
  bool has_correction = false;
  CorrectionFacts correction;
  std::string_view certificate_bytes;  ///< of --certificate
  double seconds = 0;                  ///< spent from the first file read to this report; only JUnit has it
  std::optional<StickoutOptions> stickout_options;  ///< none: not requested
  std::vector<StickoutFacts> stickouts;
  std::optional<CureOptions> cure_options;  ///< none: not requested
  std::vector<FindingCures> cures;          ///< by event, in their order
  BaselineFacts baseline;
};

/// In the order of verdict_words().
enum class OverallVerdict { clean, gouges, not_fully_checked, accepted_gouges };

/// Returns the verdict. Gouges and buried tools come first, then anything not checked that was not left out on request,
/// and assumptions that are open.
[[nodiscard]] OverallVerdict overall_verdict(const CheckResult& result);
/// Returns the same with accepted gouges, which come last of all that is not clean, and with warnings that count as
/// errors.
[[nodiscard]] OverallVerdict overall_verdict(const ReportModel& model);
/// Returns clean, gouges, not-fully-checked or accepted-gouges.
[[nodiscard]] const char* verdict_name(OverallVerdict verdict);
/// Returns the exit status of `check` and `correct`.
[[nodiscard]] ExitCode exit_status(OverallVerdict verdict);

/// Returns the guarantee in the toolpath's unit, with the moves it does not cover when something was not checked. It
/// begins "no gouge deeper than tolerance + resolution = 0.011 mm is missed". It ends "and where none is reported the
/// tool reaches at most 3 times that into a solid".
[[nodiscard]] std::string guarantee_text(const ReportModel& model);

/// Returns one sentence for each assumption that keeps the verdict from being clean: which, why, and what to do.
[[nodiscard]] std::vector<std::string> open_facts(const ReportModel& model);

/// Returns reservations about the verdict, a sentence each. (1) The option that settles why moves are not checked
/// (remedies.h). (2) That the path may not belong to the part. (3) That tools have no holder.
[[nodiscard]] std::vector<std::string> reservations(const ReportModel& model);

/// Returns a distance of ClosestApproach, which is known to a hundredth of a millimetre: "touching", "within 0.83 mm",
/// "not within 20 mm".
[[nodiscard]] std::string closest_approach_words(const std::optional<double>& distance_mm, LengthUnit unit);

/// Returns "seen nearest, the tool is touching; half of the 400 cutting positions examined (of 2425) are within 0.83
/// mm". Empty without closeness.
[[nodiscard]] std::string closest_approach_text(const ReportModel& model);

/// Moves that share a reason for not being checked or certified, in order of their first move.
struct ReasonGroup {
  MoveState state = MoveState::not_checked;
  std::string reason;
  std::size_t moves = 0;
  std::size_t first_move = 0;
};
[[nodiscard]] std::vector<ReasonGroup> group_reasons(const CheckResult& result);

}  // namespace gouge
