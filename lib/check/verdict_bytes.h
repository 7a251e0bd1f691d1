#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lib/check/verdict.h"

namespace gouge {

// Verdicts as bytes, for this program alone: of this build, on machines of one byte order. A clean move takes 9.

/// Appends `verdict`, every bit of it.
void append_bytes(const MoveVerdict& verdict, std::string& bytes);
void append_bytes(double number, std::string& bytes);
void append_bytes(std::uint64_t count, std::string& bytes);

/// Takes from the front of `bytes` what append_bytes wrote; false where they are too short, or no verdict can be so.
[[nodiscard]] bool take_bytes(std::string_view& bytes, MoveVerdict& verdict);
[[nodiscard]] bool take_bytes(std::string_view& bytes, double& number);
[[nodiscard]] bool take_bytes(std::string_view& bytes, std::uint64_t& count);

/// Returns true unless a verdict that was taken names a mesh that the scene lacks.
[[nodiscard]] bool is_of_meshes(const MoveVerdict& verdict, const Scene& scene);

}  // namespace gouge
