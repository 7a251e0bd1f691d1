#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/base/files.h"
#include "toolmodels/library.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;

// The text must read back as the very same millimetres, which one division does not promise.
double in_unit(double value_mm, LengthUnit unit) {
  const double factor = mm_per(unit);
  double value = value_mm / factor;
  for (const double candidate : {value, std::nextafter(value, 1e300), std::nextafter(value, -1e300)})
    if (!(candidate * factor < value_mm) && !(candidate * factor > value_mm)) return candidate;
  return value;
}

Json segments_json(const std::vector<ToolSegment>& segments, LengthUnit unit) {
  Json list = Json::array();
  for (const ToolSegment& s : segments)
    list.push_back({{"lower_diameter", in_unit(s.lower_diameter_mm, unit)},
                    {"upper_diameter", in_unit(s.upper_diameter_mm, unit)},
                    {"length", in_unit(s.length_mm, unit)}});
  return list;
}

struct CutterJson {
  LengthUnit unit;

  [[nodiscard]] double u(double value_mm) const { return in_unit(value_mm, unit); }
  Json operator()(const FlatCutter& t) const {
    return {{"diameter", u(t.diameter_mm)}, {"length", u(t.length_mm)}};
  }
  Json operator()(const BallCutter& t) const {
    return {{"diameter", u(t.diameter_mm)}, {"length", u(t.length_mm)}};
  }
  Json operator()(const BullNoseCutter& t) const {
    return {
        {"diameter", u(t.diameter_mm)}, {"corner_radius", u(t.corner_radius_mm)}, {"length", u(t.length_mm)}};
  }
  Json operator()(const TaperedCutter& t) const {
    return {{"diameter", u(t.diameter_mm)},
            {"corner_radius", u(t.corner_radius_mm)},
            {"taper_angle", t.taper_angle_deg},
            {"length", u(t.length_mm)}};
  }
  Json operator()(const AptCutter& t) const {
    return {{"d", u(t.d_mm)},       {"r", u(t.r_mm)},     {"e", u(t.e_mm)}, {"f", u(t.f_mm)},
            {"alpha", t.alpha_deg}, {"beta", t.beta_deg}, {"h", u(t.h_mm)}};
  }
};

Json tool_json(const ToolAssembly& tool, LengthUnit unit) {
  Json entry = Json::object();
  if (tool.number) entry["number"] = *tool.number;
  if (!tool.name.empty()) entry["name"] = tool.name;
  Json cutter = {{"shape", shape_name(tool.cutter)}};
  cutter.update(std::visit(CutterJson{unit}, tool.cutter));
  entry["cutter"] = std::move(cutter);
  if (!tool.shank.empty()) entry["shank"] = segments_json(tool.shank, unit);
  if (!tool.holder.empty()) entry["holder"] = segments_json(tool.holder, unit);
  return entry;
}

}  // namespace

std::string library_text(const ToolLibrary& library) {
  Json root = {{"units", library.unit == LengthUnit::inch ? "inch" : "mm"}};
  root["tools"] = Json::array();
  for (const ToolAssembly& tool : library.tools) root["tools"].push_back(tool_json(tool, library.unit));
  for (const NamedHolder& holder : library.holders)
    root["holders"].push_back(
        {{"name", holder.name}, {"segments", segments_json(holder.segments, library.unit)}});
  // Bytes that are no UTF-8 (a name from elsewhere) are replaced rather than refused.
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Outcome write_library(const ToolLibrary& library, const std::string& path) {
  return write_file(path, library_text(library));
}

}  // namespace gouge
