#include <algorithm>
#include <cmath>

#include "lib/stock/excess.h"

namespace gouge {

namespace {

constexpr std::size_t kSamples = 64;  // pieces that one thread takes at a time

void divide_to(const FacetPiece& piece, double size_mm, std::vector<FacetPiece>& all) {
  if (piece.radius_mm() <= size_mm) return all.push_back(piece);
  for (const FacetPiece& half : divided(piece)) divide_to(half, size_mm, all);
}

}  // namespace

std::vector<ColumnSample> sample_columns(const ExcessQuestion& question, const ExcessResult& result, double height_mm,
                                         double size_mm, std::size_t most, unsigned threads) {
  const double size = std::max(size_mm, std::sqrt(result.area_upper_mm2() / static_cast<double>(most)));
  std::vector<FacetPiece> pieces;
  for (const ExcessPlace& place : result.places) {
    for (std::uint32_t k = 0; k < place.pieces; ++k) divide_to(result.left[place.first_piece + k].piece, size, pieces);
  }
  std::vector<double> heights(pieces.size(), 0);
  for_each_chunk(pieces.size(), kSamples, threads, [&](std::size_t first, std::size_t last) {
    ColumnProofs proofs(question);
    for (std::size_t k = first; k < last; ++k) heights[k] = proofs.height_left_mm(pieces[k], question.highest_mm());
  });
  std::vector<ColumnSample> samples;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (heights[k] > height_mm) samples.push_back({pieces[k].corners, heights[k]});
  return samples;
}

}  // namespace gouge
