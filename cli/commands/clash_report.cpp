#include "cli/commands/clash_report.h"

#include <array>
#include <cmath>

#include "cli/output/json_text.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// Returns "(0, 0.6, 0.8)"; a direction has no unit.
std::string direction_text(const Vec3& direction) {
  return "(" + display_text(direction.x(), 3) + ", " + display_text(direction.y(), 3) + ", " +
         display_text(direction.z(), 3) + ")";
}

std::string clash_finding(const ClashReport& r) {
  const Clash& clash = r.clash;
  const std::string a = printable(r.a), b = printable(r.b), depth = depth_text(clash.depth_mm, r.unit);
  switch (clash.state) {
    case ClashState::free:
      return a + ": free: " + depth_text(clash.closest.distance_mm, r.unit) + " from " + b + ", nearest at " +
             point_text(clash.closest.a, r.unit);
    case ClashState::touching:
      return a + ": touching: " + b + ", nowhere deeper than " + length_text(clash.depth_upper_mm, r.unit);
    case ClashState::not_certified:
      return a + ": not certified: against " + b + ": " + printable(clash.reason);
    case ClashState::penetrating:
      break;
  }
  if (clash.containment == Containment::a_in_b) return a + ": clash: wholly inside " + b;
  if (clash.containment == Containment::b_in_a) return b + ": clash: wholly inside " + a;
  const std::string place = clash.deepest.empty() ? "" : " at " + point_text(clash.deepest.front().point, r.unit);
  return a + ": clash: " + depth + " with " + b + place;
}

std::string depth_line(const ClashReport& r) {
  const std::string least = depth_text(r.clash.depth_mm, r.unit);
  if (!std::isfinite(r.clash.depth_upper_mm))
    return "depth: at least " + least +
           "; how deep at most is not known, since one of the surfaces bounds no solid (open, inside out or doubled)\n";
  return "depth: " + least + ", proved to be at most " + length_text(r.clash.depth_upper_mm, r.unit) + "\n";
}

std::string shift_line(const ClashReport& r) {
  const FreeShift& shift = *r.shift;
  const std::string how = shift.is_weighted ? "the weighted correction, " + count_text(shift.iterations, "iteration")
                                            : std::string("the bounding boxes, which are apart then");
  return "shift: " + printable(r.b) + " by " + point_text(shift.shift, r.unit) + ", " +
         depth_text(shift.shift.norm(), r.unit) + ", is proved " + state_name(shift.state) + " (from " + how + ")\n";
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json contact_json(const Contact& contact, double mm) {
  const bool is_of_a = contact.body == 0;
  return {{"of", is_of_a ? "a" : "b"},
          {"in", is_of_a ? "b" : "a"},
          {"depth", contact.depth_mm / mm},
          {"point", point_json(contact.point, mm)},
          {"normal", point_json(contact.normal, 1)},
          {"triangle", contact.triangle + 1}};
}

}  // namespace

const char* state_name(ClashState state) {
  static constexpr std::array<const char*, 4> kNames = {"free", "touching", "penetrating", "not-certified"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string clash_text(const ClashReport& r) {
  std::string text = clash_finding(r) + "\n";
  if (r.clash.state != ClashState::penetrating) return text;
  text += depth_line(r);
  for (const Contact& contact : r.clash.deepest) {
    const bool is_of_a = contact.body == 0;
    text += "deepest of " + printable(is_of_a ? r.a : r.b) + " in " + printable(is_of_a ? r.b : r.a) + ": " +
            depth_text(contact.depth_mm, r.unit) + " at " + point_text(contact.point, r.unit) + ", triangle " +
            std::to_string(contact.triangle + 1) + "; " + printable(r.b) + " moves away along " +
            direction_text(contact.normal) + "\n";
  }
  return r.shift ? text + shift_line(r) : text;
}

std::string clash_json(const ClashReport& r) {
  const double mm = mm_per(r.unit);
  const Clash& clash = r.clash;
  const bool is_inside = clash.containment != Containment::none;
  Json json = {{"a", r.a},
               {"b", r.b},
               {"unit", unit_name(r.unit)},
               {"tolerance", r.options.tolerance_mm / mm},
               {"resolution", r.options.resolution_mm / mm},
               {"state", state_name(clash.state)}};
  json["inside"] = is_inside ? Json(clash.containment == Containment::a_in_b ? "a" : "b") : Json();
  json["depth"] = clash.depth_mm / mm;
  json["depth_upper"] = number_or_null(clash.depth_upper_mm / mm);
  json["distance"] = clash.state == ClashState::free ? Json(clash.closest.distance_mm / mm) : Json();
  json["closest"] = {{"a", point_json(clash.closest.a, mm)}, {"b", point_json(clash.closest.b, mm)}};
  json["deepest"] = Json::array();
  for (const Contact& contact : clash.deepest) json["deepest"].push_back(contact_json(contact, mm));
  json["shift"] = Json();
  if (r.shift) {
    json["shift"] = {{"of", "b"},
                     {"by", point_json(r.shift->shift, mm)},
                     {"length", r.shift->shift.norm() / mm},
                     {"method", r.shift->is_weighted ? "weighted" : "boxes"},
                     {"iterations", r.shift->iterations},
                     {"state", state_name(r.shift->state)}};
  }
  json["reason"] = clash.reason.empty() ? Json() : Json(clash.reason);
  return json_text(json);
}

}  // namespace gouge
