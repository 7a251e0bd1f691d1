#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/parsing/arc_statement.h"

namespace gouge {

/// A curve that is described before the position at its end: CIRCLE, MOVARC, and INDIRV before a TLON. A motion that is
/// announced but not finished may have gone anywhere, also at the end of the file.
class DescribedCurve {
 public:
  explicit DescribedCurve(StatementContext& in) : in_(in) {}

  /// Begins a curve to the next position, in the block's frame.
  void describe(ArcStatement arc) {
    arc_ = arc;
    statement_ = in_.index();
  }
  void begin_tangent() {
    has_tangent_ = true;
    statement_ = in_.index();
    tangent_.reset();
    if (in_.has_numbers_alone(3)) tangent_ = in_.vector(0);
  }
  /// Describes the curve of a TLON, which consumes the tangent.
  void describe_end(const ArcStatement& arc) {
    arc_ = arc;
    end_tangent();
  }
  /// Describes a curve whose statement has its end.
  void describe_whole(const ArcStatement& arc) {
    describe_end(arc);
    statement_ = kNone;
  }
  void end_tangent() {
    tangent_.reset();
    has_tangent_ = false;
  }
  void end_arc() { arc_.reset(); }
  /// Ends the curve, so that the next statement does not continue along it.
  void end_arcs() {
    arc_.reset();
    last_arc_.reset();
  }
  /// Resumes the curve for a statement that continues the positions of the previous one.
  void resume() {
    if (!arc_) arc_ = last_arc_;
  }
  /// Notes that all positions of a statement were read.
  void end_statement() { last_arc_ = std::exchange(arc_, std::nullopt); }
  void restore(std::optional<ArcStatement> arc) { arc_ = std::move(arc); }
  void spoil(const char* problem) { arc_->problem = problem; }

  [[nodiscard]] const std::optional<ArcStatement>& arc() const { return arc_; }
  [[nodiscard]] const std::optional<Vec3>& tangent() const { return tangent_; }
  /// Returns whether there is an INDIRV that no motion has used.
  [[nodiscard]] bool has_tangent() const { return has_tangent_; }
  [[nodiscard]] bool is_open() const { return arc_ || has_tangent_; }
  /// Returns the statement of CIRCLE, MOVARC or INDIRV, or kNone.
  [[nodiscard]] std::size_t statement() const { return statement_; }
  /// Returns whether a next position may continue along the last curve.
  [[nodiscard]] bool may_go_on() const { return in_.dialect.may_go_on_round && last_arc_; }
  // Returns whether a position may continue along the last curve. In the text of NCL every position has its own
  // statement. In its binary files, positions after a circle continue along it.
  [[nodiscard]] bool may_go_on(const Position& position) const {
    constexpr double kOnCircle_mm = 0.02;
    if (!in_.dialect.may_go_on_round || arc_ || !last_arc_ || !last_arc_->problem.empty()) return false;
    const Vec3 away = position.tip_local - last_arc_->center;
    const double radius = (away - away.dot(last_arc_->axis) * last_arc_->axis).norm();
    return std::abs(radius - last_arc_->radius_mm.value_or(radius)) <= kOnCircle_mm;
  }

 private:
  StatementContext& in_;
  std::optional<ArcStatement> arc_;
  std::optional<ArcStatement> last_arc_;  // the curve of the previous statement's positions
  std::size_t statement_ = kNone;
  std::optional<Vec3> tangent_;
  bool has_tangent_ = false;
};

}  // namespace gouge
