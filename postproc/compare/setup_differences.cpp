#include "postproc/compare/setup_differences.h"

#include <algorithm>

#include "postproc/report/report_text.h"

namespace gouge {

std::vector<std::string> setup_differences(const StoredResult& before, const StoredResult& after) {
  std::vector<std::string> all;
  for (const char* role : {"part", "fixture", "head"}) {
    if (before.contents_of(role) != after.contents_of(role))
      all.push_back(std::string("the ") + role + "s are other files");
  }
  if (before.placement != after.placement) all.push_back("the STL files are placed elsewhere, or in another unit");
  for (std::size_t k = 0; k < before.tools.size(); ++k) {
    const StoredTool& tool = before.tools[k];
    const auto same = std::ranges::find(after.tools, tool.key, &StoredTool::key);
    if (same == after.tools.end() || same->identity == tool.identity) continue;
    all.push_back(stored_tool_label(tool.key) + " has other dimensions");
  }
  const auto lengths = [&](const char* what, double a_mm, double b_mm) {
    if (a_mm < b_mm || a_mm > b_mm)
      all.push_back(std::string(what) + " is " + length_text(b_mm, after.unit) + ", " + length_text(a_mm, after.unit) +
                    " before");
  };
  const StoredOptions &a = before.options, &b = after.options;
  lengths("the tolerance", a.tolerance_mm, b.tolerance_mm);
  lengths("the resolution", a.resolution_mm, b.resolution_mm);
  lengths("the stock to leave", a.stock_to_leave_mm, b.stock_to_leave_mm);
  lengths("the shank's clearance", a.shank_clearance_mm, b.shank_clearance_mm);
  lengths("the holder's clearance", a.holder_clearance_mm, b.holder_clearance_mm);
  if (a.limits != b.limits) all.push_back("the limits of single files are others");
  if (a.rapid != b.rapid) all.push_back("rapids are checked as " + b.rapid + ", " + a.rapid + " before");
  if (before.version != after.version) all.push_back("gougecheck " + after.version + ", " + before.version + " before");
  return all;
}

}  // namespace gouge
