#include "cli/job/load_stock.h"

#include <utility>

#include "cli/tools/stock_tools.h"
#include "lib/base/files.h"
#include "lib/mesh/load_mesh.h"

namespace gouge {
namespace {

class StockLoader {
 public:
  StockLoader(const JobArguments& arguments, Job& job, Progress& progress, Diagnostics& errors)
      : arguments_(arguments), job_(job), progress_(progress), errors_(errors) {}

  std::optional<LoadedStock> run() {
    Result<StockOptions> options = understand_stock_options(arguments_);
    if (!options) return fail(options.error());
    options->tube = job_.options.check.tube;
    Result<DescribedStock> stock = make_solid();
    if (!stock) return fail(stock.error());
    description_ = std::move(stock->description);
    Result<std::vector<StockTool>> tools = make_stock_tools(assemblies(), stock_.tools);
    if (!tools) return fail(tools.error());
    stock_.setup = StockSetup{.solid = std::move(stock->solid), .tools = std::move(*tools), .options = *options};
    stock_.setup->heads = stock_heads(job_.heads());
    std::optional<EarlierPrograms> before = read_earlier_programs(arguments_, job_, progress_, errors_);
    if (!before) return std::nullopt;
    stock_.setup->before = std::move(before->programs);
    stock_.tools_before = std::move(before->tools);
    job_.basis.inputs.push_back(fact());
    return std::move(stock_);
  }

 private:
  std::nullopt_t fail(const Diagnostic& error) {
    errors_.push_back(error);
    return std::nullopt;
  }

  Result<DescribedStock> make_solid() {
    const Result<StockShape> shape = understand_stock_shape(arguments_.stock);
    if (!shape) return shape.error();
    if (shape->kind != StockShape::Kind::file) return make_stock(*shape, job_.scene().parts, "");
    const std::string& name = arguments_.stock;
    Result<std::string> bytes = read_file(name, arguments_.input.max_bytes);
    if (!bytes) return bytes.error();
    job_.inputs.push_back(describe_input("stock", name, *bytes));
    Result<LoadedMesh> loaded = load_mesh_bytes(*bytes, name, {job_.stl_unit(arguments_), job_.options.place});
    if (!loaded) return loaded.error();
    stock_.meshes.push_back(std::move(loaded->mesh));
    return make_stock(*shape, {&stock_.meshes.back(), 1}, name);
  }

  [[nodiscard]] std::vector<std::optional<ToolAssembly>> assemblies() const {
    std::vector<std::optional<ToolAssembly>> all = job_.assemblies;
    if (!arguments_.is_extended_up) return all;
    for (std::optional<ToolAssembly>& assembly : all)
      if (assembly) assembly = job_.without_end(*assembly);
    return all;
  }

  [[nodiscard]] Assumption fact() const {
    return assume_stock(description_, *stock_.setup, job_.scene().parts, job_.toolpath.file);
  }

  const JobArguments& arguments_;
  Job& job_;
  Progress& progress_;
  Diagnostics& errors_;
  LoadedStock stock_;
  std::string description_;
};

}  // namespace

std::optional<LoadedStock> load_stock(const JobArguments& arguments, Job& job, Progress& progress,
                                      Diagnostics& errors) {
  return StockLoader(arguments, job, progress, errors).run();
}

// The tool with the room may be as deep in stock as the tolerance and the resolution, and the stock counts as smaller by the
// resolution. So the tool is wider by these too.
std::optional<Diagnostic> add_roomy_tools(double clearance_mm, const JobArguments& arguments, const Job& job,
                                          LoadedStock& stock) {
  StockSetup& setup = *stock.setup;
  if (!(clearance_mm > 0)) return std::nullopt;
  setup.roomy_mm = clearance_mm + setup.options.tolerance_mm + 2 * setup.options.resolution_mm;
  for (const std::optional<ToolAssembly>& assembly : job.assemblies) {
    setup.roomy.push_back(nullptr);
    if (!assembly) continue;
    Result<ToolVariants> wide = make_tool_variants(arguments.is_extended_up ? job.without_end(*assembly) : *assembly,
                                                   setup.roomy_mm, setup.roomy_mm, setup.roomy_mm);
    if (!wide) return wide.error();
    stock.roomy_tools.push_back(std::move(*wide));
    setup.roomy.back() = &stock.roomy_tools.back().against_part;
  }
  return std::nullopt;
}

}  // namespace gouge
