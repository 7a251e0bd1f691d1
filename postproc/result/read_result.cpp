#include <algorithm>
#include <cmath>

#include "lib/json/json_field.h"
#include "lib/path/motion_key.h"
#include "postproc/report/identity_json.h"
#include "postproc/report/motion_list.h"
#include "postproc/result/stored_result.h"

namespace gouge {
namespace {

const std::vector<std::string>& states() {
  static const std::vector<std::string> kStates = {"clean", "near", "gouge", "buried", "not-checked", "not-certified"};
  return kStates;
}
const std::vector<std::string>& bodies() {
  static const std::vector<std::string> kBodies = {"cutter", "shank", "holder", "head"};
  return kBodies;
}

class ResultReader {
 public:
  explicit ResultReader(const JsonField& root) : root_(root) {}

  StoredResult run() {
    result_.version = root_.at("program").at("version").text();
    result_.verdict = root_.at("verdict").text();
    if (root_.at("unit").word({"mm", "in"}) == 1) result_.unit = LengthUnit::inch;
    scale_ = mm_per(result_.unit);
    result_.placement = root_.at("placement").text();
    result_.toolpath = root_.at("toolpath").at("file").text();
    result_.left_out_as_asked = root_.at("totals").at("left_out_as_asked").count();
    read_options(root_.at("options"));
    for (const JsonField& input : root_.at("inputs").list())
      result_.inputs.push_back({input.at("role").text(), input.at("name").text(), input.at("checksum").text()});
    for (const StoredInput& input : result_.inputs) {
      if (input.role == "machine") result_.options.law.push_back(input.checksum);
    }
    std::ranges::sort(result_.options.law);
    for (const JsonField& tool : root_.at("tools").list()) read_tool(tool);
    for (const JsonField& motions : root_.at("motions").list()) read_motions(motions);
    if (root_.at("toolpath").at("moves").count() != result_.motions.size())
      root_.at("motions").fail("as many motions as the path has moves");
    for (const JsonField& run : root_.at("runs").list())
      result_.runs.push_back({run.at("first_move").count(), run.at("operation").text(), run.at("tool").text()});
    const bool is_whole = result_.motions.empty() || (!result_.runs.empty() && result_.runs.front().first_move == 0);
    if (!is_whole || !std::ranges::is_sorted(result_.runs, {}, &StoredRun::first_move))
      root_.at("runs").fail("the runs of all moves, in their order");
    for (const JsonField& move : root_.at("moves").list()) read_move(move);
    for (const JsonField& event : root_.at("events").list()) read_event(event);
    const auto is_of_finding = [](const StoredMove& m) {
      return m.state == MoveState::gouge || m.state == MoveState::buried;
    };
    if (in_findings_ != static_cast<std::size_t>(std::ranges::count_if(result_.moves, is_of_finding)))
      root_.at("events").fail("every move that gouges or is buried in one of them");
    return std::move(result_);
  }

 private:
  [[nodiscard]] double length(const JsonField& field) const { return field.number() * scale_; }
  [[nodiscard]] std::optional<double> length_or_null(const JsonField& field) const {
    const std::optional<double> value = field.number_or_null();
    if (value && *value < 0) field.fail("a length of 0 or more");
    return value ? std::optional(*value * scale_) : std::nullopt;
  }

  void read_options(const JsonField& options) {
    StoredOptions& o = result_.options;
    o.tolerance_mm = length(options.at("tolerance"));
    o.resolution_mm = length(options.at("resolution"));
    o.stock_to_leave_mm = length(options.at("stock_to_leave"));
    o.shank_clearance_mm = length(options.at("shank_clearance"));
    o.holder_clearance_mm = length(options.at("holder_clearance"));
    o.rapid = options.at("rapid").text();
    const std::optional<JsonField> more = options.find("more");
    for (const char* option : {"part", "fixture"})
      if (more) read_limits(*more, option);
    std::ranges::sort(o.limits);
    for (const char* option : kLawOptions) {
      if (const auto value = more ? more->find(option) : std::nullopt)
        o.law.push_back(std::string(option) + "=" + value->text());
    }
  }

  // One is a text, several are a list.
  void read_limits(const JsonField& more, const char* option) {
    const std::optional<JsonField> value = more.find(option);
    if (!value) return;
    if (value->is_text()) return result_.options.limits.push_back(value->text());
    for (const JsonField& text : value->list()) result_.options.limits.push_back(text.text());
  }

  void read_tool(const JsonField& tool) {
    StoredTool stored{tool.at("key").text(), {}, {}};
    if (const JsonField identity = tool.at("identity"); !identity.is_null()) stored.identity = identity.text();
    for (const JsonField& body : tool.at("bodies").list()) stored.bodies.push_back(bodies()[body.word(bodies())]);
    result_.tools.push_back(std::move(stored));
  }

  void read_motions(const JsonField& field) {
    const std::string text = field.text();
    if (text.size() % kListedDigits != 0) return field.fail("motions of " + std::to_string(kListedDigits) + " digits");
    for (std::size_t at = 0; at < text.size(); at += kListedDigits)
      result_.motions.push_back(text.substr(at, kListedDigits));
  }

