#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"

namespace gouge {

/// Results of stretches of long work that survive the process. Each is kept as soon as it is there, and is reused when
/// the same work begins again. The owner must key a store to the inputs of the work. Used from one thread at a time.
class CheckpointStore {
 public:
  CheckpointStore() = default;
  CheckpointStore(const CheckpointStore&) = delete;
  CheckpointStore& operator=(const CheckpointStore&) = delete;
  virtual ~CheckpointStore() = default;

  /// Returns the number of items make a stretch, about.
  [[nodiscard]] virtual std::size_t items() const = 0;
  [[nodiscard]] virtual std::optional<std::string> find(std::string_view stage, std::size_t stretch) = 0;
  /// Once it returns, `bytes` outlast a kill; where they cannot be kept the work is merely done again.
  virtual void keep(std::string_view stage, std::size_t stretch, std::string_view bytes) = 0;
};

/// Converts a stretch to bytes and back. `read` returns whether they are those of items [first, last).
struct CheckpointForm {
  std::function<std::string(std::size_t first, std::size_t last)> write;
  std::function<bool(std::size_t first, std::size_t last, std::string_view bytes)> read;
};

/// for_each_chunk, stretch after stretch: one that is in `kept` is read, and each other one kept once all its chunks
/// are done. The chunks are the same ones. Without `kept`, and where all of the work is one stretch, nothing is kept.
void for_each_checkpointed_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                                 const ProgressCall& progress, CheckpointStore* kept, const CheckpointForm& form,
                                 const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace gouge
