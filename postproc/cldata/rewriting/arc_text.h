#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/rewriting/goto_text.h"

// The statements that describe an arc (CIRCLE, MOVARC, INDIRV and TLON of CATIA) with other numbers, in the style of
// the file. All other bytes of a statement stay.

namespace gouge {

/// An arc to write, in mm and the frame of its statement.
struct WrittenArc {
  PathArc arc;  ///< its vector has the sense of the vector in the statement
  Vec3 start = Vec3::Zero(), end = Vec3::Zero();
};

class ArcText {
 public:
  /// Learns the style from the first arcs of the file. `records` are those of read_motion_records.
  ArcText(const Toolpath& path, const MotionRecords& records);

  /// Returns whether the statements of the arc of move `move` can state another arc. They must belong to a text dialect
  /// and describe only this arc, of at most one turn.
  [[nodiscard]] bool is_writable(std::size_t move) const;

  /// Returns the arc of move `move` as the file states it. Requires is_writable(move).
  [[nodiscard]] WrittenArc as_read(std::size_t move) const;

  /// Returns the first of the statements that describe the arc. Text that is put before it precedes the arc. Requires
  /// is_writable(move).
  [[nodiscard]] std::size_t first_statement(std::size_t move) const;

  /// Returns the bytes of CIRCLE, MOVARC or INDIRV, which precede the position. Requires is_writable(move).
  /// Errors   write-arc: the written statement would not be read as this arc.
  [[nodiscard]] Result<std::string> description(std::size_t move, const WrittenArc& arc) const;

  /// Returns the bytes of the TLON that is the move itself. Requires is_writable(move) and the form `curve`.
  /// Errors   write-arc: the arc would cross half a turn, which needs other words, or would not be read as this arc.
  [[nodiscard]] Result<std::string> tlon(std::size_t move, const WrittenArc& arc) const;

 private:
  struct Field {  // an argument of a statement, with its new value
    std::size_t argument = 0;
    const NumberStyle* style = nullptr;
    double value = 0;
  };
  struct ArgumentIndices {  // indices of the arguments of MOVARC or CIRCLE
    std::size_t center = 0, axis = 3;
    std::optional<std::size_t> radius, angle;
  };

  void learn(const Statement& statement);
  [[nodiscard]] std::optional<ArgumentIndices> indices_of(const Statement& statement,
                                                          const std::vector<Argument>& arguments) const;
  void add_point(std::vector<Field>& fields, std::size_t first, const NumberStyle& style, const Vec3& point) const;
  [[nodiscard]] std::string replaced(const Statement& statement, const std::vector<Argument>& arguments,
                                     const std::vector<Field>& fields) const;
  [[nodiscard]] bool is_quiet_between(std::size_t first, std::size_t last) const;
  [[nodiscard]] Diagnostic refuse(std::size_t move, std::string_view why) const;

  const Toolpath& path_;
  const std::vector<MotionRecord>& records_;
  Dialect dialect_;
  NumberStyle lengths_, directions_, angles_;
  std::vector<SmallIndex> arcs_of_statement_;  // for each statement, the number of moves that it describes as arcs
};

}  // namespace gouge
