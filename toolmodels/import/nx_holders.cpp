#include "toolmodels/import/nx_holders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "toolmodels/import/quantity.h"

namespace gouge {
namespace {

constexpr const char* kGeneralRow = "1";  // RTYPE of the row that names a holder; its sections have RTYPE 2

// Diameters that differ by less than this are one diameter, rounded differently.
constexpr double kSameHolder_mm = 1e-4;

/// The rows of one holder, in the order of the file.
struct HolderRows {
  std::string name;
  std::vector<const NxRow*> sections;
  std::size_t line = 0;
};

std::vector<HolderRows> holders_in(const std::vector<NxRow>& rows) {
  std::vector<HolderRows> holders;
  std::map<std::string, std::size_t> place;
  for (const NxRow& row : rows) {
    const std::string name = row.text("LIBRF");
    const auto [at, is_new] = place.try_emplace(name, holders.size());
    if (is_new) holders.push_back({name, {}, row.line});
    if (row.text("RTYPE") != kGeneralRow) holders[at->second].sections.push_back(&row);
  }
  return holders;
}

/// Returns one section: DIAM is the diameter of its lower end, and its side leans outwards from the axis by TAPER over
/// LENGTH.
Result<ToolSegment> segment_of(const NxRow& row, double mm) {
  double values[3] = {};
  const char* const fields[3] = {"DIAM", "LENGTH", "TAPER"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Result<std::optional<double>> read = row.number(fields[i], i < 2 ? mm : 1);
    if (!read) return read.error();
    if (!*read && i < 2)
      return make_error("import-field", "section " + row.text("SEQ") + " has no " + fields[i] + "; it needs one");
    values[i] = read->value_or(0);
  }
  const auto [diameter, length, taper_deg] = values;
  constexpr double kSteepest = 89;
  if (std::abs(taper_deg) > kSteepest)
    return make_error("import-field", "TAPER " + display_text(taper_deg, 3) + " is not possible; expected -89 to 89");
  const double upper = diameter + 2 * length * std::tan(taper_deg * std::numbers::pi / 180);
  if (upper < 0)
    return make_error("import-field", "section " + row.text("SEQ") + " has a TAPER that would end below its axis");
  return ToolSegment{diameter, upper, length};
}

struct HolderShape {
  std::vector<ToolSegment> segments;
  bool has_corners = false;  ///< at least one section has a corner radius
};

Result<HolderShape> holder_shape(const HolderRows& holder, double mm) {
  std::vector<std::pair<long long, const NxRow*>> ordered;
  for (const NxRow* row : holder.sections) {
    const std::optional<long long> place = parse_integer(row->text("SEQ"));
    if (!place)
      return make_error("import-field", "SEQ is \"" + row->text("SEQ") + "\"; expected the number of a section");
    ordered.emplace_back(*place, row);
  }
  std::ranges::stable_sort(ordered, {}, [](const auto& one) { return one.first; });
  HolderShape shape;
  for (std::size_t k = 0; k < ordered.size(); ++k) {
    if (k > 0 && ordered[k].first == ordered[k - 1].first)
      return make_error("import-field", "has two sections of SEQ " + std::to_string(ordered[k].first));
    const Result<ToolSegment> segment = segment_of(*ordered[k].second, mm);
    if (!segment) return segment.error();
    const Result<std::optional<double>> corner = ordered[k].second->number("CRAD", mm);
    if (!corner) return corner.error();
    shape.has_corners = shape.has_corners || corner->value_or(0) > 0;
    shape.segments.push_back(*segment);
    // TAPER is rounded, but the lower diameter of the next section is exact.
    if (k == 0) continue;
    double& below = shape.segments[k - 1].upper_diameter_mm;
    if (std::abs(below - segment->lower_diameter_mm) < kSameHolder_mm) below = segment->lower_diameter_mm;
  }
  return shape;
}

}  // namespace

bool has_holders(const std::vector<NxRow>& rows) {
  return std::ranges::any_of(rows, [](const NxRow& row) { return row.values.contains("RTYPE"); });
}

void import_nx_holders(Collector& collector, const std::vector<NxRow>& rows, LengthUnit unit) {
  bool is_first = true, has_corners = false;
  for (const HolderRows& holder : holders_in(rows)) {
    const std::string who = "holder \"" + holder.name + "\"";
    if (holder.name.empty()) {
      collector.report("row", make_error("import-field", "a holder has no LIBRF; it needs a name"), holder.line);
      continue;
    }
    // Holders for turning tools have other columns.
    const bool is_round = !holder.sections.empty() && std::ranges::all_of(holder.sections, [](const NxRow* row) {
      return row->values.contains("DIAM");
    });
    if (!is_round) {
      collector.leave_out(who, holder.sections.empty() ? "without sections" : "that is not round", holder.line);
      continue;
    }
    Result<HolderShape> shape = holder_shape(holder, mm_per(unit));
    if (!shape) {
      collector.report(who, shape.error(), holder.line);
      continue;
    }
    if (is_first)
      collector.report("the library",
                       make_note("import-guess",
                                 "sections of holders are taken from the tool's side up in the order of SEQ, DIAM at "
                                 "the lower end of each; look at one: gougecheck tool draw"),
                       0);
    is_first = false;
    has_corners = has_corners || shape->has_corners;
    collector.add_holder({holder.name, std::move(shape->segments)}, unit, holder.line);
  }
  if (has_corners)
    collector.report("the library",
                     make_note("import-guess", "corner radii of holders (CRAD) are left out: their corners are sharp"),
                     0);
}

const std::vector<ToolSegment>* NxHolderSource::called(const std::string& name) {
  if (!is_read_) read();
  const auto found = holders_.find(name);
  return found == holders_.end() ? nullptr : &found->second;
}

void NxHolderSource::read() {
  is_read_ = true;
  if (!options_.read_beside) return;
  const Result<std::string> bytes = options_.read_beside("holder_database.dat");
  if (!bytes) return;
  Collector unheard("holder_database.dat", options_);
  const std::vector<NxRow> rows = NxDatabaseReader(unheard).read(*bytes);
  for (const HolderRows& holder : holders_in(rows)) {
    const bool is_round = !holder.sections.empty() && std::ranges::all_of(holder.sections, [](const NxRow* row) {
      return row->values.contains("DIAM");
    });
    if (!is_round) continue;
    if (Result<HolderShape> shape = holder_shape(holder, mm_per(unit_))) holders_.emplace(holder.name, shape->segments);
  }
}

}  // namespace gouge
