#include "toolmodels/bsp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "toolmodels/convex_cell.h"
#include "toolmodels/voronoi.h"

namespace gouge {
namespace {

using detail::CellSides;
using detail::Comparison;
using detail::ConvexCell;
using detail::DirectedLine;
using detail::DistanceForm;
using Element = std::uint32_t;

// A cell of the subdivision, with the elements that may be nearest somewhere in it. For each domain line and each
// element it has the side on which the cell lies (0: on both sides, or unknown).
struct Region {
  ConvexCell cell;
  std::vector<Element> candidates;
  std::vector<int> line_side;
  std::vector<int> element_side;
};

enum class CutKind { domain_line, element_line, element_circle, bisector };

struct Cut {
  CutKind kind = CutKind::domain_line;
  DirectedLine line;
  BspNode node;
  std::size_t index = 0;          // number of the domain line or of the element
  Element first = 0, second = 0;  // the elements of the bisector
};

class Builder {
 public:
  explicit Builder(const std::vector<BoundaryElement>& elements)
      : elements_(elements), domains_(detail::make_domains(elements)) {
    for (const BoundaryElement& e : elements) {
      forms_.push_back(detail::signed_form(e));
      low_ = low_.cwiseMin(e.a.cwiseMin(e.b));
      high_ = high_.cwiseMax(e.a.cwiseMax(e.b));
    }
    size_ = std::max({high_.x(), std::abs(low_.y()), std::abs(high_.y())});
    const double margin = 0.25 * (high_ - low_).maxCoeff();
    low_.y() -= margin;
    high_ += Vec2(margin, margin);
  }

  std::vector<BspNode> build() {
    Region all{ConvexCell(size_), {}, std::vector<int>(domains_.lines.size()), std::vector<int>(elements_.size())};
    for (Element e = 0; e < elements_.size(); ++e) {
      all.candidates.push_back(e);
      if (elements_[e].kind == ElementKind::vertex) all.element_side[e] = elements_[e].is_reflex ? -1 : 1;
    }
    reduce(all);
    descend(all);
    return is_too_large() ? std::vector<BspNode>{} : std::move(nodes_);
  }

 private:
  // ---- facts known about a region

  void learn_sides(Region& region) const {
    for (const Element e : region.candidates) {
      for (const detail::DomainBound& bound : domains_.bounds[e]) {
        int& side = region.line_side[bound.line];
        if (side == 0) side = one_side(region.cell.sides(domains_.lines[bound.line]));
      }
      int& side = region.element_side[e];
      if (side == 0) side = element_side(e, region.cell);
    }
  }

  static int one_side(const CellSides& sides) {
    if (sides.has_negative && sides.has_positive) return 0;
    return sides.has_negative ? -1 : 1;
  }

  int element_side(Element e, const ConvexCell& cell) const {
    const DistanceForm& form = forms_[e];
    if (form.is_linear) return one_side(cell.sides({form.through, form.direction}));
    DistanceForm zero;  // the linear form 0 + 0
    zero.direction = Vec2::Zero();
    if (detail::is_everywhere_below(form, zero, cell)) return -1;
    return detail::is_everywhere_below(zero, form, cell) ? 1 : 0;
  }

  bool is_outside_domain(Element e, const Region& region) const {
    return std::any_of(domains_.bounds[e].begin(), domains_.bounds[e].end(),
                       [&](const detail::DomainBound& b) { return region.line_side[b.line] == -b.sign; });
  }

  bool is_inside_domain(Element e, const Region& region) const {
    return std::all_of(domains_.bounds[e].begin(), domains_.bounds[e].end(),
                       [&](const detail::DomainBound& b) { return region.line_side[b.line] == b.sign; });
  }

  // Returns whether |distance of a| <= |distance of b| all over the region. Requires a to be valid there.
  bool dominates(Element a, Element b, const Region& region) const {
    const std::size_t corners = region.cell.corners().size();
    work_ += forms_[a].is_linear && forms_[b].is_linear ? corners : corners * corners;
    const auto is_below = [&](const DistanceForm& f) {
      const int side = region.element_side[b];
      return (side >= 0 && detail::is_everywhere_below(f, forms_[b], region.cell)) ||
             (side <= 0 && detail::is_everywhere_below(f, forms_[b].negated(), region.cell));
    };
    const int side = region.element_side[a];
    if (side >= 0 && !is_below(forms_[a])) return false;
    return side > 0 || is_below(forms_[a].negated());
  }

