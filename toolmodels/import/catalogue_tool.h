#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/base/units.h"
#include "toolmodels/assembly.h"
#include "toolmodels/import/catalogue_cutter.h"
#include "toolmodels/import/import_tools.h"

// A tool as described by a catalogue or a CAM library, and its conversion to an assembly:
//
//   holder segments          From body_length up.
//   shank                    With shank_diameter, from the shaft segments (or the shoulder) to body_length.
//   shaft segments           As the file lists them, from the tip side up.
//   shoulder                 With shoulder_diameter, from the flutes to shoulder_length.
//   cutter                   From tip to flute_length.

namespace gouge {

struct CatalogueTool {
  std::optional<int> number;
  std::string name;
  std::string file;  ///< empty: the tool stands in the file of the library
  std::size_t line = 0;
  LengthUnit unit = LengthUnit::mm;  ///< unit of the file; all lengths here are in mm
  CatalogueShape shape = CatalogueShape::flat;
  Dimensions dimensions;
  std::vector<ToolSegment> shaft;
  std::vector<ToolSegment> holder;
  std::string uncertainty;     ///< see ToolAssembly::uncertainty
  std::string missing_holder;  ///< see ToolAssembly::missing_holder
};

/// Errors   import-field, import-shape, import-stickout, and those of make_body_profiles. Only the last name the tool.
/// Notes    import-contradiction, import-guess.
[[nodiscard]] Result<ToolAssembly> make_catalogue_tool(const CatalogueTool& tool, const ImportOptions& options,
                                                       Diagnostics& notes);

}  // namespace gouge
