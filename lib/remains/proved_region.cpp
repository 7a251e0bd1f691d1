#include "lib/remains/proved_region.h"

#include <algorithm>
#include <limits>

#include "lib/remains/region_proof.h"

namespace gouge {

namespace {

constexpr std::size_t kCellChunk = 16;
constexpr unsigned kAll = 0xffU;

GridIndex around(const GridIndex& cell, std::int32_t x, std::int32_t y, std::int32_t z) {
  return {cell[0] + x, cell[1] + y, cell[2] + z};
}

/// Returns the corners of a face that are its diagonals, as bits of the cell's corners.
struct FaceDiagonals {
  unsigned first = 0, second = 0;
};
constexpr std::array<FaceDiagonals, 6> kFaces{{{0x41U, 0x14U},    // x = 0: 0, 6 and 2, 4
                                               {0x82U, 0x28U},    // x = 1: 1, 7 and 3, 5
                                               {0x21U, 0x12U},    // y = 0: 0, 5 and 1, 4
                                               {0x84U, 0x48U},    // y = 1: 2, 7 and 3, 6
                                               {0x09U, 0x06U},    // z = 0: 0, 3 and 1, 2
                                               {0x90U, 0x60U}}};  // z = 1: 4, 7 and 5, 6

/// Returns corners in the region of which one must leave it, so that one surface without ambiguity divides the cell. 0: it
/// is so.
unsigned corners_too_many(unsigned in) {
  for (const FaceDiagonals& face : kFaces) {
    const unsigned on = in & (face.first | face.second);
    if (on == face.first || on == face.second) return on;
  }
  for (unsigned k = 0; k < 4; ++k) {
    const unsigned opposite = (1U << k) | (1U << (7 - k));
    if (in == opposite || in == (kAll ^ opposite)) return in;
  }
  return 0;
}

}  // namespace

Result<ProvedRegion> ProvedRegion::find(const CellGrid& grid, const StockSide& side, double inset_mm,
                                        const CellWork& work) {
  Result<ProvedCells> cells = ProvedCells::find(grid, side, work);
  if (!cells) return cells.error();
  ProvedRegion region(grid, side, inset_mm, work, std::move(*cells));
  region.open(region.cells_.open());
  do {
    while (region.make_simple()) {
    }
  } while (!region.prove_all());
  return region;
}

void ProvedRegion::open(const Keys& cells) {
  Keys corners;
  for (const std::uint64_t key : cells) {
    if (!proofs_.emplace(key, Proof::none).second) continue;
    waiting_.push_back(key);
    unshaped_.push_back(key);
    for (unsigned k = 0; k < 8; ++k) corners.push_back(grid_key(corner_of(grid_index(key), k)));
  }
  if (!corners.empty()) open_beside(points_.add_corners(corners, work_));
}

// A cell that is not open is all in the region or all out of it.
void ProvedRegion::open_beside(const Keys& corners) {
  Keys cells;
  for (const std::uint64_t key : corners) {
    const GridIndex at = grid_index(key);
    for (unsigned k = 0; k < 8; ++k) {
      const GridIndex cell = corner_of(around(at, -1, -1, -1), k);
      if (!points_.grid().has_cell(cell) || proofs_.contains(grid_key(cell))) continue;
      if (cells_.is_proved(cell) != points_.is_in(at)) cells.push_back(grid_key(cell));
    }
  }
  if (cells.empty()) return;
  std::ranges::sort(cells);
  open(cells);
}

std::uint64_t ProvedRegion::worst_corner(const GridIndex& cell) const {
  std::uint64_t worst = 0;
  double least = std::numeric_limits<double>::max();
  for (unsigned k = 0; k < 8; ++k) {
    const std::uint64_t key = grid_key(corner_of(cell, k));
    if (!points_.corner(key).is_in || points_.corner(key).value_mm >= least) continue;
    least = points_.corner(key).value_mm;
    worst = key;
  }
  return worst;
}

void ProvedRegion::leave(std::uint64_t corner) {
  points_.take_out(corner);
  const GridIndex at = grid_index(corner);
  for (unsigned k = 0; k < 8; ++k) {
    const GridIndex cell = corner_of(around(at, -1, -1, -1), k);
    const auto found = proofs_.find(grid_key(cell));
    if (found == proofs_.end()) continue;
    found->second = Proof::none;
    waiting_.push_back(found->first);
    unshaped_.push_back(found->first);
  }
  open_beside({corner});
}

bool ProvedRegion::make_simple() {
  Keys cells;
  std::swap(cells, unshaped_);
  std::ranges::sort(cells);
  bool has_changed = false;
  for (const std::uint64_t key : cells) {
    const GridIndex cell = grid_index(key);
    const unsigned wrong = corners_too_many(points_.corners_in(cell));
    if (wrong == 0) continue;
    std::uint64_t worst = 0;
    double least = std::numeric_limits<double>::max();
    for (unsigned k = 0; k < 8; ++k) {
      const std::uint64_t corner = grid_key(corner_of(cell, k));
      if ((wrong >> k & 1U) == 0 || points_.corner(corner).value_mm >= least) continue;
      least = points_.corner(corner).value_mm;
      worst = corner;
    }
    leave(worst);
    has_changed = true;
  }
  return has_changed;
}

ProvedRegion::Proof ProvedRegion::prove(const GridIndex& cell) const {
  if (!side_.is_proved()) return Proof::exact;
  const std::vector<HullRegion> pieces = points_.pieces(cell);
  RegionProof exact(side_, inset_mm_, RegionProof::Kind::exact);
  // The whole cell first: it is often in the space of one cut.
  if (pieces.size() > 1 &&
      exact.holds(HullRegion::box(points_.grid().corner(cell), points_.grid().corner(corner_of(cell, 7))), 0))
    return Proof::exact;
  const auto holds = [](RegionProof& proof) {
    return [&proof](const HullRegion& piece) { return proof.holds(piece); };
  };
  if (std::ranges::all_of(pieces, holds(exact))) return Proof::exact;
  if (pieces.size() > 1 && points_.can_pull_back(cell)) return Proof::failed;
  if (!side_.has_slivers()) return Proof::failed;
  RegionProof widened(side_, inset_mm_, RegionProof::Kind::widened);
  return std::ranges::all_of(pieces, holds(widened)) ? Proof::widened : Proof::failed;
}

void ProvedRegion::doubt_about(const GridIndex& cell) {
  if (points_.corners_in(cell) == kAll || !points_.pull_back(cell)) return leave(worst_corner(cell));
  for (const std::int32_t x : {-1, 0, 1})
    for (const std::int32_t y : {-1, 0, 1})
      for (const std::int32_t z : {-1, 0, 1}) {
        const auto found = proofs_.find(grid_key(around(cell, x, y, z)));
        if (found == proofs_.end()) continue;
        if (found->second != Proof::failed) found->second = Proof::none;
        waiting_.push_back(found->first);
      }
}

/// Returns whether all cells are proved.
bool ProvedRegion::prove_all() {
  Keys all, divided;
  std::swap(all, waiting_);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::erase_if(all, [&](std::uint64_t key) { return proofs_.at(key) > Proof::failed; });
  std::ranges::copy_if(all, std::back_inserter(divided), [&](std::uint64_t key) {
    const unsigned in = points_.corners_in(grid_index(key));
    return in != 0 && in != kAll;
  });
  points_.add_points(divided, work_);
  std::vector<Proof> found(all.size());
  for_each_chunk(all.size(), kCellChunk, work_.threads, "proving the stock", work_.progress,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i) found[i] = prove(grid_index(all[i]));
                 });
  for (std::size_t i = 0; i < all.size(); ++i) proofs_.at(all[i]) = found[i];
  // A cell that lost a corner meanwhile is proved anew first.
  for (const std::uint64_t key : all)
    if (proofs_.at(key) == Proof::failed) doubt_about(grid_index(key));
  return waiting_.empty();
}

std::vector<std::uint64_t> ProvedRegion::divided_cells() const {
  Keys divided;
  for (const auto& [key, proof] : proofs_) {
    const unsigned in = points_.corners_in(grid_index(key));
    if (in != 0 && in != kAll) divided.push_back(key);
  }
  std::ranges::sort(divided);
  return divided;
}

std::size_t ProvedRegion::slivers() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(proofs_, [](const auto& entry) { return entry.second == Proof::widened; }));
}

}  // namespace gouge
