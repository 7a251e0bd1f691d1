#include "cli/options/mesh_limits.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/terminal/length_text.h"
#include "lib/check/contact_rule.h"

namespace gouge {
namespace {

constexpr const char* kClearance = "clearance";
constexpr const char* kTolerance = "tolerance";

// Returns the place of ",word=" behind the name of a file; npos: there is none. A misspelt word is refused later.
std::size_t begin_of_limits(const std::string& typed) {
  std::error_code ignored;
  if (std::filesystem::exists(typed, ignored)) return std::string::npos;
  for (std::size_t comma = typed.find(','); comma != std::string::npos; comma = typed.find(',', comma + 1)) {
    const std::size_t end = std::min(typed.find_first_not_of("abcdefghijklmnopqrstuvwxyz", comma + 1), typed.size());
    if (end > comma + 1 && end < typed.size() && typed[end] == '=') return comma;
  }
  return std::string::npos;
}

class LimitReader {
 public:
  LimitReader(const std::string& option, const std::string& typed, Against against, double tolerance_mm)
      : option_(option), typed_(typed), against_(against), tolerance_mm_(tolerance_mm) {}

  [[nodiscard]] Result<MeshLimit> read(const std::string& text) const {
    std::optional<double> clearance, tolerance;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::string part = text.substr(begin, end - begin);
      const std::size_t equals = part.find('=');
      const std::string name = part.substr(0, equals);
      const auto length = equals == std::string::npos ? std::nullopt : parse_length_mm(part.substr(equals + 1));
      std::optional<double>* place = name == kClearance ? &clearance : name == kTolerance ? &tolerance : nullptr;
      if (place == nullptr || *place || !length || *length < 0)
        return refuse(
            "FILE,clearance=LENGTH,tolerance=LENGTH: each at most once, from 0 to 100 m, in mm or with a unit");
      *place = length;
      begin = end + 1;
    }
    if (clearance && rule_of(against_).is_workpiece)
      return refuse("no clearance, as the cutter makes the surface of a part; use --stock-to-leave or --clearance");
    if (tolerance && *tolerance > tolerance_mm_)
      return refuse("a tolerance of a file of at most that of --tolerance, which holds for all files");
    return MeshLimit{against_, 0, clearance.value_or(0), tolerance.value_or(0)};
  }

 private:
  [[nodiscard]] Diagnostic refuse(const std::string& expected) const { return usage_error(option_, typed_, expected); }

  const std::string& option_;
  std::string typed_;
  Against against_;
  double tolerance_mm_;
};

}  // namespace

void split_limits(const std::vector<std::string>& typed, std::vector<std::string>& files, LimitTexts& limits) {
  files.clear();
  limits.clear();
  for (const std::string& value : typed) {
    const std::size_t begin = std::min(begin_of_limits(value), value.size());
    files.push_back(value.substr(0, begin));
    if (begin == value.size()) continue;
    std::string& text = limits[files.back()];
    text += (text.empty() ? "" : ",") + value.substr(begin + 1);  // a limit given twice is refused later
  }
}

Result<std::vector<MeshLimit>> understand_limits(const std::string& option, Against against,
                                                 const std::vector<std::string>& files, const LimitTexts& limits,
                                                 double tolerance_mm) {
  std::vector<MeshLimit> all;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto text = limits.find(files[i]);
    if (text == limits.end()) continue;
    Result<MeshLimit> limit =
        LimitReader(option, files[i] + "," + text->second, against, tolerance_mm).read(text->second);
    if (!limit) return limit.error();
    limit->mesh = i;
    all.push_back(*limit);
  }
  return all;
}

}  // namespace gouge
