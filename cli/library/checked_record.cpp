#include <algorithm>
#include <iterator>
#include <span>

#include "cli/library/checked_path.h"
#include "cli/library/path_stock.h"
#include "cli/tools/identities.h"
#include "lib/base/number_text.h"
#include "postproc/report/remedies.h"

// Records the inputs of a check in its result, so that `gougecheck verify` can repeat it from their files.

namespace gougecheck {
namespace {

gouge::MeshFacts facts_of(const Mesh& mesh) {
  const Mesh::Content& content = mesh.content();
  gouge::MeshFacts facts;
  facts.name = mesh.name();
  facts.triangles = content.mesh().triangles.size();
  facts.vertices = content.mesh().vertices.size();
  facts.dropped = content.findings.degenerate_triangles.count;
  facts.is_closed = content.findings.is_watertight();
  for (const gouge::Diagnostic& note : content.notes) {
    if (note.severity == gouge::Severity::warning) facts.meaning += (facts.meaning.empty() ? "" : "; ") + note.message;
  }
  return facts;
}

/// Returns the unit in which all meshes from files were read; nothing if there are several.
std::optional<gouge::LengthUnit> unit_of_meshes(const CheckedPath& checked) {
  std::optional<gouge::LengthUnit> unit;
  for (const auto& meshes : {checked.scene.parts(), checked.scene.fixtures()}) {
    for (const Mesh& mesh : meshes) {
      if (mesh.content().file.name.empty()) continue;
      if (unit && *unit != mesh.content().unit) return std::nullopt;
      unit = mesh.content().unit;
    }
  }
  return unit.value_or(gouge::LengthUnit::mm);
}

/// Returns the files that a repetition of the check reads, in the order in which the command reads them. Files that the
/// command cannot read in the same way are left out, so `gougecheck verify` asks for them.
std::vector<gouge::InputFile> recorded_inputs(const CheckedPath& checked) {
  std::vector<gouge::InputFile> inputs;
  const Path::Content& path = checked.path.content();
  if (!path.is_from_memory && !path.is_rewritten)
    inputs.push_back(gouge::describe_input("toolpath", path.path.file, path.path.source));
  inputs.insert(inputs.end(), path.program.files.begin(), path.program.files.end());
  if (checked.machine != nullptr && checked.machine->file) inputs.push_back(*checked.machine->file);
  const auto add_meshes = [&](const char* role, std::span<const Mesh> meshes) {
    for (const Mesh& mesh : meshes) {
      if (mesh.content().file.name.empty()) continue;
      inputs.push_back(mesh.content().file);
      inputs.back().role = role;
    }
  };
  if (unit_of_meshes(checked)) {
    add_meshes("part", checked.scene.parts());
    add_meshes("fixture", checked.scene.fixtures());
  }
  if (!checked.tools->is_by_facts)
    inputs.insert(inputs.end(), checked.tools->files.begin(), checked.tools->files.end());
  if (checked.stock != nullptr) inputs.insert(inputs.end(), checked.stock->inputs.begin(), checked.stock->inputs.end());
  return inputs;
}

/// Returns the options as the command records them.
std::vector<gouge::OptionText> recorded_options(const CheckedPath& checked) {
  const Path::Content& path = checked.path.content();
  std::vector<gouge::OptionText> all = path.program.options;
  if (path.facts && !path.facts->unit.empty()) all.push_back({"toolpath-units", path.facts->unit});
  if (path.facts && !path.facts->cutcom.empty()) all.push_back({"cutcom", path.facts->cutcom});
  if (const auto unit = unit_of_meshes(checked); unit && checked.basis.mesh_unit)
    all.push_back({"stl-units", std::string(gouge::facts_of(*unit).option)});
  if (checked.machine != nullptr)
    all.insert(all.end(), checked.machine->options.begin(), checked.machine->options.end());
  if (checked.stated_tube.tip_mm > 0)
    all.push_back({"tip-tolerance", gouge::exact_text(checked.stated_tube.tip_mm) + "mm"});
  if (checked.options.tube.axis_rad > 0)
    all.push_back({"axis-tolerance", gouge::exact_text(checked.options.tube.axis_rad / gouge::kDegree_rad)});
  for (const gouge::Vouched& fact : checked.basis.vouched)
    all.push_back({"assume", gouge::subject_name(fact.subject) + (fact.object.empty() ? "" : "=" + fact.object)});
  if (checked.basis.is_strict) all.push_back({"strict", "yes"});
  if (checked.stock != nullptr) all.insert(all.end(), checked.stock->options.begin(), checked.stock->options.end());
  const std::span<const double> clearances = checked.scene.fixture_clearances();
  for (std::size_t i = 0; i < clearances.size(); ++i) {
    if (clearances[i] > 0)
      all.push_back({"fixture", checked.scene.fixtures()[i].name() + ",clearance=" + gouge::exact_text(clearances[i])});
  }
  return all;
}

}  // namespace

gouge::ReportModel CheckedPath::model(const gouge::CheckResult& result) const {
  gouge::ReportModel model;
  const gouge::Toolpath& toolpath = path.content().path;
  model.inputs = recorded_inputs(*this);
  model.more_options = recorded_options(*this);
  if (const auto unit = unit_of_meshes(*this)) model.placement = gouge::placement_identity({}, *unit);
  model.options = options;
  model.toolpath = &toolpath;
  model.result = &result;
  model.notes = toolpath.notes;
  for (const Mesh& part : scene.parts()) model.parts.push_back(facts_of(part));
  for (const Mesh& fixture : scene.fixtures()) model.fixtures.push_back(facts_of(fixture));
  for (std::size_t i = 0; i < scene.fixture_clearances().size(); ++i)
    model.fixtures[i].clearance_mm = scene.fixture_clearances()[i];
  for (const auto& meshes : {scene.parts(), scene.fixtures()}) {
    for (const Mesh& mesh : meshes)
      model.notes.insert(model.notes.end(), mesh.content().notes.begin(), mesh.content().notes.end());
  }
  model.tools = tools->facts;
  model.notes.insert(model.notes.end(), tools->notes.begin(), tools->notes.end());
  if (stock != nullptr) model.notes.insert(model.notes.end(), stock->notes.begin(), stock->notes.end());
  const gouge::Diagnostics open = gouge::open_warnings(result.assumptions);
  model.notes.insert(model.notes.end(), open.begin(), open.end());
  std::ranges::move(gouge::describe_unused(basis.vouched, result.assumptions, toolpath.file),
                    std::back_inserter(model.notes));
  return model;
}

std::vector<std::string> CheckedPath::inputs() const {
  std::vector<std::string> files;
  if (!path.content().is_from_memory) files.push_back(path.name());
  for (const auto& meshes : {scene.parts(), scene.fixtures()}) {
    for (const Mesh& mesh : meshes) {
      if (!mesh.content().file.name.empty()) files.push_back(mesh.content().file.name);
    }
  }
  for (const gouge::InputFile& file : tools->files) files.push_back(file.name);
  if (machine != nullptr && machine->file) files.push_back(machine->file->name);
  if (stock == nullptr) return files;
  for (const Mesh& mesh : stock->meshes) {
    if (!mesh.content().file.name.empty()) files.push_back(mesh.content().file.name);
  }
  return files;
}

}  // namespace gougecheck
