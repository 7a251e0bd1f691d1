#include <gougecheck/path.h>

#include <algorithm>

#include "cli/library/content.h"
#include "lib/base/file_kind.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/check/reach.h"
#include "postproc/formats/read_toolpath.h"

namespace gougecheck {
namespace {

[[noreturn]] void refuse_position(const std::string& name, std::size_t position, const Vec3& axis) {
  const bool is_axis_wrong = !to_pose({0, 0, 0}, axis);
  const std::string what = is_axis_wrong ? "the axis has no length that is a number"
                                         : "the tip is not three numbers within 100 m of the origin";
  raise(gouge::make_error(is_axis_wrong ? "path-axis" : "path-too-far",
                          "position " + std::to_string(position) + ": " + what, name));
}

void require_path_reach(const gouge::Toolpath& path) {
  for (const gouge::Move& move : path.moves) {
    if (gouge::is_within_reach(move.end.tip)) continue;
    raise(gouge::make_error(
        "path-too-far", "the position is more than 100 m from the origin; expected a path within that; check the units",
        path.file, move.line));
  }
}

void append(std::string& text, const gouge::Vec3& v) {
  for (int k = 0; k < 3; ++k) {
    text += k == 0 ? "" : ",";
    text += gouge::exact_text(v[k]);
  }
}

/// Returns the error of a reader with the one that reads the file, if it was given to the wrong one.
gouge::Diagnostic with_other_reader(gouge::Diagnostic error, bool is_program, bool may_be_cl_data) {
  if (!is_program && error.code == "gcode-control")
    error.message = "is a program of a machine's control; read it with read_program and the control";
  if (is_program && may_be_cl_data && error.code == "path-no-motion")
    error.message = "is CL data, not a program of a machine's control; read it with Path::read (Python: read_toolpath)";
  return error;
}

/// Returns positions and axes with all digits as APT, without feeds, which a path from memory does not have.
std::string apt_text(const gouge::Toolpath& path) {
  std::string text = "UNITS/MM\nMULTAX\nLOADTL/1\n";
  for (const gouge::Move& move : path.moves) {
    if (move.kind == gouge::MoveKind::rapid) text += "RAPID\n";
    text += "GOTO/";
    append(text, move.end.tip);
    text += ',';
    append(text, move.end.axis);
    text += '\n';
  }
  return text + "FINI\n";
}

}  // namespace

Path::Path(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Path::Path(std::span<const Vec3> tips, std::span<const Vec3> axes, std::span<const bool> rapids, std::string name) {
  const std::size_t count = tips.size();
  if (count == 0) raise(gouge::make_error("path-no-motion", "the path has no position; expected at least one", name));
  if ((axes.size() != count && axes.size() != 1) || (!rapids.empty() && rapids.size() != count)) {
    raise(gouge::make_error("path-count",
                            std::to_string(count) + " tips, " + std::to_string(axes.size()) + " axes and " +
                                std::to_string(rapids.size()) +
                                " rapids; expected as many axes as tips, or one, and as many rapids, or none",
                            name));
  }
  gouge::Toolpath path;
  path.file = std::move(name);
  path.dialect = "apt";
  path.is_unit_stated = true;
  path.assumptions = {{.subject = gouge::Subject::path_unit,
                       .basis = gouge::Basis::stated,
                       .value = "mm",
                       .evidence = "paths from memory are in mm"}};
  path.tools.emplace_back().name = "tool";
  path.moves.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& axis = axes[axes.size() == 1 ? 0 : i];
    const auto pose = to_pose(tips[i], axis);
    if (!pose) refuse_position(path.file, i, axis);
    gouge::Move& move = path.moves[i];
    move.end = *pose;
    move.line = i + 1;
    move.tool = 0;
    move.has_start = i > 0;
    if (!rapids.empty() && rapids[i]) {
      move.kind = gouge::MoveKind::rapid;
      move.feed_unit = gouge::FeedUnit::rapid;
    }
  }
  content_ = PathAccess::from(std::move(path), true).content_;
}

Path Path::read(const std::string& file, const ReadFacts& facts) {
  return from_text(value_or_raise(gouge::read_file(file)), file, facts);
}

Path Path::read(const std::string& file, const std::string& unit) { return read(file, ReadFacts{unit, {}}); }

Path Path::from_text(std::string text, const std::string& name, const ReadFacts& facts) {
  const auto known = gouge::unit_called(facts.unit);
  const bool is_of_path = known == gouge::LengthUnit::mm || known == gouge::LengthUnit::inch;
  if (!facts.unit.empty() && !is_of_path)
    raise(gouge::make_error("usage", "unit '" + facts.unit + "': expected mm or inch", name));
  if (!facts.cutcom.empty() && facts.cutcom != "centre")
    raise(gouge::make_error("usage", "cutcom '" + facts.cutcom + "': expected centre", name));
  gouge::ReadOptions options;
  options.unit = known;
  options.is_cutcom_centre = !facts.cutcom.empty();
  return PathAccess::with_facts(PathAccess::from_bytes(name, std::move(text), options), facts);
}

Path Path::from_text(std::string text, const std::string& name, const std::string& unit) {
  return from_text(std::move(text), name, ReadFacts{unit, {}});
}

Path PathAccess::from_bytes(const std::string& name, std::string bytes, const gouge::ReadOptions& options) {
  const bool is_program = options.dialect && options.dialect->id == gouge::gcode_dialect().id;
  const bool may_be_cl_data = is_program && gouge::looks_like_cl_data(bytes);
  gouge::ReadOutcome outcome = gouge::read_toolpath(name, std::move(bytes), options);
  if (!outcome.toolpath) raise(with_other_reader(outcome.errors.front(), is_program, may_be_cl_data));
  require_path_reach(*outcome.toolpath);
  return from(std::move(*outcome.toolpath), false);
}

Path PathAccess::with_program(const Path& path, ProgramOrigin origin) {
  auto content = std::make_shared<Path::Content>(path.content());
  content->program = std::move(origin);
  return Path(std::move(content));
}

Path PathAccess::rewritten(gouge::Toolpath path) {
  auto content = std::make_shared<Path::Content>(from(std::move(path), false).content());
  content->is_rewritten = true;
  return Path(std::move(content));
}

Path PathAccess::with_origin_of(const Path& path, gouge::Toolpath other) {
  const Path::Content& origin = path.content();
  auto content = std::make_shared<Path::Content>(from(std::move(other), origin.is_from_memory).content());
  content->is_rewritten = origin.is_rewritten;
  content->program = origin.program;
  content->facts = origin.facts;
  return Path(std::move(content));
}

Path PathAccess::with_facts(const Path& path, const ReadFacts& facts) {
  auto content = std::make_shared<Path::Content>(path.content());
  content->facts = facts;
  return Path(std::move(content));
}

Path PathAccess::from(gouge::Toolpath path, bool is_from_memory) {
  auto content = std::make_shared<Path::Content>();
  content->path = std::move(path);
  content->is_from_memory = is_from_memory;
  for (const gouge::Move& move : content->path.moves) {
    content->tips.push_back(to_array(move.end.tip));
    content->axes.push_back(to_array(move.end.axis));
    content->kinds.push_back(static_cast<MoveKind>(move.kind));
    content->lines.push_back(static_cast<std::uint32_t>(std::size_t{move.line}));
  }
  return Path(std::move(content));
}

std::size_t Path::size() const { return content_->tips.size(); }
const std::string& Path::name() const { return content_->path.file; }
std::span<const Vec3> Path::tips() const { return content_->tips; }
std::span<const Vec3> Path::axes() const { return content_->axes; }
std::span<const MoveKind> Path::kinds() const { return content_->kinds; }
std::span<const std::uint32_t> Path::lines() const { return content_->lines; }

std::vector<Note> Path::notes() const {
  gouge::Diagnostics all = content_->path.notes;
  gouge::Assumptions facts = content_->path.assumptions;
  gouge::settle(facts, {}, false);
  const gouge::Diagnostics open = gouge::open_warnings(facts);
  all.insert(all.end(), open.begin(), open.end());
  return to_notes(all);
}

std::string Path::text() const {
  return content_->is_from_memory ? apt_text(content_->path) : std::string(content_->path.source.view());
}

}  // namespace gougecheck
