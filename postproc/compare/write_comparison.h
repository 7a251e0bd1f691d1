#pragma once

#include <string>

#include "postproc/compare/compare_results.h"

// Output of a comparison as text, JSON and HTML: docs/formats/compare.md.

namespace gouge {

/// Returns "path.apt:123" in the new path, or in the old one if only that has the finding.
[[nodiscard]] std::string place_of(const Comparison& comparison, const ComparedFinding& one);
/// Describes the change of a finding, without its place: "deeper: 0.213 mm cutter T1 at (1, 2, 3), move 118; 0.150 mm
/// before".
[[nodiscard]] std::string change_text(const Comparison& comparison, const ComparedFinding& one);
/// Returns "1 new, 0 deeper, 0 not checked any more, 2 gone, 1 shallower, 4 same".
[[nodiscard]] std::string change_counts(const Comparison& comparison);
/// Returns "worse", "no worse", or "no worse as far as it was checked".
[[nodiscard]] std::string comparison_verdict(const Comparison& comparison);
/// Returns reservations about the comparison, a sentence each: the differences of both set-ups, and open facts.
[[nodiscard]] std::vector<std::string> comparison_notes(const Comparison& comparison);

/// Returns one line for each finding in the format of compilers, the worst first, and a summary. Unchanged findings are
/// listed only if `has_same`.
[[nodiscard]] std::string comparison_text(const Comparison& comparison, bool has_same);
[[nodiscard]] std::string comparison_json(const Comparison& comparison);
/// Returns one page that needs no other file.
[[nodiscard]] std::string comparison_html(const Comparison& comparison);

}  // namespace gouge
