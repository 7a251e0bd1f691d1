#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/paged_memory.h"

namespace gouge {

/// The bytes of a toolpath file, which may be longer than memory. Views of them stay valid when the object is moved.
class SourceText {
 public:
  SourceText() = default;
  SourceText(std::string_view bytes) : bytes_(bytes.begin(), bytes.end()) {}
  SourceText(const std::string& bytes) : SourceText(std::string_view(bytes)) {}
  SourceText(const char* bytes) : SourceText(std::string_view(bytes)) {}
  SourceText(PagedVector<char>&& bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] std::string_view view() const { return {bytes_.data(), bytes_.size()}; }
  operator std::string_view() const { return view(); }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] const char* data() const { return bytes_.data(); }
  [[nodiscard]] std::string substr(std::size_t first, std::size_t count = std::string_view::npos) const {
    return std::string(view().substr(first, count));
  }

  friend bool operator==(const SourceText& a, std::string_view b) { return a.view() == b; }

 private:
  PagedVector<char> bytes_;
};

}  // namespace gouge
