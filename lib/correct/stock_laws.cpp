#include "lib/correct/stock_laws.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "lib/correct/plan_holes.h"
#include "lib/path/run_kind.h"

namespace gouge {

namespace {

/// Returns the finding for a move; null: the move is clear, or was not examined.
const StockFinding* finding_of(const StockResult& result, std::size_t move) {
  const auto found = std::ranges::lower_bound(result.findings, move, {}, &StockFinding::move);
  return found != result.findings.end() && found->move == move ? &*found : nullptr;
}

bool is_clear(const StockResult& result, std::size_t move) {
  return result.is_examined[move] && finding_of(result, move) == nullptr;
}

/// The moves [first, last) that a change rewrites, or whose start it moves.
struct Touched {
  std::size_t first = 0, last = 0;
};

Touched touched_by(const PathChange& change, const Toolpath& path) {
  const std::size_t last = change.hole_shift_mm ? end_of_hole(path, change.move) : change.move + 1;
  const bool moves_start = change.new_end || change.hole_shift_mm;
  return {change.move, std::min(last + (moves_start ? 1 : 0), path.moves.size())};
}

}  // namespace

StockLaws::StockLaws(const Toolpath& path, const CheckResult& result, const CheckSetup& setup,
                     const ProgressCall& progress)
    : path_(path), setup_(setup), before_(result), found_(settle_stock(path, setup, before_, progress)) {
  summarise(path, before_);
  sought_ = before_;
  std::vector<bool> meets_stock(path.moves.size(), false);
  for (const StockFinding& finding : found_.findings) meets_stock[finding.move] = finding.witness.has_value();
  std::vector<std::size_t> first(path.moves.size() + 1);
  std::iota(first.begin(), first.end(), std::size_t{0});
  const std::shared_ptr<const Toolpath> not_owned(std::shared_ptr<const Toolpath>(), &path);
  programmed_ = std::make_shared<const StockAtMoves>(not_owned, std::move(first), std::move(meets_stock), setup);
  material_ = programmed_;
}

void StockLaws::forget() {
  sought_ = before_;
  material_ = programmed_;
}

StockLaws::Examined StockLaws::examine(const Correction& correction, const CheckedPath& after,
                                       const ProgressCall& progress) const {
  Examined examined{*after.result, {}, {}, {}};
  const StockResult found = settle_stock(*after.path, setup_, examined.result, progress);
  summarise(*after.path, examined.result);
  const std::vector<MovesAfter> spans = moves_after(path_.moves.size(), correction.changes);
  std::vector<bool> has_failed(path_.moves.size(), false), is_touched(path_.moves.size(), false);
  for (const PathChange& change : correction.changes) {
    const Touched touched = touched_by(change, path_);
    for (std::size_t i = touched.first; i < touched.last; ++i) is_touched[i] = true;
  }
  for (const Uncorrected& left : correction.uncorrected) has_failed[left.move] = true;
  for (std::size_t i = 0; i < path_.moves.size(); ++i) {
    const bool is_new_rapid = runs_rapid(path_.moves[i]) && is_touched[i];
    for (std::size_t k = spans[i].first; k < spans[i].last; ++k) {
      const MoveVerdict& verdict = examined.result.verdicts[k];
      const bool is_sought = !examined.sought.empty() && examined.sought.back() == i;
      if (verdict.is_in_stock() && !has_failed[i] && !is_sought) {
        examined.sought.push_back(i);
        examined.found.push_back(verdict);
      }
      const bool replaces_feed = runs_rapid(after.path->moves[k]) && !runs_rapid(path_.moves[i]);
      if (is_no_worse(i, found, k, {is_new_rapid, replaces_feed})) continue;
      const std::vector<std::size_t> blamed = blame(i, correction.changes, finding_of(found, k));
      examined.blamed.insert(examined.blamed.end(), blamed.begin(), blamed.end());
    }
  }
  std::ranges::sort(examined.blamed);
  examined.blamed.erase(std::unique(examined.blamed.begin(), examined.blamed.end()), examined.blamed.end());
  return examined;
}

bool StockLaws::is_no_worse(std::size_t move, const StockResult& after, std::size_t piece, RapidPiece rapid) const {
  if (is_clear(after, piece)) return true;
  if (is_clear(found_, move) || rapid.replaces_feed) return false;
  const StockFinding* const was = finding_of(found_, move);
  const StockFinding* const is = finding_of(after, piece);
  const bool meets_stock = is != nullptr && is->witness;
  if (was == nullptr || !was->witness) return !(rapid.is_new && meets_stock);
  if (!meets_stock) return false;
  const double gap = depth_gap_mm(was->witness->depth_mm, setup_.stock->options);
  return is->witness->depth_mm <= was->depth_upper_mm && is->depth_upper_mm <= was->depth_upper_mm + gap;
}

// Returns the changes by which a move meets stock. Those of its own motion come first, then those of earlier cuts that
// removed the material before.
std::vector<std::size_t> StockLaws::blame(std::size_t move, const std::vector<PathChange>& changes,
                                          const StockFinding* finding) const {
  std::vector<std::size_t> blamed;
  for (const PathChange& change : changes) {
    const Touched touched = touched_by(change, path_);
    if (move >= touched.first && move < touched.last) return {move};
    for (std::size_t i = touched.first; i < std::min(touched.last, move); ++i) {
      if (finding == nullptr || !finding->witness || was_cut(i, finding->witness->point)) blamed.push_back(i);
    }
  }
  if (blamed.empty()) blamed.push_back(move);
  return blamed;
}

bool StockLaws::was_cut(std::size_t move, const Vec3& point) const {
  const CutHistory& cuts = programmed_->cuts();
  return cuts.is_known(move) && cuts.is_cutting(move) && !cuts.is_missed_by(move, 1, point);
}

void StockLaws::seek(const Examined& examined, const std::vector<PathChange>& changes, Toolpath after) {
  for (std::size_t k = 0; k < examined.sought.size(); ++k) {
    MoveVerdict& verdict = sought_.verdicts[examined.sought[k]];
    if (verdict.state == MoveState::gouge || verdict.state == MoveState::buried) continue;
    if (verdict.state != MoveState::not_checked) verdict = examined.found[k];
  }
  const std::vector<MovesAfter> spans = moves_after(path_.moves.size(), changes);
  std::vector<std::size_t> first;
  first.reserve(spans.size() + 1);
  for (const MovesAfter& span : spans) first.push_back(span.first);
  first.push_back(after.moves.size());
  std::vector<bool> meets_stock(path_.moves.size());
  for (std::size_t i = 0; i < meets_stock.size(); ++i) meets_stock[i] = material_->meets_stock(i);
  for (const std::size_t i : examined.sought) meets_stock[i] = true;
  material_ = std::make_shared<const StockAtMoves>(std::make_shared<const Toolpath>(std::move(after)), std::move(first),
                                                   std::move(meets_stock), setup_);
}

}  // namespace gouge
