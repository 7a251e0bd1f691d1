// The guarantee of docs/method/guarantee.md on random moves of every kind, with tools of every shape and heads, among closed and
// open meshes. GOUGE_RANDOM_MOVES sets how many moves, GOUGE_SEED which; GOUGE_STREAM examines one stream of a failure
// again. docs/develop/testing.md has the longest run.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>

#include "lib/base/number_text.h"
#include "tests/laws/guarantee.h"
#include "tests/laws/machine_moves.h"
#include "tests/laws/random_moves.h"
#include "tests/support/reference_hunt.h"
#include "tests/support/rotary_head_law.h"
#include "tests/support/whole_check.h"

namespace gouge::random_moves_test {
namespace {

constexpr double kRounding_mm = 1e-9, kWitness_mm = 1e-6;
constexpr int kLooks = 600, kLooksOfHeads = 200;
constexpr std::uint64_t kBounds = 5000;

std::size_t wanted_moves() {
  const char* given = std::getenv("GOUGE_RANDOM_MOVES");
  return given == nullptr ? 2000 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

struct Tally {
  std::size_t moves = 0, clean = 0, gouge = 0, buried = 0, open = 0, wide = 0, seen = 0, violations = 0;
};

std::string kind_of(const Toolpath& path, const Move& move) {
  if (!move.has_start) return "position";
  if (move.curve_kind == CurveKind::arc) return "arc";
  if (move.curve_kind == CurveKind::spline) return "spline";
  static_cast<void>(path);
  return kind_name(move.kind);
}

/// A point of the tool as deep inside it as can be found, in (r, z), for telling whether the tool is in a solid.
struct Core {
  double r = 0, z = 0, depth = -1;
  explicit Core(const reference::Contour& tool) {
    for (int i = 0; i <= 12; ++i) {
      for (int k = 0; k <= 40; ++k) {
        const double at_r = tool.widest_mm() * i / 12, at_z = tool.top_mm() * k / 40;
        const double inside = tool.depth(at_r, at_z);
        if (inside > depth) {
          r = at_r;
          z = at_z;
          depth = inside;
        }
      }
    }
  }
};

/// A solid and all within a distance of it.
template <class Solid>
class Grown {
 public:
  Grown(const Solid& solid, double distance_mm) : solid_(solid), distance_mm_(distance_mm) {}
  using Frame = typename Solid::Frame;
  [[nodiscard]] Frame frame(double t) const { return solid_.frame(t); }
  [[nodiscard]] double depth(const Frame& frame, const Vec3& p) const { return solid_.depth(frame, p) + distance_mm_; }
  [[nodiscard]] double turn_rad() const { return solid_.turn_rad(); }
  [[nodiscard]] const reference::Movement& movement() const { return solid_.movement(); }

 private:
  const Solid& solid_;
  double distance_mm_;
};

struct CampaignKind {
  bool has_rotaries = false;        ///< the axis runs as a head of two rotary axes takes it
  bool is_mismatched = false;       ///< the reference has another axis or distance; failures are only counted
  std::optional<TurnLaw> law = {};  ///< the tool runs on the machine of the campaign
  double keep_mm = 0;               ///< among the obstacles is one that must be kept at this distance; 0: none
};

class Campaign {
 public:
  explicit Campaign(CampaignKind kind) : kind_(kind) {}

  void run(std::size_t moves) {
    const auto begin = std::chrono::steady_clock::now();
    const char* alone = std::getenv("GOUGE_STREAM");
    for (std::uint64_t stream = alone == nullptr ? 0 : std::strtoull(alone, nullptr, 10);
         done_ < moves && (alone == nullptr || done_ == 0); ++stream) {
      laws::RandomJobs jobs(stream);
      for (int k = 0; k < 8 && done_ < moves; ++k) {
        where_ = "stream " + std::to_string(stream) + ", job " + std::to_string(k);
        check(jobs.next());
      }
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    print(spent.count());
  }

  std::map<std::string, Tally> by_kind;
  std::size_t heads = 0, tools_seen = 0, failures = 0, kept_witnesses = 0, kept_freed = 0;

 private:
  /// A copy of the part in another place, which no point of the tool may come near.
  void add_kept_obstacle(laws::RandomJob& job) {
    test::Scatter random(done_ + 1);
    const double away_mm = random.in(0.5, 2) * kind_.keep_mm + job.tool.bare.r_max_mm;
    job.scene.fixtures = {shapes::moved(job.scene.parts.front(), away_mm * random.axis(1))};
    job.scene.limits = {{Against::fixture, 0, kind_.keep_mm, random.below(2) == 0 ? 0 : 0.003}};
    job.is_closed = false;  // it may overlap the part
  }

  void check(laws::RandomJob job) {
    if (kind_.keep_mm > 0) add_kept_obstacle(job);
    CheckOptions options;
    options.threads = 1;
    options.tolerance_mm = std::array{0.01, 0.0, 0.1}[done_ % 3];
    options.resolution_mm = done_ % 2 == 0 ? 0.001 : 0.01;
    // The guarantee holds at any budget; a small budget for most allows many more moves.
    const bool is_patient = ++jobs_ % 32 == 0;
    if (!is_patient) options.budget_per_move = kBounds;
    if (kind_.law) {
      options.law = laws::law_of_campaign(*kind_.law);
      laws::choose_joints_of_campaign(job.path);
    }
    if (kind_.has_rotaries) options.law = {RapidMode::straight, std::make_shared<test::RotaryHeadLaw>()};
    std::vector<HeadBody> bodies;
    for (const IndexedMesh& head : job.heads) bodies.push_back(*build_head_body(head));
    const CheckResult result = whole_check(job.path, &job.tool, job.scene, options, bodies);
    heads += job.heads.empty() ? 0 : result.verdicts.size();
    const guarantee::Contours tool(job.tool);
    const Core core(tool.part);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      const std::size_t before = failures;
      judge(job, options, result.verdicts[i], i, tool, core);
      Tally& tally = by_kind[kind_of(job.path, job.path.moves[i])];
      tally.violations += failures > before ? 1 : 0;
    }
    done_ += result.verdicts.size();
  }

  /// The motions of a move that its law admits; of LawScope::any the first, and two with the rotary joints at rest.
  [[nodiscard]] std::vector<reference::Movement> movements_of(const Toolpath& path, std::size_t i) const {
    std::vector<reference::Movement> all{movement_of(path, i, {})};
    test::Scatter random(1000 * done_ + i);
    if (kind_.law == TurnLaw::documented) all.push_back(movement_of(path, i, TurnShares{}));
    for (int k = 0; k < 2 && kind_.law == TurnLaw::any; ++k)
      all.push_back(movement_of(path, i, TurnShares{random.in(0, 1), random.in(0, 1)}));
    return all;
  }

  /// The motion of a witness with these shares.
  [[nodiscard]] reference::Movement movement_of(const Toolpath& path, std::size_t i,
                                                const std::optional<TurnShares>& turn) const {
    reference::Movement movement = reference::movement(path, i);
    if (kind_.law == TurnLaw::documented || kind_.law == TurnLaw::vector) {
      const auto by_axis = laws::frames_of(TurnLaw::axis, path, i);
      if (turn) movement.frames = by_axis;
      if (!turn && by_axis) movement.ends = {by_axis->frame(0).rotation, by_axis->frame(1).rotation};
      return movement;
    }
    if (kind_.law == TurnLaw::any) {
      movement.frames = laws::frames_of(TurnLaw::axis, path, i, turn);
      return movement;
    }
    if (kind_.has_rotaries && !kind_.is_mismatched) movement.rotaries.emplace(movement.from.axis, movement.to.axis);
    if (kind_.law) {
      const TurnLaw other = *kind_.law == TurnLaw::joint ? TurnLaw::axis : TurnLaw::joint;
      movement.frames = laws::frames_of(kind_.is_mismatched ? other : *kind_.law, path, i);
    }
    return movement;
  }

  void fail(const laws::RandomJob& job, std::size_t move, const std::string& what) {
    ++failures;
    if (!kind_.is_mismatched) ADD_FAILURE() << where_ << ", " << job.tool_name << ", move " << move << ": " << what;
  }

  void judge(const laws::RandomJob& job, const CheckOptions& options, const MoveVerdict& v, std::size_t i,
             const guarantee::Contours& tool, const Core& core) {
    Tally& tally = by_kind[kind_of(job.path, job.path.moves[i])];
    ++tally.moves;
    tally.clean += v.state == MoveState::clean ? 1 : 0;
    tally.buried += v.state == MoveState::buried ? 1 : 0;
    tally.gouge += v.state == MoveState::gouge ? 1 : 0;
    if (v.state == MoveState::not_certified || v.state == MoveState::not_checked) ++tally.open;
    if (v.state == MoveState::not_checked) return;
    const std::vector<reference::Movement> movements = movements_of(job.path, i);
    const reference::Movement& movement = movements.front();
    judge_inside(job, options, v, i, movement, core);
    if (v.state == MoveState::buried) return;
    if (v.state == MoveState::clean && v.depth_upper_mm > options.tolerance_mm + options.resolution_mm)
      fail(job, i, "clean, yet only proved to " + std::to_string(v.depth_upper_mm));
    const MeshLimit* limit = limit_of(job, v);
    const double tolerance_mm =
        limit == nullptr ? options.tolerance_mm : std::min(limit->tolerance_mm, options.tolerance_mm);
    if (v.state == MoveState::gouge && !(v.depth_mm > tolerance_mm))
      fail(job, i,
           "a gouge within the tolerance of " + std::to_string(options.tolerance_mm) + ": " + exact_text(v.depth_mm) +
               " to " + std::to_string(v.depth_upper_mm) + " " + reason_text(v.reason));
    // Elsewhere the tool may be as deep as the tolerance.
    const bool has_limit = limit != nullptr || !job.tool.with_clearance.elements.empty();
    const double gap_mm = options.resolution_mm + (has_limit ? options.tolerance_mm : 0);
    if (v.state == MoveState::gouge && v.depth_upper_mm - v.depth_mm > gap_mm) {
      ++tally.wide;
      if (job.heads.empty() && options.budget_per_move > kBounds && kind_.law != TurnLaw::any)
        fail(job, i, "a gouge known only to " + std::to_string(v.depth_upper_mm - v.depth_mm));
    }
    if (v.witness)
      judge_witness(job, v, i, v.witness->turn ? movement_of(job.path, i, v.witness->turn) : movement, tool);
    for (const reference::Movement& one : movements) hunt(job, options, v, i, one, tool, tally);
  }

  /// Null: the obstacle of its witness has none.
  static const MeshLimit* limit_of(const laws::RandomJob& job, const MoveVerdict& v) {
    const bool has_limit = v.witness && v.witness->against == Against::fixture && !job.scene.limits.empty();
    return has_limit ? &job.scene.limits.front() : nullptr;
  }

  /// A clean tool is outside of what is closed, a buried one inside.
  void judge_inside(const laws::RandomJob& job, const CheckOptions& options, const MoveVerdict& v, std::size_t i,
                    const reference::Movement& movement, const Core& core) {
    const bool is_clean = v.state == MoveState::clean, is_buried = v.state == MoveState::buried;
    if (!job.is_closed || !(is_clean || is_buried) || core.depth <= options.tolerance_mm + options.resolution_mm)
      return;
    bool is_inside = false;
    const auto look = [&](const Vec3& p) {
      for (const std::vector<IndexedMesh>* meshes : {&job.scene.parts, &job.scene.fixtures}) {
        for (const IndexedMesh& mesh : *meshes) is_inside |= reference::solid_angle_share(mesh, p) > 0.5;
      }
    };
    const Pose pose = movement.at(0.5);
    look(pose.tip + core.r * pose.axis.unitOrthogonal() + core.z * pose.axis);
    if (is_clean && is_inside) fail(job, i, "clean, and inside a solid");
    if (is_buried && !is_inside && job.heads.empty()) fail(job, i, "buried, and outside");
  }

  void judge_witness(const laws::RandomJob& job, const MoveVerdict& v, std::size_t i,
                     const reference::Movement& movement, const guarantee::Contours& tool) {
    if (const MeshLimit* limit = limit_of(job, v); limit != nullptr && v.depth_mm > 0)
      return judge_kept_witness(job, v, i, movement, limit->clearance_mm);
    if (v.witness->body != Body::head) {
      for (const std::string& uncertainty :
           guarantee::uncertainties(*v.witness, v.depth_mm, movement, tool, job.scene)) {
        // Giving way by the depth frees a point, but on a concave boundary by no plain sum.
        if (uncertainty.rfind("deep after", 0) != 0) fail(job, i, uncertainty);
      }
      return;
    }
    double deepest = -1e300;
    for (const IndexedMesh& head : job.heads) {
      const reference::MovingHead moving(head, movement);
      deepest = std::max(deepest, moving.depth(moving.frame(v.witness->t), v.witness->point));
    }
    if (std::abs(deepest - v.depth_mm) > kWitness_mm)
      fail(job, i, "the head's witness is " + std::to_string(deepest) + " deep, not " + std::to_string(v.depth_mm));
  }

  /// As far within the distance as was reported, and at its edge once the tool or the head has given way.
  void judge_kept_witness(const laws::RandomJob& job, const MoveVerdict& v, std::size_t i,
                          const reference::Movement& movement, double keep_mm) {
    const auto look = [&](const auto& solid) {
      double depth = -1e300, left = -1e300;
      for (const auto& one : solid) {
        auto frame = one.frame(v.witness->t);
        depth = std::max(depth, keep_mm + one.depth(frame, v.witness->point));
        frame.tip += v.depth_mm * v.witness->normal;
        left = std::max(left, keep_mm + one.depth(frame, v.witness->point));
      }
      if (std::abs(depth - v.depth_mm) > kWitness_mm)
        fail(job, i, "within the distance by " + exact_text(depth) + ", not " + exact_text(v.depth_mm));
      // Where the surface of the tool is concave no single step frees a point.
      kept_freed += left <= kWitness_mm ? 1 : 0;
      ++kept_witnesses;
    };
    if (v.witness->body == Body::head) {
      std::vector<reference::MovingHead> all;
      for (const IndexedMesh& head : job.heads) all.emplace_back(head, movement);
      return look(all);
    }
    const reference::Contour bare(job.tool.bare);
    look(std::array{reference::MovingTool(bare, movement)});
  }

  /// How far within the distance from the kept obstacle the tool and the heads come.
  [[nodiscard]] reference::Found hunt_kept(const laws::RandomJob& job, const reference::Movement& movement,
                                           double mark) const {
    reference::Found found;
    const auto look = [&](const auto& solid, int looks) {
      const double keep_mm = job.scene.limits.front().clearance_mm + (kind_.is_mismatched ? 0.05 : 0);
      const reference::Found one = reference::Hunt(Grown(solid, keep_mm), job.scene.fixtures, looks).run(mark);
      if (one.depth_mm > found.depth_mm) found = one;
    };
    const reference::Contour bare(job.tool.bare);
    look(reference::MovingTool(bare, movement), kLooks);
    for (const IndexedMesh& head : job.heads) look(reference::MovingHead(head, movement), kLooksOfHeads);
    return found;
  }

  void hunt(const laws::RandomJob& job, const CheckOptions& options, const MoveVerdict& v, std::size_t i,
            const reference::Movement& movement, const guarantee::Contours& tool, Tally& tally) {
    const bool is_gouge = v.state == MoveState::gouge;
    const double mark = is_gouge ? v.depth_mm - 0.005 : v.depth_upper_mm;
    reference::Found found;
    const auto take = [&](const reference::Found& one) {
      if (one.depth_mm > found.depth_mm) found = one;
    };
    const reference::MovingTool against_part(tool.part, movement), against_fixture(tool.fixture, movement);
    take(reference::Hunt(against_part, job.scene.parts, kLooks).run(mark));
    take(reference::Hunt(against_fixture, job.scene.fixtures, kLooks).run(mark));
    for (const IndexedMesh& head : job.heads) {
      const reference::MovingHead moving(head, movement);
      take(reference::Hunt(moving, job.scene.parts, kLooksOfHeads).run(mark));
      take(reference::Hunt(moving, job.scene.fixtures, kLooksOfHeads).run(mark));
    }
    if (!job.scene.limits.empty()) {
      const reference::Found kept = hunt_kept(job, movement, mark);
      take(kept);
      const double allowed = job.scene.limits.front().tolerance_mm + options.resolution_mm;
      if (v.state == MoveState::clean && kept.depth_mm > allowed + kRounding_mm)
        fail(job, i, "clean, yet " + exact_text(kept.depth_mm) + " within the distance to keep");
    }
    tally.seen += is_gouge && found.depth_mm > v.depth_mm - 0.001 ? 1 : 0;
    if (found.depth_mm <= v.depth_upper_mm + kRounding_mm) return;
    std::ostringstream text;
    text << std::setprecision(17) << state_name(v.state) << ", depth " << v.depth_mm << ", at most " << v.depth_upper_mm
         << ", but " << found.depth_mm << " at t " << found.t << ", " << found.point.transpose();
    fail(job, i, text.str());
  }

  void print(double seconds) const {
    std::cout << "kind      moves    clean    gouge  buried  open  wide  found again  violations\n";
    Tally all;
    const auto row = [](const std::string& kind, const Tally& t) {
      std::cout << std::left << std::setw(9) << kind << std::right << std::setw(7) << t.moves << std::setw(9) << t.clean
                << std::setw(9) << t.gouge << std::setw(8) << t.buried << std::setw(6) << t.open << std::setw(6)
                << t.wide << std::setw(13) << t.seen << std::setw(12) << t.violations << "\n";
    };
    for (const auto& [kind, t] : by_kind) {
      row(kind, t);
      all.moves += t.moves, all.clean += t.clean, all.gouge += t.gouge, all.buried += t.buried, all.open += t.open;
      all.wide += t.wide, all.seen += t.seen, all.violations += t.violations;
    }
    row("all", all);
    std::cout << heads << " moves with a head; " << seconds << " s\n";
  }

  CampaignKind kind_;
  std::size_t done_ = 0, jobs_ = 0;
  std::string where_;
};

/// Both laws of motion that tests have, and a third kind of obstacle.
class RandomMoves : public testing::TestWithParam<CampaignKind> {};

TEST_P(RandomMoves, NothingIsDeeperThanItsBoundAndEveryWitnessIsReal) {
  Campaign campaign(GetParam());
  campaign.run(wanted_moves());
  Tally all;
  for (const auto& [kind, tally] : campaign.by_kind) {
    all.moves += tally.moves;
    all.clean += tally.clean;
    all.gouge += tally.gouge;
    all.seen += tally.seen;
    EXPECT_GT(tally.moves, 0U) << kind;
  }
  EXPECT_EQ(campaign.by_kind.size(), 6U) << "arc, cycle, feed, position, rapid, spline";
  EXPECT_GT(campaign.heads, 0U);
  EXPECT_GT(all.clean * 10, all.moves) << "too few clean moves to try";
  EXPECT_GT(all.gouge * 10, all.moves) << "too few gouges to try";
  EXPECT_GE(all.seen * 10, all.gouge * 9) << "the reference is too weak";
  EXPECT_EQ(campaign.kept_witnesses > 0, GetParam().keep_mm > 0);
  EXPECT_GE(campaign.kept_freed * 10, campaign.kept_witnesses * 8);
}

INSTANTIATE_TEST_SUITE_P(Laws, RandomMoves,
                         testing::Values(CampaignKind{}, CampaignKind{.has_rotaries = true},
                                         CampaignKind{.law = TurnLaw::vector}, CampaignKind{.law = TurnLaw::axis},
                                         CampaignKind{.law = TurnLaw::documented}, CampaignKind{.law = TurnLaw::any},
                                         CampaignKind{.law = TurnLaw::joint}, CampaignKind{.law = TurnLaw::independent},
                                         CampaignKind{.keep_mm = 5}),
                         [](const auto& kind) -> std::string {
                           if (kind.param.law) return "Law_" + std::string(turn_law_name(*kind.param.law));
                           if (kind.param.keep_mm > 0) return "KeptObstacle";
                           return kind.param.has_rotaries ? "RotaryHead" : "GreatCircle";
                         });

/// The reference of the other law finds depths above the bounds: it shows the two apart.
TEST(RandomMovesOfRotaries, AreNotThoseOnTheGreatCircle) {
  Campaign campaign({.has_rotaries = true, .is_mismatched = true});
  campaign.run(500);
  EXPECT_GT(campaign.failures, 0U);
}

TEST(RandomMovesOfJoints, AreNotThoseOfAnotherLaw) {
  for (const TurnLaw law : {TurnLaw::joint, TurnLaw::independent}) {
    Campaign campaign({.is_mismatched = true, .law = law});
    campaign.run(300);
    EXPECT_GT(campaign.failures, 0U) << turn_law_name(law);
  }
}

TEST(RandomMovesBesideKeptObstacle, ReachFartherThanALargerDistanceAllows) {
  Campaign campaign({.is_mismatched = true, .keep_mm = 5});
  campaign.run(300);
  EXPECT_GT(campaign.failures, 0U);
}

}  // namespace
}  // namespace gouge::random_moves_test
