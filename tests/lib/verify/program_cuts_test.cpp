#include "lib/verify/program_cuts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/verify/claimed_stock.h"
#include "tests/support/paths.h"
#include "tests/support/tools.h"

namespace gouge::program_cuts_test {
namespace {

TEST(ProgramCuts, AnswerForAPointAtExactlyTheDistanceInQuestion) {
  const ToolVariants tool = tools::flat(10);
  const Toolpath path = paths::through({paths::upright(-90, 0, -10), paths::upright(0, 0, -10)});
  ClaimedProgram program{ClaimedScene{path, {&tool}, {}, {}, {}}, {&tool}, {true}};
  const ProgramCuts cuts(program);
  for (const double within : {0.050001, -1e-6}) {
    for (const double beyond : {-1e-3, -1e-7, -1e-12, 0.0, 1e-12, 1e-7, 1e-3}) {
      const Vec3 point(-45, 5 + within + beyond, 0);
      const bool is_nearer = cuts.nearer(point, 2, within, true).has_value();
      if (std::abs(beyond) > 1e-5) {
        EXPECT_EQ(is_nearer, beyond < 0) << within << " " << beyond;
      }
    }
  }
}

// Its draws reach points whose distance from a cutter is the one in question up to the rounding of the bounds.
TEST(StockVerifier, EndsItsSearchWhereRoundingLeavesADistanceOpen) {
  ToolAssembly assembly = tools::assembly(FlatCutter{10, 30}, 10);
  assembly.shank = {{10, 10, 30}};
  assembly.holder.clear();
  const ToolVariants tool = tools::variants(assembly);
  Toolpath path = paths::through({paths::upright(-90, 0, 80), paths::upright(-90, 0, -10), paths::upright(0, 0, -10),
                                  paths::upright(0, 0, -20), paths::upright(-60, 0, -20)});
  path.moves[1].kind = MoveKind::rapid;
  ClaimedStock stock;
  stock.low = Vec3(-110, -110, -120);
  stock.high = Vec3(110, 110, 20);
  stock.tolerance_mm = 0.1;
  stock.resolution_mm = 0.05;
  stock.programs.push_back({ClaimedScene{path, {&tool}, {}, {}, {}}, {&tool}, {true}});
  const StockVerifier verifier(stock);
  EXPECT_FALSE(verifier.attack({false, false, true, true, true}, 0).found.has_value());
}

}  // namespace
}  // namespace gouge::program_cuts_test
