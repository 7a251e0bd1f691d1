#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/penetration/contact.h"

namespace gouge {

/// Returns sum(d_i^2 n_i) / sum(d_i): the mean of the contacts' ways out, weighted by their depths; zero without
/// contacts.
/// Source   Thesis 5.3.
[[nodiscard]] Vec3 weighted_correction(std::span<const Contact> contacts);

enum class CorrectionEnd {
  free,      ///< no contact is deeper than `free_mm`
  balanced,  ///< the contacts' ways out cancel, so no shift is better than another
  cycle,     ///< the body returned to an earlier position
  limit,     ///< the maximum number of iterations was reached
};

struct CorrectionOptions {
  double free_mm = Tolerance::kFilePoint_mm;
  std::size_t iterations = 64;
};

struct FreeingShift {
  CorrectionEnd end = CorrectionEnd::limit;
  std::size_t iterations = 0;  ///< number of corrections applied
  Vec3 shift = Vec3::Zero();   ///< sum of the corrections
  double depth_left_mm = 0;    ///< largest depth after that shift
  std::vector<Vec3> trail;     ///< shift after each correction
};

/// A function that returns the contacts of the body after a shift.
using ContactsAt = std::function<std::vector<Contact>(const Vec3& shift)>;

/// Repeats the weighted correction until the body is free (thesis 5.3, figure 35: 4 to 8 times is usual). The thesis
/// does not state when to stop. A body in a slot narrower than itself moves back and forth forever; this is reported as
/// a cycle.
[[nodiscard]] FreeingShift correct_until_free(const ContactsAt& contacts_at, const CorrectionOptions& options = {});

}  // namespace gouge
