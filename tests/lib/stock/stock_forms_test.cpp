// Remaining stock after whole operations whose result is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/lib/stock/block.h"
#include "tests/support/scatter.h"

namespace gouge::stock_forms_test {
namespace {

using block::append;
using block::flat;
using block::kFeed;
using block::kRapid;
using block::path_of;
using block::run;
using block::Step;
using paths::upright;

constexpr double kResolution_mm = 0.05;

/// Expects one finding, for a move, whose bounds enclose a depth.
void expect_depth(const StockResult& result, std::size_t move, double exact_mm) {
  ASSERT_EQ(result.findings.size(), 1U);
  const StockFinding& finding = result.findings.front();
  EXPECT_EQ(finding.move, move);
  ASSERT_TRUE(finding.witness.has_value());
  EXPECT_LE(finding.witness->depth_mm, exact_mm + 1e-6);
  EXPECT_GE(finding.depth_upper_mm, exact_mm - 1e-6);
  EXPECT_LE(finding.depth_upper_mm - finding.witness->depth_mm,
            std::max(0.1 * exact_mm, 5 * kResolution_mm) + 2 * kResolution_mm);
}

/// A helix about the Z axis from the face of the block, with a full circle at its end.
Toolpath helix(double radius, double depth, int turns) {
  Toolpath path = path_of({{kRapid, upright(radius, 0, 10)},
                           {kFeed, upright(radius, 0, 0)},
                           {kFeed, upright(radius, 0, -depth)},
                           {kFeed, upright(radius, 0, -depth)},
                           {kRapid, upright(radius, 0, 20)}});
  for (const auto& [move, sweep] : {std::pair<std::size_t, double>(2, turns), std::pair<std::size_t, double>(3, 1)}) {
    path.moves[move].kind = MoveKind::arc;
    path.moves[move].curve_kind = CurveKind::arc;
    path.moves[move].curve = path.arcs.size();
    path.arcs.push_back({Vec3::Zero(), Vec3::UnitZ(), sweep * 2 * std::numbers::pi});
  }
  return path;
}

TEST(StockForms, AHelixOpensAHoleOfItsRadiusAndThatOfItsCutter) {
  // The shank is as wide as the flutes and follows the hole that the helix has opened above it.
  const ToolVariants cutter = flat(10, 6, 10, 30);
  EXPECT_TRUE(run(helix(4, 20, 8), {cutter}).findings.empty());
  for (const auto& [diameter, depth, exact] :
       {std::tuple(17.6, 19.99, 0.0), std::tuple(18.6, 19.9, 0.3), std::tuple(17.6, 20.4, 0.4)}) {
    Toolpath path = helix(4, 20, 8);
    append({{kRapid, upright(0, 0, 30)}, {kRapid, upright(0, 0, -depth)}}, 1, path);
    const StockResult result = run(path, {cutter, flat(diameter, 30, diameter)});
    if (exact > 0)
      expect_depth(result, 6, exact);
    else
      EXPECT_TRUE(result.findings.empty()) << diameter;
  }
}

TEST(StockForms, ARampDeeperThanTheFlutesBringsTheShankIntoTheMaterialAhead) {
  const auto ramp = [](double depth) {
    return path_of({{kRapid, upright(-30, 0, 0)}, {kFeed, upright(30, 0, -depth)}});
  };
  for (const double shank : {10.0, 12.0}) {
    EXPECT_TRUE(run(ramp(6.05), {flat(10, 6, shank)}).findings.empty()) << shank;
    const StockResult result = run(ramp(10), {flat(10, 6, shank)});
    ASSERT_EQ(result.findings.size(), 1U) << shank;
    const StockFinding& finding = result.findings.front();
    EXPECT_EQ(finding.move, 1U);
    EXPECT_EQ(finding.body, Body::shank);
    // At the end the lower face of the shank is 4 mm below that of the block, with uncut material ahead.
    EXPECT_LE(finding.witness->depth_mm, 4 + 1e-9);
    EXPECT_GE(finding.depth_upper_mm, 4 - 2 * kResolution_mm);
    // The shank is 0.1 mm below the face at a depth of 6.1 mm. The material ahead begins at its own radius there.
    EXPECT_LE(finding.contact.clear_until, (6.1 + 2 * kResolution_mm) / 10);
    EXPECT_GE(finding.contact.contact_at, 6.1 / 10 - 1e-9);
  }
}

/// Circles of an adaptive pass at full depth. Their middle advances along X.
Toolpath adaptive(double radius, double step_over, double to_x) {
  Toolpath path = path_of({{kRapid, upright(-70, radius, 10)}, {kRapid, upright(-70, radius, -18)}});
  const auto add = [&](const Pose& pose, bool is_arc, double middle) {
    Move move = path.moves.back();
    move.kind = is_arc ? MoveKind::arc : kFeed;
    move.end = pose;
    move.line = path.moves.size() + 1;
    move.has_start = true;
    move.curve_kind = is_arc ? CurveKind::arc : CurveKind::none;
    move.curve = path.arcs.size();
    if (is_arc) path.arcs.push_back({Vec3(middle, 0, 0), -Vec3::UnitZ(), std::numbers::pi});
    path.moves.push_back(move);
  };
  for (double x = -70; x < to_x; x += step_over) {
    add(upright(x, -radius, -18), true, x);
    add(upright(x, radius, -18), false, 0);
    add(upright(x + step_over, radius, -18), false, 0);
  }
  return path;
}

TEST(StockForms, AFullDepthAdaptivePassClearsItsBand) {
  const ToolVariants cutter = flat(10, 20, 10);
  const Toolpath pass = adaptive(8, 0.5, 0);
  EXPECT_TRUE(run(pass, {cutter}).findings.empty());
  // The band is 26 mm wide; the arcs leave scallops of 0.0024 mm beside it.
  for (const auto& [diameter, exact] : {std::pair(25.8, 0.0), std::pair(26.8, 0.4)}) {
    Toolpath path = pass;
    append({{kRapid, upright(-90, 0, -17.9)}, {kRapid, upright(-20, 0, -17.9)}}, 1, path);
    const StockResult result = run(path, {cutter, flat(diameter, 30, diameter)});
    if (exact > 0)
      expect_depth(result, pass.moves.size() + 1, exact);
    else
      EXPECT_TRUE(result.findings.empty()) << result.findings.front().witness->depth_mm;
  }
}

TEST(StockForms, AToolOfAnotherDirectionPassesTheSlotOfTheFirst) {
  const ToolVariants cutter = flat(10, 20, 10);
  const auto lying = [](double x) { return Pose{Vec3(x, 0, -4.5), -Vec3::UnitX()}; };
  for (const auto& [diameter, exact] : {std::pair(8.0, 0.0), std::pair(9.98, 0.0), std::pair(10.8, 0.4)}) {
    Toolpath path = path_of({{kRapid, upright(-70, 0, -12)}, {kFeed, upright(70, 0, -12)}});
    append({{kRapid, lying(-60)}, {kRapid, lying(30)}}, 1, path);
    ToolAssembly along = tools::assembly(FlatCutter{diameter, 100}, diameter);
    along.holder.clear();
    const StockResult result = run(path, {cutter, tools::variants(along)});
    if (exact > 0)
      expect_depth(result, 3, exact);
    else
      EXPECT_TRUE(result.findings.empty()) << diameter;
  }
}

class TwoPrograms : public testing::Test {
 protected:
  [[nodiscard]] StockResult run_after(const Toolpath* first, const Toolpath& second) const {
    std::optional<CutHistory> earlier;
    if (first != nullptr) earlier.emplace(*first, law_, tools_, options_);
    const CutHistory history(second, law_, tools_, options_, earlier ? &*earlier : nullptr);
    StockResult result = check_stock(history, block::solid(), options_, 1);
    for (const StockFinding& finding : result.findings) {
      if (finding.nearest_cut) cut_earlier_ = finding.nearest_cut->cut.program != &history;
      if (finding.unknown) unknown_line_ = finding.unknown.program->path().moves[finding.unknown.move].line;
    }
    return result;
  }

