#include "postproc/viewer/payload.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "postproc/report/report_text.h"

namespace gouge {
namespace {

// A compromise between speed and size: level 9 takes three times as long and saves only two hundredths.
constexpr int kLevel = 6;
constexpr std::size_t kStep = std::size_t{1} << 20, kRoom = std::size_t{1} << 16;  // bytes read and written at once

/// Deflates what the stream has to read, and appends it.
bool deflate_into(std::string& out, z_stream& stream, int flush) {
  std::array<char, kRoom> room;
  int status = Z_OK;
  do {
    stream.next_out = reinterpret_cast<Bytef*>(room.data());
    stream.avail_out = static_cast<uInt>(room.size());
    status = ::deflate(&stream, flush);
    out.append(room.data(), room.size() - stream.avail_out);
  } while (status == Z_OK && stream.avail_out == 0);
  return status == Z_STREAM_END || (flush == Z_NO_FLUSH && (status == Z_OK || status == Z_BUF_ERROR));
}

/// Deflates several texts as one.
Result<std::string> deflated(std::initializer_list<std::string_view> parts) {
  z_stream stream{};
  std::string out;
  bool is_good = ::deflateInit(&stream, kLevel) == Z_OK;
  const auto* const last = parts.end() - 1;
  for (const std::string_view* part = parts.begin(); is_good && part != parts.end(); ++part) {
    std::size_t done = 0;
    do {
      const std::size_t take = std::min(part->size() - done, kStep);
      stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(part->data() + done));
      stream.avail_in = static_cast<uInt>(take);
      done += take;
      is_good = deflate_into(out, stream, part == last && done == part->size() ? Z_FINISH : Z_NO_FLUSH);
    } while (is_good && done < part->size());
  }
  ::deflateEnd(&stream);
  if (!is_good) return make_error("page-not-packed", "cannot deflate the scene of the report; is there memory left?");
  return out;
}

}  // namespace

nlohmann::ordered_json Payload::add(std::span<const std::uint32_t> numbers, int bytes) {
  return add(numbers.size(), bytes, [&](std::size_t i) { return numbers[i]; });
}

nlohmann::ordered_json Payload::add_differences(std::span<const std::uint32_t> numbers, int bytes) {
  const std::uint32_t mask = bytes == 4 ? 0xFFFFFFFFU : (1U << (8 * bytes)) - 1;
  const std::uint32_t half = mask / 2;
  std::uint32_t last = 0;
  return add(numbers.size(), bytes, [&](std::size_t i) {
    const std::uint32_t step = (numbers[i] - std::exchange(last, numbers[i])) & mask;
    return step <= half ? 2 * step : 2 * (mask - step) + 1;
  });
}

Result<std::string> Payload::text(const nlohmann::ordered_json& json) const {
  const std::string head = json.dump();
  std::string size;
  for (int k = 0; k < 4; ++k) size.push_back(static_cast<char>((head.size() >> (8 * k)) & 0xFFU));
  const Result<std::string> packed = deflated({size, head, planes_});
  if (!packed) return packed.error();
  return base64(*packed);
}

}  // namespace gouge
