#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lib/contact/left_stock.h"
#include "lib/tilt/tilt_lattice.h"
#include "lib/tilt/tilt_run.h"

namespace gouge {

/// The surface that a path cuts while its runs are tilted one by one. It is the programmed surface except for accepted
/// runs. Rapids do not cut.
class CutPath {
 public:
  /// `job` must outlive it.
  explicit CutPath(const TiltJob& job) : job_(job) {}

  /// Returns the stock that would be left on the finished surface if this run were tilted too. Nothing: provably at
  /// most TiltOptions::max_stock_mm above the tolerance is left.
  [[nodiscard]] std::optional<LeftStock> left_by(const TiltSpace& space, const TiltSequence& tilts) const;

  void accept(const TiltSpace& space, const TiltSequence& tilts);

 private:
  struct Replaced {
    double from = 0, to = 1;  ///< instants of the move
  };
  using ReplacedMoves = std::map<std::size_t, std::vector<Replaced>>;
  struct Cut {
    Motion motion;
    std::size_t tool = 0, move = 0;
  };

  [[nodiscard]] static ReplacedMoves replaced_by(const TiltSpace& space);
  [[nodiscard]] const MotionLaw& law() const { return job_.checker.options().law; }
  [[nodiscard]] std::vector<Cut> tilted(const TiltSpace& space, const TiltSequence& tilts, std::size_t tool) const;
  void add_unchanged(const ReplacedMoves& replaced, const Vec3& centre, double radius_mm, CutterSweep& sweep) const;
  [[nodiscard]] std::size_t tool_of(const TiltSpace& space) const { return job_.path.moves[space[0].move].tool; }

  const TiltJob& job_;
  ReplacedMoves replaced_;
  std::vector<Cut> accepted_;
};

}  // namespace gouge
