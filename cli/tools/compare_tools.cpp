#include "cli/tools/compare_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/text.h"
#include "toolmodels/from_path.h"
#include "toolmodels/silhouette.h"

namespace gouge {

std::string name_of(const PathTool& tool) {
  if (tool.number) return "T" + std::to_string(*tool.number);
  return tool.name.empty() ? "the tool" : "tool \"" + tool.name + "\"";
}

namespace {

constexpr double kReach_mm = 5e-3;
constexpr double kMeasured_mm = 1;           // lengths that differ by more are no measured ones of one tool
constexpr double kMeasuredRadius_mm = 0.01;  // measured radii differ by less; also the default tolerance of a check

// Rounds to a millionth: finer than a difference that counts, coarser than the rounding of a change of unit.
std::string rounded_text(double mm, LengthUnit unit) { return exact_text(std::round(mm / mm_per(unit) * 1e6) / 1e6); }

std::string size_text(double diameter_mm, double corner_mm, LengthUnit unit) {
  return "D " + rounded_text(diameter_mm, unit) + " R " + rounded_text(corner_mm, unit) + " " + unit_name(unit);
}

std::string size_text(double diameter_mm, LengthUnit unit) {
  return "D " + rounded_text(diameter_mm, unit) + " " + unit_name(unit);
}

// Returns whether one radius describes the lower end of a cutter, as R2 of a tool table does.
bool has_corner_alone(const Cutter& cutter) {
  if (const auto* stated = std::get_if<AptCutter>(&cutter))
    return !(std::abs(stated->alpha_deg) > 0) && stated->r_mm <= stated->d_mm / 2 + Tolerance::kFilePoint_mm;
  return std::holds_alternative<FlatCutter>(cutter) || std::holds_alternative<BallCutter>(cutter) ||
         std::holds_alternative<BullNoseCutter>(cutter) || std::holds_alternative<TaperedCutter>(cutter) ||
         std::holds_alternative<LollipopCutter>(cutter) || std::holds_alternative<TSlotCutter>(cutter) ||
         std::holds_alternative<DovetailCutter>(cutter) || std::holds_alternative<FaceMillCutter>(cutter);
}

class Comparer {
 public:
  Comparer(const PathTool& tool, const ToolAssembly& known, const Toolpath& path, const ToolSetUp& set_up)
      : tool_(tool), known_(known), path_(path), set_up_(set_up) {}

  ToolDifference run() {
    compare();
    if (tool_.cutter && tool_.cutter->given > 0) compare_above_flutes();
    compare_flutes();
    compare_stickouts();
    compare_gauge_lengths();
    compare_loaded_lengths();
    return std::move(difference_);
  }

 private:
  void compare() {
    compare_names(tool_.name);
    for (const std::string& name : tool_.other_names) compare_names(name);
    const auto [diameter, corner] = nominal_size(known_.cutter);
    compare_with_table({diameter, corner});
    if (!tool_.in_table.has_diameter && tool_.stated_diameter_mm > 0 &&
        std::abs(diameter - tool_.stated_diameter_mm) > Tolerance::kFilePoint_mm) {
      return report_difference(size_text(tool_.stated_diameter_mm, path_.unit), size_text(diameter, path_.unit),
                               diameter < tool_.stated_diameter_mm);
    }
    if (!tool_.cutter || tool_.cutter->given == 0) return;
    const double given_corner = tool_.cutter->given > 1 ? tool_.cutter->r_mm : corner;
    if (std::abs(diameter - tool_.cutter->d_mm) <= Tolerance::kFilePoint_mm &&
        std::abs(corner - given_corner) <= Tolerance::kFilePoint_mm)
      return compare_outlines();
    const bool is_round = tool_.cutter->given > 1;
    const bool is_smaller =
        diameter < tool_.cutter->d_mm - Tolerance::kFilePoint_mm || (is_round && reach_mm(tool_) > kReach_mm);
    report_difference(size_text(tool_.cutter->d_mm, given_corner, path_.unit), size_text(diameter, corner, path_.unit),
                      is_smaller);
  }

