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

/// A tool touches the part where its surface is within this of the part's: a twentieth of the cutter's
/// radius, 0.02 mm to 0.5 mm. It allows for tessellation and for what is left to finish, not for a wrong
/// position.
[[nodiscard]] double touch_mm(const ToolVariants& tool);

/// Shape    As check_path, with the verdicts it gave.
/// Ensures  (1) fits, where fewer than 10 positions cut, however deep: a position is too little to judge by.
///          (2) too_deep only if also more than half of the operations are, each by most of its positions, so
///          that one bad operation is none; mistaken never by a shift along the tool axis of less than half
///          the cutter's radius, nor where the path gouges by less than touch_mm: a uniform shallow undercut
///          fits. (3) an explanation changes the path, leaves three quarters of the positions it is tried at
///          touching the part with the tool outside, and at most a tenth gouging; it is the one with which
///          most touch. It takes 20 positions that the mistake changes, and of a unit a path whose size fits
///          the part's better then. (4) the same result at any number of threads.
/// Cost     32 searches where little gouges; else some 27 mistakes, tried at 16 to 128 positions, spread by the golden
///          ratio so that they do not fall into step with passes: 0.1 s to 0.3 s, whatever the path's length, and twice
///          the trees of the part where its size is in doubt.
[[nodiscard]] PathFit find_path_fit(const Toolpath& toolpath, const MoveVerdicts& verdicts,
                                    const std::vector<const ToolVariants*>& tools, const PreparedScene& scene,
                                    unsigned threads);

}  // namespace gouge
