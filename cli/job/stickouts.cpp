#include "cli/job/stickouts.h"

#include <utility>

#include "toolmodels/compile_tool.h"

namespace gouge {
namespace {

Result<std::vector<HeadBody>> moved_up(const std::vector<HeadBody>& heads, double by_mm) {
  std::vector<HeadBody> moved;
  for (const HeadBody& head : heads) {
    IndexedMesh mesh = head.whole.mesh();
    for (Vec3& vertex : mesh.vertices) vertex.z() += by_mm;
    Result<HeadBody> body = build_head_body(std::move(mesh));
    if (!body) return body.error();
    moved.push_back(std::move(*body));
  }
  return moved;
}

}  // namespace

Result<std::vector<StickoutFacts>> find_stickouts_of(const Job& job, const PreparedScene& scene,
                                                     const CheckResult& result, bool is_extended_up,
                                                     const StickoutOptions& options, const ProgressCall& progress) {
  const CheckOptions& check = job.options.check;
  const MakeLongerTool make = [&](std::size_t tool, double longer_mm) -> Result<LongerTool> {
    const ToolAssembly longer = with_longer_stickout(*job.assemblies[tool], longer_mm);
    Result<ToolVariants> bodies = make_non_cutting_variants(is_extended_up ? job.without_end(longer) : longer,
                                                            check.shank_clearance_mm, check.holder_clearance_mm);
    if (!bodies) return bodies.error();
    Result<std::vector<HeadBody>> heads = moved_up(job.heads(), longer_mm);
    if (!heads) return heads.error();
    return LongerTool{std::move(*bodies), std::move(*heads)};
  };
  std::vector<std::optional<double>> now_mm;
  for (const auto& tool : job.assemblies) now_mm.push_back(tool ? std::optional(stickout_mm(*tool)) : std::nullopt);
  Result<std::vector<ToolStickout>> found =
      find_stickouts(job.toolpath, result, job.setup(scene), now_mm, make, options, progress);
  if (!found) return found.error();
  std::vector<StickoutFacts> facts;
  for (ToolStickout& one : *found) {
    const ToolAssembly& tool = *job.assemblies[one.tool];
    const bool is_stated = tool.stickout_mm > 0;
    facts.push_back({std::move(one), is_stated ? std::optional(shank_end_mm(tool)) : std::nullopt});
  }
  return facts;
}

}  // namespace gouge
