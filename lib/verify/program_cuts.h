#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "lib/verify/claimed_stock.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"

namespace gouge {

/// The contours of a tool that cuts stock.
struct CutterForms {
  explicit CutterForms(const ToolVariants& tool)
      : whole(tool.bare), cutting(tool.cutting), non_cutting(tool.non_cutting) {}
  ToolContour whole, cutting, non_cutting;
};

/// The cuts of one program, with a ball about the tips of each and of each block of them.
class ProgramCuts {
 public:
  /// `program` must outlive it. Cost: some microseconds and 64 bytes for each move.
  explicit ProgramCuts(const ClaimedProgram& program);

  [[nodiscard]] const Toolpath& path() const { return program_.scene.path; }
  [[nodiscard]] const ClaimedScene& scene() const { return program_.scene; }
  /// Returns the contours of the tool of a move; null: it is not defined.
  [[nodiscard]] const CutterForms* forms_of(std::size_t move) const;
  [[nodiscard]] bool is_known(std::size_t move) const;
  [[nodiscard]] bool cuts(std::size_t move) const;
  /// Returns the body that must be clear of stock: the whole tool, or shank and holder of a move that cuts. Requires a tool.
  [[nodiscard]] const ToolContour& body_of(std::size_t move) const;

  /// Returns the first move below `before` whose cutter may come nearer to a point than `within_mm`. A motion that is not
  /// known here may come anywhere, if `counts_unknown`.
  [[nodiscard]] std::optional<std::size_t> nearer(const Vec3& point, std::size_t before, double within_mm,
                                                  bool counts_unknown) const;
  /// Returns the largest distance of a point of a cutter from its tip.
  [[nodiscard]] double largest_mm() const { return largest_mm_; }
  /// Returns the largest distance of a tip of a cut from its first tip.
  [[nodiscard]] double longest_mm() const { return longest_mm_; }
  /// Calls `visit(move)` for each cut below `before` whose cutter may come nearer to a point than `within_mm`.
  template <typename Visit>
  void visit_near(const Vec3& point, std::size_t before, double within_mm, const Visit& visit) const {
    for (std::size_t b = 0; b * kBlock < before; ++b) {
      if (is_beyond(blocks_[b], point, within_mm)) continue;
      for (std::size_t i = b * kBlock; i < std::min(before, (b + 1) * kBlock); ++i)
        if (!is_beyond(balls_[i], point, within_mm)) visit(i);
    }
  }

 private:
  static constexpr std::size_t kBlock = 64;  // moves that share a ball

  /// All tips of some moves are within `radius_mm` of the center.
  struct Ball {
    Vec3 center = Vec3::Zero();
    double radius_mm = -1;  ///< below 0: no move
    void add(const Vec3& point, double slack_mm);
  };

  [[nodiscard]] bool is_beyond(const Ball& ball, const Vec3& point, double within_mm) const;
  [[nodiscard]] Ball ball_of(std::size_t move);
  [[nodiscard]] bool may_reach(std::size_t move, const Vec3& point, double within_mm, bool counts_unknown) const;

  const ClaimedProgram& program_;
  std::vector<std::unique_ptr<const CutterForms>> forms_;
  std::vector<Ball> balls_, blocks_;
  double largest_mm_ = 0, longest_mm_ = 0;
};

}  // namespace gouge
