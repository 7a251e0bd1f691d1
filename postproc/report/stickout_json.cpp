#include "postproc/report/stickout_json.h"

#include <cmath>

#include "postproc/report/report_text.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

Json need_json(const ReportModel& model, const StickoutNeed& need) {
  const bool has_move = need.move != kNone;
  return {{"needed", need.stickout_mm ? length_json(*need.stickout_mm, model.toolpath->unit) : Json(nullptr)},
          {"move", has_move ? Json(need.move) : Json(nullptr)},
          {"line", has_move ? Json(std::size_t{model.toolpath->moves[need.move].line}) : Json(nullptr)},
          {"body", has_move ? Json(body_name(need.body)) : Json(nullptr)},
          {"state", has_move ? Json(state_name(need.state)) : Json(nullptr)}};
}

}  // namespace

Json length_json(double length_mm, LengthUnit unit) {
  const double value = length_mm / mm_per(unit);
  return std::isfinite(value) ? Json(value + 0.0) : Json(nullptr);
}

Json stickout_json(const ReportModel& model) {
  if (!model.stickout_options) return nullptr;
  const LengthUnit unit = model.toolpath->unit;
  Json tools = Json::array();
  for (const StickoutFacts& tool : model.stickouts) {
    Json operations = Json::array();
    for (const OperationStickout& of : tool.found.operations) {
      Json operation = {{"operation", valid_utf8(operation_name(*model.toolpath, of.operation))}};
      operation.update(need_json(model, of.need));
      operations.push_back(std::move(operation));
    }
    Json one = {{"tool", valid_utf8(tool_key(*model.toolpath, tool.found.tool))},
                {"now", length_json(tool.found.now_mm, unit)}};
    one.update(need_json(model, tool.found.all));
    one["operations"] = std::move(operations);
    tools.push_back(std::move(one));
  }
  return {{"step", length_json(model.stickout_options->step_mm, unit)},
          {"most_longer", length_json(model.stickout_options->most_longer_mm, unit)},
          {"tools", std::move(tools)}};
}

}  // namespace gouge
