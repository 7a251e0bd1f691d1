#include "lib/hierarchy/cut_entries.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace gouge::detail {
namespace {

constexpr std::size_t kMaxBins = 1024;
// Number of entries that are enough to find the widest axis.
constexpr std::size_t kSample = 512;

/// Equal parts of a box along one axis. The two outer parts have no outer end.
class Bins {
 public:
  Bins(const EntryBox& box, std::size_t axis, std::size_t entries)
      : axis_(axis),
        count_(std::clamp(std::bit_ceil(entries) / 2, std::size_t{2}, kMaxBins)),
        last_(static_cast<float>(count_ - 1)),
        low_(box.low[axis]),
        scale_(static_cast<float>(count_) / box.width(axis)) {}

  [[nodiscard]] std::size_t count() const { return count_; }
  /// Returns whether the box is too thin to be divided in single precision; then all entries are in one bin.
  [[nodiscard]] bool is_too_thin() const { return !(scale_ < 1e20F); }

  /// Returns the position of an entry, which never decreases as its middle grows. Bin k is the range from k to k + 1.
  [[nodiscard]] float bin_position(const Entry& entry) const { return (entry.middle[axis_] - low_) * scale_; }
  [[nodiscard]] std::size_t of(const Entry& entry) const {
    const float position = bin_position(entry);
    const float from_zero = position > 0 ? position : 0;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(from_zero < last_ ? from_zero : last_));
  }

 private:
  std::size_t axis_, count_;
  float last_, low_, scale_;
};

/// A bin, with the number of entries in the bins before it and in the bin.
struct CutBin {
  std::size_t bin = 0, before = 0, within = 0;
};

CutBin bin_of_rank(std::span<const Entry> entries, const Bins bins, std::size_t rank) {
  std::array<std::uint32_t, kMaxBins> counts;
  std::fill_n(counts.begin(), bins.count(), 0U);
  for (const Entry& e : entries) ++counts[bins.of(e)];
  CutBin cut;
  for (cut.within = counts[0]; cut.before + cut.within <= rank; cut.within = counts[cut.bin]) {
    cut.before += cut.within;
    ++cut.bin;
  }
  return cut;
}

// The type in which an entry is moved as a whole.
using Whole = std::uint32_t __attribute__((vector_size(16)));
static_assert(sizeof(Whole) == sizeof(Entry));

/// Writes an entry to both possible places, so that the processor has no branch to predict.
[[gnu::always_inline]] inline void copy_to_both(const Entry& entry, Entry& one, Entry& other) {
  Whole whole;
  std::memcpy(&whole, &entry, sizeof whole);
  std::memcpy(static_cast<void*>(&one), &whole, sizeof whole);
  std::memcpy(static_cast<void*>(&other), &whole, sizeof whole);
}

/// Moves the entries of the bins before the cut to the front, followed by those of the cut's own bin, and then the
/// others.
void part_at(std::span<Entry> entries, std::span<Entry> scratch, const Bins bins, const CutBin cut) {
  constexpr float kEnd = std::numeric_limits<float>::infinity();
  const float begin = cut.bin == 0 ? -kEnd : static_cast<float>(cut.bin);
  const float end = cut.bin + 1 == bins.count() ? kEnd : static_cast<float>(cut.bin + 1);
  Entry* low = entries.data();
  Entry* rest = scratch.data();
  for (const Entry& e : entries) {
    const std::ptrdiff_t is_low = bins.bin_position(e) < begin ? 1 : 0;
    copy_to_both(e, *low, *rest);
    low += is_low;
    rest += 1 - is_low;
  }
  Entry* high = scratch.data();
  for (const Entry* e = high; e != rest; ++e) {
    const std::ptrdiff_t is_within = bins.bin_position(*e) < end ? 1 : 0;
    copy_to_both(*e, *low, *high);
    low += is_within;
    high += 1 - is_within;
  }
  std::copy(scratch.data(), high, low);
}

}  // namespace

std::size_t EntryBox::widest_axis() const {
  std::size_t widest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (width(k) > width(widest)) widest = k;
  }
  return widest;
}

EntryBox box_of(std::span<const Entry> entries, std::size_t step) {
  EntryBox box{entries[0].middle, entries[0].middle};
  for (std::size_t i = 0; i < entries.size(); i += step) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], entries[i].middle[k]);
      box.high[k] = std::max(box.high[k], entries[i].middle[k]);
    }
  }
  return box;
}

void cut_entries(std::span<Entry> entries, std::span<Entry> scratch, std::size_t rank) {
  const EntryBox box = box_of(entries, std::max(std::size_t{1}, entries.size() / kSample));
  const std::size_t axis = box.widest_axis();
  CutBin cut{0, 0, entries.size()};
  const Bins bins(box, axis, entries.size());
  if (!bins.is_too_thin()) {
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
