#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lib/motion/motion.h"
#include "tests/bench/workload.h"

// Functions that the measuring programs share: the cases they run, a sample of poses and moves with the truth about
// each, and the counting of wrong results.

namespace gouge::bench {

/// The truth about a sampled pose or move: the smallest signed distance of the tool from the mesh, over the
/// instants examined. Independent of the engine.
struct SampledPose {
  std::size_t position = 0;
  double closest_mm = 0;
};
struct SampledMove {
  Motion motion;
  std::size_t move = 0;
  MoveGroup group = MoveGroup::contact;
  double closest_mm = 0;
};

struct PeerCase {
  BenchPart part = BenchPart::wavy;
  ToolKind tool = ToolKind::ball;
  std::size_t triangles = 0;
  Workload work;

  [[nodiscard]] std::string label() const;  ///< "wavy/ball/2400"
};

/// Positions in stretches of consecutive ones, evenly spread, `count` in all (or every one, if fewer).
[[nodiscard]] std::vector<SampledPose> sample_poses(const PeerCase& c, std::size_t count);

/// Moves likewise, each examined in 64 instants besides its start.
[[nodiscard]] std::vector<SampledMove> sample_moves(const PeerCase& c, std::size_t count);

/// Answers of a yes-or-no engine. What lies within a grey band about contact is not judged.
class Wrongs {
 public:
  /// `closest_mm` is the truth, `is_hit` the result.
  void count(double closest_mm, bool is_hit);
  void count_depth(double closest_mm, double depth_mm);
  void report(benchmark::State& state) const;

 private:
  std::size_t asked_ = 0, missed_ = 0, invented_ = 0;
  double largest_missed_mm_ = 0, largest_depth_error_mm_ = 0;
};

/// A pose as the rotation that takes tool coordinates (z along the axis) to part coordinates.
[[nodiscard]] Eigen::Matrix3d rotation_of(const Vec3& axis);

/// The surface of the whole tool as a closed mesh, chords within `chord_mm` of the true surface.
[[nodiscard]] IndexedMesh tessellate_tool(const BenchTool& tool, double chord_mm);

/// One thing to measure: `prepare` builds what it needs for a case, untimed, and hands back what is timed.
struct Measurement {
  std::string name;
  std::function<std::function<void(benchmark::State&)>(std::shared_ptr<const PeerCase>)> prepare;
  std::size_t largest = 2000000;  ///< greater meshes are left out
  std::size_t smallest = 0;       ///< and smaller ones
  std::size_t density = 1;
  bool is_for_all_tools = true;  ///< false: for the ball alone
};

/// Times are of the processor, which a busy machine disturbs less; the wall clock's stand beside them.
/// Registers each measurement for every queried part, tool and size as "<name>/<part>/<tool>/<size>". A case is
/// made when its turn comes and kept until another one's. The environment chooses: GOUGE_BENCH_SIZES (numbers
/// and commas), GOUGE_BENCH_PARTS ("wavy", "unseen" or both).
void register_measurements(std::vector<Measurement> measurements);

/// Answers every sampled pose once in each iteration and counts what is wrong. `depth` gives the depth, or
/// for an engine that only states yes or no, `is_yes_or_no`, something above or not above 0.
void time_poses(benchmark::State& state, const PeerCase& c, const std::vector<SampledPose>& sample,
                const std::function<double(const Pose&)>& depth, bool is_yes_or_no);

/// The same for moves; engines for motions state yes or no.
void time_moves(benchmark::State& state, const std::vector<SampledMove>& sample,
                const std::function<bool(const Motion&)>& is_hit);

/// True with GOUGE_BENCH_QUICK set: smaller samples, fewer repetitions.
[[nodiscard]] bool is_quick();

/// `count`, or a fourth of it in a quick run.
[[nodiscard]] std::size_t scaled(std::size_t count);

/// The main function of a measuring program.
int run_measurements(int count, char** words);

}  // namespace gouge::bench
