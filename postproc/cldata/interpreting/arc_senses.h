#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/parsing/arc_statement.h"

namespace gouge {

/// Senses of rotation of arcs. If neither the dialect nor the statement states the sense, the lines that touch arcs
/// show it after the whole file is read. Arcs whose sense stays unknown are not checked.
class ArcSenses {
 public:
  explicit ArcSenses(StatementContext& in) : in_(in) {}

  /// Attaches `arc`, in part coordinates, to `move`, which is about to become the last one. It runs from `start` to the
  /// end of `move`. `other_uncertainty` is a reason not to check the move that does not depend on the sense; it may be
  /// empty.
  void attach(ArcStatement arc, const Position& position, const Pose& start, std::string_view other_uncertainty,
              Move& move);
  /// Notes a motion; `move` is about to become the last one.
  void note_motion(const Move& move, const std::optional<Pose>& start);
  void break_motion() { last_direction_.reset(); }
  /// Marks moves [begin, end) as not checked, independent of their sense.
  void uncertainty(std::size_t begin, std::size_t end, std::string_view reason);
  /// Decides the open senses at the end of the file.
  void close();
  void write_notes() const;

 private:
  struct OpenArc {
    std::size_t move = 0;
    ArcStatement arc;                     // in part coordinates
    std::string_view not_checked_reason;  // reason that does not depend on the sense
  };
  void mark_sense_uncertain(ArcStatement& arc, const Pose& start, const Move& move);
  [[nodiscard]] bool is_round(const ArcStatement& arc, const Position& position, const Pose& start, Move& move) const;
  void fit(const ArcStatement& arc, const Vec3& start, Move& move);
  void vote(const ArcStatement& arc, const Vec3& tip, const Vec3& direction);
  void close_as(ArcSense sense);
  void cover_both_senses();
  void cover_by_circle(ArcStatement arc, const Vec3& start, Move& move);

  StatementContext& in_;
  std::vector<OpenArc> open_;                     // arcs whose sense must follow from the rest of the file
  std::optional<Vec3> last_direction_;            // direction of the last move if it was straight, in part coordinates
  std::size_t right_votes_ = 0, left_votes_ = 0;  // number of lines that touch arcs, by the sense that they show
  // number of such lines that agree, or disagree, with the sense in which the arc is read
  std::size_t smooth_arcs_ = 0, reversing_arcs_ = 0;
  // number of clockwise arcs with a reversed vector, and with an unchanged one
  std::size_t turned_vectors_ = 0, reversed_arcs_ = 0;
  Tally radius_errors_;
  double worst_radius_error_mm_ = 0;
};

}  // namespace gouge
