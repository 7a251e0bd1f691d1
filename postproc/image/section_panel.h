#pragma once

#include "lib/tool/compiled_tool.h"
#include "postproc/image/page.h"
#include "postproc/image/section.h"

namespace gouge {

/// Content of one section panel.
struct SectionPanel {
  Area area;
  Vec2 centre = Vec2::Zero();  ///< point of the plane in the middle of the panel
  double mm_per_unit = 1;
  [[nodiscard]] Vec2 place(const Vec2& p) const {
    return {area.middle().x() + (p.x() - centre.x()) / mm_per_unit,
            area.middle().y() - (p.y() - centre.y()) / mm_per_unit};
  }
};

/// Paints the material (only if `is_closed`, else just its outline), the tool, the heads and their overlap with
/// material. Clearances or stock to leave may make the checked outline larger than the tool. Then that outline is
/// dashed. `clearance_mm` is that of the mesh, around the whole tool.
void draw_section(Page& page, const SectionPanel& panel, const Section& section, bool is_closed,
                  const CompiledTool& bare, const CompiledTool& checked, double clearance_mm = 0);

}  // namespace gouge
