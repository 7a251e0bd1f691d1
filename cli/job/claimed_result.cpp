#include "cli/job/claimed_result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "cli/job/claimed_scene.h"
#include "cli/options/job_options.h"
#include "cli/options/joint_options.h"
#include "cli/options/option_table.h"
#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/base/units.h"
#include "postproc/record/read_record.h"
#include "postproc/record/words.h"
#include "postproc/result/stored_result.h"

namespace gouge {
namespace {

/// Returns the name of a file as stated by the result, or its place in the folder of the result or in one above it if only
/// that exists. Behind a symbolic link these folders are those of the name as typed, then those of its target.
std::string found_at(const std::string& name, const std::string& result_file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(name, error)) return name;
  for (const fs::path& result : {fs::absolute(result_file, error), fs::weakly_canonical(result_file, error)}) {
    for (fs::path folder = result.parent_path();; folder = folder.parent_path()) {
      const fs::path there = folder / fs::path(name);
      if (fs::exists(there, error)) return there.string();
      if (folder == folder.parent_path()) break;
    }
  }
  return name;
}

/// Takes from a record the data that a verification needs. `root` gives errors their place.
class ClaimTaker {
 public:
  ClaimTaker(const std::string& file, const JsonField& root, const ResultRecord& record)
      : file_(file), root_(root), record_(record) {}

  // Returns the claims. After the first error, which `root` keeps, they mean nothing.
  ClaimedResult take() {
    result_.mm_per_unit = mm_per(record_.unit);
    result_.program = std::string(kProgramName) + " " + record_.program.version;
    result_.verdict = record_.verdict;
    result_.exit_status = record_.exit_status;
    result_.has_baseline = record_.baseline.has_value();
    if (record_.excess) take_excess(*record_.excess);
    for (const Assumption& fact : record_.assumptions) take_fact(fact);
    const std::vector<JsonField> inputs = root_.at("inputs").list();
    for (std::size_t k = 0; k < record_.inputs.size(); ++k) take_input(inputs[k], record_.inputs[k]);
    result_.not_recorded = first_not_recorded();
    if (result_.not_recorded.empty()) result_.not_recorded = stock_not_recorded();
    take_options(record_.options);
    if (result_.arguments.has_warnings_as_errors) take_warnings();
    result_.totals = record_.totals;
    for (const MoveRecord& move : record_.moves) take_move(move);
    for (const EventRecord& event : record_.events)
      result_.findings.push_back({claimed_state(event.state), event.first_move, event.last_move, event.worst_move});
    return std::move(result_);
  }

 private:
  /// The library, also in Python, checks meshes and tools that are in memory, and records no file of them.
  [[nodiscard]] std::string first_not_recorded() const {
    if (result_.arguments.path.empty()) return "toolpath";
    if (record_.baseline && result_.arguments.baseline_file.empty()) return "baseline";
    if (record_.parts.size() > named_parts_.size()) return "part " + record_.parts[named_parts_.size()].name;
    if (record_.fixtures.size() > named_fixtures_.size())
      return "fixture " + record_.fixtures[named_fixtures_.size()].name;
    const auto is_recorded = [&](const ToolRecord& tool) {
      return tool.defined_in.empty() || std::ranges::any_of(record_.inputs, [&](const InputFile& input) {
               return tool.defined_in == input.name || tool.defined_in.starts_with(input.name + ":");
             });
    };
    const auto other = std::ranges::find_if_not(record_.tools, is_recorded);
    return other == record_.tools.end() ? std::string() : "tool " + other->name;
  }

  /// Returns the stock, or the program before the path, whose file the result does not name.
  [[nodiscard]] std::string stock_not_recorded() const {
    for (const std::string& name : all_given("stock"))
      if (names_stock_file(name) && stock_file_.empty()) return "stock " + name;
    for (const std::string& typed : all_given("before")) {
      const BeforeText before = split_before(typed);
      if (!found_.contains(before.path)) return "program " + before.path + " before it";
      if (!before.tools.empty() && !found_.contains(before.tools)) return "tools of the program " + before.path;
    }
    return {};
  }

  void take_fact(const Assumption& fact) {
    const std::string name = subject_name(fact.subject);
    if (fact.is_open) {
      result_.open_facts.push_back(name);
    } else if (fact.basis == Basis::contradicted || fact.basis == Basis::unknown) {
      result_.hidden_facts.push_back(name + " (" + basis_name(fact.basis) + ")");
    }
  }

  void take_excess(const ExcessRecord& excess) {
    result_.has_excess = true;
    for (const ExcessPlaceRecord& place : excess.places)
      (place.height_mm ? result_.has_material_left : result_.is_material_open) = true;
  }

