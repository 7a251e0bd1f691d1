#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"

namespace gouge {

/// Store for results of long work that survive the process. The work is divided into stretches. The result of a stretch
/// is kept as soon as it exists, and is reused when the same work begins again. The owner must key a store to the
/// inputs of the work. It is used from one thread at a time.
class CheckpointStore {
 public:
  CheckpointStore() = default;
  CheckpointStore(const CheckpointStore&) = delete;
  CheckpointStore& operator=(const CheckpointStore&) = delete;
  virtual ~CheckpointStore() = default;

  /// Returns the approximate number of items in a stretch.
  [[nodiscard]] virtual std::size_t items() const = 0;
  [[nodiscard]] virtual std::optional<std::string> find(std::string_view stage, std::size_t stretch) = 0;
  /// Keeps `bytes`. Once it returns, they survive a kill of the process. If they cannot be kept, the work is done again
  /// later.
  virtual void keep(std::string_view stage, std::size_t stretch, std::string_view bytes) = 0;
};

/// Conversion of a stretch to bytes and back. `read` returns whether the bytes are those of the items [first, last).
struct CheckpointForm {
  std::function<std::string(std::size_t first, std::size_t last)> write;
  std::function<bool(std::size_t first, std::size_t last, std::string_view bytes)> read;
};

/// Runs for_each_chunk, one stretch after another. A stretch in `kept` is read from there; any other stretch is kept
/// once all its chunks are done. The chunks are the same as without a store. Nothing is kept without `kept`, or if all
/// of the work is one stretch.
void for_each_checkpointed_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                                 const ProgressCall& progress, CheckpointStore* kept, const CheckpointForm& form,
                                 const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace gouge
