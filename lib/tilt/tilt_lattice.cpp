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

constexpr std::size_t kFirstLayers = 64;  // number of first layers of a long run
constexpr int kCoarseSteps = 6;           // steps of the coarsest lattice from no tilt to the largest one
constexpr int kLevels = 4;                // number of lattices, each with half the step of the one before
constexpr int kFinestSteps = kCoarseSteps << (kLevels - 1);
constexpr int kFinerPerStep = 4;       // steps of the finer lattice near a found sequence, for each step
constexpr double kTube = 1.5;          // distance from the found sequence, in steps, that the finer lattice covers
constexpr int kMaxUncertain = 3;       // number of layers that are searched for any free tilt after no sequence is left
constexpr std::size_t kMaxOthers = 4;  // number of examined neighbours of a refused tilt that no known point refuses
constexpr int kMaxRounds = 60;         // maximum number of rounds in which layers are added, ...
constexpr int kMaxStrikes = 24;        // ... or motions are excluded; an obstacle to these usually blocks most of their
                                       // neighbours too

/// One lattice over the allowed tilts, and the known tilts at each position.
///
/// Free tilts, too, are found lazily. First the cheapest sequence is found as if all tilts were free. Then its tilts
/// are examined. The search repeats without the refused ones. The remaining sequence is the cheapest of all, because no
/// other sequence lost a free tilt. Tilts that no sequence can use any more are not examined.
class Lattice {
 public:
  /// `near` is null, or a sequence: then every tilt is within `reach_rad` of it. `known` has the results of other
  /// lattices at each position.
  Lattice(const TiltSpace& space, int steps, unsigned threads, std::vector<KnownTilts>& known, const TiltSequence* near,
          double reach_rad)
      : space_(space),
        threads_(threads),
        known_(known),
        near_(near),
        reach_rad_(reach_rad),
        first_at_once_(near != nullptr ? 1 : static_cast<std::size_t>(steps / kCoarseSteps * (steps / kCoarseSteps))),
        proofs_(space) {
    const TiltOptions& options = space.task().options;
    const double step_rad = space.largest_tilt_rad() / steps;
    const int across = options.freedom == TiltFreedom::both ? steps : 0;
    for (int x = -steps; x <= steps; ++x) {
      for (int y = -across; y <= across; ++y) {
        const Tilt tilt = step_rad * Tilt(x, y);
        if (tilt.norm() > options.max_tilt_rad) continue;
        nodes_.push_back(options.freedom == TiltFreedom::side ? Tilt(tilt.y(), tilt.x()) : tilt);
        finest_.push_back(index_among_finest(x, y, steps));
      }
    }
    choices_ = static_cast<Node>(nodes_.size());
    is_layer_.assign(space.size(), false);
    for (std::size_t i = 0; i + 1 < space.size(); ++i) changes_rad_.push_back(space.largest_change_rad(i));
  }

  /// Searches a sequence. At the position `doubtful` possibly no tilt is free; all its tilts are examined first. The
  /// positions `needed` are layers from the start, because a coarser lattice needed them. On return `needed` has the
  /// layers of this lattice.
  LatticeResult find(std::optional<std::size_t> doubtful, std::vector<std::size_t>& needed) {
    if (doubtful) {
      add_layer(*doubtful);
      if (!has_free(layers_.front())) return {std::nullopt, doubtful, std::nullopt};
    }
    add_first_layers();
    for (const std::size_t i : needed) add_layer(i);
    const LatticeResult result = search();
    needed.clear();
    for (const Layer& layer : layers_) needed.push_back(layer.position);
    return result;
  }

 private:
  LatticeResult search() {
    for (int round = 0, strikes = 0; round < kMaxRounds && strikes < kMaxStrikes; ++round) {
      const std::size_t struck_before = struck_.size();
      const std::optional<Choice> choice = cheapest_free();
      if (!choice) return {std::nullopt, blocked(), std::nullopt};
      const TiltSequence sequence = between_layers(*choice);
      if (prove(sequence, *choice)) return {sequence, std::nullopt, std::nullopt};
      strikes += struck_.size() > struck_before ? 1 : 0;
    }
    return {std::nullopt, std::nullopt, std::nullopt};
  }

