#include <gougecheck/report.h>

#include "cli/library/report_content.h"
#include "cli/library/saved.h"

namespace gougecheck {
namespace {

constexpr const char* kReportKind = "Report";

Fields place_fields(const std::optional<Vec3>& place) { return place ? Fields(*place) : Fields(); }

std::optional<Vec3> place_in(const Fields& fields) {
  return fields.is_null() ? std::nullopt : std::optional(fields.get<Vec3>());
}

Fields fields_of(const Finding& f) {
  return {{"state", static_cast<int>(f.state)},
          {"moves", {f.move, f.moves, f.line}},
          {"numbers", packed_rows(std::vector<double>{f.depth, f.depth_upper, f.overcut, f.clearance, f.t})},
          {"body", f.body ? static_cast<int>(*f.body) : -1},
          {"words", {f.against, f.tool, f.operation, f.message}},
          {"pose", {f.tip, f.axis}},
          {"point", place_fields(f.point)},
          {"normal", place_fields(f.normal)}};
}

Finding finding_in(const Fields& fields) {
  Finding f;
  f.state = static_cast<State>(fields.at("state").get<int>());
  const Fields &moves = fields.at("moves"), &words = fields.at("words"), &pose = fields.at("pose");
  f.move = moves.at(0);
  f.moves = moves.at(1);
  f.line = moves.at(2);
  std::vector<double> numbers;
  take_rows(kReportKind, fields.at("numbers"), numbers);
  if (numbers.size() != 5) refuse_bytes(kReportKind);
  f.depth = numbers[0], f.depth_upper = numbers[1], f.overcut = numbers[2], f.clearance = numbers[3], f.t = numbers[4];
  if (const int body = fields.at("body"); body >= 0) f.body = static_cast<Body>(body);
  f.against = words.at(0);
  f.tool = words.at(1);
  f.operation = words.at(2);
  f.message = words.at(3);
  f.tip = pose.at(0);
  f.axis = pose.at(1);
  f.point = place_in(fields.at("point"));
  f.normal = place_in(fields.at("normal"));
  return f;
}

Fields fields_of(const ReportFacts& facts) {
  Fields fields = {{"verdict", static_cast<int>(facts.verdict)},
                   {"counts", facts.counts},
                   {"worst_depth", facts.worst_depth},
                   {"reasons", Fields::array()},
                   {"assumptions", Fields::array()},
                   {"notes", Fields::array()},
                   {"findings", Fields::array()},
                   {"text", facts.text},
                   {"forms", Fields::object()},
                   {"inputs", facts.inputs}};
  for (const auto& [move, reason] : facts.reasons) fields["reasons"].push_back({move, reason});
  for (const Assumption& a : facts.assumptions)
    fields["assumptions"].push_back({a.fact, a.object, a.state, a.is_open, a.value, a.evidence, a.remedy});
  for (const Note& note : facts.notes) fields["notes"].push_back({note.is_warning, note.code, note.text});
  for (const Finding& finding : facts.findings) fields["findings"].push_back(fields_of(finding));
  for (const auto& [extension, bytes] : facts.forms) fields["forms"][extension] = packed_bytes(bytes);
  return fields;
}

ReportFacts facts_in(const Fields& fields) {
  ReportFacts facts;
  facts.verdict = static_cast<Verdict>(fields.at("verdict").get<int>());
  facts.counts = fields.at("counts").get<std::array<std::size_t, kStates>>();
  facts.worst_depth = fields.at("worst_depth");
  for (const Fields& r : fields.at("reasons")) facts.reasons.emplace(r.at(0).get<std::size_t>(), r.at(1));
  for (const Fields& a : fields.at("assumptions"))
    facts.assumptions.push_back({a.at(0), a.at(1), a.at(2), a.at(3), a.at(4), a.at(5), a.at(6)});
  for (const Fields& n : fields.at("notes")) facts.notes.push_back({n.at(0), n.at(1), n.at(2)});
  for (const Fields& finding : fields.at("findings")) facts.findings.push_back(finding_in(finding));
  facts.text = fields.at("text");
  for (const auto& [extension, bytes] : fields.at("forms").items()) facts.forms.emplace(extension, text_in(bytes));
  facts.inputs = fields.at("inputs").get<std::vector<std::string>>();
  return facts;
}

void take_arrays(const Fields& fields, Report::Content& content) {
  const auto take = [&](const char* name, auto& values) { take_rows(kReportKind, fields.at(name), values); };
  take("state", content.state);
  take("depth", content.depth);
  take("depth_upper", content.depth_upper);
  take("t", content.t);
  take("overcut", content.overcut);
  take("point", content.point);
  take("normal", content.normal);
  take("triangle", content.triangle);
  take("mesh", content.mesh);
  take("body", content.body);
  take("is_fixture", content.is_fixture);
}

}  // namespace

std::string Report::to_bytes() const {
  Fields fields = fields_of(content_->run ? facts_of(*content_->run) : *content_->saved);
  const auto put = [&](const char* name, const auto& values) { fields["arrays"][name] = packed_rows(values); };
  put("state", content_->state);
  put("depth", content_->depth);
  put("depth_upper", content_->depth_upper);
  put("t", content_->t);
  put("overcut", content_->overcut);
  put("point", content_->point);
  put("normal", content_->normal);
  put("triangle", content_->triangle);
  put("mesh", content_->mesh);
  put("body", content_->body);
  put("is_fixture", content_->is_fixture);
  return pack(kReportKind, std::move(fields));
}

Report Report::from_bytes(std::string_view bytes) {
  return unpacked(kReportKind, bytes, [](const Fields& fields) {
    auto content = std::make_shared<Content>(facts_in(fields));
    take_arrays(fields.at("arrays"), *content);
    return Report(std::move(content));
  });
}

}  // namespace gougecheck
