#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

enum class MoveKind : std::uint8_t { feed, rapid, arc, cycle };

/// Facts about a program of a machine's control (G-code), as texts of the options of `gougecheck check` with these names.
/// An empty text states nothing.
struct GOUGECHECK_EXPORT ProgramOptions {
  std::string control;  ///< "linuxcnc", "haas", ...; empty: that of the machine
  std::string machine;  ///< machine file or preset; empty: a program without rotary words
  std::vector<std::string> joint_limits, joint_points, joint_rates;
  std::string zero;                   ///< part zero in machine coordinates
  std::optional<double> tool_length;  ///< mm, from the gauge point to the tip
  std::vector<std::string> offsets;   ///< "G54=x,y,z"
  std::string tool_lengths;           ///< file
  std::vector<std::string> start;     ///< blocks in force at the start
  std::vector<std::string> tip_control_ends, harmless_words;
  std::string block_delete, home, plain_numbers, rotary_turns, tip_frame;
  std::string joint_rapid_law;  ///< "joint" or "independent"
  std::string unit;             ///< mm or inch, for a program that states none
};

/// Facts about CL data that the file does not state. An empty text states nothing.
struct GOUGECHECK_EXPORT ReadFacts {
  std::string unit;    ///< mm or inch, of a file that states none
  std::string cutcom;  ///< "centre": positions under CUTCOM are those of the cutter centre; else they are not checked
};

/// A toolpath. Move 0 is the first position alone. Each other move is the motion from the previous position. The tip
/// runs on the straight line, or on the arc in its file, and the axis on the great circle. Immutable.
class GOUGECHECK_EXPORT Path {
 public:
  /// Builds a path from memory. `tips` are the positions of the tip. `axes` point from tip to spindle, with any length
  /// but 0; there are as many as tips, or one for all. `rapids` marks rapid moves, one flag for each move, or is empty.
  /// The arrays are copied.
  /// Throws   Error: no positions, or arrays of different lengths. Also an axis without length, or a coordinate that is
  ///          not a number or beyond 100 m.
  Path(std::span<const Vec3> tips, std::span<const Vec3> axes, std::span<const bool> rapids = {},
       std::string name = "path");

  /// Reads CL data of any dialect, recognised by its content.
  /// Throws   Error: the first error of the file (docs/formats/apt_cl.md), a unit that differs from that of the file, or a
  ///          fact that is not one of its values.
  [[nodiscard]] static Path read(const std::string& file, const ReadFacts& facts = {});
  [[nodiscard]] static Path read(const std::string& file, const std::string& unit);

  /// Reads CL data from memory. `name` stands for the file in messages and reports.
  [[nodiscard]] static Path from_text(std::string text, const std::string& name, const ReadFacts& facts = {});
  [[nodiscard]] static Path from_text(std::string text, const std::string& name, const std::string& unit);

  /// Reads a program of a machine's control as the control runs it. A check of a program that turns rotary joints needs
  /// the machine with which it was read, with the same joints, zero and tool length.
  /// Throws   Error: the first error of the options or of the program (docs/formats/gcode.md).
  [[nodiscard]] static Path read_program(const std::string& file, const ProgramOptions& options);

  [[nodiscard]] std::size_t size() const;  ///< number of moves
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::span<const Vec3> tips() const;  ///< ends of the moves; valid as long as a copy of the path exists
  [[nodiscard]] std::span<const Vec3> axes() const;  ///< of unit length
  [[nodiscard]] std::span<const MoveKind> kinds() const;
  /// line in the file, from 1; for a path from memory the number of the move
  [[nodiscard]] std::span<const std::uint32_t> lines() const;
  [[nodiscard]] std::vector<Note> notes() const;  ///< notes of the reader

  /// Returns the bytes of the file. For a path from memory, returns APT that reads back as the same positions.
  [[nodiscard]] std::string text() const;

  /// Returns the path for `from_bytes` of this version, in this or another process.
  /// Throws   Error: path-not-saved, for a program of a control and for the path of a Correction.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws   Error: saved-bytes.
  [[nodiscard]] static Path from_bytes(std::string_view bytes);

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  explicit Path(std::shared_ptr<const Content> content);
  friend struct PathAccess;
  std::shared_ptr<const Content> content_;
};

}  // namespace gougecheck
