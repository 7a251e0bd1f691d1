#include "cli/library/path_stock.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cli/library/checked_path.h"
#include "cli/machine/program_machine.h"
#include "cli/tools/resolve_tools.h"
#include "cli/tools/stock_tools.h"
#include "cli/values/parse_lengths.h"
#include "cli/values/parse_stock.h"
#include "lib/base/number_text.h"
#include "lib/path/place_path.h"

namespace gougecheck {
namespace {

constexpr double kFinestStock_mm = 0.001;

[[noreturn]] void refuse(const std::string& message) { raise(gouge::make_error("usage", message)); }

gouge::StockOptions options_of(const Stock& stock) {
  gouge::StockOptions options;
  if (!(stock.tolerance > 0 && stock.tolerance <= gouge::kFarthest_mm))
    refuse("stock.tolerance: expected a length above 0");
  options.tolerance_mm = stock.tolerance;
  options.resolution_mm = stock.resolution.value_or(std::min(options.resolution_mm, 0.5 * stock.tolerance));
  if (!(options.resolution_mm >= kFinestStock_mm && options.resolution_mm <= options.tolerance_mm))
    refuse("stock.resolution: expected a length from 0.001 mm to the tolerance of the stock");
  return options;
}

class StockMaker {
 public:
  StockMaker(const Stock& stock, const gouge::CheckOptions& understood, const gouge::Toolpath& path,
             const PathMachine* machine)
      : stock_(stock), understood_(understood), path_(path), machine_(machine) {}

  std::shared_ptr<const PathStock> run(const std::vector<gouge::IndexedMesh>& parts,
                                       const std::vector<std::optional<gouge::ToolAssembly>>& assemblies) {
    gouge::DescribedStock solid = solid_of(parts);
    made_->setup = gouge::StockSetup{.solid = std::move(solid.solid),
                                     .tools = value_or_raise(gouge::make_stock_tools(assemblies, made_->tools)),
                                     .options = options_of(stock_)};
    made_->setup->options.tube = understood_.tube;
    for (const EarlierProgram& program : stock_.before) add(program);
    made_->facts.push_back(gouge::assume_stock(solid.description, *made_->setup, parts, path_.file));
    record();
    return made_;
  }

 private:
  gouge::DescribedStock solid_of(const std::vector<gouge::IndexedMesh>& parts) {
    if (stock_.meshes.empty()) {
      const std::optional<gouge::StockShape> shape = gouge::parse_stock_shape(stock_.shape);
      if (!shape || shape->kind == gouge::StockShape::Kind::file)
        refuse("stock.shape '" + stock_.shape + "': expected box, box=LENGTH or part+LENGTH, or meshes");
      return value_or_raise(gouge::make_stock(*shape, parts, ""));
    }
    std::string names;
    for (const Mesh& mesh : stock_.meshes) {
      made_->meshes.push_back(MeshAccess::in(mesh, path_.unit));
      made_->solids.push_back(made_->meshes.back().content().mesh());
      names += (names.empty() ? "" : ", ") + mesh.name();
    }
    return value_or_raise(gouge::make_stock({}, made_->solids, names));
  }

  void add(const EarlierProgram& stated) {
    gouge::EarlierProgram& program = made_->setup->before.emplace_back();
    const auto* const library = std::get_if<ToolLibrary>(&stated.tools);
    program.path = (library != nullptr ? stated.path : with_every_tool_named(stated.path)).content().path;
    program.law = understood_.law;
    place(stated, program.path);
    const std::string& name = program.path.file;
    gouge::ResolvedTools resolved = value_or_raise(
        library != nullptr
            ? gouge::resolve_tools(program.path, &library->content().library, {}, {}, gouge::ToolUse::removes_stock)
            : gouge::resolve_given(program.path, std::get<Tool>(stated.tools).content().assembly,
                                   gouge::ToolUse::removes_stock));
    if (std::ranges::none_of(resolved.assemblies, [](const auto& assembly) { return assembly.has_value(); }))
      raise(gouge::make_error("no-tool",
                              "no tool of this program is defined, so what it removed is not known; expected one of "
                              "its number or name in its library, or CUTTER or TLDATA in the path",
                              name));
    program.tools = value_or_raise(gouge::make_stock_tools(resolved.assemblies, made_->tools));
    for (const gouge::Assumptions* facts : {&program.path.assumptions, &resolved.assumptions})
      std::ranges::move(gouge::facts_of_program(name, *facts), std::back_inserter(made_->facts));
    for (const gouge::Diagnostics* notes : {&program.path.notes, &resolved.notes})
      made_->notes.insert(made_->notes.end(), notes->begin(), notes->end());
  }