  // Adds warnings to the open facts. With --warnings-as-errors a warning keeps the verdict open like an open fact.
  void take_warnings() {
    for (const Diagnostic& note : record_.notes) {
      if (note.severity == Severity::warning) result_.open_facts.emplace_back("warnings");
    }
  }

  void take_input(const JsonField& field, const InputFile& input) {
    JobArguments& a = result_.arguments;
    const std::string& role = input.role;
    if (input.name.empty() || input.name.find('\0') != std::string::npos) field.at("name").fail("the name of a file");
    const std::string name = found_at(input.name, file_);
    const bool is_beside = role == "baseline" || role == "project";
    (is_beside ? result_.beside_inputs : result_.inputs).push_back({role, name, input.bytes, input.checksum});
    if (is_beside) {
      if (role == "baseline") a.baseline_file = name;
      return;
    }
    found_inputs_[input.name] = name;
    if (role == "toolpath") a.path = name;
    if (role == "part") a.parts.push_back(name);
    if (role == "fixture") a.fixtures.push_back(name);
    if (role == "head") a.heads.push_back(name);
    if (role == "tools") a.tools_file = name;
    if (role == "machine") a.machine = name;
    if (role == "stock") stock_file_ = name;
    if (role == "before" || role == "before-tools") found_[input.name] = name;
    if (role == "part") named_parts_.push_back(input.name);
    if (role == "fixture") named_fixtures_.push_back(input.name);
    if (role == "part" || role == "fixture")
      meshes_[role + " " + input.name] = (role == "part" ? a.parts : a.fixtures).size() - 1;
  }

  void take_options(const OptionsRecord& options) {
    CheckOptions& check = result_.options.check;
    check.tolerance_mm = options.tolerance_mm;
    check.resolution_mm = options.resolution_mm;
    check.stock_to_leave_mm = options.stock_to_leave_mm;
    check.shank_clearance_mm = options.shank_clearance_mm;
    check.holder_clearance_mm = options.holder_clearance_mm;
    check.near_miss_mm = options.near_miss_mm;
    JobArguments& a = result_.arguments;
    a.rapid = options.rapid;
    check.law = rapid_called(options.rapid).value_or(RapidMode::straight);
    const auto given = [&](const std::string& key, bool is_repeatable) {
      std::vector<std::string> texts = all_given(key);
      if (!is_repeatable && texts.size() > 1) root_.at("options").at("more").at(key).fail("one text");
      return texts;
    };
    repeat_options<ReadingArguments>(a.reading, reading_options(), given);
    const std::string machine = a.machine;
    repeat_options(a, job_options(), given);
    repeat_options(a.joints, joint_options(), given);
    if (!machine.empty()) a.machine = machine;
    for (std::string& assumed : a.assumed) assumed = at_found_object(assumed);
    take_stock(given);
    take_limits("part", Against::part, named_parts_);
    take_limits("fixture", Against::fixture, named_fixtures_);
  }

  /// Returns a fact of --assume whose object is named as the file of an input was found.
  [[nodiscard]] std::string at_found_object(const std::string& assumed) const {
    const std::size_t object = assumed.find('=') + 1;
    const auto found = found_inputs_.find(assumed.substr(object));
    return object == 0 || found == found_inputs_.end() ? assumed : assumed.substr(0, object) + found->second;
  }

  template <typename Given>
  void take_stock(const Given& given) {
    JobArguments& a = result_.arguments;
    repeat_options(a, stock_options(), given);
    repeat_options(a, left_stock_options(), given);
    if (a.stock.empty() == record_.stock.has_value()) root_.at("stock").fail("a check of the stock of its options");
    if (names_stock_file(a.stock)) a.stock = stock_file_;
    const auto found = [&](const std::string& name) {
      const auto at = found_.find(name);
      return at == found_.end() ? name : at->second;
    };
    for (std::string& typed : a.before) {
      BeforeText before = split_before(typed);
      before.path = found(before.path);
      before.tools = found(before.tools);
      typed = before.typed();
    }
    if (const auto wrong = find_wrong_stock(a)) root_.at("options").at("more").at("stock").fail(wrong->message);
  }

  void take_limits(const char* option, Against against, const std::vector<std::string>& named) {
    const auto fail = [&](const char* expected) { root_.at("options").at("more").at(option).fail(expected); };
    std::vector<std::string> files;
    LimitTexts texts;
    split_limits(all_given(option), files, texts);
    const Result<std::vector<MeshLimit>> limits =
        understand_limits("--" + std::string(option), against, named, texts, result_.options.check.tolerance_mm);
    if (!limits) return fail("limits of the files that are named");
    std::vector<MeshLimit>& all = result_.options.limits;
    all.insert(all.end(), limits->begin(), limits->end());
    if (limits->size() != texts.size()) fail("a file that is named among the inputs");
  }

