#include "cli/job/load_stock.h"

#include <limits>
#include <utility>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/mesh/load_mesh.h"
#include "toolmodels/compile_tool.h"

namespace gouge {
namespace {

class StockLoader {
 public:
  StockLoader(const JobArguments& arguments, Job& job) : arguments_(arguments), job_(job) {}

  Result<LoadedStock> run() {
    const Result<StockOptions> options = understand_stock_options(arguments_);
    if (!options) return options.error();
    Result<StockSolid> solid = make_solid();
    if (!solid) return solid.error();
    stock_.setup = StockSetup{std::move(*solid), {}, *options};
    if (const std::optional<Diagnostic> error = add_tools()) return *error;
    job_.basis.inputs.push_back(fact());
    return std::move(stock_);
  }

 private:
  Result<StockSolid> make_solid() {
    const Result<StockShape> shape = understand_stock_shape(arguments_.stock);
    if (!shape) return shape.error();
    if (shape->kind == StockShape::Kind::file) return read_file_solid();
    const std::vector<IndexedMesh>& parts = job_.scene().parts;
    if (shape->kind == StockShape::Kind::part) {
      description_ = "the part with an allowance of " + exact_text(shape->allowance_mm) + " mm";
      return StockSolid::meshes(parts, shape->allowance_mm);
    }
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const IndexedMesh& part : parts) {
      for (const Vec3& vertex : part.vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
      }
    }
    const Vec3 margin = Vec3::Constant(shape->allowance_mm);
    low -= margin;
    high += margin;
    description_ = "the box from " + point(low) + " to " + point(high) + " mm about the part";
    return StockSolid::box(low, high);
  }

  static std::string point(const Vec3& p) {
    constexpr int kDecimals = 3;
    return display_text(p.x(), kDecimals) + "," + display_text(p.y(), kDecimals) + "," + display_text(p.z(), kDecimals);
  }

  Result<StockSolid> read_file_solid() {
    const std::string& name = arguments_.stock;
    Result<std::string> bytes = read_file(name, arguments_.input.max_bytes);
    if (!bytes) return bytes.error();
    job_.inputs.push_back(describe_input("stock", name, *bytes));
    Result<LoadedMesh> loaded = load_mesh_bytes(*bytes, name, {job_.stl_unit(arguments_), job_.options.place});
    if (!loaded) return loaded.error();
    stock_.meshes.push_back(std::move(loaded->mesh));
    description_ = name;
    return StockSolid::meshes({&stock_.meshes.back(), 1}, 0);
  }

  /// Cutters and bodies as they are: clearances and the stock to leave concern the part.
  std::optional<Diagnostic> add_tools() {
    for (const std::optional<ToolAssembly>& assembly : job_.assemblies) {
      stock_.setup->tools.emplace_back();
      if (!assembly) continue;
      Result<ToolVariants> variants =
          make_tool_variants(arguments_.is_extended_up ? job_.without_end(*assembly) : *assembly, 0, 0, 0);
      if (!variants) return variants.error();
      stock_.tools.push_back(std::move(*variants));
      stock_.setup->tools.back().tool = &stock_.tools.back();
    }
    return std::nullopt;
  }

  [[nodiscard]] Assumption fact() const {
    Assumption fact{.subject = Subject::stock, .basis = Basis::stated, .value = description_};
    fact.evidence = "stated by the user; only the moves of this path remove material from it";
    fact.file = job_.toolpath.file;
    return fact;
  }

  const JobArguments& arguments_;
  Job& job_;
  LoadedStock stock_;
  std::string description_;
};

}  // namespace

Result<LoadedStock> load_stock(const JobArguments& arguments, Job& job) {
  if (!job.options.check.tube.is_empty())
    return make_error("usage",
                      "--stock does not cover the tolerances of the control yet; give --tip-tolerance 0 and "
                      "--axis-tolerance 0");
  return StockLoader(arguments, job).run();
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
