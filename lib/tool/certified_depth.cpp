#include "lib/tool/certified_depth.h"

#include <algorithm>
#include <cmath>

#include "lib/tool/reach_bound.h"
#include "lib/tool/tool_variants.h"

namespace gouge {
namespace {

constexpr int kMaxHalvings = 40;
constexpr double kLeast_mm = 1e-5;  // smaller depths would depend on rounding

bool is_same_form(const CompiledTool& a, const CompiledTool& b) {
  return a.elements.size() == b.elements.size() && std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(),
                                                              [](const BoundaryElement& x, const BoundaryElement& y) {
                                                                return x.kind == y.kind && x.a == y.a && x.b == y.b &&
                                                                       x.center == y.center;
                                                              });
}

}  // namespace

CertifiedDepth find_certified_depth(const CompiledTool& form, const CompiledTool& bare, double given_mm) {
  const double enough = kReachPerDepth * given_mm;
  CertifiedDepth sure;
  sure.reach_mm = bound_reach(form, bare, given_mm, enough);
  if (sure.reach_mm <= enough) {
    sure.depth_mm = given_mm;
    return sure;
  }
  for (int k = 1; k <= kMaxHalvings; ++k) {
    const double depth = given_mm * std::exp2(-0.5 * k);
    if (depth < kLeast_mm) break;
    if (!(bound_reach(form, bare, depth, enough) <= enough)) continue;
    sure.depth_mm = depth;
    sure.halvings = k;
    break;
  }
  return sure;
}

CertifiedDepth CertifiedDepths::at(const CompiledTool& form, const CompiledTool& bare, double given_mm) const {
  const std::scoped_lock lock(mutex_);
  const auto known = known_.find(given_mm);
  if (known != known_.end()) return known->second;
  return known_[given_mm] = find_certified_depth(form, bare, given_mm);
}

CertifiedDepth ToolVariants::certified_depth(std::span<const CertifiedForm> forms, double given_mm) const {
  CertifiedDepth sure{given_mm, given_mm, 0};
  for (std::size_t k = 0; k < forms.size(); ++k) {
    const auto is_known = [&](const CertifiedForm& before) { return is_same_form(*before.form, *forms[k].form); };
    if (std::any_of(forms.begin(), forms.begin() + static_cast<std::ptrdiff_t>(k), is_known)) continue;
    const CertifiedDepth own = forms[k].depths->at(*forms[k].form, bare, given_mm);
    const double reach = k == 0 ? own.reach_mm : std::max(sure.reach_mm, own.reach_mm);
    if (k == 0 || own.depth_mm < sure.depth_mm) sure = own;
    sure.reach_mm = reach;
  }
  return sure;
}

}  // namespace gouge
