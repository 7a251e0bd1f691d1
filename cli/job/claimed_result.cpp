#include "cli/job/claimed_result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/options/job_options.h"
#include "cli/options/option_table.h"
#include "lib/base/units.h"
#include "lib/json/json_field.h"

namespace gouge {
namespace {

using nlohmann::json;

// In the order of ClaimedState.
const std::vector<std::string> kStates = {"clean", "near", "gouge", "buried", "not-checked", "not-certified"};
constexpr std::array<const char*, 6> kTotals = {"clean", "near", "gouge", "buried", "not_checked", "not_certified"};
const std::vector<std::string> kRapids(kRapidWords.begin(), kRapidWords.end());  // in the order of RapidMode

/// A file where the result names it, or beside the result.
std::string found_at(const std::string& name, const std::string& result_file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path beside = fs::path(result_file).parent_path() / fs::path(name);
  return !fs::exists(name, error) && fs::exists(beside, error) ? beside.string() : name;
}

class ResultReader {
 public:
  ResultReader(const std::string& file, const JsonField& root) : file_(file), root_(root) {}

  // After the first error, which `root` keeps, of no meaning.
  ClaimedResult read() {
    result_.mm_per_unit = mm_per(root_.at("unit").word({"mm", "in"}) == 1 ? LengthUnit::inch : LengthUnit::mm);
    result_.program = root_.at("program").at("name").text() + " " + root_.at("program").at("version").text();
    result_.verdict = root_.at("verdict").text();
    result_.exit_status = root_.at("exit_status").count();
    result_.has_baseline = !root_.at("baseline").is_null();
    if (const auto facts = root_.find("assumptions")) {
      for (const JsonField& fact : facts->list()) read_fact(fact);
    }
    for (const JsonField& input : root_.at("inputs").list()) read_input(input);
    read_options(root_.at("options"));
    if (result_.arguments.has_warnings_as_errors) read_warnings(root_.at("notes"));
    const JsonField totals = root_.at("totals");
    result_.moves = totals.at("moves").count();
    result_.left_out_as_asked = totals.at("left_out_as_asked").count();
    for (const char* const total : kTotals) result_.totals[total] = totals.at(total).count();
    for (const JsonField& move : root_.at("moves").list()) read_move(move);
    for (const JsonField& event : root_.at("events").list()) read_finding(event);
    return std::move(result_);
  }

 private:
  void read_fact(const JsonField& fact) {
    const std::string state = fact.at("state").text();
    const std::string name = fact.at("fact").text();
    if (fact.at("is_open").flag()) {
      result_.open_facts.push_back(name);
    } else if (state == basis_name(Basis::contradicted) || state == basis_name(Basis::unknown)) {
      result_.hidden_facts.push_back(name + " (" + state + ")");
    }
  }

  // With --warnings-as-errors a warning is as open as a fact.
  void read_warnings(const JsonField& notes) {
    for (const JsonField& note : notes.list()) {
      if (note.at("severity").text() == "warning") result_.open_facts.emplace_back("warnings");
    }
  }

  void read_input(const JsonField& input) {
    JobArguments& a = result_.arguments;
    const std::string role = input.at("role").text();
    if (role == "baseline" || role == "project") return;  // no verdict depends on the bytes of these
    const std::string as_named = input.at("name").text(), name = found_at(as_named, file_);
    if (as_named.empty() || as_named.find('\0') != std::string::npos) input.at("name").fail("the name of a file");
    result_.inputs.push_back({role, name, input.at("bytes").count(), input.at("checksum").text()});
    if (role == "toolpath") a.path = name;
    if (role == "part") a.parts.push_back(name);
    if (role == "fixture") a.fixtures.push_back(name);
    if (role == "head") a.heads.push_back(name);
    if (role == "tools") a.tools_file = name;
    if (role == "machine") a.machine = name;
    if (role == "part") named_parts_.push_back(as_named);
    if (role == "fixture") named_fixtures_.push_back(as_named);
    if (role == "part" || role == "fixture")
      meshes_[role + " " + as_named] = (role == "part" ? a.parts : a.fixtures).size() - 1;
  }

  void read_options(const JsonField& options) {
    CheckOptions& check = result_.options.check;
    check.tolerance_mm = non_negative(options.at("tolerance"));
    check.resolution_mm = non_negative(options.at("resolution"));
    check.stock_to_leave_mm = length(options.at("stock_to_leave"));
    check.shank_clearance_mm = non_negative(options.at("shank_clearance"));
    check.holder_clearance_mm = non_negative(options.at("holder_clearance"));
    check.near_miss_mm = non_negative(options.at("near_miss"));
    JobArguments& a = result_.arguments;
    const std::size_t rapid = options.at("rapid").word(kRapids);
    a.rapid = kRapids[rapid];
    check.law = static_cast<RapidMode>(rapid);
    const JsonField more = options.at("more");
    const auto given = [&](const std::string& key, bool is_repeatable) {
      if (is_repeatable) return all_given(more, key.c_str());
      const std::optional<JsonField> value = more.find(key);
      return value ? std::vector<std::string>{value->text()} : std::vector<std::string>();
    };
    repeat_options<ReadingArguments>(a.reading, reading_options(), given);
    const std::string machine = a.machine;
    repeat_options(a, job_options(), given);
    if (!machine.empty()) a.machine = machine;
    read_limits(more, "part", Against::part, named_parts_);
    read_limits(more, "fixture", Against::fixture, named_fixtures_);
  }

