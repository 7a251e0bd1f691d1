#include "postproc/image/depth_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "lib/base/parallel.h"
#include "lib/check/check_path.h"
#include "lib/tool/evaluate.h"
#include "lib/tool/evaluate_batch.h"
#include "postproc/image/pixel_points.h"

namespace gouge {
namespace {

constexpr double kUnseen = 1.03;  // a deeper pose is not looked at when no eye could tell its colour
constexpr std::size_t kLeafPoints = 16;
constexpr std::size_t kBlocks = 64;

double signed_distance(const CompiledTool& tool, const Pose& pose, const Vec3& p) {
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis);
  return evaluate(tool, (d - pose.axis * z).norm(), z).signed_distance_mm;
}

// Instants so close that what the tool leaves between two of them stays a small part of the depth.
std::size_t instants_of(const Motion& motion, const CompiledTool& tool, double depth_mm) {
  // A holder is wide, but what moves slowly across the part is mostly the cutter, and its curvature counts.
  const double reach = std::clamp(tool.core_depth_mm, 0.1, std::max(tool.r_max_mm, 0.1));
  double travel = 0;
  for (std::uint32_t s = 0; s < motion.stretches().size(); ++s)
    travel += motion.way_mm(motion.stretches()[s].t0, motion.stretches()[s].t1, s);
  travel += std::abs(motion.angle_rad()) * 0.5 * (tool.z_max_mm - tool.z_min_mm);
  const double step = std::max(std::sqrt(8 * reach * 0.01 * std::max(depth_mm, 1e-3)), 0.02 * reach);
  return static_cast<std::size_t>(std::clamp(std::ceil(travel / step), 1.0, 400.0));
}

}  // namespace

DepthField::DepthField(const PictureInput& input, std::size_t most_poses)
    : tolerance_mm_(input.options.tolerance_mm) {
  const std::vector<MoveVerdict>& verdicts = input.result->verdicts;
  // Fewer instants a move when there would be too many of them; the worst instant of a move always stays.
  for (double detail = 1; detail > 0.01; detail *= 0.5) {
    poses_.clear();
    for (std::size_t i = 0; i < verdicts.size() && poses_.size() <= most_poses; ++i) {
      if (verdicts[i].state == MoveState::gouge) add_move(input, i, detail);
    }
    if (poses_.size() <= most_poses) return;
  }
  add_worst_only(input, most_poses);
}

// Too many gouging moves even so: the worst of each group of neighbours.
void DepthField::add_worst_only(const PictureInput& input, std::size_t most_poses) {
  const std::vector<MoveVerdict>& verdicts = input.result->verdicts;
  std::vector<std::size_t> gouging;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].state == MoveState::gouge) gouging.push_back(i);
  }
  const std::size_t group = gouging.size() / std::max<std::size_t>(most_poses / 2, 1) + 1;
  poses_.clear();
  for (std::size_t first = 0; first < gouging.size(); first += group) {
    // Depths are known to the resolution; equal ones leave the picks evenly spread.
    const double equal = input.options.resolution_mm;
    std::size_t worst = gouging[first];
    for (std::size_t k = first; k < std::min(first + group, gouging.size()); ++k) {
      if (verdicts[gouging[k]].depth_mm > verdicts[worst].depth_mm + equal) worst = gouging[k];
    }
    add_move(input, worst, 0);
  }
}

void DepthField::add_move(const PictureInput& input, std::size_t index, double detail) {
  const Move& move = input.toolpath->moves[index];
  if (move.tool >= input.tools.size() || input.tools[move.tool] == nullptr) return;
  const ToolForms* forms = input.tools[move.tool];
  const Motion motion = motion_of(*input.toolpath, index, input.options.rapid);
  if (!motion.is_defined()) return;
  const MoveVerdict& verdict = input.result->verdicts[index];
  if (verdict.witness) poses_.push_back({motion.at(verdict.witness->t), forms, index});
  if (motion.is_alone()) return;
  const auto whole = static_cast<double>(instants_of(motion, forms->against_part, verdict.depth_mm));
  const std::size_t steps = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(whole * detail)));
  for (std::size_t k = detail < 0.1 ? steps : 0; k <= steps; ++k) {
    poses_.push_back({motion.at(static_cast<double>(k) / static_cast<double>(steps)), forms, index});
  }
}

