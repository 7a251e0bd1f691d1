#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/verify/program_cuts.h"
#include "lib/verify/space_block.h"

// Cutters that a proof about stock names: at one instant of a cut, or between two instants of a straight cut.

namespace gouge {

/// One instant of a cut, or the time between two of them. Its piece of motion is halved `level` times. An instant is at the
/// start of one of these 2^level parts, or at the end of the piece: place 2^level.
struct NamedCut {
  std::uint64_t program = 0;  ///< index among the programs, in the order of time
  std::uint64_t move = 0;
  std::uint64_t piece = 0;  ///< index among the pieces of the move
  std::uint64_t level = 0, first = 0, last = 0;

  /// Returns the last instant as a share of the piece.
  [[nodiscard]] double share() const { return static_cast<double>(last) / static_cast<double>(1ULL << level); }
  bool operator==(const NamedCut&) const = default;
};
inline constexpr std::uint64_t kMaxCutLevel = 40;

/// The latest instant that a cut may have: a program, a move, a piece of motion and a share of it.
struct LatestInstant {
  std::size_t move = 0, piece = 0;  ///< of the last program
  double share = 0;
};

/// Returns whether an instant of a cut is no later. `last` is the index of the last program.
[[nodiscard]] bool is_by(const NamedCut& cut, std::size_t last, const LatestInstant& latest);

void append_cut(const NamedCut& cut, std::string& steps);
/// Removes a cut from the beginning of the steps; nothing: they have none.
[[nodiscard]] std::optional<NamedCut> take_cut(std::string_view& steps);

/// The poses at both instants of a cut. Between them the tip runs straight and the axis stands still.
struct CutPoses {
  PoseBounds first, last;
};

/// Returns whether the tip of a piece runs straight and its axis stands still, up to rounding.
[[nodiscard]] bool is_straight(const MotionPiece& piece);

/// The programs of a stock, with the cutters of their cuts.
class CutPrograms {
 public:
  /// The programs must outlive it. Cost: some microseconds for each move.
  explicit CutPrograms(const std::vector<ClaimedProgram>& programs);

  [[nodiscard]] std::size_t size() const { return programs_.size(); }
  [[nodiscard]] const ProgramCuts& at(std::size_t program) const { return *programs_[program]; }
  /// Returns the program of the path whose moves are proved.
  [[nodiscard]] const ProgramCuts& last() const { return *programs_.back(); }
  /// Returns the cutter of a cut; null: there is no such cut, or its contour is not closed.
  [[nodiscard]] const ToolContour* cutter_of(const NamedCut& cut) const;
  /// Returns bounds of the poses of a cut; nothing: there are none, or the cut has two instants and is not straight.
  /// Requires a cut with a cutter, RoundsUpward.
  [[nodiscard]] std::optional<CutPoses> poses_of(const NamedCut& cut) const;

 private:
  std::vector<std::unique_ptr<const ProgramCuts>> programs_;
};

/// Returns the pose at a place of a piece that is halved `level` times.
[[nodiscard]] PoseBounds pose_at_place(const MotionPiece& piece, std::uint64_t level, std::uint64_t place);

/// Returns the share of a straight way at which an axis passes nearest to a point; both are relative to the start of the way.
[[nodiscard]] double share_on_way(const Vec3& point, const Vec3& way, const Vec3& axis);

/// Returns bounds of the heights of a block above the tip of a cutter, at all poses between two.
[[nodiscard]] Bounds heights_between(const SpaceBlock& block, const CutPoses& poses);

/// Proves that the cylinder about the axis with this radius, between these heights, is in the cutter or within `wider_mm` of
/// it. Requires RoundsUpward.
[[nodiscard]] bool has_cylinder(const ToolContour& cutter, double radius_mm, const Bounds& heights, double wider_mm);

/// Proves that every point of the block is in the cutter between these poses, or within `wider_mm` of it. Requires
/// RoundsUpward. Cost: linear in the pieces of the contour.
[[nodiscard]] bool is_within_cutter(const ToolContour& cutter, const CutPoses& poses, const SpaceBlock& block,
                                    double wider_mm);

}  // namespace gouge
