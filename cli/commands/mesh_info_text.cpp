#include "cli/commands/mesh_info_text.h"

#include <cmath>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

constexpr std::size_t kMeshLabelWidth = 26;

std::string mesh_row(const std::string& name, const std::string& value) {
  return "  " + padded(name, kMeshLabelWidth - 1) + " " + printable(value) + "\n";
}

// Texts of lengths, areas and volumes of the mesh in the unit of its file.
class Lengths {
 public:
  explicit Lengths(LengthUnit unit) : unit_(unit), decimals_(facts_of(unit).decimals) {}

  [[nodiscard]] std::string vector(const Vec3& v_mm, const std::string& between) const {
    const double mm = mm_per(unit_);
    return display_text(v_mm.x() / mm, decimals_, Zeros::kept) + between +
           display_text(v_mm.y() / mm, decimals_, Zeros::kept) + between +
           display_text(v_mm.z() / mm, decimals_, Zeros::kept);
  }

  [[nodiscard]] std::string power(double value_mm, int power) const {
    for (int k = 0; k < power; ++k) value_mm /= mm_per(unit_);
    return display_text(value_mm, decimals_, Zeros::kept) + " " + unit_name(unit_) + std::to_string(power);
  }

  [[nodiscard]] std::string exact(double length_mm) const {
    return exact_text(std::round(length_mm / mm_per(unit_) * 1e9) / 1e9) + " " + unit_name(unit_);
  }

  [[nodiscard]] std::string spot(const MeshSpot& spot) const {
    if (spot.count == 0) return "none";
    return std::to_string(spot.count) + (spot.count == 1 ? ", at " : ", first at ") + position_text(spot, unit_);
  }

  [[nodiscard]] std::string crossings(const SelfIntersections& found) const {
    if (found.pairs == 0) return "none";
    return count_text(found.pairs, "pair") + (found.pairs == 1 ? ", at (" : ", first at (") +
           vector(found.position_mm, ", ") + ") " + unit_name(unit_) + ", triangles " +
           std::to_string(found.first_triangle + 1) + " and " + std::to_string(found.second_triangle + 1);
  }

 private:
  LengthUnit unit_;
  int decimals_;
};

std::string size_rows(const MeshInfo& info, const Lengths& lengths) {
  const MeshFindings& found = info.judged.findings;
  std::string handles;
  if (found.handles().value_or(0) > 0)
    handles = ", " + count_text(static_cast<std::size_t>(*found.handles()), "through hole");
  std::string text;
  text += mesh_row("format", std::string(info.format == StlFormat::binary ? "binary" : "ASCII") + " STL, read as " +
                                 unit_name(info.unit));
  text += mesh_row("triangles", std::to_string(found.triangles) + " (" + count_text(found.edges, "edge") + ", " +
                                    count_text(found.vertices, "vertex", "vertices") + ")");
  text +=
      mesh_row("pieces", std::to_string(found.components) + handles +
                             (found.cavities > 0 ? ", including " + count_text(found.cavities, "inner shell") : ""));
  text += mesh_row("size", lengths.vector(found.box_mm.sizes(), " x ") + " " + unit_name(info.unit) + ", from (" +
                               lengths.vector(found.box_mm.min(), ", ") + ")");
  text += mesh_row("area", lengths.power(found.area_mm2, 2));
  text += mesh_row("volume", info.judged.volume_mm3 ? lengths.power(*info.judged.volume_mm3, 3)
                                                    : std::string("undefined (see below)"));
  return text;
}

