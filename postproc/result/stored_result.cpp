#include "postproc/result/stored_result.h"

#include <algorithm>

#include "postproc/report/report_text.h"

namespace gouge {

const MoveRecord* StoredResult::find_move(std::size_t move) const {
  const auto found = std::ranges::lower_bound(record.moves, move, {}, &MoveRecord::move);
  return found != record.moves.end() && found->move == move ? &*found : nullptr;
}

std::vector<const MoveRecord*> StoredResult::moves_of(const EventRecord& finding) const {
  std::vector<const MoveRecord*> all;
  auto at = std::ranges::lower_bound(record.moves, finding.first_move, {}, &MoveRecord::move);
  for (; at != record.moves.end() && at->move <= finding.last_move; ++at) {
    if (at->state == finding.state) all.push_back(&*at);
  }
  return all;
}

const RunRecord& StoredResult::run_of(std::size_t move) const {
  return *(std::ranges::upper_bound(record.runs, move, {}, &RunRecord::first_move) - 1);
}

std::size_t StoredResult::moves_like(const RunRecord& run, std::size_t first, std::size_t end) const {
  const std::vector<RunRecord>& runs = record.runs;
  std::size_t count = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].operation != run.operation || runs[k].tool != run.tool) continue;
    const std::size_t begin = std::max(runs[k].first_move, first);
    const std::size_t last = std::min(k + 1 < runs.size() ? runs[k + 1].first_move : record.listed_motions(), end);
    count += last > begin ? last - begin : 0;
  }
  return count;
}

std::string StoredResult::contents_of(std::string_view role) const {
  std::string all;
  for (const InputFile& input : record.inputs) {
    if (input.role == role) all += input.checksum + "\n";
  }
  return all;
}

std::string stored_tool_label(const std::string& key) {
  const bool is_number = !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
  if (is_number) return "T" + key;
  return key.empty() ? "the unnamed tool" : "\"" + key + "\"";
}

std::string stored_finding_text(const StoredResult& result, const EventRecord& finding) {
  const MoveRecord& worst = result.worst_of(finding);
  const LengthUnit unit = result.record.unit;
  std::string text =
      finding.state == MoveState::buried ? "buried, " : depth_text(worst.depth_mm.value_or(0), unit) + " ";
  if (finding.against == Against::stock) text += "into stock, ";
  text += std::string(body_name(finding.body)) + " " + stored_tool_label(finding.tool);
  if (worst.witness) text += " at " + point_text(worst.witness->point_mm, unit);
  return text + ", move " + std::to_string(worst.move);
}

}  // namespace gouge