  // Compares the tool with the one of the control's tool table, which holds measured radii.
  void compare_with_table(const NominalSize& known) {
    const TableTool& stated = tool_.in_table;
    const double wider = stated.has_diameter ? tool_.stated_diameter_mm / 2 - known.diameter_mm / 2 : 0;
    const double sharper = known.corner_radius_mm - table_corner_mm(known.corner_radius_mm);
    if (2 * std::abs(wider) <= Tolerance::kFilePoint_mm && std::abs(sharper) <= Tolerance::kFilePoint_mm) return;
    // The radius of the flat bottom differs by both together. Between bottom and side, the tools differ by less.
    const double reach = std::max(wider, wider + sharper), excess = std::max(-wider, -wider - sharper);
    const double hidden = set_up_.use == ToolUse::removes_stock ? std::max(reach, excess) : reach;
    const bool has_other_corner = std::abs(sharper) > Tolerance::kFilePoint_mm;
    const std::string message =
        name_of(tool_) + " is " +
        table_text(tool_.stated_diameter_mm, known.corner_radius_mm - sharper, has_other_corner) +
        " by the tool table " + stated.file + " but " +
        table_text(known.diameter_mm, known.corner_radius_mm, has_other_corner) +
        " by the library, which is what is checked";
    if (2 * hidden <= Tolerance::kFilePoint_mm)
      return warn(message + "; correct the library or --tool if another tool is meant");
    if (hidden > kMeasuredRadius_mm + Tolerance::kRounding_mm) return contradict(message);
    add_doubt(message + "; the radii differ by up to " + length(hidden));
  }

  [[nodiscard]] std::string table_text(double diameter_mm, double corner_mm, bool has_corner) const {
    if (!has_corner) return size_text(diameter_mm, path_.unit);
    if (tool_.in_table.has_diameter) return size_text(diameter_mm, corner_mm, path_.unit);
    return "R2 " + rounded_text(corner_mm, path_.unit) + " " + unit_name(path_.unit);
  }

  // Returns the corner radius in the tool table; that of the library where there is none to compare. Many tables leave it
  // at 0, so 0 is a doubt.
  [[nodiscard]] double table_corner_mm(double known_mm) {
    const std::optional<double>& stated = tool_.in_table.corner_mm;
    if (!stated || !has_corner_alone(known_.cutter)) return known_mm;
    if (*stated > 0 || known_mm <= Tolerance::kFilePoint_mm) return *stated;
    add_doubt(name_of(tool_) + " has the corner radius R2 0 in the tool table " + tool_.in_table.file + ", but " +
              length(known_mm) + " by the library, which is what is checked");
    return known_mm;
  }

  // Compares a name, and the part before its first comma: some writers state the name and a comment.
  void compare_names(const std::string& text) {
    compare_name(text);
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos) compare_name(std::string(trim(std::string_view(text).substr(0, comma))));
  }

  // Compares a name that the file states. A name that no tool of the library has is free text.
  void compare_name(const std::string& name) {
    const auto has_name = [&](const ToolAssembly& tool) {
      return !tool.name.empty() && equals_ignoring_case(tool.name, name);
    };
    if (name.empty() || has_name(known_) || std::ranges::none_of(set_up_.library.tools, has_name)) return;
    report_difference("called " + name, known_.name.empty() ? "not" : known_.name, true);
  }

  // Returns the distance by which a tool of the file reaches out of the library's tool.
  [[nodiscard]] double reach_mm(const PathTool& tool) const {
    const Result<ToolFromPath> made = make_tool_from_path(tool, set_up_.holder);
    return made ? reach_beyond_mm(made->tool.cutter, known_.cutter) : 0;
  }

  // Returns the distance by which the library's tool reaches out of a tool of the file.
  [[nodiscard]] double excess_mm(const PathTool& tool) const {
    const Result<ToolFromPath> made = make_tool_from_path(tool, set_up_.holder);
    return made ? reach_beyond_mm(known_.cutter, made->tool.cutter) : 0;
  }

  // Returns the file's tool as a tapered ball whose diameter is that of the ball. The diameter may also be the one at
  // which its flank meets the tip plane. Nothing: it is no such tool.
  [[nodiscard]] std::optional<PathTool> as_tapered_ball() const {
    constexpr double kBall_mm = 1e-4;
    PathTool ball = tool_;
    CutterStatement& c = *ball.cutter;
    if (std::abs(c.alpha_deg) > 0 || std::abs(2 * c.r_mm - c.d_mm) > kBall_mm) return std::nullopt;
    const double flank = c.beta_deg * std::numbers::pi / 180;
    c.d_mm = 2 * c.r_mm * (1 / std::cos(flank) - std::tan(flank));
    c.e_mm = 0;
    c.f_mm = c.r_mm;
    return ball;
  }