  // Drops every candidate that cannot be nearest anywhere in the region.
  void reduce(Region& region) const {
    learn_sides(region);
    std::vector<Element> kept;
    for (const Element e : region.candidates)
      if (!is_outside_domain(e, region)) kept.push_back(e);
    if (kept.empty()) kept.push_back(nearest_in(region));  // a sliver between two shared lines leaves no candidate
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (!is_inside_domain(kept[i], region)) continue;
      const Element strong = kept[i];
      const auto is_beaten = [&](Element e) { return e != strong && dominates(strong, e, region); };
      std::erase_if(kept, is_beaten);
      i = static_cast<std::size_t>(std::find(kept.begin(), kept.end(), strong) - kept.begin());
    }
    region.candidates = std::move(kept);
    while (drop_decided(region)) {
    }
  }

  // Drops one candidate of a pair whose bisector misses the region. Returns whether there was such a pair.
  bool drop_decided(Region& region) const {
    for (const Element a : region.candidates)
      for (const Element b : region.candidates) {
        if (a >= b || !is_comparable(a, region) || !is_comparable(b, region)) continue;
        const Comparison::Kind kind = compare(unsigned_form(a, region), unsigned_form(b, region), region.cell).kind;
        if (kind != Comparison::Kind::first_nearer && kind != Comparison::Kind::second_nearer) continue;
        std::erase(region.candidates, kind == Comparison::Kind::first_nearer ? b : a);
        return true;
      }
    return false;
  }

  Element nearest_in(const Region& region) const {
    const Vec2 point = region.cell.samples().front();
    const auto distance = [&](Element e) {
      const DistanceForm& f = forms_[e];
      return f.is_linear ? std::abs(f.direction.dot(point - f.through))
                         : std::abs(f.sign * (point - f.center).norm() + f.shift);
    };
    return *std::min_element(region.candidates.begin(), region.candidates.end(),
                             [&](Element a, Element b) { return distance(a) < distance(b); });
  }

  // ---- cuts

  std::vector<Cut> find_cuts(const Region& region) const {
    std::vector<Cut> cuts;
    std::vector<std::size_t> seen;
    for (const Element e : region.candidates) {
      for (const detail::DomainBound& b : domains_.bounds[e]) {
        if (region.line_side[b.line] != 0 || std::find(seen.begin(), seen.end(), b.line) != seen.end()) continue;
        seen.push_back(b.line);
        const DirectedLine& line = domains_.lines[b.line];
        cuts.push_back({CutKind::domain_line, line, detail::straight_node(line), b.line, 0, 0});
      }
      if (region.element_side[e] == 0) cuts.push_back(element_cut(e));
    }
    if (cuts.empty() || region.candidates.size() <= kFewCandidates) add_bisectors(region, cuts);
    return cuts;
  }

  Cut element_cut(Element e) const {
    Cut cut;
    cut.index = e;
    const DistanceForm& f = forms_[e];
    if (f.is_linear) {
      cut.kind = CutKind::element_line;
      cut.line = {f.through, f.direction};
      cut.node = detail::straight_node(cut.line);
      return cut;
    }
    cut.kind = CutKind::element_circle;
    cut.node.origin = f.center;
    cut.node.v0 = f.shift;
    cut.node.square = -f.sign;
    cut.node.round = f.sign;
    return cut;
  }

  bool is_comparable(Element e, const Region& region) const {
    return region.element_side[e] != 0 && is_inside_domain(e, region);
  }

  DistanceForm unsigned_form(Element e, const Region& region) const {
    return region.element_side[e] > 0 ? forms_[e] : forms_[e].negated();
  }

  void add_bisectors(const Region& region, std::vector<Cut>& cuts) const {
    for (std::size_t i = 0; i < region.candidates.size(); ++i)
      for (std::size_t j = i + 1; j < region.candidates.size(); ++j) {
        const Element a = region.candidates[i], b = region.candidates[j];
        if (!is_comparable(a, region) || !is_comparable(b, region)) continue;
        const Comparison c = compare(unsigned_form(a, region), unsigned_form(b, region), region.cell);
        Cut cut{CutKind::bisector, c.line, c.curve, 0, a, b};
        if (c.kind == Comparison::Kind::split_first)
          cut = {CutKind::domain_line, c.line, detail::straight_node(c.line), kNoLine, a, b};
        else if (c.kind == Comparison::Kind::curve && !c.is_straight)
          cut.index = kNoLine;
        cuts.push_back(cut);
      }
  }

