// Certificates of random scenes: accepted as they are, refused once anything in them or in the result is
// changed, and no proof is ever found for less than a witness shows. GOUGE_VERIFY_SCENES sets how many
// scenes, GOUGE_VERIFY_MUTATIONS how many changes, GOUGE_SEED which. docs/develop/testing.md has the longest run.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "lib/verify/certificate.h"
#include "lib/verify/certificate_text.h"
#include "lib/verify/witness_check.h"
#include "lib/verify/zstd_stream.h"
#include "tests/laws/random_scenes.h"
#include "tests/support/reference.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::verify_law_test {
namespace {

using laws::RandomScene;
using laws::SceneScatter;

const std::string kInputs(64, 'a');

std::size_t wanted(const char* name, std::size_t usual) {
  const char* given = std::getenv(name);
  return given == nullptr ? usual : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// A random scene, checked, and what is claimed of it.
struct Case {
  RandomScene random;
  const ToolVariants* tool = nullptr;
  std::unique_ptr<ClaimedScene> scene;
  std::vector<MoveClaim> claims;

  [[nodiscard]] MadeCertificate certificate(unsigned threads = 1) const {
    ClaimedScene with = *scene;
    with.threads = threads;
    return make_certificate(with, claims, kInputs, {});
  }
  [[nodiscard]] Result<CertificateReading> verify(std::string_view bytes) const {
    return verify_certificate(*scene, SceneOrders(*scene), claims, kInputs, "proofs.gcp", bytes, {});
  }
  /// By its proofs and its witnesses.
  [[nodiscard]] bool is_refuted(std::string_view bytes) const {
    const auto read = verify(bytes);
    if (!read || !read->refuted.empty()) return true;
    const ClaimedTools tools = claimed_tools(*scene);
    for (std::size_t i = 0; i < claims.size(); ++i)
      if (find_witness_fault(*scene, tools, i, claims[i])) return true;
    return false;
  }
};

void bend_a_move(SceneScatter& scatter, Toolpath& path) {
  const std::size_t i = 1 + scatter.below(path.moves.size() - 1);
  Move& move = path.moves[i];
  const Vec3 from = path.start_of(i).tip, way = move.end.tip - from;
  const Vec3 aside = scatter.point(0.3 * way.norm());
  if (scatter.in(0, 1) < 0.5) {
    move.curve_kind = CurveKind::spline;
    path.splines.push_back({{{0, 1, {from, from + way / 3 + aside, from + way / 1.5 - aside, move.end.tip}}}});
  } else if (way.norm() > 1e-3) {
    move.curve_kind = CurveKind::arc;
    const Vec3 normal = way.unitOrthogonal();
    const double off = scatter.in(-2, 2) * way.norm();
    const Vec3 center = from + 0.5 * way + off * normal.cross(way.normalized());
    path.arcs.push_back({center, normal, 2 * std::atan2(0.5 * way.norm(), -off)});
  }
}

MoveClaim claim_of(const MoveVerdict& v, double largest_clean_mm) {
  MoveClaim claim;
  claim.depth_mm = v.depth_mm;
  claim.depth_upper_mm = v.depth_upper_mm;
  // Open meshes leave inside and outside open; the depth is known all the same.
  claim.state = v.state == MoveState::not_checked      ? ClaimedState::not_checked
                : v.depth_upper_mm <= largest_clean_mm ? ClaimedState::near
                                                       : ClaimedState::gouge;
  if (v.witness) {
    const Witness& w = *v.witness;
    claim.witness = ClaimedWitness{w.t, w.point, w.normal, w.body, w.against == Against::fixture, w.mesh, w.triangle};
  } else if (claim.state == ClaimedState::near) {
    claim.state = ClaimedState::clean;
  }
  return claim;
}

/// Tools of all shapes in turn.
const ToolVariants& tool_of(std::size_t k) {
  static const std::vector<ToolVariants> kTools = [] {
    std::vector<ToolVariants> all = tools::all();
    for (ToolVariants& shape : tools::shapes()) all.push_back(std::move(shape));
    return all;
  }();
  return kTools[k % kTools.size()];
}

std::unique_ptr<Case> make_case(std::size_t k) {
  SceneScatter scatter(9'000'000 + k);
  auto made = std::make_unique<Case>();
  made->tool = &tool_of(k);
  made->random = scatter.scene(made->tool->against_part);
  if (k % 3 == 0) bend_a_move(scatter, made->random.path);
  const CheckOptions options;
  const CheckResult result = whole_check(made->random.path, made->tool, made->random.scene, options);
  made->scene = std::make_unique<ClaimedScene>(
      ClaimedScene{made->random.path, {made->tool}, made->random.scene.parts, made->random.scene.fixtures, {}});
  for (const MoveVerdict& v : result.verdicts)
    made->claims.push_back(claim_of(v, options.tolerance_mm + options.resolution_mm));
  return made;
}

TEST(VerifyLaw, EveryRandomScenesCertificateIsAcceptedTheSameBytesAtAnyNumberOfThreads) {
  std::size_t moves = 0, open = 0, gouges = 0;
  for (std::size_t k = 0; k < wanted("GOUGE_VERIFY_SCENES", 20); ++k) {
    const auto of = make_case(k);
    const MadeCertificate made = of->certificate();
    EXPECT_EQ(made.bytes, of->certificate(3).bytes) << "scene " << k;
    const auto read = of->verify(made.bytes);
    ASSERT_TRUE(read.has_value()) << "scene " << k << ": " << read.error().message;
    for (const ProofRefutation& r : read->refuted)
      ADD_FAILURE() << "scene " << k << ", move " << r.move << ": " << r.what;
    EXPECT_FALSE(of->is_refuted(made.bytes)) << "scene " << k;
    for (const MoveClaim& claim : of->claims) gouges += claim.state == ClaimedState::gouge ? 1 : 0;
    moves += of->claims.size();
    open += made.surfaces.not_proved.size();
  }
  std::cout << moves << " moves, " << gouges << " of them gouges, " << open << " without a proof\n";
  EXPECT_GT(gouges, 0U);
  EXPECT_LE(open * 10, moves);
}

TEST(VerifyLaw, NoProofIsFoundForLessThanAWitnessShows) {
  std::size_t asked = 0;
  for (std::size_t k = 0; k < wanted("GOUGE_VERIFY_SCENES", 20); ++k) {
    const auto of = make_case(5000 + k);
    for (std::size_t i = 0; i < of->claims.size(); ++i) {
      MoveClaim& claim = of->claims[i];
      const bool is_deep = claim.witness && claim.depth_mm > 1e-4;
      claim.state = is_deep ? ClaimedState::gouge : ClaimedState::not_checked;
      claim.depth_upper_mm = claim.depth_mm - 3e-6;
      asked += is_deep ? 1 : 0;
    }
    EXPECT_EQ(of->certificate().surfaces.proved, 0U) << "scene " << k;
  }
  EXPECT_GT(asked, 10U);
}

/// A certificate proves motions by one law, and no other.
TEST(VerifyLaw, ACertificateNamesItsLawOfMotion) {
  const auto of = make_case(0);
  const MadeCertificate made = of->certificate();
  ASSERT_GT(made.surfaces.proved, 0U);
  of->scene->is_dogleg = true;
  EXPECT_FALSE(of->verify(made.bytes).has_value());
  of->scene->is_dogleg = false;
  EXPECT_TRUE(of->verify(made.bytes).has_value());
  of->scene->axis_law = "rotary-head";
  EXPECT_FALSE(of->verify(made.bytes).has_value());
  EXPECT_EQ(of->certificate().surfaces.proved, 0U);
}

/// The groups of a certificate, to be changed and written again.
std::vector<ProofGroup> groups_in(std::string_view bytes, std::string& header) {
  ZstdReader reader(bytes.substr(kCertificateMagic.size()));
  header = reader.take(header_bytes(false));
  std::vector<ProofGroup> all;
  for (std::uint32_t size = block_length(reader.take(4)); size > 0; size = block_length(reader.take(4))) {
    const auto groups = groups_of(reader.take(size), 0, ~std::uint32_t{0});
    if (groups) all.insert(all.end(), groups->begin(), groups->end());
  }
  return all;
}

std::string bytes_of(const std::string& header, const std::vector<ProofGroup>& groups) {
  ZstdWriter writer;
  writer.add(header);
  if (!groups.empty()) writer.add(block_bytes(groups));
  writer.add(block_bytes({}));
  return std::string(kCertificateMagic) + writer.finish();
}

/// Changes a case or its certificate so that something of it is not true any more. False where there is
/// nothing to change in this way.
bool mutate(Case& of, std::string& bytes, std::size_t way, SceneScatter& scatter) {
  std::string header;
  std::vector<ProofGroup> groups = groups_in(bytes, header);
  const std::size_t move = scatter.below(of.claims.size());
  MoveClaim& claim = of.claims[move];
  const bool has_witness = claim.witness && claim.depth_mm > 1e-4;
  ProofGroup* const group = groups.empty() ? nullptr : &groups[scatter.below(groups.size())];
  const bool has_steps = group != nullptr && !group->steps.empty() && group->steps != "\x09";
  switch (way) {
    case 0:  // depth
      if (!has_witness) return false;
      claim.depth_mm += (scatter.in(0, 1) < 0.5 ? 1 : -1) * std::pow(10, scatter.in(-5, -1));
      return true;
    case 1:  // bound
      if (!has_witness || claim.state != ClaimedState::gouge) return false;
      claim.depth_upper_mm = claim.depth_mm - std::pow(10, scatter.in(-5, -4));
      claim.depth_mm = *claim.depth_upper_mm;  // the bound alone would contradict the depth
      return true;
    case 2: {  // t
      if (!has_witness) return false;
      const double depth = claim.depth_mm;
      claim.witness->t = scatter.in(0, 1);
      const Pose pose = reference::movement(of.random.path, move).at(claim.witness->t);
      return std::abs(reference::Contour(of.tool->against_part).depth(pose, claim.witness->point) - depth) > 1e-5;
    }
    case 3: {  // triangle
      if (!has_witness) return false;
      const IndexedMesh& mesh = of.random.scene.parts[claim.witness->mesh];
      claim.witness->triangle = (claim.witness->triangle + 1) % mesh.triangles.size();
      const auto t = claim.witness->triangle;
      return reference::distance_to_triangle(claim.witness->point, mesh.corner(t, 0), mesh.corner(t, 1),
                                             mesh.corner(t, 2)) > 1e-5;
    }
    case 4:  // a box is removed
    case 5:  // a box is shrunk to half
      if (!has_steps) return false;
      for (std::size_t at = scatter.below(group->steps.size());; at = (at + 1) % group->steps.size()) {
        if (group->steps[at] < 2) continue;  // a cut
        if (way == 4)
          group->steps.erase(at, 1);
        else
          group->steps.insert(at, 1, static_cast<char>(scatter.below(2)));
        break;
      }
      bytes = bytes_of(header, groups);
      return true;
    case 6:  // a move is removed
      if (group == nullptr) return false;
      groups.erase(groups.begin() + (group - groups.data()));
      bytes = bytes_of(header, groups);
      return true;
    case 7:  // a byte of the file
      bytes[scatter.below(bytes.size())] ^= static_cast<char>(1 + scatter.below(255));
      return true;
    default:  // the file is cut short
      bytes.resize(scatter.below(bytes.size()));
      return true;
  }
}

TEST(VerifyLaw, EveryMutationIsFound) {
  constexpr std::size_t kWays = 9;
  std::array<std::size_t, kWays> made{};
  std::size_t mutations = 0;
  for (std::size_t k = 0; mutations < wanted("GOUGE_VERIFY_MUTATIONS", 60); ++k) {
    auto of = make_case(k / kWays);
    std::string bytes = of->certificate().bytes;
    SceneScatter scatter(7'000'000 + k);
    if (!mutate(*of, bytes, k % kWays, scatter)) continue;
    ++mutations;
    ++made.at(k % kWays);
    EXPECT_TRUE(of->is_refuted(bytes)) << "mutation " << k << ", way " << k % kWays;
  }
  for (const std::size_t count : made) EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace gouge::verify_law_test