/// Points in a tree of boxes, so that a pose visits only what its tool can reach.
class DepthField::PointTree {
 public:
  PointTree(const std::vector<Point>& points, double tolerance_mm)
      : points_(points), tolerance_(tolerance_mm), order_(points.size()), depth_(points.size(), 0.0F) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!points.empty()) build(0, points.size(), std::max<std::size_t>(points.size() / kBlocks, kLeafPoints));
  }

  std::vector<float> answer(const std::vector<FieldPose>& poses) {
    // Blocks share no points, so they may be done in any order.
    for_each_chunk(blocks_.size(), 1, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        for (const FieldPose& pose : poses) visit(blocks_[b], pose);
      }
    });
    return depth_;
  }

 private:
  struct Node {
    Vec3 centre = Vec3::Zero();
    double radius = 0;
    std::size_t first = 0, last = 0;
    std::size_t child = 0;  // of two neighbours; 0: a leaf
    float least = 0;        // smallest depth found below
  };

  std::size_t build(std::size_t first, std::size_t last, std::size_t block) {
    const std::size_t at = nodes_.size();
    nodes_.resize(at + 1);
    fill(at, first, last, block, false);
    return at;
  }

  void fill(std::size_t at, std::size_t first, std::size_t last, std::size_t block, bool is_in_block) {
    Box3 box;
    for (std::size_t i = first; i < last; ++i) box.extend(points_[order_[i]].at);
    nodes_[at] = {box.center(), 0.5 * box.diagonal().norm(), first, last, 0, 0};
    if (!is_in_block && last - first <= block) {
      blocks_.push_back(at);
      is_in_block = true;
    }
    if (last - first <= kLeafPoints) return;
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = first + (last - first) / 2;
    const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(first), place(middle), place(last), [&](std::size_t a, std::size_t b) {
      const double xa = points_[a].at[axis];
      const double xb = points_[b].at[axis];
      return xa < xb || (!(xb < xa) && a < b);
    });
    const std::size_t child = nodes_.size();
    nodes_.resize(child + 2);
    nodes_[at].child = child;
    fill(child, first, middle, block, is_in_block);
    fill(child + 1, middle, last, block, is_in_block);
  }

  // The part form holds every other form inside it up to its clearances, so it decides what is far away.
  void visit(std::size_t at, const FieldPose& pose) {
    Node& node = nodes_[at];
    const double distance = std::min(signed_distance(pose.tool->against_part, pose.pose, node.centre),
                                     signed_distance(pose.tool->against_fixture, pose.pose, node.centre));
    const double floor = pose.tool->with_clearance.elements.empty() ? tolerance_ : 0.0;
    if (node.radius - distance <= std::max(floor, kUnseen * static_cast<double>(node.least))) return;
    if (node.child != 0) {
      const std::size_t child = node.child;
      visit(child, pose);
      visit(child + 1, pose);
      nodes_[at].least = std::min(nodes_[child].least, nodes_[child + 1].least);
      return;
    }
    const std::array<float, kLeafPoints> told = told_depths(node, pose);
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = node.first; i < node.last; ++i) {
      float& depth = depth_[order_[i]];
      depth = std::max(depth, told[i - node.first]);
      least = std::min(least, depth);
    }
    node.least = least;
  }

  [[nodiscard]] std::array<float, kLeafPoints> told_depths(const Node& leaf, const FieldPose& pose) const {
    const std::size_t count = leaf.last - leaf.first;
    std::array<double, kLeafPoints> r{}, z{}, part{}, fixture{}, clearance{};
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 d = points_[order_[leaf.first + i]].at - pose.pose.tip;
      z[i] = d.dot(pose.pose.axis);
      r[i] = (d - pose.pose.axis * z[i]).norm();
    }
    const auto ask = [&](const CompiledTool& form, std::array<double, kLeafPoints>& out) {
      signed_distances(form, {r.data(), count}, {z.data(), count}, {out.data(), count});
    };
    ask(pose.tool->against_part, part);
    ask(pose.tool->against_fixture, fixture);
    if (!pose.tool->with_clearance.elements.empty()) ask(pose.tool->with_clearance, clearance);
    std::array<float, kLeafPoints> told{};
    for (std::size_t i = 0; i < count; ++i) {
      const double depth = -(points_[order_[leaf.first + i]].is_fixture ? fixture : part)[i];
      told[i] = static_cast<float>(std::max({depth > tolerance_ ? depth : 0.0, -clearance[i], 0.0}));
    }
    return told;
  }

  const std::vector<Point>& points_;
  double tolerance_;
  std::vector<std::size_t> order_;
  std::vector<float> depth_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> blocks_;
};

std::vector<float> DepthField::depth_at(const std::vector<Point>& points) const {
  if (poses_.empty()) return std::vector<float>(points.size(), 0.0F);
  return PointTree(points, tolerance_mm_).answer(poses_);
}

std::vector<float> DepthField::depth_on_pixels(const PictureScene& scene, const SurfaceBuffer& buffer) const {
  if (poses_.empty()) return std::vector<float>(buffer.z.size(), 0.0F);
  const PixelPoints seen = pixel_points(buffer);
  std::vector<Point> points;
  points.reserve(seen.points.size());
  for (const PixelPoints::Point& p : seen.points) points.push_back({p.at, scene.faces[p.face].is_fixture});
  return seen.spread(depth_at(points));
}

}  // namespace gouge
