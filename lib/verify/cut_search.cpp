#include "lib/verify/cut_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/verify/claimed_pieces.h"
#include "lib/verify/witness_check.h"

namespace gouge {

namespace {

constexpr std::size_t kMaxChords = 60'000;  // held at once
constexpr std::size_t kTries = 6;           // chords whose instant is tested, of all that contain the middle of a block
constexpr double kSagShare = 0.25;          // a chord leaves its motion by no more than this share of the resolution
constexpr double kStepShare = 0.25;         // instants of a chord are as near to each other, along the way of the tip
constexpr std::uint64_t kMaxHalvings = 12;
constexpr double kFixedAxis = 1e-9, kStill = 1e-6;

Pose between(const CutChord& chord, double share) {
  return {(1 - share) * chord.pose0.tip + share * chord.pose1.tip,
          ((1 - share) * chord.pose0.axis + share * chord.pose1.axis).normalized()};
}

}  // namespace

double CutSearch::largest_of(const CutPrograms& programs) {
  double largest = 0;
  for (std::size_t k = 0; k < programs.size(); ++k)
    largest = std::max(largest, programs.at(k).largest_mm() + 0.5 * programs.at(k).longest_mm());
  return largest;
}

ChordList CutSearch::near(const SpaceBlock& block, double radius_mm, std::size_t last_move) {
  ChordList list;
  for (std::size_t k = 0; k < programs_.size(); ++k) {
    const ProgramCuts& program = programs_.at(k);
    const std::size_t before = k + 1 < programs_.size() ? program.path().moves.size() : last_move + 1;
    program.visit_near(block.center, before, radius_mm + wider_mm_, [&](std::size_t move) {
      for (const CutChord& chord : chords_of(k, move)) list.push_back(&chord);
    });
  }
  return list;
}

void CutSearch::forget() {
  if (held_ < kMaxChords) return;
  for (auto& of_program : chords_) of_program.clear();
  held_ = 0;
  hint_ = nullptr;
}

const std::vector<CutChord>& CutSearch::chords_of(std::size_t program, std::size_t move) {
  const auto [at, is_new] = chords_[program].try_emplace(move);
  if (!is_new) return at->second;
  NamedCut cut;
  cut.program = program;
  cut.move = move;
  const ToolContour* const cutter = programs_.cutter_of(cut);
  const auto pieces = cutter != nullptr ? claimed_pieces(programs_.at(program).scene(), move) : std::nullopt;
  if (!pieces) return at->second;
  for (const MotionPiece& piece : *pieces) {
    append_chords(piece, cut, *cutter, at->second);
    ++cut.piece;
  }
  held_ += at->second.size();
  return at->second;
}

void CutSearch::append_chords(const MotionPiece& piece, const NamedCut& at, const ToolContour& cutter,
                              std::vector<CutChord>& chords) const {
  const double off = piece.sag_mm() + piece.bend() * cutter.size_mm();
  if (off > kSagShare * wider_mm_ && at.level < kMaxHalvings) {
    const std::array<MotionPiece, 2> halves = piece.halves();
    NamedCut half = at;
    ++half.level;
    half.first = half.last = 2 * at.first;
    append_chords(halves[0], half, cutter, chords);
    half.first = half.last = 2 * at.first + 1;
    append_chords(halves[1], half, cutter, chords);
    return;
  }
  const double parts = static_cast<double>(1ULL << at.level), first = static_cast<double>(at.first);
  chords.push_back({at, is_straight(piece), piece, &cutter, piece.start().middle(), piece.end().middle(), first / parts,
                    (first + 1) / parts, 0.5 * (cutter.low_mm() + cutter.high_mm())});
}

// The middle is deepest where it is nearest to the axis, or half-way up the cutter; else at an end of the chord.
std::optional<CutSearch::Deepest> CutSearch::deepest(const CutChord& chord, const Vec3& point,
                                                     const LatestInstant& latest) const {
  double most = 1;
  if (!is_by(chord.start, programs_.size() - 1, latest)) return std::nullopt;
  if (chord.start.program + 1 == programs_.size() && chord.start.move == latest.move &&
      chord.start.piece == latest.piece)
    most = std::min(1.0, (latest.share - chord.from) / (chord.until - chord.from));
  const Vec3 way = chord.pose1.tip - chord.pose0.tip, from = point - chord.pose0.tip;
  const Vec3 axis = between(chord, 0.5).axis;
  const double along = way.dot(axis);
  const Vec3 across = way - along * axis;
  std::array<double, 5> shares{};
  std::size_t count = 0;
  const auto add = [&](double share) { shares[count++] = std::clamp(share, 0.0, most); };
  if (across.norm() > kStill * std::abs(along)) add(from.dot(across) / across.squaredNorm());
  if (std::abs(along) > kStill * across.norm()) add((from.dot(axis) - chord.middle_mm) / along);
  const bool is_turning = (chord.pose1.axis - chord.pose0.axis).squaredNorm() > kFixedAxis * kFixedAxis;
  if (is_turning || count == 0)
    for (const double share : {0.0, 0.5, 1.0}) add(share * most);
  Deepest best;
  for (std::size_t k = 0; k < count; ++k) {
    const double distance = chord.cutter->nearest(in_tool(between(chord, shares[k]), point)).signed_distance_mm;
    if (k == 0 || distance < best.distance_mm) best = {shares[k], distance, most};
  }
  return best;
}

/// Returns the shares of a straight chord at which its axis passes the corners of a block, the least and the largest.
std::pair<double, double> shares_of(const CutChord& chord, const SpaceBlock& block, double most) {
  const Vec3 way = chord.pose1.tip - chord.pose0.tip, across = way - way.dot(chord.pose0.axis) * chord.pose0.axis;
  const double middle = (block.center - chord.pose0.tip).dot(across), square = across.squaredNorm();
  double half = 0;
  for (const Vec3& arm : block.arms) half += std::abs(arm.dot(across));
  return {std::clamp((middle - half) / square, 0.0, most), std::clamp((middle + half) / square, 0.0, most)};
}

std::optional<CutSearch::Trial> CutSearch::trial_of(const CutChord& chord, const Deepest& at, const SpaceBlock& block,
                                                    const LatestInstant& latest) const {
  const Vec3 along = chord.pose1.tip - chord.pose0.tip;
  const double way = along.norm() + (chord.pose1.axis - chord.pose0.axis).norm() * chord.cutter->size_mm();
  Trial trial{chord.start};
  while (trial.level < kMaxHalvings && way / static_cast<double>(1ULL << trial.level) > kStepShare * wider_mm_)
    ++trial.level;
  const auto parts = static_cast<double>(1ULL << trial.level);
  const auto place_of = [&](double share) { return static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * parts); };
  trial.first = trial.last = place_of(at.share + 0.5 / parts);
  if (chord.is_straight && along.cross(chord.pose0.axis).norm() > kStepShare * wider_mm_) {
    const auto [least, largest] = shares_of(chord, block, at.most);
    trial.first = place_of(least);
    trial.last = place_of(largest);
  }
  trial.cut.level += trial.level;
  const std::uint64_t base = chord.start.first << trial.level;
  for (;; --trial.last) {
    trial.first = std::min(trial.first, trial.last);
    trial.cut.first = base + trial.first;
    trial.cut.last = base + trial.last;
    if (is_by(trial.cut, programs_.size() - 1, latest)) return trial;
    if (trial.last == 0) return std::nullopt;
  }
}

