#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

// Work is divided into fixed chunks. The result of a chunk must not depend on the thread that runs it, or on the time.
// Results are joined in index order, so any number of threads gives the same bytes.

namespace gouge {

/// Maximum number of threads. More threads help on no machine, and each takes memory before it does anything.
inline constexpr unsigned kMaxThreads = 1024;

/// Sets the number of threads that for_each_chunk uses for 0. Initially it is 0: all threads of the machine. With 1 no
/// thread is started.
void set_default_threads(unsigned threads);

/// Returns the number of threads that for_each_chunk uses for 0 when it is called here.
[[nodiscard]] unsigned usable_threads();

/// Calls `body(first, last)` once for each chunk of [0, count). A chunk has `chunk` items; the last one may be shorter.
/// With `threads` = 0 it uses all threads of the machine, or the number of set_default_threads. With `threads` = 1 it
/// runs in the calling thread, in order; so do chunks within a chunk. If the system refuses more threads, the existing
/// ones do all of the work. Requires chunk > 0. An exception of `body` reaches the caller after the other chunks have
/// stopped.
void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body);

/// Progress report of long work: its current stage, for example "checking moves", and how much of the stage is done. It
/// is called from any thread, but never from two at once. An empty one gives no report.
using ProgressCall = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

/// Runs for_each_chunk and reports progress before the first chunk and after each.
void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                    const ProgressCall& progress, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace gouge
