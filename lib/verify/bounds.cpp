#include "lib/verify/bounds.h"

namespace gouge {

SineCosine sine_cosine(const Bounds& angle) {
  constexpr int kTerms = 40;
  Bounds term(1), sine(0), cosine(1);
  for (int k = 1; k < kTerms; ++k) {
    term = term * angle / Bounds(k);
    const bool is_added = k % 4 < 2;
    Bounds& sum = k % 2 == 1 ? sine : cosine;
    sum = is_added ? sum + term : sum - term;
  }
  // All derivatives of sine and cosine are at most 1, so the remainder is at most |angle|^40 / 40!.
  const double rest = (CGAL::abs(term * angle) / Bounds(kTerms)).sup();
  const Bounds one(-1, 1);
  const auto within = [&](const Bounds& sum) {
    const Bounds wide = widened(sum, rest);
    return Bounds(std::max(wide.inf(), one.inf()), std::min(wide.sup(), one.sup()));
  };
  return {within(sine), within(cosine)};
}

}  // namespace gouge
