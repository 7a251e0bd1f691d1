#include "postproc/accept/accepted_setup.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/tolerance.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

template <class Inputs>
std::vector<std::string> checksums(const Inputs& inputs, std::string_view role) {
  std::vector<std::string> all;
  for (const auto& input : inputs) {
    if (input.role == role) all.push_back(input.checksum);
  }
  std::ranges::sort(all);
  return all;
}

// Returns whether two lengths are equal except for the last bit, by which a length in inches may change as text in mm.
bool is_same_length(double a_mm, double b_mm) {
  return std::abs(a_mm - b_mm) <= Tolerance::kFewRoundings * std::max(std::abs(a_mm), std::abs(b_mm));
}

std::vector<std::string> limits_of(const ReportModel& model) {
  std::vector<std::string> all;
  for (const OptionText& option : model.more_options)
    if (option.name == "part" || option.name == "fixture") all.push_back(option.value);
  std::ranges::sort(all);
  return all;
}

// Returns the data of StoredOptions::law.
std::vector<std::string> law_of(const ReportModel& model) {
  std::vector<std::string> all = checksums(model.inputs, "machine");
  for (const OptionText& option : model.more_options) {
    if (std::ranges::find(kLawOptions, option.name) != kLawOptions.end())
      all.push_back(option.name + "=" + option.value);
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace

AcceptedSetup setup_of(const StoredResult& result, const std::string& tool) {
  const StoredOptions& o = result.options;
  return {checksums(result.record.inputs, "part"),
          checksums(result.record.inputs, "fixture"),
          checksums(result.record.inputs, "head"),
          result.record.placement,
          tool,
          o.tolerance_mm,
          o.resolution_mm,
          o.stock_to_leave_mm,
          o.shank_clearance_mm,
          o.holder_clearance_mm,
          o.rapid,
          o.limits,
          o.law};
}

AcceptedSetup setup_of(const ReportModel& model, const std::string& tool) {
  const CheckOptions& o = model.options;
  return {checksums(model.inputs, "part"),
          checksums(model.inputs, "fixture"),
          checksums(model.inputs, "head"),
          model.placement,
          tool,
          o.tolerance_mm,
          o.resolution_mm,
          o.stock_to_leave_mm,
          o.shank_clearance_mm,
          o.holder_clearance_mm,
          rapid_word(o.law.rapid()),
          limits_of(model),
          law_of(model)};
}

std::optional<std::string> find_change(const AcceptedSetup& accepted, const AcceptedSetup& now, LengthUnit unit) {
  if (accepted.parts != now.parts) return "the part is another one";
  if (accepted.fixtures != now.fixtures) return "the fixtures are others";
  if (accepted.heads != now.heads) return "the heads are others";
  if (accepted.placement != now.placement) return "the STL files are placed elsewhere, or in another unit";
  struct Length {
    const char* what;
    double AcceptedSetup::*member;
  };
  static constexpr Length kLengths[] = {{"the tolerance", &AcceptedSetup::tolerance_mm},
                                        {"the resolution", &AcceptedSetup::resolution_mm},
                                        {"the stock to leave", &AcceptedSetup::stock_to_leave_mm},
                                        {"the shank's clearance", &AcceptedSetup::shank_clearance_mm},
                                        {"the holder's clearance", &AcceptedSetup::holder_clearance_mm}};
  for (const Length& one : kLengths) {
    const double then_mm = accepted.*one.member, now_mm = now.*one.member;
    if (is_same_length(then_mm, now_mm)) continue;
    return std::string(one.what) + " is " + length_text(now_mm, unit) + ", " + length_text(then_mm, unit) +
           " when it was accepted";
  }
  if (accepted.limits != now.limits) return "the limits of single files are others";
  if (accepted.law != now.law) return "the machine, or its law of motion, is another one";
  if (accepted.rapid != now.rapid) return "rapids are checked as " + now.rapid + ", then as " + accepted.rapid;
  return std::nullopt;
}

}  // namespace gouge