bool CutSearch::seems_within(const CutChord& chord, const Trial& trial, const SpaceBlock& block) const {
  const auto about = [&](std::uint64_t place) {
    const Pose pose = between(chord, static_cast<double>(place) / static_cast<double>(1ULL << trial.level));
    return PoseBounds{Bounds3(pose.tip), Bounds3(pose.axis)};
  };
  return is_within_cutter(*chord.cutter, {about(trial.first), about(trial.last)}, block, wider_mm_);
}

std::optional<NamedCut> CutSearch::try_at(const CutChord& chord, const Deepest& at, const SpaceBlock& block,
                                          const LatestInstant& latest) const {
  std::optional<Trial> trial = trial_of(chord, at, block, latest);
  if (!trial || !seems_within(chord, *trial, block)) return std::nullopt;
  if (!is_within_cutter(*chord.cutter, poses_of(chord, *trial), block, wider_mm_)) return std::nullopt;
  return trial->cut;
}

CutPoses CutSearch::poses_of(const CutChord& chord, Trial& trial) {
  for (; trial.level > 0 && trial.first % 2 == 0 && trial.last % 2 == 0; --trial.level, --trial.cut.level)
    for (std::uint64_t* place : {&trial.first, &trial.last, &trial.cut.first, &trial.cut.last}) *place /= 2;
  const PoseBounds first = pose_at_place(chord.piece, trial.level, trial.first);
  return {first, trial.first == trial.last ? first : pose_at_place(chord.piece, trial.level, trial.last)};
}

