#include "lib/verify/zstd_stream.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>

namespace gouge {
namespace {

// Fails like an allocation without memory. zstd reports a lack of memory by null or an error number instead of
// std::bad_alloc. Incomplete data must not pass as complete.
void end_without_memory() { static_cast<void>(::operator new(PTRDIFF_MAX)); }

template <class Context>
Context* made(Context* context) {
  if (context == nullptr) end_without_memory();
  return context;
}

bool is_short_of_memory(std::size_t answer) { return ZSTD_getErrorCode(answer) == ZSTD_error_memory_allocation; }

}  // namespace

struct ZstdWriter::State {
  ZSTD_CCtx* context = made(ZSTD_createCCtx());
  std::string out;
};

ZstdWriter::ZstdWriter() : state_(std::make_unique<State>()) {
  constexpr int kLevel = 9;
  ZSTD_CCtx_setParameter(state_->context, ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(state_->context, ZSTD_c_checksumFlag, 1);
}
ZstdWriter::~ZstdWriter() { ZSTD_freeCCtx(state_->context); }

void ZstdWriter::run(std::string_view bytes, bool is_end) {
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::array<char, 1 << 16> room{};
  for (bool is_done = false; !is_done;) {
    ZSTD_outBuffer out{room.data(), room.size(), 0};
    const std::size_t left = ZSTD_compressStream2(state_->context, &out, &in, is_end ? ZSTD_e_end : ZSTD_e_continue);
    if (ZSTD_isError(left) != 0) end_without_memory();  // compression cannot fail for any other reason
    state_->out.append(room.data(), out.pos);
    is_done = (is_end ? left == 0 : in.pos == in.size);
  }
}

void ZstdWriter::add(std::string_view bytes) { run(bytes, false); }

std::string ZstdWriter::finish() {
  run({}, true);
  return std::move(state_->out);
}

struct ZstdReader::State {
  ZSTD_DCtx* context = made(ZSTD_createDCtx());
  ZSTD_inBuffer in{};
  std::string ready;  // decompressed bytes that are not yet taken
  bool is_broken = false, is_ended = false;

  void read() {
    std::array<char, 1 << 16> room{};
    ZSTD_outBuffer out{room.data(), room.size(), 0};
    const std::size_t before = in.pos;
    const std::size_t left = ZSTD_decompressStream(context, &out, &in);
    if (is_short_of_memory(left)) end_without_memory();
    if (ZSTD_isError(left) != 0 || (left != 0 && out.pos == 0 && in.pos == before)) is_broken = true;
    if (!is_broken && left == 0) is_ended = true;
    ready.append(room.data(), out.pos);
  }
};

ZstdReader::ZstdReader(std::string_view bytes) : state_(std::make_unique<State>()) {
  state_->in = {bytes.data(), bytes.size(), 0};
}
ZstdReader::~ZstdReader() { ZSTD_freeDCtx(state_->context); }

std::string ZstdReader::take(std::size_t count) {
  while (state_->ready.size() < count && !state_->is_broken && !state_->is_ended) state_->read();
  const std::size_t given = std::min(count, state_->ready.size());
  std::string taken = state_->ready.substr(0, given);
  state_->ready.erase(0, given);
  return taken;
}

bool ZstdReader::is_broken() const { return state_->is_broken; }

bool ZstdReader::is_at_end() {
  while (!state_->is_broken && !state_->is_ended && state_->ready.empty()) state_->read();
  return !state_->is_broken && state_->is_ended && state_->ready.empty() && state_->in.pos == state_->in.size;
}

}  // namespace gouge
