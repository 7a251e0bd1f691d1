#pragma once

namespace gouge {

/// More threads than this are no use on any machine, and each takes memory before it does anything.
inline constexpr unsigned kMostThreads = 1024;

/// What 0 threads mean to for_each_chunk from now on; 0, as at first: all the machine has. With 1 no thread is started.
void set_default_threads(unsigned threads);

}  // namespace gouge
