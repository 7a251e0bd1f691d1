#include <gougecheck/report.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/library/report_content.h"
#include "cli/library/report_findings.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "postproc/report/write_report.h"
#include "postproc/report_files/own_files.h"

namespace gougecheck {
namespace {

struct Form {
  std::string_view extension;
  std::string (*write)(const gouge::ReportModel&);
};

std::string html_alone(const gouge::ReportModel& model) { return gouge::write_html(model, {}); }
std::string all_findings(const gouge::ReportModel& model) { return gouge::findings_text(model); }

constexpr Form kForms[] = {{".json", gouge::write_json}, {".csv", gouge::write_csv}, {".sarif", gouge::write_sarif},
                           {".xml", gouge::write_junit}, {".html", html_alone},      {".txt", all_findings}};

Verdict verdict_of(const CheckedResult& run) { return static_cast<Verdict>(gouge::overall_verdict(run.result)); }

std::array<std::size_t, kStates> counts_of(const gouge::StateCounts& n) {
  return {n.clean, n.near_miss, n.gouge, n.buried, n.not_checked, n.not_certified};
}

std::vector<Assumption> assumptions_of(const gouge::CheckResult& result) {
  std::vector<Assumption> all;
  for (const gouge::Assumption& fact : result.assumptions) {
    all.push_back({gouge::subject_name(fact.subject), fact.object, gouge::basis_name(fact.basis), fact.is_open,
                   fact.value, fact.evidence, fact.remedy});
  }
  return all;
}

std::string form_in(const Report::Content& content, const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  std::optional<std::string> form;
  if (content.run) {
    form = form_of(content.run->model(), extension);
  } else if (const auto found = content.saved->forms.find(extension); found != content.saved->forms.end()) {
    form = found->second;
  }
  if (form) return std::move(*form);
  raise(gouge::make_error("usage", "extension '" + extension + "': expected .json, .csv, .sarif, .xml, .html or .txt",
                          file));
}

}  // namespace

const char* state_name(State state) {
  if (static_cast<std::size_t>(state) >= kStates)
    raise(gouge::make_error(
        "usage", "state " + std::to_string(static_cast<int>(state)) + ": expected one of State, which has 0 to 5"));
  return gouge::state_name(static_cast<gouge::MoveState>(state));
}

std::optional<std::string> form_of(const gouge::ReportModel& model, const std::string& extension) {
  const auto form = std::ranges::find(kForms, extension, &Form::extension);
  return form == std::end(kForms) ? std::nullopt : std::optional(form->write(model));
}

ReportFacts facts_of(const CheckedResult& run) {
  const gouge::ReportModel model = run.model();
  ReportFacts facts;
  facts.verdict = verdict_of(run);
  facts.counts = counts_of(run.result.counts);
  facts.worst_depth = run.result.worst_depth_mm;
  for (std::size_t move = 0; move < run.result.verdicts.size(); ++move) {
    std::string reason = gouge::reason_text(run.result.verdicts[move].reason);
    if (!reason.empty()) facts.reasons.emplace(move, std::move(reason));
  }
  facts.assumptions = assumptions_of(run.result);
  facts.notes = to_notes(model.notes);
  facts.findings = findings_of(run.checked, run.result);
  facts.text = gouge::findings_text(model);
  for (const Form& form : kForms) facts.forms.emplace(form.extension, form.write(model));
  facts.inputs = run.checked.inputs();
  return facts;
}

Report::Report(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Report make_report(CheckedPath checked, gouge::CheckResult result) {
  return Report(std::make_shared<Report::Content>(std::move(checked), std::move(result)));
}

std::size_t Report::size() const { return content_->state.size(); }

Verdict Report::verdict() const { return content_->run ? verdict_of(*content_->run) : content_->saved->verdict; }

int Report::exit_status() const {
  if (verdict() == Verdict::clean) return gouge::kExitClean;
  return verdict() == Verdict::gouges ? gouge::kExitGouges : gouge::kExitNotChecked;
}

std::size_t Report::count(State state) const {
  const auto index = static_cast<std::size_t>(state);
  if (index >= kStates) return 0;
  return content_->run ? counts_of(content_->run->result.counts)[index] : content_->saved->counts[index];
}

double Report::worst_depth() const {
  return content_->run ? content_->run->result.worst_depth_mm : content_->saved->worst_depth;
}
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
  if (move >= size()) return {};
  if (content_->run) return gouge::reason_text(content_->run->result.verdicts[move].reason);
  const auto found = content_->saved->reasons.find(move);
  return found == content_->saved->reasons.end() ? std::string() : found->second;
}

std::vector<Finding> Report::findings() const {
  return content_->run ? findings_of(content_->run->checked, content_->run->result) : content_->saved->findings;
}

std::vector<Assumption> Report::assumptions() const {
  return content_->run ? assumptions_of(content_->run->result) : content_->saved->assumptions;
}

std::vector<Note> Report::notes() const {
  return content_->run ? to_notes(content_->run->model().notes) : content_->saved->notes;
}

std::string Report::text() const {
  return content_->run ? gouge::findings_text(content_->run->model()) : content_->saved->text;
}

void Report::write(const std::string& file) const {
  const std::string bytes = form_in(*content_, file);
  for (const std::string& input : content_->run ? content_->run->checked.inputs() : content_->saved->inputs) {
    std::error_code none;
    if (std::filesystem::equivalent(input, file, none))
      raise(gouge::make_error("usage", "the report would overwrite an input; expected another file", file));
  }
  if (const std::string why = gouge::why_kept(file); !why.empty())
    raise(gouge::make_error("usage", "the output " + why, file));
  value_or_raise(gouge::write_file(file, bytes));
}

}  // namespace gougecheck
