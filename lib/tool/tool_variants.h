#pragma once

#include <array>
#include <memory>
#include <span>

#include "lib/tool/certified_depth.h"
#include "lib/tool/compiled_tool.h"
#include "lib/tool/tilted_tools.h"

namespace gouge {

/// The cutter, the shank and the holder of a tool, each as a solid of its own: it is closed where it meets the next body.
/// No elements: the tool has no such body.
using BodiesAlone = std::array<std::shared_ptr<const CompiledTool>, 3>;

/// The bodies of the variants that a check needs. Equal bodies are one object.
struct AloneVariants {
  BodiesAlone bare, against_part, against_fixture;
};

/// The offset variants of one tool that a check needs. Their offsets are the clearances and the stock to leave
/// (rounded). `toolmodels` makes the variants. Equal variants may be copies.
struct ToolVariants {
  CompiledTool bare;             ///< as in the library: for pictures and `tool show`
  CompiledTool against_part;     ///< cutter offset by stock to leave, shank and holder by their clearances
  CompiledTool against_fixture;  ///< shank and holder offset by their clearances
  /// Only the bodies with a clearance, offset by it. Any depth in this variant is a gouge. No elements: no body has a
  /// clearance.
  CompiledTool with_clearance;
  CompiledTool cutting;                         ///< the cutter alone, offset by stock to leave; it may touch the part
  CompiledTool non_cutting;                     ///< shank and holder, offset by their clearances, for near misses; may
                                                ///< be empty
  CertifiedDepths part_depths, fixture_depths;  ///< of the variants against_part and against_fixture
  /// The tool with every body wider by the diameter of the cutter. It contains all places of the tool if the tip is up
  /// to one diameter beside a motion. Null: not made.
  std::shared_ptr<const ToolVariants> wide;
  /// The bodies of bare, against_part and against_fixture. Null: not made.
  std::shared_ptr<const AloneVariants> alone;
  /// The tool swept over tilts. Null: not made.
  std::shared_ptr<const TiltedTools> tilted;

  /// A form of this tool with its own stored certified depths.
  struct CertifiedForm {
    const CompiledTool* form;
    const CertifiedDepths* depths;
  };
  /// Returns the minimum find_certified_depth of the forms. It is computed once for each given depth.
  [[nodiscard]] CertifiedDepth certified_depth(std::span<const CertifiedForm> forms, double given_mm) const;
};

}  // namespace gouge
