#include "lib/tilt/tilt_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "lib/base/parallel.h"

namespace gouge {
namespace {

constexpr std::size_t kFirstLayers = 64;  // of a long run
constexpr std::size_t kAtATime = 8;       // layers looked at before the next is decided on
constexpr int kCoarseSteps = 6;           // of a lattice from no tilt to the largest one
constexpr int kLevels = 3;                // each with half the step
constexpr int kFinerPerStep = 4;          // about the way found
constexpr double kTube = 1.5;             // how many steps of it the finer lattice reaches about the way
constexpr int kMostRounds = 60;           // in which layers are added, ...
constexpr int kMostStrikes = 12;       // ... or motions struck out: what refuses these refuses most of their neighbours
constexpr double kLeastWay_mm = 1e-3;  // positions that are closer count as so far apart

/// One lattice over the allowed tilts, and what is known of it at each position.
class Lattice {
 public:
  /// `near`: null, or the sequence that tilts may be no farther from than `reach_rad`.
  Lattice(const TiltSpace& space, int steps, unsigned threads, const TiltSequence* near, double reach_rad)
      : space_(space), threads_(threads), near_(near), reach_rad_(reach_rad), proofs_(space) {
    const TiltOptions& options = space.task().options;
    // A little inwards, where the largest tilts are still within their margin.
    const double step_rad = options.max_tilt_rad / steps * 0.999;
    const int across = options.freedom == TiltFreedom::both ? steps : 0;
    for (int x = -steps; x <= steps; ++x) {
      for (int y = -across; y <= across; ++y) {
        const Tilt tilt = step_rad * Tilt(x, y);
        if (tilt.norm() <= options.max_tilt_rad)
          nodes_.push_back(options.freedom == TiltFreedom::side ? Tilt(tilt.y(), tilt.x()) : tilt);
      }
    }
    std::ranges::stable_sort(nodes_, {}, [](const Tilt& tilt) { return tilt.squaredNorm(); });
    free_.resize(space.size());
    is_layer_.assign(space.size(), false);
  }

  /// `doubtful`: a position where no tilt may be free, which is looked at first.
  LatticeResult find(std::optional<std::size_t> doubtful) {
    if (doubtful) add_layer(*doubtful);
    if (const auto blocked = look_at_new_layers()) return {std::nullopt, blocked};
    add_first_layers();
    for (int round = 0, strikes = 0; round < kMostRounds && strikes < kMostStrikes; ++round) {
      const std::size_t struck_before = struck_.size();
      if (const auto blocked = look_at_new_layers()) return {std::nullopt, blocked};
      const std::optional<TiltSequence> sequence = cheapest();
      if (!sequence) return {std::nullopt, std::nullopt};
      if (prove(*sequence)) return {sequence, std::nullopt};
      strikes += struck_.size() > struck_before ? 1 : 0;
    }
    return {std::nullopt, std::nullopt};
  }

 private:
  using Node = std::uint32_t;
  struct Struck {
    std::size_t from, to;
    Node node, next;
    auto operator<=>(const Struck&) const = default;
  };

  /// Both ends, the middle, and so on between: a position where nothing is free is met soon.
  void add_first_layers() {
    const std::size_t last = space_.size() - 1;
    add_layer(0);
    add_layer(last);
    for (std::size_t i = 0; i < space_.size(); ++i) {
      if (space_[i].is_fixed) add_layer(i);
    }
    std::size_t pieces = 1;
    while (pieces < kFirstLayers && pieces < space_.size()) pieces *= 2;
    for (std::size_t step = pieces; step > 1; step /= 2) {
      for (std::size_t k = step / 2; k < pieces; k += step) add_layer(k * last / pieces);
    }
  }

  void add_layer(std::size_t i) {
    if (is_layer_[i]) return;
    is_layer_[i] = true;
    new_layers_.push_back(i);
  }

  /// A layer where nothing is free ends it.
  [[nodiscard]] std::optional<std::size_t> look_at_new_layers() {
    std::vector<std::size_t> left = std::move(new_layers_);
    new_layers_.clear();
    for (std::size_t begin = 0; begin < left.size(); begin += kAtATime) {
      const std::size_t end = std::min(begin + kAtATime, left.size());
      for_each_chunk(end - begin, 1, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) look_at(left[begin + k]);
      });
      for (std::size_t k = begin; k < end; ++k) {
        if (free_[left[k]].empty()) return left[k];
        layers_.push_back(left[k]);
      }
    }
    std::ranges::sort(layers_);
    return std::nullopt;
  }

  void look_at(std::size_t i) {
    const bool is_fixed = space_[i].is_fixed;
    RefusingPoints refusing;
    for (Node n = 0; n < nodes_.size() && (!is_fixed || n == 0); ++n) {
      if (near_ != nullptr && (nodes_[n] - (*near_)[i]).norm() > reach_rad_) continue;
      if (is_fixed || space_.is_free(i, nodes_[n], &refusing)) free_[i].push_back(n);
    }
  }

  [[nodiscard]] double way_mm(std::size_t i, std::size_t k) const {
    return std::max(space_[k].way_mm - space_[i].way_mm, kLeastWay_mm);
  }

