#include "lib/head/flat_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "lib/base/parallel.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/offset/vertex_offsets.h"

namespace gouge {
namespace {

constexpr double kFlat = 1e-7;         // of the size: roundings of single-precision files
constexpr double kSameNormal = 0.999;  // keeps slivers out, whose normals say little
constexpr std::size_t kMostRims = 200;
constexpr double kRim = 1e-6;  // of the size: walls that stand on a rim are not above the patch
constexpr std::size_t kChunk = 256;

class PatchFinder {
 public:
  explicit PatchFinder(const IndexedMesh& mesh)
      : mesh_(mesh),
        adjacency_(mesh),
        normals_(face_normals(mesh)),
        flat_mm_(kFlat * mesh.box().diagonal().norm()),
        patch_of_(mesh.triangles.size(), kNone) {}

  FlatPatches run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (patch_of_[t] != kNone) continue;
      const std::vector<std::uint32_t> faces = spread(t);
      FlatPatch patch = patch_about(t, faces);
      if (patch.rims.size() > kMostRims) {
        for (const std::uint32_t face : faces) add(patch_about(face, std::span(&face, 1)), std::span(&face, 1));
      } else {
        add(std::move(patch), faces);
      }
    }
    std::vector<FlatPatch> faces;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) faces.push_back(patch_about(t, std::span(&t, 1)));
    return {std::move(patches_), std::move(patch_of_), std::move(faces)};
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t kPending = kNone - 1;

  void add(FlatPatch patch, std::span<const std::uint32_t> faces) {
    for (const std::uint32_t face : faces) patch_of_[face] = static_cast<std::uint32_t>(patches_.size());
    patches_.push_back(std::move(patch));
  }

  /// The faces that share a plane with `seed` and hang together with it.
  std::vector<std::uint32_t> spread(std::uint32_t seed) {
    std::vector<std::uint32_t> faces = {seed};
    patch_of_[seed] = kPending;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (const std::uint32_t edge : adjacency_.edges_of_triangle(faces[i])) {
        for (const EdgeUse& use : adjacency_.uses(adjacency_.edges()[edge])) {
          if (patch_of_[use.triangle] != kNone || !is_level(use.triangle, seed)) continue;
          patch_of_[use.triangle] = kPending;
          faces.push_back(use.triangle);
        }
      }
    }
    return faces;
  }

  [[nodiscard]] bool is_level(std::uint32_t face, std::uint32_t seed) const {
    if (!(normals_[face].dot(normals_[seed]) > kSameNormal)) return false;
    const Vec3& on = mesh_.corner(seed, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(normals_[seed].dot(mesh_.corner(face, k) - on)) > flat_mm_) return false;
    }
    return true;
  }

  /// Edges that two of the faces run along in opposite directions are within; all others make the outline.
  [[nodiscard]] FlatPatch patch_about(std::uint32_t seed, std::span<const std::uint32_t> faces) const {
    FlatPatch patch;
    patch.up = normals_[seed];
    patch.offset = patch.up.dot(mesh_.corner(seed, 0));
    std::vector<std::pair<Corner, Corner>> edges;
    for (const std::uint32_t face : faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        edges.emplace_back(mesh_.triangles[face][k], mesh_.triangles[face][(k + 1) % 3]);
        patch.off_mm = std::max(patch.off_mm, std::abs(patch.up.dot(mesh_.corner(face, k)) - patch.offset));
      }
    }
    std::sort(edges.begin(), edges.end());
    const auto count = [&edges](Corner from, Corner to) {
      const auto [first, last] = std::equal_range(edges.begin(), edges.end(), std::pair(from, to));
      return last - first;
    };
    for (const auto& [from, to] : edges) {
      if (count(from, to) <= count(to, from)) continue;
      const Vec3 across = patch.up.cross(mesh_.vertices[to] - mesh_.vertices[from]);
      const double length = across.norm();
      const Vec3 inward = length > 0 ? Vec3(across / length) : Vec3(Vec3::Zero());
      patch.rims.push_back({inward, inward.dot(mesh_.vertices[from])});
    }
    return patch;
  }

  const IndexedMesh& mesh_;
  MeshAdjacency adjacency_;
  std::vector<Vec3> normals_;
  double flat_mm_;
  std::vector<std::uint32_t> patch_of_;
  std::vector<FlatPatch> patches_;
};

