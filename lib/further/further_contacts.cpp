#include "lib/further/further_contacts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "lib/check/search_witness.h"
#include "lib/check/sweep_filter.h"
#include "lib/head/check_heads.h"
#include "lib/motion/motion_law.h"
#include "lib/tool/tilted_tools.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerChunk = 64;
constexpr std::array kToolBodies{Body::cutter, Body::shank, Body::holder};

/// A body alone, with the surfaces that it is compared with, and how deep they may be in it.
struct Pair {
  Body body = Body::cutter;
  SearchTarget target;
  double tolerance_mm = 0;
};

bool has_clearance(const ToolVariants& tool, Body body) {
  return std::ranges::any_of(tool.with_clearance.elements, [&](const BoundaryElement& e) { return e.body == body; });
}

/// Returns the pairs of one tool: each body with each obstacle, and with each mesh that has limits of its own.
std::vector<Pair> pairs_of(const ToolVariants& tool, const PreparedScene& scene, const CheckOptions& options) {
  std::vector<Pair> pairs;
  if (tool.alone == nullptr) return pairs;
  for (const Body body : kToolBodies) {
    const auto index = static_cast<std::size_t>(body);
    const auto form = [&](const ContactRule& rule) { return ((*tool.alone).*rule.alone)[index].get(); };
    if (tool.alone->bare[index]->elements.empty()) continue;
    const double tolerance_mm = has_clearance(tool, body) ? 0 : options.tolerance_mm;
    for (const PreparedObstacle& obstacle : scene.obstacles())
      pairs.push_back({body, target_on(*form(obstacle.rule), obstacle), tolerance_mm});
    for (const LimitedMesh& mesh : scene.limited_meshes()) {
      const CompiledTool& limited = mesh.limit.clearance_mm > 0 ? *tool.alone->bare[index] : *form(mesh.obstacle->rule);
      pairs.push_back({body, target_on(limited, mesh), std::min(mesh.limit.tolerance_mm, tolerance_mm)});
    }
  }
  return pairs;
}

/// The contacts of one move.
class Contacts {
 public:
  explicit Contacts(std::size_t move) : move_(move) {}

  /// Joins a contact with the other one of its body and obstacle, if there is one.
  void add(FurtherContact&& contact) {
    contact.move = move_;
    const auto same =
        std::ranges::find_if(all_, [&](const FurtherContact& one) { return one.is_of_same_pair(contact); });
    if (same == all_.end()) return all_.push_back(std::move(contact));
    const double upper_mm = std::max(same->depth_upper_mm, contact.depth_upper_mm);
    if (contact.depth_mm > same->depth_mm) *same = std::move(contact);
    same->depth_upper_mm = upper_mm;
  }

  /// Returns the contacts, the deepest first. The open ones are last.
  [[nodiscard]] std::vector<FurtherContact> sorted() && {
    std::ranges::stable_sort(all_, std::ranges::greater{}, &FurtherContact::depth_mm);
    return std::move(all_);
  }

 private:
  std::size_t move_;
  std::vector<FurtherContact> all_;
};

class FurtherSearch {
 public:
  FurtherSearch(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                const CheckOptions& options, const std::vector<HeadBody>& heads, const MoveVerdicts& verdicts)
      : toolpath_(toolpath), tools_(tools), scene_(scene), options_(options), verdicts_(verdicts) {
    if (heads.empty()) return;
    for (const PreparedObstacle& obstacle : scene.obstacles()) heads_.emplace_back(heads, scene, obstacle.rule.against);
  }

  /// Returns the contacts of moves, in their order.
  [[nodiscard]] std::vector<FurtherContact> find(std::span<const std::size_t> moves) const {
    std::vector<FurtherContact> found;
    while (!moves.empty()) {
      const std::size_t tool = toolpath_.moves[moves.front()].tool;
      const auto end = std::ranges::find_if(moves, [&](std::size_t i) { return toolpath_.moves[i].tool != tool; });
      const auto count = static_cast<std::size_t>(end - moves.begin());
      for (Contacts& contacts : find(*tools_[tool], moves.first(count)))
        std::ranges::move(std::move(contacts).sorted(), std::back_inserter(found));
      moves = moves.subspan(count);
    }
    return found;
  }

 private:
  [[nodiscard]] bool is_of_verdict(std::size_t move, Body body, Against against) const {
    const Witness& witness = *verdicts_[move].witness;
    return witness.body == body && witness.against == against;
  }

  /// Finds the contacts of moves with one tool.
  [[nodiscard]] std::vector<Contacts> find(const ToolVariants& tool, std::span<const std::size_t> moves) const {
    std::vector<Contacts> contacts(moves.begin(), moves.end());
    const std::vector<Pair> pairs = pairs_of(tool, scene_, options_);
    for (std::size_t k = 0; k < pairs.size(); ++k) search(tool, pairs, k, moves, contacts);
    for (std::size_t k = 0; k < heads_.size(); ++k) {
      const Against against = scene_.obstacles()[k].rule.against;
      for (std::size_t m = 0; m < moves.size(); ++m)
        if (!is_of_verdict(moves[m], Body::head, against)) search_heads(heads_[k], against, moves[m], contacts[m]);
    }
    return contacts;
  }

  [[nodiscard]] SearchQuery query_of(const Pair& pair) const {
    return {{pair.tolerance_mm, options_.resolution_mm, options_.resolution_mm, options_.budget_per_move}, 0};
  }

