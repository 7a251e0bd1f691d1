#include "cli/claimed_result.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "lib/base/units.h"
#include "lib/json/json_file.h"

namespace gouge {
namespace {

using nlohmann::json;

const std::array<std::pair<const char*, ClaimedState>, 6> kStates{{{"clean", ClaimedState::clean},
                                                                   {"near", ClaimedState::near},
                                                                   {"gouge", ClaimedState::gouge},
                                                                   {"buried", ClaimedState::buried},
                                                                   {"not-checked", ClaimedState::not_checked},
                                                                   {"not-certified", ClaimedState::not_certified}}};

const char* total_of(ClaimedState state) {
  static constexpr std::array<const char*, 6> kNames{"clean",  "near",        "gouge",
                                                     "buried", "not_checked", "not_certified"};
  return kNames.at(static_cast<std::size_t>(state));
}

/// A file where the result names it, or beside the result.
std::string found_at(const std::string& name, const std::string& result_file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path beside = fs::path(result_file).parent_path() / fs::path(name);
  return !fs::exists(name, error) && fs::exists(beside, error) ? beside.string() : name;
}

class ResultReader {
 public:
  ResultReader(const std::string& file, const json& root) : file_(file), root_(root) {}

  // nlohmann's own errors (a key that lacks, a value of another kind) are caught by the caller.
  ClaimedResult read() {
    const std::string unit = root_.at("unit");
    result_.mm_per_unit = mm_per(unit_called(unit == "in" ? "inch" : unit).value_or(LengthUnit::mm));
    result_.program =
        root_.at("program").at("name").get<std::string>() + " " + root_.at("program").at("version").get<std::string>();
    read_inputs();
    read_options();
    const json& totals = root_.at("totals");
    result_.moves = totals.at("moves");
    for (const auto& [word, state] : kStates) result_.totals[total_of(state)] = totals.at(total_of(state));
    result_.totals["left_out_as_asked"] = totals.at("left_out_as_asked");
    result_.verdict = root_.at("verdict");
    for (const json& move : root_.at("moves")) read_move(move);
    for (const json& event : root_.at("events"))
      result_.findings.push_back(
          {state(event.at("state")), event.at("first_move"), event.at("last_move"), event.at("worst_move")});
    return std::move(result_);
  }

 private:
  void read_inputs() {
    JobArguments& a = result_.arguments;
    for (const json& input : root_.at("inputs")) {
      const std::string role = input.at("role");
      if (role == "baseline" || role == "project") continue;  // no verdict depends on the bytes of these
      const std::string name = found_at(input.at("name"), file_);
      result_.inputs.push_back({role, name, input.at("bytes"), input.at("checksum")});
      if (role == "toolpath") a.path = name;
      if (role == "part") a.parts.push_back(name);
      if (role == "fixture") a.fixtures.push_back(name);
      if (role == "head") a.heads.push_back(name);
      if (role == "tools") a.tools_file = name;
      if (role == "part" || role == "fixture")
        meshes_[role + " " + input.at("name").get<std::string>()] = (role == "part" ? a.parts : a.fixtures).size() - 1;
    }
  }

  void read_options() {
    const json& options = root_.at("options");
    CheckOptions& check = result_.options.check;
    check.tolerance_mm = length(options.at("tolerance"));
    check.resolution_mm = length(options.at("resolution"));
    check.stock_to_leave_mm = length(options.at("stock_to_leave"));
    check.shank_clearance_mm = length(options.at("shank_clearance"));
    check.holder_clearance_mm = length(options.at("holder_clearance"));
    check.near_miss_mm = length(options.at("near_miss"));
    JobArguments& a = result_.arguments;
    a.rapid = options.at("rapid");
    check.rapid = a.rapid == "skip" ? RapidMode::skip : a.rapid == "dogleg" ? RapidMode::dogleg : RapidMode::straight;
    const json& more = options.at("more");
    a.place = more.value("place", "");
    a.stl_units = more.value("stl-units", "");
    a.reading = {more.value("dialect", ""), more.value("toolpath-units", ""), more.value("cutcom", "")};
    a.holder = more.value("holder", "");
    a.is_extended_up = more.contains("extend-up");
    if (!more.contains("tool")) return;
    const json& tools = more.at("tool");
    if (tools.is_array())
      a.tool_names = tools.get<std::vector<std::string>>();
    else
      a.tool_names = {tools.get<std::string>()};
  }

