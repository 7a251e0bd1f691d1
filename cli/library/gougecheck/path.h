#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

enum class MoveKind : std::uint8_t { feed, rapid, arc, cycle };

/// A toolpath. Move 0 is the first position alone. Each other move is the motion from the position before. The tip runs
/// on the straight line, or the arc of its file, and the axis on the great circle. Immutable.
class GOUGECHECK_EXPORT Path {
 public:
  /// Builds a path from memory. The `tips` are the positions of the tip. The `axes` point from tip to spindle, with any
  /// length but 0, as many as tips, or one for all. The flags `rapids` mark rapid moves, one each, or none at all. The
  /// arrays are copied.
  /// Throws   Error: no positions, or numbers of them that differ. Also an axis without length, or a coordinate that is
  ///          not a number or beyond 100 m.
  Path(std::span<const Vec3> tips, std::span<const Vec3> axes, std::span<const bool> rapids = {},
       std::string name = "path");

  /// Reads CL data of any dialect, recognised by its content. The `unit` is mm or inch, for a file that states none;
  /// empty: not known.
  /// Throws   Error: the first error of the file (docs/formats/apt_cl.md), another unit than the file states.
  [[nodiscard]] static Path read(const std::string& file, const std::string& unit = "");

  [[nodiscard]] std::size_t size() const;  ///< moves
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::span<const Vec3> tips() const;  ///< ends of the moves; valid as long as a copy of the path lives
  [[nodiscard]] std::span<const Vec3> axes() const;  ///< unit
  [[nodiscard]] std::span<const MoveKind> kinds() const;
  [[nodiscard]] std::span<const std::uint32_t> lines() const;  ///< of the file, from 1; of a path from memory the move
  [[nodiscard]] std::vector<Note> notes() const;               ///< notes of the reader

  /// Returns the bytes of its file; of a path from memory, APT that reads back as the same positions.
  [[nodiscard]] std::string text() const;

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  explicit Path(std::shared_ptr<const Content> content);
  friend struct PathAccess;
  std::shared_ptr<const Content> content_;
};

}  // namespace gougecheck
