#include "lib/check/check_move.h"

#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "lib/check/search.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

class MoveChecker {
 public:
  MoveChecker(const Motion& motion, MoveKind kind, const ToolForms& tool, const PreparedScene& scene,
              const CheckOptions& options)
      : motion_(motion), kind_(kind), tool_(tool), scene_(scene), options_(options) {}

  MoveVerdict run() {
    const SearchAnswer depth = ask(whole(), 0, options_.tolerance_mm);
    set_depth(depth, whole());
    const bool is_deep = depth.value_mm > options_.tolerance_mm;
    if (is_deep) {
      verdict_.state = MoveState::gouge;
    } else if (!tool_.with_clearance.elements.empty()) {
      check_clearances(depth);
    }
    if (!is_decided_ && verdict_.state != MoveState::gouge) give_up();
    if (!is_decided_ && verdict_.state == MoveState::gouge) verdict_.reason = out_of_budget();
    if (verdict_.state == MoveState::clean && options_.near_miss_mm > 0) check_near_miss();
    return verdict_;
  }

  [[nodiscard]] std::uint64_t bounds() const { return bounds_; }

 private:
  using Targets = std::vector<SearchTarget>;

  [[nodiscard]] Targets whole() const {
    return {{&tool_.against_part, &scene_.parts, Against::part},
            {&tool_.against_fixture, &scene_.fixtures, Against::fixture}};
  }

  SearchAnswer ask(const Targets& targets, double reach, double tolerance) {
    const double gap = options_.gouge_gap_mm > 0 ? options_.gouge_gap_mm : options_.resolution_mm;
    const SearchAnswer answer = search_move(
        motion_, targets, {reach, tolerance, options_.resolution_mm, gap, options_.budget_per_move});
    bounds_ += answer.bounds;
    is_decided_ = is_decided_ && answer.is_decided;
    return answer;
  }

  void set_depth(const SearchAnswer& answer, const Targets& targets) {
    verdict_.depth_mm = 0;
    verdict_.depth_upper_mm = answer.value_upper_mm;
    verdict_.witness.reset();
    if (!answer.has_witness) return;
    const SearchTarget& target = targets[answer.target];
    const Place place = place_of(answer);
    const ToolAnswer at = evaluate(*target.tool, place.r, place.z);
    if (!(at.signed_distance_mm < 0)) return;
    verdict_.depth_mm = -at.signed_distance_mm;
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, verdict_.depth_mm);
    verdict_.witness = witness(answer, target, place, at);
  }

  /// A surface point as the pose sees it.
  struct Place {
    Pose pose;
    Vec3 out;  ///< from the tool axis to the point, unit
    double r = 0, z = 0;
  };

  // By the pose as anyone would compute it from the file, so that the evidence can be checked by hand.
  [[nodiscard]] Place place_of(const SearchAnswer& answer) const {
    Place place;
    place.pose = motion_.at(answer.t);
    const Vec3 from_tip = answer.point - place.pose.tip;
    place.z = from_tip.dot(place.pose.axis);
    const Vec3 across = from_tip - place.z * place.pose.axis;
    place.r = across.norm();
    place.out = place.r > 0 ? Vec3(across / place.r) : place.pose.axis.unitOrthogonal();
    return place;
  }

  static Witness witness(const SearchAnswer& answer, const SearchTarget& target, const Place& place,
                         const ToolAnswer& at) {
    const SurfaceTriangle& triangle = target.tree->triangles[answer.triangle];
    Witness result;
    result.t = answer.t;
    result.point = answer.point;
    result.normal = -(at.normal.x() * place.out + at.normal.y() * place.pose.axis).normalized();
    result.body = target.tool->elements[at.element].body;
    result.against = target.against;
    result.mesh = triangle.mesh;
    result.triangle = triangle.file_triangle;
    return result;
  }

  // Any depth in a body with a clearance is a gouge, so the whole depth is then wanted to the resolution.
  void check_clearances(const SearchAnswer& depth) {
    const Targets grown{{&tool_.with_clearance, &scene_.parts, Against::part},
                        {&tool_.with_clearance, &scene_.fixtures, Against::fixture}};
    const SearchAnswer entered = ask(grown, 0, 0);
    if (!entered.has_witness) return;
    const bool is_closed = depth.value_upper_mm - depth.value_mm <= options_.resolution_mm;
    const SearchAnswer closed = is_closed ? depth : ask(whole(), 0, 0);
    set_depth(closed, whole());
    verdict_.state = MoveState::gouge;
    show_clearance(entered, grown[entered.target]);
  }

  // The body that must keep its clearance is better evidence than a cutter's lawful contact, as long as it
  // realises the depth.
  void show_clearance(const SearchAnswer& entered, const SearchTarget& target) {
    const Place place = place_of(entered);
    const ToolAnswer at = evaluate(*target.tool, place.r, place.z);
    const SearchTarget all = whole()[entered.target];
    const double depth = -evaluate(*all.tool, place.r, place.z).signed_distance_mm;
    verdict_.reason = std::string("the clearance of the ") +
                      body_name(target.tool->elements[at.element].body) + " is entered by " +
                      exact_text(entered.value_mm) + " mm";
    if (!(depth > 0) || verdict_.depth_upper_mm - depth > options_.resolution_mm) return;
    verdict_.depth_mm = depth;
    verdict_.witness = witness(entered, target, place, at);
  }

  void give_up() {
    verdict_.state = MoveState::not_certified;
    verdict_.reason = out_of_budget();
  }

  [[nodiscard]] std::string out_of_budget() const {
    return "the budget of " + std::to_string(options_.budget_per_move) +
           " bounds ran out before the depth was known to the resolution";
  }

  // A cutter on a feed move is meant to touch the part; everything else is watched.
  void check_near_miss() {
    const bool is_cutting = kind_ != MoveKind::rapid;
    const Targets watched{
        {is_cutting ? &tool_.non_cutting : &tool_.against_part, &scene_.parts, Against::part},
        {&tool_.against_fixture, &scene_.fixtures, Against::fixture}};
    const SearchAnswer answer = ask(watched, options_.near_miss_mm, 0);
    if (!answer.has_witness) {
      if (!is_decided_) give_up();
      return;
    }
    verdict_.state = MoveState::near_miss;
    if (!is_decided_) verdict_.reason = out_of_budget();
    verdict_.clearance_mm = std::max(0.0, options_.near_miss_mm - answer.value_mm);
    if (verdict_.witness) return;
    const Place place = place_of(answer);
    const SearchTarget& target = watched[answer.target];
    verdict_.witness = witness(answer, target, place, evaluate(*target.tool, place.r, place.z));
  }

  const Motion& motion_;
  MoveKind kind_;
  const ToolForms& tool_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  MoveVerdict verdict_;
  bool is_decided_ = true;
  std::uint64_t bounds_ = 0;
};

}  // namespace

PreparedScene prepare_scene(const Scene& scene) {
  return {&scene, build_surface_tree(scene.parts), build_surface_tree(scene.fixtures)};
}

MoveVerdict check_move(const Motion& motion, MoveKind kind, const ToolForms& tool, const PreparedScene& scene,
                       const CheckOptions& options, std::uint64_t* bounds) {
  MoveChecker checker(motion, kind, tool, scene, options);
  const MoveVerdict verdict = checker.run();
  if (bounds != nullptr) *bounds += checker.bounds();
  return verdict;
}

}  // namespace gouge
