#include "lib/stock/check_stock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/stock/clear_groups.h"

namespace gouge {

namespace {

constexpr std::size_t kGroup = 256;
constexpr int kContactSteps = 16;

/// Moves of one group have the same tool and the same body in question.
struct Group {
  MoveRange range;
  bool is_whole = false;
};

/// A body of a group that must be clear of stock.
struct AskedBody {
  const CompiledTool& body;
  std::size_t head = kNone;  ///< index of the head of which `body` is the surroundings
};

/// Joins what two bodies of one move find. The deeper witness stays; both bounds hold for the other body too.
StockFinding joined(StockFinding one, StockFinding other) {
  const bool is_other_first = other.witness && (!one.witness || one.witness->depth_mm < other.witness->depth_mm);
  StockFinding& first = is_other_first ? other : one;
  const StockFinding& second = is_other_first ? one : other;
  first.depth_upper_mm = std::max(first.depth_upper_mm, second.depth_upper_mm);
  if (!first.unknown) first.unknown = second.unknown;
  if (!first.witness) return first;
  // A body that is open may have met stock at any time.
  first.contact.clear_until = second.witness ? std::min(first.contact.clear_until, second.contact.clear_until) : 0;
  if (second.witness) first.contact.contact_at = std::min(first.contact.contact_at, second.contact.contact_at);
  return first;
}

/// Enters the findings of one more body. Both are in path order.
void join(const std::vector<StockFinding>& more, std::vector<StockFinding>& found) {
  std::vector<StockFinding> all;
  auto at = found.begin();
  for (const StockFinding& finding : more) {
    while (at != found.end() && at->move < finding.move) all.push_back(*at++);
    const bool is_both = at != found.end() && at->move == finding.move;
    all.push_back(is_both ? joined(*at++, finding) : finding);
  }
  all.insert(all.end(), at, found.end());
  found = std::move(all);
}

class StockChecker {
 public:
  StockChecker(const CutHistory& history, const StockSolid& stock, const StockOptions& options)
      : history_(history), path_(history.path()), stock_(stock), options_(options) {
    is_examined_.reserve(path_.moves.size());
    for (std::size_t i = 0; i < path_.moves.size(); ++i) is_examined_.push_back(history.is_known(i));
  }

  StockResult run(unsigned threads, const ProgressCall& progress) {
    const std::vector<Group> groups = make_groups();
    std::vector<std::vector<StockFinding>> found(groups.size());
    for_each_chunk(groups.size(), 1, threads, "checking stock", progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t g = first; g < last; ++g) found[g] = check(groups[g]);
    });
    StockResult result;
    for (std::vector<StockFinding>& of_group : found)
      result.findings.insert(result.findings.end(), of_group.begin(), of_group.end());
    result.proved =
        static_cast<std::uint64_t>(std::count(is_examined_.begin(), is_examined_.end(), true)) - result.findings.size();
    result.is_examined = std::move(is_examined_);
    return result;
  }

 private:
  /// Returns whether the whole tool is examined. A position to which the file states no motion is reached as in a rapid.
  [[nodiscard]] bool is_whole(std::size_t i) const { return !history_.is_cutting(i); }

