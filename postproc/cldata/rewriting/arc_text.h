#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/rewriting/goto_text.h"

// The statements that describe an arc (CIRCLE, MOVARC, CATIA's INDIRV and TLON) with other numbers in them,
// written as the file writes its arcs. Everything else of a statement keeps its bytes.

namespace gouge {

/// An arc to write, in mm and the frame of its statement.
struct WrittenArc {
  PathArc arc;  ///< its vector points as the statement's own does
  Vec3 start = Vec3::Zero(), end = Vec3::Zero();
};

class ArcText {
 public:
  /// Learns from the first arcs of the file. `records` as read_motion_records gives them.
  ArcText(const Toolpath& path, const MotionRecords& records);

  /// Returns true where the statements of the arc that is move `move` can state another one. These are statements of a
  /// dialect of text that describe this arc alone, of one turn at most.
  [[nodiscard]] bool is_writable(std::size_t move) const;

  /// Returns the arc of move `move` as the file has it. Requires is_writable(move).
  [[nodiscard]] WrittenArc as_read(std::size_t move) const;

  /// Returns the first of the statements that describe the arc. Text put before them is before the arc. Requires
  /// is_writable(move).
  [[nodiscard]] std::size_t first_statement(std::size_t move) const;

  /// Returns the bytes of CIRCLE, MOVARC or INDIRV, which stand before the position. Requires is_writable(move).
  /// Errors   write-arc: what would be written does not read as this arc.
  [[nodiscard]] Result<std::string> description(std::size_t move, const WrittenArc& arc) const;

  /// Returns the bytes of the TLON that is the move itself. Requires is_writable(move) and the form `curve`.
  /// Errors   write-arc: the arc would cross half a turn, which takes other words, or not read as this one.
  [[nodiscard]] Result<std::string> tlon(std::size_t move, const WrittenArc& arc) const;

 private:
  struct Field {  // an argument of a statement and its new value
    std::size_t argument = 0;
    const NumberStyle* style = nullptr;
    double value = 0;
  };
  struct ArgumentIndices {  // indices of arguments; of MOVARC, CIRCLE
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
  std::vector<SmallIndex> arcs_of_statement_;  // how many moves a statement describes as arcs
};

}  // namespace gouge