  // Compares two tools of the same size, which may have another taper or tip.
  void compare_outlines() {
    constexpr int kWhole = 7;
    const CutterStatement& c = *tool_.cutter;
    const bool is_plain = !(std::abs(c.alpha_deg) > 0) && !(std::abs(c.beta_deg) > 0);
    const bool has_angles = dialect_or_apt(path_.dialect).has_tool_angles;
    if (c.given < kWhole || (is_plain && !has_angles)) return;
    const std::optional<PathTool> ball = as_tapered_ball();
    const double reach = ball ? std::min(reach_mm(tool_), reach_mm(*ball)) : reach_mm(tool_);
    if (reach > kReach_mm)
      return contradict(name_of(tool_) + " reaches up to " + length(reach) +
                        " farther from its axis by the toolpath than by the library, which is what is checked");
    if (set_up_.use != ToolUse::removes_stock) return;
    const double excess = ball ? std::min(excess_mm(tool_), excess_mm(*ball)) : excess_mm(tool_);
    if (excess > kReach_mm)
      contradict(name_of(tool_) + " reaches up to " + length(excess) +
                 " farther from its axis by the library, which is what removes stock, than by the toolpath");
  }

  // Returns the library's tool with the holder of --holder, if it has none itself.
  [[nodiscard]] ToolAssembly with_holder() const {
    ToolAssembly whole = known_;
    if (whole.holder.empty()) whole.holder = set_up_.holder;
    return whole;
  }

  // Returns how far the file's tool reaches out of the library's above the flutes of that. Requires a stated length.
  [[nodiscard]] double reach_above_mm(const PathTool& tool, const ToolAssembly& whole) const {
    const Result<ToolFromPath> made = make_tool_from_path(tool, {});
    if (!made || !made->is_length_stated) return 0;
    const double top = std::min(height_mm(made->tool), height_mm(whole)) - kReach_mm;
    return reach_beyond_mm(made->tool, whole, length_mm(known_.cutter), top);
  }

  // Compares the tool that the file states with shank and holder of the library's, up to a stated length. Shapes that CL
  // data cannot state differ within the flutes alone.
  void compare_above_flutes() {
    const Result<ToolFromPath> made = make_tool_from_path(tool_, {});
    if (!made || !made->is_length_stated) return;
    const ToolAssembly whole = with_holder();
    const double stated = height_mm(made->tool), known = height_mm(whole);
    if (stated > known + kReach_mm)
      contradict(name_of(tool_) + " is " + length(stated) + " long by the toolpath, but ends at " + length(known) +
                 " by the library, which is what is checked");
    const std::optional<PathTool> ball = as_tapered_ball();
    double reach = reach_above_mm(tool_, whole);
    if (ball) reach = std::min(reach, reach_above_mm(*ball, whole));
    if (reach > kReach_mm)
      contradict(
          name_of(tool_) + " reaches up to " + length(reach) +
          " farther from its axis by the toolpath than above its flutes by the library, which is what is checked");
  }

  // Returns the length of the flutes that the file states. They are not longer than the whole tool. 0: it states neither.
  [[nodiscard]] double stated_flutes_mm() const {
    if (tool_.flute_length_mm > 0 || !tool_.cutter) return tool_.flute_length_mm;
    const Result<ToolFromPath> made = make_tool_from_path(tool_, {});
    return made && made->is_length_stated ? height_mm(made->tool) : 0;
  }

  // Compares the lengths of the flutes, where longer ones remove more stock. Outlines do not show them, as a shank may be
  // as wide as its flutes.
  void compare_flutes() {
    if (set_up_.use != ToolUse::removes_stock) return;
    const double stated = stated_flutes_mm(), known = length_mm(known_.cutter);
    if (stated <= 0 || known <= stated + kReach_mm) return;
    contradict(name_of(tool_) + " has flutes of " + length(stated) + " by the toolpath, and of " + length(known) +
               " by the library, which is what removes stock");
  }

  // Compares the lengths to the gauge line. The joints follow the stated one, and shank and holder are the library's.
  void compare_gauge_lengths() {
    const bool is_stated_for_all = !tool_.gauge_length_mm && path_.tools.size() == 1;
    const std::optional<double> stated = is_stated_for_all ? set_up_.length.mm : tool_.gauge_length_mm;
    if (!stated) return;
    const double slack = is_stated_for_all ? set_up_.length.slack_mm : 0;
    if (*stated > 0)
      contradict_holder_above(*stated + slack, name_of(tool_) + " is " + length(*stated + slack) +
                                                   " long to the gauge line by the stated tool length, but ");
    if (!(known_.gauge_length_mm > 0)) return;
    const double gap = std::abs(*stated - known_.gauge_length_mm) - slack;
    if (gap <= kReach_mm) return;
    const std::string message = name_of(tool_) + " is " + length(*stated) +
                                " long to the gauge line by the stated tool length, but " +
                                length(known_.gauge_length_mm) + " by the library";
    if (gap > kMeasured_mm) return contradict(message);
    warn(message + "; its shank and holder are checked as in the library");
  }

