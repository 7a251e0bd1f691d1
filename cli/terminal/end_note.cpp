#include "cli/terminal/end_note.h"

#include <unistd.h>

#include <atomic>
#include <cstring>
#include <utility>

namespace gouge {
namespace {

std::atomic<const char*> printed_text = nullptr;
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler reads it");

}  // namespace

EndNote::EndNote(std::string text) : text_(std::move(text)) { printed_text = text_.c_str(); }

EndNote::~EndNote() { printed_text = nullptr; }

void print_end_note() noexcept {
  const char* const text = printed_text;
  if (text == nullptr) return;
  // A failed write cannot be reported.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, std::strlen(text));
}

}  // namespace gouge
