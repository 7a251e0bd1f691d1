#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gouge {

/// "8GB", "1.5 MiB" or "4096": bytes, where kB, MB, GB and TB are powers of 1000 and KiB, MiB, GiB and TiB of 1024, and
/// a bare number or B is bytes; capitals or not. Nothing for other text, or for less than 1 or more than 2^62 bytes.
[[nodiscard]] std::optional<std::uint64_t> parse_byte_size(std::string_view text);

/// For people, in powers of 1000: "8 GB", "12.35 MB", "999 bytes"; cut, not rounded up.
[[nodiscard]] std::string byte_size_text(std::uint64_t bytes);

}  // namespace gouge
