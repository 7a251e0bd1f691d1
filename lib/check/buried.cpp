#include "lib/check/buried.h"

#include <cmath>

#include "lib/check/check_path.h"
#include "lib/mesh/winding.h"

namespace gouge {
namespace {

enum class Inside { no, yes, unknown };

// Inside a closed solid the winding number is a whole number other than 0. The share of the solid angle that
// an open mesh leaves free cannot exceed what its holes cover, so far from one half it still tells.
constexpr double kSurelyOutside = 0.25;
constexpr double kSurelyInside = 0.75;

Inside inside_of(const std::vector<IndexedMesh>& meshes, const std::vector<Box3>& boxes, const Vec3& point) {
  Inside answer = Inside::no;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (!boxes[m].contains(point)) continue;
    const double winding = std::abs(winding_number(meshes[m], point));
    if (winding >= kSurelyInside) return Inside::yes;
    if (winding > kSurelyOutside) answer = Inside::unknown;
  }
  return answer;
}

class BuriedMarker {
 public:
  explicit BuriedMarker(const Scene& scene) : scene_(scene) {
    for (const IndexedMesh& mesh : scene.parts) part_boxes_.push_back(mesh.box());
    for (const IndexedMesh& mesh : scene.fixtures) fixture_boxes_.push_back(mesh.box());
  }

  [[nodiscard]] Inside at(const Pose& pose, const CompiledTool& tool) const {
    const Vec3 core = pose.tip + tool.core.y() * pose.axis;
    const Inside part = inside_of(scene_.parts, part_boxes_, core);
    if (part == Inside::yes) return part;
    const Inside fixture = inside_of(scene_.fixtures, fixture_boxes_, core);
    return fixture == Inside::no ? part : fixture;
  }

 private:
  const Scene& scene_;
  std::vector<Box3> part_boxes_, fixture_boxes_;
};

constexpr const char* kBuried = "the tool is inside the solid; no surface is inside the tool";
constexpr const char* kOpenMesh = "the mesh is open here: it cannot tell whether the tool is buried";
constexpr const char* kThinCutter =
    "the tolerance lets the surface reach the middle of the cutter, so the tool may be buried; give a "
    "smaller "
    "tolerance";

}  // namespace

void mark_buried(const Toolpath& toolpath, const std::vector<const ToolForms*>& tools, const Scene& scene,
                 const CheckOptions& options, std::vector<MoveVerdict>& verdicts) {
  const BuriedMarker marker(scene);
  Inside state = Inside::unknown;
  bool is_chained = false;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const Move& move = toolpath.moves[i];
    MoveVerdict& verdict = verdicts[i];
    const bool is_checked =
        verdict.state != MoveState::not_checked && verdict.state != MoveState::not_certified;
    const bool is_core_free = is_checked && verdict.depth_upper_mm < tools[move.tool]->bare.core_depth_mm;
    const bool goes_on =
        is_chained && is_core_free && move.has_start && toolpath.moves[i - 1].tool == move.tool;
    is_chained = is_core_free;
    if (!is_checked || (verdict.state == MoveState::gouge && !is_core_free)) continue;
    if (!goes_on) state = marker.at(motion_of(toolpath, i, options.rapid).start(), tools[move.tool]->bare);
    if (verdict.state == MoveState::gouge || (state == Inside::no && is_core_free)) continue;
    verdict.state = state == Inside::yes ? MoveState::buried : MoveState::not_certified;
    verdict.reason = state == Inside::yes ? kBuried : state == Inside::unknown ? kOpenMesh : kThinCutter;
  }
}

}  // namespace gouge
