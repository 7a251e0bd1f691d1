#include <algorithm>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/compare/write_comparison.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

std::string words_of(Change change) {
  std::string text = change_name(change);
  std::ranges::replace(text, '-', ' ');
  return text;
}

double deepest_mm(const StoredResult& result, const std::vector<std::size_t>& findings) {
  double deepest = 0;
  for (const std::size_t k : findings) {
    const MoveRecord& worst = result.worst_of(result.findings[k]);
    deepest = std::max(deepest, worst.depth_mm.value_or(0));
  }
  return deepest;
}

bool is_buried(const StoredResult& result, const std::vector<std::size_t>& findings) {
  return std::ranges::any_of(findings, [&](std::size_t k) { return result.findings[k].state == MoveState::buried; });
}

// Returns the depth in the old run, in the unit of the new one.
std::string depth_before(const Comparison& c, const ComparedFinding& one) {
  if (is_buried(*c.before, one.before)) return "buried before";
  return depth_text(deepest_mm(*c.before, one.before), c.after->record.unit) + " before";
}

std::string numbers(const StoredResult& result, const std::vector<std::size_t>& findings) {
  std::string text = findings.size() == 1 ? "finding " : "findings ";
  for (std::size_t k = 0; k < findings.size(); ++k)
    text += (k > 0 ? ", " : "") + std::to_string(*result.findings[findings[k]].number);
  return text;
}

}  // namespace

std::string place_of(const Comparison& c, const ComparedFinding& one) {
  const bool is_new = !one.after.empty();
  const StoredResult& result = is_new ? *c.after : *c.before;
  const EventRecord& finding = result.findings[is_new ? one.after.front() : one.before.front()];
  return result.record.toolpath.file + ":" + std::to_string(finding.line);
}

std::string change_text(const Comparison& c, const ComparedFinding& one) {
  const bool is_new = !one.after.empty();
  const StoredResult& result = is_new ? *c.after : *c.before;
  const std::vector<std::size_t>& own = is_new ? one.after : one.before;
  std::string text = words_of(one.change) + ": " + stored_finding_text(result, result.findings[own.front()]);
  if (is_new && !one.before.empty()) text += "; " + depth_before(c, one);
  if (!one.why.empty()) text += "; " + one.why;
  text += " (" + numbers(result, own);
  if (is_new && !one.before.empty()) text += ", was " + numbers(*c.before, one.before);
  return text + ")";
}

std::string change_counts(const Comparison& comparison) {
  std::string text;
  for (std::size_t k = 0; k < kChanges; ++k) {
    const auto change = static_cast<Change>(k);
    text += (k > 0 ? ", " : "") + std::to_string(comparison.count(change)) + " " + words_of(change);
  }
  return text;
}

std::string comparison_verdict(const Comparison& comparison) {
  switch (comparison.exit_status()) {
    case kExitGouges:
      return "worse";
    case kExitNotChecked:
      return "no worse as far as it was checked";
    default:
      return "no worse";
  }
}

std::vector<std::string> comparison_notes(const Comparison& comparison) {
  std::vector<std::string> all;
  if (comparison.excess) all.push_back(words_of(comparison.excess->change) + ": " + comparison.excess->text);
  all.insert(all.end(), comparison.open_facts.begin(), comparison.open_facts.end());
  all.insert(all.end(), comparison.differences.begin(), comparison.differences.end());
  if (comparison.open_moves > 0)
    all.push_back(count_text(comparison.open_moves, "move") +
                  " of the new run not checked or not certified: nothing is said of what may be new there");
  return all;
}

std::string comparison_text(const Comparison& comparison, bool has_same) {
  std::string text;
  for (std::size_t k = 0; k < kChanges; ++k) {
    if (static_cast<Change>(k) == Change::same && !has_same) continue;
    for (const ComparedFinding& one : comparison.findings) {
      if (one.change != static_cast<Change>(k)) continue;
      text += printable(place_of(comparison, one) + ": " + change_text(comparison, one)) + "\n";
    }
  }
  text += printable(comparison.before->file + " -> " + comparison.after->file) + "\n";
  text += comparison_verdict(comparison) + ": " + change_counts(comparison) + "\n";
  for (const std::string& note : comparison_notes(comparison)) text += "note: " + printable(note) + "\n";
  return text;
}

}  // namespace gouge
