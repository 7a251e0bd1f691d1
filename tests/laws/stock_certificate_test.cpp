// Certificates about remaining stock, of random programs: accepted as they are; where a proof is still accepted after the
// program, the claim or the proof has changed, no point of the stock contradicts it. GOUGE_STOCK_PROOFS sets how many programs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <memory>

#include "lib/stock/check_stock.h"
#include "lib/tool/evaluate.h"
#include "lib/verify/certificate.h"
#include "tests/lib/stock/block.h"
#include "tests/support/scatter.h"

namespace gouge::stock_certificate_test {
namespace {

const std::string kInputs(64, 'a');
constexpr int kInstants = 60;
constexpr std::size_t kPointsOfChange = 60;

std::size_t wanted_programs() {
  const char* const given = std::getenv("GOUGE_STOCK_PROOFS");
  return given == nullptr ? 16 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// A program in a block, and what its check claims.
struct Case {
  Case(test::Scatter& scatter, bool is_five_axis)
      : tool(tools()[scatter.below(tools().size())]), path(block::random_program(scatter, is_five_axis, 24)) {
    const StockSolid solid = StockSolid::box(low, high);
    const std::vector<StockTool> all{{&tool, true}};
    const CutHistory history(path, law, all, options);
    const StockResult result = check_stock(history, solid, options, 1);
    depths.assign(path.moves.size(), options.tolerance_mm + options.resolution_mm);
    for (const StockFinding& finding : result.findings) {
      depths[finding.move] = std::nullopt;
      if (!finding.witness) continue;
      depths[finding.move] = finding.depth_upper_mm;
      witnesses.push_back({finding.move, finding.witness->depth_mm});
    }
  }

  static const std::vector<ToolVariants>& tools() {
    static const std::vector<ToolVariants> kTools = block::small_tools();
    return kTools;
  }
  [[nodiscard]] ClaimedStock stock() const {
    ClaimedStock claimed;
    claimed.low = low;
    claimed.high = high;
    claimed.tolerance_mm = options.tolerance_mm;
    claimed.resolution_mm = options.resolution_mm;
    claimed.programs.push_back({ClaimedScene{path, {&tool}, {}, {}, {}}, {&tool}, {true}});
    return claimed;
  }
  [[nodiscard]] MadeCertificate certificate(unsigned threads = 1) const {
    const ClaimedStock claimed = stock();
    const StockClaims claims(claimed, depths);
    return make_certificate(scene(threads), surface_claims(), kInputs, {}, &claims);
  }
  [[nodiscard]] Result<CertificateReading> verify(std::string_view bytes) const {
    const ClaimedStock claimed = stock();
    const StockClaims claims(claimed, depths);
    const ClaimedScene of = scene(1);
    return verify_certificate(of, SceneOrders(of), surface_claims(), kInputs, "proofs.gcp", bytes, {}, &claims);
  }
  [[nodiscard]] ClaimedScene scene(unsigned threads) const {
    ClaimedScene of{path, {&tool}, {}, {}, {}};
    of.threads = threads;
    return of;
  }
  [[nodiscard]] std::vector<MoveClaim> surface_claims() const { return std::vector<MoveClaim>(path.moves.size()); }

  struct Witness {
    std::size_t move = 0;
    double depth_mm = 0;
  };
  const ToolVariants& tool;
  Toolpath path;
  MotionLaw law;
  StockOptions options;
  Vec3 low{-15, -15, -15}, high{15, 15, 0};
  StockDepths depths;
  std::vector<Witness> witnesses;
};

bool is_cutting(const Move& move) { return move.kind != MoveKind::rapid && move.has_start; }

/// Returns how deep a point is in the body that must be clear on a move, at some instants at which it is farther than the
/// resolution from every place that the cutter took before.
double depth_at(const Case& of, std::size_t wanted, const Vec3& point) {
  double nearest = 1e9, deepest = 0;
  for (std::size_t i = 0; i <= wanted; ++i) {
    const Motion motion = of.law.of(of.path, i);
    const bool cuts = is_cutting(of.path.moves[i]);
    const CompiledTool& body = cuts ? of.tool.non_cutting : of.tool.bare;
    const double way = motion.path_length_mm(0, 1, 0) + motion.turn_rad() * 80;
    for (int n = 0; n <= kInstants; ++n) {
      const Pose pose = motion.at(static_cast<double>(n) / kInstants);
      if (i == wanted && nearest > of.options.resolution_mm)
        deepest = std::max(deepest, -signed_distance_mm(body, pose, point));
      // Between two instants the cutter may be nearer by half of the way between them.
      if (cuts) nearest = std::min(nearest, signed_distance_mm(of.tool.cutting, pose, point) - 0.5 * way / kInstants);
    }
  }
  return deepest;
}

/// Returns a random point of the stock, half of the points in the tool on this move.
Vec3 point_near(const Case& of, std::size_t move, test::Scatter& scatter) {
  Vec3 point = scatter.point(15);
  if (scatter.is(0.8)) {
    const Pose pose = of.law.of(of.path, move).at(scatter.in(0, 1));
    const double z = scatter.in(0, 25), r = scatter.in(0, 8);
    point = pose.tip + z * pose.axis + r * pose.axis.cross(scatter.direction()).normalized();
  }
  const Vec3 inset = Vec3::Constant(of.options.resolution_mm);
  return point.cwiseMax(of.low + inset).cwiseMin(of.high - inset);
}

/// Changes the program or the stock, so that some claims may not be true any more.
void change(Case& of, test::Scatter& scatter) {
  Move& move = of.path.moves[1 + scatter.below(of.path.moves.size() - 1)];
  switch (scatter.below(5)) {
    case 0:
      move.kind = move.kind == MoveKind::rapid ? MoveKind::feed : MoveKind::rapid;
      break;
    case 1:
      move.end.tip += scatter.point(3);
      break;
    case 2:
      move.end.axis = Vec3((move.end.axis + scatter.point(0.3)).normalized());
      break;
    case 3:
      of.high.z() += scatter.in(0, 3);
      break;
    default:
      for (Move& each : of.path.moves) each.kind = scatter.is(0.2) ? MoveKind::rapid : each.kind;
  }
}

TEST(StockCertificate, IsAcceptedAsItIsAtAnyNumberOfThreads) {
  test::Scatter scatter(4711);
  std::size_t clear = 0, open = 0, findings = 0;
  for (std::size_t k = 0; k < wanted_programs(); ++k) {
    const Case of(scatter, k % 2 == 1);
    const MadeCertificate made = of.certificate();
    EXPECT_EQ(made.bytes, of.certificate(2).bytes);
    const auto read = of.verify(made.bytes);
    ASSERT_TRUE(read.has_value()) << read.error().message;
    for (const ProofRefutation& r : read->refuted)
      ADD_FAILURE() << "program " << k << ", move " << r.move << ": " << r.what;
    for (std::size_t i = 0; i < of.depths.size(); ++i) {
      const bool is_clear = of.depths[i] && *of.depths[i] <= of.options.tolerance_mm + of.options.resolution_mm;
      clear += is_clear ? 1U : 0U;
      open += is_clear && read->of_move_in_stock[i] != ProofState::proved ? 1U : 0U;
    }
    findings += of.witnesses.size();
  }
  std::cout << clear << " clear moves, " << open << " of them without a proof; " << findings << " findings\n";
  EXPECT_GT(clear, 10 * wanted_programs());
  EXPECT_GT(findings, wanted_programs());
  EXPECT_LE(open * 20, clear);
}

TEST(StockCertificate, ProvesNoBoundBelowAWitness) {
  test::Scatter scatter(4712);
  std::size_t tried = 0;
  for (std::size_t k = 0; k < wanted_programs(); ++k) {
    Case of(scatter, k % 2 == 1);
    std::vector<std::size_t> moves;
    of.depths.assign(of.path.moves.size(), std::nullopt);
    for (const Case::Witness& witness : of.witnesses) {
      // The proof takes cutters as wider, and the stock as smaller, by the resolution.
      const double claimed = witness.depth_mm - 2.5 * of.options.resolution_mm;
      if (claimed < of.options.tolerance_mm) continue;
      of.depths[witness.move] = claimed;
      ++tried;
    }
    EXPECT_EQ(of.certificate().stock.proved, 0U) << "program " << k;
  }
  EXPECT_GT(tried, wanted_programs());
}

TEST(StockCertificate, IsTrueOfEveryProgramForWhichItIsAccepted) {
  test::Scatter scatter(4713);
  std::size_t refuted = 0, accepted = 0, deep = 0;
  for (std::size_t k = 0; k < wanted_programs(); ++k) {
    const Case honest(scatter, k % 2 == 1);
    const std::string bytes = honest.certificate().bytes;
    for (int n = 0; n < 8; ++n) {
      Case of = honest;
      change(of, scatter);
      const auto read = of.verify(bytes);
      ASSERT_TRUE(read.has_value()) << read.error().message;
      refuted += read->refuted.empty() ? 0U : 1U;
      for (std::size_t i = 0; i < of.depths.size(); ++i) {
        if (read->of_move_in_stock[i] != ProofState::proved || scatter.is(0.5)) continue;
        ++accepted;
        for (std::size_t p = 0; p < kPointsOfChange; ++p) {
          const double depth = depth_at(of, i, point_near(of, i, scatter));
          deep += depth > 0 ? 1U : 0U;
          EXPECT_LE(depth, *of.depths[i] + 1e-5) << "program " << k << ", change " << n << ", move " << i;
        }
      }
    }
  }
  std::cout << refuted << " refuted, " << accepted << " moves accepted after a change, " << deep
            << " points in a body\n";
  EXPECT_GT(refuted, wanted_programs());
  EXPECT_GT(accepted, 10 * wanted_programs());
  EXPECT_GT(deep, wanted_programs());
}

TEST(StockCertificate, BelongsToResultsWithStock) {
  test::Scatter scatter(4714);
  const Case of(scatter, false);
  const std::string bytes = of.certificate().bytes;
  const ClaimedScene scene = of.scene(1);
  const auto without =
      verify_certificate(scene, SceneOrders(scene), of.surface_claims(), kInputs, "proofs.gcp", bytes, {});
  ASSERT_FALSE(without.has_value());
  EXPECT_EQ(without.error().code, "certificate-invalid");
  EXPECT_NE(without.error().message.find("the result has no stock"), std::string::npos) << without.error().message;
  const MadeCertificate plain = make_certificate(scene, of.surface_claims(), kInputs, {});
  const auto with = of.verify(plain.bytes);
  ASSERT_FALSE(with.has_value());
  EXPECT_NE(with.error().message.find("no proofs about stock"), std::string::npos) << with.error().message;
}

}  // namespace
}  // namespace gouge::stock_certificate_test
