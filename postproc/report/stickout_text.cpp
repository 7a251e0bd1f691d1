#include "postproc/report/stickout_text.h"

#include <algorithm>
#include <iterator>

#include "lib/base/tolerance.h"
#include "postproc/report/report_text.h"

namespace gouge {

namespace {

/// Returns the length that was examined before `stickout_mm`.
double one_step_less(const ReportModel& model, const StickoutFacts& tool, double stickout_mm) {
  const double step = model.stickout_options->step_mm;
  return std::max(tool.found.now_mm, stickout_mm - step);
}

std::string line_of(const ReportModel& model, std::size_t move) {
  return "line " + std::to_string(std::size_t{model.toolpath->moves[move].line});
}

const char* state_words(MoveState state) {
  if (state == MoveState::gouge) return " gouges";
  return state == MoveState::buried ? " is inside a solid" : " is not proved free";
}

std::string need_text(const ReportModel& model, const StickoutFacts& tool, const StickoutNeed& need) {
  const LengthUnit unit = model.toolpath->unit;
  if (need.is_enough()) return "long enough";
  const std::string where =
      std::string(body_name(need.body)) + state_words(need.state) + ", " + line_of(model, need.move);
  if (!need.stickout_mm) {
    const double most = tool.found.now_mm + model.stickout_options->max_longer_mm;
    return "no stick-out up to " + length_text(most, unit) + " is enough: the " + where;
  }
  std::string text = length_text(*need.stickout_mm, unit) + " needed, " +
                     length_text(*need.stickout_mm - tool.found.now_mm, unit) + " longer; at " +
                     length_text(one_step_less(model, tool, *need.stickout_mm), unit) + " the " + where;
  if (tool.shank_end_mm && *need.stickout_mm > *tool.shank_end_mm + Tolerance::kWitness_mm)
    text += "; flutes and shank reach " + length_text(*tool.shank_end_mm, unit) + ", so it takes a longer tool";
  return text;
}

}  // namespace

std::string stickout_need_text(const ReportModel& model, const StickoutFacts& tool, const StickoutNeed& need) {
  return need_text(model, tool, need) +
         (model.result->stock ? "; of parts and fixtures alone, without remaining stock" : "");
}

std::vector<OperationStickout> operations_in_need(const StickoutFacts& tool) {
  std::vector<OperationStickout> found;
  if (tool.found.operations.size() < 2) return found;
  std::copy_if(tool.found.operations.begin(), tool.found.operations.end(), std::back_inserter(found),
               [](const OperationStickout& operation) { return !operation.need.is_enough(); });
  return found;
}

std::string stickout_operation_label(const ReportModel& model, std::size_t operation) {
  const std::string name = operation_name(*model.toolpath, operation);
  if (!name.empty()) return name;
  return operation == kNone ? "before the first operation" : "operation " + std::to_string(operation + 1);
}

std::string stickout_lines(const ReportModel& model) {
  std::string text;
  const LengthUnit unit = model.toolpath->unit;
  for (const StickoutFacts& tool : model.stickouts) {
    const ToolStickout& found = tool.found;
    const std::string label = "stick-out " + tool_label(*model.toolpath, found.tool);
    text += label + ": " + length_text(found.now_mm, unit) + "; " + stickout_need_text(model, tool, found.all) + "\n";
    for (const OperationStickout& operation : operations_in_need(tool)) {
      text += label + ", " + stickout_operation_label(model, operation.operation) + ": " +
              stickout_need_text(model, tool, operation.need) + "\n";
    }
  }
  return text;
}

}  // namespace gouge