  [[nodiscard]] double cost(std::size_t i, const Tilt& from, std::size_t k, const Tilt& to) const {
    const double way = way_mm(i, k), blend = std::max(space_.task().options.blend_mm, kLeastWay_mm);
    return 0.5 * way * (from.squaredNorm() + to.squaredNorm()) / (blend * blend) + (to - from).squaredNorm() / way;
  }

  [[nodiscard]] std::optional<TiltSequence> cheapest() {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<double> so_far(free_[layers_.front()].size(), 0);
    std::vector<std::vector<std::uint32_t>> came_from(layers_.size());
    for (std::size_t l = 1; l < layers_.size(); ++l) {
      const std::size_t i = layers_[l - 1], k = layers_[l];
      const std::vector<Node>&from = free_[i], &to = free_[k];
      std::vector<double> best(to.size(), kNever);
      came_from[l].assign(to.size(), 0);
      for (std::uint32_t b = 0; b < to.size(); ++b) {
        for (std::uint32_t a = 0; a < from.size(); ++a) {
          const double total = so_far[a] + cost(i, nodes_[from[a]], k, nodes_[to[b]]);
          if (!(total < best[b])) continue;
          if (!struck_.empty() && struck_.contains({i, k, from[a], to[b]})) continue;
          best[b] = total;
          came_from[l][b] = a;
        }
      }
      so_far = std::move(best);
    }
    const auto cheapest = std::ranges::min_element(so_far);
    if (cheapest == so_far.end() || !(*cheapest < kNever)) return std::nullopt;
    auto at = static_cast<std::uint32_t>(cheapest - so_far.begin());
    std::vector<Node> chosen(layers_.size());
    for (std::size_t l = layers_.size(); l-- > 0;) {
      chosen[l] = free_[layers_[l]][at];
      if (l > 0) at = came_from[l][at];
    }
    last_chosen_ = chosen;
    return between_layers(chosen);
  }

  [[nodiscard]] TiltSequence between_layers(const std::vector<Node>& chosen) const {
    TiltSequence sequence(space_.size(), nodes_[chosen.front()]);
    for (std::size_t l = 1; l < layers_.size(); ++l) {
      const std::size_t i = layers_[l - 1], k = layers_[l];
      const Tilt &from = nodes_[chosen[l - 1]], &to = nodes_[chosen[l]];
      for (std::size_t j = i + 1; j < k; ++j) {
        const double share = (space_[j].way_mm - space_[i].way_mm) / way_mm(i, k);
        sequence[j] = from + std::min(share, 1.0) * (to - from);
      }
      sequence[k] = to;
    }
    return sequence;
  }

  /// Whether the sequence is free everywhere. Where not, layers are added or a change between two is struck out.
  [[nodiscard]] bool prove(const TiltSequence& sequence) {
    constexpr char kPosition = 1, kMotion = 2;  // what is refused: the position, or the motion from it to the next
    std::vector<char> is_refused(space_.size(), 0);
    for_each_chunk(space_.size(), 8, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (!is_layer_[i] && !proofs_.is_free(i, sequence[i])) {
          is_refused[i] = kPosition;
        } else if (i + 1 < space_.size() && !proofs_.is_free_after(i, sequence[i], sequence[i + 1])) {
          is_refused[i] = kMotion;
        }
      }
    });
    bool is_proved = true;
    for (std::size_t l = 1; l < layers_.size(); ++l) {
      const std::size_t first = layers_[l - 1], last = layers_[l];
      std::size_t bad = first;
      while (bad < last && is_refused[bad] == 0) ++bad;
      if (bad == last) continue;
      is_proved = false;
      if (last == first + 1) {
        struck_.insert({first, last, last_chosen_[l - 1], last_chosen_[l]});
      } else {
        add_layer(std::clamp(is_refused[bad] == kPosition ? bad : (first + last) / 2, first + 1, last - 1));
      }
    }
    return is_proved;
  }

  const TiltSpace& space_;
  unsigned threads_;
  const TiltSequence* near_;
  double reach_rad_;
  std::vector<Tilt> nodes_;              // the smallest first
  std::vector<std::vector<Node>> free_;  // of each layer
  std::vector<bool> is_layer_;
  std::vector<std::size_t> layers_, new_layers_;
  std::set<Struck> struck_;
  TiltProofs proofs_;
  std::vector<Node> last_chosen_;
};

}  // namespace

LatticeResult find_tilts(const TiltSpace& space, unsigned threads, std::optional<std::size_t> doubtful) {
  LatticeResult found;
  for (int level = 0, steps = kCoarseSteps; level < kLevels; ++level, steps *= 2) {
    found = Lattice(space, steps, threads, nullptr, 0).find(doubtful);
    // Where no way leads between, positions closer to each other help more than more tilts.
    if (!found.sequence && !found.blocked) break;
    if (found.blocked) doubtful = found.blocked;
    if (!found.sequence) continue;
    const double reach_rad = kTube * space.task().options.max_tilt_rad / steps;
    LatticeResult finer =
        Lattice(space, kFinerPerStep * steps, threads, &*found.sequence, reach_rad).find(std::nullopt);
    if (finer.sequence) found = std::move(finer);
    break;
  }
  return found;
}

}  // namespace gouge
