#include "lib/verify/claimed_stock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/number_text.h"
#include "lib/verify/claimed_pose.h"
#include "lib/verify/draws.h"
#include "lib/verify/named_cut.h"
#include "lib/verify/witness_check.h"

namespace gouge {
namespace {

constexpr double kStockExact_mm = 1e-6;  // promised accuracy of a witness
constexpr std::size_t kPlaces = 4'000, kTriesOfPoint = 24;
constexpr int kInstants = 200;  // of the move of a witness, for its own cutter

std::string length_mm(double value) { return display_text(value, 7) + " mm"; }

/// Signed distance of a point from the stock, positive inside.
double depth_in(const ClaimedStock& stock, const Vec3& point) {
  if (stock.solids.empty()) return std::min((point - stock.low).minCoeff(), (stock.high - point).minCoeff());
  double deepest = -std::numeric_limits<double>::infinity();
  for (const SolidDepth& solid : stock.solids) {
    const double inside = solid.at(point);
    deepest = std::max(deepest, stock.allowance_mm + (inside > 0 ? inside : -solid.distance_to_surface(point)));
  }
  return deepest;
}

}  // namespace

StockVerifier::StockVerifier(const ClaimedStock& stock)
    : stock_(stock), programs_(std::make_unique<const CutPrograms>(stock.programs)) {}
StockVerifier::~StockVerifier() = default;

std::optional<std::string> StockVerifier::nearer(const Vec3& point, std::size_t before, double within_mm,
                                                 bool counts_unknown) const {
  for (std::size_t k = 0; k < programs_->size(); ++k) {
    const ProgramCuts& program = programs_->at(k);
    const bool is_last = k + 1 == programs_->size();
    const auto cut = program.nearer(point, is_last ? before : program.path().moves.size(), within_mm, counts_unknown);
    if (!cut) continue;
    const std::string line = "line " + std::to_string(std::size_t{program.path().moves[*cut].line});
    return is_last ? line : line + " of " + program.path().file;
  }
  return std::nullopt;
}

std::optional<std::string> StockVerifier::find_fault(std::size_t move, const MoveClaim& claim) const {
  if (!claim.witness) return "it has no witness";
  const ClaimedWitness& w = *claim.witness;
  if (!(w.t >= 0 && w.t <= 1) || !w.point.allFinite()) return "its instant is not of the move, or its point is none";
  const ProgramCuts& program = programs_->last();
  if (!program.is_known(move)) return "the motion or the tool of its move is not known";
  if (claim.depth_upper_mm && claim.depth_mm > *claim.depth_upper_mm) return "its depth is more than its bound";
  if (!(claim.depth_mm > stock_.tolerance_mm)) return "its depth is no more than the tolerance of the stock";
  const double in_stock = depth_in(stock_, w.point);
  if (in_stock < -kStockExact_mm) return "its point is " + length_mm(-in_stock) + " outside of the stock";
  if (auto wrong = find_wrong_depth(move, claim)) return wrong;
  const CutterForms& forms = *program.forms_of(move);
  if (const auto cut = nearer(w.point, move, -kStockExact_mm, false))
    return "the cutter of " + *cut + " was there before";
  for (int k = 0; k <= kInstants && program.cuts(move); ++k) {
    const Pose pose = claimed_pose(program.scene(), move, w.t * k / kInstants);
    if (forms.cutting.nearest(in_tool(pose, w.point)).signed_distance_mm < -kStockExact_mm)
      return "the cutter of its own move was there before";
  }
  return std::nullopt;
}

std::optional<std::string> StockVerifier::find_wrong_depth(std::size_t move, const MoveClaim& claim) const {
  const ClaimedWitness& w = *claim.witness;
  const ProgramCuts& program = programs_->last();
  std::vector<double> depths;
  if (w.body == Body::head) {
    const Vec3 at = head_frame(program.scene(), move, w.t, w.turn).inverse().point(w.point);
    for (const SolidDepth& head : stock_.heads) depths.push_back(head.at(at));
    if (depths.empty()) return "it names a head, and there is none";
  } else {
    const ToolContour& body = program.body_of(move);
    depths.push_back(
        -body.nearest(in_tool(claimed_pose(program.scene(), move, w.t, w.turn), w.point)).signed_distance_mm);
  }
  const auto is_as_said = [&](double depth) {
    const bool is_less = depth + kStockExact_mm<claim.depth_mm, is_more = depth> claim.depth_mm + kStockExact_mm;
    return !is_less && (!is_more || stock_.is_motion_open);
  };
  if (std::ranges::any_of(depths, is_as_said)) return std::nullopt;
  return "the point is " + length_mm(std::ranges::max(depths)) + " deep, and said to be " + length_mm(claim.depth_mm);
}

std::optional<StockVerifier::Draw> StockVerifier::draw_in_tool(std::size_t move, double t, double least_mm,
                                                               Draws& draws) const {
  const ProgramCuts& program = programs_->last();
  const ToolContour& body = program.body_of(move);
  const Pose pose = claimed_pose(program.scene(), move, t);
  const Vec3 x = pose.axis.unitOrthogonal(), y = pose.axis.cross(x);
  const double size = body.size_mm(), angle = 2 * std::numbers::pi * draws.share();
  Vec2 q(size * draws.share(), size * draws.share());
  const ToolContour::Nearest nearest = body.nearest(q);
  // Half of the points are as near to the boundary as a claim is about: there the last remains of a cut are.
  if (draws.below(2) == 0) q = nearest.foot - (least_mm + kStockExact_mm) * nearest.normal;
  const double depth = -body.nearest(q).signed_distance_mm;
  if (q.x() < 0 || depth < least_mm) return std::nullopt;
  return Draw{pose.tip + q.x() * (std::cos(angle) * x + std::sin(angle) * y) + q.y() * pose.axis, depth};
}

std::optional<StockVerifier::Draw> StockVerifier::draw_in_head(const SolidDepth& head, std::size_t move, double t,
                                                               double least_mm, Draws& draws) const {
  const IndexedMesh& mesh = head.mesh();
  Vec3 q;
  for (int k = 0; k < 3; ++k) q[k] = head.box().min()[k] + draws.share() * head.box().sizes()[k];
  if (draws.below(2) == 0) {
    const std::size_t triangle = draws.below(mesh.triangles.size());
    const Vec3 a = mesh.corner(triangle, 0), u = mesh.corner(triangle, 1) - a, v = mesh.corner(triangle, 2) - a;
    const double along = draws.share(), across = draws.share() * (1 - along);
    q = a + along * u + across * v - (least_mm + kStockExact_mm) * u.cross(v).normalized();
  }
  const double depth = head.at(q);
  if (depth < least_mm) return std::nullopt;
  return Draw{head_frame(programs_->last().scene(), move, t).point(q), depth};
}

AttackResult StockVerifier::attack(const std::vector<bool>& is_clear, double seconds) const {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  const ProgramCuts& program = programs_->last();
  std::vector<std::size_t> moves;
  for (std::size_t i = 0; i < is_clear.size(); ++i)
    if (is_clear[i] && program.is_known(i)) moves.push_back(i);
  AttackResult result;
  result.moves = moves.size();
  const double least_mm = stock_.tolerance_mm + stock_.resolution_mm + kStockExact_mm;
  Draws draws;
  const auto is_over = [&] {
    return seconds > 0 ? std::chrono::duration<double>(Clock::now() - began).count() >= seconds
                       : result.samples >= kPlaces;
  };
  std::size_t looks_per_head = 2;  // the time of each query of a head is linear in its facets
  for (const SolidDepth& head : stock_.heads) looks_per_head += head.mesh().triangles.size() / 100;
  while (!moves.empty() && !is_over() && !result.found) {
    ++result.samples;
    const std::size_t move = moves[draws.below(moves.size())];
    const bool cuts = program.cuts(move);
    const bool has_head = !stock_.heads.empty() && draws.below(looks_per_head) == 0;
    const SolidDepth* const head = has_head ? &stock_.heads[draws.below(stock_.heads.size())] : nullptr;
    if (head == nullptr && program.body_of(move).empty()) continue;
    const double t = program.path().moves[move].has_start ? draws.share() : 1;
    for (std::size_t k = 0; k < kTriesOfPoint; ++k) {
      const std::optional<Draw> drawn =
          head != nullptr ? draw_in_head(*head, move, t, least_mm, draws) : draw_in_tool(move, t, least_mm, draws);
      if (!drawn || depth_in(stock_, drawn->point) < stock_.resolution_mm + kStockExact_mm) continue;
      // The move itself counts with all of its time.
      if (nearer(drawn->point, cuts ? move + 1 : move, stock_.resolution_mm + kStockExact_mm, true)) break;
      result.found = Counterexample{move, t, drawn->point,
                                    "stock is left " + length_mm(drawn->depth_mm) + " deep in a " +
                                        (head != nullptr ? "head" : "body of the tool")};
      break;
    }
  }
  return result;
}

}  // namespace gouge
