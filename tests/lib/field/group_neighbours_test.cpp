#include "lib/field/group_neighbours.h"

#include <gtest/gtest.h>

namespace gouge::group_neighbours_test {
namespace {

struct Counted {
  explicit Counted(int kind_of) : kind(kind_of) {}
  Counted(std::span<const Counted> of, std::uint32_t first)
      : kind(of.front().kind), parts(of.size()), first_part(first) {}
  [[nodiscard]] bool is_of(const Counted& other) const { return kind == other.kind; }

  int kind;
  std::size_t parts = 0, first_part = 0;
};

// How often each of the bodies is reached from the roots; groups must hold one kind.
std::vector<int> reached(const std::vector<Counted>& bodies, std::size_t roots) {
  std::vector<int> times(bodies.size(), 0);
  for (std::size_t b = bodies.size(); b-- > 0;) {
    if (b >= bodies.size() - roots) ++times[b];
    for (std::size_t k = 0; k < bodies[b].parts; ++k) {
      EXPECT_EQ(bodies[bodies[b].first_part + k].kind, bodies[b].kind);
      times[bodies[b].first_part + k] += times[b];
    }
  }
  return times;
}

TEST(GroupNeighbours, StandForEachBodyOnce) {
  for (const std::size_t count : {0U, 1U, 4U, 5U, 64U, 1000U}) {
    for (const std::size_t run : {1U, 3U, 1000U}) {
      std::vector<Counted> bodies;
      for (std::size_t k = 0; k < count; ++k) bodies.emplace_back(static_cast<int>(k / run));
      const std::size_t roots = group_neighbours(bodies);
      EXPECT_EQ(reached(bodies, roots), std::vector<int>(bodies.size(), 1)) << count << " in runs of " << run;
      if (run == 1000) {
        EXPECT_LE(roots, 4U);
      }
    }
  }
}

}  // namespace
}  // namespace gouge::group_neighbours_test
