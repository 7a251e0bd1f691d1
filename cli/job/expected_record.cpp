#include "cli/job/expected_record.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "cli/job/claimed_scene.h"
#include "cli/options/length_rule.h"
#include "cli/tools/identities.h"
#include "lib/base/units.h"
#include "lib/check/path_fit.h"
#include "lib/verify/claimed_findings.h"
#include "postproc/report/record_of.h"

namespace gouge {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

class ExpectedRecordMaker {
 public:
  ExpectedRecordMaker(const Job& job, const BesideJob& beside, const ClaimedResult& result,
                      const ProgressCall& progress)
      : job_(job),
        path_(job.toolpath),
        beside_(beside),
        claimed_(result),
        record_(result.record),
        progress_(progress) {}

  ExpectedRecord run() {
    made_.verdicts.resize(path_.moves.size());
    for (const MoveRecord& move : record_.moves) take_move(move);
    gather();
    count();
    const PreparedScene& scene = job_.files->prepared(job_.options.check.threads, progress_);
    CheckSetup setup = job_.setup(scene);
    if (beside_.stock != nullptr) setup.stock = &*beside_.stock->setup;
    setup.basis.place = place_as_stated(setup.basis.place);
    assess(path_, setup, made_);
    ExpectedRecord expected{record_of(model()), is_fit_known(setup)};
    for (std::size_t k = 0; k < findings_.size(); ++k)
      expected.record.events[k].number = findings_[k].number > 0 ? std::optional(findings_[k].number) : std::nullopt;
    return expected;
  }

 private:
  /// Returns the reason of a move as a value. Only those are distinguished that totals, findings and acceptances depend on.
  [[nodiscard]] Reason reason_of(const MoveRecord& move) const {
    if (move.reason.empty()) return {};
    const bool is_in_stock = move.witness && move.witness->against == Against::stock;
    if (move.state == MoveState::gouge && (is_in_stock || is_text_of_limit(move.reason)))
      return {Reason::Kind::stock_met, Body::cutter, 0, move.reason};
    const bool may_be_skipped = move.state == MoveState::not_checked &&
                                path_.moves[move.move].kind == MoveKind::rapid &&
                                record_.options.rapid == rapid_word(RapidMode::skip);
    if (may_be_skipped && move.reason == reason_text({Reason::Kind::rapid_skipped}))
      return {Reason::Kind::rapid_skipped};
    Body body = Body::cutter;
    if (move.state == MoveState::buried) {
      for (const Body one : {Body::shank, Body::holder, Body::head})
        if (move.reason == reason_text({Reason::Kind::buried, one})) body = one;
    }
    return {Reason::Kind::of_path, body, 0, move.reason};
  }

  void take_move(const MoveRecord& move) {
    MoveVerdict& verdict = made_.verdicts[move.move];
    const MoveClaim& claim = claimed_.claims.at(move.move);
    verdict.state = move.state;
    verdict.depth_mm = move.depth_mm.value_or(0);
    verdict.depth_upper_mm = move.depth_upper_mm.value_or(kUnbounded);
    if (move.state != MoveState::gouge) verdict.clearance_mm = move.clearance_mm;  // a gouge has none
    if (move.overcut_mm) verdict.overcut = OvercutBounds{*move.overcut_mm, move.overcut_upper_mm.value_or(kUnbounded)};
    verdict.reason = reason_of(move);
    if (claim.witness) verdict.witness = taken(*claim.witness, *move.witness);
    for (std::size_t k = 0; k < move.further.size(); ++k) {
      const FurtherRecord& record = move.further[k];
      FurtherContact& contact = made_.further.emplace_back();
      contact.move = move.move;
      contact.body = record.body;
      contact.against = record.against;
      contact.depth_mm = record.depth_mm.value_or(0);
      contact.depth_upper_mm = record.depth_upper_mm.value_or(kUnbounded);
      if (record.witness) contact.witness = taken(*claim.further[k].witness, *record.witness);
    }
  }

  static Witness taken(const ClaimedWitness& w, const WitnessRecord& record) {
    return {w.t,
            w.point,
            w.normal,
            w.body,
            record.against,
            static_cast<std::uint32_t>(w.mesh),
            static_cast<std::uint32_t>(w.triangle),
            w.turn};
  }

  [[nodiscard]] ListedMove listed(const MoveRecord& move) const {
    const MoveVerdict& verdict = made_.verdicts[move.move];
    ListedMove one{.move = move.move, .state = claimed_state(move.state)};
    one.depth_mm = verdict.depth_mm;
    one.clearance_mm = verdict.clearance_mm.optional();
    one.reason = move.reason;
    if (move.witness) {
      one.has_witness = true;
      one.body = move.witness->body;
      one.obstacle = static_cast<ClaimedObstacle>(move.witness->against);
    }
    if (move.state == MoveState::buried) one.body = verdict.reason.body;
    return one;
  }

