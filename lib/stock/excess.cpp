#include "lib/stock/excess.h"

#include <algorithm>
#include <numeric>

#include "lib/stock/excess_places.h"

namespace gouge {

namespace {

// Facets that one thread takes at a time, and pieces whose highest column is found together.
constexpr std::size_t kFacets = 64, kPieces = 256;
// Pieces nearer than this share of the part's diagonal are in one place, and the border of an area is found to it.
constexpr double kPlaceShare = 0.005;

struct Facet {
  std::uint32_t mesh, triangle;
};

class ExcessFinder {
 public:
  ExcessFinder(const ExcessQuestion& question, double height_mm, unsigned threads, const ProgressCall& progress)
      : q_(question), height_mm_(height_mm), threads_(threads), progress_(progress) {
    Box3 box;
    for (std::size_t m = 0; m < q_.parts.size(); ++m) box.extend(q_.parts.mesh(m).box());
    diagonal_mm_ = box.isEmpty() ? 0 : box.diagonal().norm();
  }

  ExcessResult run() {
    search_facets();
    group();
    find_heights();
    sort_places();
    return std::move(result_);
  }

 private:
  void search_facets() {
    std::vector<Facet> facets;
    for (std::uint32_t m = 0; m < q_.parts.size(); ++m) {
      const auto triangles = static_cast<std::uint32_t>(q_.parts.mesh(m).triangles.size());
      for (std::uint32_t t = 0; t < triangles; ++t) facets.push_back({m, t});
    }
    const std::size_t chunks = (facets.size() + kFacets - 1) / kFacets;
    std::vector<std::vector<LeftPiece>> left(chunks);
    std::vector<double> area(chunks, 0);
    for_each_chunk(facets.size(), kFacets, threads_, "finding material left on the part", progress_,
                   [&](std::size_t first, std::size_t last) {
                     ColumnProofs proofs(q_);
                     for (std::size_t f = first; f < last; ++f)
                       area[first / kFacets] += search(facets[f], proofs, left[first / kFacets]);
                   });
    for (const std::vector<LeftPiece>& some : left) result_.left.insert(result_.left.end(), some.begin(), some.end());
    result_.surface_mm2 = std::accumulate(area.begin(), area.end(), 0.0);
  }

  /// Returns the area of the facet.
  double search(const Facet& facet, ColumnProofs& proofs, std::vector<LeftPiece>& left) const {
    const IndexedMesh& mesh = q_.parts.mesh(facet.mesh);
    FacetPiece piece{{mesh.corner(facet.triangle, 0), mesh.corner(facet.triangle, 1), mesh.corner(facet.triangle, 2)},
                     face_normal(mesh, facet.triangle),
                     facet.mesh,
                     facet.triangle};
    if (piece.normal.isZero(0)) return 0;
    find_left(proofs, q_, piece, {height_mm_, kPlaceShare * diagonal_mm_}, left);
    return piece.area_mm2();
  }

  void group() {
    if (result_.left.empty()) return;
    const std::vector<std::uint32_t> places = places_of(result_.left, kPlaceShare * diagonal_mm_);
    result_.places.resize(1 + *std::max_element(places.begin(), places.end()));
    for (const std::uint32_t place : places) ++result_.places[place].pieces;
    std::uint32_t first = 0;
    for (ExcessPlace& place : result_.places) {
      place.first_piece = first;
      first += place.pieces;
      place.pieces = 0;
    }
    std::vector<LeftPiece> sorted(result_.left.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      ExcessPlace& place = result_.places[places[k]];
      sorted[place.first_piece + place.pieces++] = result_.left[k];
      const double area = result_.left[k].piece.area_mm2();
      place.area_upper_mm2 += area;
      if (result_.left[k].is_proved) place.area_mm2 += area;
    }
    result_.left = std::move(sorted);
  }

  void find_heights() {
    struct Task {
      std::uint32_t place, first, last;
    };
    std::vector<Task> tasks;
    for (std::uint32_t p = 0; p < result_.places.size(); ++p) {
      const ExcessPlace& place = result_.places[p];
      const std::uint32_t end = place.first_piece + place.pieces;
      for (std::uint32_t k = place.first_piece; k < end; k += kPieces)
        tasks.push_back({p, k, std::min<std::uint32_t>(k + kPieces, end)});
    }
    std::vector<HighestColumn> found(tasks.size());
    for_each_chunk(tasks.size(), 1, threads_, "measuring material left on the part", progress_,
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t k = first; k < last; ++k) {
                       ColumnProofs proofs(q_);
                       const std::span<const LeftPiece> all = result_.left;
                       found[k] = find_highest(proofs, q_, all.subspan(tasks[k].first, tasks[k].last - tasks[k].first),
                                               height_mm_);
                     }
                   });
    for (std::size_t k = 0; k < tasks.size(); ++k) join(found[k], result_.places[tasks[k].place].highest);
    for (ExcessPlace& place : result_.places)
      if (!place.is_proved()) place.unknown = unknown_near(place);
  }

  static void join(const HighestColumn& one, HighestColumn& all) {
    const double upper = std::max(all.height_upper_mm, one.height_upper_mm);
    if (one.height_mm > all.height_mm) all = one;
    all.height_upper_mm = upper;
  }

  CutMove unknown_near(const ExcessPlace& place) const {
    const ColumnProofs proofs(q_);
    for (std::uint32_t k = 0; k < place.pieces; ++k) {
      if (const auto unknown = proofs.unknown_near(result_.left[place.first_piece + k].piece, height_mm_))
        return unknown;
    }
    return {};
  }

  /// Leaves out places where the search for the highest column proved that there is none.
  void sort_places() {
    std::erase_if(result_.places, [&](const ExcessPlace& place) {
      return !place.is_proved() && !(place.highest.height_upper_mm > height_mm_ + q_.resolution_mm);
    });
    std::stable_sort(result_.places.begin(), result_.places.end(), [](const ExcessPlace& a, const ExcessPlace& b) {
      if (a.is_proved() != b.is_proved()) return a.is_proved();
      const double x = a.is_proved() ? a.highest.height_mm : a.highest.height_upper_mm;
      const double y = b.is_proved() ? b.highest.height_mm : b.highest.height_upper_mm;
      return x > y;
    });
  }

  const ExcessQuestion& q_;
  double height_mm_, diagonal_mm_ = 0;
  unsigned threads_;
  const ProgressCall& progress_;
  ExcessResult result_;
};

}  // namespace

double ExcessResult::area_mm2() const {
  return std::accumulate(places.begin(), places.end(), 0.0,
                         [](double sum, const ExcessPlace& place) { return sum + place.area_mm2; });
}

double ExcessResult::area_upper_mm2() const {
  return std::accumulate(places.begin(), places.end(), 0.0,
                         [](double sum, const ExcessPlace& place) { return sum + place.area_upper_mm2; });
}

ExcessResult find_excess(const ExcessQuestion& question, double height_mm, unsigned threads,
                         const ProgressCall& progress) {
  return ExcessFinder(question, height_mm, threads, progress).run();
}

}  // namespace gouge
