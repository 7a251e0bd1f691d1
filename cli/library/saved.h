#pragma once

#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/library/content.h"

// Objects as bytes, for another process with the same version: CBOR with the kind of the object, the version and its
// fields. Arrays are binary values, as numbers written as digits take more space and time.

namespace gougecheck {

using Fields = nlohmann::json;

[[nodiscard]] std::string pack(const char* kind, Fields fields);
/// Returns the fields. Throws Error, saved-bytes: other bytes, or bytes of another kind or version.
[[nodiscard]] Fields unpack(const char* kind, std::string_view bytes);
[[noreturn]] void refuse_bytes(const char* kind);

/// Returns what `make` makes of the fields. A missing field gives saved-bytes.
template <class Make>
[[nodiscard]] auto unpacked(const char* kind, std::string_view bytes, const Make& make) {
  try {
    return make(unpack(kind, bytes));
  } catch (const Fields::exception&) {
    refuse_bytes(kind);
  }
}

[[nodiscard]] Fields packed_bytes(std::string_view bytes);
[[nodiscard]] std::string text_in(const Fields& field);

template <class T>
[[nodiscard]] Fields packed_rows(std::span<const T> values) {
  return packed_bytes({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}
template <class T>
[[nodiscard]] Fields packed_rows(const std::vector<T>& values) {
  return packed_rows(std::span<const T>(values));
}

/// Copies the rows of a field. A length that is no whole number of rows gives saved-bytes.
template <class T>
void take_rows(const char* kind, const Fields& field, std::vector<T>& values) {
  const Fields::binary_t& bytes = field.get_binary();
  if (bytes.size() % sizeof(T) != 0) refuse_bytes(kind);
  values.resize(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
}

[[nodiscard]] Fields fields_of(const gouge::Diagnostics& diagnostics);
[[nodiscard]] gouge::Diagnostics diagnostics_in(const Fields& fields);

}  // namespace gougecheck
