#include "lib/field/point_tree.h"

#include <algorithm>
#include <numeric>

namespace gouge {
namespace {

constexpr std::size_t kBlocks = 64;

}  // namespace

PointTree::PointTree(const std::vector<Vec3>& points) : order_(points.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (points.empty()) return;
  nodes_.resize(1);
  fill(points, 0, 0, points.size(), std::max(points.size() / kBlocks, kLeafPoints), false);
}

void PointTree::fill(const std::vector<Vec3>& points, std::size_t at, std::size_t first, std::size_t last,
                     std::size_t block, bool is_in_block) {
  Box3 box;
  for (std::size_t i = first; i < last; ++i) box.extend(points[order_[i]]);
  nodes_[at] = {box, box.center(), 0.5 * box.diagonal().norm(), first, last, 0};
  if (!is_in_block && last - first <= block) {
    blocks_.push_back(at);
    is_in_block = true;
  }
  if (last - first <= kLeafPoints) return;
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto swept = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(swept(first), swept(middle), swept(last), [&](std::size_t a, std::size_t b) {
    const double xa = points[a][axis], xb = points[b][axis];
    return xa < xb || (!(xb < xa) && a < b);
  });
  const std::size_t child = nodes_.size();
  nodes_.resize(child + 2);
  nodes_[at].child = child;
  fill(points, child, first, middle, block, is_in_block);
  fill(points, child + 1, middle, last, block, is_in_block);
}

}  // namespace gouge
