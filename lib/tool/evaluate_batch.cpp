#include "lib/tool/evaluate_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/instruction_sets.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr std::size_t kBlock = 64;

struct Block {
  const double* r;
  const double* z;
  std::size_t count;
  std::array<double, kBlock> behind;  // value of the border to the element before: >= 0 on this side
  std::array<double, kBlock> best;
};

// Keeps the value where the point lies in the element's domain and nothing seen so far is nearer. `ahead` is
// the border to the next element, which the next call finds in `behind`; the last element has none.
inline void keep(Block& block, std::size_t i, double ahead, double value) {
  const bool is_in_domain = (block.behind[i] >= 0) & (ahead < 0);
  const bool is_nearer = std::abs(value) < std::abs(block.best[i]);
  block.best[i] = (is_in_domain & is_nearer) ? value : block.best[i];
  block.behind[i] = ahead;
}

GOUGE_WIDE void look_at_segment(Block& block, const BoundaryElement& e, const DomainBorder& border) {
  const double nr = e.normal.x(), nz = e.normal.y(), ar = e.a.x(), az = e.a.y();
  const double dr = border.direction.x(), dz = border.direction.y();
  const double tr = border.through.x(), tz = border.through.y(), offset = border.offset;
  for (std::size_t i = 0; i < block.count; ++i) {
    const double ahead = offset + dr * (block.r[i] - tr) + dz * (block.z[i] - tz);
    keep(block, i, ahead, nr * (block.r[i] - ar) + nz * (block.z[i] - az));
  }
}

GOUGE_WIDE void look_at_round(Block& block, const BoundaryElement& e, const DomainBorder& border) {
  const bool is_vertex = e.kind == ElementKind::vertex;
  const double cr = is_vertex ? e.a.x() : e.center.x(), cz = is_vertex ? e.a.y() : e.center.y();
  const double radius = is_vertex ? 0.0 : e.radius_mm, sign = e.is_reflex ? -1.0 : 1.0;
  const double dr = border.direction.x(), dz = border.direction.y();
  const double tr = border.through.x(), tz = border.through.y(), offset = border.offset;
  for (std::size_t i = 0; i < block.count; ++i) {
    const double ahead = offset + dr * (block.r[i] - tr) + dz * (block.z[i] - tz);
    const double r = block.r[i] - cr, z = block.z[i] - cz;
    keep(block, i, ahead, sign * (std::sqrt(r * r + z * z) - radius));
  }
}

void look_at_all(const CompiledTool& tool, Block& block) {
  static const DomainBorder none{Vec2::Zero(), Vec2::Zero(), -1};
  std::fill_n(block.behind.begin(), block.count, 0.0);
  std::fill_n(block.best.begin(), block.count, std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < tool.elements.size(); ++k) {
    const DomainBorder& border = k < tool.borders.size() ? tool.borders[k] : none;
    const BoundaryElement& e = tool.elements[k];
    if (e.kind == ElementKind::segment)
      look_at_segment(block, e, border);
    else
      look_at_round(block, e, border);
  }
}

}  // namespace

void signed_distances_by_tree(const CompiledTool& tool, std::span<const double> r, std::span<const double> z,
                              std::span<double> distances_mm) {
  for (std::size_t i = 0; i < r.size(); ++i) distances_mm[i] = evaluate(tool, r[i], z[i]).signed_distance_mm;
}

void signed_distances_by_loop(const CompiledTool& tool, std::span<const double> r, std::span<const double> z,
                              std::span<double> distances_mm) {
  Block block;
  for (std::size_t first = 0; first < r.size(); first += kBlock) {
    block.r = r.data() + first;
    block.z = z.data() + first;
    block.count = std::min(kBlock, r.size() - first);
    look_at_all(tool, block);
    std::copy_n(block.best.begin(), block.count, distances_mm.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

void signed_distances(const CompiledTool& tool, std::span<const double> r, std::span<const double> z,
                      std::span<double> distances_mm) {
  const bool is_small = tool.elements.size() <= kLoopElements && !tool.borders.empty();
  (is_small ? signed_distances_by_loop : signed_distances_by_tree)(tool, r, z, distances_mm);
}

}  // namespace gouge
