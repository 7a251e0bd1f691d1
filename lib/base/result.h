#pragma once

#include <utility>
#include <variant>

#include "lib/base/diagnostic.h"

// A value, or the error that states why there is no value. Its members have the names of std::expected. It becomes an
// alias of std::expected once the project uses C++23.

namespace gouge {

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Diagnostic error) : content_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// Returns the value. Requires has_value(); otherwise it throws std::bad_variant_access, which is an error of the
  /// caller.
  T& value() & { return std::get<0>(content_); }
  const T& value() const& { return std::get<0>(content_); }
  T&& value() && { return std::get<0>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// Returns the error. Requires !has_value().
  [[nodiscard]] const Diagnostic& error() const { return std::get<1>(content_); }

 private:
  std::variant<T, Diagnostic> content_;
};

struct Done {};
/// Result of an action that returns nothing except its success.
using Outcome = Result<Done>;

}  // namespace gouge
