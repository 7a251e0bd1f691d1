#include "lib/certify/settle_stock.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/certify/check.h"
#include "lib/check/check_path.h"
#include "lib/stock/check_stock.h"
#include "lib/stock/excess.h"
#include "lib/stock/move_places.h"

namespace gouge {
namespace {

/// Enters findings into verdicts.
class Settling {
 public:
  Settling(const Toolpath& path, const CutHistory& history, CheckResult& result)
      : path_(path), history_(history), result_(result) {}

  void enter(const StockFinding& finding) {
    MoveVerdict& verdict = result_.verdicts[finding.move];
    if (finding.witness) result_.stock->contacts.push_back(contact_of(finding));
    if (!is_free(verdict)) return add_to_gouge(verdict, remark_about(finding));
    if (!finding.witness) {
      verdict = open(std::max(verdict.depth_upper_mm, finding.depth_upper_mm), open_reason(finding));
    } else if (has_unknown_way(finding.move)) {
      verdict = not_checked(link_reason(path_, finding.move));
    } else {
      verdict = gouge(finding);
    }
  }

  void leave_open(std::size_t move) {
    MoveVerdict& verdict = result_.verdicts[move];
    const Reason why{Reason::Kind::stock_motion_open, Body::cutter};
    if (!is_free(verdict)) return add_to_gouge(verdict, open_remark(why));
    verdict = open(std::numeric_limits<double>::infinity(), why);
  }

 private:
  static bool is_free(const MoveVerdict& verdict) {
    return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
  }

  /// Adds to the gouge of a part or a fixture the stock that its move meets too. So no acceptance of the gouge hides it.
  static void add_to_gouge(MoveVerdict& verdict, const Reason& stock) {
    if (verdict.state != MoveState::gouge) return;
    const std::string limit = reason_text(verdict.reason);
    const std::string detail = std::string(stock.detail()) + (limit.empty() ? "" : "; " + limit);
    verdict.reason = {stock.kind, stock.body, stock.amount(), detail};
  }

  /// Returns the remark that it is open, for this reason, whether the move of a gouge meets stock too.
  static Reason open_remark(const Reason& why) { return {Reason::Kind::stock_open_too, why.body, 0, reason_text(why)}; }

  /// Returns the remark about a finding in a move that gouges a part or a fixture. Its amount is the depth.
  [[nodiscard]] Reason remark_about(const StockFinding& finding) const {
    if (!finding.witness) return open_remark(open_reason(finding));
    if (has_unknown_way(finding.move)) return open_remark(link_reason(path_, finding.move));
    const double depth_mm = finding.witness->depth_mm;
    return {Reason::Kind::stock_met_too, finding.body, depth_mm,
            display_text(depth_mm, kLengthDecimals) + " mm (at most " +
                display_text(finding.depth_upper_mm, kLengthDecimals) + " mm), " + evidence(finding)};
  }

  /// Returns whether the file does not state the way to the position at which a move ends.
  [[nodiscard]] bool has_unknown_way(std::size_t move) const {
    return path_.moves[move].is_linked && !path_.moves[move].has_start;
  }

  /// Returns why a finding without a witness leaves its move open.
  [[nodiscard]] Reason open_reason(const StockFinding& finding) const {
    if (finding.body == Body::head && is_turn_open(finding.move)) return {Reason::Kind::turn_undecided, Body::head};
    if (!finding.unknown) return {Reason::Kind::stock_touched, finding.body};
    return {Reason::Kind::stock_unknown, finding.body, 0, place_of(finding.unknown)};
  }

  /// Returns whether the law leaves open how a head is turned about the tool axis.
  [[nodiscard]] bool is_turn_open(std::size_t move) const {
    const Motion motion = history_.motion_of(move);
    return !has_known_turn(motion) || !history_.departure_from(motion).is_none();
  }

  [[nodiscard]] static std::size_t line_of(const CutMove& cut) { return cut.program->path().moves[cut.move].line; }
  /// Returns the name of the file of a program that ran before; empty for the path itself.
  [[nodiscard]] std::string file_of(const CutMove& cut) const {
    return cut.program == &history_ ? "" : cut.program->path().file;
  }
  /// Returns "line 12", or "line 12 of op10.apt" for a program that ran before.
  [[nodiscard]] std::string place_of(const CutMove& cut) const {
    const std::string file = file_of(cut);
    return "line " + std::to_string(line_of(cut)) + (file.empty() ? "" : " of " + file);
  }

