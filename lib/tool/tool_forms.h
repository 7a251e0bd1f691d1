#pragma once

#include "lib/tool/compiled_tool.h"
#include "lib/tool/sure_depth.h"

namespace gouge {

/// The forms of one tool that a check needs. Clearances and stock to leave are grown into them (rounded).
/// `toolmodels` makes it; a form that equals another may be a copy of it.
struct ToolForms {
  CompiledTool bare;             ///< as in the library: for pictures and `tool show`
  CompiledTool against_part;     ///< cutter grown by stock to leave, shank and holder by their clearances
  CompiledTool against_fixture;  ///< shank and holder grown by their clearances
  /// Bodies that have a clearance, alone, grown: any depth in it is a gouge. No elements: none has one.
  CompiledTool with_clearance;
  CompiledTool non_cutting;  ///< shank and holder as grown above: for near misses. May be empty.
  SureDepths part_depths, fixture_depths;  ///< of the forms against_part and against_fixture

  /// find_sure_depth, the lesser one of the forms that are asked for. Computed once for each depth given.
  [[nodiscard]] SureDepth sure_depth(bool has_parts, bool has_fixtures, double given_mm) const;
};

}  // namespace gouge
