#pragma once

#include <string>

namespace gouge {

/// A name that a file has for a moment, until it is in its place. The destructor removes it, and so does a signal that
/// ends the program (remove_temporary_names). At most 64 at once are known to signals.
class TemporaryName {
 public:
  TemporaryName() = default;
  /// To be made before the file: a signal may come in between.
  explicit TemporaryName(const std::string& name);
  TemporaryName(TemporaryName&& other) noexcept;
  TemporaryName& operator=(TemporaryName&& other) noexcept;
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  ~TemporaryName();

  [[nodiscard]] bool empty() const { return name_.empty(); }
  [[nodiscard]] const char* c_str() const { return name_.c_str(); }
  /// The file has gone to its place, or was never made: there is nothing to remove.
  void forget() noexcept;

 private:
  std::string name_;
  int slot_ = -1;  // in the list for signals; -1: none
};

/// Removes the files under all such names. May be called from a signal handler; the program must end after it.
void remove_temporary_names() noexcept;

}  // namespace gouge
