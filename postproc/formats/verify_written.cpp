#include "postproc/formats/verify_written.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/formats/read_toolpath.h"

namespace gouge {
namespace {

constexpr double kWrittenAxis = 1e-4;
constexpr double kSameFeed = 1e-4;  // relative difference

std::string feed_name(const Feed& feed) {
  switch (feed.unit) {
    case FeedUnit::rapid:
      return "rapid";
    case FeedUnit::per_minute:
      return "at " + exact_text(feed.mm) + " mm per minute";
    case FeedUnit::per_revolution:
      return "at " + exact_text(feed.mm) + " mm per revolution";
    case FeedUnit::not_stated:
      break;
    case FeedUnit::not_understood:
      return "at a feed that is not understood";
  }
  return "at a feed that is not stated";
}

// Compares the written file, read again, with the expected motions.
struct Verification {
  const Toolpath& path;
  const Dialect& target;
  const std::vector<ExpectedMotion>& expected;
  const Toolpath& again;

  [[nodiscard]] double factor() const { return mm_per(path.unit) / mm_per(again.unit); }
  [[nodiscard]] bool is_same_tool(const Move& found, const Move& meant) const;
  [[nodiscard]] bool is_same_motion(const Move& found, const ExpectedMotion& meant) const;
  [[nodiscard]] std::size_t count_other_motions() const;
  [[nodiscard]] std::optional<Diagnostic> find_other_tool() const;
  [[nodiscard]] std::optional<Diagnostic> find_other_feed() const;
};

// Returns whether a move has the expected tool. A tool that the result does not name or define is not checked, or is
// reported. Shapes are compared if the dialect states them whole.
bool Verification::is_same_tool(const Move& found, const Move& meant) const {
  constexpr double kSameSize_mm = 2e-3, kSameAngle_deg = 1e-3;
  if (found.tool == kNone) return true;
  const PathTool& tool = again.tools[found.tool];
  // A name without a number and a cutter is no other tool.
  if (meant.tool == kNone) return !tool.number && !tool.cutter;
  const PathTool& wanted = path.tools[meant.tool];
  if (tool.number != wanted.number) return false;
  if (!tool.cutter) return true;
  if (!wanted.cutter) return false;
  const CutterStatement &a = *tool.cutter, &b = *wanted.cutter;
  const bool is_same_size =
      std::abs(a.d_mm * factor() - b.d_mm) <= kSameSize_mm && std::abs(a.r_mm * factor() - b.r_mm) <= kSameSize_mm;
  const bool is_same_shape =
      std::abs(a.alpha_deg - b.alpha_deg) <= kSameAngle_deg && std::abs(a.beta_deg - b.beta_deg) <= kSameAngle_deg;
  const bool is_slanted = std::abs(b.alpha_deg) > 0 || std::abs(b.beta_deg) > 0;
  if (target.cutter_form == CutterForm::without_angles && is_slanted) return true;
  return is_same_size && is_same_shape;
}

std::optional<Diagnostic> Verification::find_other_tool() const {
  if (target.has_positions_alone) return std::nullopt;
  for (std::size_t i = 0; i < std::min(again.moves.size(), expected.size()); ++i) {
    const Move& meant = path.moves[expected[i].move];
    if (is_same_tool(again.moves[i], meant)) continue;
    return make_error("convert-tool",
                      std::string(target.id) +
                          " cannot say which tool this move has, and would give it another one: a tool without a "
                          "number or a cutter after one that has them; expected tools with numbers and cutters",
                      path.file, meant.line);
  }
  return std::nullopt;
}

// Finds a feed motion that becomes rapid, or has another feed. It would break tools, so nothing is written then.
std::optional<Diagnostic> Verification::find_other_feed() const {
  if (target.has_positions_alone) return std::nullopt;
  // Binary NCCS files state feeds without a unit, and positions too.
  const bool has_no_unit = target.is_binary;
  const double scale = has_no_unit ? factor() : 1;
  for (std::size_t i = 0; i < std::min(again.moves.size(), expected.size()); ++i) {
    const Feed found = again.moves[i].feed();
    const Feed& meant = expected[i].feed;
    const bool is_same =
        found.unit == meant.unit && std::abs(found.mm * scale - meant.mm) <= kSameFeed * std::abs(meant.mm);
    if (is_same) continue;
    return make_error("convert-feed",
                      "written in " + std::string(target.id) + ", this move would be " + feed_name(found) + "; it is " +
                          feed_name(meant) + ": expected another dialect for --to",
                      path.file, path.moves[expected[i].move].line);
  }
  return std::nullopt;
}

bool Verification::is_same_motion(const Move& found, const ExpectedMotion& meant) const {
  if ((found.end.tip * factor() - meant.end.tip).norm() > Tolerance::kFilePoint_mm) return false;
  if ((found.end.axis - meant.end.axis).norm() > kWrittenAxis || found.has_start == meant.is_alone) return false;
  if (!target.has_positions_alone && found.is_spindle_stopped() != path.moves[meant.move].is_spindle_stopped())
    return false;
  const bool is_checked = found.not_checked_reason.empty();
  if (is_checked != meant.is_checked) return false;
  if (!is_checked) return true;
  const bool is_round = std::abs(meant.sweep_rad) > 0;
  if (!is_round || found.curve_kind != CurveKind::arc) return !is_round && found.curve_kind == CurveKind::none;
  const PathArc& arc = again.arcs[found.curve];
  return (arc.sweep_rad * arc.axis - meant.sweep_rad * meant.axis).norm() <= 0.1;
}

std::size_t Verification::count_other_motions() const {
  std::size_t count = again.moves.size() == expected.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(again.moves.size(), expected.size()); ++i) {
    if (!is_same_motion(again.moves[i], expected[i])) ++count;
  }
  return count;
}

}  // namespace

std::optional<Diagnostic> verify_written(const Toolpath& path, const Dialect& target,
                                         const std::vector<ExpectedMotion>& expected, std::size_t lost_breaks,
                                         WrittenToolpath& written) {
  ReadOptions options;
  options.dialect = target;
  const ReadOutcome outcome = read_toolpath(path.file, written.bytes, options);
  const auto note = [&](const char* code, const std::string& text) {
    written.notes.push_back(make_warning(code, text, path.file));
  };
  if (!outcome.toolpath) {
    note("convert-verify",
         "the result cannot be read again: " + (outcome.errors.empty() ? "" : outcome.errors.front().message));
    return std::nullopt;
  }
  const Toolpath& again = *outcome.toolpath;
  const Verification verification{path, target, expected, again};
  if (auto error = verification.find_other_tool()) return error;
  if (auto error = verification.find_other_feed()) return error;
  if (again.unit != path.unit) {
    note("convert-unit",
         std::string("the result does not state its unit, ") + unit_name(path.unit) + "; say it with --path-units");
  }
  std::size_t differing = verification.count_other_motions();
  if (differing > lost_breaks) {
    // The path may have been read so that positions under CUTCOM are those of the centre.
    options.is_cutcom_centre = true;
    const ReadOutcome centre = read_toolpath(path.file, written.bytes, options);
    if (centre.toolpath)
      differing = std::min(differing, Verification{path, target, expected, *centre.toolpath}.count_other_motions());
  }
  if (differing <= lost_breaks) return std::nullopt;
  const std::size_t count = differing - lost_breaks;
  note("convert-verify",
       std::to_string(count) + (count == 1 ? " move" : " moves") + " of the result read with another meaning");
  return std::nullopt;
}

}  // namespace gouge
