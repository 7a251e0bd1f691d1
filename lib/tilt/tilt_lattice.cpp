#include "lib/tilt/tilt_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "lib/base/parallel.h"
#include "lib/tilt/cheapest_choice.h"

namespace gouge {
namespace {

constexpr std::size_t kFirstLayers = 64;  // of a long run
constexpr int kCoarseSteps = 6;           // of a lattice from no tilt to the largest one
constexpr int kLevels = 3;                // each with half the step
constexpr int kFinerPerStep = 4;          // about the way found
constexpr double kTube = 1.5;             // how many steps of it the finer lattice reaches about the way
constexpr int kMostRounds = 60;           // in which layers are added, ...
constexpr int kMostStrikes = 24;  // ... or motions struck out: what refuses these refuses most of their neighbours

/// One lattice over the allowed tilts, and what is known of it at each position.
///
/// Which of its tilts are free is found out lazily too: the cheapest way is sought as if all were, then the tilts it
/// takes are looked at, and it is sought again without those that are refused. The way that is left is the cheapest of
/// all, as no other way lost a tilt that is free.
class Lattice {
 public:
  /// `near`: null, or the sequence that tilts may be no farther from than `reach_rad`. `refusing`: what other lattices
  /// learned at each position.
  Lattice(const TiltSpace& space, int steps, unsigned threads, std::vector<RefusingPoints>& refusing,
          const TiltSequence* near, double reach_rad)
      : space_(space),
        threads_(threads),
        refusing_(refusing),
        near_(near),
        reach_rad_(reach_rad),
        first_at_once_(near != nullptr ? 1 : static_cast<std::size_t>(steps / kCoarseSteps * (steps / kCoarseSteps))),
        proofs_(space) {
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
    choices_ = static_cast<Node>(nodes_.size());
    is_layer_.assign(space.size(), false);
    for (std::size_t i = 0; i + 1 < space.size(); ++i) changes_rad_.push_back(space.largest_change_rad(i));
  }

  /// `doubtful`: a position where no tilt may be free, of which all are looked at first.
  LatticeResult find(std::optional<std::size_t> doubtful) {
    if (doubtful) {
      add_layer(*doubtful);
      if (!look_at_all(layers_.front())) return {std::nullopt, doubtful};
    }
    add_first_layers();
    for (int round = 0, strikes = 0; round < kMostRounds && strikes < kMostStrikes; ++round) {
      const std::size_t struck_before = struck_.size();
      const std::optional<Choice> choice = cheapest_free();
      if (!choice) return {std::nullopt, first_blocked()};
      const TiltSequence sequence = between_layers(*choice);
      if (prove(sequence, *choice)) return {sequence, std::nullopt};
      strikes += struck_.size() > struck_before ? 1 : 0;
    }
    return {std::nullopt, std::nullopt};
  }

 private:
  using Node = std::uint32_t;
  using Choice = std::vector<Node>;  ///< a tilt of each layer

  struct Struck {
    std::size_t from, to;
    Node node, next;
    auto operator<=>(const Struck&) const = default;
  };

  /// A position, and what is known of the lattice's tilts there.
  struct Layer {
    std::size_t position = 0;
    std::vector<Node> open;     ///< that were not refused; the smallest tilts first
    std::vector<bool> is_free;  ///< of each open one, whether that is known
    std::size_t at_once = 1;    ///< how many more to look at where the one that was taken is refused

    void refuse(const std::vector<Node>& refused) {
      std::size_t kept = 0;
      for (std::size_t k = 0; k < open.size(); ++k) {
        if (std::ranges::find(refused, open[k]) != refused.end()) continue;
        open[kept] = open[k];
        is_free[kept++] = is_free[k];
      }
      open.resize(kept);
      is_free.resize(kept);
    }
  };

  /// Both ends, those that are fixed, and some between.
  void add_first_layers() {
    const std::size_t last = space_.size() - 1, pieces = std::min(kFirstLayers, last);
    for (std::size_t k = 0; k <= pieces && pieces > 0; ++k) add_layer(k * last / pieces);
    add_layer(0);
    for (std::size_t i = 0; i < space_.size(); ++i) {
      if (space_[i].is_fixed()) add_layer(i);
    }
  }

