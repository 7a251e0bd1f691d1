#include "postproc/record/result_digest.h"

#include <cstddef>

#include "lib/base/sha256.h"

namespace gouge {
namespace {

constexpr std::string_view kBefore = ",\n \"digest\": \"sha256:", kAfter = "\"\n}\n", kEnd = "\n}\n";
constexpr std::size_t kDigits = 64;

}  // namespace

std::string with_digest(std::string json) {
  json.resize(json.size() - kEnd.size());
  const std::string digest = sha256_of(json);
  return json.append(kBefore).append(digest).append(kAfter);
}

DigestState check_digest(std::string_view json) {
  const std::size_t size = kBefore.size() + kDigits + kAfter.size();
  if (json.size() < size) return DigestState::missing;
  const std::string_view body = json.substr(0, json.size() - size), tail = json.substr(json.size() - size);
  if (!tail.starts_with(kBefore) || !tail.ends_with(kAfter))
    return json.find("\"digest\"") == std::string_view::npos ? DigestState::missing : DigestState::wrong;
  return tail.substr(kBefore.size(), kDigits) == sha256_of(body) ? DigestState::right : DigestState::wrong;
}

}  // namespace gouge
