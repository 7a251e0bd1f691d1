#include <gougecheck/report.h>

#include <filesystem>
#include <limits>
#include <utility>

#include "cli/library/checked_path.h"
#include "lib/base/files.h"
#include "postproc/report/write_report.h"

namespace gougecheck {

struct Report::Content {
  CheckedPath checked;
  gouge::CheckResult result;
  std::vector<State> state;
  std::vector<double> depth, depth_upper, t, overcut;
  std::vector<Vec3> point, normal;
  std::vector<std::int64_t> triangle;
  std::vector<std::int32_t> mesh;
  std::vector<std::int8_t> body, is_fixture;

  Content(CheckedPath checked_path, gouge::CheckResult check_result)
      : checked(std::move(checked_path)), result(std::move(check_result)) {
    for (const gouge::MoveVerdict& verdict : result.verdicts) add(verdict);
  }

  void add(const gouge::MoveVerdict& verdict) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool has_depth = verdict.state != gouge::MoveState::buried && verdict.state != gouge::MoveState::not_checked;
    state.push_back(static_cast<State>(verdict.state));
    depth.push_back(has_depth ? verdict.depth_mm : kNone);
    depth_upper.push_back(has_depth ? verdict.depth_upper_mm : kNone);
    overcut.push_back(verdict.overcut_mm.value_or(kNone));
    const auto& witness = verdict.witness;
    t.push_back(witness ? witness->t : kNone);
    point.push_back(witness ? to_array(witness->point) : Vec3{kNone, kNone, kNone});
    normal.push_back(witness ? to_array(witness->normal) : Vec3{kNone, kNone, kNone});
    triangle.push_back(witness ? static_cast<std::int64_t>(witness->triangle) : -1);
    mesh.push_back(witness ? static_cast<std::int32_t>(witness->mesh) : -1);
    body.push_back(witness ? static_cast<std::int8_t>(witness->body) : std::int8_t{-1});
    const bool fixture = witness && witness->against == gouge::Against::fixture;
    is_fixture.push_back(witness ? static_cast<std::int8_t>(fixture ? 1 : 0) : std::int8_t{-1});
  }
};

namespace {

struct Form {
  std::string_view extension;
  std::string (*write)(const gouge::ReportModel&);
};

std::string html_alone(const gouge::ReportModel& model) { return gouge::write_html(model, {}); }
std::string all_findings(const gouge::ReportModel& model) { return gouge::findings_text(model); }

constexpr Form kForms[] = {{".json", gouge::write_json}, {".csv", gouge::write_csv}, {".sarif", gouge::write_sarif},
                           {".xml", gouge::write_junit}, {".html", html_alone},      {".txt", all_findings}};

const Form& form_of(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  for (const Form& form : kForms) {
    if (form.extension == extension) return form;
  }
  raise(gouge::make_error("usage", "extension '" + extension + "': expected .json, .csv, .sarif, .xml, .html or .txt",
                          file));
}

}  // namespace

const char* state_name(State state) { return gouge::state_name(static_cast<gouge::MoveState>(state)); }

Report::Report(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Report make_report(CheckedPath checked, gouge::CheckResult result) {
  return Report(std::make_shared<Report::Content>(std::move(checked), std::move(result)));
}

std::size_t Report::size() const { return content_->state.size(); }

Verdict Report::verdict() const { return static_cast<Verdict>(gouge::overall_verdict(content_->result)); }

std::size_t Report::count(State state) const {
  const gouge::StateCounts& counts = content_->result.counts;
  switch (state) {
    case State::clean:
      return counts.clean;
    case State::near_miss:
      return counts.near_miss;
    case State::gouge:
      return counts.gouge;
    case State::buried:
      return counts.buried;
    case State::not_checked:
      return counts.not_checked;
    case State::not_certified:
      return counts.not_certified;
  }
  return 0;
}

double Report::worst_depth() const { return content_->result.worst_depth_mm; }
std::span<const State> Report::state() const { return content_->state; }
std::span<const double> Report::depth() const { return content_->depth; }
std::span<const double> Report::depth_upper() const { return content_->depth_upper; }
std::span<const double> Report::t() const { return content_->t; }
std::span<const Vec3> Report::point() const { return content_->point; }
std::span<const Vec3> Report::normal() const { return content_->normal; }
std::span<const std::int64_t> Report::triangle() const { return content_->triangle; }
std::span<const std::int32_t> Report::mesh() const { return content_->mesh; }
std::span<const std::int8_t> Report::body() const { return content_->body; }
std::span<const std::int8_t> Report::is_fixture() const { return content_->is_fixture; }
std::span<const double> Report::overcut() const { return content_->overcut; }

std::string Report::reason(std::size_t move) const {
  return move < size() ? gouge::reason_text(content_->result.verdicts[move].reason) : std::string();
}

std::vector<Assumption> Report::assumptions() const {
  std::vector<Assumption> all;
  for (const gouge::Assumption& fact : content_->result.assumptions) {
    all.push_back({gouge::subject_name(fact.subject), fact.object, gouge::basis_name(fact.basis), fact.is_open,
                   fact.value, fact.evidence, fact.remedy});
  }
  return all;
}

std::vector<Note> Report::notes() const { return to_notes(content_->checked.model(content_->result).notes); }
std::string Report::text() const { return gouge::findings_text(content_->checked.model(content_->result)); }

void Report::write(const std::string& file) const {
  const Form& form = form_of(file);
  for (const std::string& input : content_->checked.inputs()) {
    std::error_code none;
    if (std::filesystem::equivalent(input, file, none))
      raise(gouge::make_error("usage", "the report would overwrite an input; expected another file", file));
  }
  value_or_raise(gouge::write_file(file, form.write(content_->checked.model(content_->result))));
}

}  // namespace gougecheck
