#pragma once

#include <memory>
#include <span>

#include "lib/tool/certified_depth.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// The offset variants of one tool that a check needs. Clearances and stock to leave offset them (rounded).
/// `toolmodels` makes it; a variant that equals another may be a copy of it.
struct ToolVariants {
  CompiledTool bare;             ///< as in the library: for pictures and `tool show`
  CompiledTool against_part;     ///< cutter offset by stock to leave, shank and holder by their clearances
  CompiledTool against_fixture;  ///< shank and holder offset by their clearances
  /// Bodies that have a clearance, alone, offset: any depth in it is a gouge. No elements: none has one.
  CompiledTool with_clearance;
  CompiledTool cutting;                         ///< the cutter alone, offset by stock to leave, which touches the part
  CompiledTool non_cutting;                     ///< shank and holder as offset above: for near misses. May be empty.
  CertifiedDepths part_depths, fixture_depths;  ///< of the variants against_part and against_fixture
  /// The tool with every body wider by the diameter of the cutter. It holds all places that the tool takes where its
  /// tip is up to a diameter beside a motion. Null: not made.
  std::shared_ptr<const ToolVariants> wide;

  /// A form of this tool with its own sure depths.
  struct CertifiedForm {
    const CompiledTool* form;
    const CertifiedDepths* depths;
  };
  /// Returns the least find_certified_depth of the forms, computed once for each depth given.
  [[nodiscard]] CertifiedDepth certified_depth(std::span<const CertifiedForm> forms, double given_mm) const;
};

}  // namespace gouge