/// What stands lowest above one patch.
class ClearAbove {
 public:
  ClearAbove(const Surface& surface, const std::vector<std::uint32_t>& patch_of, FlatPatch& patch, std::uint32_t own,
             const Box3& box)
      : surface_(surface), patch_of_(patch_of), patch_(patch), own_(own), box_(box) {
    const double size = surface.mesh().box().diagonal().norm();
    patch.rim_mm = kRim * size;
    patch.clear_mm = box.diagonal().norm();
    for (int k = 0; k < 3; ++k) {
      const double rise = patch.up[k] * patch.clear_mm;
      box_.min()[k] += std::min(0.0, rise) - patch.rim_mm;
      box_.max()[k] += std::max(0.0, rise) + patch.rim_mm;
    }
    visit(0);
  }

 private:
  void visit(std::uint32_t index) {
    const BlockTree& tree = surface_.tree();
    const NodeBlock& node = tree.nodes[index];
    for (std::size_t lane = 0; lane < node.count; ++lane) {
      if (!LaneBound(tree, node, lane).box().intersects(box_)) continue;
      node.has_leaves ? visit_leaf(tree.leaves[node.child[lane]]) : visit(node.child[lane]);
    }
  }

  void visit_leaf(const TriangleBlock& leaf) {
    for (std::size_t k = 0; k < leaf.count; ++k) {
      if (patch_of_[leaf.triangle[k]] != own_) look_at(surface_.corners(leaf.triangle[k]));
    }
  }

  /// The part of a facet that stands over the patch, cut off at its rims.
  void look_at(const std::array<Vec3, 3>& facet) {
    std::vector<Vec3> left(facet.begin(), facet.end());
    left = cut(left, patch_.up, patch_.offset + patch_.off_mm);
    for (const FlatPatch::Rim& rim : patch_.rims) {
      if (left.empty()) return;
      left = cut(left, rim.inward, rim.offset + 0.5 * patch_.rim_mm);
    }
    for (const Vec3& x : left) patch_.clear_mm = std::min(patch_.clear_mm, std::max(0.0, patch_.height_mm(x)));
  }

  static std::vector<Vec3> cut(const std::vector<Vec3>& polygon, const Vec3& inward, double offset) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double in_a = inward.dot(a) - offset, in_b = inward.dot(b) - offset;
      if (in_a >= 0) kept.push_back(a);
      if ((in_a >= 0) != (in_b >= 0)) kept.push_back(a + in_a / (in_a - in_b) * (b - a));
    }
    return kept;
  }

  const Surface& surface_;
  const std::vector<std::uint32_t>& patch_of_;
  FlatPatch& patch_;
  std::uint32_t own_;
  Box3 box_;
};

}  // namespace

double FlatPatch::inside_mm(const Vec3& x) const {
  double least = rims.empty() ? -1.0 : std::numeric_limits<double>::infinity();
  for (const Rim& rim : rims) least = std::min(least, rim.inward.dot(x) - rim.offset);
  return least;
}

FlatPatches find_flat_patches(const IndexedMesh& mesh) { return PatchFinder(mesh).run(); }

void measure_clear_above(const Surface& surface, FlatPatches& flat) {
  const IndexedMesh& mesh = surface.mesh();
  std::vector<Box3> boxes(flat.patches.size());
  std::vector<std::uint32_t> itself(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    itself[t] = t;
    for (std::size_t k = 0; k < 3; ++k) boxes[flat.patch_of[t]].extend(mesh.corner(t, k));
  }
  const auto chunks = [](std::size_t count, const auto& body) {
    for_each_chunk(count, kChunk, 0, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) body(static_cast<std::uint32_t>(i));
    });
  };
  chunks(flat.patches.size(),
         [&](std::uint32_t p) { ClearAbove(surface, flat.patch_of, flat.patches[p], p, boxes[p]); });
  chunks(flat.faces.size(), [&](std::uint32_t t) {
    Box3 box;
    for (std::size_t k = 0; k < 3; ++k) box.extend(mesh.corner(t, k));
    ClearAbove(surface, itself, flat.faces[t], t, box);
  });
}

}  // namespace gouge
