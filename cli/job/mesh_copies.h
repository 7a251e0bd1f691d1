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

/// Copies of meshes on a disk of this machine. All gougechecks on it, ranks or shares, so read a mesh of a shared file
/// system once. They agree by locks on files alone. The next one that begins removes copies that a killed one left, and
/// the last one that ends removes all. May be used from several threads.
class MeshCopies {
 public:
  /// In a folder of this user's own below `folder`; empty: nothing is copied.
  explicit MeshCopies(const std::string& folder);
  MeshCopies(const MeshCopies&) = delete;
  MeshCopies& operator=(const MeshCopies&) = delete;
  ~MeshCopies();

  /// Reads a file as view_file does, from its copy where there is one. The copy must have the SHA-256 of the copied
  /// bytes, and be made of the file as it is. Else the file itself is read, and copied.
  [[nodiscard]] Result<FileView> view(const std::string& path, std::uint64_t max_bytes);

  /// Returns why files are read where they are, the first reason of all (a warning, code scratch-unusable).
  [[nodiscard]] std::optional<Diagnostic> trouble() const;
  /// Copies made by this process.
  [[nodiscard]] std::size_t files() const;
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  void open();
  void note(const std::string& what, int error);
  [[nodiscard]] bool put(const std::string& copy, std::string_view bytes);

  std::string folder_;  // of the copies; empty: none
  int in_use_ = -1;     // a file there that all who use the folder have locked together
  mutable std::mutex guard_;
  std::optional<Diagnostic> trouble_;
  std::size_t files_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace gouge
