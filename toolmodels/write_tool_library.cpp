#include <cmath>
#include <nlohmann/json.hpp>

#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

using nlohmann::ordered_json;

class LibraryWriter {
 public:
  explicit LibraryWriter(LengthUnit unit) : factor_(mm_per(unit)) {}

  ordered_json operator()(const FlatCutter& c) const {
    return {{"shape", "flat"}, {"diameter", length(c.diameter_mm)}, {"length", length(c.length_mm)}};
  }
  ordered_json operator()(const BallCutter& c) const {
    return {{"shape", "ball"}, {"diameter", length(c.diameter_mm)}, {"length", length(c.length_mm)}};
  }
  ordered_json operator()(const BullNoseCutter& c) const {
    return {{"shape", "bull_nose"},
            {"diameter", length(c.diameter_mm)},
            {"corner_radius", length(c.corner_radius_mm)},
            {"length", length(c.length_mm)}};
  }
  ordered_json operator()(const TaperedCutter& c) const {
    return {{"shape", "tapered"},
            {"diameter", length(c.diameter_mm)},
            {"corner_radius", length(c.corner_radius_mm)},
            {"taper_angle", c.taper_angle_deg},
            {"length", length(c.length_mm)}};
  }
  ordered_json operator()(const AptCutter& c) const {
    return {{"shape", "apt"},      {"d", length(c.d_mm)},  {"r", length(c.r_mm)}, {"e", length(c.e_mm)},
            {"f", length(c.f_mm)}, {"alpha", c.alpha_deg}, {"beta", c.beta_deg},  {"h", length(c.h_mm)}};
  }

  // The text must read back as the very same millimetres, which one division does not promise.
  [[nodiscard]] double length(double value_mm) const {
    const double value = value_mm / factor_;
    for (const double near : {value, std::nextafter(value, 1e300), std::nextafter(value, -1e300)})
      if (!(near * factor_ < value_mm) && !(near * factor_ > value_mm)) return near;
    return value;
  }

  [[nodiscard]] ordered_json segments(const std::vector<ToolSegment>& list) const {
    ordered_json result = ordered_json::array();
    for (const ToolSegment& s : list) {
      result.push_back({{"lower_diameter", length(s.lower_diameter_mm)},
                        {"upper_diameter", length(s.upper_diameter_mm)},
                        {"length", length(s.length_mm)}});
    }
    return result;
  }

  [[nodiscard]] ordered_json tool(const ToolAssembly& t) const {
    ordered_json result = ordered_json::object();
    if (t.number) result["number"] = *t.number;
    if (!t.name.empty()) result["name"] = t.name;
    result["cutter"] = std::visit(*this, t.cutter);
    if (!t.shank.empty()) result["shank"] = segments(t.shank);
    if (!t.holder.empty()) result["holder"] = segments(t.holder);
    return result;
  }

 private:
  double factor_;
};

}  // namespace

std::string write_tool_library(const ToolLibrary& library) {
  const LibraryWriter writer(library.unit);
  ordered_json document;
  document["units"] = library.unit == LengthUnit::inch ? "inch" : "mm";
  document["tools"] = ordered_json::array();
  for (const ToolAssembly& tool : library.tools) document["tools"].push_back(writer.tool(tool));
  for (const NamedHolder& holder : library.holders) {
    document["holders"].push_back({{"name", holder.name}, {"segments", writer.segments(holder.segments)}});
  }
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace gouge