  [[nodiscard]] StockContact contact_of(const StockFinding& finding) const {
    StockContact contact;
    contact.move = finding.move;
    contact.clear_until = finding.contact.clear_until;
    contact.contact_at = finding.contact.contact_at;
    if (finding.nearest_cut) {
      contact.cut_move = finding.nearest_cut->cut.move;
      contact.cut_line = line_of(finding.nearest_cut->cut);
      contact.cut_file = file_of(finding.nearest_cut->cut);
      contact.missed_by_mm = finding.nearest_cut->distance_mm;
    }
    return contact;
  }

  [[nodiscard]] static MoveVerdict open(double depth_upper_mm, const Reason& why) {
    MoveVerdict verdict;
    verdict.state = MoveState::not_certified;
    verdict.depth_upper_mm = depth_upper_mm;
    verdict.reason = why;
    return verdict;
  }

  MoveVerdict gouge(const StockFinding& finding) const {
    const ToolVariants& tool = *history_.tool_of(finding.move).tool;
    const CompiledTool& body = history_.is_cutting(finding.move) ? tool.non_cutting : tool.bare;
    MoveVerdict verdict;
    verdict.state = MoveState::gouge;
    verdict.depth_mm = finding.witness->depth_mm;
    verdict.depth_upper_mm = finding.depth_upper_mm;
    const Motion motion = history_.motion_of(finding.move);
    verdict.witness = finding.body == Body::head
                          ? stock_witness(*finding.witness, history_.heads()[finding.head], motion)
                          : stock_witness(*finding.witness, finding.body, body, motion);
    verdict.reason = {Reason::Kind::stock_met, finding.body, 0, evidence(finding)};
    return verdict;
  }

  std::string evidence(const StockFinding& finding) const {
    std::string text = "first contact at t=" + display_text(finding.contact.contact_at, kInstantDecimals) +
                       ", clear until t=" + display_text(finding.contact.clear_until, kInstantDecimals) + "; ";
    if (!finding.nearest_cut) return text + "no earlier move cuts this stock";
    return text + "the nearest earlier cut, " + place_of(finding.nearest_cut->cut) + ", misses it by " +
           display_text(finding.nearest_cut->distance_mm, kLengthDecimals) + " mm";
  }

  static constexpr int kInstantDecimals = 6, kLengthDecimals = 3;