  using Node = std::uint32_t;
  using Choice = std::vector<Node>;  ///< one tilt in each layer

  struct Struck {
    std::size_t from, to;
    Node node, next;
    auto operator<=>(const Struck&) const = default;
  };

  /// A position, and the known tilts of the lattice there.
  struct Layer {
    std::size_t position = 0;
    std::vector<Node> open;     ///< not refused, and possibly part of a sequence; by columns
    std::vector<char> is_free;  ///< for each entry of `open`: whether it is known to be free
    std::vector<Node> aside;    ///< not refused, but not part of any sequence
    std::size_t at_once = 1;    ///< number of further tilts to examine if the chosen one is refused

    template <typename IsKept>
    void keep(const IsKept& is_kept) {
      std::size_t kept = 0;
      for (std::size_t k = 0; k < open.size(); ++k) {
        if (!is_kept(k)) continue;
        open[kept] = open[k];
        is_free[kept++] = is_free[k];
      }
      open.resize(kept);
      is_free.resize(kept);
    }
  };

  /// Returns the index that a tilt of a lattice with `steps` steps has in the finest lattice; kNone: it is not part of
  /// that lattice.
  [[nodiscard]] static std::size_t index_among_finest(int x, int y, int steps) {
    if (kFinestSteps % steps != 0) return kNone;
    const int row = x * (kFinestSteps / steps) + kFinestSteps, column = y * (kFinestSteps / steps) + kFinestSteps;
    return static_cast<std::size_t>(row * (2 * kFinestSteps + 1) + column);
  }

