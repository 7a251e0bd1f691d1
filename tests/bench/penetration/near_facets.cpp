#include "tests/bench/penetration/near_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lib/base/parallel.h"
#include "lib/geom/point_triangle.h"
#include "lib/penetration/depth_body.h"
#include "lib/surface/surface.h"

namespace gouge {
namespace {

constexpr double kBand = 2;  // lists reach to this many depths below the surface
constexpr int kBrick = 8;    // cells along a side
constexpr std::size_t kChunk = 8;
constexpr std::size_t kMaxGathered = 64, kMaxListed = 12;
constexpr int kHalvings = 2;        // of a cell
constexpr std::size_t kLevels = 7;  // four of cubes of cells, two of halved cells, one to spare

struct Distant {
  double mm = 0;
  std::uint32_t slot = 0;
  Vec3 way = Vec3::Zero();  ///< unit, from the foot; zero at it
};

/// The lists of some bricks.
struct NearFacetsPart {
  struct Cell {
    std::uint32_t index, list;  ///< list: slot in lists
  };
  std::vector<Cell> cells;
  std::vector<std::uint32_t> lists;
};

double box_distance2(const float* box, const Vec3& p) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double out = std::max({static_cast<double>(box[i]) - p[i], p[i] - static_cast<double>(box[i + 3]), 0.0});
    sum += out * out;
  }
  return sum;
}

/// Appends the slots of the facets within `radius_mm` of a point; false, and not all of them, when there are
/// more than `most`.
bool facets_within(const DepthBody& body, const Vec3& point, double radius_mm, std::size_t most,
                   std::vector<std::uint32_t>& slots) {
  const double radius2 = radius_mm * radius_mm;
  const std::size_t before = slots.size();
  std::vector<std::uint32_t> open(body.tree.nodes.empty() ? 0 : 1, 0);
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    open.pop_back();
    if (box_distance2(body.boxes.data() + 6 * std::size_t{index}, point) > radius2) continue;
    const KdopNode& node = body.tree.nodes[index];
    for (std::uint32_t k = 0; k < node.children; ++k) open.push_back(node.first + k);
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k) {
      if (closest_on_triangle(point, body.corners[node.first + k]).distance2_mm2 > radius2) continue;
      slots.push_back(node.first + k);
      if (slots.size() - before > most) return false;
    }
  }
  return true;
}

/// Lists of the cells of one brick after another: cubes of cells are halved down to cells, and each hands
/// those facets on that may be nearest somewhere in it.
class BrickFacets {
 public:
  /// `slot_of`: by triangle.
  BrickFacets(const DepthBody& body, const std::vector<std::uint32_t>& slot_of, double within_mm)
      : body_(body),
        slot_of_(slot_of),
        grid_(body.depths),
        within_mm_(within_mm),
        rounding_mm_(kRounding * static_cast<double>(body.slack_mm)) {}

  void add_brick(const DepthGrid::Cell& low, NearFacetsPart& part) {
    part_ = &part;
    add_cube(low, kBrick, nullptr, 0);
  }

 private:
  // In units of the body's slack, which is four roundings of single precision: far above those of doubles.
  static constexpr double kRounding = 1e-3;
  using Slots = std::vector<std::uint32_t>;

  static double diagonal(double half_mm) { return std::sqrt(3.0) * half_mm; }

