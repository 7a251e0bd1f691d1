#include "postproc/viewer/payload.h"

#include <zlib.h>

#include <utility>

#include "postproc/report/report_text.h"

namespace gouge {
namespace {

// A compromise between speed and size: level 9 takes three times as long and saves only two hundredths.
constexpr int kLevel = 6;

Result<std::string> deflated(const std::string& bytes) {
  uLongf size = ::compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int status =
      ::compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  static_cast<uLong>(bytes.size()), kLevel);
  if (status != Z_OK)
    return make_error("page-not-packed", "cannot deflate the scene of the report; is there memory left?");
  out.resize(size);
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
  std::string bytes;
  bytes.reserve(4 + head.size() + planes_.size());
  for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<char>((head.size() >> (8 * k)) & 0xFFU));
  const Result<std::string> packed = deflated(bytes + head + planes_);
  if (!packed) return packed.error();
  return base64(*packed);
}

}  // namespace gouge