  /// Adds both ends, all fixed positions and some positions in between.
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
      bool is_raised = false;
      for (Node n = 0; n < choices_; ++n) {
        const bool is_near = near_ == nullptr || !((nodes_[n] - (*near_)[i]).norm() > reach_rad_);
        if (is_near && !stays_refused(i, n, is_raised)) layer.open.push_back(n);
      }
    }
    for (const Node n : layer.open)
      layer.is_free.push_back(space_[i].stays_programmed() || state_of(i, n) == KnownTilts::kFree ? 1 : 0);
    layers_.insert(std::ranges::upper_bound(layers_, i, {}, &Layer::position), std::move(layer));
  }

  /// Returns the node of a tilt. Adds the tilt if the lattice does not have it.
  [[nodiscard]] Node node_of(const Tilt& tilt) {
    const auto known = std::ranges::find_if(nodes_, [&](const Tilt& node) { return node == tilt; });
    const auto node = static_cast<Node>(known - nodes_.begin());
    if (known == nodes_.end()) nodes_.push_back(tilt);
    return node;
  }

  [[nodiscard]] KnownTilts::State state_in(const std::vector<KnownTilts::State>& states, Node node) const {
    return states.empty() || node >= choices_ || finest_[node] == kNone ? KnownTilts::kUnknown : states[finest_[node]];
  }
  [[nodiscard]] KnownTilts::State state_of(std::size_t position, Node node) const {
    return state_in(known_[position].states, node);
  }

  /// Returns whether a tilt that was refused before stays refused now that the tip may rise. It does if the tip does
  /// not or cannot rise. Sets `is_raised` if the tip rises at this tilt. Once it is set, the function only returns
  /// known results.
  [[nodiscard]] bool stays_refused(std::size_t position, Node node, bool& is_raised) {
    const KnownTilts::State state = state_of(position, node);
    KnownTilts& known = known_[position];
    if (state != KnownTilts::kUnknown || is_raised) return state == KnownTilts::kRefused;
    if (state_in(known.unraised, node) != KnownTilts::kRefused) return false;
    const std::optional<double> raise_mm = space_.is_refused_by(known.refusing, position, nodes_[node])
                                               ? std::nullopt
                                               : space_.raise_mm(position, nodes_[node], &known.refusing);
    is_raised = raise_mm && *raise_mm > 0;
    if (!is_raised) keep(position, node, false);
    return !is_raised;
  }

  void keep(std::size_t position, Node node, bool is_free) {
    if (node >= choices_ || finest_[node] == kNone) return;
    std::vector<KnownTilts::State>& states = known_[position].states;
    states.resize((2 * kFinestSteps + 1) * (2 * kFinestSteps + 1), KnownTilts::kUnknown);
    states[finest_[node]] = is_free ? KnownTilts::kFree : KnownTilts::kRefused;
  }

  /// Returns whether a tilt is free, and stores the result.
  [[nodiscard]] bool look(std::size_t position, Node node) {
    KnownTilts& known = known_[position];
    const bool was_free = state_in(known.unraised, node) == KnownTilts::kFree;
    const bool is_same = was_free && space_.raise_mm(position, nodes_[node]) == 0.0;
    const bool is_free = is_same || space_.is_free(position, nodes_[node], &known.refusing);
    keep(position, node, is_free);
    return is_free;
  }

  /// Returns whether any tilt is free there, even one that no sequence uses.
  [[nodiscard]] bool has_free(Layer& layer) {
    if (std::ranges::find(layer.is_free, 1) != layer.is_free.end()) return true;
    for (std::size_t k = 0; k < layer.open.size(); ++k) {
      layer.is_free[k] = look(layer.position, layer.open[k]) ? 1 : 0;
      if (layer.is_free[k] == 0) continue;
      const auto first = static_cast<std::ptrdiff_t>(k);
      layer.open.erase(layer.open.begin(), layer.open.begin() + first);
      layer.is_free.erase(layer.is_free.begin(), layer.is_free.begin() + first);
      return true;
    }
    layer.open.clear();
    layer.is_free.clear();
    return std::ranges::any_of(layer.aside, [&](Node node) {
      const KnownTilts::State state = state_of(layer.position, node);
      return state == KnownTilts::kFree || (state == KnownTilts::kUnknown && look(layer.position, node));
    });
  }

  /// Returns whether the chosen tilt is free. If it is not free, neighbours are examined too, twice as many each time.
  /// An obstacle to one tilt is an obstacle to many, so a position without a free tilt is soon known.
  [[nodiscard]] bool is_free(Layer& layer, Node taken) {
    const auto index = static_cast<std::size_t>(std::ranges::find(layer.open, taken) - layer.open.begin());
    if (layer.is_free[index] != 0) return true;
    layer.is_free[index] = look(layer.position, taken) ? 1 : 0;
    if (layer.is_free[index] != 0) return true;
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < layer.open.size(); ++k) {
      if (layer.is_free[k] == 0 && k != index) others.push_back(k);
    }
    const auto away = [&](std::size_t k) { return (nodes_[layer.open[k]] - nodes_[taken]).squaredNorm(); };
    if (others.size() > layer.at_once) {
      std::ranges::stable_sort(others, {}, away);
      others.resize(layer.at_once);
    }
    layer.at_once *= 2;
    look_quickly_at(layer, others, index);
    return false;
  }

  /// Removes the tilt `refused`. Of the tilts `some`, removes those that known points refuse. Examines a few of the
  /// others and removes those that are refused.
  void look_quickly_at(Layer& layer, const std::vector<std::size_t>& some, std::size_t refused) {
    std::vector<char> is_refused(layer.open.size(), 0);
    is_refused[refused] = 1;
    std::size_t looks = 0;
    for (const std::size_t k : some) {
      const Node node = layer.open[k];
      if (space_.is_refused_by(known_[layer.position].refusing, layer.position, nodes_[node])) {
        keep(layer.position, node, false);
        is_refused[k] = 1;
      } else if (looks++ < kMaxOthers) {
        layer.is_free[k] = look(layer.position, node) ? 1 : 0;
        is_refused[k] = layer.is_free[k] == 0 ? 1 : 0;
      }
    }
    layer.keep([&](std::size_t k) { return is_refused[k] == 0; });
  }

  /// Examines all tilts that a sequence may use and keeps only the free ones.
  void look_at_rest(Layer& layer) {
    for (std::size_t k = 0; k < layer.open.size(); ++k) {
      if (layer.is_free[k] == 0) layer.is_free[k] = look(layer.position, layer.open[k]) ? 1 : 0;
    }
    layer.keep([&](std::size_t k) { return layer.is_free[k] != 0; });
  }

  /// Returns a position where no tilt is free. Only tests the positions with the fewest tilts left.
  [[nodiscard]] std::optional<std::size_t> blocked() {
    if (near_ != nullptr) return std::nullopt;
    std::vector<Layer*> uncertain;
    for (Layer& layer : layers_) uncertain.push_back(&layer);
    std::ranges::stable_sort(uncertain, {},
                             [](const Layer* layer) { return layer->open.size() + layer->aside.size(); });
    for (std::size_t k = 0; k < std::min<std::size_t>(kMaxUncertain, uncertain.size()); ++k) {
      if (!has_free(*uncertain[k])) return uncertain[k]->position;
    }
    return std::nullopt;
  }

  /// Returns the cheapest sequence through the layers that is free in each layer.
  [[nodiscard]] std::optional<Choice> cheapest_free() {
    for (;;) {
      const std::optional<Choice> choice = cheapest();
      if (!choice) return std::nullopt;
      std::vector<char> is_refused(layers_.size(), 0);
      for_each_chunk(layers_.size(), 1, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t l = first; l < last; ++l) is_refused[l] = is_free(layers_[l], (*choice)[l]) ? 0 : 1;
      });
      if (std::ranges::find(is_refused, 1) == is_refused.end()) return choice;
      Layer* narrowest = nullptr;
      for (std::size_t l = 0; l < layers_.size(); ++l) {
        const bool is_narrower = narrowest == nullptr || layers_[l].open.size() < narrowest->open.size();
        if (is_refused[l] != 0 && is_narrower) narrowest = &layers_[l];
      }
      look_at_rest(*narrowest);
      if (narrowest->open.empty()) return std::nullopt;
    }
  }

  /// Returns the cheapest sequence through the layers, without the refused tilts.
  [[nodiscard]] std::optional<Choice> cheapest() {
    std::vector<TiltLayer> layers;
    for (const Layer& layer : layers_) {
      TiltLayer& next = layers.emplace_back();
      next.arc_length_mm = space_[layer.position].arc_length_mm;
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
    const LayerChoices choices = cheapest_choice(layers, space_.task().options.blend_mm);
    if (!choices.cheapest) return std::nullopt;
    Choice choice = *choices.cheapest;
    for (std::size_t l = 0; l < choice.size(); ++l) {
      choice[l] = layers_[l].open[choice[l]];
      const std::vector<char>& is_possible = choices.is_possible[l];
      for (std::size_t k = 0; k < is_possible.size(); ++k) {
        if (is_possible[k] == 0) layers_[l].aside.push_back(layers_[l].open[k]);
      }
      layers_[l].keep([&](std::size_t k) { return is_possible[k] != 0; });
    }
    return choice;
  }

  [[nodiscard]] TiltSequence between_layers(const Choice& choice) const {
    TiltSequence sequence(space_.size(), nodes_[choice.front()]);
    for (std::size_t l = 1; l < layers_.size(); ++l) {
      const std::size_t i = layers_[l - 1].position, k = layers_[l].position;
      const double begin = space_[i].arc_length_mm, way = std::max(space_[k].arc_length_mm - begin, kMinWay_mm);
      const Tilt &from = nodes_[choice[l - 1]], &to = nodes_[choice[l]];
      for (std::size_t j = i + 1; j < k; ++j)
        sequence[j] = from + std::min((space_[j].arc_length_mm - begin) / way, 1.0) * (to - from);
      sequence[k] = to;
    }
    return sequence;
  }

  /// Returns whether the sequence is free everywhere. If it is not, adds layers or excludes a change between two tilts.
  [[nodiscard]] bool prove(const TiltSequence& sequence, const Choice& choice) {
    // For each stretch between two layers: the first position that is rejected, by itself or because of the motion from
    // it.
    std::vector<std::size_t> refused(layers_.size(), kNone);
    std::vector<char> is_motion(layers_.size(), 0);
    for_each_chunk(layers_.size() - 1, 1, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t l = first; l < last; ++l) {
        for (std::size_t i = layers_[l].position; i < layers_[l + 1].position && refused[l] == kNone; ++i) {
          is_motion[l] = is_layer_[i] || proofs_.is_free(i, sequence[i]) ? 1 : 0;
          if (is_motion[l] == 0 || !proofs_.is_free_after(i, sequence[i], sequence[i + 1])) refused[l] = i;
        }
      }
    });
    std::vector<std::size_t> added;
    bool is_proved = true;
    for (std::size_t l = 0; l + 1 < layers_.size(); ++l) {
      const std::size_t first = layers_[l].position, last = layers_[l + 1].position;
      if (refused[l] == kNone) continue;
      is_proved = false;
      if (last == first + 1) {
        struck_.insert({first, last, choice[l], choice[l + 1]});
      } else {
        added.push_back(std::clamp(is_motion[l] != 0 ? (first + last) / 2 : refused[l], first + 1, last - 1));
      }
    }
    for (const std::size_t i : added) add_layer(i);
    return is_proved;
  }

  const TiltSpace& space_;
  unsigned threads_;
  std::vector<KnownTilts>& known_;  // at each position
  const TiltSequence* near_;
  double reach_rad_;
  std::size_t first_at_once_;        // number of tilts of this lattice for each tilt of the coarsest one
  std::vector<Tilt> nodes_;          // first the tilts of the lattice, by columns; then the given tilts
  std::vector<std::size_t> finest_;  // index of each tilt in the finest lattice
  Node choices_ = 0;                 // number of the lattice's own tilts
  std::vector<double> changes_rad_;  // largest change from each position to the next
  std::vector<bool> is_layer_;
  std::vector<Layer> layers_;  // in the order of the path
  std::set<Struck> struck_;
  TiltProofs proofs_;
};

}  // namespace

