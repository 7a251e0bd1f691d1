#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "cli/library/content.h"
#include "lib/certify/settle_stock.h"
#include "postproc/report/report_model.h"
#include "toolmodels/assembly.h"

namespace gougecheck {

struct PathMachine;

/// The stock of one check, with all to which it refers. Immutable.
struct PathStock {
  std::vector<Mesh> meshes;
  std::vector<gouge::IndexedMesh> solids;
  std::deque<gouge::ToolVariants> tools;
  std::optional<gouge::StockSetup> setup;
  gouge::Assumptions facts;
  gouge::Diagnostics notes;
  std::vector<gouge::OptionText> options;  // as the command records them
  std::vector<gouge::InputFile> inputs;    // files of the stock, in the order in which the command reads them
};

/// Makes the stock that the options state; null: none. `parts` are in the unit of the path, and must outlive it.
/// Errors: usage, a text or a length that is wrong, or tolerances of a control. stock-open-mesh. no-tool: no tool of an
/// earlier program is defined. before-place: a program is moved whose motion depends on the machine.
[[nodiscard]] std::shared_ptr<const PathStock> make_path_stock(
    const CheckOptions& options, const gouge::CheckOptions& understood, const gouge::Toolpath& path,
    const std::vector<gouge::IndexedMesh>& parts, const std::vector<std::optional<gouge::ToolAssembly>>& assemblies,
    const PathMachine* machine);

}  // namespace gougecheck
