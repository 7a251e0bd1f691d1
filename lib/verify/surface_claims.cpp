#include "lib/verify/surface_claims.h"

#include <algorithm>

#include "lib/verify/claimed_pieces.h"

namespace gouge {

namespace {

constexpr std::uint64_t kTriesPerMove = 3'000, kTriesAlone = 300'000;

}  // namespace

SurfaceClaims::Forms::Forms(const ToolVariants& tool)
    : part(tool.against_part), fixture(tool.against_fixture), clearance(tool.with_clearance) {
  is_closed = part.is_closed() && fixture.is_closed() && clearance.is_closed();
}

SurfaceClaims::SurfaceClaims(const ClaimedScene& scene, const SceneOrders& orders, const std::vector<MoveClaim>& claims)
    : scene_(scene), orders_(orders), claims_(claims) {
  for (const ToolVariants* tool : scene.tools)
    forms_.push_back(tool == nullptr ? nullptr : std::make_unique<Forms>(*tool));
}

bool SurfaceClaims::is_askable(std::size_t move) const {
  const auto has_clearance = [](const ClaimedLimit& limit) { return limit.clearance_mm > 0; };
  if (std::ranges::any_of(scene_.limits, has_clearance)) return false;
  const std::size_t tool = scene_.path.moves[move].tool;
  if (tool >= forms_.size() || !forms_[tool] || !forms_[tool]->is_closed) return false;
  const MoveClaim& claim = claims_[move];
  return claims_clean(claim) || (claim.state == ClaimedState::gouge && claim.depth_upper_mm);
}

bool SurfaceClaims::is_alike(std::size_t a, std::size_t b) const {
  return claims_clean(claims_[a]) && claims_clean(claims_[b]) && scene_.path.moves[a].tool == scene_.path.moves[b].tool;
}

std::vector<ProofQuestion> SurfaceClaims::questions_of(std::size_t move) const {
  const MoveClaim& claim = claims_[move];
  const Forms& forms = *forms_[scene_.path.moves[move].tool];
  const double depth = claims_clean(claim) ? scene_.largest_clean_mm() : *claim.depth_upper_mm;
  std::vector<ProofQuestion> all{{forms.part, orders_.parts, depth}, {forms.fixture, orders_.fixtures, depth}};
  if (!claims_clean(claim)) return all;
  all.push_back({forms.clearance, orders_.parts, scene_.resolution_mm});
  all.push_back({forms.clearance, orders_.fixtures, scene_.resolution_mm});
  for (std::size_t k = 0; k < scene_.limits.size(); ++k) {
    const ClaimedLimit& limit = scene_.limits[k];
    const double allowed_mm = limit.tolerance_mm + scene_.resolution_mm;
    all.push_back({limit.is_fixture ? forms.fixture : forms.part, orders_.limited[k], allowed_mm});
  }
  return all;
}

class SurfaceClaims::Search final : public ProofSearch {
 public:
  explicit Search(const SurfaceClaims& claims) : claims_(claims) {}

  bool find(std::size_t first, std::size_t count, std::string& steps) override {
    const std::uint64_t tries = count > 1 ? kTriesPerMove * count : kTriesAlone;
    const auto pieces = pieces_of_moves(claims_.scene_, first, count);
    if (!pieces) return false;
    return std::ranges::all_of(claims_.questions_of(first), [&](const ProofQuestion& question) {
      return find_proof(question, pieces->motion, tries, steps);
    });
  }

 private:
  const SurfaceClaims& claims_;
};

std::unique_ptr<ProofSearch> SurfaceClaims::search() const { return std::make_unique<Search>(*this); }

std::optional<ProofRefutation> SurfaceClaims::refute(const ProofGroup& group) const {
  const auto pieces = pieces_of_moves(scene_, group.first, group.count);
  if (!pieces) return ProofRefutation{group.first, Vec3::Zero(), "its motion is not defined"};
  std::string_view steps = group.steps;
  for (const ProofQuestion& question : questions_of(group.first)) {
    ProofFault fault;
    if (!follow_proof(question, pieces->motion, steps, fault))
      return ProofRefutation{pieces->of_piece[fault.piece].move, fault.point, fault.what};
  }
  if (!steps.empty()) return ProofRefutation{group.first, Vec3::Zero(), "its proof goes on after its end"};
  return std::nullopt;
}

}  // namespace gouge
