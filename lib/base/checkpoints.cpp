#include "lib/base/checkpoints.h"

#include <algorithm>

namespace gouge {

void for_each_checkpointed_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                                 const ProgressCall& progress, CheckpointStore* kept, const CheckpointForm& form,
                                 const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t wanted = kept != nullptr ? std::max<std::size_t>(kept->items(), 1) : count;
  if (kept == nullptr || wanted >= count) return for_each_chunk(count, chunk, threads, stage, progress, body);
  const std::size_t items = (wanted + chunk - 1) / chunk * chunk;
  for (std::size_t stretch = 0, first = 0; first < count; ++stretch, first += items) {
    const std::size_t last = std::min(first + items, count);
    if (progress) progress(stage, first, count);
    const std::optional<std::string> found = kept->find(stage, stretch);
    if (found && form.read(first, last, *found)) continue;
    const auto reported = [&](std::string_view, std::size_t done, std::size_t) {
      progress(stage, first + done, count);
    };
    for_each_chunk(last - first, chunk, threads, stage, progress ? ProgressCall(reported) : ProgressCall(),
                   [&](std::size_t begin, std::size_t end) { body(first + begin, first + end); });
    kept->keep(stage, stretch, form.write(first, last));
  }
  if (progress) progress(stage, count, count);
}

}  // namespace gouge
