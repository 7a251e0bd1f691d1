#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lib/check/verdict.h"

namespace gouge {

// Verdicts as bytes, only for the same build of this program on machines of one byte order. A clean move takes 9 bytes.

/// Appends `verdict` with all its bits.
void append_bytes(const MoveVerdict& verdict, std::string& bytes);
void append_bytes(double number, std::string& bytes);
void append_bytes(std::uint64_t count, std::string& bytes);

/// Reads a value that append_bytes wrote from the front of `bytes`, and removes it. Returns false if the bytes are too
/// few or not a possible verdict.
[[nodiscard]] bool take_bytes(std::string_view& bytes, MoveVerdict& verdict);
[[nodiscard]] bool take_bytes(std::string_view& bytes, double& number);
[[nodiscard]] bool take_bytes(std::string_view& bytes, std::uint64_t& count);

/// Returns false if a verdict names a mesh that the scene lacks.
[[nodiscard]] bool is_of_meshes(const MoveVerdict& verdict, const Scene& scene);

}  // namespace gouge
