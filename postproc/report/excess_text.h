#pragma once

#include <string>
#include <vector>

#include "postproc/report/report_model.h"

namespace gouge {

/// Returns "0.3 to 0.38 mm of material is left at (1, 2, 3) of part.stl, facet 12, on 35 to 36.2 mm2", or what leaves the
/// place open.
[[nodiscard]] std::string excess_place_text(const ReportModel& model, const ExcessPlaceFacts& place);

/// Returns why a place is open; empty for a place that is proved.
[[nodiscard]] std::string why_open_text(const ExcessPlaceFacts& place);

/// Returns the kind of a place, in which its line of the findings begins: "material left" or "material open".
[[nodiscard]] std::string excess_kind(const ExcessPlaceFacts& place);

/// Returns the answer to --excess in one sentence, with what counts as removed; empty if it was not asked for.
[[nodiscard]] std::string excess_text(const ReportModel& model);

/// Returns the headline of a result in which material is left and no move gouges, or all gouges are accepted. Requires a
/// proved place.
[[nodiscard]] std::string excess_headline(const CheckResult& result, LengthUnit unit);

/// Returns a range of areas: "35 to 36.2 mm2".
[[nodiscard]] std::string area_range_text(double low_mm2, double high_mm2, LengthUnit unit);

}  // namespace gouge
