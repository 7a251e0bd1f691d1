#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "lib/base/diagnostic.h"
#include "lib/base/files.h"
#include "lib/base/result.h"

namespace gouge {

/// Copies of meshes on a disk of this machine. With them, all gougecheck processes on it, ranks or shards, read a mesh
/// from a shared file system only once. The processes coordinate only by locks on files. A process that begins alone
/// removes copies that killed ones left, and the last one that ends removes all. May be used from several threads.
class MeshCopies {
 public:
  /// Keeps the copies in a folder of this user below `folder`; empty: nothing is copied.
  explicit MeshCopies(const std::string& folder);
  MeshCopies(const MeshCopies&) = delete;
  MeshCopies& operator=(const MeshCopies&) = delete;
  ~MeshCopies();

  /// Reads a file like view_file, from its copy if there is one. The copy must have the SHA-256 of the copied bytes,
  /// and be made of the present version of the file. Else reads the file itself, and copies it.
  [[nodiscard]] Result<FileView> view(const std::string& path, std::uint64_t max_bytes);

  /// Returns why files are not copied: the first of all reasons (a warning, code scratch-unusable).
  [[nodiscard]] std::optional<Diagnostic> trouble() const;
  /// Returns the number of copies made by this process, and below their bytes.
  [[nodiscard]] std::size_t files() const;
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  void open();
  void note(const std::string& what, int error);
  [[nodiscard]] bool put(const std::string& copy, std::string_view bytes);

  std::string folder_;  // the folder of the copies; empty: none
  int in_use_ = -1;     // a file in it that all processes which use the folder have locked (shared)
  mutable std::mutex guard_;
  std::optional<Diagnostic> trouble_;
  std::size_t files_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace gouge
