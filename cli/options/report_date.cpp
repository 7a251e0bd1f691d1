#include <array>
#include <cstdlib>
#include <ctime>

#include "cli/options/job_options.h"
#include "lib/base/number_text.h"

namespace gouge {

Result<std::string> date_of_report() {
  constexpr long long kEndOf9999 = 253'402'300'799;
  std::time_t seconds = std::time(nullptr);
  if (const char* const stated = std::getenv("SOURCE_DATE_EPOCH"); stated != nullptr) {
    const std::optional<long long> number = parse_integer(stated);
    if (!number || *number < 0 || *number > kEndOf9999)
      return make_error("usage", "SOURCE_DATE_EPOCH '" + std::string(stated) +
                                     "' of the environment: expected seconds since 1970-01-01, or unset it");
    seconds = static_cast<std::time_t>(*number);
  }
  std::tm date{};
  ::gmtime_r(&seconds, &date);
  std::array<char, 64> text{};
  return std::string(text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &date));
}

}  // namespace gouge