  void read_limits(const JsonField& more, const char* option, Against against, const std::vector<std::string>& named) {
    std::vector<std::string> files;
    LimitTexts texts;
    split_limits(all_given(more, option), files, texts);
    const Result<std::vector<MeshLimit>> limits =
        understand_limits("--" + std::string(option), against, named, texts, result_.options.check.tolerance_mm);
    if (!limits) return more.at(option).fail("limits of the files that are named");
    std::vector<MeshLimit>& all = result_.options.limits;
    all.insert(all.end(), limits->begin(), limits->end());
    if (limits->size() != texts.size()) more.at(option).fail("a file that is named among the inputs");
  }

  // For an option that may be given several times: a text, or a list of them.
  static std::vector<std::string> all_given(const JsonField& more, const char* option) {
    const std::optional<JsonField> value = more.find(option);
    if (!value) return {};
    if (value->is_text()) return {value->text()};
    std::vector<std::string> texts;
    for (const JsonField& text : value->list()) texts.push_back(text.text());
    return texts;
  }

  void read_finding(const JsonField& event) {
    result_.findings.push_back({static_cast<ClaimedState>(event.at("state").word(kStates)),
                                event.at("first_move").count(), event.at("last_move").count(),
                                event.at("worst_move").count()});
  }

  void read_move(const JsonField& move) {
    MoveClaim claim;
    claim.state = static_cast<ClaimedState>(move.at("state").word(kStates));
    claim.depth_mm = length_or_null(move.at("depth")).value_or(0);
    claim.depth_upper_mm = length_or_null(move.at("depth_upper"));
    claim.clearance_mm = length_or_null(move.at("clearance"));
    if (const JsonField named = move.at("witness"); !named.is_null()) claim.witness = witness(named);
    const std::size_t index = move.at("move").count();
    result_.lines[index] = move.at("line").count();
    if (!result_.claims.emplace(index, claim).second) result_.totals["moves named twice"]++;
  }

  [[nodiscard]] ClaimedWitness witness(const JsonField& w) const {
    static const std::vector<std::string> kBodies = {"cutter", "shank", "holder", "head"};
    static const std::vector<std::string> kCounterparts = {"part", "fixture"};
    ClaimedWitness read;
    read.t = w.at("t").number();
    read.point = vector(w.at("point")) * result_.mm_per_unit;
    read.normal = vector(w.at("normal"));
    read.body = static_cast<Body>(w.at("body").word(kBodies));
    const std::size_t against = w.at("against").word(kCounterparts);
    read.is_fixture = against == 1;
    const auto mesh = meshes_.find(kCounterparts[against] + " " + w.at("mesh").text());
    read.mesh = mesh == meshes_.end() ? static_cast<std::size_t>(-1) : mesh->second;
    read.triangle = w.at("triangle").count();
    return read;
  }

  [[nodiscard]] static Vec3 vector(const JsonField& field) {
    const std::vector<JsonField> numbers = field.list();
    if (numbers.size() == 3) return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
    field.fail("three numbers");
    return Vec3::Zero();
  }
  [[nodiscard]] double length(const JsonField& field) const {
    const double value = field.number() * result_.mm_per_unit;
    if (!std::isfinite(value)) field.fail("a length");
    return value;
  }
  [[nodiscard]] double non_negative(const JsonField& field) const {
    const double value = length(field);
    if (!(value >= 0)) field.fail("a length of 0 or more");
    return value;
  }
  [[nodiscard]] std::optional<double> length_or_null(const JsonField& field) const {
    return field.is_null() ? std::nullopt : std::optional(non_negative(field));
  }

