#include <cmath>
#include <limits>
#include <utility>

#include <gougecheck/version.h>

#include "cli/library/content.h"
#include "lib/base/tolerance.h"
#include "lib/check/reach.h"

namespace gougecheck {

const char* version() { return GOUGECHECK_VERSION_STRING; }

Error::Error(std::string code, const std::string& what, std::string file, std::size_t line)
    : std::runtime_error(what), code_(std::move(code)), file_(std::move(file)), line_(line) {}

Error::~Error() = default;

void raise(const gouge::Diagnostic& error) { throw Error(error.code, gouge::to_text(error), error.file, error.line); }

Note to_note(const gouge::Diagnostic& diagnostic) {
  return {diagnostic.severity != gouge::Severity::note, diagnostic.code, gouge::to_text(diagnostic)};
}

std::vector<Note> to_notes(const gouge::Diagnostics& diagnostics) {
  std::vector<Note> notes;
  notes.reserve(diagnostics.size());
  for (const gouge::Diagnostic& diagnostic : diagnostics) notes.push_back(to_note(diagnostic));
  return notes;
}

std::optional<gouge::Pose> to_pose(const Vec3& tip, const Vec3& axis) {
  const gouge::Vec3 direction = to_vector(axis), point = to_vector(tip);
  const double length = direction.norm();
  if (!std::isfinite(length) || !(length > 0) || !gouge::is_within_reach(point)) return std::nullopt;
  // Keeps the digits of a vector that has unit length already, such as an axis of another path.
  constexpr double kUnit = 4 * std::numeric_limits<double>::epsilon();
  const gouge::Vec3 unit = std::abs(length - 1) <= kUnit ? direction : gouge::Vec3(direction / length);
  // A vector whose length overflows or underflows has no exact digits left.
  if (std::abs(unit.norm() - 1) > gouge::Tolerance::kRounding) return std::nullopt;
  return gouge::Pose{point, unit};
}

}  // namespace gougecheck
