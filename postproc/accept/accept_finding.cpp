#include "postproc/accept/accept_finding.h"

#include <algorithm>
#include <map>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

// As far as the depths of a text read back in another unit may be from what they were.

// The one reason of a gouge that leaves nothing open.
bool is_of_clearance(const std::string& reason) { return reason.starts_with("the clearance of the "); }

class Accepter {
 public:
  Accepter(const StoredResult& result, const StoredFinding& finding) : result_(result), finding_(finding) {}

  /// What keeps it from being accepted; none: nothing.
  [[nodiscard]] std::optional<std::string> why_impossible() const {
    if (finding_.state == MoveState::buried)
      return "the tool is buried: there is no depth that a later one could be compared with";
    if (!finding_.tool_index || result_.tools[*finding_.tool_index].identity.empty())
      return "its tool is not defined, so that a later one could not be compared with it";
    for (const StoredMove* move : result_.moves_of(finding_)) {
      const double gap_mm = result_.options.resolution_mm + Tolerance::kRounding_mm;
      if (!move->depth_upper_mm || *move->depth_upper_mm > *move->depth_mm + gap_mm)
        return "the depth of move " + std::to_string(move->move) + " (line " + std::to_string(move->line) +
               ") is not certified to the resolution";
      if (!move->reason.empty() && !is_of_clearance(move->reason))
        return "of move " + std::to_string(move->move) + " (line " + std::to_string(move->line) +
               ") more is open: " + move->reason;
    }
    return std::nullopt;
  }

  [[nodiscard]] Acceptance make(const AcceptanceNote& note) const {
    Acceptance made;
    made.reason = note.reason;
    made.by = note.by;
    made.date = note.date;
    made.finding = stored_finding_text(result_, finding_);
    made.toolpath = result_.toolpath;
    made.line = finding_.line;
    made.statement = result_.worst_of(finding_).statement;
    made.tool = finding_.tool;
    made.body = finding_.body;
    made.against = finding_.against;
    made.setup = setup_of(result_, result_.tools[*finding_.tool_index].identity);
    const std::map<std::string, std::size_t> passes = passes_of_motions();
    for (const StoredMove* move : result_.moves_of(finding_)) {
      AcceptedMove accepted{move->motion, *move->depth_mm, *move->depth_upper_mm, {}, passes.at(move->motion)};
      if (move->overcut_mm) accepted.overcut_upper_mm = move->overcut_upper_mm;
      made.moves.push_back(std::move(accepted));
    }
    return made;
  }

 private:
  // Over all findings that are alike.
  [[nodiscard]] std::map<std::string, std::size_t> passes_of_motions() const {
    std::map<std::string, std::size_t> passes;
    for (const StoredFinding& other : result_.findings) {
      const bool is_alike = other.state == finding_.state && other.tool_index && other.body == finding_.body &&
                            other.against == finding_.against &&
                            result_.tools[*other.tool_index].identity == result_.tools[*finding_.tool_index].identity;
      if (!is_alike) continue;
      for (const StoredMove* move : result_.moves_of(other)) ++passes[move->motion];
    }
    return passes;
  }

  const StoredResult& result_;
  const StoredFinding& finding_;
};

// Whether all of its motions are accepted as often as they gouge.
bool is_accepted_already(const Acceptance& made, const std::vector<Acceptance>& accepted) {
  std::map<std::string, std::size_t> times;
  for (const Acceptance& other : accepted) {
    if (other.body != made.body || other.against != made.against || other.setup.tool != made.setup.tool ||
        find_change(other.setup, made.setup, LengthUnit::mm))
      continue;
    for (const AcceptedMove& move : other.moves) ++times[move.motion];
  }
  return std::ranges::any_of(made.moves, [&](const AcceptedMove& move) {
    const auto found = times.find(move.motion);
    return found != times.end() && found->second >= move.passes;
  });
}

}  // namespace

Result<Acceptance> accept_finding(const StoredResult& result, std::size_t number, const AcceptanceNote& note,
                                  const std::vector<Acceptance>& accepted) {
  const auto finding = std::ranges::find(result.findings, number, &StoredFinding::number);
  if (finding == result.findings.end())
    return make_error("usage", "--finding '" + std::to_string(number) + "': " + result.file +
                                   " has no gouge of that number; " + "'gougecheck accept " + result.file +
                                   "' lists those that it has");
  const Accepter accepter(result, *finding);
  if (const auto why = accepter.why_impossible())
    return make_error("accept-impossible",
                      "finding " + std::to_string(number) + " cannot be accepted: " + *why + "; it stays a gouge",
                      result.file);
  Acceptance made = accepter.make(note);
  if (is_accepted_already(made, accepted))
    return make_error(
        "accept-twice",
        "finding " + std::to_string(number) + " has motions that are accepted already; expected one that is not",
        result.file);
  return made;
}

}  // namespace gouge
