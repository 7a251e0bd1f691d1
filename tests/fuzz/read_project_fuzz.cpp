#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "cli/job/claimed_result.h"
#include "cli/project_file.h"
#include "tests/fuzz/require.h"

// Project files, and results that are to be verified. What is refused has a code of its own and one short message; a
// project file sets options that it may set; a result has a claim for every move, and what contradicts itself in it is
// named.

namespace gouge {
namespace {

using fuzz::require;

void require_documented(const Diagnostic& error, const std::set<std::string>& codes) {
  require(codes.contains(error.code) && !error.message.empty());
  require(to_text(error).size() < 5000);
}

void read_project(const std::string& text) {
  const Result<ProjectFile> project = read_project_file("gougecheck.json", "", text);
  if (!project)
    return require_documented(project.error(), {"project-syntax", "project-duplicate-key", "project-option",
                                                "json-too-deep", "json-too-long"});
  const std::vector<std::string> keys = project_keys();
  for (const ProjectOption& option : project->options) {
    require(std::ranges::find(keys, option.key) != keys.end() && !option.words.empty() && option.line > 0);
    for (const std::string& word : option.words) require(word.starts_with("--" + option.key));
  }
}

void read_claimed(const std::string& text) {
  const Result<ClaimedResult> result = read_claimed_result("result.json", text);
  if (!result)
    return require_documented(result.error(), {"result-syntax", "result-duplicate-key", "result-field",
                                               "result-invalid", "json-too-deep", "json-too-long"});
  constexpr std::size_t kMoves = 3;
  require(result->claims_of(kMoves).size() == kMoves);
  for (const std::string& what : find_contradictions(*result)) require(!what.empty());
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (text.find("gougecheck-report") == std::string::npos) {
    gouge::read_project(text);
  } else {
    gouge::read_claimed(text);
  }
  return 0;
}
