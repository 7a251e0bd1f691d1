#include "lib/penetration/node_boxes.h"

#include <algorithm>

namespace gouge {

void fill_node_boxes(DepthBody& body) {
  body.boxes.resize(6 * body.tree.nodes.size());
  for (std::size_t n = body.tree.nodes.size(); n-- > 0;) {
    const KdopNode& node = body.tree.nodes[n];
    float* const box = body.boxes.data() + 6 * n;
    Box3 all;
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      for (const Vec3& corner : body.corners[node.first + k]) all.extend(corner);
    }
    for (int i = 0; i < 3; ++i) {
      if (node.children == 0) {
        box[i] = static_cast<float>(all.min()[i]) - body.slack_mm;
        box[i + 3] = static_cast<float>(all.max()[i]) + body.slack_mm;
        continue;
      }
      const float* const first = body.boxes.data() + 6 * std::size_t{node.first};
      box[i] = first[i];
      box[i + 3] = first[i + 3];
      for (std::size_t k = 1; k < node.children; ++k) {
        box[i] = std::min(box[i], first[6 * k + static_cast<std::size_t>(i)]);
        box[i + 3] = std::max(box[i + 3], first[6 * k + static_cast<std::size_t>(i) + 3]);
      }
    }
  }
}

}  // namespace gouge
