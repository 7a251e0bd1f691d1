#include "lib/base/temporary_name.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <utility>

namespace gouge {
namespace {

// State that a signal handler may read: it allocates nothing.
struct Slot {
  std::atomic<bool> is_taken;  // by a TemporaryName
  std::atomic<bool> is_named;  // the name is complete
  char name[PATH_MAX];
};
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int kSlots = 64;
std::array<Slot, kSlots> slots;

int take_slot(const std::string& name) {
  if (name.size() >= sizeof Slot::name) return -1;
  for (int i = 0; i < kSlots; ++i) {
    Slot& slot = slots[static_cast<std::size_t>(i)];
    if (slot.is_taken.exchange(true)) continue;
    std::memcpy(slot.name, name.c_str(), name.size() + 1);
    slot.is_named = true;
    return i;
  }
  return -1;
}

}  // namespace

TemporaryName::TemporaryName(const std::string& name) : name_(name), slot_(take_slot(name)) {}

TemporaryName::TemporaryName(TemporaryName&& other) noexcept
    : name_(std::exchange(other.name_, {})), slot_(std::exchange(other.slot_, -1)) {}

TemporaryName& TemporaryName::operator=(TemporaryName&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(slot_, other.slot_);
  return *this;
}

TemporaryName::~TemporaryName() {
  if (!name_.empty()) ::unlink(name_.c_str());
  forget();
}

void TemporaryName::forget() noexcept {
  name_.clear();
  if (slot_ < 0) return;
  Slot& slot = slots[static_cast<std::size_t>(std::exchange(slot_, -1))];
  slot.is_named = false;
  slot.is_taken = false;
}

void remove_temporary_names() noexcept {
  for (Slot& slot : slots) {
    if (slot.is_named) ::unlink(slot.name);
  }
}

}  // namespace gouge
