#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/library/checked_path.h"

namespace gougecheck {

inline constexpr std::size_t kStates = 6;

/// Report::Content without arrays: all that a report states, as it is saved.
struct ReportFacts {
  Verdict verdict = Verdict::not_fully_checked;
  std::array<std::size_t, kStates> counts = {};  // by State
  double worst_depth = 0;
  std::map<std::size_t, std::string> reasons;  // by move; a move without one has none
  std::vector<Assumption> assumptions;
  std::vector<Note> notes;
  std::vector<Finding> findings;
  std::string text;
  std::map<std::string, std::string> forms;  // by extension, the bytes that `write` writes
  std::vector<std::string> inputs;           // files that were read for the check
};

/// The inputs and the result of a check in this process.
struct CheckedResult {
  CheckedPath checked;
  gouge::CheckResult result;

  [[nodiscard]] gouge::ReportModel model() const { return checked.model(result); }
};

/// Exactly one of `run` and `saved` is there.
struct Report::Content {
  std::optional<CheckedResult> run;
  std::optional<ReportFacts> saved;
  std::vector<State> state;
  std::vector<double> depth, depth_upper, t, overcut;
  std::vector<Vec3> point, normal;
  std::vector<std::int64_t> triangle;
  std::vector<std::int32_t> mesh;
  std::vector<std::int8_t> body, is_fixture;

  explicit Content(ReportFacts facts) : saved(std::move(facts)) {}
  Content(CheckedPath checked_path, gouge::CheckResult check_result)
      : run({std::move(checked_path), std::move(check_result)}) {
    for (const gouge::MoveVerdict& verdict : run->result.verdicts) add(verdict);
  }

  void add(const gouge::MoveVerdict& verdict) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool has_depth = verdict.state != gouge::MoveState::buried && verdict.state != gouge::MoveState::not_checked;
    state.push_back(static_cast<State>(verdict.state));
    depth.push_back(has_depth ? verdict.depth_mm : kNone);
    depth_upper.push_back(has_depth ? verdict.depth_upper_mm : kNone);
    overcut.push_back(verdict.overcut ? verdict.overcut->lower_mm : kNone);
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

/// Returns the facts of a result.
[[nodiscard]] ReportFacts facts_of(const CheckedResult& run);
/// Returns the bytes that a report in the format of the extension has; nothing for another extension.
[[nodiscard]] std::optional<std::string> form_of(const gouge::ReportModel& model, const std::string& extension);

}  // namespace gougecheck
