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

// Inside and outside of a scene, for the tool and for heads. Proofs: docs/method/inside_outside.md.

namespace gouge {

struct SideResult {
  Side side = Side::unknown;
  std::string why;  ///< of unknown: which mesh does not decide it, and for which fault
};

/// The meshes of each obstacle together.
class SceneSides {
 public:
  /// The scene must outlive it.
  explicit SceneSides(const Scene& scene);

  /// Returns bits: bit k is set beyond all meshes of obstacle k.
  [[nodiscard]] std::uint8_t beyond(const Vec3& point) const;
  [[nodiscard]] std::uint8_t beyond_all() const { return static_cast<std::uint8_t>((1U << obstacles_.size()) - 1); }

  /// Returns the side: outside only when outside of all obstacles, inside when inside of one. In `beyond` is the part
  /// known already.
  [[nodiscard]] SideResult side_of(const ConnectedPoints& joined, std::uint8_t beyond = 0) const;

 private:
  std::deque<Enclosure> obstacles_;  // at most eight: one bit each
};

/// Points that moves keep free of all surfaces, numbered from 0 and joined where one leads to the next. A side proved
/// for one holds for all that are joined with it, before it on the path as well as after.
class FreeChains {
 public:
  FreeChains(const SceneSides& sides, std::size_t count) : sides_(sides), joins_(count), beyond_(count, 0) {}

  void join(std::size_t a, std::size_t b) { joins_.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)); }
  /// `point` is one that `item` keeps free.
  void add(std::size_t item, const Vec3& point) { beyond_[item] |= sides_.beyond(point); }

  /// Decides each chain that was not seen beyond everything; `points_of` gives points of an item.
  /// Motions that `is_asked` excludes belong to no chain and get no result. Empty: all are tested.
  /// Ensures the same results at any number of threads.
  void decide(unsigned threads, const std::function<ConnectedPoints(std::size_t)>& points_of,
              const std::function<bool(std::size_t)>& is_asked = {});

  /// Requires decide().
  [[nodiscard]] const SideResult& result(std::size_t item) {
    return results_[result_of_[joins_.root(static_cast<std::uint32_t>(item))]];
  }

 private:
  const SceneSides& sides_;
  UnionFind joins_;
  PagedVector<std::uint8_t> beyond_;
  PagedVector<std::uint32_t> result_of_;  // by root
  std::vector<SideResult> results_;
};

}  // namespace gouge
