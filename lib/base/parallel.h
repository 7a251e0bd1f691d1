#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

// Work cut into fixed chunks. The result of a chunk may not depend on which thread runs it or when. Results are joined
// in index order, so any number of threads gives the same bytes.

namespace gouge {

/// More threads than this are no use on any machine, and each takes memory before it does anything.
inline constexpr unsigned kMaxThreads = 1024;

/// Sets the number of threads that for_each_chunk uses for 0; initially 0: all of the machine. With 1 no thread is
/// started.
void set_default_threads(unsigned threads);

/// Calls `body(first, last)` once for each chunk of [0, count) with `chunk` items (the last one shorter). With
/// `threads` = 0 it takes all the machine has, or as set_default_threads sets. With `threads` = 1 it runs in the
/// calling thread, in order; so do chunks of a chunk. Where the system lets no more threads begin, those that run do
/// all of the work. Requires chunk > 0. An exception of `body` reaches the caller after the other chunks have stopped.
void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body);

/// Progress report of long work: the stage it is in, as in "checking moves", and how much of it is done. It comes
/// from any thread, but never from two at once. Empty: no report.
using ProgressCall = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

/// for_each_chunk that reports before the first and after each chunk.
void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                    const ProgressCall& progress, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace gouge
