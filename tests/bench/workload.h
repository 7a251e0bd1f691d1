#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/check/check_path.h"
#include "lib/check/check_result.h"
#include "tests/bench/bench_tool.h"
#include "tests/bench/place_tool.h"

// The generated work that the engine and its peers are measured with: a closed solid at a choice of
// tessellations, a tool with a holder, and a 5-axis finishing path of 20,000 moves laid exactly 0.005 mm over
// that very mesh, with stretches that gouge, passes where the holder hits, and air passes.
//
// Generating takes from seconds to a minute. With the environment variable GOUGE_BENCH_CACHE naming a folder,
// the placed positions are kept there and read back.

namespace gouge::bench {

enum class BenchPart : std::uint8_t { wavy, unseen };
enum class ToolKind : std::uint8_t { ball, bull, taper };

/// Class of a move by the reference results of its two ends.
enum class MoveGroup : std::uint8_t { contact, air, gouge, holder, link };
[[nodiscard]] const char* group_name(MoveGroup group);

struct WorkloadKey {
  BenchPart part = BenchPart::wavy;
  ToolKind tool = ToolKind::ball;
  std::size_t triangles = 2400;  ///< requested; the mesh has within 2 % of it
  std::size_t density = 1;       ///< positions for each of the 20,000 of the curve
};

struct Workload {
  BenchTool tool;
  Scene scene;                        ///< one part, no fixture
  std::vector<PlacedPose> positions;  ///< one a move, its end
  std::vector<MoveGroup> groups;      ///< one a move
  Toolpath path;                      ///< one tool, kind feed; move 0 is the first position alone
};

inline constexpr std::size_t kSizes[] = {2400, 20000, 200000, 2000000};

/// Cost: seconds, or up to a minute for density 10 or 2,000,000 triangles. `threads` only shortens it.
[[nodiscard]] Workload make_workload(const WorkloadKey& key, unsigned threads = 2);

/// The mesh alone.
[[nodiscard]] IndexedMesh make_bench_mesh(BenchPart part, std::size_t triangles);

/// The moves of one group, each with its own start; the other fields as in `path`.
[[nodiscard]] Toolpath only(const Workload& work, MoveGroup group);

}  // namespace gouge::bench
