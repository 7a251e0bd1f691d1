#pragma once

#include <utility>
#include <variant>

#include "lib/base/diagnostic.h"

// A value, or the one error that states why there is none. Member names are those of std::expected,
// which this becomes an alias of once the project moves to C++23.

namespace gouge {

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Diagnostic error) : content_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// Requires has_value(); std::bad_variant_access otherwise, which is a bug of the caller.
  T& value() & { return std::get<0>(content_); }
  const T& value() const& { return std::get<0>(content_); }
  T&& value() && { return std::get<0>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// Requires !has_value().
  [[nodiscard]] const Diagnostic& error() const { return std::get<1>(content_); }

 private:
  std::variant<T, Diagnostic> content_;
};

struct Done {};
/// Result of an action that has nothing to hand back but whether it worked.
using Outcome = Result<Done>;

}  // namespace gouge
