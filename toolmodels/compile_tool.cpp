#include "toolmodels/compile_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "lib/tool/evaluate.h"
#include "toolmodels/bsp.h"
#include "toolmodels/elements.h"
#include "toolmodels/tilt_sweep.h"
#include "toolmodels/trace_regions.h"
#include "toolmodels/unite.h"

namespace gouge {
namespace {

void set_extent(CompiledTool& tool) {
  tool.z_min_mm = tool.z_max_mm = tool.elements.front().a.y();
  for (const BoundaryElement& e : tool.elements) {
    tool.z_min_mm = std::min({tool.z_min_mm, e.a.y(), e.b.y()});
    tool.z_max_mm = std::max({tool.z_max_mm, e.a.y(), e.b.y()});
    tool.r_max_mm = std::max({tool.r_max_mm, e.a.x(), e.b.x()});
    if (e.kind != ElementKind::arc) continue;
    // An arc may reach beyond its ends if it contains its lowest, highest or widest point.
    const auto reaches = [&](const Vec2& direction) {
      const double turn = e.is_reflex ? -1 : 1;
      return turn * cross(e.a - e.center, direction) > 0 && turn * cross(direction, e.b - e.center) > 0;
    };
    if (reaches({0, -1})) tool.z_min_mm = std::min(tool.z_min_mm, e.center.y() - e.radius_mm);
    if (reaches({0, 1})) tool.z_max_mm = std::max(tool.z_max_mm, e.center.y() + e.radius_mm);
    if (reaches({1, 0})) tool.r_max_mm = std::max(tool.r_max_mm, e.center.x() + e.radius_mm);
  }
}

double depth_on_axis(const CompiledTool& tool, double z) { return -signed_distance_mm(tool, 0, z); }

// Finds the deepest of evenly spaced points, then halves the spacing around it. The depth is 1-Lipschitz, so the result
// is within one spacing of the largest depth. In practice it is equal to it.
double deepest_on_axis(const CompiledTool& tool, double low, double high) {
  constexpr int kSamples = 512;
  double step = (high - low) / kSamples;
  double best = 0.5 * (low + high);
  for (int i = 1; i < kSamples; ++i) {
    const double z = low + i * step;
    if (depth_on_axis(tool, z) > depth_on_axis(tool, best)) best = z;
  }
  for (; step > Tolerance::kFewRoundings * (high - low); step /= 2)
    for (const double z : {best - step, best + step})
      if (z > low && z < high && depth_on_axis(tool, z) > depth_on_axis(tool, best)) best = z;
  return best;
}

void set_core(CompiledTool& tool) {
  double low = tool.z_max_mm, high = tool.z_min_mm;
  for (const BoundaryElement& e : tool.elements) {
    if (e.body != Body::cutter) continue;
    low = std::min({low, e.a.y(), e.b.y()});
    high = std::max({high, e.a.y(), e.b.y()});
  }
  if (low >= high) std::swap(low, high);
  double best = deepest_on_axis(tool, low, high);
  // Between these heights the axis may be only in the hollow of the cutter.
  if (!(depth_on_axis(tool, best) > 0)) best = deepest_on_axis(tool, tool.z_min_mm, tool.z_max_mm);
  tool.core = Vec2(0, best);
  tool.core_depth_mm = depth_on_axis(tool, best);
}

/// Lengths by which bodies grow, mm.
struct Growth {
  double stock_to_leave_mm = 0, shank_clearance_mm = 0, holder_clearance_mm = 0;
  double every_body_mm = 0;  ///< beside these
  bool is_swept = false;     ///< the bodies are swept over tilts
};

/// The bodies of a tool with the lengths by which they grow.
struct GrownBodies {
  OffsetBody bare_cutter, cutter_with_stock, bare_shank, offset_shank, bare_holder, offset_holder;

  GrownBodies(const BodyProfiles& bodies, const Growth& growth) {
    const auto& [cutter, shank, holder] = bodies;
    const double every_mm = growth.every_body_mm;
    bare_cutter = {&cutter, every_mm};
    cutter_with_stock = {&cutter, growth.stock_to_leave_mm + every_mm};
    bare_shank = {&shank, every_mm};
    offset_shank = {&shank, growth.shank_clearance_mm + every_mm};
    bare_holder = {&holder, every_mm};
    offset_holder = {&holder, growth.holder_clearance_mm + every_mm};
  }
};

/// Compiles unions of bodies of one tool. The last error is kept.
class UnionCompiler {
 public:
  UnionCompiler(const ToolAssembly& tool, const Growth& growth) : name_(label(tool)), is_swept_(growth.is_swept) {}

