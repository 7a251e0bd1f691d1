#include "lib/correct/correct_path.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "lib/correct/laws.h"
#include "lib/correct/lifted_cuts.h"
#include "lib/correct/low_rapids.h"
#include "lib/correct/measure_stock.h"
#include "lib/correct/plan_holes.h"
#include "lib/correct/proposer.h"
#include "lib/correct/stock_laws.h"

namespace gouge {
namespace {

constexpr int kRounds = 6;  // number of rounds that take back worse changes, before all changes are taken back
constexpr int kStockRounds = 4, kAllStockRounds = 12;  // number of searches anew because changes left other stock
constexpr const char* kLeftForLaws = "a change here would make a move of the written file worse";
constexpr const char* kLeavesOpen = "a change here would leave a move of the written file unchecked: ";
constexpr const char* kLeavesStock = "a change here would bring a move of the written file into remaining stock";
constexpr const char* kUnwritable = "the file's records do not allow this change: ";

/// Returns the changed moves of a line, if the error names only the line and not the change that cannot be written.
std::vector<std::size_t> moves_of_line(const Toolpath& path, const std::vector<PathChange>& changes, std::size_t line) {
  std::vector<std::size_t> moves;
  for (const PathChange& change : changes) {
    const std::size_t next = std::min(change.move + 1, path.moves.size() - 1);
    if (path.moves[change.move].line == line || path.moves[next].line == line) moves.push_back(change.move);
  }
  return moves;
}

std::vector<KeptMove> kept_for(const std::vector<std::size_t>& moves, const std::string& reason) {
  std::vector<KeptMove> kept;
  for (const std::size_t i : moves) kept.push_back({i, reason});
  return kept;
}

bool is_bad(const MoveVerdict& verdict) {
  return verdict.state == MoveState::gouge || verdict.state == MoveState::buried;
}

/// Returns every move that is bad at the end, with its known reason or the usual one.
std::vector<Uncorrected> list_remaining(const Toolpath& path, const CheckResult& before, const Correction& correction,
                                        const CheckResult& after, double max_shift_mm) {
  std::vector<const Uncorrected*> known(path.moves.size(), nullptr);
  for (const Uncorrected& left : correction.uncorrected) known[left.move] = &left;
  std::vector<bool> is_changed(path.moves.size(), false);
  for (const PathChange& change : correction.changes) {
    const std::size_t last = change.hole_shift_mm ? end_of_hole(path, change.move) : change.move + 1;
    std::fill(is_changed.begin() + static_cast<std::ptrdiff_t>(change.move),
              is_changed.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  const std::vector<MovesAfter> spans = moves_after(path.moves.size(), correction.changes);
  std::vector<Uncorrected> remaining;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const MoveVerdict* worst = nullptr;
    for (std::size_t k = spans[i].first; k < spans[i].last; ++k) {
      const MoveVerdict& verdict = after.verdicts[k];
      if (is_bad(verdict) && (worst == nullptr || verdict.depth_mm > worst->depth_mm)) worst = &verdict;
    }
    if (worst == nullptr) continue;
    const double depth = is_changed[i] || !is_bad(before.verdicts[i]) ? worst->depth_mm : before.verdicts[i].depth_mm;
    const std::string reason =
        known[i] != nullptr ? known[i]->reason : usual_reason(path.moves[i], *worst, max_shift_mm);
    remaining.push_back({i, path.moves[i].line, worst->state == MoveState::gouge ? depth : 0, reason, is_changed[i]});
  }
  return remaining;
}

// Keeps the assumptions on the position of part and path. The correction does not move them relative to each other. A
// path that was lifted from the part does not show anything different; a path that did not fit still does not fit.
void keep_place(const CheckResult& before, CheckResult& after) {
  for (const Subject fact : {Subject::mesh_unit, Subject::placement})
    copy_facts(fact, before.assumptions, after.assumptions);
}

void add_lifted_cuts(const Toolpath& path, const Toolpath& after, const CheckSetup& setup, Correction& correction) {
  const std::vector<Uncut> lifted = find_lifted_cuts(path, correction, after, setup);
  correction.uncut.insert(correction.uncut.end(), lifted.begin(), lifted.end());
  std::ranges::stable_sort(correction.uncut, {}, &Uncut::first_move);
}

/// Fills in the lines of all stretches.
template <typename Stretch>
void add_lines(const Toolpath& path, std::vector<Stretch>& stretches) {
  for (Stretch& stretch : stretches) {
    stretch.first_line = path.moves[stretch.first_move].line;
    stretch.last_line = path.moves[stretch.last_move].line;
  }
}

/// The search for changes that keep the laws.
class LawfulSearch {
 public:
  LawfulSearch(const Toolpath& path, const CheckResult& result, const CheckSetup& setup, const CorrectOptions& correct,
               const RewritePath& rewrite, const ProgressCall& progress)
      : path_(path), result_(result), setup_(setup), correct_(correct), rewrite_(rewrite), progress_(progress) {
    if (setup.stock != nullptr) stock_ = std::make_unique<StockLaws>(path, result, setup, progress);
    start();
  }

  Result<LawfulCorrection> run() {
    for (;;) {
      Correction correction = proposer_->propose(progress_);
      Result<Toolpath> changed = rewrite_(correction.changes);
      if (!changed) {
        if (correction.changes.empty()) return changed.error();
        take_back(correction, kept_for(moves_of_line(path_, correction.changes, changed.error().line),
                                       kUnwritable + changed.error().message));
        continue;
      }
      ChangedPath after{std::move(*changed), {}};
      after.result = check_moves(after.path, setup_, progress_);
      std::vector<std::size_t> worse =
          find_worse({&path_, &result_}, correction.changes, {&after.path, &after.result}, setup_.options);
      std::string reason;
      if (worse.empty() && stock_) {
        StockLaws::Examined examined = stock_->examine(correction, {&after.path, &after.result}, progress_);
        if (!examined.sought.empty() && stock_rounds_ < kStockRounds && all_stock_rounds_ < kAllStockRounds) {
          ++stock_rounds_;
          ++all_stock_rounds_;
          stock_->seek(examined, correction.changes, std::move(after.path));
          start();
          continue;
        }
        worse = std::move(examined.blamed);
        reason = kLeavesStock;
        after.result = std::move(examined.result);
      }
      if (worse.empty()) return finish(std::move(correction), std::move(after));
      if (correction.changes.empty()) return changed_alone(worse.front());
      take_back(correction, reason.empty() ? with_reasons(worse, correction, after.path) : kept_for(worse, reason));
      seek_from_the_start();
    }
  }

 private:
  /// Begins the search anew, with what is known of the stock and without the changes that were taken back.
  void start() {
    proposer_ = std::make_unique<Proposer>(path_, stock_ ? stock_->sought() : result_, setup_, correct_, progress_,
                                           stock_ ? stock_->material() : nullptr);
    for (const std::vector<KeptMove>& together : kept_) proposer_->keep(together);
    if (!tilts_given_up_.empty()) proposer_->give_up_tilts(tilts_given_up_);
    for (const std::size_t move : straight_) proposer_->make_straight(move);
    if (!all_kept_.empty()) proposer_->keep_all(all_kept_);
  }

  /// Forgets what a change left that was taken back, so that no move is changed because of it.
  void seek_from_the_start() {
    if (stock_rounds_ == 0) return;
    stock_rounds_ = 0;
    stock_->forget();
    start();
  }

  /// Returns the reasons why moves are worse in the changed path. A machine that cannot run a move is named.
  [[nodiscard]] std::vector<KeptMove> with_reasons(const std::vector<std::size_t>& worse, const Correction& correction,
                                                   const Toolpath& after) const {
    const std::vector<MovesAfter> spans = moves_after(path_.moves.size(), correction.changes);
    std::vector<KeptMove> kept;
    for (const std::size_t i : worse) {
      std::string reason = kLeftForLaws;
      for (std::size_t k = spans[i].first; k < std::min(spans[i].last, after.moves.size()); ++k) {
        const std::string_view open = after.moves[k].not_checked_reason;
        if (open.empty() || open == path_.moves[i].not_checked_reason) continue;
        reason = kLeavesOpen + std::string(open);
        break;
      }
      kept.push_back({i, std::move(reason)});
    }
    return kept;
  }

  void take_back(const Correction& correction, const std::vector<KeptMove>& worse) {
    // A worse move that no change touches is an effect of other changes. Only taking all of them back certainly ends
    // that. Tilts go first: they turn the joints of a machine, which all later moves depend on.
    const bool is_touched = std::any_of(worse.begin(), worse.end(), [&](const KeptMove& kept) {
      return std::any_of(correction.changes.begin(), correction.changes.end(),
                         [&](const PathChange& c) { return c.move == kept.move || c.move + 1 == kept.move; });
    });
    if (round_++ >= kRounds || !is_touched) {
      const std::string reason = worse.empty() ? kLeftForLaws : worse.front().reason;
      if (!proposer_->has_tilts()) {
        all_kept_ = reason;
        return proposer_->keep_all(reason);
      }
      round_ = 0;
      tilts_given_up_ = reason;
      return proposer_->give_up_tilts(reason);
    }
    std::vector<KeptMove> kept;
    for (const KeptMove& one : worse) {
      const auto is_arc = [&](const PathChange& c) { return c.move == one.move && c.has_arc(); };
      if (std::any_of(correction.changes.begin(), correction.changes.end(), is_arc)) {
        straight_.push_back(one.move);
        proposer_->make_straight(one.move);
      } else {
        kept.push_back(one);
      }
    }
    if (!kept.empty()) kept_.push_back(proposer_->keep(kept));
  }

  [[nodiscard]] Diagnostic changed_alone(std::size_t move) const {
    return make_error("correct-law",
                      "the file as it was written without a change reads or checks otherwise; nothing was written",
                      path_.file, path_.moves[move].line);
  }

  [[nodiscard]] LawfulCorrection finish(Correction correction, ChangedPath after) const {
    const CheckResult& before = stock_ ? stock_->before() : result_;
    correction.uncorrected = list_remaining(path_, before, correction, after.result, correct_.max_shift_mm);
    for (ChangeRecord& record : correction.records) {
      if (record.cause != kNone && !is_bad(before.verdicts[record.cause])) record.cause = kNone;
    }
    if (progress_) progress_("measuring what is left", 0, 1);
    correction.stock = measure_stock(path_, correction, after.path, setup_, correct_);
    assess(after.path, setup_, after.result);
    keep_place(result_, after.result);
    add_lifted_cuts(path_, after.path, setup_, correction);
    correction.low_rapids = find_low_rapids(path_, correction, after.path, setup_, correct_);
    add_lines(path_, correction.uncut);
    add_lines(path_, correction.stock);
    LawfulCorrection lawful{std::move(correction), std::move(after), std::nullopt};
    if (stock_) lawful.before = before;
    return lawful;
  }

  const Toolpath& path_;
  const CheckResult& result_;
  const CheckSetup& setup_;
  const CorrectOptions& correct_;
  const RewritePath& rewrite_;
  const ProgressCall& progress_;
  std::unique_ptr<StockLaws> stock_;  // null: stock is not examined
  std::unique_ptr<Proposer> proposer_;
  std::vector<std::vector<KeptMove>> kept_;  // moves that were taken back together
  std::vector<std::size_t> straight_;
  std::string tilts_given_up_, all_kept_;  // reasons; empty: not done
  int round_ = 0, stock_rounds_ = 0, all_stock_rounds_ = 0;
};

}  // namespace

Correction correct_path(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                        const CorrectOptions& correct, const ProgressCall& progress) {
  return Proposer(toolpath, result, setup, correct, progress).propose(progress);
}

Result<LawfulCorrection> correct_lawfully(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                                          const CorrectOptions& correct, const RewritePath& rewrite,
                                          const ProgressCall& progress) {
  return LawfulSearch(toolpath, result, setup, correct, rewrite, progress).run();
}

}  // namespace gouge