  void add_layer(std::size_t i) {
    if (is_layer_[i]) return;
    is_layer_[i] = true;
    Layer layer;
    layer.position = i;
    layer.at_once = first_at_once_;
    if (const auto& given = space_[i].given) {
      layer.open = {node_of(*given)};
    } else {
      for (Node n = 0; n < choices_; ++n) {
        if (near_ == nullptr || !((nodes_[n] - (*near_)[i]).norm() > reach_rad_)) layer.open.push_back(n);
      }
    }
    layer.is_free.assign(layer.open.size(), space_[i].stays_programmed());
    layers_.insert(std::ranges::upper_bound(layers_, i, {}, &Layer::position), std::move(layer));
  }

  /// Of a tilt that need not be one of the lattice's.
  [[nodiscard]] Node node_of(const Tilt& tilt) {
    const auto known = std::ranges::find_if(nodes_, [&](const Tilt& node) { return node == tilt; });
    const auto node = static_cast<Node>(known - nodes_.begin());
    if (known == nodes_.end()) nodes_.push_back(tilt);
    return node;
  }

  /// Whether any tilt is free there.
  [[nodiscard]] bool look_at_all(Layer& layer) {
    std::vector<Node> refused;
    for (std::size_t k = 0; k < layer.open.size(); ++k) {
      layer.is_free[k] =
          layer.is_free[k] || space_.is_free(layer.position, nodes_[layer.open[k]], &refusing_[layer.position]);
      if (!layer.is_free[k]) refused.push_back(layer.open[k]);
    }
    layer.refuse(refused);
    return !layer.open.empty();
  }

  /// Whether the tilt that was taken is free. Where it is not, others about it are looked at too, twice as many each
  /// time: what refuses it refuses many, and a position where none is free is soon known.
  [[nodiscard]] bool is_free(Layer& layer, Node taken) {
    const auto index = static_cast<std::size_t>(std::ranges::find(layer.open, taken) - layer.open.begin());
    if (layer.is_free[index]) return true;
    layer.is_free[index] = space_.is_free(layer.position, nodes_[taken], &refusing_[layer.position]);
    if (layer.is_free[index]) return true;
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < layer.open.size(); ++k) {
      if (!layer.is_free[k] && k != index) others.push_back(k);
    }
    std::ranges::stable_sort(others, {},
                             [&](std::size_t k) { return (nodes_[layer.open[k]] - nodes_[taken]).squaredNorm(); });
    others.resize(std::min(others.size(), layer.at_once));
    layer.at_once *= 2;
    std::vector<Node> refused = {taken};
    for (const std::size_t k : others) {
      layer.is_free[k] = space_.is_free(layer.position, nodes_[layer.open[k]], &refusing_[layer.position]);
      if (!layer.is_free[k]) refused.push_back(layer.open[k]);
    }
    layer.refuse(refused);
    return false;
  }

  [[nodiscard]] std::optional<std::size_t> first_blocked() const {
    const auto blocked = std::ranges::find_if(layers_, [](const Layer& layer) { return layer.open.empty(); });
    return blocked == layers_.end() ? std::nullopt : std::optional(blocked->position);
  }