  ToolVariants tool_ = flat(10, 20, 10);
  std::vector<StockTool> tools_{{&tool_, true}};
  MotionLaw law_;
  StockOptions options_;
  mutable bool cut_earlier_ = false;
  mutable std::size_t unknown_line_ = 0;
};

TEST_F(TwoPrograms, TheSecondSetUpPassesWhatTheFirstOneCut) {
  // From above, then with the part turned over: the tool enters the slot from below.
  const Toolpath first = path_of({{kRapid, upright(-70, 0, -15)}, {kFeed, upright(70, 0, -15)}});
  const auto below = [](double x, double y) { return Pose{Vec3(x, y, -0.5), -Vec3::UnitZ()}; };
  const Toolpath through = path_of({{kRapid, below(-80, 0)}, {kRapid, below(80, 0)}});
  EXPECT_EQ(run_after(nullptr, through).findings.size(), 1U);
  const StockResult after = run_after(&first, through);
  // Above the slot the tool is free; below it, its flutes and shank are in the block.
  ASSERT_EQ(after.findings.size(), 1U);
  Toolpath deeper = first;
  for (Move& move : deeper.moves) move.end.tip.z() = -45;
  ToolVariants longer = flat(10, 60, 10);
  tools_ = {{&longer, true}};
  EXPECT_TRUE(run_after(&deeper, through).findings.empty());
  const Toolpath beside = path_of({{kRapid, below(-80, 0.4)}, {kRapid, below(80, 0.4)}});
  const StockResult met = run_after(&deeper, beside);
  expect_depth(met, 1, 0.4);
  EXPECT_TRUE(cut_earlier_);
}

TEST_F(TwoPrograms, GiveTheResultOfOneProgramWithBoth) {
  test::Scatter scatter(91);
  std::size_t findings = 0;
  for (int k = 0; k < 40; ++k) {
    std::vector<Step> steps{{kRapid, upright(-80, 0, 20)}};
    for (int n = 0; n < 24; ++n) {
      const Vec3 tip(scatter.in(-50, 50), scatter.in(-50, 50), scatter.in(-12, 2));
      steps.push_back({scatter.below(3) == 0 ? kRapid : kFeed, {tip, Vec3::UnitZ()}});
    }
    const Toolpath whole = path_of(steps);
    const std::vector<Step> begin(steps.begin(), steps.begin() + 13), end(steps.begin() + 12, steps.end());
    const Toolpath first = path_of(begin), second = path_of(end);
    std::vector<StockFinding> expected = run_after(nullptr, whole).findings;
    std::erase_if(expected, [](const StockFinding& finding) { return finding.move < 13; });
    std::vector<StockFinding> found = run_after(&first, second).findings;
    // The first position of the second program has no motion; the tool rests where the first program left it.
    std::erase_if(found, [](const StockFinding& finding) { return finding.move == 0; });
    ASSERT_EQ(found.size(), expected.size()) << k;
    for (std::size_t n = 0; n < found.size(); ++n) {
      EXPECT_EQ(found[n].move + 12, expected[n].move);
      EXPECT_EQ(found[n].witness.has_value(), expected[n].witness.has_value());
    }
    findings += found.size();
  }
  EXPECT_GT(findings, 40U);
}

TEST_F(TwoPrograms, AnUnknownMotionOfTheFirstLeavesTheSecondOpen) {
  Toolpath first = path_of({{kRapid, upright(-70, 0, -5)}, {kFeed, upright(70, 0, -5)}});
  first.moves[1].not_checked_reason = "the tool radius compensation is on";
  const StockResult result = run_after(&first, path_of({{kRapid, upright(-70, 0, -5)}, {kRapid, upright(70, 0, -5)}}));
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_FALSE(result.findings.front().witness.has_value());
  EXPECT_EQ(unknown_line_, 2U);
}

}  // namespace
}  // namespace gouge::stock_forms_test