std::string defect_rows(const MeshValidation& judged, const Lengths& lengths) {
  const MeshFindings& found = judged.findings;
  std::string text;
  text += mesh_row("open edges", lengths.spot(found.boundary_edges));
  text += mesh_row("non-manifold edges", lengths.spot(found.non_manifold_edges));
  text += mesh_row("non-manifold vertices", lengths.spot(found.non_manifold_vertices));
  text += mesh_row("contradicting edges", lengths.spot(found.misoriented_edges));
  text += mesh_row("pieces inside out", lengths.spot(found.inside_out_components));
  text += mesh_row("self-intersections",
                   judged.trouble.empty() ? lengths.crossings(judged.self_intersections) : "not decided");
  text += mesh_row("duplicate triangles", lengths.spot(found.duplicate_triangles));
  text += mesh_row("degenerate triangles", lengths.spot(found.degenerate_triangles));
  text += mesh_row("triangles without area", lengths.spot(found.collinear_triangles));
  if (judged.bounds_volume && !*judged.bounds_volume && found.inside_out_components.count == 0) {
    text += mesh_row("nesting", "a closed piece lies inside another without being a cavity of it");
  }
  if (found.opposite_normals.count > 0) text += mesh_row("normals turned", lengths.spot(found.opposite_normals));
  return text;
}

std::string verdict(const MeshValidation& judged) {
  if (judged.is_sound()) return "sound: closed, manifold, facing outward, free of self-intersections";
  if (!judged.trouble.empty()) return "not decided: " + printable(judged.trouble);
  return count_text(judged.defects(), "defect");
}

std::string meaning(const MeshValidation& judged) {
  if (judged.findings.is_solid()) return "depths are found, and a tool wholly inside the part is reported";
  return "depths are found on every triangle; a tool that may be wholly inside the part is never clean, but may be "
         "reported as not certified only";
}

std::string weld_rows(const MeshInfo& info, const Lengths& lengths) {
  const MeshWeld& weld = *info.weld;
  std::string text = "weld: vertices no more than " + lengths.exact(weld.reach_mm) + " apart become one\n";
  text += mesh_row(
      "vertices joined",
      std::to_string(weld.vertices_joined) +
          (weld.vertices_joined > 0 ? ", moved by up to " + lengths.exact(weld.largest_shift_mm) : std::string()));
  text += mesh_row("triangles collapsed", std::to_string(weld.triangles_collapsed));
  text += defect_rows(weld.judged, lengths);
  text += "welded: " + verdict(weld.judged) + "\n";
  if (info.repair) return text;
  return text + "not written: give --repair OUT.stl to write the welded mesh\n";
}

std::string repair_rows(const MeshInfo& info) {
  const RepairSteps& steps = info.repair->steps;
  std::string text = "repair\n";
  text += mesh_row("degenerate removed", std::to_string(steps.degenerate_removed));
  text += mesh_row("duplicates removed", std::to_string(steps.duplicates_removed));
  text += mesh_row("vertices split", std::to_string(steps.vertices_split));
  text += mesh_row("borders stitched", count_text(steps.borders_stitched, "pair"));
  text += mesh_row("without area removed",
                   std::to_string(steps.collinear_removed) +
                       (steps.collinear_left > 0 ? ", " + std::to_string(steps.collinear_left) + " left" : ""));
  text += mesh_row("holes filled", std::to_string(steps.holes_filled) + " (" +
                                       count_text(steps.hole_triangles_added, "triangle") + " added), " +
                                       std::to_string(steps.holes_left) + " left");
  text += mesh_row("triangles turned", std::to_string(steps.triangles_turned));
  if (steps.pieces_not_oriented > 0) {
    text += mesh_row("flat pieces",
                     std::to_string(steps.pieces_not_oriented) + ", closed but without an inside: left as they are");
  }
  text += "repaired: " + verdict(info.repair->after) + "\n";
  if (!info.written_file.empty()) return text + "written: " + printable(info.written_file) + "\n";
  return text + (info.judged.is_sound() ? "not written: there was nothing to repair\n"
                                        : "not written: the repair leaves no fewer defects than there were\n");
}

}  // namespace

std::string mesh_info_text(const MeshInfo& info) {
  const Lengths lengths(info.unit);
  std::string text = printable(info.file) + "\n" + size_rows(info, lengths) + defect_rows(info.judged, lengths);
  text += "verdict: " + verdict(info.judged) + "\n";
  text += "for a check: " + meaning(info.judged) + "\n";
  for (const Diagnostic& note : info.notes) {
    if (note.code.starts_with("stl-")) text += to_text(note) + "\n";
  }
  if (info.weld) text += weld_rows(info, lengths);
  if (info.repair) text += repair_rows(info);
  return text;
}

}  // namespace gouge