  /// `among`: the facets that may be nearest; null where they were too many.
  void add_cube(const DepthGrid::Cell& low, int cells, const Slots* among, std::size_t level) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (low[i] >= grid_.counts()[i]) return;
    }
    if (cells == 1 && grid_.result(grid_.index(low)) == DepthGrid::Cover::outside) return;
    const double half_mm = 0.5 * cells * grid_.cell_mm();
    const Vec3 centre = grid_.corner(low) + Vec3::Constant(half_mm);
    std::optional<ClosestPoint> foot;
    if (among == nullptr) {
      foot = body_.surface.closest_point(centre, within_mm_ + diagonal(half_mm));
      if (!foot) return;
      gathered_.clear();
      const double reach = foot->distance_mm + 2 * diagonal(half_mm) + rounding_mm_;
      if (facets_within(body_, centre, reach, kMaxGathered, gathered_)) among = &gathered_;
    }
    Slots& here = here_[level];
    if (among != nullptr) {
      const double nearest_mm = prune(centre, half_mm, *among, here, level);
      if (nearest_mm > within_mm_ + diagonal(half_mm)) return;
    }
    if (cells == 1) {
      if (among == nullptr) return add_list(low, {slot_of_[foot->triangle]}, 0);
      return add_cell(low, centre, half_mm, here, level);
    }
    const int n = cells / 2;
    for (int k = 0; k < 8; ++k)
      add_cube({low[0] + (k & 1) * n, low[1] + (k >> 1 & 1) * n, low[2] + (k >> 2) * n}, n,
               among != nullptr ? &here : nullptr, level + 1);
  }

  void add_cell(const DepthGrid::Cell& cell, const Vec3& centre, double half_mm, const Slots& among,
                std::size_t level) {
    kept_.clear();
    keep(centre, half_mm, among, level, kHalvings);
    order_.clear();
    for (const std::uint32_t slot : kept_)
      order_.emplace_back(closest_on_triangle(centre, body_.corners[slot]).distance2_mm2, slot);
    std::sort(order_.begin(), order_.end());
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = order_[i].second;
    if (kept_.size() > kMaxListed) return add_list(cell, {kept_[0]}, 0);
    add_list(cell, kept_, NearFacets::kIsComplete);
  }

  /// Neighbours often have the same list; it is kept once.
  void add_list(const DepthGrid::Cell& cell, const Slots& slots, std::uint32_t flag) {
    const auto count = static_cast<std::uint32_t>(slots.size()) | flag;
    Slots& lists = part_->lists;
    const auto same = [&](std::size_t at) {
      return lists[at] == count &&
             std::equal(slots.begin(), slots.end(), lists.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    };
    if (part_->cells.empty() || !same(part_->cells.back().list)) {
      part_->cells.push_back({static_cast<std::uint32_t>(grid_.index(cell)), static_cast<std::uint32_t>(lists.size())});
      lists.push_back(count);
      lists.insert(lists.end(), slots.begin(), slots.end());
      return;
    }
    part_->cells.push_back({static_cast<std::uint32_t>(grid_.index(cell)), part_->cells.back().list});
  }

  /// How much nearer than `nearest` facet `d` can become on a path of length `h` from the centre. Distances to a
  /// convex set are convex, and their slope turns by no more than one over the distance.
  static double gain_within(double h, const Distant& d, const Distant& nearest) {
    const double plain = 2 * h;
    if (!(nearest.mm > 1.5 * h)) return plain;
    return std::min(plain, h * (d.way - nearest.way).norm() + h * h / (2 * (nearest.mm - h)));
  }

  /// Selects those of `among` that may be nearest in the cube; returns the distance of the one nearest to its centre.
  double prune(const Vec3& centre, double half_mm, const Slots& among, Slots& here, std::size_t level) {
    std::vector<Distant>& distances = distances_[level];
    distances.clear();
    here.clear();
    Distant nearest;
    nearest.mm = std::numeric_limits<double>::infinity();
    for (const std::uint32_t slot : among) {
      const Vec3 way = centre - closest_on_triangle(centre, body_.corners[slot]).point;
      const double mm = way.norm();
      distances.push_back({mm, slot, mm > 0 ? Vec3(way / mm) : Vec3(Vec3::Zero())});
      if (mm < nearest.mm) nearest = distances.back();
    }
    const double h = diagonal(half_mm);
    for (const Distant& d : distances) {
      if (d.mm - nearest.mm <= gain_within(h, d, nearest) + rounding_mm_) here.push_back(d.slot);
    }
    return nearest.mm;
  }

  /// Adds to kept_ the facets that may be nearest in the cube, halved `halvings` times more.
  void keep(const Vec3& centre, double half_mm, const Slots& among, std::size_t level, int halvings) {
    const bool is_news = std::any_of(among.begin(), among.end(), [this](std::uint32_t slot) {
      return std::find(kept_.begin(), kept_.end(), slot) == kept_.end();
    });
    if (!is_news) return;
    if (among.size() == 1 || halvings == 0) {
      for (const std::uint32_t slot : among) {
        if (std::find(kept_.begin(), kept_.end(), slot) == kept_.end()) kept_.push_back(slot);
      }
      return;
    }
    const double quarter = 0.5 * half_mm;
    Slots& here = here_[level + 1];
    for (int k = 0; k < 8; ++k) {
      const Vec3 to((k & 1) != 0 ? quarter : -quarter, (k & 2) != 0 ? quarter : -quarter,
                    (k & 4) != 0 ? quarter : -quarter);
      const Vec3 middle = centre + to;
      prune(middle, quarter, among, here, level + 1);
      keep(middle, quarter, here, level + 1, halvings - 1);
    }
  }

  const DepthBody& body_;
  const std::vector<std::uint32_t>& slot_of_;
  const DepthGrid& grid_;
  double within_mm_, rounding_mm_;
  NearFacetsPart* part_ = nullptr;
  Slots gathered_, kept_;
  std::vector<std::pair<double, std::uint32_t>> order_;
  std::array<std::vector<Distant>, kLevels> distances_;
  std::array<Slots, kLevels> here_;
};

}  // namespace