  /// Searches one pair, the k-th of the tool's pairs, in all moves whose verdict is of another one.
  void search(const ToolVariants& tool, const std::vector<Pair>& pairs, std::size_t k,
              std::span<const std::size_t> moves, std::vector<Contacts>& contacts) const {
    const Pair& pair = pairs[k];
    std::vector<Motion> motions;
    std::vector<std::size_t> of;
    std::vector<bool> is_bounded;
    for (std::size_t m = 0; m < moves.size(); ++m) {
      if (is_of_verdict(moves[m], pair.body, pair.target.against)) continue;
      const Motion motion = options_.law.of(toolpath_, moves[m]);
      if (motion.is_any() && is_clear_at_any_turn(motion, tool, k)) continue;
      const auto add = [&](Motion&& one) {
        motions.push_back(std::move(one));
        of.push_back(m);
        is_bounded.push_back(!motion.is_any());
      };
      add(motion.alone());
      if (auto other = motion.other()) add(*std::move(other));
    }
    if (motions.empty()) return;
    const std::vector<SearchTarget> targets{pair.target};
    const SearchQuery query = query_of(pair);
    const std::vector<SweptMove> swept = sweep_moves(motions, targets, query);
    for (std::size_t m = 0; m < motions.size(); ++m) {
      const SearchResult found = search_move(motions[m], targets, query, swept[m].start);
      if (auto contact = contact_of(pair, motions[m], found, is_bounded[m])) contacts[of[m]].add(*std::move(contact));
    }
  }

  /// Returns whether the k-th pair is proved clear for every turn of the joints that the law admits. The body is swept
  /// over all tilts of the move.
  [[nodiscard]] bool is_clear_at_any_turn(const Motion& motion, const ToolVariants& tool, std::size_t k) const {
    const std::optional<std::size_t> level = level_of_tilt(motion.axis_path()->spread({0, 0}, {1, 1}).axis_rad);
    const ToolVariants* const swept = level && tool.tilted ? tool.tilted->at(*level) : nullptr;
    if (swept == nullptr || swept->alone == nullptr) return false;
    const std::vector<Pair> pairs = pairs_of(*swept, scene_, options_);
    if (k >= pairs.size()) return false;
    const SearchResult found = sweep_and_search(motion.at_rest({0.5, 0.5}), {pairs[k].target}, query_of(pairs[k]));
    return found.value_upper_mm <= pairs[k].tolerance_mm + options_.resolution_mm;
  }

  /// Returns the contact of a result. None: the body is proved to keep its limit, up to the resolution.
  [[nodiscard]] std::optional<FurtherContact> contact_of(const Pair& pair, const Motion& motion,
                                                         const SearchResult& found, bool is_bounded) const {
    FurtherContact contact;
    contact.body = pair.body;
    contact.against = pair.target.against;
    contact.depth_upper_mm = is_bounded ? found.value_upper_mm : std::numeric_limits<double>::infinity();
    if (found.has_witness) {
      const ToolPoint point = locate(motion, found);
      const ToolDistance at = evaluate(*pair.target.tool, point.r, point.z);
      const double depth_mm = pair.target.reach_mm - at.signed_distance_mm;
      if (depth_mm > pair.tolerance_mm) {
        contact.depth_mm = depth_mm;
        contact.depth_upper_mm = std::max(contact.depth_upper_mm, depth_mm);
        contact.witness = make_witness(motion, found, pair.target, point, at);
        return contact;
      }
    }
    if (contact.depth_upper_mm > pair.tolerance_mm + options_.resolution_mm) return contact;
    return std::nullopt;
  }

  void search_heads(const HeadChecker& checker, Against against, std::size_t move, Contacts& contacts) const {
    MoveVerdict verdict;
    std::vector<double> uppers_mm;
    checker.sweep(options_.law.of(toolpath_, move), options_, verdict, uppers_mm);
    if (verdict.state == MoveState::clean) return;
    FurtherContact contact;
    contact.body = Body::head;
    contact.against = against;
    contact.depth_upper_mm = verdict.depth_upper_mm;
    if (verdict.state == MoveState::gouge) {
      contact.depth_mm = verdict.depth_mm;
      contact.witness = verdict.witness.optional();
    }
    contacts.add(std::move(contact));
  }

  const Toolpath& toolpath_;
  const std::vector<const ToolVariants*>& tools_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  const MoveVerdicts& verdicts_;
  std::vector<HeadChecker> heads_;  // one for each obstacle; empty: there are no heads
};

}  // namespace

void find_further_contacts(const Toolpath& toolpath, const std::vector<const ToolVariants*>& tools,
                           const PreparedScene& scene, const CheckOptions& options, const std::vector<HeadBody>& heads,
                           CheckResult& result, const ProgressCall& progress) {
  PagedVector<std::size_t> moves;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const MoveVerdict& verdict = result.verdicts[i];
    if (verdict.state == MoveState::gouge && verdict.witness && !verdict.is_in_stock()) moves.push_back(i);
  }
  result.further.clear();
  if (moves.empty()) return;
  const FurtherSearch search(toolpath, tools, scene, options, heads, result.verdicts);
  std::vector<std::vector<FurtherContact>> found((moves.size() + kMovesPerChunk - 1) / kMovesPerChunk);
  for_each_chunk(moves.size(), kMovesPerChunk, options.threads, "looking for further contacts", progress,
                 [&](std::size_t first, std::size_t last) {
                   found[first / kMovesPerChunk] = search.find({moves.data() + first, last - first});
                 });
  for (std::vector<FurtherContact>& some : found) std::ranges::move(some, std::back_inserter(result.further));
}

}  // namespace gouge