  [[nodiscard]] static ClaimedState state(const std::string& word) {
    const auto* const known =
        std::find_if(kStates.begin(), kStates.end(), [&](const auto& state) { return word == state.first; });
    return known == kStates.end() ? ClaimedState::not_checked : known->second;
  }

  void read_move(const json& move) {
    MoveClaim claim;
    claim.state = state(move.at("state"));
    if (move.at("depth").is_number()) claim.depth_mm = length(move.at("depth"));
    if (move.at("depth_upper").is_number()) claim.depth_upper_mm = length(move.at("depth_upper"));
    if (move.at("clearance").is_number()) claim.clearance_mm = length(move.at("clearance"));
    if (move.at("witness").is_object()) claim.witness = witness(move.at("witness"));
    const std::size_t index = move.at("move");
    result_.lines[index] = move.at("line");
    if (!result_.claims.emplace(index, claim).second) result_.totals["moves named twice"]++;
  }

  [[nodiscard]] ClaimedWitness witness(const json& w) const {
    ClaimedWitness read;
    read.t = w.at("t");
    read.point = vector(w.at("point")) * result_.mm_per_unit;
    read.normal = vector(w.at("normal"));
    const std::string body = w.at("body"), against = w.at("against");
    for (const Body named : {Body::cutter, Body::shank, Body::holder, Body::head})
      if (body == body_name(named)) read.body = named;
    read.is_fixture = against == "fixture";
    const auto mesh = meshes_.find(against + " " + w.at("mesh").get<std::string>());
    read.mesh = mesh == meshes_.end() ? static_cast<std::size_t>(-1) : mesh->second;
    read.triangle = w.at("triangle");
    return read;
  }

  [[nodiscard]] static Vec3 vector(const json& v) {
    return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
  }
  [[nodiscard]] double length(const json& value) const { return value.get<double>() * result_.mm_per_unit; }

  const std::string& file_;
  const json& root_;
  std::map<std::string, std::size_t> meshes_;  // by role and name: which of its kind
  ClaimedResult result_;
};

/// Findings and moves must tell the same: every gouge is in a finding, and a finding's worst move is as it says.
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

/// The verdict and the totals: "clean" is a word for results where nothing else was found or left open.
void compare_verdict(const ClaimedResult& result, std::vector<std::string>& all) {
  const auto& n = result.totals;
  const bool has_gouges = n.at("gouge") + n.at("buried") > 0;
  const bool is_complete = n.at("not_certified") == 0 && n.at("not_checked") <= n.at("left_out_as_asked");
  const bool names_gouges = result.verdict == "gouges" || result.verdict == "accepted-gouges";
  if (has_gouges != names_gouges || (result.verdict == "clean" && !is_complete))
    all.emplace_back("its verdict says other than its totals");
}

Diagnostic invalid(const std::string& file, const std::string& found) {
  return make_error("result-invalid", found + "; expected the JSON of 'gougecheck check --json'", file);
}

}  // namespace

std::vector<MoveClaim> ClaimedResult::all_claims() const {
  std::vector<MoveClaim> all(moves);
  for (const auto& [move, claim] : claims)
    if (move < moves) all[move] = claim;
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
  ClaimedResult result;
  try {
    result = ResultReader(file, root).read();
  } catch (const json::exception& error) {
    return invalid(file, std::string("something in it is missing or of another kind (") + error.what() + ")");
  }
  const CheckOptions check = result.options.check;
  const Result<JobOptions> understood = understand(result.arguments);
  if (!understood) return invalid(file, "an option in it cannot be (" + understood.error().message + ")");
  result.options = *understood;
  result.options.check = check;
  return result;
}

std::vector<std::string> find_contradictions(const ClaimedResult& result) {
  std::vector<std::string> all;
  std::map<std::string, std::size_t> counted;
  for (const auto& [move, claim] : result.claims) {
    ++counted[total_of(claim.state)];
    if (move >= result.moves) all.push_back("it names move " + std::to_string(move) + ", which is not there");
    if (claim.state == ClaimedState::clean)
      all.push_back("it lists move " + std::to_string(move) + " and calls it clean");
  }
  if (result.totals.count("moves named twice") != 0) all.push_back("it names a move twice");
  counted["clean"] = result.moves - std::min(result.moves, result.claims.size());
  for (const auto& [word, state] : kStates) {
    const std::string key = total_of(state);
    if (result.totals.at(key) != counted[key])
      all.push_back("its totals count " + std::to_string(result.totals.at(key)) + " moves as " + word + ", its moves " +
                    std::to_string(counted[key]));
  }
  compare_findings(result, all);
  compare_verdict(result, all);
  return all;
}

}  // namespace gouge