  void gather() {
    std::vector<ListedMove> moves;
    for (const MoveRecord& move : record_.moves) moves.push_back(listed(move));
    std::vector<StatedChoice> stated;
    for (const EventRecord& event : record_.events) stated.push_back({event.worst_move, event.number.value_or(0)});
    findings_ = gather_findings(path_, moves, stated, is_rounded());
    for (const GatheredFinding& finding : findings_) {
      Event& event = made_.events.emplace_back();
      event.state = made_.verdicts[finding.first_move].state;
      event.first_move = finding.first_move;
      event.last_move = finding.last_move;
      event.worst_move = finding.worst_move;
      event.moves = finding.moves;
      event.tool = finding.tool;
      event.body = finding.body;
      event.against = static_cast<Against>(finding.obstacle);
    }
  }

  /// Returns the place as the result words it. Its options have the same place with units.
  [[nodiscard]] std::string place_as_stated(const std::string& place) const {
    const auto fact = std::ranges::find(record_.assumptions, Subject::placement, &Assumption::subject);
    if (fact == record_.assumptions.end()) return place;
    const std::string stated = fact->value.substr(0, fact->value.find(" ("));
    return with_units(stated) == with_units(place) ? stated : place;
  }

  /// Lengths in mm read back as the same double, those in inches with a rounding.
  [[nodiscard]] bool is_rounded() const { return path_.unit != LengthUnit::mm; }

  void count() {
    StateCounts& n = made_.counts;
    n.clean = path_.moves.size() - record_.moves.size();
    for (const MoveRecord& move : record_.moves) {
      const MoveVerdict& verdict = made_.verdicts[move.move];
      count_state(move.state);
      if (verdict.reason.is(Reason::Kind::rapid_skipped)) ++n.skipped;
      made_.worst_overcut_mm = std::max(made_.worst_overcut_mm, move.overcut_mm.value_or(0));
      if (move.state != MoveState::gouge) continue;
      if (!verdict.is_in_stock())
        made_.largest_gap_mm = std::max(made_.largest_gap_mm, verdict.depth_upper_mm - verdict.depth_mm);
      const bool is_as_deep = !(verdict.depth_mm < made_.worst_depth_mm);
      const bool is_stated = is_rounded() && record_.totals.worst_move == move.move;
      if (verdict.depth_mm > made_.worst_depth_mm || (is_as_deep && is_stated)) made_.worst_move = move.move;
      made_.worst_depth_mm = std::max(made_.worst_depth_mm, verdict.depth_mm);
    }
  }

  void count_state(MoveState state) {
    StateCounts& n = made_.counts;
    switch (state) {
      case MoveState::clean:
        return;
      case MoveState::near_miss:
        ++n.near_miss;
        return;
      case MoveState::gouge:
        ++n.gouge;
        return;
      case MoveState::buried:
        ++n.buried;
        return;
      case MoveState::not_checked:
        ++n.not_checked;
        return;
      case MoveState::not_certified:
        ++n.not_certified;
        return;
    }
  }

  [[nodiscard]] ReportModel model() const {
    ReportModel model;
    model.inputs = record_.inputs;
    model.options = job_.options.check;
    for (const auto& [name, texts] : record_.options.more)
      for (const std::string& text : texts) model.more_options.push_back({name, text});
    model.placement = placement_identity(job_.options.place, job_.stl_unit(claimed_.arguments));
    model.toolpath = &path_;
    model.result = &made_;
    model.parts = job_.files->parts;
    model.fixtures = job_.files->fixtures;
    model.heads = job_.files->head_facts;
    model.tools = job_.tool_facts;
    model.notes = job_.notes;
    std::ranges::move(open_warnings(made_.assumptions), std::back_inserter(model.notes));
    beside_.baseline.apply(model);
    return model;
  }

  [[nodiscard]] bool is_fit_known(const CheckSetup& setup) const {
    const double clean_mm = setup.options.tolerance_mm + setup.options.resolution_mm;
    return std::ranges::all_of(setup.tools,
                               [&](const ToolVariants* tool) { return tool == nullptr || touch_mm(*tool) > clean_mm; });
  }

  const Job& job_;
  const Toolpath& path_;
  const BesideJob& beside_;
  const ClaimedResult& claimed_;
  const ResultRecord& record_;
  const ProgressCall& progress_;
  CheckResult made_;
  std::vector<GatheredFinding> findings_;
};

}  // namespace

ExpectedRecord make_expected_record(const Job& job, const BesideJob& beside, const ClaimedResult& result,
                                    const ProgressCall& progress) {
  return ExpectedRecordMaker(job, beside, result, progress).run();
}

}  // namespace gouge
