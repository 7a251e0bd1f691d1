#include "lib/path/assumption.h"

#include <algorithm>
#include <iterator>

namespace gouge {
namespace {

constexpr std::array<const char*, 5> kBases = {"stated", "derived", "default", "contradicted", "unknown"};
constexpr std::array<const char*, kSubjects> kNames = {"path-unit",  "dialect",   "complete",  "statements", "frame",
                                                       "motion-law", "machine",   "smoothing", "tool",       "holder",
                                                       "head",       "mesh-unit", "solid",     "placement",  "stock"};

bool is_vouched(const Assumption& fact, const std::vector<Vouched>& vouched) {
  return std::ranges::any_of(vouched, [&](const Vouched& v) {
    return v.subject == fact.subject && (v.object.empty() || v.object == fact.object);
  });
}

bool is_open(Basis basis, bool is_strict) {
  return basis == Basis::contradicted || basis == Basis::unknown || (is_strict && basis == Basis::by_default);
}

// Maximum number of shown objects of a subject, such as the tools of a long job. Further objects are only counted.
constexpr std::size_t kMaxShown = 4;

}  // namespace

const char* basis_name(Basis basis) { return kBases.at(static_cast<std::size_t>(basis)); }

const char* subject_name(Subject subject) { return kNames.at(static_cast<std::size_t>(subject)); }

std::optional<Subject> subject_called(std::string_view name) {
  const auto* const found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Subject>(found - kNames.begin());
}

std::string subject_names() {
  std::string names;
  for (const char* name : kNames) names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

std::optional<Vouched> parse_vouched(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::optional<Subject> subject = subject_called(text.substr(0, equals));
  if (!subject) return std::nullopt;
  if (equals == std::string_view::npos) return Vouched{*subject, {}};
  if (equals + 1 == text.size()) return std::nullopt;
  return Vouched{*subject, std::string(text.substr(equals + 1))};
}

void settle(Assumptions& facts, const std::vector<Vouched>& vouched, bool is_strict) {
  std::ranges::stable_sort(facts, {}, &Assumption::subject);
  for (Assumption& fact : facts) {
    if (is_vouched(fact, vouched)) fact.basis = Basis::stated;
    fact.is_open = is_open(fact.basis, is_strict);
  }
}

void copy_facts(Subject subject, const Assumptions& from, Assumptions& to) {
  std::erase_if(to, [&](const Assumption& fact) { return fact.subject == subject; });
  std::ranges::copy_if(from, std::back_inserter(to), [&](const Assumption& fact) { return fact.subject == subject; });
  std::ranges::stable_sort(to, {}, &Assumption::subject);
}

bool has_open(const Assumptions& facts) { return std::ranges::any_of(facts, &Assumption::is_open); }

Diagnostics open_warnings(const Assumptions& facts) {
  Diagnostics warnings;
  for (const Assumption& fact : facts) {
    if (!fact.is_open) continue;
    std::string message = fact.evidence + "; " + fact.remedy;
    warnings.push_back(make_warning(fact.code, std::move(message), fact.file, fact.line));
  }
  return warnings;
}

std::string assumptions_text(const Assumptions& facts) {
  std::string text;
  std::size_t of_subject = 0, left_out = 0;
  const auto close = [&] {
    if (left_out > 0) text += " and " + std::to_string(left_out) + " more";
    left_out = 0;
  };
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const Assumption& fact = facts[i];
    const bool is_new = i == 0 || facts[i - 1].subject != fact.subject;
    if (is_new) close();
    of_subject = is_new ? 1 : of_subject + 1;
    if (of_subject > kMaxShown) {
      ++left_out;
      continue;
    }
    text += text.empty() ? "" : ", ";
    if (is_new) text += std::string(subject_name(fact.subject)) + " ";
    if (!fact.object.empty()) text += fact.object + " ";
    text += fact.value + " (" + basis_name(fact.basis) + ")";
  }
  close();
  return text;
}

}  // namespace gouge
