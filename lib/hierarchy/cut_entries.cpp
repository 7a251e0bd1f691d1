#include "lib/hierarchy/cut_entries.h"

#include <algorithm>
#include <bit>

namespace gouge::detail {
namespace {

constexpr std::size_t kMostBins = 1024;

/// Equal parts of a box along one axis. The number of a bin never falls as a middle grows.
class Bins {
 public:
  Bins(const EntryBox& box, std::size_t axis, std::size_t entries)
      : axis_(axis),
        count_(std::clamp(std::bit_ceil(entries) / 2, std::size_t{2}, kMostBins)),
        low_(box.low[axis]),
        scale_(static_cast<float>(count_) / box.width(axis)) {}

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t of(const Entry& entry) const {
    const auto bin = static_cast<std::int32_t>((entry.middle[axis_] - low_) * scale_);
    return std::min(static_cast<std::size_t>(bin), count_ - 1);
  }

 private:
  std::size_t axis_, count_;
  float low_, scale_;
};

/// A bin, and how many entries are in the bins before it and in it.
struct CutBin {
  std::size_t bin = 0, before = 0, within = 0;
};

CutBin bin_of_rank(std::span<const Entry> entries, const Bins& bins, std::size_t rank) {
  std::array<std::uint32_t, kMostBins> counts;
  std::fill_n(counts.begin(), bins.count(), 0U);
  for (const Entry& e : entries) ++counts[bins.of(e)];
  CutBin cut;
  for (cut.within = counts[0]; cut.before + cut.within <= rank; cut.within = counts[cut.bin]) {
    cut.before += cut.within;
    ++cut.bin;
  }
  return cut;
}

/// Entries of the bins before the cut first, then those of its own bin, then the others.
void part_at(std::span<Entry> entries, std::span<Entry> scratch, const Bins& bins, const CutBin& cut) {
  Entry* low = entries.data();
  Entry* rest = scratch.data();
  for (const Entry& e : entries) {
    const Entry kept = e;
    const bool is_low = bins.of(kept) < cut.bin;
    *(is_low ? low : rest) = kept;
    low += is_low ? 1 : 0;
    rest += is_low ? 0 : 1;
  }
  Entry* high = low + cut.within;
  for (const Entry* e = scratch.data(); e != rest; ++e) {
    const bool is_within = bins.of(*e) == cut.bin;
    *(is_within ? low : high) = *e;
    low += is_within ? 1 : 0;
    high += is_within ? 0 : 1;
  }
}

}  // namespace

std::size_t EntryBox::widest_axis() const {
  std::size_t widest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (width(k) > width(widest)) widest = k;
  }
  return widest;
}

EntryBox box_of(std::span<const Entry> entries) {
  EntryBox box{entries[0].middle, entries[0].middle};
  for (const Entry& e : entries) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], e.middle[k]);
      box.high[k] = std::max(box.high[k], e.middle[k]);
    }
  }
  return box;
}

void cut_entries(std::span<Entry> entries, std::span<Entry> scratch, std::size_t rank) {
  const EntryBox box = box_of(entries);
  const std::size_t axis = box.widest_axis();
  CutBin cut{0, 0, entries.size()};
  const Bins bins(box, axis, entries.size());
  // A width that single precision cannot divide by leaves one bin: everything.
  if (static_cast<float>(bins.count()) / box.width(axis) < 1e30F) {
    cut = bin_of_rank(entries, bins, rank);
    part_at(entries, scratch, bins, cut);
  }
  if (cut.before == rank) return;
  const auto first = entries.begin() + static_cast<std::ptrdiff_t>(cut.before);
  std::nth_element(first, entries.begin() + static_cast<std::ptrdiff_t>(rank),
                   first + static_cast<std::ptrdiff_t>(cut.within), [axis](const Entry& a, const Entry& b) {
                     return a.middle[axis] < b.middle[axis] ||
                            (!(b.middle[axis] < a.middle[axis]) && a.triangle < b.triangle);
                   });
}

}  // namespace gouge::detail
