#include "cli/commands/verification.h"

#include <utility>

#include "cli/job/claimed_scene.h"
#include "cli/job/find_differences.h"
#include "lib/base/exit_code.h"
#include "lib/verify/claimed_pose.h"

namespace gouge {

namespace {

/// Verifies a result whose inputs are unchanged.
class Verifier {
 public:
  Verifier(const Job& job, const BesideJob& beside, const ClaimedResult& result, Progress& progress)
      : job_(job),
        beside_(beside),
        result_(result),
        scene_(claimed_scene(job)),
        digest_(inputs_digest(result.inputs, job, result.arguments)),
        progress_(progress) {
    if (beside.stock != nullptr) stock_ = claimed_stock(job, result.arguments, *beside.stock);
    done_.has_heads = !scene_.heads.empty();
    done_.has_excess = result.has_excess;
  }

  /// Verifies the result and its certificate. Errors: certificate-invalid.
  Result<Verification> run(const NamedCertificate& certificate, double seconds) {
    for (const std::string& what : find_contradictions(result_)) refute(std::nullopt, what);
    if (scene_.path.moves.size() != result_.totals.moves) {
      refute(std::nullopt, "the result has " + std::to_string(result_.totals.moves) + " moves and the toolpath " +
                               std::to_string(scene_.path.moves.size()));
      return std::move(done_);
    }
    compare_record();
    if (const auto wrong = find_wrong_joints(scene_)) refute(*wrong, "its rotary angles do not give its tool axes");
    claims_ = result_.claims_of(result_.totals.moves);
    if (stock_) verify_stock(seconds);
    const ClaimedTools tools = claimed_tools(scene_);
    const SceneOrders orders(scene_);
    progress_.begin("verifying witnesses");
    check_witnesses(tools);
    CertificateReading proofs;
    proofs.of_move.resize(claims_.size(), ProofState::missing);
    if (!certificate.name.empty()) {
      done_.has_certificate = true;
      std::optional<StockClaims> about_stock;
      if (stock_) about_stock.emplace(*stock_, stock_depths_);
      Result<CertificateReading> read =
          verify_certificate(scene_, orders, claims_, digest_, std::string(certificate.name), certificate.bytes,
                             progress_.call(), about_stock ? &*about_stock : nullptr);
      if (!read) return read.error();
      proofs = std::move(*read);
      for (const ProofRefutation& r : proofs.refuted) done_.refuted.push_back({r.move, std::nullopt, r.point, r.what});
    }
    count(proofs.of_move);
    if (stock_) count_stock(proofs.of_move_in_stock);
    refute_open_moves();
    progress_.begin("looking for counterexamples");
    done_.outside = check_outside(scene_, tools, claims_);
    for (const Counterexample& c : done_.outside.refuted) done_.refuted.push_back({c.move, c.t, c.point, c.what});
    std::vector<bool> is_proved(claims_.size());
    for (std::size_t i = 0; i < claims_.size(); ++i) is_proved[i] = proofs.of_move[i] == ProofState::proved;
    if (is_worth_sampling_) done_.attack = attack_claims(scene_, orders, tools, claims_, is_proved, seconds);
    if (const auto& c = done_.attack.found) done_.refuted.push_back({c->move, c->t, c->point, c->what});
    return std::move(done_);
  }

 private:
  void refute(std::optional<std::size_t> move, std::string what) {
    Verification::Refuted refuted;
    refuted.move = move;
    refuted.what = std::move(what);
    done_.refuted.push_back(std::move(refuted));
  }

  /// Compares the result with what its moves and inputs give.
  void compare_record() {
    if (!result_.malformed.empty() || result_.names_a_move_twice) return;  // it is refuted already
    progress_.begin("comparing the result with its inputs");
    RecordDifferences found = find_differences(result_, make_expected_record(job_, beside_, result_, progress_.call()));
    is_worth_sampling_ = found.wrong.empty();
    for (std::string& what : found.wrong) refute(std::nullopt, std::move(what));
    done_.is_placement_open = found.is_placement_open;
  }

