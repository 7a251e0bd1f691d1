#pragma once

#include <cstddef>
#include <functional>

namespace gouge {

/// Called after each finished share of long work: done and total, from any thread but never from two at once.
using ProgressCall = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace gouge
