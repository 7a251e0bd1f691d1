#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>

#include "lib/check/verdict_bytes.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// A check whose stretches are kept, taken from an earlier run in part or in whole, states to the bit what one states that
// knows nothing of stretches: also of events, chains of free points, links and overcuts that cross their borders.

namespace gouge::kept_check_test {
namespace {

constexpr std::size_t kStretch = 256;  // the least there is: moves share bounds by so many

class InMemory : public CheckpointStore {
 public:
  [[nodiscard]] std::size_t items() const override { return 1; }
  [[nodiscard]] std::optional<std::string> find(std::string_view stage, std::size_t stretch) override {
    const auto found = all.find({std::string(stage), stretch});
    if (found == all.end()) return std::nullopt;
    ++taken;
    return found->second;
  }
  void keep(std::string_view stage, std::size_t stretch, std::string_view bytes) override {
    all[{std::string(stage), stretch}] = bytes;
  }

  std::map<std::pair<std::string, std::size_t>, std::string> all;
  std::size_t taken = 0;
};

std::string text_of(const CheckResult& result) {
  std::string text = std::to_string(result.evaluations) + " " + std::to_string(result.worst_move) + " ";
  append_bytes(result.worst_overcut_mm, text);
  for (const MoveVerdict& verdict : result.verdicts) append_bytes(verdict, text);
  for (const Event& e : result.events) {
    for (const std::size_t n : {e.first_move, e.last_move, e.worst_move, e.moves, e.tool})
      text += std::to_string(n) + " ";
    text += std::string(state_name(e.state)) + body_name(e.body) + against_name(e.against) + "\n";
  }
  return text;
}

/// Passes over a block, with a dive over the first border, two tools, positions alone (linked and not) at a border, moves
/// that are not checked, and a tool inside the block from one border to the next.
Toolpath varied_path() {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < 5 * kStretch + 17; ++i) {
    const double x = 0.02 * static_cast<double>(i);
    const double dive = i > kStretch - 20 && i < kStretch + 30 ? 0.5 : 0;
    poses.push_back({Vec3(x, std::sin(x), 0.2 - dive), Vec3(0.1 * std::sin(3 * x), 0, 1).normalized()});
  }
  for (std::size_t i = 3 * kStretch - 3; i < 4 * kStretch + 3; ++i) poses[i].tip.z() = -60;
  Toolpath path = paths::through(poses);
  path.tools.resize(2);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    Move& move = path.moves[i];
    move.tool = i < 2 * kStretch + 5 ? 0 : 1;
    if (i % 97 == 0) move.kind = MoveKind::rapid;
    if (i % 301 == 300) move.not_checked_reason = "an arc";
  }
  for (const std::size_t i : {2 * kStretch, 2 * kStretch + 5, 5 * kStretch}) path.moves[i].has_start = false;
  path.moves[5 * kStretch].is_linked = true;
  return path;
}

class CheckpointedCheck : public ::testing::Test {
 protected:
  CheckResult run(CheckpointStore* kept, unsigned threads = 2) {
    CheckOptions options;
    options.threads = threads;
    options.near_miss_mm = 0.15;
    std::vector<HeadBody> heads;
    if (has_head_) heads.push_back(*build_head_body(shapes::box(Vec3(20, -2, 62), Vec3(24, 2, 100))));
    const OwnSetup own(&tool_, scene_, options, heads);
    CheckSetup setup = own.setup;
    setup.tools = {&tool_, &other_};
    setup.kept = kept;
    return check(path_, setup);
  }

  void expect_same() {
    const CheckResult plain = run(nullptr);
    const std::string expected = text_of(plain);
    EXPECT_GT(plain.counts.gouge, 0U);
    EXPECT_GT(plain.counts.not_checked, 0U);
    InMemory kept;
    EXPECT_TRUE(text_of(run(&kept)) == expected);
    EXPECT_EQ(kept.taken, 0U);
    const std::size_t stretches = kept.all.size();
    EXPECT_GE(stretches, 6U);
    EXPECT_TRUE(text_of(run(&kept, 1)) == expected);
    EXPECT_EQ(kept.taken, stretches);
    // Whatever was done when it was interrupted.
    for (std::size_t lost = 0; lost < stretches; ++lost) {
      InMemory interrupted;
      std::size_t k = 0;
      for (const auto& [name, bytes] : kept.all) {
        if (k++ < lost) interrupted.all[name] = bytes;
      }
      EXPECT_TRUE(text_of(run(&interrupted)) == expected) << lost;
    }
    for (auto& [name, bytes] : kept.all) bytes.resize(bytes.size() / 2);
    EXPECT_TRUE(text_of(run(&kept)) == expected);
  }

  bool has_head_ = false;
  Toolpath path_ = varied_path();
  ToolVariants tool_ = tools::ball(10), other_ = tools::ball(4);
  Scene scene_{{shapes::box(Vec3(-50, -50, -300), Vec3(80, 50, 0))}, {}};
};

TEST_F(CheckpointedCheck, SaysWhatAnUndisturbedOneSays) { expect_same(); }

TEST_F(CheckpointedCheck, SaysItOfHeadsToo) {
  has_head_ = true;
  expect_same();
}

TEST_F(CheckpointedCheck, SaysItInAnOpenMeshWhereThePathAloneTellsInsideFromOutside) {
  IndexedMesh& mesh = scene_.parts[0];
  mesh.triangles.pop_back();
  mesh.file_triangle.pop_back();
  expect_same();
}

TEST_F(CheckpointedCheck, HasAnEventOverABorder) {
  InMemory kept;
  const CheckResult result = run(&kept);
  bool is_any_over = false;
  for (const Event& event : result.events) is_any_over |= event.first_move < kStretch && event.last_move > kStretch;
  EXPECT_TRUE(is_any_over);
}

}  // namespace
}  // namespace gouge::kept_check_test
