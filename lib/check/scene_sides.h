#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "lib/base/paged_memory.h"
#include "lib/check/scene.h"
#include "lib/mesh/enclosure.h"
#include "lib/mesh/union_find.h"

// Decision of inside and outside of a scene, for the tool and for heads. Proofs: docs/method/inside_outside.md.

namespace gouge {

struct SideResult {
  Side side = Side::unknown;
  std::string why;  ///< for Side::unknown: the mesh that does not decide it, and its fault
};

/// The enclosures of a scene, one for all meshes of each obstacle.
class SceneSides {
 public:
  /// Builds the enclosures. The scene must outlive the object.
  explicit SceneSides(const Scene& scene);

  /// Returns a set of bits: bit k is set if the point is beyond all meshes of obstacle k.
  [[nodiscard]] std::uint8_t beyond(const Vec3& point) const;
  [[nodiscard]] std::uint8_t beyond_all() const { return static_cast<std::uint8_t>((1U << obstacles_.size()) - 1); }

  /// Returns outside only if the points are outside of all obstacles, and inside if they are inside of one. `beyond` is
  /// the part of the answer that is already known.
  [[nodiscard]] SideResult side_of(const ConnectedPoints& joined, std::uint8_t beyond = 0) const;

 private:
  std::deque<Enclosure> obstacles_;  // at most eight, because each has one bit
};

/// Points that moves keep free of all surfaces, numbered from 0. Two points are joined if one moves to the other. A
/// side proved for one point holds for all points joined with it, earlier and later on the path.
class FreeChains {
 public:
  FreeChains(const SceneSides& sides, std::size_t count) : sides_(sides), joins_(count), beyond_(count, 0) {}

  /// Joins two items. The facts known about `b` hold for `a` too.
  void join(std::size_t a, std::size_t b) {
    joins_.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    beyond_[a] |= beyond_[b];
  }
  /// Returns whether the item is known to be beyond all obstacles, so that more points tell nothing.
  [[nodiscard]] bool is_settled(std::size_t item) const { return beyond_[item] == sides_.beyond_all(); }
  /// Adds `point`, which `item` keeps free of surfaces.
  void add(std::size_t item, const Vec3& point) { beyond_[item] |= sides_.beyond(point); }

  /// Decides each chain that was not seen beyond all meshes; `points_of` returns points of an item. Items that
  /// `is_asked` excludes belong to no chain and get no result; if it is empty, all are tested.
  /// Ensures  The results are the same at any number of threads.
  void decide(unsigned threads, const std::function<ConnectedPoints(std::size_t)>& points_of,
              const std::function<bool(std::size_t)>& is_asked = {});

  /// Returns the side of an item. Requires decide().
  [[nodiscard]] const SideResult& result(std::size_t item) {
    return results_[result_of_[joins_.root(static_cast<std::uint32_t>(item))]];
  }

 private:
  const SceneSides& sides_;
  UnionFind joins_;
  PagedVector<std::uint8_t> beyond_;
  PagedVector<std::uint32_t> result_of_;  // indexed by the root of a chain
  std::vector<SideResult> results_;
};

}  // namespace gouge
