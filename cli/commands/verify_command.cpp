#include "cli/commands/verify_command.h"

#include <CLI/CLI.hpp>
#include <ostream>
#include <utility>

#include "cli/job/claimed_result.h"
#include "cli/job/claimed_scene.h"
#include "cli/job/load_stock.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/progress.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "lib/base/sha256.h"
#include "lib/verify/claimed_pose.h"

namespace gouge {

namespace {

constexpr double kMaxSeconds = 1e6;

/// Verifies a result whose inputs are unchanged.
class Verifier {
 public:
  /// `stock`: null, if the check had none.
  Verifier(const Job& job, const LoadedStock* stock, const ClaimedResult& result, Progress& progress)
      : result_(result),
        scene_(claimed_scene(job)),
        digest_(inputs_digest(result.inputs, job, result.arguments)),
        progress_(progress) {
    if (stock != nullptr) stock_ = claimed_stock(job, result.arguments, *stock);
    done_.has_heads = !scene_.heads.empty();
    done_.has_excess = result.has_excess;
  }

  /// Verifies the result and its certificate. Errors: certificate-invalid.
  Result<Verification> run(const std::string& certificate_name, std::string_view certificate, double seconds) {
    for (const std::string& what : find_contradictions(result_)) refute(std::nullopt, what);
    if (scene_.path.moves.size() != result_.totals.moves) {
      refute(std::nullopt, "the result has " + std::to_string(result_.totals.moves) + " moves and the toolpath " +
                               std::to_string(scene_.path.moves.size()));
      return std::move(done_);
    }
    if (const auto wrong = find_wrong_joints(scene_)) refute(*wrong, "its rotary angles do not give its tool axes");
    claims_ = result_.claims_of(result_.totals.moves);
    if (stock_) verify_stock(seconds);
    const ClaimedTools tools = claimed_tools(scene_);
    const SceneOrders orders(scene_);
    progress_.begin("verifying witnesses");
    check_witnesses(tools);
    CertificateReading proofs;
    proofs.of_move.resize(claims_.size(), ProofState::missing);
    if (!certificate_name.empty()) {
      done_.has_certificate = true;
      std::optional<StockClaims> about_stock;
      if (stock_) about_stock.emplace(*stock_, stock_depths_);
      Result<CertificateReading> read =
          verify_certificate(scene_, orders, claims_, digest_, certificate_name, certificate, progress_.call(),
                             about_stock ? &*about_stock : nullptr);
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
    done_.attack = attack_claims(scene_, orders, tools, claims_, is_proved, seconds);
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
      if (result_.lines.at(move) != scene_.path.moves[move].line)
        refute(move, "the result names line " + std::to_string(result_.lines.at(move)) + " for it");
      if (auto fault = find_witness_fault(scene_, tools, move, claim)) {
        const auto& w = claim.witness;
        done_.refuted.push_back({move, w ? std::optional(w->t) : std::nullopt,
                                 w ? std::optional(w->point) : std::nullopt, "its witness: " + *fault});
      } else if (claim.witness) {
        ++done_.witnesses;
      }
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

  const ClaimedResult& result_;
  ClaimedScene scene_;
  std::string digest_;
  std::optional<ClaimedStock> stock_;
  std::vector<MoveClaim> claims_;
  StockDepths stock_depths_;
  Progress& progress_;
  Verification done_;
};

/// Returns the inputs that differ from those of the result.
Result<std::vector<Verification::Refuted>> find_changed(const ClaimedResult& result, std::uint64_t max_bytes) {
  std::vector<Verification::Refuted> changed;
  for (const InputFile& input : result.inputs) {
    if (input.name == "-")
      return make_error("verify-input", "the " + input.role +
                                            " of this result was read from standard input; expected a file: check it "
                                            "again by its name");
    const Result<FileView> file = view_file(input.name, max_bytes);
    if (!file) {
      Diagnostic error = file.error();
      if (error.code == "file-not-found")
        error.message = "there is no such file, nor in the folder of the result or in one above it; expected the " +
                        input.role + " that was checked";
      return error;
    }
    if ("sha256:" + sha256_of(file->bytes) == input.checksum) continue;
    Verification::Refuted one;
    one.what = "the " + input.role + " " + input.name + " is not the file that was checked (its SHA-256 differs)";
    changed.push_back(std::move(one));
  }
  return changed;
}

bool are_same(const std::vector<InputFile>& a, const std::vector<InputFile>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const InputFile& x, const InputFile& y) {
    return x.role == y.role && x.checksum == y.checksum;
  });
}

int finish(const VerifyArguments& arguments, const Verification& verification, const ClaimedResult& result,
           const Toolpath* path, std::ostream& out) {
  if (!arguments.is_quiet) out << verification_text(verification, result, path);
  return exit_status(verification);
}

}  // namespace

void add_verify_options(CLI::App& command, VerifyArguments& a) {
  command.add_option("RESULT", a.result_file, "Result of a check (the output of --json, or the folder of a report)")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--certificate", a.certificate_file, "Proofs of the same check (the output of check --certificate)")
      ->type_name("FILE");
  command
      .add_option(
          "--seconds", a.seconds,
          "Minimum duration of sampling (default: 0, for the end of every move without a proof and 4000 instants more, "
          "whatever time they take)")
      ->type_name("SECONDS");
  add_input_limit(command, a.input);
  add_threads_option(command, a.threads);
  add_progress_option(command, a.progress);
  add_verbosity(command, a, "Print notes of all inputs and the peak memory (not with -q)");
  command.footer(
      "Example:\n"
      "  gougecheck check part.apt --part part.stl --tools tools.json \\\n"
      "      --json result.json --certificate proofs.gcp\n"
      "  gougecheck verify result.json --certificate proofs.gcp\n\n"
      "The command reads the inputs that the result names, from their paths, or relative to the folder of the result "
      "or to one above it. It recomputes every witness, tests every proof in interval arithmetic and looks for "
      "counterexamples. It shares no code with the check except the readers of files. docs/method/verify.md explains "
      "the method and has an example that is computed by hand.\n\n"
      "Exit status: 0 verified, 1 refuted, 2 wrong command line, 3 input unreadable, 4 not everything is "
      "covered, 5 internal or resource failure.");
}

int run_verify(const VerifyArguments& typed, std::ostream& out, std::ostream& err) {
  VerifyArguments a = typed;
  if (const auto batch = refuse_batch_folder(typed.result_file)) return fail(err, {*batch});
  a.result_file = result_in(typed.result_file);
  if (const auto error = find_contradiction(a)) return fail(err, {*error});
  const std::optional<double> seconds = a.seconds.empty() ? 0 : parse_number(a.seconds);
  if (!seconds || !(*seconds >= 0 && *seconds <= kMaxSeconds))
    return fail(err, {usage_error("--seconds", a.seconds, "a number of seconds, 0 or more")});
  Progress progress(err, understand_progress(a.progress));
  progress.begin("reading " + a.result_file);
  const Result<FileView> bytes = view_file(a.result_file, a.input.max_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  Result<ClaimedResult> result = read_claimed_result(a.result_file, bytes->bytes);
  if (!result) return fail(err, {result.error()}, kExitInput);
  if (!result->not_recorded.empty() && result->digest == DigestState::right)
    return fail(err,
                {make_error("verify-input",
                            "the result does not name the file of the " + result->not_recorded +
                                ", which was in memory of the library or of Python; expected files for all inputs",
                            a.result_file)},
                kExitInput);
  result->arguments.input = a.input;
  result->options.check.threads = a.threads;
  FileView certificate;
  if (!a.certificate_file.empty()) {
    Result<FileView> read = view_file(a.certificate_file, a.input.max_bytes);
    if (!read) return fail(err, {read.error()});
    certificate = std::move(*read);
  }
  Result<std::vector<Verification::Refuted>> changed = find_changed(*result, a.input.max_bytes);
  if (!changed) return fail(err, {changed.error()}, kExitInput);
  if (!changed->empty()) {
    Verification verification;
    verification.refuted = std::move(*changed);
    progress.end();
    return finish(a, verification, *result, nullptr, out);
  }
  LoadedJob loaded = load_job(result->arguments, result->options, progress);
  progress.end();
  if (!loaded.job) return fail(err, loaded.errors, kExitInput);
  std::optional<LoadedStock> stock;
  if (!result->arguments.stock.empty()) {
    Diagnostics errors;
    stock = load_stock(result->arguments, *loaded.job, progress, errors);
    progress.end();
    if (!stock) return fail(err, errors, kExitInput);
  }
  if (!are_same(loaded.job->inputs, result->inputs))
    return fail(err,
                {make_error("input-changed", "the inputs changed while they were read; run it again", a.result_file)});
  print_notes(err, loaded.job->notes, a);
  Result<Verification> verification = Verifier(*loaded.job, stock ? &*stock : nullptr, *result, progress)
                                          .run(a.certificate_file, certificate.bytes, *seconds);
  progress.end();
  if (!verification) return fail(err, {verification.error()}, kExitInput);
  if (a.is_verbose) print_peak_memory(err);
  return finish(a, *verification, *result, &loaded.job->toolpath, out);
}

namespace {

constexpr std::size_t kMaxLines = 50;

std::string moves(std::size_t count) { return count_text(count, "move"); }

std::string refutation(const Verification::Refuted& refuted, const ClaimedResult& result, const Toolpath* path) {
  std::string line = result.arguments.path;
  if (refuted.move && path != nullptr && *refuted.move < path->moves.size())
    line += ":" + std::to_string(std::size_t{path->moves[*refuted.move].line});
  line += ": refuted: " + refuted.what;
  if (refuted.move) line += ", move " + std::to_string(*refuted.move);
  if (refuted.t) line += " t=" + display_text(*refuted.t, 6);
  if (refuted.point) {
    const Vec3 p = *refuted.point / result.mm_per_unit;
    line += " at (" + display_text(p.x(), 6) + ", " + display_text(p.y(), 6) + ", " + display_text(p.z(), 6) + ")";
  }
  return line;
}

std::string verified_text(const Verification& v) {
  std::string text = "verified: the inputs are those of the result (SHA-256)\n";
  if (v.witnesses > 0)
    text += "verified: " + count_text(v.witnesses, "witness", "witnesses") +
            " (point on its triangle, pose, depth, side, way out)\n";
  if (v.stock_witnesses > 0)
    text += "verified: " + count_text(v.stock_witnesses, "witness", "witnesses") +
            " in the stock (point in the stock, pose, depth, no earlier cutter there)\n";
  const std::string except =
      std::string(v.stock ? " against parts and fixtures" : "") +
      (v.has_heads ? ", of the tool without its heads" : ", at every instant and for every triangle");
  if (v.proved_clean > 0) text += "verified: " + moves(v.proved_clean) + " proved clean" + except + "\n";
  if (v.proved_gouges > 0)
    text += "verified: " + count_text(v.proved_gouges, "gouging move") + " proved to be no deeper than said" + except +
            "\n";
  if (v.outside.proved > 0)
    text +=
        "verified: " + moves(v.outside.proved) + " outside of all solids, as the tool leaves their box on the way\n";
  if (v.proved_stock > 0)
    text += "verified: " + moves(v.proved_stock) +
            " proved to meet no remaining stock deeper than said, at every instant\n";
  return text;
}

std::string sampled_text(const Verification& v) {
  std::string text;
  const auto add = [&](const std::string& what) { text += "only sampled: " + what + "\n"; };
  if (v.sampled_clean > 0)
    add(moves(v.sampled_clean) + " said to be clean" + (v.has_certificate ? "" : " (no certificate)"));
  if (v.sampled_gouges > 0) add("the bound of the depth of " + count_text(v.sampled_gouges, "gouging move"));
  if (v.outside.sampled > 0)
    add("that " + moves(v.outside.sampled) + " are outside of all solids, by a winding number");
  if (v.has_heads) add("the heads, in some instants");
  if (v.attack.samples > 0)
    text += "attacked: nothing deeper than said was found in " + count_text(v.attack.samples, "instant") + " of " +
            moves(v.attack.moves) + "\n";
  if (v.stock) {
    if (v.sampled_stock > 0)
      add(moves(v.sampled_stock) + " said to be clear of the stock, or to meet it no deeper than said");
    text += "attacked: no stock was left at " + count_text(v.stock->samples, "place") + " of these moves\n";
  }
  return text;
}

std::string uncovered_text(const Verification& v) {
  std::string text;
  const auto add = [&](const std::string& what) { text += "not covered: " + what + "\n"; };
  if (v.uncovered > 0) add(moves(v.uncovered) + " that the result itself calls not checked, not certified or buried");
  if (!v.without_proof.empty())
    add(moves(v.without_proof.size()) +
        " said to be clean, for which the certificate says no proof was found (first: move " +
        std::to_string(v.without_proof.front()) + ")");
  if (!v.without_stock_proof.empty())
    add(moves(v.without_stock_proof.size()) +
        " said to be clear of the stock, for which the certificate says no proof was found (first: move " +
        std::to_string(v.without_stock_proof.front()) + ")");
  if (v.outside.unexamined > 0)
    add("whether " + moves(v.outside.unexamined) + " of tools with a thin body are outside of all solids");
  if (v.has_excess) add("the material that the result states to be left on the parts");
  text +=
      "not part of a verification: overcut, that no move is nearer than said, how far thin features reach into a solid\n";
  return text;
}

}  // namespace

int exit_status(const Verification& v) {
  if (!v.refuted.empty()) return kExitGouges;
  const bool is_covered = v.uncovered == 0 && !v.has_excess && v.without_proof.empty() &&
                          v.without_stock_proof.empty() && v.outside.unexamined == 0;
  return is_covered ? kExitClean : kExitNotChecked;
}

std::string verification_text(const Verification& v, const ClaimedResult& result, const Toolpath* path) {
  std::string text;
  for (std::size_t k = 0; k < v.refuted.size() && k < kMaxLines; ++k)
    text += printable(refutation(v.refuted[k], result, path)) + "\n";
  if (v.refuted.size() > kMaxLines) text += "and " + std::to_string(v.refuted.size() - kMaxLines) + " more\n";
  if (!v.refuted.empty())
    return text + "result: refuted; it is not right, or its inputs are not those that were checked\n";
  text += verified_text(v) + sampled_text(v) + uncovered_text(v);
  if (exit_status(v) != kExitClean) return text + "result: not refuted, but not all of it is covered\n";
  const bool is_all_proved = v.has_certificate && !v.has_heads &&
                             v.sampled_clean + v.sampled_gouges + v.sampled_stock + v.outside.sampled == 0;
  return text + (is_all_proved ? "result: verified\n"
                               : "result: not refuted; what is only sampled may be wrong all the same\n");
}

}  // namespace gouge