  // Contradicts a length to the gauge line above which the holder begins. `begin` states that length. Returns whether it does.
  bool contradict_holder_above(double stated, const std::string& begin) {
    const ToolAssembly whole = with_holder();
    if (whole.holder.empty() || stickout_mm(whole) <= stated + kMeasured_mm) return false;
    contradict(begin + "its holder begins at " + length(stickout_mm(whole)) +
               " by the library, which is what is checked");
    return true;
  }

  // Compares the heights of the holder above the tip. A holder that is lower than the checked one could hide a gouge.
  void compare_stickouts() {
    const ToolAssembly whole = with_holder();
    if (whole.holder.empty()) return;
    const double known = stickout_mm(whole);
    compare_stated_stickout(known);
    const double total = whole_length_mm();
    if (tool_.stickout_mm > 0 || !(total > 0) || known <= total + kMeasured_mm) return;
    // Many toolpaths state the length of the flutes there.
    add_doubt(name_of(tool_) + " is " + length(total) + " long by the toolpath, and its holder begins at " +
              length(known) + " by the library, which is what is checked");
  }

  void compare_stated_stickout(double known) {
    if (!(tool_.stickout_mm > 0) || std::abs(known - tool_.stickout_mm) <= kReach_mm) return;
    const std::string message = name_of(tool_) + " has a stick-out of " + length(tool_.stickout_mm) +
                                " by the toolpath and of " + length(known) + " by the library";
    if (known > tool_.stickout_mm + kMeasured_mm) return contradict(message + ", which is what is checked");
    warn(message + "; its shank and holder are checked as in the library");
  }

  // Returns the length of the whole tool that the file states. Some CAM systems state that of the flutes in its place,
  // which is then the library's. 0: it states none.
  [[nodiscard]] double whole_length_mm() const {
    if (!tool_.cutter || !(tool_.cutter->h_mm > 0)) return 0;
    const Result<ToolFromPath> made = make_tool_from_path(tool_, {});
    if (!made || !made->is_length_stated) return 0;
    const double height = height_mm(made->tool);
    const bool may_be_flutes = !dialect_or_apt(path_.dialect).states_whole_length && !(tool_.flute_length_mm > 0);
    return may_be_flutes && std::abs(height - length_mm(known_.cutter)) <= kMeasured_mm ? 0 : height;
  }

  // Compares the length of LENGTH in a loading.
  void compare_loaded_lengths() {
    const double stated = tool_.loaded_length_mm;
    if (!(stated > 0)) return;
    const std::string begin =
        name_of(tool_) + " is loaded with a length of " + length(stated) + " by the toolpath, but ";
    if (contradict_holder_above(stated, begin)) return;
    if (!loaded_gauge_length_mm(tool_) || !(known_.gauge_length_mm > 0)) return;
    const double gap = std::abs(stated - known_.gauge_length_mm);
    const std::string message =
        begin + "is " + length(known_.gauge_length_mm) + " long to the gauge line by the library";
    if (gap > kMeasured_mm) return contradict(message);
    if (gap > kReach_mm) warn(message + "; its shank and holder are checked as in the library");
  }

  void warn(const std::string& message) {
    difference_.warnings.push_back(make_warning("tool-differs", message, path_.file, tool_.line));
  }

  [[nodiscard]] std::string length(double mm) const {
    return exact_text(std::round(mm / mm_per(path_.unit) * 1e4) / 1e4) + " " + unit_name(path_.unit);
  }

  void report_difference(const std::string& given, const std::string& known, bool is_smaller) {
    const std::string message =
        name_of(tool_) + " is " + given + " by the toolpath but " + known + " by the library, which is what is checked";
    if (is_smaller || set_up_.use == ToolUse::removes_stock) return contradict(message);
    warn(message + "; correct the library or --tool if another tool is meant");
  }

  void add_doubt(const std::string& what) { difference_.doubt += (difference_.doubt.empty() ? "" : "; ") + what; }

  void contradict(const std::string& what) {
    difference_.contradiction += (difference_.contradiction.empty() ? "" : "; ") + what;
  }

  const PathTool& tool_;
  const ToolAssembly& known_;
  const Toolpath& path_;
  const ToolSetUp& set_up_;
  ToolDifference difference_;
};

}  // namespace

std::optional<double> loaded_gauge_length_mm(const PathTool& tool) {
  const bool is_of_cutter = tool.cutter && std::abs(tool.cutter->h_mm - tool.loaded_length_mm) <= kMeasured_mm;
  if (!(tool.loaded_length_mm > 0) || is_of_cutter) return std::nullopt;
  return tool.loaded_length_mm;
}

ToolDifference compare_tools(const PathTool& tool, const ToolAssembly& known, const Toolpath& path,
                             const ToolSetUp& set_up) {
  return Comparer(tool, known, path, set_up).run();
}

}  // namespace gouge
