#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/validate/cgal_bridge.h"
#include "lib/validate/cgal_guard.h"

namespace gouge::detail {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Polygon = std::array<std::size_t, 3>;

// Maximum number of border edges for which CGAL may use its cubic search. For larger holes that search would take
// minutes.
constexpr std::size_t kLongestCubicHole = 300;

// A guard: during its lifetime CGAL neither prints nor aborts.
class QuietCgal {
 public:
  QuietCgal()
      : behaviour_(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION)),
        error_(CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {})),
        warning_(CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {})) {}
  ~QuietCgal() {
    CGAL::set_error_behaviour(behaviour_);
    CGAL::set_error_handler(error_);
    CGAL::set_warning_handler(warning_);
  }
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  CGAL::Failure_behaviour behaviour_;
  CGAL::Failure_function error_;
  CGAL::Failure_function warning_;
};

Vec3 to_vec(const Point& p) { return {p.x(), p.y(), p.z()}; }

void to_soup(const IndexedMesh& mesh, std::vector<Point>& points, std::vector<Polygon>& polygons) {
  points.reserve(mesh.vertices.size());
  polygons.reserve(mesh.triangles.size());
  for (const Vec3& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  for (const TriangleCorners& t : mesh.triangles) polygons.push_back({t[0], t[1], t[2]});
}

// Returns nothing if the triangles do not form a manifold surface.
std::optional<SurfaceMesh> to_surface_mesh(const IndexedMesh& mesh) {
  SurfaceMesh surface;
  const auto counted = [](std::size_t count) { return static_cast<SurfaceMesh::size_type>(count); };
  surface.reserve(counted(mesh.vertices.size()), counted(3 * mesh.triangles.size() / 2),
                  counted(mesh.triangles.size()));
  for (const Vec3& v : mesh.vertices) surface.add_vertex({v.x(), v.y(), v.z()});
  for (const TriangleCorners& t : mesh.triangles) {
    const std::array<SurfaceMesh::Vertex_index, 3> corners{
        SurfaceMesh::Vertex_index(t[0]), SurfaceMesh::Vertex_index(t[1]), SurfaceMesh::Vertex_index(t[2])};
    if (CGAL::Euler::add_face(corners, surface) == SurfaceMesh::null_face()) return std::nullopt;
  }
  return surface;
}

IndexedMesh to_indexed_mesh(SurfaceMesh& surface, const std::string& name) {
  surface.collect_garbage();
  IndexedMesh mesh;
  mesh.name = name;
  for (const auto vertex : surface.vertices()) mesh.vertices.push_back(to_vec(surface.point(vertex)));
  for (const auto face : surface.faces()) {
    TriangleCorners corners{};
    std::size_t k = 0;
    for (const auto vertex : CGAL::vertices_around_face(surface.halfedge(face), surface)) {
      corners[k++] = static_cast<Corner>(vertex.idx());
    }
    mesh.file_triangle.push_back(static_cast<std::uint32_t>(mesh.triangles.size()));
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

std::size_t count_faces_without_area(const SurfaceMesh& surface) {
  std::vector<SurfaceMesh::Face_index> found;
  pmp::degenerate_faces(surface, std::back_inserter(found));
  return found.size();
}

double squared_length(const SurfaceMesh& surface, SurfaceMesh::Halfedge_index side) {
  return CGAL::squared_distance(surface.point(surface.source(side)), surface.point(surface.target(side)));
}

SurfaceMesh::Halfedge_index longest_side(const SurfaceMesh& surface, SurfaceMesh::Face_index face) {
  SurfaceMesh::Halfedge_index longest = surface.halfedge(face);
  for (const auto side : CGAL::halfedges_around_face(surface.halfedge(face), surface)) {
    if (squared_length(surface, side) > squared_length(surface, longest)) longest = side;
  }
  return longest;
}

// Flips edges to remove faces without area. The middle corner of such a face splits the neighbour at its longest side.
// Such an edge flip moves no point of the surface. A face without a neighbour at that side is removed, which loses
// nothing.
void flip_faces_without_area(SurfaceMesh& surface) {
  constexpr std::size_t kMaxFlipsEach = 20;  // several faces on one line may exchange corners back and forth
  std::vector<SurfaceMesh::Face_index> open;
  pmp::degenerate_faces(surface, std::back_inserter(open));
  for (std::size_t left = kMaxFlipsEach * open.size(); left > 0 && !open.empty(); --left) {
    const SurfaceMesh::Face_index face = open.back();
    open.pop_back();
    if (surface.is_removed(face) || !pmp::is_degenerate_triangle_face(face, surface)) continue;
    const auto side = longest_side(surface, face);
    const auto across = surface.opposite(side);
    if (surface.is_border(across)) {
      CGAL::Euler::remove_face(side, surface);
      continue;
    }
    const auto corner = surface.target(surface.next(side));
    const auto other_corner = surface.target(surface.next(across));
    if (corner == other_corner || CGAL::halfedge(corner, other_corner, surface).second) continue;
    CGAL::Euler::flip_edge(side, surface);
    open.push_back(surface.face(side));
    open.push_back(surface.face(across));
  }
}

// Removes faces without area by flipping and collapsing edges, so the surface does not move. Returns the number of
// removed faces. CGAL has more methods than flips alone, but it fails on some surfaces.
std::size_t remove_faces_without_area(SurfaceMesh& surface) {
  const std::size_t count = count_faces_without_area(surface);
  if (count == 0) return 0;
  SurfaceMesh attempt = surface;
  try {
    pmp::remove_degenerate_faces(attempt);
    surface = std::move(attempt);
  } catch (const CGAL::Failure_exception&) {
    flip_faces_without_area(surface);
  }
  return count - std::min(count, count_faces_without_area(surface));
}

// Returns whether the border surrounds a lone triangle. Such a border is not a hole: its filling would be the other
// side of the triangle.
bool is_rim_of_triangle(const SurfaceMesh& surface, SurfaceMesh::Halfedge_index rim) {
  const auto inside = surface.opposite(rim);
  const auto neighbours = CGAL::halfedges_around_face(inside, surface);
  return std::all_of(neighbours.begin(), neighbours.end(),
                     [&](const auto side) { return surface.is_border(surface.opposite(side)); });
}

void fill_holes(SurfaceMesh& surface, bool fills_holes, RepairSteps& steps) {
  std::vector<SurfaceMesh::Halfedge_index> holes;
  pmp::extract_boundary_cycles(surface, std::back_inserter(holes));
  for (const auto hole : holes) {
    std::vector<SurfaceMesh::Face_index> patch;
    if (fills_holes && !is_rim_of_triangle(surface, hole)) {
      const auto rim = CGAL::halfedges_around_face(hole, surface);
      const bool is_long = static_cast<std::size_t>(std::distance(rim.begin(), rim.end())) > kLongestCubicHole;
      const auto options = pmp::parameters::do_not_use_cubic_algorithm(is_long);
#if CGAL_VERSION_NR < 1050600000
      pmp::triangulate_hole(surface, hole, std::back_inserter(patch), options);
#else
      pmp::triangulate_hole(surface, hole, options.face_output_iterator(std::back_inserter(patch)));
#endif
    }
    if (patch.empty()) {
      ++steps.holes_left;
    } else {
      ++steps.holes_filled;
      steps.hole_triangles_added += patch.size();
    }
  }
}

// Orients pieces that do not cross by their nesting. If pieces cross, each closed piece faces outward by itself.
void orient_as_one(SurfaceMesh& surface) {
  if (CGAL::is_closed(surface)) {
    pmp::orient_to_bound_a_volume(surface);
  } else {
    pmp::orient(surface);
  }
}

// Returns whether CGAL can determine the facing of a piece. It cannot if the triangles at its uppermost corner lie in
// one plane.
bool has_facing(const SurfaceMesh& piece) {
  if (!CGAL::is_closed(piece)) return true;
  try {
    static_cast<void>(pmp::is_outward_oriented(piece));
    return true;
  } catch (const CGAL::Failure_exception&) {
    return false;
  }
}

// Orients all pieces with a known facing. The other pieces are flat and bound nothing. They do not change and do not
// prevent the turning of other pieces.
void orient_outward(SurfaceMesh& surface, RepairSteps& steps) {
  SurfaceMesh attempt = surface;
  try {
    orient_as_one(attempt);
    surface = std::move(attempt);
    return;
  } catch (const CGAL::Failure_exception&) {
    surface.collect_garbage();
  }
  std::vector<SurfaceMesh> pieces;
  pmp::split_connected_components(surface, pieces);
  SurfaceMesh facing, flat;
  for (const SurfaceMesh& piece : pieces) {
    const bool is_facing = has_facing(piece);
    CGAL::copy_face_graph(piece, is_facing ? facing : flat);
    steps.pieces_not_oriented += is_facing ? 0 : 1;
  }
  if (facing.number_of_faces() > 0) orient_as_one(facing);
  CGAL::copy_face_graph(flat, facing);
  surface = std::move(facing);
}

}  // namespace

Outcome run_guarded(const std::string& task, const std::function<void()>& work) {
  const QuietCgal quiet;
  try {
    work();
    return Done{};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return make_error("cgal-failed", "the triangles are too degenerate to " + task);
  }
}

Result<VolumeFacts> find_volume_facts(const IndexedMesh& mesh) {
  return guarded<VolumeFacts>("find what they bound", [&]() -> Result<VolumeFacts> {
    std::optional<SurfaceMesh> made = to_surface_mesh(mesh);
    if (!made) return make_error("cgal-failed", "the triangles do not form a manifold surface");
    SurfaceMesh& surface = *made;
    remove_faces_without_area(surface);  // they bound nothing, and CGAL cannot determine their facing
    if (surface.number_of_faces() == 0 || !CGAL::is_closed(surface))
      return make_error("cgal-failed", "the surface is not closed");
    VolumeFacts facts;
    facts.bounds_volume = pmp::does_bound_a_volume(surface) && pmp::is_outward_oriented(surface);
    facts.volume_mm3 = CGAL::to_double(pmp::volume(surface));
    return facts;
  });
}

Result<CgalRepair> repair_with_cgal(const IndexedMesh& mesh, bool fills_holes) {
  return guarded<CgalRepair>("be repaired", [&]() -> Result<CgalRepair> {
    CgalRepair repair;
    RepairSteps& steps = repair.steps;
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    to_soup(mesh, points, polygons);
    steps.duplicates_removed = pmp::merge_duplicate_polygons_in_polygon_soup(points, polygons);
    const std::size_t points_before = points.size();
    pmp::orient_polygon_soup(points, polygons);
    steps.vertices_split = points.size() - points_before;
    SurfaceMesh surface;
    pmp::polygon_soup_to_polygon_mesh(points, polygons, surface);
    points = {};
    polygons = {};
    steps.borders_stitched = pmp::stitch_borders(surface);
    steps.collinear_removed = remove_faces_without_area(surface);
    steps.vertices_split += pmp::duplicate_non_manifold_vertices(surface);
    if (surface.number_of_faces() == 0) return make_error("cgal-failed", "no triangle with area is left");
    fill_holes(surface, fills_holes, steps);
    steps.collinear_left = count_faces_without_area(surface);
    orient_outward(surface, steps);
    repair.mesh = to_indexed_mesh(surface, mesh.name);
    return repair;
  });
}

}  // namespace gouge::detail
