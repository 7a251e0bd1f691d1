#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lib/motion/departure.h"
#include "lib/motion/motion_law.h"
#include "lib/path/toolpath.h"
#include "lib/stock/contour_hulls.h"
#include "lib/stock/convex_pieces.h"
#include "lib/stock/cover_motion.h"
#include "lib/stock/hull_region.h"
#include "lib/stock/motion_tree.h"
#include "lib/stock/move_places.h"
#include "lib/stock/stock_head.h"
#include "lib/stock/stock_options.h"
#include "lib/stock/tool_piece.h"
#include "lib/tool/tool_variants.h"

namespace gouge {

/// A tool for the questions about stock. Its bodies have no offsets.
struct StockTool {
  const ToolVariants* tool = nullptr;  ///< made without offsets; null: the tool has no definition
  bool cuts = true;                    ///< false: it removes no material, for example a probe
};

class CutHistory;

/// A move of one program of a history.
struct CutMove {
  const CutHistory* program = nullptr;  ///< null: no move
  std::size_t move = kNone;

  explicit operator bool() const { return program != nullptr; }
};

/// The earlier cut that passed a point nearest.
struct PassedBy {
  double distance_mm = 0;  ///< of its cutter from the point
  CutMove cut;
};

/// The place of a tool that is nearest to a point.
struct NearestPlace {
  double distance_mm = 0;        ///< signed; negative inside the tool
  Vec3 outward = Vec3::UnitZ();  ///< direction in which the distance grows
};

/// The bodies of tools that count: the cutters of motions that cut, or all bodies of all motions.
enum class PlacesOf : std::uint8_t { cutters, tools };

/// A ball, without what is above a plane across it: the points x with |x - center| <= radius_mm and
/// up . (x - center) <= height_mm.
struct CutBall {
  Vec3 center = Vec3::Zero();
  double radius_mm = 0;
  Vec3 up = Vec3::Zero();  ///< unit, or zero: the whole ball
  double height_mm = 0;
};

/// All motions of a path that remove material, held so that one can ask whether a piece of space is removed. Nothing is
/// simulated in advance: a piece is removed if it lies in one convex piece of one cutter during one earlier motion.
/// A history may follow another one, of a program that ran before. Then all moves of that program come first.
///
/// Proofs: docs/method/stock.md. Any number of threads may ask.
class CutHistory {
 public:
  /// `tools[k]` belongs to path.tools[k]. `earlier` is the history of the program before; null: there is none. All
  /// programs are in the same coordinates. `heads` move with every tool of the path; they touch material and remove none.
  /// All references must outlive it.
  CutHistory(const Toolpath& path, const MotionLaw& law, const std::vector<StockTool>& tools,
             const StockOptions& options, const CutHistory* earlier = nullptr, std::span<const StockHead> heads = {});

  /// Proves that every point of a piece is in an earlier cutter, wider by the resolution, at every instant of its
  /// interval. Only moves before `before`, and earlier programs, count. `hint` is a move that is tried first; the result
  /// does not depend on it. False: not proved.
  [[nodiscard]] bool is_removed(const SweptPiece& piece, std::size_t before, CutMove& hint) const;
  /// Both halves of is_removed: by the hint alone, and by a search for a move, which becomes the hint.
  [[nodiscard]] bool is_removed_by_hint(const SweptPiece& piece, std::size_t before, const CutMove& hint) const;
  [[nodiscard]] bool find_removal(const SweptPiece& piece, std::size_t before, CutMove& hint) const;
  /// Proves the same from the motion of a move over [0, until] alone.
  [[nodiscard]] bool is_removed_by(std::size_t move, double until, const SweptPiece& piece) const;

  /// Proves that no tool, with all its bodies, reached a point before a move, and that all motions until then are known.
  /// `hint` is a move that is tried first; the result does not depend on it.
  [[nodiscard]] bool is_untouched(const Vec3& point, std::size_t before, CutMove& hint) const;
  /// Proves the same for all points of a ball without its part above a plane.
  [[nodiscard]] bool is_untouched(const CutBall& ball, std::size_t before, CutMove& hint) const;
  /// Proves that the cutter of a move did not reach a point over [0, until].
  [[nodiscard]] bool is_missed_by(std::size_t move, double until, const Vec3& point) const;
  /// Returns the first move before `before` whose motion is not known and may have come within `within_mm` of the point;
  /// else no move.
  [[nodiscard]] CutMove unknown_near(const Vec3& point, std::size_t before, double within_mm = 0) const;
  /// Returns the earlier cutter that came nearest to a point; none: no cutter is within `within_mm`.
  [[nodiscard]] std::optional<PassedBy> nearest_cut(const Vec3& point, std::size_t before, double within_mm) const;