  [[nodiscard]] CompiledTool operator()(const std::vector<OffsetBody>& bodies) {
    const Result<Profile> united = unite(bodies);
    if (united) return compile_tool(name_, is_swept_ ? cut_at_turns(*united) : *united);
    error_ = united.error();
    error_->message = "tool " + name_ + ": " + error_->message;
    return {};
  }
  [[nodiscard]] const std::optional<Diagnostic>& error() const { return error_; }

 private:
  std::string name_;
  bool is_swept_;
  std::optional<Diagnostic> error_;
};

Result<ToolVariants> variants_of(const ToolAssembly& tool, const BodyProfiles& bodies, const Growth& growth) {
  const GrownBodies grown(bodies, growth);
  const Profile none;
  UnionCompiler compiled(tool, growth);
  const bool has_shank = growth.shank_clearance_mm > 0, has_holder = growth.holder_clearance_mm > 0;
  ToolVariants variants;
  variants.bare = compiled({grown.bare_cutter, grown.bare_shank, grown.bare_holder});
  variants.against_fixture =
      has_shank || has_holder ? compiled({grown.bare_cutter, grown.offset_shank, grown.offset_holder}) : variants.bare;
  variants.against_part = growth.stock_to_leave_mm > 0
                              ? compiled({grown.cutter_with_stock, grown.offset_shank, grown.offset_holder})
                              : variants.against_fixture;
  variants.with_clearance = compiled(
      {has_shank ? grown.offset_shank : OffsetBody{&none, 0}, has_holder ? grown.offset_holder : OffsetBody{&none, 0}});
  const bool is_alone = grown.bare_shank.profile->elements.empty() && grown.bare_holder.profile->elements.empty();
  variants.cutting = is_alone ? variants.against_part : compiled({grown.cutter_with_stock});
  variants.non_cutting = compiled({grown.offset_shank, grown.offset_holder});
  if (compiled.error()) return *compiled.error();
  return variants;
}

Result<AloneVariants> alone_variants(const ToolAssembly& tool, const BodyProfiles& bodies, const Growth& growth,
                                     const CompiledTool& cutting) {
  constexpr auto kCutter = static_cast<std::size_t>(Body::cutter), kShank = static_cast<std::size_t>(Body::shank),
                 kHolder = static_cast<std::size_t>(Body::holder);
  UnionCompiler compiled(tool, growth);
  const auto alone = [&](const OffsetBody& body) { return std::make_shared<const CompiledTool>(compiled({body})); };
  const GrownBodies grown(bodies, growth);
  const auto cutter_with_stock = std::make_shared<const CompiledTool>(cutting);
  AloneVariants variants;
  variants.bare[kCutter] = growth.stock_to_leave_mm > 0 ? alone(grown.bare_cutter) : cutter_with_stock;
  variants.bare[kShank] = alone(grown.bare_shank);
  variants.bare[kHolder] = alone(grown.bare_holder);
  variants.against_fixture = variants.bare;
  if (growth.shank_clearance_mm > 0) variants.against_fixture[kShank] = alone(grown.offset_shank);
  if (growth.holder_clearance_mm > 0) variants.against_fixture[kHolder] = alone(grown.offset_holder);
  variants.against_part = variants.against_fixture;
  variants.against_part[kCutter] = cutter_with_stock;
  if (compiled.error()) return *compiled.error();
  return variants;
}

// Returns the contour moved away from the axis, with its ends joined to the axis.
Profile moved_out(const Profile& body, double farther_mm) {
  Profile wide;
  if (body.elements.empty()) return wide;
  const Vec2 out(farther_mm, 0);
  const Body kind = body.elements.front().body;
  const Vec2 tip = body.elements.front().a, top = body.elements.back().b;
  wide.elements.push_back(make_segment(kind, tip, tip + out));
  for (ProfileElement element : body.elements) {
    element.a += out;
    element.b += out;
    element.center += out;
    wide.elements.push_back(element);
  }
  wide.elements.push_back(make_segment(kind, top + out, top));
  return wide;
}

}  // namespace

CompiledTool compile_tool(const std::string& name, const Profile& profile) {
  CompiledTool tool;
  tool.name = name;
  tool.elements = make_elements(profile);
  if (tool.elements.empty()) return tool;
  set_support_ranges(profile, tool.elements);
  tool.borders = make_borders(tool.elements);
  tool.nodes = build_bsp(tool.elements);
  if (tool.nodes.empty() && tool.elements.size() > 1) tool.stretches = make_contour_tree(tool.elements);
  set_extent(tool);
  set_core(tool);
  return tool;
}

namespace {

/// Returns the contours of all bodies, swept over the tilts of a tube.
Result<BodyProfiles> swept_profiles(const ToolAssembly& tool, const MotionTube& tube) {
  Result<BodyProfiles> bodies = make_body_profiles(tool);
  if (!bodies) return bodies;
  for (Profile& body : *bodies) {
    Result<Profile> swept = sweep_tilts(body, tube.axis_rad);
    if (!swept) return make_error(swept.error().code, "tool " + label(tool) + ": " + swept.error().message);
    body = *std::move(swept);
  }
  return bodies;
}

/// Lengths by which the bodies of a tool grow, and the tube of its motion.
struct Offsets {
  double stock_to_leave_mm = 0, shank_clearance_mm = 0, holder_clearance_mm = 0;
  MotionTube tube;
};

Growth growth_of(const Offsets& offsets) {
  return {offsets.stock_to_leave_mm, offsets.shank_clearance_mm, offsets.holder_clearance_mm, offsets.tube.tip_mm,
          offsets.tube.axis_rad > 0};
}

Result<ToolVariants> whole_variants(const ToolAssembly& tool, const Offsets& offsets, bool has_wide) {
  Result<BodyProfiles> bodies = swept_profiles(tool, offsets.tube);
  if (!bodies) return bodies.error();
  const Growth growth = growth_of(offsets);
  Result<ToolVariants> variants = variants_of(tool, *bodies, growth);
  if (!variants) return variants;
  Result<AloneVariants> alone = alone_variants(tool, *bodies, growth, variants->cutting);
  if (!alone) return alone.error();
  variants->alone = std::make_shared<const AloneVariants>(*std::move(alone));
  if (!has_wide || bodies->front().elements.empty()) return variants;
  const double farther_mm = 2 * variants->cutting.r_max_mm;
  for (Profile& body : *bodies) body = moved_out(body, farther_mm);
  Result<ToolVariants> wide = variants_of(tool, *bodies, growth);
  if (!wide) return wide.error();
  variants->wide = std::make_shared<const ToolVariants>(std::move(*wide));
  return variants;
}

Result<ToolVariants> body_variants(const ToolAssembly& tool, const Offsets& offsets) {
  return make_non_cutting_variants(tool, offsets.shank_clearance_mm, offsets.holder_clearance_mm, offsets.tube);
}

class SweptTools : public TiltedTools {
 public:
  SweptTools(const ToolAssembly& tool, const Offsets& offsets, bool has_cutter)
      : tool_(tool), offsets_(offsets), has_cutter_(has_cutter) {}

