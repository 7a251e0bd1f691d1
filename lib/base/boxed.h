#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace gouge {

/// An optional value in memory of its own, used like std::optional. An empty one has the size of a pointer, which matters
/// in arrays of millions of items of which few have a value. A copy has a value of its own.
template <class Value>
class Boxed {
 public:
  Boxed() = default;
  Boxed(std::nullopt_t /*none*/) {}
  Boxed(Value value) : value_(std::make_unique<Value>(std::move(value))) {}
  Boxed(const std::optional<Value>& value) : value_(value ? std::make_unique<Value>(*value) : nullptr) {}
  Boxed(const Boxed& other) : value_(other ? std::make_unique<Value>(*other) : nullptr) {}
  Boxed(Boxed&& other) noexcept = default;
  Boxed& operator=(Boxed other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  ~Boxed() = default;

  [[nodiscard]] bool has_value() const { return value_ != nullptr; }
  explicit operator bool() const { return has_value(); }
  [[nodiscard]] Value& operator*() { return *value_; }
  [[nodiscard]] const Value& operator*() const { return *value_; }
  [[nodiscard]] Value* operator->() { return value_.get(); }
  [[nodiscard]] const Value* operator->() const { return value_.get(); }

  [[nodiscard]] Value value_or(Value otherwise) const { return value_ ? *value_ : otherwise; }
  [[nodiscard]] std::optional<Value> optional() const { return value_ ? std::optional(*value_) : std::nullopt; }

  Value& emplace() { return *(value_ = std::make_unique<Value>()); }
  void reset() { value_.reset(); }

 private:
  std::unique_ptr<Value> value_;
};

}  // namespace gouge