  /// Returns the nearest place before a move that a search finds, if it is nearer than `within_mm`. A search may miss a
  /// nearer place, so nothing is proved with it. Boxes about motions that are not known are places of tools.
  [[nodiscard]] std::optional<NearestPlace> nearest_place(const Vec3& point, std::size_t before, double within_mm,
                                                          PlacesOf places) const;
  /// Proves that no tool, with all its bodies, reached a point within `slack_mm` of a region before a move, and that all
  /// motions until then are known near it. `hint` is a move that is tried first; the result does not depend on it.
  [[nodiscard]] bool is_untouched(const HullRegion& region, double slack_mm, std::size_t before, CutMove& hint) const;

  /// Returns whether the tool of a move is known, and its motion within a departure.
  [[nodiscard]] bool is_known(std::size_t move) const { return is_known_[move]; }
  /// Returns the motion of a move, straight where the file states none (Move::is_linked), or the tool at rest in its
  /// position.
  [[nodiscard]] Motion motion_of(std::size_t move) const;
  /// Returns how far the tool may be from a motion: by the law, and by the tolerances of the control.
  [[nodiscard]] Departure departure_from(const Motion& motion) const { return gouge::departure_of(motion) + tube_; }
  /// Returns whether the move cuts: no rapid, and no position to which the file states no motion.
  [[nodiscard]] bool is_cutting(std::size_t move) const;
  [[nodiscard]] const Toolpath& path() const { return path_; }
  /// Returns the history of the program before; null: there is none.
  [[nodiscard]] const CutHistory* earlier() const { return earlier_; }
  [[nodiscard]] const StockTool& tool_of(std::size_t move) const { return tools_[path_.moves[move].tool]; }
  [[nodiscard]] std::span<const StockHead> heads() const { return heads_; }

 private:
  struct OfTool {
    std::vector<ConvexPiece> pieces;
    std::vector<BodyHulls> bodies;
    ToolCylinder cutter;
    double cutter_reach_mm = 0, reach_mm = 0;  // largest distances from the tip
    std::unique_ptr<const MotionTree> tree;
  };
  struct Unknown {
    std::size_t move = 0;
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  };

  /// Returns the motion of a move; none: it or its tool is not known.
  [[nodiscard]] std::optional<Motion> known_motion(std::size_t move) const;
  [[nodiscard]] std::size_t size() const { return path_.moves.size(); }
  [[nodiscard]] bool removes(const SweptPiece& piece, std::size_t before, CutMove& hint) const;
  [[nodiscard]] bool touches(const CutBall& ball, std::size_t before, CutMove& hint) const;
  /// Enters the cut nearest to a point, if it is nearer than the one that stands there and within `reach_mm`.
  void add_nearest(const Vec3& point, std::size_t before, double reach_mm, std::optional<PassedBy>& nearest) const;
  // Both of this program alone.
  [[nodiscard]] std::optional<NearestPlace> own_nearest_place(const Vec3& point, std::size_t before, double within_mm,
                                                              PlacesOf places) const;
  [[nodiscard]] bool is_left_alone(const HullRegion& region, double slack_mm, std::size_t before, CutMove& hint) const;
  void add_unknown(std::size_t move);
  /// Returns whether the cutter may contain the piece during a span.
  [[nodiscard]] bool may_cover(const MotionSpan& span, const SweptPiece& piece, const Vec3& middle) const;
  [[nodiscard]] bool covers(std::size_t move, const CutWindow& window, const SweptPiece& piece) const;
  [[nodiscard]] bool is_straight_with_fixed_axis(std::size_t move) const;
  /// Returns the departure of a move that is known.
  [[nodiscard]] const Departure& departure_of(std::size_t move) const {
    return departures_.empty() ? tube_ : departures_[move];
  }
  [[nodiscard]] MovePlaces places_of(std::size_t move, std::uint32_t segment) const;
  /// Returns whether a body may come within `within_mm` of the point during [t0, t1] of a segment of a move.
  [[nodiscard]] bool reaches(std::size_t move, const CompiledTool& body, double t0, double t1, std::uint32_t segment,
                             const Vec3& point, double within_mm = 0) const;
  /// Returns whether a body of the tool may meet the ball during a span.
  [[nodiscard]] bool meets(const MotionSpan& span, const CutBall& ball) const;
  /// Returns the same for a head.
  [[nodiscard]] bool meets(const StockHead& head, const MotionSpan& span, const CutBall& ball) const;

  const Toolpath& path_;
  const MotionLaw& law_;
  const std::vector<StockTool>& tools_;
  const CutHistory* earlier_;
  std::span<const StockHead> heads_;
  double resolution_mm_;
  Departure tube_;
  std::vector<Departure> departures_;  // one for each move; empty: all are those of the tolerances
  std::vector<bool> is_known_;         // one for each move
  std::vector<OfTool> of_tool_;
  std::vector<Unknown> unknown_;
};

}  // namespace gouge
