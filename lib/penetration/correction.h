#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/penetration/contact.h"

namespace gouge {

/// Returns sum(d_i^2 n_i) / sum(d_i): every contact's way out, weighted by its depth once more. Zero without contacts.
/// Source   Thesis 5.3.
[[nodiscard]] Vec3 weighted_correction(std::span<const Contact> contacts);

enum class CorrectionEnd {
  free,      ///< nothing is deeper than `free_mm`
  balanced,  ///< the contacts' ways out cancel: no shift is better than another
  cycle,     ///< the body came back to where it had been
  limit,     ///< the iterations ran out
};

struct CorrectionOptions {
  double free_mm = Tolerance::kFilePoint_mm;
  std::size_t iterations = 64;
};

struct FreeingShift {
  CorrectionEnd end = CorrectionEnd::limit;
  std::size_t iterations = 0;  ///< corrections applied
  Vec3 shift = Vec3::Zero();   ///< their sum
  double depth_left_mm = 0;    ///< largest depth at that shift
  std::vector<Vec3> trail;     ///< shift after each of them
};

/// Contacts of the body moved by a shift.
using ContactsAt = std::function<std::vector<Contact>(const Vec3& shift)>;

/// Applies the weighted correction again and again (thesis 5.3, figure 35: 4 to 8 times is usual). The thesis does not
/// state when to give up. A body jammed in a slot narrower than itself moves back and forth forever, which is reported
/// as a cycle.
[[nodiscard]] FreeingShift correct_until_free(const ContactsAt& contacts_at, const CorrectionOptions& options = {});

}  // namespace gouge
