#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

enum class State : std::uint8_t {
  clean,
  near_miss,  ///< nearer than CheckOptions::near_miss
  gouge,
  buried,         ///< inside a solid with no surface inside the tool
  not_checked,    ///< could not be checked: see Report::reason
  not_certified,  ///< checked, and not proved within the budget
};
/// Returns clean, near, gouge, buried, not-checked or not-certified.
[[nodiscard]] GOUGECHECK_EXPORT const char* state_name(State state);

enum class Body : std::uint8_t { cutter, shank, holder, head };

/// Verdict of a whole path. It gouges where a move gouges or is buried. It is clean where every move is clean or near
/// and no fact that this rests on is open.
enum class Verdict : std::uint8_t { clean, gouges, not_fully_checked };

/// Result of a check: one entry a move, in order, as a structure of arrays. For every move depth <= true depth <=
/// depth_upper. Immutable; spans are valid as long as a copy of the report lives.
class GOUGECHECK_EXPORT Report {
 public:
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] bool is_clean() const { return verdict() == Verdict::clean; }
  [[nodiscard]] std::size_t count(State state) const;
  [[nodiscard]] double worst_depth() const;  ///< of all moves; 0 where none is deep

  [[nodiscard]] std::span<const State> state() const;
  /// Returns how deep a point of the surface is in the tool, positive inside, 0 outside; NaN of buried and not checked
  /// moves.
  [[nodiscard]] std::span<const double> depth() const;
  [[nodiscard]] std::span<const double> depth_upper() const;
  /// Returns the witness of `depth`: instant of the move in [0, 1], point of the surface, unit direction in which the
  /// tool must move away. NaN where there is none.
  [[nodiscard]] std::span<const double> t() const;
  [[nodiscard]] std::span<const Vec3> point() const;
  [[nodiscard]] std::span<const Vec3> normal() const;
  /// Returns of the witness the face of its mesh as given, the index of the mesh, and the body of the tool. Each is -1 where
  /// there is none.
  [[nodiscard]] std::span<const std::int64_t> triangle() const;
  [[nodiscard]] std::span<const std::int32_t> mesh() const;
  [[nodiscard]] std::span<const std::int8_t> body() const;        ///< a Body
  [[nodiscard]] std::span<const std::int8_t> is_fixture() const;  ///< 1: `mesh` counts fixtures; 0: parts
  /// Returns how far below the surface the tool reached, at least; NaN where it was not measured.
  [[nodiscard]] std::span<const double> overcut() const;
  /// Returns why a move is not checked, not certified or buried; else empty, or a remark.
  [[nodiscard]] std::string reason(std::size_t move) const;
  /// Returns the facts that the verdict rests on. It is clean only if none of them is open.
  [[nodiscard]] std::vector<Assumption> assumptions() const;
  /// Exceptions to the verdict, and warnings about the inputs.
  [[nodiscard]] std::vector<Note> notes() const;

  /// Returns the report as the program prints it: one finding a line, then the summary.
  [[nodiscard]] std::string text() const;
  /// The report in the form of the file's extension: .json, .csv, .sarif, .xml (JUnit), .html (without pictures), .txt.
  /// The file appears whole or not at all.
  /// Throws   Error: another extension; a file that was read for this report; file-unwritable.
  void write(const std::string& file) const;

  struct Content;
  explicit Report(std::shared_ptr<const Content> content);

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace gougecheck