  [[nodiscard]] std::vector<std::string> all_given(const std::string& option) const {
    const OptionTexts& more = record_.options.more;
    const auto found = std::ranges::find(more, option, [](const auto& one) { return one.first; });
    return found == more.end() ? std::vector<std::string>() : found->second;
  }

  void take_move(const MoveRecord& move) {
    MoveClaim claim;
    claim.state = claimed_state(move.state);
    claim.depth_mm = move.depth_mm.value_or(0);
    claim.depth_upper_mm = move.depth_upper_mm;
    claim.clearance_mm = move.clearance_mm;
    if (move.witness) claim.witness = witness(*move.witness);
    for (const FurtherRecord& further : move.further) {
      FurtherClaim& one = claim.further.emplace_back();
      one.body = further.body;
      one.is_fixture = further.against == Against::fixture;
      one.is_stock = further.against == Against::stock;
      one.depth_mm = further.depth_mm.value_or(0);
      one.depth_upper_mm = further.depth_upper_mm;
      if (further.witness) one.witness = witness(*further.witness);
    }
    result_.largest_overcut_mm = std::max(result_.largest_overcut_mm, move.overcut_mm.value_or(0));
    if (!result_.claims.emplace(move.move, claim).second) result_.names_a_move_twice = true;
  }

  [[nodiscard]] ClaimedWitness witness(const WitnessRecord& w) const {
    ClaimedWitness claimed;
    claimed.t = w.t;
    claimed.point = w.point_mm;
    claimed.normal = w.normal;
    claimed.body = w.body;
    claimed.is_fixture = w.against == Against::fixture;
    claimed.is_stock = w.against == Against::stock;
    const auto mesh = meshes_.find(std::string(against_name(w.against)) + " " + w.mesh);
    claimed.mesh = mesh == meshes_.end() ? static_cast<std::size_t>(-1) : mesh->second;
    claimed.triangle = w.triangle;
    if (w.turn) claimed.turn = {w.turn->first, w.turn->second};
    return claimed;
  }

  const std::string& file_;
  JsonField root_;
  const ResultRecord& record_;
  std::vector<std::string> named_parts_, named_fixtures_;
  std::string stock_file_;
  std::map<std::string, std::string> found_;         // names of earlier programs and their tools: where they were found
  std::map<std::string, std::string> found_inputs_;  // the same of all inputs
  std::map<std::string, std::size_t> meshes_;        // by role and name: its index among the meshes of its kind
  ClaimedResult result_;
};

Diagnostic invalid(const std::string& file, const std::string& found) {
  return make_error("result-invalid", found + "; expected the JSON of 'gougecheck check --json'", file);
}

/// Compares findings and moves. Every gouge must be in a finding, and the worst move of a finding must have its state.
void compare_findings(const ClaimedResult& result, std::vector<std::string>& all) {
  std::vector<std::pair<std::size_t, std::size_t>> gouges;  // first and last moves of the findings of gouges
  for (const ClaimedResult::Finding& finding : result.findings) {
    const auto claim = result.claims.find(finding.worst_move);
    const bool is_in = finding.first_move <= finding.worst_move && finding.worst_move <= finding.last_move;
    if (!is_in || claim == result.claims.end() || claim->second.state != finding.state)
      all.push_back("it has a finding of move " + std::to_string(finding.worst_move) +
                    ", and its moves say otherwise of that move");
    if (finding.state == ClaimedState::gouge) gouges.emplace_back(finding.first_move, finding.last_move);
  }
  std::sort(gouges.begin(), gouges.end());
  // number of findings that begin at or before the move; the largest last move of these
  std::size_t next = 0, reach = 0;
  bool has_begun = false;
  for (const auto& [move, claim] : result.claims) {
    if (claim.state != ClaimedState::gouge) continue;
    for (; next < gouges.size() && gouges[next].first <= move; ++next, has_begun = true)
      reach = std::max(reach, gouges[next].second);
    if (!has_begun || move > reach) all.push_back("move " + std::to_string(move) + " gouges, and is in no finding");
  }
}

/// Finds a verdict that contradicts the totals. It ignores which gouges were accepted.
std::optional<std::string> find_wrong_verdict(const ClaimedResult& result) {
  const TotalsRecord& total = result.totals;
  const bool is_open = total.not_checked > total.left_out_as_asked || total.not_certified > 0 ||
                       !result.open_facts.empty() || result.is_material_open;
  const bool may_be_accepted = result.has_baseline && total.buried == 0;
  std::string expected = result.has_material_left ? "material-left" : is_open ? "not-fully-checked" : "clean";
  const bool is_settled = !is_open && !result.has_material_left;
  if (total.gouge + total.buried > 0 && !(may_be_accepted && !is_settled && result.verdict == expected))
    expected = may_be_accepted && is_settled && result.verdict == "accepted-gouges" ? result.verdict : "gouges";
  if (result.verdict != expected)
    return "its verdict is '" + result.verdict + "', that of its totals '" + expected + "'";
  const int status = expected == "gouges" || expected == "material-left" ? 1 : expected == "not-fully-checked" ? 4 : 0;
  if (result.exit_status == status) return std::nullopt;
  return "its exit status is " + std::to_string(result.exit_status) + ", that of its verdict " + std::to_string(status);
}

/// Compares the largest value of the totals with that of the moves. Both are in the unit of the file there.
void compare_largest(const char* what, double total_mm, double of_moves_mm, std::vector<std::string>& all) {
  if (std::abs(total_mm - of_moves_mm) <= Tolerance::kFewRoundings * std::max(total_mm, of_moves_mm)) return;
  all.push_back(std::string("its totals state the largest ") + what + " as " + exact_text(total_mm) +
                " mm, its moves as " + exact_text(of_moves_mm) + " mm");
}

/// Finds a file that is not as it was written.
std::optional<std::string> find_wrong_digest(DigestState digest) {
  if (digest == DigestState::right) return std::nullopt;
  if (digest == DigestState::missing) return "it has no digest, with which gougecheck ends each result";
  return "its digest is of other bytes: it was changed after gougecheck wrote it";
}

/// Compares the totals with the listed moves.
void compare_totals(const ClaimedResult& result, std::vector<std::string>& all) {
  const TotalsRecord& t = result.totals;
  const std::array totals = {t.clean, t.near, t.gouge, t.buried, t.not_checked, t.not_certified};
  std::array<std::size_t, totals.size()> counted{};
  for (const auto& [move, claim] : result.claims) ++counted.at(static_cast<std::size_t>(claim.state));
  counted.front() = t.moves - std::min(t.moves, result.claims.size());
  for (std::size_t k = 0; k < totals.size(); ++k) {
    if (totals.at(k) != counted.at(k))
      all.push_back("its totals count " + std::to_string(totals.at(k)) + " moves as " + state_words()[k] +
                    ", its moves " + std::to_string(counted.at(k)));
  }
  double depth_mm = 0;
  for (const auto& [move, claim] : result.claims)
    if (claim.state == ClaimedState::gouge) depth_mm = std::max(depth_mm, claim.depth_mm);
  compare_largest("depth", t.worst_depth_mm, depth_mm, all);
  compare_largest("overcut", t.worst_overcut_mm, result.largest_overcut_mm, all);
}

}  // namespace