std::vector<FoundCut> CutSearch::along(const Vec3& from, const Vec3& middle, const Vec3& to,
                                       const LatestInstant& latest) {
  constexpr std::size_t kMaxFound = 3;
  struct Candidate {
    double off_mm = 0;
    Deepest at;
    const CutChord* chord = nullptr;
  };
  std::vector<Candidate> best;
  for (const CutChord* chord : near({middle, {}}, 0, latest.move)) {
    const auto at = deepest(*chord, middle, latest);
    if (!at || at->distance_mm > 0) continue;
    const double off = in_tool(between(*chord, at->share), middle).x();
    const auto place = std::upper_bound(best.begin(), best.end(), off,
                                        [](double value, const Candidate& one) { return value < one.off_mm; });
    best.insert(place, {off, *at, chord});
    if (best.size() > kMaxFound) best.pop_back();
  }
  const SpaceBlock line{0.5 * (from + to), {0.5 * (to - from), Vec3::Zero(), Vec3::Zero()}};
  std::vector<FoundCut> found;
  for (const auto& [off, at, chord] : best) {
    auto trial = trial_of(*chord, at, line, latest);
    if (!trial) continue;
    const CutPoses poses = poses_of(*chord, *trial);
    found.push_back({trial->cut, chord->cutter, poses, between(*chord, at.share), chord->pose1.tip - chord->pose0.tip});
  }
  return found;
}

std::optional<std::size_t> CutSearch::find_arm(const CutChord& chord, const Deepest& at, const SpaceBlock& block,
                                               const LatestInstant& latest) const {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < 3; ++k) {
    if (best && block.arms[k].squaredNorm() <= block.arms[*best].squaredNorm()) continue;
    const SpaceBlock section = block.section(k);
    if (const auto trial = trial_of(chord, at, section, latest); trial && seems_within(chord, *trial, section))
      best = k;
  }
  return best;
}

std::optional<NamedCut> CutSearch::find(const SpaceBlock& block, double radius_mm, const ChordList& chords,
                                        const LatestInstant& latest, ChordList& left) {
  arm_to_cut_.reset();
  if (hint_ != nullptr) {
    if (const auto at = deepest(*hint_, block.center, latest); at && at->distance_mm < wider_mm_)
      if (const auto cut = try_at(*hint_, *at, block, latest)) return cut;
  }
  std::array<std::pair<Deepest, const CutChord*>, kTries> best;
  std::size_t count = 0;
  left.reserve(chords.size());
  for (const CutChord* chord : chords) {
    // A chord that is too late for this time may serve for a part of it.
    const auto at = deepest(*chord, block.center, latest);
    if (!at || at->most < 1 || at->distance_mm < radius_mm + wider_mm_) left.push_back(chord);
    if (!at || at->distance_mm > wider_mm_) continue;
    if (count == kTries && !(at->distance_mm < best[kTries - 1].first.distance_mm)) continue;
    std::size_t k = count < kTries ? count++ : kTries - 1;
    for (; k > 0 && at->distance_mm < best[k - 1].first.distance_mm; --k) best[k] = best[k - 1];
    best[k] = {*at, chord};
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (const auto cut = try_at(*best[k].second, best[k].first, block, latest)) {
      hint_ = best[k].second;
      return cut;
    }
  }
  for (std::size_t k = 0; k < count && !arm_to_cut_; ++k)
    arm_to_cut_ = find_arm(*best[k].second, best[k].first, block, latest);
  return std::nullopt;
}

}  // namespace gouge
