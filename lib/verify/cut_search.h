#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lib/verify/named_cut.h"

// The search for the cut that removed a block. A proof does not depend on how it was found.

namespace gouge {

/// A part of a cut that is short enough to be nearly straight.
struct CutChord {
  NamedCut start;  ///< its first instant; `level` is that of the chord
  bool is_straight = false;
  MotionPiece piece;
  const ToolContour* cutter;
  Pose pose0, pose1;   ///< approximate, at its ends
  double from, until;  ///< shares of the piece of the cut
  double middle_mm;    ///< height in the middle of the cutter
};

/// The chords whose cutter may contain a part of a block.
using ChordList = std::vector<const CutChord*>;

/// A cut with its cutter and poses.
struct FoundCut {
  NamedCut cut;
  const ToolContour* cutter = nullptr;
  CutPoses poses;
  Pose at;   ///< of the cutter where it is nearest
  Vec3 way;  ///< of its tip on the whole chord
};

class CutSearch {
 public:
  /// Blocks count as removed within `wider_mm` of a cutter. `programs` must outlive it.
  CutSearch(const CutPrograms& programs, double wider_mm) : programs_(programs), wider_mm_(wider_mm) {}

  /// Returns the radius above which a block is not worth a search: it is in no cutter, nor in a straight cut.
  [[nodiscard]] double largest_mm() const { return largest_mm_; }
  /// Returns the chords of moves up to `last_move` of the last program, and of all moves of the programs before it, that
  /// may contain a part of the block. They stay until forget().
  [[nodiscard]] ChordList near(const SpaceBlock& block, double radius_mm, std::size_t last_move);
  /// Frees the chords if they are many. Lists become invalid.
  void forget();

  /// Returns a cut by the instant that contains the block; nothing if it finds none. `left` are the chords that may
  /// contain a part of it.
  [[nodiscard]] std::optional<NamedCut> find(const SpaceBlock& block, double radius_mm, const ChordList& chords,
                                             const LatestInstant& latest, ChordList& left);
  /// Returns cuts by the instant whose cutter contains the middle one of three points on a way. Those whose axis is nearest
  /// to it come first. They last from the first point to the last where they are straight.
  [[nodiscard]] std::vector<FoundCut> along(const Vec3& from, const Vec3& middle, const Vec3& to,
                                            const LatestInstant& latest);
  /// Returns the longest arm across which a section of the block of the last find is in a cutter; nothing: there is none.
  [[nodiscard]] std::optional<std::size_t> arm_to_cut() const { return arm_to_cut_; }

 private:
  /// The instant of a chord at which the middle of a block is deepest in its cutter.
  struct Deepest {
    double share = 0;
    double distance_mm = 0;  ///< signed; negative inside
    double most = 1;         ///< the last share that is permitted
  };
  [[nodiscard]] const std::vector<CutChord>& chords_of(std::size_t program, std::size_t move);
  void append_chords(const MotionPiece& piece, const NamedCut& at, const ToolContour& cutter,
                     std::vector<CutChord>& chords) const;
  [[nodiscard]] std::optional<Deepest> deepest(const CutChord& chord, const Vec3& point,
                                               const LatestInstant& latest) const;
  /// A cut by places of its chord, and the same by places of its piece.
  struct Trial {
    NamedCut cut;
    std::uint64_t level = 0, first = 0, last = 0;
  };
  /// Returns the cut that may contain a block; nothing: its instants are too late.
  [[nodiscard]] std::optional<Trial> trial_of(const CutChord& chord, const Deepest& at, const SpaceBlock& block,
                                              const LatestInstant& latest) const;
  /// Returns whether the trial contains the block, up to the rounding of its poses.
  [[nodiscard]] bool seems_within(const CutChord& chord, const Trial& trial, const SpaceBlock& block) const;
  /// Returns the poses of a trial whose places are reduced.
  [[nodiscard]] static CutPoses poses_of(const CutChord& chord, Trial& trial);
  [[nodiscard]] std::optional<NamedCut> try_at(const CutChord& chord, const Deepest& at, const SpaceBlock& block,
                                               const LatestInstant& latest) const;
  [[nodiscard]] std::optional<std::size_t> find_arm(const CutChord& chord, const Deepest& at, const SpaceBlock& block,
                                                    const LatestInstant& latest) const;

  const CutPrograms& programs_;
  double wider_mm_, largest_mm_ = largest_of(programs_);
  std::vector<std::unordered_map<std::size_t, std::vector<CutChord>>> chords_{programs_.size()};
  std::size_t held_ = 0;
  const CutChord* hint_ = nullptr;
  std::optional<std::size_t> arm_to_cut_;

  static double largest_of(const CutPrograms& programs);
};

}  // namespace gouge