  [[nodiscard]] const ToolVariants* at(std::size_t level) const override {
    return made(levels_[level], [&]() -> Result<ToolVariants> {
      Offsets wider = offsets_;
      wider.tube.axis_rad += tilt_of_level_rad(level);
      return has_cutter_ ? whole_variants(tool_, wider, false) : body_variants(tool_, wider);
    });
  }

  [[nodiscard]] const ToolVariants* without_cutter() const override {
    const ToolVariants* const bodies = made(bodies_, [&]() -> Result<ToolVariants> {
      Result<ToolVariants> variants = body_variants(tool_, offsets_);
      if (variants) variants->tilted = std::make_shared<const SweptTools>(tool_, offsets_, false);
      return variants;
    });
    return bodies == nullptr || bodies->bare.elements.empty() ? nullptr : bodies;
  }

 private:
  struct Slot {
    std::once_flag is_made;
    std::optional<ToolVariants> variants;
  };

  template <typename Make>
  static const ToolVariants* made(Slot& slot, const Make& make) {
    std::call_once(slot.is_made, [&] {
      if (Result<ToolVariants> variants = make()) slot.variants = *std::move(variants);
    });
    return slot.variants ? &*slot.variants : nullptr;
  }

  ToolAssembly tool_;
  Offsets offsets_;
  bool has_cutter_;
  mutable std::array<Slot, kTiltLevels> levels_;
  mutable Slot bodies_;
};

}  // namespace

Result<ToolVariants> make_tool_variants(const ToolAssembly& tool, double stock_to_leave_mm, double shank_clearance_mm,
                                        double holder_clearance_mm, bool has_wide, const MotionTube& tube) {
  const Offsets offsets{stock_to_leave_mm, shank_clearance_mm, holder_clearance_mm, tube};
  Result<ToolVariants> variants = whole_variants(tool, offsets, has_wide);
  if (variants) variants->tilted = std::make_shared<const SweptTools>(tool, offsets, true);
  return variants;
}

Result<ToolVariants> make_non_cutting_variants(const ToolAssembly& tool, double shank_clearance_mm,
                                               double holder_clearance_mm, const MotionTube& tube) {
  Result<BodyProfiles> bodies = swept_profiles(tool, tube);
  if (!bodies) return bodies.error();
  bodies->at(static_cast<std::size_t>(Body::cutter)) = {};
  return variants_of(tool, *bodies, growth_of({0, shank_clearance_mm, holder_clearance_mm, tube}));
}

}  // namespace gouge
