#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Tests whether a path can belong to the part it is checked against, and if not, which of the usual
/// mistakes explains it. Sampled, not certified: no verdict rests on it.
struct PathFit {
  /// The change that makes the path fit.
  struct Explanation {
    std::string text;       ///< UndoneMistake::text
    double share = 0;       ///< of the positions examined, how many touch the part then
    bool is_of_all = true;  ///< false: of the positions that it changes
  };
  enum class Kind {
    fits,      ///< as far as can be determined
    too_deep,  ///< most cutting positions are nine tenths of the cutter's radius deep in the part or more, or
               ///< the tool is inside
    mistaken,  ///< a fifth of the positions or more that a mistake concerns are deeper than a touch; undone,
               ///< a fifth of these
    apart,     ///< the tool hardly touches the part where it cuts, and with one mistake undone it does
  };

  Kind kind = Kind::fits;
  std::size_t positions = 0;  ///< ends of checked moves that cut: all but rapids
  std::size_t deep = 0;       ///< of them, as `too_deep` states
  std::size_t gouging = 0;    ///< of them, deeper than `touch_mm` of their tool, in the part
  std::optional<Explanation> explanation;
};

/// Returns the distance within which the surface of a tool touches the part's: a twentieth of the cutter's radius, 0.02
/// mm to 0.5 mm. It allows for tessellation and for stock left to finish, not for a wrong position.
[[nodiscard]] double touch_mm(const ToolVariants& tool);

/// Shape    As check_path, with the verdicts it gave.
/// Ensures  (1) `fits` where fewer than 10 positions cut, however deep: so few do not suffice to judge. (2) `too_deep`
///          only if more than half of the operations are too deep as well, each at most of its positions. So one bad
///          operation alone is not `too_deep`. (3) Never `mistaken` by a shift along the tool axis of less than half
///          the cutter's radius. Nor is it `mistaken` where the path gouges by less than touch_mm: a uniform shallow
///          undercut fits. (4) An explanation changes the path. With it at least three quarters of the tried positions
///          touch the part with the tool outside, and at most a tenth gouge. It is the explanation with which most
///          touch. It needs 20 positions that the mistake changes. For a mistaken unit the size of the path must then
///          fit the part better. (5) The same result at any number of threads.
/// Cost     32 searches where little gouges. Else some 27 mistakes, each tried at 16 to 128 positions. These are spread
///          by the golden ratio so that they do not fall into step with passes. 0.1 s to 0.3 s at any length of the
///          path. Where the size of the part is in doubt, also twice the trees of the part.
[[nodiscard]] PathFit find_path_fit(const Toolpath& toolpath, const MoveVerdicts& verdicts,
                                    const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                                    unsigned threads);

}  // namespace gouge