NearFacets::NearFacets(const DepthBody& body) {
  const DepthGrid& grid = body.depths;
  std::vector<DepthGrid::Cell> bricks;
  for (int z = 0; z < grid.counts()[2]; z += kBrick) {
    for (int y = 0; y < grid.counts()[1]; y += kBrick) {
      for (int x = 0; x < grid.counts()[0]; x += kBrick) bricks.push_back({x, y, z});
    }
  }
  std::vector<std::uint32_t> slot_of(body.tree.order.size());
  for (std::uint32_t slot = 0; slot < slot_of.size(); ++slot) slot_of[body.tree.order[slot]] = slot;
  std::vector<NearFacetsPart> parts((bricks.size() + kChunk - 1) / kChunk);
  for_each_chunk(bricks.size(), kChunk, 0, [&](std::size_t first, std::size_t last) {
    BrickFacets facets(body, slot_of, kBand * body.options.depth_mm);
    for (std::size_t i = first; i < last; ++i) facets.add_brick(bricks[i], parts[first / kChunk]);
  });
  first_.assign(grid.cell_count() + 1, 0);
  lists_.push_back(0);
  for (const NearFacetsPart& part : parts) {
    const auto base = static_cast<std::uint32_t>(lists_.size());
    for (const NearFacetsPart::Cell& cell : part.cells) first_[cell.index] = base + cell.list;
    lists_.insert(lists_.end(), part.lists.begin(), part.lists.end());
  }
  number_facets(body);
}

/// In the order of the bricks, so that what is requested together lies together.
void NearFacets::number_facets(const DepthBody& body) {
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> facet_at(body.corners.size(), kNone);
  for (std::size_t at = 1; at < lists_.size();) {
    const std::size_t end = at + 1 + (lists_[at] & ~kIsComplete);
    for (++at; at < end; ++at) {
      const std::uint32_t slot = lists_[at];
      if (facet_at[slot] == kNone) {
        facet_at[slot] = static_cast<std::uint32_t>(slots_.size());
        slots_.push_back(slot);
        planes_.push_back(facet_planes(body.corners[slot], body.surface.face_normal(body.tree.order[slot])));
      }
      lists_[at] = facet_at[slot];
    }
  }
}

}  // namespace gouge