  // Returns the part of the region on one side of a cut, with its candidates reduced.
  Region part(const Region& region, const Cut& cut, int sign) const {
    Region child = region;
    const bool is_line = cut.kind != CutKind::element_circle && cut.index != kNoLine;
    if (is_line || cut.kind == CutKind::domain_line) {
      if (cut.line.direction.squaredNorm() > 0) child.cell = region.cell.clipped(cut.line, sign);
    }
    if (cut.kind == CutKind::domain_line && cut.index != kNoLine) child.line_side[cut.index] = sign;
    if (cut.kind == CutKind::element_line || cut.kind == CutKind::element_circle) child.element_side[cut.index] = sign;
    if (cut.kind == CutKind::bisector) std::erase(child.candidates, sign < 0 ? cut.second : cut.first);
    if (cut.kind == CutKind::element_circle) clip_by_circle(child, cut.index, sign);
    reduce(child);
    return child;
  }

  // Clips the cell to a square around the disc if it lies within the circle. Otherwise, within the arc's domain, clips
  // it to the outer side of the chord.
  void clip_by_circle(Region& child, std::size_t element, int sign) const {
    const BoundaryElement& e = elements_[element];
    const bool is_within = (sign < 0) != e.is_reflex;
    if (is_within) {
      for (const Vec2& u : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
        child.cell = child.cell.clipped({e.center + e.radius_mm * u, u}, -1);
    } else if (is_inside_domain(static_cast<Element>(element), child)) {
      const Vec2 chord = (e.b - e.a).normalized();
      const double turn = e.is_reflex ? -1 : 1;
      child.cell = child.cell.clipped({e.a, turn * Vec2(chord.y(), -chord.x())}, 1);
    }
  }

  // Estimates the cost of the tree below a region, up to a common factor. The estimate is the share of points that come
  // here times their number of steps.
  double cost(const Region& region) const {
    if (region.candidates.size() <= 1) return 0;
    const double all = (high_ - low_).prod();
    const double weight = region.cell.corners().size() < 3 ? 0 : region.cell.area_within(low_, high_) / all;
    return (weight + 0.02) * (1 + 1.5 * std::log2(static_cast<double>(region.candidates.size())));
  }

  // ---- recursion

  [[nodiscard]] bool is_too_large() const {
    return nodes_.size() > kMaxBspNodes * elements_.size() || work_ > kMaxWork;
  }

  std::int32_t descend(const Region& region) {
    if (region.candidates.size() == 1 || is_too_large()) return ~static_cast<std::int32_t>(region.candidates.front());
    const std::vector<Cut> cuts = find_cuts(region);
    std::optional<Region> negative, positive;
    const Cut* best = nullptr;
    double best_cost = std::numeric_limits<double>::infinity();
    for (const Cut& cut : cuts) {
      Region n = part(region, cut, -1);
      Region p = part(region, cut, 1);
      const double here = cost(n) + cost(p);
      if (here >= best_cost) continue;
      best_cost = here;
      best = &cut;
      negative = std::move(n);
      positive = std::move(p);
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back(best->node);
    const std::int32_t below = descend(*negative);
    const std::int32_t above = descend(*positive);
    nodes_[index].negative = below;
    nodes_[index].positive = above;
    return static_cast<std::int32_t>(index);
  }

  static constexpr std::size_t kFewCandidates = 5;  // with more candidates, straight cuts are better
  static constexpr std::size_t kMaxWork =
      2'000'000;  // corners examined: three times what the largest of 240 random tools takes
  static constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);

  const std::vector<BoundaryElement>& elements_;
  detail::Domains domains_;
  std::vector<DistanceForm> forms_;
  std::vector<BspNode> nodes_;
  Vec2 low_ = Vec2::Zero(), high_ = Vec2::Zero();
  double size_ = 0;
  mutable std::size_t work_ = 0;
};

}  // namespace

std::vector<BspNode> build_bsp(const std::vector<BoundaryElement>& elements) {
  const bool has_tree = elements.size() > 1 && elements.size() <= kMaxBspElements;
  return has_tree ? Builder(elements).build() : std::vector<BspNode>{};
}

std::size_t bsp_depth(const std::vector<BspNode>& nodes) {
  // Children are stored behind their parents, so one pass from the back computes all depths.
  std::vector<std::size_t> below(nodes.size(), 1);
  for (std::size_t i = nodes.size(); i-- > 0;)
    for (const std::int32_t child : {nodes[i].negative, nodes[i].positive})
      if (child >= 0) below[i] = std::max(below[i], 1 + below[static_cast<std::size_t>(child)]);
  return nodes.empty() ? 0 : below[0];
}

}  // namespace gouge