  /// The cheapest way through the layers that is free in each of them.
  [[nodiscard]] std::optional<Choice> cheapest_free() {
    for (;;) {
      const std::optional<Choice> choice = cheapest();
      if (!choice) return std::nullopt;
      std::vector<char> is_refused(layers_.size(), 0);
      for_each_chunk(layers_.size(), 1, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t l = first; l < last; ++l) is_refused[l] = is_free(layers_[l], (*choice)[l]) ? 0 : 1;
      });
      if (std::ranges::find(is_refused, 1) == is_refused.end()) return choice;
      if (first_blocked()) return std::nullopt;
    }
  }

  /// The cheapest way through the layers by tilts that were not refused.
  [[nodiscard]] std::optional<Choice> cheapest() const {
    std::vector<TiltLayer> layers;
    for (const Layer& layer : layers_) {
      TiltLayer& next = layers.emplace_back();
      next.way_mm = space_[layer.position].way_mm;
      for (const Node node : layer.open) next.tilts.push_back(nodes_[node]);
    }
    for (std::size_t l = 0; l + 1 < layers_.size(); ++l) {
      const std::size_t i = layers_[l].position, k = layers_[l + 1].position;
      layers[l].largest_change_rad = 0;
      for (std::size_t j = i; j < k; ++j) layers[l].largest_change_rad += changes_rad_[j];
      for (auto it = struck_.lower_bound({i, k, 0, 0}); it != struck_.end() && it->from == i && it->to == k; ++it) {
        const auto from = std::ranges::find(layers_[l].open, it->node);
        const auto to = std::ranges::find(layers_[l + 1].open, it->next);
        if (from == layers_[l].open.end() || to == layers_[l + 1].open.end()) continue;
        layers[l].struck.emplace_back(from - layers_[l].open.begin(), to - layers_[l + 1].open.begin());
      }
      std::ranges::sort(layers[l].struck);
    }
    std::optional<Choice> choice = cheapest_choice(layers, space_.task().options.blend_mm);
    for (std::size_t l = 0; choice && l < choice->size(); ++l) (*choice)[l] = layers_[l].open[(*choice)[l]];
    return choice;
  }

  [[nodiscard]] TiltSequence between_layers(const Choice& choice) const {
    TiltSequence sequence(space_.size(), nodes_[choice.front()]);
    for (std::size_t l = 1; l < layers_.size(); ++l) {
      const std::size_t i = layers_[l - 1].position, k = layers_[l].position;
      const double begin = space_[i].way_mm, way = std::max(space_[k].way_mm - begin, kLeastWay_mm);
      const Tilt &from = nodes_[choice[l - 1]], &to = nodes_[choice[l]];
      for (std::size_t j = i + 1; j < k; ++j)
        sequence[j] = from + std::min((space_[j].way_mm - begin) / way, 1.0) * (to - from);
      sequence[k] = to;
    }
    return sequence;
  }

  /// Whether the sequence is free everywhere. Where not, layers are added or a change between two is struck out.
  [[nodiscard]] bool prove(const TiltSequence& sequence, const Choice& choice) {
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
    std::vector<std::size_t> added;
    bool is_proved = true;
    for (std::size_t l = 1; l < layers_.size(); ++l) {
      const std::size_t first = layers_[l - 1].position, last = layers_[l].position;
      std::size_t bad = first;
      while (bad < last && is_refused[bad] == 0) ++bad;
      if (bad == last) continue;
      is_proved = false;
      if (last == first + 1) {
        struck_.insert({first, last, choice[l - 1], choice[l]});
      } else {
        added.push_back(std::clamp(is_refused[bad] == kPosition ? bad : (first + last) / 2, first + 1, last - 1));
      }
    }
    for (const std::size_t i : added) add_layer(i);
    return is_proved;
  }

  const TiltSpace& space_;
  unsigned threads_;
  std::vector<RefusingPoints>& refusing_;  // at each position
  const TiltSequence* near_;
  double reach_rad_;
  std::size_t first_at_once_;        // as many as lie about a tilt where a coarser lattice has one
  std::vector<Tilt> nodes_;          // of the lattice, the smallest first; then those that are given
  Node choices_ = 0;                 // how many are of the lattice
  std::vector<double> changes_rad_;  // the largest from each position to the next
  std::vector<bool> is_layer_;
  std::vector<Layer> layers_;  // in the order of the way
  std::set<Struck> struck_;
  TiltProofs proofs_;
};

}  // namespace

LatticeResult find_tilts(const TiltSpace& space, unsigned threads, std::optional<std::size_t> doubtful) {
  LatticeResult found;
  std::vector<RefusingPoints> refusing(space.size());
  for (int level = 0, steps = kCoarseSteps; level < kLevels; ++level, steps *= 2) {
    found = Lattice(space, steps, threads, refusing, nullptr, 0).find(doubtful);
    if (found.blocked) doubtful = found.blocked;
    if (!found.sequence) continue;
    const double reach_rad = kTube * space.task().options.max_tilt_rad / steps;
    LatticeResult finer =
        Lattice(space, kFinerPerStep * steps, threads, refusing, &*found.sequence, reach_rad).find(std::nullopt);
    if (finer.sequence) found = std::move(finer);
    break;
  }
  return found;
}

}  // namespace gouge
