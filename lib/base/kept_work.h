#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"

namespace gouge {

/// Results of stretches of long work that outlast the process: kept as soon as they are there, and taken from here
/// when the same work is begun again. What they belong to, whoever makes one sees to. Used from one thread at a time.
class KeptWork {
 public:
  KeptWork() = default;
  KeptWork(const KeptWork&) = delete;
  KeptWork& operator=(const KeptWork&) = delete;
  virtual ~KeptWork() = default;

  /// How many items make a stretch, about.
  [[nodiscard]] virtual std::size_t items() const = 0;
  [[nodiscard]] virtual std::optional<std::string> find(std::string_view stage, std::size_t stretch) = 0;
  /// Once it returns, `bytes` outlast a kill; where they cannot be kept the work is merely done again.
  virtual void keep(std::string_view stage, std::size_t stretch, std::string_view bytes) = 0;
};

/// What a stretch is as bytes, and back. `read` tells whether they are those of items [first, last).
struct StretchForm {
  std::function<std::string(std::size_t first, std::size_t last)> write;
  std::function<bool(std::size_t first, std::size_t last, std::string_view bytes)> read;
};

/// for_each_chunk, stretch after stretch: one that is in `kept` is read, and each other one kept once all its chunks are
/// done. The chunks are the same ones. Without `kept`, and where all of the work is one stretch, nothing is kept.
void for_each_kept_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                         const ProgressCall& progress, KeptWork* kept, const StretchForm& form,
                         const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace gouge
