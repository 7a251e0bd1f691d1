#include "lib/verify/claimed_findings.h"

#include <algorithm>
#include <limits>

namespace gouge {
namespace {

bool forms_findings(ClaimedState state) { return state != ClaimedState::clean && state != ClaimedState::not_checked; }

/// Returns how bad a move is within its finding. Near misses are worse the nearer they are.
double badness_mm(const ListedMove& move) { return move.clearance_mm ? -*move.clearance_mm : move.depth_mm; }

class FindingGatherer {
 public:
  FindingGatherer(const Toolpath& path, std::span<const ListedMove> listed, std::span<const StatedChoice> stated,
                  bool is_rounded)
      : path_(path), listed_(listed), stated_(stated), is_rounded_(is_rounded) {}

  std::vector<GatheredFinding> run() {
    for (std::size_t k = 0; k < listed_.size(); ++k) {
      if (!forms_findings(listed_[k].state)) continue;
      if (k > 0 && !findings_.empty() && continues(listed_[k - 1], listed_[k]))
        extend(listed_[k]);
      else
        begin(k);
    }
    for (std::size_t f = 0; f < findings_.size(); ++f) take_stated_worst(f);
    number();
    return std::move(findings_);
  }

 private:
  /// Returns whether a move belongs to the last finding, which ends with the move `before`.
  [[nodiscard]] bool continues(const ListedMove& before, const ListedMove& next) const {
    const GatheredFinding& last = findings_.back();
    if (before.move + 1 != next.move || last.last_move != before.move || last.state != next.state) return false;
    const Move &a = path_.moves[before.move], &b = path_.moves[next.move];
    if (a.tool != b.tool || a.operation != b.operation) return false;
    if (next.state == ClaimedState::buried) return before.reason == next.reason;
    return !next.has_witness || (last.body == next.body && last.obstacle == next.obstacle);
  }

  void begin(std::size_t k) {
    const ListedMove& move = listed_[k];
    GatheredFinding finding;
    finding.state = move.state;
    finding.first_move = finding.last_move = finding.worst_move = move.move;
    finding.moves = 1;
    finding.tool = path_.moves[move.move].tool;
    finding.body = move.body;
    if (move.has_witness) finding.obstacle = move.obstacle;
    findings_.push_back(finding);
    firsts_.push_back(k);
    worst_.push_back(k);
  }

  void extend(const ListedMove& move) {
    GatheredFinding& finding = findings_.back();
    finding.last_move = move.move;
    ++finding.moves;
    if (!is_worse(move, listed_[worst_.back()])) return;
    worst_.back() = static_cast<std::size_t>(&move - listed_.data());
    finding.worst_move = move.move;
  }

  static bool is_worse(const ListedMove& a, const ListedMove& b) {
    const bool are_both_near = a.clearance_mm && b.clearance_mm;
    return are_both_near ? badness_mm(a) > badness_mm(b) : a.depth_mm > b.depth_mm;
  }

  /// Takes the stated worst move where it is as bad as the one that was found.
  void take_stated_worst(std::size_t f) {
    if (f >= stated_.size()) return;
    GatheredFinding& finding = findings_[f];
    const std::size_t stated = stated_[f].worst_move;
    if (stated < finding.first_move || stated > finding.last_move) return;
    const std::size_t k = firsts_[f] + (stated - finding.first_move);  // moves of a finding follow each other
    const bool is_choice = finding.state == ClaimedState::buried ? listed_[k].has_witness : is_rounded_;
    if (!is_choice || is_worse(listed_[worst_[f]], listed_[k])) return;
    finding.worst_move = stated;
    worst_[f] = k;
  }

  [[nodiscard]] double rank_mm(std::size_t f) const {
    if (findings_[f].state == ClaimedState::buried) return std::numeric_limits<double>::infinity();
    const ListedMove& worst = listed_[worst_[f]];
    return findings_[f].state == ClaimedState::near ? -worst.clearance_mm.value_or(0) : worst.depth_mm;
  }

  [[nodiscard]] std::size_t stated_number(std::size_t f) const {
    return is_rounded_ && f < stated_.size() ? stated_[f].number : 0;
  }

  void number() {
    std::vector<std::size_t> order;
    for (std::size_t f = 0; f < findings_.size(); ++f)
      if (findings_[f].state != ClaimedState::not_certified) order.push_back(f);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      if (rank_mm(a) > rank_mm(b) || rank_mm(b) > rank_mm(a)) return rank_mm(a) > rank_mm(b);
      return stated_number(a) < stated_number(b);
    });
    for (std::size_t k = 0; k < order.size(); ++k) findings_[order[k]].number = k + 1;
  }

  const Toolpath& path_;
  std::span<const ListedMove> listed_;
  std::span<const StatedChoice> stated_;
  bool is_rounded_;
  std::vector<GatheredFinding> findings_;
  std::vector<std::size_t> firsts_, worst_;  // for each finding: indices of its first and its worst move in `listed_`
};

}  // namespace

std::vector<GatheredFinding> gather_findings(const Toolpath& path, std::span<const ListedMove> listed,
                                             std::span<const StatedChoice> stated, bool is_rounded) {
  return FindingGatherer(path, listed, stated, is_rounded).run();
}

}  // namespace gouge
