#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

// Work cut into fixed chunks. What a chunk computes may not depend on which thread runs it or when, and
// results are joined in index order, so any number of threads gives the same bytes.

namespace gouge {

/// More threads than this are no use on any machine, and each takes memory before it does anything.
inline constexpr unsigned kMostThreads = 1024;

/// What 0 threads mean to for_each_chunk from now on; 0, as at first: all the machine has. With 1 no thread is started.
void set_default_threads(unsigned threads);

/// Calls `body(first, last)` once for each chunk of [0, count) with `chunk` items (the last one shorter).
/// `threads` = 0 takes all the machine has, or what set_default_threads says; 1 runs in the calling thread,
/// in order, as do chunks of a chunk. Where the system lets no more threads begin, those that run do all of
/// the work. Requires chunk > 0. An exception of `body` reaches the caller after the other chunks have
/// stopped.
void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body);

/// What long work reports of itself: the stage it is in, as in "checking moves", and how much of it is done. It comes
/// from any thread, but never from two at once. Empty: nobody asks.
using ProgressCall = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

/// for_each_chunk that reports before the first and after each chunk.
void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                    const ProgressCall& progress, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace gouge
