// The two bounds of overcut on random gouging moves of every kind, with tools of every shape and heads, in closed
// meshes: against points that are looked for by own arithmetic, and every lower bound at the point it was realised at.
// GOUGE_OVERCUTS sets how many gouging moves, GOUGE_SEED which, GOUGE_STREAM examines one stream of a failure again.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>

#include "lib/check/overcut_gap.h"
#include "lib/motion/motion_law.h"
#include "lib/overcut/overcut_search.h"
#include "lib/overcut/swept_solid.h"
#include "lib/overcut/swept_tool.h"
#include "lib/verify/solid_depth.h"
#include "tests/laws/machine_moves.h"
#include "tests/laws/random_moves.h"
#include "tests/support/reference_hunt.h"
#include "tests/support/whole_check.h"

namespace gouge::overcut_law_test {
namespace {

constexpr double kRounding_mm = 1e-6;
constexpr int kStarts = 8, kSteps = 80;

std::size_t number_from(const char* variable, std::size_t otherwise) {
  const char* given = std::getenv(variable);
  return given == nullptr ? otherwise : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// A solid's surface by its triangles alone; where shells may meet, by the winding numbers on both sides of them.
class PlainPart {
 public:
  PlainPart(const IndexedMesh& mesh, bool has_shells) : mesh_(mesh) {
    if (has_shells) depth_.emplace(mesh);
  }

  [[nodiscard]] double distance(const Vec3& p) const {
    if (depth_) return depth_->at(p);
    double least = 1e300;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      least = std::min(least,
                       reference::distance_to_triangle(p, mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)));
    }
    return least;
  }
  [[nodiscard]] bool has_inside(const Vec3& p) const { return reference::solid_angle_share(mesh_, p) > 0.5; }
  [[nodiscard]] const IndexedMesh& mesh() const { return mesh_; }

 private:
  const IndexedMesh& mesh_;
  std::optional<SolidDepth> depth_;
};

struct Deepest {
  double depth_mm = 0, t = 0;
  Vec3 point = Vec3::Zero();
};

/// Looks for a point of what moves that is deep below the surface: from random points under random triangles, and from
/// `start`, by random steps that stay in both and lead deeper.
template <class Moving>
Deepest look_for_deepest(const Moving& moving, const PlainPart& part, const Deepest& start, test::Scatter& random) {
  Deepest best = start;
  const double size = part.mesh().box().diagonal().norm();
  const auto climb = [&](Deepest at) {
    double step = 0.05 * size;
    for (int k = 0; k < kSteps; ++k) {
      const double t = random.is(0.5) ? at.t : std::clamp(at.t + random.in(-0.2, 0.2) * step / size * 20, 0.0, 1.0);
      const Vec3 point = at.point + random.in(0, step) * random.direction();
      const bool is_deeper = moving.depth(moving.frame(t), point) >= 0 && part.distance(point) > at.depth_mm;
      if (is_deeper && part.has_inside(point)) {
        at = {part.distance(point), t, point};
      } else {
        step *= 0.93;
      }
    }
    if (at.depth_mm > best.depth_mm) best = at;
  };
  if (start.depth_mm > 0) climb(start);
  for (int k = 0; k < kStarts; ++k) {
    const IndexedMesh& mesh = part.mesh();
    const std::size_t triangle = random.below(mesh.triangles.size());
    const double u = random.in(0, 1), v = random.in(0, 1 - u);
    const Vec3 a = mesh.corner(triangle, 0), b = mesh.corner(triangle, 1) - a, c = mesh.corner(triangle, 2) - a;
    const Vec3 below = -b.cross(c).normalized();
    Deepest at;
    at.t = random.in(0, 1);
    at.point = a + u * b + v * c + random.in(0, 0.1 * size) * random.in(0, 1) * below;
    if (!(moving.depth(moving.frame(at.t), at.point) >= 0) || !part.has_inside(at.point)) continue;
    at.depth_mm = part.distance(at.point);
    climb(at);
  }
  return best;
}

/// A second closed shell in the material of the part, or across its surface: how often triangles wind around a point is
/// then what shows the side, and no longer the nearest of them.
void add_shell(IndexedMesh& part, test::Scatter& random) {
  const Box3 box = part.box();
  const double size = random.in(0.05, 0.3) * box.diagonal().norm();
  IndexedMesh shell = random.is(0.5) ? shapes::box(Vec3::Constant(-size), Vec3::Constant(size)) : shapes::sphere(size);
  const Vec3 middle = box.center() + Vec3(0.5 * box.sizes().cwiseProduct(random.point(1)));
  part = shapes::joined(part, shapes::moved(std::move(shell), middle));
}

class Campaign {
 public:
  /// `law`: the tool runs on the machine of campaigns; none: on the great circle.
  explicit Campaign(std::optional<TurnLaw> law = {}, std::uint64_t first_stream = 0)
      : law_(law), first_(first_stream) {}

  void run(std::size_t gouges) {
    const bool is_alone = std::getenv("GOUGE_STREAM") != nullptr;
    std::uint64_t stream = number_from("GOUGE_STREAM", first_);
    for (bool is_first = true; is_alone ? is_first : measured < gouges; ++stream, is_first = false) {
      laws::RandomJobs jobs(stream);
      test::Scatter random(stream + 1);
      for (int k = 0; k < 8; ++k) {
        where_ = "stream " + std::to_string(stream) + ", job " + std::to_string(k);
        laws::RandomJob job = jobs.next();
        if (law_) laws::choose_joints_of_campaign(job.path);
        if (job.is_closed) check(job, random);
      }
    }
  }

  std::size_t measured = 0, of_heads = 0, open = 0, reached = 0;