std::vector<MoveClaim> ClaimedResult::claims_of(std::size_t path_moves) const {
  std::vector<MoveClaim> all(path_moves);
  for (const auto& [move, claim] : claims)
    if (move < path_moves) all[move] = claim;
  return all;
}

Result<ClaimedResult> read_claimed_result(const std::string& file, std::string_view bytes) {
  Result<ReadRecord> read = read_record(file, bytes);
  if (!read && read.error().code == "result-format")
    return invalid(file, "it is no result of gougecheck in a version that is known");
  if (!read) return read.error();
  if (read->record.correction)
    return invalid(file, "it is the result of a correction; check the corrected toolpath with --json and verify that");
  JsonErrors errors{file, "result-field", &read->json.lines};
  ClaimedResult result = ClaimTaker(file, JsonField(read->json.root, errors), read->record).take();
  if (errors.first) return *errors.first;
  result.digest = check_digest(bytes);
  if (const auto wrong = find_contradiction(file, *read))
    result.malformed = "line " + std::to_string(wrong->line) + " contradicts another: " + wrong->message;
  CheckOptions check = result.options.check;
  const std::vector<MeshLimit> limits = result.options.limits;
  const Result<JobOptions> understood = understand(result.arguments);
  if (!understood) return invalid(file, "an option in it cannot be (" + understood.error().message + ")");
  check.tube = understood->check.tube;
  result.options = *understood;
  result.options.check = check;
  result.options.limits = limits;
  result.record = std::move(read->record);
  return result;
}

std::vector<std::string> find_contradictions(const ClaimedResult& result) {
  std::vector<std::string> all;
  if (auto wrong = find_wrong_digest(result.digest)) all.push_back(std::move(*wrong));
  for (const auto& [move, claim] : result.claims) {
    if (move >= result.totals.moves) all.push_back("it names move " + std::to_string(move) + ", which is not there");
    if (claim.state == ClaimedState::clean)
      all.push_back("it lists move " + std::to_string(move) + " and calls it clean");
  }
  if (!result.malformed.empty()) all.push_back(result.malformed);
  if (result.names_a_move_twice) all.push_back("it names a move twice");
  compare_totals(result, all);
  compare_findings(result, all);
  for (const std::string& fact : result.hidden_facts) all.push_back("it does not count as open the fact " + fact);
  if (auto wrong = find_wrong_verdict(result)) all.push_back(std::move(*wrong));
  return all;
}

}  // namespace gouge
