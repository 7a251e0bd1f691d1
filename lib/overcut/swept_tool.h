#pragma once

#include "lib/overcut/swept_solid.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// A tool along one motion.
class SweptTool : public SweptSolid {
 public:
  /// Requires a tool with elements; it must outlive this.
  SweptTool(const Motion& motion, const CompiledTool& tool) : SweptSolid(motion), tool_(tool) {}

  [[nodiscard]] double distance_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] Vec3 outward_at(const Vec3& point_part, double t) const override;

 private:
  [[nodiscard]] double reach_mm() const override;

  const CompiledTool& tool_;
};

}  // namespace gouge