  [[nodiscard]] std::vector<Group> make_groups() const {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (!is_examined_[i]) continue;
      const bool continues = !groups.empty() && groups.back().range.last == i &&
                             i - groups.back().range.first < kGroup && groups.back().is_whole == is_whole(i) &&
                             path_.moves[i].tool == path_.moves[i - 1].tool;
      if (!continues) groups.push_back({{i, i}, is_whole(i)});
      groups.back().range.last = i + 1;
    }
    return groups;
  }

  [[nodiscard]] std::vector<StockFinding> check(const Group& group) const {
    const ToolVariants& tool = *history_.tool_of(group.range.first).tool;
    std::vector<StockFinding> found = check(group, {group.is_whole ? tool.bare : tool.non_cutting});
    for (std::size_t h = 0; h < history_.heads().size(); ++h)
      join(check(group, {history_.heads()[h].around(), h}), found);
    return found;
  }

  [[nodiscard]] std::vector<StockFinding> check(const Group& group, const AskedBody& asked) const {
    std::vector<StockFinding> found;
    if (asked.body.elements.empty()) return found;
    std::uint64_t left = options_.budget_per_group;
    const StockQuestion first = question(asked, group.range.first, options_.budget_per_move);
    StockHints hints;
    for (const OpenMove& open : moves_not_clear(first, group.range)) {
      const std::uint64_t budget = std::max(options_.least_budget, std::min(left, options_.budget_per_move));
      StockQuestion about = question(asked, open.move, budget);
      about.hints = &hints;
      const Motion motion = history_.motion_of(open.move);
      const bool is_turn_open =
          about.head != nullptr && !(has_known_turn(motion) && history_.departure_from(motion).is_none());
      if (is_turn_open) about.head = nullptr;
      const StockAnswer answer = find_stock(about, motion, open.pieces, 0, 1, options_.tolerance_mm);
      std::uint64_t examined = answer.examined;
      if (!answer.is_clear) {
        StockFinding finding;
        finding.move = open.move;
        finding.depth_upper_mm = asked.body.r_max_mm;
        finding.unknown = answer.unknown;
        if (asked.head != kNone) finding.body = Body::head;
        finding.head = asked.head;
        // A witness in the surroundings of a head is none where the turn of the head is not known.
        if (!is_turn_open) finding.witness = answer.witness;
        if (finding.witness) examined += explain(about, motion, open.pieces, finding);
        found.push_back(finding);
      }
      left -= std::min(left, examined);
    }
    return found;
  }

  [[nodiscard]] StockQuestion question(const AskedBody& asked, std::size_t move, std::uint64_t budget) const {
    const StockHead* const head = asked.head == kNone ? nullptr : &history_.heads()[asked.head];
    StockQuestion about{history_, stock_, options_, asked.body, move, budget, history_.is_cutting(move)};
    about.head = head;
    return about;
  }

  /// Asks with what is left of the budget for a bound, and takes off what that needed.
  static StockAnswer ask(const StockQuestion& about, const Motion& motion, const std::vector<ToolPiece>& pieces,
                         double from, double to, double depth_mm, std::uint64_t& budget) {
    StockQuestion limited = about;
    limited.budget = budget;
    const StockAnswer answer = find_stock(limited, motion, pieces, from, to, depth_mm);
    budget -= std::min(budget, answer.examined);
    return answer;
  }

  /// Completes a finding. Returns the number of examined pieces.
  std::uint64_t explain(const StockQuestion& about, const Motion& motion, const std::vector<ToolPiece>& pieces,
                        StockFinding& finding) const {
    StockQuestion limited = about;
    limited.budget = std::min(about.budget, options_.budget_per_bound);
    std::uint64_t left = limited.budget;
    finding.contact = first_contact(about, motion, pieces, finding.witness->t, left);
    const StockDepth deepest = find_depth(limited, motion, *finding.witness, finding.depth_upper_mm);
    finding.witness = deepest.witness;
    finding.depth_upper_mm = deepest.upper_mm;
    const StockWitness& witness = *finding.witness;
    finding.nearest_cut = history_.nearest_cut(witness.point, about.move, (stock_.high() - stock_.low()).norm());
    if (about.head != nullptr) return limited.budget - left + deepest.examined;
    finding.body = body_at(history_.tool_of(about.move).tool->bare, about.body, motion.at(witness.t), witness.point);
    if (!is_whole(about.move) && finding.body == Body::cutter) finding.body = Body::shank;
    return limited.budget - left + deepest.examined;
  }

  /// Halves the time before the witness until the instants are closer than the resolution along the path.
  [[nodiscard]] FirstContact first_contact(const StockQuestion& about, const Motion& motion,
                                           const std::vector<ToolPiece>& pieces, double t_witness,
                                           std::uint64_t& budget) const {
    FirstContact contact{0, t_witness};
    double length = 0;
    for (std::uint32_t s = 0; s < motion.segments().size(); ++s)
      length += motion.path_length_mm(motion.segments()[s].t0, motion.segments()[s].t1, s);
    length += motion.turn_rad() * std::max(about.body.z_max_mm, about.body.r_max_mm);
    for (int k = 0; k < kContactSteps && budget > 0; ++k) {
      if ((contact.contact_at - contact.clear_until) * length <= options_.resolution_mm) break;
      const double middle = 0.5 * (contact.clear_until + contact.contact_at);
      const StockAnswer until = ask(about, motion, pieces, contact.clear_until, middle, options_.tolerance_mm, budget);
      if (until.witness) {
        contact.contact_at = until.witness->t;
      } else if (until.is_clear) {
        contact.clear_until = middle;
      } else {
        break;
      }
    }
    return contact;
  }

  const CutHistory& history_;
  const Toolpath& path_;
  const StockSolid& stock_;
  const StockOptions& options_;
  std::vector<bool> is_examined_;
};

}  // namespace

StockResult check_stock(const CutHistory& history, const StockSolid& stock, const StockOptions& options,
                        unsigned threads, const ProgressCall& progress) {
  return StockChecker(history, stock, options).run(threads, progress);
}

}  // namespace gouge
