#pragma once

#include <string>
#include <utility>

#include "lib/base/result.h"

namespace gouge {

/// The lock of a folder: no other gougecheck writes its report or batch there as long as the object lives. On a file
/// system without locks it has no effect.
class ReportLock {
 public:
  /// Takes the lock of an existing folder. Errors: folder-unwritable; store-busy or report-busy, if another process has
  /// it.
  [[nodiscard]] static Result<ReportLock> take(const std::string& folder, bool is_for_batch);
  ReportLock(ReportLock&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  ReportLock& operator=(ReportLock&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~ReportLock();

 private:
  explicit ReportLock(int handle) : handle_(handle) {}

  int handle_ = -1;
};

}  // namespace gouge
