#include "cli/tools/head_facts.h"

#include <algorithm>
#include <cmath>

#include "cli/tools/compare_tools.h"
#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "postproc/cldata/language/dialect.h"

namespace gouge {
namespace {

bool is_always_upright(const Toolpath& path) {
  return std::ranges::all_of(path.moves, [](const Move& move) { return move.end.axis == Vec3(Vec3::UnitZ()); });
}

Assumption turn_fact(const Toolpath& path, const std::string& machine) {
  Assumption fact{.subject = Subject::head, .object = "turn", .code = "head-turn"};
  fact.file = path.file;
  if (path.joints != nullptr && path.dialect == gcode_dialect().id) {
    fact.basis = Basis::stated;
    fact.value = "by the joints of the program";
  } else if (!machine.empty()) {
    fact.value = "by joint angles of machine " + machine;
    fact.evidence = "the toolpath states the tool axis alone, and the control may choose other joint angles";
    fact.remedy = "check the program of the control, or state with --assume head=turn that it chooses these angles";
  } else if (path.has_turned_frame) {
    fact.basis = Basis::contradicted;
    fact.value = "by the shortest rotation from Z to the tool axis";
    fact.evidence =
        "the toolpath states a frame whose X, Y and Z are turned from those of the part, and a head turns from the axes "
        "of the part";
    fact.remedy = "give --machine and --zero, or state with --assume head=turn that the head turns so";
  } else if (is_always_upright(path)) {
    fact.basis = Basis::derived;
    fact.value = "as in its file";
    fact.evidence = "the tool axis is Z in all moves";
  } else {
    fact.value = "by the shortest rotation from Z to the tool axis";
    fact.evidence = "the toolpath states the tool axis alone, and not how a head turns about it";
    fact.remedy = "give --machine, or state with --assume head=turn that the head turns so";
  }
  return fact;
}

/// Length of a tool by which heads lie above its tip.
struct HeadLength {
  std::size_t tool = 0;
  double mm = 0;  ///< 0: not known
  bool is_gauge_length = false;
  const char* source = "";  ///< of a length that the toolpath changes, as in "T1 is 110 mm long by LENGTH"
};

constexpr double kEqual_mm = 5e-3;

HeadLength known_length(const PathTool& tool, std::size_t index, const std::optional<ToolAssembly>& assembly) {
  const std::optional<double>& stated = tool.gauge_length_mm;
  const bool is_in_library = assembly && assembly->gauge_length_mm > 0;
  if (stated || is_in_library) return {index, stated ? *stated : assembly->gauge_length_mm, true};
  return {index, assembly && !assembly->holder.empty() ? height_mm(*assembly) : 0, false};
}

// Returns how much farther from the tip the holder is by the stick-out that the toolpath states than in the library.
double stickout_excess_mm(const PathTool& tool, const ToolAssembly& assembly) {
  if (!(tool.stickout_mm > 0) || assembly.holder.empty()) return 0;
  const double excess = tool.stickout_mm - stickout_mm(assembly);
  return std::abs(excess) > kEqual_mm ? excess : 0;
}

// Returns the length of a tool. LENGTH in its loading is that of the tool as it is loaded. A stick-out moves the holder,
// and the head with it.
HeadLength length_of(const Toolpath& path, std::size_t index, const std::optional<ToolAssembly>& assembly) {
  const PathTool& tool = path.tools[index];
  HeadLength length = known_length(tool, index, assembly);
  if (tool.gauge_length_mm || !(length.mm > 0)) return length;
  if (const std::optional<double> loaded = loaded_gauge_length_mm(tool)) {
    const bool is_as_known = std::abs(*loaded - length.mm) <= kEqual_mm;
    if (!is_as_known) length = {index, *loaded, false, " by LENGTH in the toolpath"};
  } else if (const double excess = stickout_excess_mm(tool, *assembly); std::abs(excess) > 0) {
    length = {index, length.mm + excess, length.is_gauge_length, " by its stick-out in the toolpath"};
  }
  return length;
}

std::vector<HeadLength> lengths_of_used(const Toolpath& path,
                                        const std::vector<std::optional<ToolAssembly>>& assemblies) {
  const std::vector<bool> is_used = used_tools(path);
  std::vector<HeadLength> lengths;
  for (std::size_t i = 0; i < path.tools.size(); ++i)
    if (is_used[i] && assemblies[i]) lengths.push_back(length_of(path, i, assemblies[i]));
  return lengths;
}

std::string length_text(const Toolpath& path, const HeadLength& length) {
  return name_of(path.tools[length.tool]) + " is " + display_text(length.mm / mm_per(path.unit), 4) + " " +
         unit_name(path.unit) + " long" + length.source;
}

Assumption place_fact(const Toolpath& path, const std::vector<HeadLength>& lengths) {
  Assumption fact{.subject = Subject::head, .object = "place", .code = "head-place"};
  fact.file = path.file;
  fact.value = "equally far from the tip of each tool";
  fact.remedy =
      "check the tools one by one, each with its head, or state with --assume head=place that the head is right "
      "for all";
  const auto unknown = std::ranges::find_if(lengths, [](const HeadLength& one) { return !(one.mm > 0); });
  const auto other = std::ranges::find_if(
      lengths, [&](const HeadLength& one) { return std::abs(one.mm - lengths.front().mm) > kEqual_mm; });
  const auto again = std::ranges::find_if(lengths, [&](const HeadLength& one) {
    return !path.tools[one.tool].gauge_length_mm && path.tools[one.tool].has_other_length;
  });
  if (again != lengths.end()) {
    fact.basis = Basis::contradicted;
    fact.evidence = "a head is equally far from the tip in all moves, but the toolpath loads " +
                    name_of(path.tools[again->tool]) + " with several lengths";
  } else if (lengths.size() < 2) {
    fact.basis = Basis::stated;
    fact.value = "as in its file";
    fact.remedy.clear();
  } else if (unknown != lengths.end()) {
    fact.basis = Basis::unknown;
    fact.evidence = "a head is equally far from the tip of each tool, and the length of " +
                    name_of(path.tools[unknown->tool]) + " to the gauge line is not known";
    fact.remedy = "state gauge_length in the library; or " + fact.remedy;
  } else if (other != lengths.end()) {
    fact.basis = Basis::contradicted;
    fact.evidence = "a head is equally far from the tip of each tool, but " + length_text(path, lengths.front()) +
                    " and " + length_text(path, *other);
  } else {
    fact.basis = std::ranges::all_of(lengths, &HeadLength::is_gauge_length) ? Basis::derived : Basis::by_default;
    fact.evidence = "all tools are " + display_text(lengths.front().mm / mm_per(path.unit), 4) + " " +
                    unit_name(path.unit) + " long";
  }
  return fact;
}

}  // namespace

Assumptions head_facts(const Toolpath& path, const std::vector<std::optional<ToolAssembly>>& assemblies,
                       const std::string& machine) {
  return {turn_fact(path, machine), place_fact(path, lengths_of_used(path, assemblies))};
}

}  // namespace gouge
