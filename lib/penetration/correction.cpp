#include "lib/penetration/correction.h"

#include <algorithm>

namespace gouge {
namespace {

// Share of the depth below which a correction, or the distance to an earlier position, makes no progress.
constexpr double kNoProgress = 1e-6;

double deepest(std::span<const Contact> contacts) {
  double depth = 0;
  for (const Contact& c : contacts) depth = std::max(depth, c.depth_mm);
  return depth;
}

}  // namespace

Vec3 weighted_correction(std::span<const Contact> contacts) {
  Vec3 sum = Vec3::Zero();
  double weight = 0;
  for (const Contact& c : contacts) {
    sum += c.depth_mm * c.depth_mm * c.normal;
    weight += c.depth_mm;
  }
  return weight > 0 ? Vec3(sum / weight) : Vec3(Vec3::Zero());
}

FreeingShift correct_until_free(const ContactsAt& contacts_at, const CorrectionOptions& options) {
  FreeingShift result;
  for (;;) {
    const std::vector<Contact> contacts = contacts_at(result.shift);
    result.depth_left_mm = deepest(contacts);
    if (result.depth_left_mm <= options.free_mm) {
      result.end = CorrectionEnd::free;
      return result;
    }
    const double small = kNoProgress * result.depth_left_mm;
    const auto was_here = [&](const Vec3& position) { return (position - result.shift).norm() <= small; };
    if (result.iterations > 1 && std::any_of(result.trail.begin(), result.trail.end() - 1, was_here)) {
      result.end = CorrectionEnd::cycle;
      return result;
    }
    const Vec3 step = weighted_correction(contacts);
    if (step.norm() <= small) {
      result.end = CorrectionEnd::balanced;
      return result;
    }
    if (result.iterations == options.iterations) return result;
    result.shift += step;
    result.trail.push_back(result.shift);
    ++result.iterations;
  }
}

}  // namespace gouge
