#include <nlohmann/json.hpp>

#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

using nlohmann::ordered_json;

class LibraryWriter {
 public:
  explicit LibraryWriter(LengthUnit unit) : factor_(1 / mm_per(unit)) {}

  ordered_json operator()(const FlatCutter& c) const {
    return {{"shape", "flat"}, {"diameter", c.diameter_mm * factor_}, {"length", c.length_mm * factor_}};
  }
  ordered_json operator()(const BallCutter& c) const {
    return {{"shape", "ball"}, {"diameter", c.diameter_mm * factor_}, {"length", c.length_mm * factor_}};
  }
  ordered_json operator()(const BullNoseCutter& c) const {
    return {{"shape", "bull_nose"},
            {"diameter", c.diameter_mm * factor_},
            {"corner_radius", c.corner_radius_mm * factor_},
            {"length", c.length_mm * factor_}};
  }
  ordered_json operator()(const TaperedCutter& c) const {
    return {{"shape", "tapered"},
            {"diameter", c.diameter_mm * factor_},
            {"corner_radius", c.corner_radius_mm * factor_},
            {"taper_angle", c.taper_angle_deg},
            {"length", c.length_mm * factor_}};
  }
  ordered_json operator()(const AptCutter& c) const {
    return {{"shape", "apt"},        {"d", c.d_mm * factor_}, {"r", c.r_mm * factor_},
            {"e", c.e_mm * factor_}, {"f", c.f_mm * factor_}, {"alpha", c.alpha_deg},
            {"beta", c.beta_deg},    {"h", c.h_mm * factor_}};
  }

  [[nodiscard]] ordered_json segments(const std::vector<ToolSegment>& list) const {
    ordered_json result = ordered_json::array();
    for (const ToolSegment& s : list) {
      result.push_back({{"lower_diameter", s.lower_diameter_mm * factor_},
                        {"upper_diameter", s.upper_diameter_mm * factor_},
                        {"length", s.length_mm * factor_}});
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