 private:
  void check(const laws::RandomJob& job, test::Scatter& random) {
    CheckOptions options;
    options.threads = 1;
    if (law_) options.law = laws::law_of_campaign(*law_);
    std::vector<HeadBody> bodies;
    for (const IndexedMesh& head : job.heads) bodies.push_back(*build_head_body(head));
    Scene scene = job.scene;
    has_shells_ = random.is(0.05) && !law_;  // their distances take long, and are alike by every law
    if (has_shells_) add_shell(scene.parts.front(), random);
    const OwnSetup own(&job.tool, scene, options, bodies);
    const CheckResult result = gouge::check(job.path, own.setup);
    const reference::Contour bare(job.tool.bare);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      const MoveVerdict& v = result.verdicts[i];
      if (v.state != MoveState::gouge || !v.overcut) continue;
      reference::Movement movement = reference::movement(job.path, i);
      if (law_) movement.frames = laws::frames_of(*law_, job.path, i);
      const Motion motion = options.law.of(job.path, i);
      if (v.witness->body != Body::head) {
        SweptTool swept(motion, job.tool.bare);
        judge(job, own.scene, v, i, swept, reference::MovingTool(bare, movement), random);
      } else if (bodies.size() == 1) {
        ++of_heads;
        SweptHead swept(motion, bodies[0]);
        judge(job, own.scene, v, i, swept, reference::MovingHead(job.heads[0], movement), random);
      }
    }
  }

  template <class Moving>
  void judge(const laws::RandomJob& job, const PreparedScene& scene, const MoveVerdict& v, std::size_t i,
             SweptSolid& swept, const Moving& moving, test::Scatter& random) {
    ++measured;
    const auto fail = [&](const std::string& what, double value) {
      std::ostringstream text;
      text.precision(17);
      text << where_ << ", " << job.tool_name << ", move " << i << ": overcut " << v.overcut->lower_mm << " to "
           << v.overcut->upper_mm << ", depth " << v.depth_mm << " to " << v.depth_upper_mm << "; " << what << " "
           << value;
      ADD_FAILURE() << text.str();
    };
    const bool is_part = v.witness->against == Against::part;
    const IndexedMesh& mesh = (is_part ? scene.scene->parts : scene.scene->fixtures)[v.witness->mesh];
    const PlainPart part(mesh, has_shells_ && is_part && v.witness->mesh == 0);
    const Surface& surface = scene.surface(v.witness->against, v.witness->mesh).boundary();
    // The search by cells alone: nothing is taken from the depth.
    OvercutOptions brief;
    brief.max_cells = 500;
    const Vec3 seed = v.witness->point - v.depth_mm * v.witness->normal;
    const Overcut found = find_overcut(swept, surface, seed, v.witness->t, brief);
    if (found.depth_mm > 0) {
      const double deep = moving.depth(moving.frame(found.t), found.point);
      if (!(deep >= -kRounding_mm)) fail("the point of the lower bound is not in what moves:", deep);
      const double distance = part.distance(found.point);
      if (std::abs(distance - found.depth_mm) > kRounding_mm) fail("its distance is", distance);
      if (distance > kRounding_mm && !part.has_inside(found.point)) fail("it is outside, by", distance);
    }
    if (found.depth_mm > v.overcut->upper_mm + kRounding_mm) fail("cells alone reach", found.depth_mm);
    if (v.overcut->lower_mm > found.depth_upper_mm + kRounding_mm)
      fail("cells alone bound it by", found.depth_upper_mm);
    const Deepest deepest = look_for_deepest(moving, part, {found.depth_mm, found.t, found.point}, random);
    if (deepest.depth_mm > v.overcut->upper_mm + kRounding_mm) fail("a point was found at", deepest.depth_mm);
    if (deepest.depth_mm > found.depth_upper_mm + kRounding_mm)
      fail("a point was found beyond the cells' bound:", deepest.depth_mm);
    if (v.overcut->upper_mm - v.overcut->lower_mm > overcut_gap_mm(v.overcut->lower_mm) + kRounding_mm) ++open;
    const Deepest own = look_for_deepest(moving, part, {}, random);
    if (own.depth_mm > 0.9 * v.overcut->lower_mm) ++reached;
  }

  std::optional<TurnLaw> law_;
  std::uint64_t first_;
  std::string where_;
  bool has_shells_ = false;
};

TEST(OvercutLaw, HoldsAgainstPointsFoundByOwnArithmetic) {
  Campaign campaign;
  campaign.run(number_from("GOUGE_OVERCUTS", 1000));
  std::cout << campaign.measured << " gouging moves, " << campaign.of_heads << " of heads; " << campaign.open
            << " not closed to their gap; in " << campaign.reached << " the reference alone comes to 90 %\n";
  EXPECT_GT(campaign.of_heads, 0U);
  EXPECT_GT(campaign.reached * 10, campaign.measured) << "the reference is too weak";
}

TEST(OvercutLaw, HoldsWhereTheJointsOfAMachineRun) {
  std::size_t measured = 0, of_heads = 0, reached = 0;
  for (const TurnLaw law : {TurnLaw::axis, TurnLaw::joint, TurnLaw::independent}) {
    Campaign campaign(law, 10'000 * static_cast<std::uint64_t>(law));
    campaign.run(number_from("GOUGE_OVERCUTS", 1000) * 2 / 5);
    std::cout << turn_law_name(law) << ": " << campaign.measured << " gouging moves, " << campaign.of_heads
              << " of heads; in " << campaign.reached << " the reference alone comes to 90 %\n";
    measured += campaign.measured;
    of_heads += campaign.of_heads;
    reached += campaign.reached;
  }
  EXPECT_GT(of_heads, 0U);
  EXPECT_GT(reached * 10, measured) << "the reference is too weak";
}

}  // namespace
}  // namespace gouge::overcut_law_test