  void read_move(const JsonField& field) {
    StoredMove move;
    move.move = field.at("move").count();
    move.line = field.at("line").count();
    move.state = static_cast<MoveState>(field.at("state").word(states()));
    move.kind = field.at("kind").text();
    move.tool = field.at("tool").text();
    move.operation = field.at("operation").text();
    move.statement = field.at("statement").text();
    move.motion = field.at("motion").text();
    move.depth_mm = length_or_null(field.at("depth"));
    move.depth_upper_mm = length_or_null(field.at("depth_upper"));
    move.overcut_mm = length_or_null(field.at("overcut"));
    move.overcut_upper_mm = length_or_null(field.at("overcut_upper"));
    move.reason = field.at("reason").text();
    if (const JsonField witness = field.at("witness"); !witness.is_null()) move.witness = read_witness(witness);
    if (move.move >= result_.motions.size() || (!result_.moves.empty() && result_.moves.back().move >= move.move))
      return field.at("move").fail("moves of the path, in their order");
    if (move.motion.size() != kMotionDigits || !move.motion.starts_with(result_.motions[move.move]))
      return field.at("motion").fail("the motion that 'motions' lists for this move");
    if (move.state == MoveState::gouge) judge_gouge(field, move);
    result_.moves.push_back(std::move(move));
  }

  static void judge_gouge(const JsonField& field, const StoredMove& move) {
    if (!move.depth_mm) return field.at("depth").fail("the depth of a gouge");
    if (move.depth_upper_mm && *move.depth_upper_mm < *move.depth_mm)
      return field.at("depth_upper").fail("no less than the depth");
    if (move.overcut_mm && move.overcut_upper_mm && *move.overcut_upper_mm < *move.overcut_mm)
      return field.at("overcut_upper").fail("no less than the overcut");
    if (!move.witness) field.at("witness").fail("the witness of a gouge");
  }

  [[nodiscard]] StoredWitness read_witness(const JsonField& field) const {
    StoredWitness witness;
    witness.t = field.at("t").number();
    witness.body = bodies()[field.at("body").word(bodies())];
    witness.against = field.at("against").text();
    witness.mesh = field.at("mesh").text();
    const std::vector<JsonField> point = field.at("point").list();
    if (point.size() != 3) {
      field.at("point").fail("three coordinates");
      return witness;
    }
    for (int k = 0; k < 3; ++k) witness.point[k] = length(point[static_cast<std::size_t>(k)]);
    return witness;
  }

  void read_event(const JsonField& field) {
    StoredFinding finding;
    finding.state = static_cast<MoveState>(field.at("state").word(states()));
    finding.first_move = field.at("first_move").count();
    finding.last_move = field.at("last_move").count();
    if (finding.first_move < next_move_ || finding.last_move >= result_.motions.size())
      return field.at("first_move").fail("findings of the path, one behind the other");
    next_move_ = finding.last_move + 1;
    if (finding.state != MoveState::gouge && finding.state != MoveState::buried) return;
    finding.number = field.at("number").count();
    finding.worst_move = field.at("worst_move").count();
    finding.line = field.at("line").count();
    finding.tool = field.at("tool").text();
    finding.body = bodies()[field.at("body").word(bodies())];
    finding.against = field.at("against").text();
    if (const JsonField tool = field.at("tool_index"); !tool.is_null()) {
      finding.tool_index = tool.count();
      if (*finding.tool_index >= result_.tools.size()) tool.fail("an index into 'tools'");
    }
    const StoredMove* worst = result_.find_move(finding.worst_move);
    const bool is_inside = finding.first_move <= finding.worst_move && finding.worst_move <= finding.last_move;
    if (!is_inside || worst == nullptr || worst->state != finding.state)
      return field.at("worst_move").fail("a move of the finding that is listed in 'moves' with its state");
    const std::size_t moves = result_.moves_of(finding).size();
    if (moves != field.at("moves").count())
      return field.at("moves").fail("as many as 'moves' lists of its interval and state");
    in_findings_ += moves;
    result_.findings.push_back(std::move(finding));
  }

  JsonField root_;
  StoredResult result_;
  std::size_t next_move_ = 0;    // behind the findings so far
  std::size_t in_findings_ = 0;  // moves
  double scale_ = 1;
};

Diagnostic not_ours(const std::string& file) {
  return make_error("result-format",
                    "this is not a result of gougecheck; expected what 'gougecheck check --json FILE' writes", file, 1);
}

}  // namespace

Result<StoredResult> read_result(const std::string& file, std::string_view bytes) {
  const Result<JsonFile> json =
      parse_json(file, bytes, {"result-syntax", "result-duplicate-key", "a result of gougecheck"});
  if (!json) return json.error();
  const nlohmann::json& root = json->root;
  if (!root.is_object() || root.value("format", nlohmann::json()) != "gougecheck-report") return not_ours(file);
  if (root.value("format_version", nlohmann::json()) != 1)
    return make_error("result-format",
                      "this result is of another version of the format; expected format_version 1; check again", file,
                      json->lines.at("/format_version"));
  switch (check_digest(bytes)) {
    case DigestState::missing:
      return make_error("result-format",
                        "this result is of an older version of gougecheck, which does not say what a comparison needs; "
                        "check again",
                        file, 1);
    case DigestState::wrong:
      return make_error(
          "result-edited",
          "the file is not as gougecheck wrote it: its digest is of other bytes; expected the file itself; "
          "check again",
          file, json->lines.at("/digest"));
    case DigestState::right:
      break;
  }
  JsonErrors errors{file, "result-field", &json->lines};
  StoredResult result = ResultReader(JsonField(root, errors)).run();
  if (errors.first) return *errors.first;
  result.file = file;
  return result;
}

}  // namespace gouge
