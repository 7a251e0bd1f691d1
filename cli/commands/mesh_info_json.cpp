#include "cli/commands/mesh_info_text.h"
#include "cli/output/json_text.h"

namespace gouge {
namespace {

Json spot_json(const MeshSpot& spot, LengthUnit unit) {
  Json json = {{"count", spot.count}};
  if (spot.count > 0) {
    json["first_at"] = point_json(spot.position_mm, mm_per(unit));
    json["first_triangle"] = spot.file_triangle + 1;
  }
  return json;
}

Json crossings_json(const SelfIntersections& found, LengthUnit unit) {
  Json json = {{"pairs", found.pairs}};
  if (found.pairs > 0) {
    json["first_at"] = point_json(found.position_mm, mm_per(unit));
    json["first_triangles"] = {found.first_triangle + 1, found.second_triangle + 1};
  }
  return json;
}

Json defects_json(const MeshValidation& judged, LengthUnit unit) {
  const MeshFindings& found = judged.findings;
  return {{"open_edges", spot_json(found.boundary_edges, unit)},
          {"non_manifold_edges", spot_json(found.non_manifold_edges, unit)},
          {"non_manifold_vertices", spot_json(found.non_manifold_vertices, unit)},
          {"contradicting_edges", spot_json(found.misoriented_edges, unit)},
          {"pieces_inside_out", spot_json(found.inside_out_components, unit)},
          {"self_intersections", judged.trouble.empty() ? crossings_json(judged.self_intersections, unit) : Json()},
          {"duplicate_triangles", spot_json(found.duplicate_triangles, unit)},
          {"degenerate_triangles", spot_json(found.degenerate_triangles, unit)},
          {"triangles_without_area", spot_json(found.collinear_triangles, unit)},
          {"normals_turned", spot_json(found.opposite_normals, unit)}};
}

Json judged_json(const MeshValidation& judged, LengthUnit unit) {
  const MeshFindings& found = judged.findings;
  const double mm = mm_per(unit);
  Json json = {{"sound", judged.is_sound()},
               {"tells_buried_tools", found.is_solid()},
               {"defect_count", judged.defects()},
               {"triangles", found.triangles},
               {"edges", found.edges},
               {"vertices", found.vertices},
               {"euler_number", found.euler_number()},
               {"pieces", found.components},
               {"inner_shells", found.cavities},
               {"box", {point_json(found.box_mm.min(), mm), point_json(found.box_mm.max(), mm)}},
               {"area", found.area_mm2 / (mm * mm)}};
  json["volume"] = judged.volume_mm3 ? Json(*judged.volume_mm3 / (mm * mm * mm)) : Json();
  json["bounds_volume"] = judged.bounds_volume ? Json(*judged.bounds_volume) : Json();
  if (!judged.trouble.empty()) json["not_decided"] = judged.trouble;
  json["defects"] = defects_json(judged, unit);
  return json;
}

Json repair_json(const MeshInfo& info) {
  const RepairSteps& steps = info.repair->steps;
  Json json = {{"steps",
                {{"degenerate_removed", steps.degenerate_removed},
                 {"duplicates_removed", steps.duplicates_removed},
                 {"vertices_split", steps.vertices_split},
                 {"borders_stitched", steps.borders_stitched},
                 {"without_area_removed", steps.collinear_removed},
                 {"without_area_left", steps.collinear_left},
                 {"holes_filled", steps.holes_filled},
                 {"hole_triangles_added", steps.hole_triangles_added},
                 {"holes_left", steps.holes_left},
                 {"triangles_turned", steps.triangles_turned},
                 {"flat_pieces", steps.pieces_not_oriented}}},
               {"result", judged_json(info.repair->after, info.unit)}};
  json["written"] = info.written_file.empty() ? Json() : Json(info.written_file);
  return json;
}

Json weld_json(const MeshWeld& weld, LengthUnit unit) {
  const double mm = mm_per(unit);
  return {{"distance", weld.reach_mm / mm},
          {"vertices_joined", weld.vertices_joined},
          {"largest_displacement", weld.largest_shift_mm / mm},
          {"triangles_collapsed", weld.triangles_collapsed},
          {"result", judged_json(weld.judged, unit)}};
}

}  // namespace

std::string mesh_info_json(const MeshInfo& info) {
  Json json = {{"file", info.file},
               {"unit", unit_name(info.unit)},
               {"format", info.format == StlFormat::binary ? "binary" : "ascii"}};
  json["mesh"] = judged_json(info.judged, info.unit);
  json["notes"] = Json::array();
  for (const Diagnostic& note : info.notes) json["notes"].push_back({{"code", note.code}, {"message", note.message}});
  if (info.weld) json["weld"] = weld_json(*info.weld, info.unit);
  if (info.repair) json["repair"] = repair_json(info);
  return json_text(json);
}

}  // namespace gouge