  /// Verifies what the result claims about remaining stock. The other claims of these moves are those of clean ones: a
  /// move that meets the stock as well as a part is a gouge of the part.
  void verify_stock(double seconds) {
    progress_.begin("verifying the stock");
    const StockVerifier verifier(*stock_);
    std::vector<bool> is_clear(claims_.size(), false);
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      MoveClaim& claim = claims_[i];
      is_clear[i] = claims_clean(claim);
      std::optional<double>& depth = stock_depths_.emplace_back();
      if (is_clear[i]) depth = stock_->largest_clear_mm();
      if (!claim.witness || !claim.witness->is_stock) continue;
      if (auto fault = verifier.find_fault(i, claim))
        done_.refuted.push_back({i, claim.witness->t, claim.witness->point, "its witness: " + *fault});
      else
        ++done_.stock_witnesses;
      depth = claim.depth_upper_mm;
      claim = MoveClaim();
    }
    if (!is_worth_sampling_) return;
    done_.stock = verifier.attack(is_clear, seconds);
    if (const auto& c = done_.stock->found) done_.refuted.push_back({c->move, c->t, c->point, c->what});
  }

  /// A result must not call a move clean whose motion the toolpath or the machine leaves open.
  void refute_open_moves() {
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      const Move& move = scene_.path.moves[i];
      if (move.not_checked_reason.empty() || move.is_covered() || !claims_clean(claims_[i])) continue;
      refute(i, "it cannot be checked: " + std::string(move.not_checked_reason));
    }
  }

  void check_witnesses(const ClaimedTools& tools) {
    for (const auto& [move, claim] : result_.claims) {
      if (move >= claims_.size() || (stock_ && claim.witness && claim.witness->is_stock)) continue;
      if (auto fault = find_witness_fault(scene_, tools, move, claim)) {
        const auto& w = claim.witness;
        done_.refuted.push_back({move, w ? std::optional(w->t) : std::nullopt,
                                 w ? std::optional(w->point) : std::nullopt, "its witness: " + *fault});
      } else if (claim.witness && claim.state != ClaimedState::buried) {
        ++done_.witnesses;
      }
      for (const FurtherClaim& further : claim.further) check_further(tools, move, further);
    }
  }

  void check_further(const ClaimedTools& tools, std::size_t move, const FurtherClaim& further) {
    const auto& w = further.witness;
    if (auto fault = find_further_fault(scene_, tools, move, further)) {
      done_.refuted.push_back({move, w ? std::optional(w->t) : std::nullopt, w ? std::optional(w->point) : std::nullopt,
                               std::string("the witness of its ") + body_name(further.body) + ": " + *fault});
    } else if (w) {
      ++done_.witnesses;
    }
  }

  void count(const std::vector<ProofState>& proofs) {
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      const bool is_proved = proofs[i] == ProofState::proved;
      if (claims_clean(claims_[i])) {
        ++(is_proved ? done_.proved_clean : done_.sampled_clean);
        if (!is_proved && done_.has_certificate) done_.without_proof.push_back(i);
      } else if (claims_[i].state == ClaimedState::gouge) {
        ++(is_proved ? done_.proved_gouges : done_.sampled_gouges);
      } else {
        ++done_.uncovered;
      }
    }
  }

  void count_stock(const std::vector<ProofState>& proofs) {
    for (std::size_t i = 0; i < stock_depths_.size(); ++i) {
      const bool is_proved = i < proofs.size() && proofs[i] == ProofState::proved;
      if (stock_depths_[i]) ++(is_proved ? done_.proved_stock : done_.sampled_stock);
      const bool is_clear = stock_depths_[i] && *stock_depths_[i] <= stock_->largest_clear_mm();
      if (is_clear && i < proofs.size() && proofs[i] == ProofState::open) done_.without_stock_proof.push_back(i);
    }
  }

  const Job& job_;
  const BesideJob& beside_;
  const ClaimedResult& result_;
  ClaimedScene scene_;
  std::string digest_;
  std::optional<ClaimedStock> stock_;
  std::vector<MoveClaim> claims_;
  StockDepths stock_depths_;
  bool is_worth_sampling_ = true;  // false: the result is refuted by what it states of its own moves and inputs
  Progress& progress_;
  Verification done_;
};

}  // namespace

Result<Verification> verify_claims(const Job& job, const BesideJob& beside, const ClaimedResult& result,
                                   const NamedCertificate& certificate, double seconds, Progress& progress) {
  Result<Verification> verification = Verifier(job, beside, result, progress).run(certificate, seconds);
  if (!verification) return verification;
  for (Verification::Refuted& one : verification->refuted)
    if (one.move && *one.move < job.toolpath.moves.size()) one.line = job.toolpath.moves[*one.move].line;
  return verification;
}

int exit_status(const Verification& v) {
  if (!v.refuted.empty()) return kExitGouges;
  const bool is_covered = v.uncovered == 0 && !v.has_excess && v.without_proof.empty() &&
                          v.without_stock_proof.empty() && !v.is_placement_open && v.outside.unexamined == 0;
  return is_covered ? kExitClean : kExitNotChecked;
}

}  // namespace gouge
