#include "postproc/accept/checked_findings.h"

#include "lib/check/reason.h"
#include "lib/path/motion_key.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

CheckedMove checked_move(const ReportModel& model, const Event& event, std::size_t move) {
  const MoveVerdict& verdict = model.result->verdicts[move];
  CheckedMove made;
  made.line = model.toolpath->moves[move].line;
  if (verdict.state != MoveState::gouge || !verdict.witness || verdict.witness->body != event.body ||
      verdict.witness->against != event.against)
    return made;
  made.motion = motion_key(*model.toolpath, move, model.options.law.is_by_axes(model.toolpath->moves[move]));
  made.depth_mm = verdict.depth_mm;
  made.depth_upper_mm = verdict.depth_upper_mm;
  if (verdict.overcut) made.overcut_mm = verdict.overcut->lower_mm;
  if (!verdict.reason.names_limit()) made.open = reason_text(verdict.reason);
  return made;
}

CheckedMove checked_move(const EventRecord& event, const MoveRecord& move) {
  CheckedMove made;
  made.line = move.line;
  if (move.state != MoveState::gouge || !move.witness || move.witness->body != event.body ||
      move.witness->against != event.against || !move.depth_mm || !move.depth_upper_mm)
    return made;
  made.motion = move.motion;
  made.depth_mm = *move.depth_mm;
  made.depth_upper_mm = *move.depth_upper_mm;
  made.overcut_mm = move.overcut_mm;
  if (!is_text_of_limit(move.reason)) made.open = move.reason;
  return made;
}

CheckedFinding checked_finding(const ReportModel& model, const Event& event) {
  CheckedFinding made;
  made.is_gouge = event.state == MoveState::gouge && event.tool < model.tools.size();
  made.tool_key = tool_key(*model.toolpath, event.tool);
  if (event.tool < model.tools.size()) made.tool = model.tools[event.tool].identity;
  made.body = body_name(event.body);
  made.against = against_name(event.against);
  made.line = model.toolpath->moves[event.worst_move].line;
  made.depth_mm = model.result->verdicts[event.worst_move].depth_mm;
  made.first_line = model.toolpath->moves[event.first_move].line;
  made.last_line = model.toolpath->moves[event.last_move].line;
  for (std::size_t move = event.first_move; made.is_gouge && move <= event.last_move; ++move)
    made.moves.push_back(checked_move(model, event, move));
  return made;
}

CheckedFinding checked_finding(const StoredResult& result, const EventRecord& event) {
  CheckedFinding made;
  made.is_gouge = event.state == MoveState::gouge && event.tool_index;
  made.tool_key = event.tool;
  if (event.tool_index) made.tool = result.record.tools[*event.tool_index].identity.value_or("");
  made.body = body_name(event.body);
  made.against = against_name(event.against);
  made.line = event.line;
  made.depth_mm = result.worst_of(event).depth_mm.value_or(0);
  made.first_line = result.find_move(event.first_move)->line;
  made.last_line = result.find_move(event.last_move)->line;
  if (!made.is_gouge) return made;
  for (const MoveRecord* move : result.moves_of(event)) made.moves.push_back(checked_move(event, *move));
  return made;
}

}  // namespace

CheckedFindings checked_findings(const ReportModel& model) {
  CheckedFindings made{model.toolpath->file, model.toolpath->unit, setup_of(model, {}), {}, {}};
  for (std::size_t i = 0; i < model.toolpath->tools.size() && i < model.tools.size(); ++i)
    made.tools.push_back({tool_key(*model.toolpath, i), model.tools[i].identity});
  for (const Event& event : model.result->events) made.findings.push_back(checked_finding(model, event));
  return made;
}

CheckedFindings checked_findings(const StoredResult& result) {
  CheckedFindings made{result.record.toolpath.file, result.record.unit, setup_of(result, {}), {}, {}};
  for (const ToolRecord& tool : result.record.tools) made.tools.push_back({tool.key, tool.identity.value_or("")});
  for (const EventRecord& event : result.findings) made.findings.push_back(checked_finding(result, event));
  return made;
}

}  // namespace gouge
