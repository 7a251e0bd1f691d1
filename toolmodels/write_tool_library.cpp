#include <cmath>
#include <nlohmann/json.hpp>

#include "toolmodels/cutter_fields.h"
#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

using nlohmann::ordered_json;

class LibraryWriter {
 public:
  explicit LibraryWriter(const ToolLibrary& library) : library_(library), factor_(mm_per(library.unit)) {}

  [[nodiscard]] ordered_json cutter(const Cutter& cutter) const {
    ordered_json result = {{"shape", shape_name(cutter)}};
    Cutter copy = cutter;
    detail::visit_fields(copy, [&](const detail::CutterField& field) {
      if (field.otherwise && std::abs(*field.value) <= 0) return;
      result[field.key] = field.kind == detail::FieldKind::length ? length(*field.value) : *field.value;
    });
    if (const auto* profile = std::get_if<ProfileCutter>(&cutter)) result["points"] = points(*profile);
    return result;
  }

  [[nodiscard]] ordered_json points(const ProfileCutter& profile) const {
    ordered_json result = ordered_json::array();
    for (const ProfilePoint& p : profile.points) {
      result.push_back({{"r", length(p.r_mm)}, {"z", length(p.z_mm)}});
      if (p.shape == ProfilePoint::SegmentShape::straight) continue;
      result.back()["arc"] = p.shape == ProfilePoint::SegmentShape::convex ? "convex" : "concave";
      result.back()["radius"] = length(p.radius_mm);
    }
    return result;
  }

  // Returns the length in the file's unit. It must read back as exactly the same millimetres, which a single division
  // does not guarantee.
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
    result["cutter"] = cutter(t.cutter);
    if (!t.shank.empty()) result["shank"] = segments(t.shank);
    for (const ToolExtension& e : t.extensions)
      result["extensions"].push_back(
          {{"name", e.name}, {"counts_as", body_name(e.counts_as)}, {"segments", segments(e.segments)}});
    if (!t.holder.empty()) result["holder"] = segments(t.holder);
    if (t.stickout_mm > 0) result["stickout"] = length(t.stickout_mm);
    if (t.gauge_length_mm > 0) result["gauge_length"] = length(t.gauge_length_mm);
    if (!t.cuts) result["cuts"] = false;
    if (const std::string why = uncertainty(t); !why.empty()) result["uncertain"] = why;
    return result;
  }

 private:
  // A library of ours cannot state that a number had several tools, so the tool itself states it.
  [[nodiscard]] std::string uncertainty(const ToolAssembly& t) const {
    if (!t.uncertainty.empty()) return t.uncertainty;
    if (t.holder.empty() && !t.missing_holder.empty()) return t.missing_holder;
    if (!t.number || !library_.is_shared_number(*t.number)) return {};
    return "the file that it was imported from has several tools of number " + std::to_string(*t.number);
  }

  const ToolLibrary& library_;
  double factor_;
};

}  // namespace

std::string write_tool_library(const ToolLibrary& library) {
  const LibraryWriter writer(library);
  ordered_json document;
  document["units"] = library.unit == LengthUnit::inch ? "inch" : "mm";
  document["tools"] = ordered_json::array();
  for (const ToolAssembly& tool : library.tools) document["tools"].push_back(writer.tool(tool));
  for (const NamedHolder& holder : library.holders) {
    document["holders"].push_back({{"name", holder.name}, {"segments", writer.segments(holder.segments)}});
    if (!holder.uncertainty.empty()) document["holders"].back()["uncertain"] = holder.uncertainty;
  }
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace gouge
