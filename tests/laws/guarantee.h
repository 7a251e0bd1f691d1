#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <memory>
#include <vector>

#include "cli/job/job.h"
#include "lib/certify/check.h"
#include "tests/support/reference.h"

// The guarantee of docs/method/guarantee.md compared with a checked job: every witness by own arithmetic, every depth_upper
// against the reference. Header only.

namespace gouge::guarantee {

inline Job load(const JobArguments& arguments) {
  const Result<JobOptions> options = understand(arguments);
  EXPECT_TRUE(options.has_value());
  Progress progress(std::cerr, ProgressMode::never);
  LoadedJob loaded = load_job(arguments, *options, progress);
  for (const Diagnostic& d : loaded.errors) ADD_FAILURE() << d.message;
  return loaded.job ? std::move(*loaded.job) : Job{};
}

inline CheckResult check_job(const Job& job) {
  const PreparedScene scene = prepare_scene(job.scene());
  return check(job.toolpath, job.setup(scene));
}

struct Contours {
  reference::Contour part, fixture;
  explicit Contours(const ToolVariants& variants) : part(variants.against_part), fixture(variants.against_fixture) {}
  [[nodiscard]] const reference::Contour& against(Against a) const { return a == Against::part ? part : fixture; }
};

/// Reason to reject a witness; empty when there is none.
inline std::vector<std::string> uncertainties(const Witness& w, double depth_mm, const reference::Movement& movement,
                                              const Contours& tool, const Scene& scene) {
  constexpr double kSlack_mm = 1e-6;
  std::vector<std::string> all;
  const auto uncertainty = [&all](const std::string& what, double value) {
    all.push_back(what + ": " + std::to_string(value));
  };
  const reference::Contour& contour = tool.against(w.against);
  const Pose pose = movement.at(w.t);
  const double depth = contour.depth(pose, w.point);
  if (!(std::abs(depth - depth_mm) <= kSlack_mm)) uncertainty("the point is deep", depth);
  if (!(w.t >= 0 && w.t <= 1)) uncertainty("t is not of the move", w.t);
  if (!(std::abs(w.normal.norm() - 1) <= 1e-12)) uncertainty("length of the normal", w.normal.norm());
  const double left = contour.depth({pose.tip + depth_mm * w.normal, pose.axis}, w.point);
  if (!(left <= kSlack_mm)) uncertainty("deep after giving way by the depth", left);
  const double half = contour.depth({pose.tip + 0.5 * depth_mm * w.normal, pose.axis}, w.point);
  if (!(std::abs(half - 0.5 * depth_mm) <= kSlack_mm)) uncertainty("deep after giving way by half the depth", half);
  const Vec3 d = w.point - pose.tip;
  const double away = contour.distance_to(w.body, d.cross(pose.axis).norm(), d.dot(pose.axis));
  if (!(std::abs(away - depth_mm) <= kSlack_mm)) uncertainty("the named body is away", away);
  const auto& meshes = w.against == Against::part ? scene.parts : scene.fixtures;
  if (w.mesh >= meshes.size()) return {"the mesh does not exist"};
  const IndexedMesh& mesh = meshes[w.mesh];
  const auto found = std::find(mesh.file_triangle.begin(), mesh.file_triangle.end(), w.triangle);
  if (found == mesh.file_triangle.end()) return {"the triangle does not exist"};
  const auto t = static_cast<std::size_t>(found - mesh.file_triangle.begin());
  const double off = reference::distance_to_triangle(w.point, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  if (!(off <= 1e-9 * (1 + w.point.norm()))) uncertainty("the point is off its triangle", off);
  return all;
}

inline bool is_bounded(const MoveVerdict& v) {
  return v.state != MoveState::not_checked && v.state != MoveState::buried;
}

/// Every witness, and every state against its numbers.
inline void expect_witnesses(const Job& job, const CheckResult& result) {
  const CheckOptions& options = job.options.check;
  std::map<std::size_t, std::unique_ptr<Contours>> tools;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const MoveVerdict& v = result.verdicts[i];
    if (!is_bounded(v)) continue;
    const Move& move = job.toolpath.moves[i];
    auto& contours = tools[move.tool];
    if (!contours) contours = std::make_unique<Contours>(*job.variants[move.tool]);
    EXPECT_LE(v.depth_mm, v.depth_upper_mm) << "move " << i;
    EXPECT_EQ(v.depth_mm > 0, v.witness.has_value()) << "move " << i;
    if (v.state == MoveState::gouge) {
      EXPECT_GT(v.depth_mm, options.tolerance_mm) << "move " << i;
      EXPECT_LE(v.depth_upper_mm - v.depth_mm, options.resolution_mm) << "move " << i;
    }
    if (v.state == MoveState::clean) {
      EXPECT_LE(v.depth_upper_mm, options.tolerance_mm + options.resolution_mm) << "move " << i;
    }
    if (!v.witness) continue;
    const reference::Movement movement = reference::movement(job.toolpath, i);
    for (const std::string& d : uncertainties(*v.witness, v.depth_mm, movement, *contours, job.scene())) {
      ADD_FAILURE() << "line " << move.line << ", move " << i << ", told " << v.depth_mm << " mm: " << d;
    }
  }
}

/// At most `count` of them, evenly spread.
inline std::vector<std::size_t> spread(const std::vector<std::size_t>& all, std::size_t count) {
  if (all.size() <= count) return all;
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(all[k * all.size() / count]);
  return some;
}

/// The reference never finds more than depth_upper. That it would if there were more is seen by what it finds on
/// gouging moves: nearly always the reported depth itself.
inline void expect_nothing_deeper(const Job& job, const CheckResult& result, std::size_t count = 60) {
  std::vector<std::size_t> gouging, others;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    if (!is_bounded(result.verdicts[i])) continue;
    (result.verdicts[i].state == MoveState::gouge ? gouging : others).push_back(i);
  }
  std::vector<std::size_t> looked = spread(gouging, count);
  for (const std::size_t i : spread(others, count)) looked.push_back(i);
  std::size_t gouges = 0, seen = 0;
  for (const std::size_t i : looked) {
    const MoveVerdict& v = result.verdicts[i];
    const bool is_gouge = v.state == MoveState::gouge;
    const Move& move = job.toolpath.moves[i];
    const Contours contours(*job.variants[move.tool]);
    const reference::Found found =
        reference::deepest(contours.part, contours.fixture, reference::movement(job.toolpath, i), job.scene(),
                           is_gouge ? v.depth_mm - 0.005 : v.depth_upper_mm);
    gouges += is_gouge ? 1 : 0;
    seen += is_gouge && found.depth_mm > v.depth_mm - 0.001 ? 1 : 0;
    EXPECT_LE(found.depth_mm, v.depth_upper_mm + 1e-9)
        << "line " << move.line << ", move " << i << " (" << state_name(v.state) << ", depth " << v.depth_mm << "): t "
        << found.t << " at " << found.point.transpose();
  }
  EXPECT_GE(seen * 10, gouges * 9) << "the reference is too weak: it saw " << seen << " of " << gouges << " gouges";
}

}  // namespace gouge::guarantee
