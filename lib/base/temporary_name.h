#pragma once

#include <string>

namespace gouge {

/// A temporary name of a file, until the file is in its place. The destructor removes the file, and so does a signal
/// that ends the program (remove_temporary_names). Signals know at most 64 names at once.
class TemporaryName {
 public:
  TemporaryName() = default;
  /// Registers the name. Call it before the file is created: a signal may arrive in between.
  explicit TemporaryName(const std::string& name);
  TemporaryName(TemporaryName&& other) noexcept;
  TemporaryName& operator=(TemporaryName&& other) noexcept;
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  ~TemporaryName();

  [[nodiscard]] bool empty() const { return name_.empty(); }
  [[nodiscard]] const char* c_str() const { return name_.c_str(); }
  /// Cancels the removal, because the file is in its place or was never created.
  void forget() noexcept;

 private:
  std::string name_;
  int slot_ = -1;  // index in the list for signals; -1: not in the list
};

/// Removes the files of all temporary names. May be called from a signal handler; the program must end after it.
void remove_temporary_names() noexcept;

}  // namespace gouge
