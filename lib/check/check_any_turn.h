#pragma once

#include <cstdint>
#include <span>

#include "lib/check/check_options.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Extends the verdicts on motions of one tool to all motions that LawScope::any admits for them: the rotary joints
/// anywhere between their ends, and the tip, independently of them, anywhere on its line or curve.
///
/// The joint positions of a move form a box. Each part of it is proved with the joints at rest at its middle, and with a
/// tool that is swept over all tilts up to the spread of the part. A part without a proof is checked with the tool itself,
/// for a witness, and is then halved.
///
/// Shape    One kind, one verdict and one count of bounds for each motion. Motions without is_any() are passed over.
/// Requires `verdicts`, which check_motions gives for the motions themselves.
/// Ensures  depth <= largest depth over all these poses <= depth_upper. A clean move is proved for each of them. A
///          witness has Witness::turn. After CheckOptions::turn_boxes boxes, a move without a witness is not certified.
/// Cost     That of one check where the surface is far, otherwise of two for each box.
/// Proof    docs/method/machine.md, section "Any motion of the rotary joints".
void check_any_turns(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                     const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                     std::span<std::uint64_t> bounds);

}  // namespace gouge