  const Toolpath& path_;
  const CutHistory& history_;
  CheckResult& result_;
};

// The size of the pieces in pictures, as a share of the diagonal of the stock, and about how many there are at most.
constexpr double kPatchShare = 0.004;
constexpr std::size_t kPatches = 20'000;

ExcessFacts excess_facts(const CutHistory& history, const StockSetup& stock, const CheckSetup& setup,
                         const ProgressCall& progress) {
  const PartColumns& parts = stock.excess->parts;
  const ExcessQuestion question{history, stock.solid, parts, stock.options.resolution_mm};
  const ExcessResult found = find_excess(question, stock.excess->asked_mm, setup.options.threads, progress);
  ExcessFacts facts{stock.excess->asked_mm, stock.options.resolution_mm, found.surface_mm2, {}, {}};
  for (const ExcessPlace& place : found.places) {
    ExcessPlaceFacts& one = facts.places.emplace_back();
    const HighestColumn& highest = place.highest;
    one.height_mm = highest.height_mm;
    one.height_upper_mm = highest.height_upper_mm;
    one.area_mm2 = place.area_mm2;
    one.area_upper_mm2 = place.area_upper_mm2;
    const FacetPiece& at = place.is_proved() ? highest.at : found.left[place.first_piece].piece;
    one.point = place.is_proved() ? highest.point : at.middle();
    one.normal = at.normal;
    one.part = at.mesh;
    one.facet = parts.mesh(at.mesh).file_triangle[at.triangle];
    if (place.is_proved() || !place.unknown) continue;
    one.unknown_move = place.unknown.move;
    const Toolpath& program = place.unknown.program->path();
    one.unknown_line = program.moves[place.unknown.move].line;
    if (place.unknown.program != &history) one.unknown_file = program.file;
  }
  if (!stock.excess->is_pictured) return facts;
  const double size = kPatchShare * (stock.solid.high() - stock.solid.low()).norm();
  for (const ColumnSample& sample :
       sample_columns(question, found, facts.asked_mm, size, kPatches, setup.options.threads))
    facts.patches.push_back({sample.corners, sample.height_mm});
  return facts;
}

}  // namespace

StockHistory::StockHistory(const Toolpath& path, const MotionLaw& law, const StockSetup& stock) {
  const auto last = [&] { return programs_.empty() ? nullptr : &programs_.back(); };
  for (const EarlierProgram& earlier : stock.before)
    programs_.emplace_back(earlier.path, earlier.law, earlier.tools, stock.options, last());
  programs_.emplace_back(path, law, stock.tools, stock.options, last(), stock.heads);
}

namespace {

// Returns by how much the farthest of some corners of the parts is outside the stock; a distance that is measured, not
// proved.
double part_outside_mm(std::span<const IndexedMesh> parts, const StockSolid& stock) {
  constexpr std::size_t kMaxCorners = 2000;
  std::size_t corners = 0;
  for (const IndexedMesh& part : parts) corners += part.vertices.size();
  const std::size_t step = std::max<std::size_t>(1, corners / kMaxCorners);
  double farthest_mm = 0;
  for (const IndexedMesh& part : parts)
    for (std::size_t i = 0; i < part.vertices.size(); i += step)
      farthest_mm = std::max(farthest_mm, stock.signed_distance(part.vertices[i]).mm);
  return farthest_mm;
}

}  // namespace

Assumption assume_stock(const std::string& description, const StockSetup& stock, std::span<const IndexedMesh> parts,
                        const std::string& file) {
  constexpr double kMaxOutside_mm = 1;  // more than the tessellations of a stock and its part differ
  std::string programs;
  for (const EarlierProgram& earlier : stock.before)
    programs += (programs.empty() ? "the moves of " : ", ") + earlier.path.file;
  Assumption fact{.subject = Subject::stock, .basis = Basis::stated, .value = description};
  fact.evidence = "stated by the user; " +
                  (programs.empty() ? "only the moves of this path" : programs + " and then those of this path") +
                  " remove material from it";
  fact.file = file;
  if (const double outside_mm = part_outside_mm(parts, stock.solid); outside_mm > kMaxOutside_mm) {
    fact.basis = Basis::contradicted;
    fact.code = "stock-misplaced";
    fact.evidence = "the part reaches " + fixed_text(outside_mm, 1) + " mm out of the stock";
    fact.remedy = "check unit, place and file of the stock, or state that it is right with --assume stock";
  }
  return fact;
}

std::vector<StockHead> stock_heads(const std::vector<HeadBody>& heads) {
  std::vector<StockHead> all;
  for (const HeadBody& head : heads) all.emplace_back(head.surface);
  return all;
}

Witness stock_witness(const StockWitness& found, const StockHead& head, const Motion& motion) {
  const RigidTransform to_part = BodyMotion(motion).at(found.t);
  Witness witness;
  witness.t = found.t;
  witness.point = found.point;
  witness.normal = -to_part.direction(head.outward(to_part.inverse().point(found.point)));
  witness.body = Body::head;
  witness.against = Against::stock;
  return witness;
}

Witness stock_witness(const StockWitness& found, Body of, const CompiledTool& body, const Motion& motion) {
  Witness witness;
  witness.t = found.t;
  witness.point = found.point;
  witness.normal = -outward_of(body, motion.at(found.t), found.point);  // the tool leaves the point soonest
  witness.body = of;
  witness.against = Against::stock;
  return witness;
}

StockResult settle_stock(const Toolpath& path, const CheckSetup& setup, CheckResult& result,
                         const ProgressCall& progress) {
  const StockSetup& stock = *setup.stock;
  const StockHistory programs(path, setup.options.law, stock);
  const CutHistory& history = programs.of_path();
  StockResult found = check_stock(history, stock.solid, stock.options, setup.options.threads, progress);
  result.stock = StockFacts{stock.options.tolerance_mm, stock.options.resolution_mm, 0, 0, {}};
  if (stock.excess) result.excess = excess_facts(history, stock, setup, progress);
  Settling settling(path, history, result);
  const auto is_left_out = [&](std::size_t i) { return result.verdicts[i].reason.is(Reason::Kind::rapid_skipped); };
  std::size_t met = 0;
  for (const StockFinding& finding : found.findings) {
    if (is_left_out(finding.move)) continue;
    settling.enter(finding);
    ++met;
  }
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (is_left_out(i)) continue;
    if (found.is_examined[i]) {
      ++result.stock->examined;
    } else {
      settling.leave_open(i);
    }
  }
  result.stock->clear = result.stock->examined - met;
  return found;
}

}  // namespace gouge