  const std::string& file_;
  JsonField root_;
  std::vector<std::string> named_parts_, named_fixtures_;
  std::map<std::string, std::size_t> meshes_;  // by role and name: which of its kind
  ClaimedResult result_;
};

Diagnostic invalid(const std::string& file, const std::string& found) {
  return make_error("result-invalid", found + "; expected the JSON of 'gougecheck check --json'", file);
}

/// Findings and moves must show the same: every gouge is in a finding, and a finding's worst move is as it states.
void compare_findings(const ClaimedResult& result, std::vector<std::string>& all) {
  std::vector<std::pair<std::size_t, std::size_t>> gouges;  // of findings: first and last move
  for (const ClaimedResult::Finding& finding : result.findings) {
    const auto claim = result.claims.find(finding.worst_move);
    const bool is_in = finding.first_move <= finding.worst_move && finding.worst_move <= finding.last_move;
    if (!is_in || claim == result.claims.end() || claim->second.state != finding.state)
      all.push_back("it has a finding of move " + std::to_string(finding.worst_move) +
                    ", and its moves say otherwise of that move");
    if (finding.state == ClaimedState::gouge) gouges.emplace_back(finding.first_move, finding.last_move);
  }
  std::sort(gouges.begin(), gouges.end());
  std::size_t next = 0, reach = 0;  // findings begun at or before a move; where the farthest of these ends
  bool has_begun = false;
  for (const auto& [move, claim] : result.claims) {
    if (claim.state != ClaimedState::gouge) continue;
    for (; next < gouges.size() && gouges[next].first <= move; ++next, has_begun = true)
      reach = std::max(reach, gouges[next].second);
    if (!has_begun || move > reach) all.push_back("move " + std::to_string(move) + " gouges, and is in no finding");
  }
}

/// Finds impossible totals. It ignores which gouges were accepted.
std::optional<std::string> find_wrong_verdict(const ClaimedResult& result) {
  const auto total = [&](const char* state) { return result.totals.at(state); };
  const bool is_open =
      total("not_checked") > result.left_out_as_asked || total("not_certified") > 0 || !result.open_facts.empty();
  const bool may_be_accepted = result.has_baseline && total("buried") == 0;
  std::string expected = is_open ? "not-fully-checked" : "clean";
  if (total("gouge") + total("buried") > 0 && !(may_be_accepted && is_open && result.verdict == expected))
    expected = may_be_accepted && !is_open && result.verdict == "accepted-gouges" ? result.verdict : "gouges";
  if (result.verdict != expected)
    return "its verdict is '" + result.verdict + "', that of its totals '" + expected + "'";
  const std::size_t status = expected == "gouges" ? 1 : expected == "not-fully-checked" ? 4 : 0;
  if (result.exit_status == status) return std::nullopt;
  return "its exit status is " + std::to_string(result.exit_status) + ", that of its verdict " + std::to_string(status);
}

}  // namespace

std::vector<MoveClaim> ClaimedResult::claims_of(std::size_t path_moves) const {
  std::vector<MoveClaim> all(path_moves);
  for (const auto& [move, claim] : claims)
    if (move < path_moves) all[move] = claim;
  return all;
}

Result<ClaimedResult> read_claimed_result(const std::string& file, std::string_view bytes) {
  Result<JsonFile> parsed = parse_json(file, bytes, {"result-syntax", "result-duplicate-key", "the result of a check"});
  if (!parsed) return parsed.error();
  const json& root = parsed->root;
  if (!root.is_object() || root.value("format", json()) != "gougecheck-report" ||
      root.value("format_version", json()) != 1)
    return invalid(file, "it is no result of gougecheck in a version that is known");
  if (root.contains("correction") && !root.at("correction").is_null())
    return invalid(file, "it is the result of a correction; check the corrected toolpath with --json and verify that");
  JsonErrors errors{file, "result-field", &parsed->lines};
  ClaimedResult result = ResultReader(file, JsonField(root, errors)).read();
  if (errors.first) return *errors.first;
  const CheckOptions check = result.options.check;
  const std::vector<MeshLimit> limits = result.options.limits;
  const Result<JobOptions> understood = understand(result.arguments);
  if (!understood) return invalid(file, "an option in it cannot be (" + understood.error().message + ")");
  result.options = *understood;
  result.options.check = check;
  result.options.limits = limits;
  return result;
}

std::vector<std::string> find_contradictions(const ClaimedResult& result) {
  std::vector<std::string> all;
  std::array<std::size_t, kTotals.size()> counted{};
  for (const auto& [move, claim] : result.claims) {
    ++counted.at(static_cast<std::size_t>(claim.state));
    if (move >= result.moves) all.push_back("it names move " + std::to_string(move) + ", which is not there");
    if (claim.state == ClaimedState::clean)
      all.push_back("it lists move " + std::to_string(move) + " and calls it clean");
  }
  if (result.totals.count("moves named twice") != 0) all.push_back("it names a move twice");
  counted.front() = result.moves - std::min(result.moves, result.claims.size());
  for (std::size_t k = 0; k < kTotals.size(); ++k) {
    const std::size_t total = result.totals.at(kTotals.at(k));
    if (total != counted.at(k))
      all.push_back("its totals count " + std::to_string(total) + " moves as " + kStates[k] + ", its moves " +
                    std::to_string(counted.at(k)));
  }
  compare_findings(result, all);
  for (const std::string& fact : result.hidden_facts) all.push_back("it does not count as open the fact " + fact);
  if (auto wrong = find_wrong_verdict(result)) all.push_back(std::move(*wrong));
  return all;
}

}  // namespace gouge