  void place(const EarlierProgram& stated, gouge::Toolpath& path) {
    if (stated.place.empty()) {
      if (auto other = gouge::find_other_offset(path, path_)) raise(std::move(*other));
      if (machine_ != nullptr) path = joints_added(std::move(path), *machine_);
      return;
    }
    const std::optional<gouge::RigidTransform> to_path = gouge::parse_place(stated.place);
    if (!to_path) refuse("before.place '" + stated.place + "': expected x,y,z or x,y,z,rx,ry,rz");
    if (!understood_.law.is_great_circle() || understood_.law.rapid() == gouge::RapidMode::dogleg)
      raise(gouge::make_error("before-place",
                              "the motion between its positions depends on the place of the program on the machine; "
                              "expected a program in the coordinates of the path, or the great circle with straight "
                              "rapids",
                              path.file));
    gouge::place_path(*to_path, path);
  }

  void record() {
    std::string names;
    for (const Mesh& mesh : stock_.meshes) names += (names.empty() ? "" : ", ") + mesh.name();
    made_->options.push_back({"stock", names.empty() ? stock_.shape : names});
    for (const Mesh& mesh : made_->meshes) add_input("stock", mesh.content().file);
    for (const EarlierProgram& program : stock_.before) record(program);
    made_->options.push_back({"stock-tolerance", gouge::exact_text(made_->setup->options.tolerance_mm) + "mm"});
    made_->options.push_back({"stock-resolution", gouge::exact_text(made_->setup->options.resolution_mm) + "mm"});
  }

  void record(const EarlierProgram& program) {
    const Path::Content& path = program.path.content();
    if (!path.is_from_memory && !path.is_rewritten)
      made_->inputs.push_back(gouge::describe_input("before", path.path.file, path.path.source));
    const auto* const library = std::get_if<ToolLibrary>(&program.tools);
    const bool is_file = library != nullptr && !library->content().files.empty() && !library->content().is_by_facts;
    std::string tools = "memory";
    if (is_file) {
      for (gouge::InputFile file : library->content().files) {
        if (file.role == "tools") {
          file.role = "before-tools";
          tools = file.name;
        }
        made_->inputs.push_back(std::move(file));
      }
    }
    made_->options.push_back(
        {"before", program.path.name() + ",tools=" + tools + (program.place.empty() ? "" : ",place=" + program.place)});
  }

  void add_input(const char* role, gouge::InputFile file) {
    if (file.name.empty()) return;
    file.role = role;
    made_->inputs.push_back(std::move(file));
  }

  const Stock& stock_;
  const gouge::CheckOptions& understood_;
  const gouge::Toolpath& path_;
  const PathMachine* machine_;
  std::shared_ptr<PathStock> made_ = std::make_shared<PathStock>();
};

}  // namespace

std::shared_ptr<const PathStock> make_path_stock(const CheckOptions& options, const gouge::CheckOptions& understood,
                                                 const gouge::Toolpath& path,
                                                 const std::vector<gouge::IndexedMesh>& parts,
                                                 const std::vector<std::optional<gouge::ToolAssembly>>& assemblies,
                                                 const PathMachine* machine) {
  if (!options.stock) return nullptr;
  return StockMaker(*options.stock, understood, path, machine).run(parts, assemblies);
}

}  // namespace gougecheck