LatticeResult find_tilts(const TiltSpace& space, unsigned threads, std::optional<std::size_t> doubtful,
                         std::vector<KnownTilts>& known) {
  LatticeResult found;
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (!space.holds_back(i)) continue;
    found.held_back = i;
    return found;
  }
  std::vector<std::size_t> needed;
  known.resize(space.size());
  for (KnownTilts& of_position : known) {
    if (!space.task().may_raise) continue;
    of_position.unraised = std::move(of_position.states);
    of_position.states.clear();
  }
  for (int level = 0, steps = kCoarseSteps; level < kLevels; ++level, steps *= 2) {
    // The finest lattice costs most. It finds a free tilt in a gap of the others, for a position without any other free
    // tilt.
    if (level + 1 == kLevels && (!found.blocked || space.task().may_raise)) break;
    found = Lattice(space, steps, threads, known, nullptr, 0).find(doubtful, needed);
    if (found.blocked) doubtful = found.blocked;
    if (!found.sequence) continue;
    const double reach_rad = kTube * space.task().options.max_tilt_rad / steps;
    std::vector<std::size_t> of_finer;
    LatticeResult finer =
        Lattice(space, kFinerPerStep * steps, threads, known, &*found.sequence, reach_rad).find(std::nullopt, of_finer);
    if (finer.sequence) found = std::move(finer);
    break;
  }
  return found;
}

}  // namespace gouge
