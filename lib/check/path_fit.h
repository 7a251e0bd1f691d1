#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Result of a test whether a path can belong to the part that it is checked against. If it cannot, the result names
/// the usual mistake that explains it. The test is sampled, not certified: no verdict rests on it.
struct PathFit {
  /// The change that makes the path fit.
  struct Explanation {
    std::string text;       ///< UndoneMistake::text
    double share = 0;       ///< share of the examined positions that touch the part after the change
    bool is_of_all = true;  ///< false: the share is of the positions that the change affects
  };
  enum class Kind {
    fits,      ///< as far as the test can determine
    too_deep,  ///< in most cutting positions the depth in the part is nine tenths of the cutter's radius or more, or
               ///< the tool is inside
    mistaken,  ///< at least a fifth of the positions changed by a mistake gouge by more than touch_mm; after the change
               ///< at most a fifth of these do
    apart,     ///< the tool hardly touches the part in its cuts, but does so with one mistake undone
  };

  Kind kind = Kind::fits;
  std::size_t positions = 0;  ///< number of ends of checked moves that cut: all moves but rapids
  std::size_t deep = 0;       ///< number of positions that are deep, as defined at `too_deep`
  std::size_t gouging = 0;    ///< number of positions that are deeper in the part than `touch_mm` of their tool
  std::optional<Explanation> explanation;
};

/// Returns the distance within which the surface of a tool counts as touching the part. It is a twentieth of the
/// cutter's radius, but at least 0.02 mm and at most 0.5 mm. This allows for tessellation and for stock to leave, not
/// for a wrong position.
[[nodiscard]] double touch_mm(const ToolVariants& tool);

/// Tests whether a path can belong to the part.
///
/// Shape    The same as check_path, with the verdicts that it gave.
/// Ensures  (1) `fits` if fewer than 10 positions cut, however deep: so few do not suffice to judge. (2) `too_deep`
///          only if more than half of the operations are too deep too, each in more than half of its positions. So a
///          single bad operation does not give `too_deep`. (3) A shift along the tool axis of less than half the
///          cutter's radius never gives `mistaken`. Nor does a path that gouges by less than touch_mm: a uniform
///          shallow undercut fits. (4) An explanation changes the path. After the change at least three quarters of the
///          tried positions touch the part with the tool outside, and at most a tenth gouge. Of all such changes it is
///          the one with which most positions touch. The mistake must affect at least 20 positions. For a mistaken
///          unit, the size of the path must then also fit the part better. (5) The result is the same at any number of
///          threads.
/// Cost     32 searches if little gouges. Otherwise some 27 mistakes are tried, each at 16 to 128 positions. These are
///          spread by the golden ratio so that they do not fall into step with passes. This takes 0.1 s to 0.3 s for
///          any length of the path. If the size of the part is in doubt, two more trees of the part are built.
[[nodiscard]] PathFit find_path_fit(const Toolpath& toolpath, const MoveVerdicts& verdicts,
                                    const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                                    unsigned threads);

}  // namespace gouge
