#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/printable_text.h"
#include "lib/base/sha256.h"
#include "postproc/accept/accepted.h"
#include "postproc/compare/write_comparison.h"
#include "postproc/record/result_digest.h"
#include "tests/fuzz/require.h"

// Two results, a line "=====" between them, or accepted findings. Digests and seals are made right, so that what they
// would keep out is read. A text is refused with a code of its own, or compares with itself as no worse, and each finding
// can be accepted once or is refused; what is accepted reads back as it was. Nothing of it is markup, or obeyed by a
// terminal.

namespace gouge {
namespace {

using fuzz::require;

constexpr std::string_view kParting = "\n=====\n", kEnd = "\n}\n";

void require_documented(const Diagnostic& error, const std::set<std::string>& codes) {
  require(codes.contains(error.code) && !error.message.empty());
  require(to_text(error).size() < 5000);
}

std::optional<StoredResult> result_of(std::string text) {
  if (text.ends_with(kEnd)) text = with_digest(std::move(text));
  Result<StoredResult> read = read_result("a.json", text);
  if (read) return std::move(*read);
  require_documented(read.error(), {"result-syntax", "result-duplicate-key", "result-format", "result-field",
                                    "result-edited", "json-too-deep", "json-too-long"});
  return std::nullopt;
}

void require_shown(const Comparison& comparison) {
  const std::string lines = comparison_text(comparison, true);
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', at), lines.size());
    const std::string line = lines.substr(at, end - at);
    require(printable(line) == line);
    at = end + 1;
  }
  require(nlohmann::json::accept(comparison_json(comparison)));
  require(comparison_html(comparison).find("<canary") == std::string::npos);
}

void accept_all(const StoredResult& result) {
  std::vector<Acceptance> accepted;
  for (const EventRecord& finding : result.findings) {
    Result<Acceptance> made = accept_finding(result, *finding.number, {"reason", "by", "2026-01-01"});
    if (made) {
      accepted.push_back(std::move(*made));
    } else {
      require_documented(made.error(), {"accept-impossible"});
    }
  }
  if (accepted.empty()) return;
  const std::string text = write_accepted(accepted);
  const Result<std::vector<Acceptance>> read = read_accepted("accepted.json", text);
  if (read) {
    require(write_accepted(*read) == text);
  } else {
    require_documented(read.error(), {"accepted-field", "accepted-edited"});
  }
}

void read_results(const std::string& text) {
  const std::size_t parting = text.find(kParting);
  const auto before = result_of(text.substr(0, parting == std::string::npos ? text.size() : parting + 1));
  if (!before) return;
  const Comparison with_itself = compare_results(*before, *before, {});
  require(with_itself.exit_status() != kExitGouges);
  require_shown(with_itself);
  accept_all(*before);
  if (parting == std::string::npos) return;
  const auto after = result_of(text.substr(parting + kParting.size()));
  if (after) require_shown(compare_results(*before, *after, {}));
}

// As 'gougecheck accept' makes them.
void seal(nlohmann::json& entry) {
  if (!entry.is_object()) return;
  entry.erase("seal");
  entry["seal"] = "sha256:" + sha256_of(entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void read_accepted_findings(const std::string& text) {
  const Result<std::vector<Acceptance>> read = read_accepted("accepted.json", text);
  if (!read)
    return require_documented(read.error(), {"accepted-syntax", "accepted-duplicate-key", "accepted-format",
                                             "accepted-field", "accepted-edited", "json-too-deep", "json-too-long"});
  const Result<std::vector<Acceptance>> again = read_accepted("accepted.json", write_accepted(*read));
  require(again && again->size() == read->size());
}

std::string sealed(const std::string& text) {
  nlohmann::json all = nlohmann::json::parse(text, nullptr, false);
  if (!all.is_object() || !all.contains("accepted") || !all["accepted"].is_array()) return text;
  for (nlohmann::json& entry : all["accepted"]) seal(entry);
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (text.find("gougecheck-accepted") == std::string::npos) {
    gouge::read_results(text);
  } else {
    gouge::read_accepted_findings(text);
    gouge::read_accepted_findings(gouge::sealed(text));
  }
  return 0;
}
