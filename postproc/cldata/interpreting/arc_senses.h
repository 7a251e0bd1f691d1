#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/parsing/arc_statement.h"

namespace gouge {

/// Senses of rotation of arcs. Where neither the dialect nor the statement states it, the lines that arcs touch do,
/// once the whole file is read. Arcs whose sense nothing shows are not checked.
class ArcSenses {
 public:
  explicit ArcSenses(StatementContext& in) : in_(in) {}

  /// Attaches `arc`, in part coordinates, from `start` to the end of `move`, which is about to become the last one. The
  /// reason `other_uncertainty` is why the move is not checked whatever its sense; it may be empty.
  void attach(ArcStatement arc, const Position& position, const Pose& start, std::string_view other_uncertainty,
              Move& move);
  /// `move` is about to become the last one.
  void note_motion(const Move& move, const std::optional<Pose>& start);
  void break_motion() { last_direction_.reset(); }
  /// Moves [begin, end) are not checked, whatever their sense.
  void uncertainty(std::size_t begin, std::size_t end, std::string_view reason);
  /// At the end of the file.
  void close();
  void write_notes() const;

 private:
  struct OpenArc {
    std::size_t move = 0;
    ArcStatement arc;                     // part coordinates
    std::string_view not_checked_reason;  // whatever its sense
  };
  void mark_sense_uncertain(ArcStatement& arc, const Pose& start, const Move& move);
  [[nodiscard]] bool is_round(const ArcStatement& arc, const Position& position, const Pose& start, Move& move) const;
  void fit(const ArcStatement& arc, const Vec3& start, Move& move);
  void vote(const ArcStatement& arc, const Vec3& tip, const Vec3& direction);
  void close_as(ArcSense sense);
  void cover_both_senses();
  void cover_by_circle(ArcStatement arc, const Vec3& start, Move& move);

  StatementContext& in_;
  std::vector<OpenArc> open_;                           // whose sense the rest of the file must show
  std::optional<Vec3> last_direction_;                  // of the last move where it was straight, part coordinates
  std::size_t right_votes_ = 0, left_votes_ = 0;        // lines that touch arcs, by the sense they show
  std::size_t smooth_arcs_ = 0, reversing_arcs_ = 0;    // the same, by whether it is the sense they are read in
  std::size_t turned_vectors_ = 0, reversed_arcs_ = 0;  // clockwise arcs right-handed, and left-handed
  Tally radius_errors_;
  double worst_radius_error_mm_ = 0;
};

}  // namespace gouge
