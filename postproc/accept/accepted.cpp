#include "postproc/accept/accepted.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "lib/base/sha256.h"
#include "lib/base/tolerance.h"
#include "lib/check/reason.h"
#include "lib/json/json_field.h"
#include "lib/path/motion_key.h"
#include "postproc/report/report_text.h"

namespace gouge {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "gougecheck-accepted";
constexpr int kVersion = 1;

Json text(const std::string& value) { return valid_utf8(value); }

Json texts(const std::vector<std::string>& values) {
  Json all = Json::array();
  for (const std::string& value : values) all.push_back(text(value));
  return all;
}

Json setup_json(const AcceptedSetup& s) {
  Json setup = {{"parts", texts(s.parts)},
                {"fixtures", texts(s.fixtures)},
                {"heads", texts(s.heads)},
                {"placement", text(s.placement)},
                {"tool", text(s.tool)},
                {"tolerance_mm", s.tolerance_mm},
                {"resolution_mm", s.resolution_mm},
                {"stock_to_leave_mm", s.stock_to_leave_mm},
                {"shank_clearance_mm", s.shank_clearance_mm},
                {"holder_clearance_mm", s.holder_clearance_mm},
                {"rapid", text(s.rapid)},
                {"limits", texts(s.limits)}};
  if (!s.law.empty()) setup["law"] = texts(s.law);
  return setup;
}

Json entry_json(const Acceptance& a) {
  Json moves = Json::array();
  for (const AcceptedMove& move : a.moves) {
    moves.push_back({{"motion", text(move.motion)},
                     {"depth_mm", move.depth_mm},
                     {"depth_upper_mm", move.depth_upper_mm},
                     {"overcut_upper_mm", move.overcut_upper_mm ? Json(*move.overcut_upper_mm) : Json(nullptr)},
                     {"passes", move.passes}});
  }
  return {{"reason", text(a.reason)},       {"by", text(a.by)},
          {"date", text(a.date)},           {"finding", text(a.finding)},
          {"toolpath", text(a.toolpath)},   {"line", a.line},
          {"statement", text(a.statement)}, {"tool", text(a.tool)},
          {"body", text(a.body)},           {"against", text(a.against)},
          {"setup", setup_json(a.setup)},   {"moves", std::move(moves)}};
}

// Writes whole numbers as such. Other programs that save the file again may write 0 for 0.0.
template <class AnyJson>
void write_whole_numbers(AnyJson& json) {
  constexpr double kMaxWhole = 1e15;  // every whole number up to it has its own double
  if (json.is_structured()) {
    for (AnyJson& part : json) write_whole_numbers(part);
  } else if (json.is_number_float()) {
    const auto value = json.template get<double>();
    if (std::abs(value) <= kMaxWhole && !(std::abs(std::trunc(value) - value) > 0))
      json = static_cast<std::int64_t>(value);
  }
}

// Returns the seal of an entry: the hash of its text without the seal. Keys are in alphabetical order, so white space,
// the order of keys and, after write_whole_numbers, the notation of numbers have no effect.
std::string seal_of(const nlohmann::json& entry) {
  return "sha256:" + sha256_of(entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

class EntryReader {
 public:
  explicit EntryReader(const JsonField& entry) : entry_(entry) {}

  Acceptance run() {
    Acceptance a;
    a.reason = word("reason");
    a.by = word("by");
    a.date = word("date");
    a.finding = word("finding");
    a.toolpath = word("toolpath");
    a.statement = entry_.at("statement").text();
    a.line = entry_.at("line").count();
    a.tool = entry_.at("tool").text();
    a.body = word("body");
    a.against = word("against");
    read_setup(entry_.at("setup"), a.setup);
    for (const JsonField& move : entry_.at("moves").list()) a.moves.push_back(read_move(move));
    if (a.moves.empty()) entry_.at("moves").fail("at least one motion");
    return a;
  }

 private:
  [[nodiscard]] std::string word(const char* key) const {
    const JsonField field = entry_.at(key);
    std::string value = field.text();
    if (value.empty()) field.fail("a text that is not empty");
    return value;
  }

  [[nodiscard]] static double length(const JsonField& field) {
    const double value = field.number();
    if (value < 0) field.fail("a length of 0 or more");
    return value;
  }

  static std::vector<std::string> texts_of(const JsonField& field) {
    std::vector<std::string> all;
    for (const JsonField& one : field.list()) all.push_back(one.text());
    return all;
  }

  static void read_setup(const JsonField& field, AcceptedSetup& s) {
    s.parts = texts_of(field.at("parts"));
    s.fixtures = texts_of(field.at("fixtures"));
    s.heads = texts_of(field.at("heads"));
    s.placement = field.at("placement").text();
    s.tool = field.at("tool").text();
    if (s.tool.empty()) field.at("tool").fail("the identity of a tool");
    s.tolerance_mm = length(field.at("tolerance_mm"));
    s.resolution_mm = length(field.at("resolution_mm"));
    s.stock_to_leave_mm = field.at("stock_to_leave_mm").number();
    s.shank_clearance_mm = length(field.at("shank_clearance_mm"));
    s.holder_clearance_mm = length(field.at("holder_clearance_mm"));
    s.rapid = field.at("rapid").text();
    if (const auto limits = field.find("limits")) s.limits = texts_of(*limits);
    if (const auto law = field.find("law")) s.law = texts_of(*law);
  }

  static AcceptedMove read_move(const JsonField& field) {
    AcceptedMove move;
    move.motion = field.at("motion").text();
    move.depth_mm = length(field.at("depth_mm"));
    move.depth_upper_mm = length(field.at("depth_upper_mm"));
    if (const JsonField overcut = field.at("overcut_upper_mm"); !overcut.is_null())
      move.overcut_upper_mm = length(overcut);
    move.passes = field.at("passes").count();
    if (move.motion.size() != kMotionDigits)
      field.at("motion").fail("a motion of " + std::to_string(kMotionDigits) + " digits");
    if (move.depth_upper_mm < move.depth_mm) field.at("depth_upper_mm").fail("no less than the depth");
    if (move.passes < 1) field.at("passes").fail("at least 1");
    return move;
  }

  JsonField entry_;
};

Diagnostic edited(const std::string& file, std::size_t line, const std::string& what) {
  return make_error(
      "accepted-edited",
      what + "; expected entries as 'gougecheck accept' wrote them; take it out, and accept the finding again", file,
      line);
}

}  // namespace

Result<std::vector<Acceptance>> read_accepted(const std::string& file, std::string_view bytes) {
  const Result<JsonFile> json =
      parse_json(file, bytes, {"accepted-syntax", "accepted-duplicate-key", "accepted findings"});
  if (!json) return json.error();
  const nlohmann::json& root = json->root;
  if (!root.is_object() || root.value("format", nlohmann::json()) != kFormat)
    return make_error("accepted-format",
                      "this is no file of accepted findings; expected what 'gougecheck accept' writes", file, 1);
  if (root.value("format_version", nlohmann::json()) != kVersion)
    return make_error("accepted-format",
                      "this file of accepted findings is of another version of the format; expected format_version " +
                          std::to_string(kVersion) + "; use the version of gougecheck that wrote it",
                      file, json->lines.at("/format_version"));
  JsonErrors errors{file, "accepted-field", &json->lines};
  std::vector<Acceptance> all;
  std::set<std::string> seals;
  const std::vector<JsonField> entries = JsonField(root, errors).at("accepted").list();
  for (std::size_t k = 0; k < entries.size(); ++k) {
    all.push_back(EntryReader(entries[k]).run());
    const std::string seal = entries[k].at("seal").text();
    if (errors.first) return *errors.first;
    nlohmann::json entry = root.at("accepted").at(k);
    entry.erase("seal");
    write_whole_numbers(entry);
    const std::size_t line = json->lines.at("/accepted/" + std::to_string(k));
    if (seal_of(entry) != seal) return edited(file, line, "this entry was changed after it was written");
    if (!seals.insert(seal).second) return edited(file, line, "this entry is there twice");
  }
  if (errors.first) return *errors.first;
  return all;
}

namespace {

Json sealed_json(const Acceptance& entry) {
  Json json = entry_json(entry);
  write_whole_numbers(json);
  json["seal"] = seal_of(json);
  return json;
}

}  // namespace

std::string write_entry(const Acceptance& entry) { return sealed_json(entry).dump(); }

std::string write_accepted(const std::vector<Acceptance>& entries) {
  Json all = Json::array();
  for (const Acceptance& entry : entries) all.push_back(sealed_json(entry));
  const Json file = {{"format", kFormat},
                     {"format_version", kVersion},
                     {"program", {{"name", kProgramName}, {"version", kProgramVersion}}},
                     {"accepted", std::move(all)}};
  return file.dump(1) + "\n";
}

std::string more_text(const std::string& reason) {
  return (is_text_of_stock_too(reason) ? "has more than this gouge: " : "leaves more open: ") + reason;
}

namespace {

class Accepter {
 public:
  Accepter(const StoredResult& result, const EventRecord& finding) : result_(result), finding_(finding) {}

  /// Returns the reason why the finding cannot be accepted; none: it can be.
  [[nodiscard]] std::optional<std::string> why_impossible() const {
    if (finding_.state == MoveState::buried)
      return "the tool is buried: there is no depth that a later one could be compared with";
    if (finding_.against == Against::stock)
      return "the tool meets remaining stock, which depends on all moves before it";
    if (!finding_.tool_index || !result_.record.tools[*finding_.tool_index].identity)
      return "its tool is not defined, so that a later one could not be compared with it";
    for (const MoveRecord* move : result_.moves_of(finding_)) {
      const double gap_mm = result_.options.resolution_mm + Tolerance::kRounding_mm;
      if (!move->depth_upper_mm || *move->depth_upper_mm > *move->depth_mm + gap_mm)
        return "the depth of move " + std::to_string(move->move) + " (line " + std::to_string(move->line) +
               ") is not certified to the resolution";
      for (const FurtherRecord& further : move->further)
        if (!further.depth_mm || !further.depth_upper_mm || *further.depth_upper_mm > *further.depth_mm + gap_mm)
          return "the depth of the " + std::string(body_name(further.body)) + " in move " + std::to_string(move->move) +
                 " (line " + std::to_string(move->line) + ") is not certified to the resolution";
      if (!move->reason.empty() && !is_text_of_limit(move->reason))
        return "move " + std::to_string(move->move) + " (line " + std::to_string(move->line) + ") " +
               more_text(move->reason);
    }
    return std::nullopt;
  }

  [[nodiscard]] Acceptance make(const AcceptanceNote& note) const {
    Acceptance made;
    made.reason = note.reason;
    made.by = note.by;
    made.date = note.date;
    made.finding = stored_finding_text(result_, finding_);
    made.toolpath = result_.record.toolpath.file;
    made.line = finding_.line;
    made.statement = result_.worst_of(finding_).statement;
    made.tool = finding_.tool;
    made.body = body_name(finding_.body);
    made.against = against_name(finding_.against);
    made.setup = setup_of(result_, *result_.record.tools[*finding_.tool_index].identity);
    const std::map<std::string, std::size_t> passes = passes_of_motions();
    for (const MoveRecord* move : result_.moves_of(finding_)) {
      AcceptedMove accepted{move->motion, *move->depth_mm, *move->depth_upper_mm, {}, passes.at(move->motion)};
      if (move->overcut_mm) accepted.overcut_upper_mm = move->overcut_upper_mm;
      made.moves.push_back(std::move(accepted));
    }
    return made;
  }

 private:
  // Returns for each motion how often it gouges, over all findings with the same state, tool, body and counterpart.
  [[nodiscard]] std::map<std::string, std::size_t> passes_of_motions() const {
    std::map<std::string, std::size_t> passes;
    for (const EventRecord& other : result_.findings) {
      const bool is_alike =
          other.state == finding_.state && other.tool_index && other.body == finding_.body &&
          other.against == finding_.against &&
          result_.record.tools[*other.tool_index].identity == result_.record.tools[*finding_.tool_index].identity;
      if (!is_alike) continue;
      for (const MoveRecord* move : result_.moves_of(other)) ++passes[move->motion];
    }
    return passes;
  }

  const StoredResult& result_;
  const EventRecord& finding_;
};

}  // namespace

Result<Acceptance> accept_finding(const StoredResult& result, std::size_t number, const AcceptanceNote& note) {
  const auto finding = std::ranges::find(result.findings, number, &EventRecord::number);
  if (finding == result.findings.end())
    return make_error("usage", "--finding '" + std::to_string(number) + "': " + result.file +
                                   " has no gouge of that number; " + "'gougecheck accept " + result.file +
                                   "' lists those that it has");
  const Accepter accepter(result, *finding);
  if (const auto why = accepter.why_impossible())
    return make_error("accept-impossible",
                      "finding " + std::to_string(number) + " cannot be accepted: " + *why + "; it stays a gouge",
                      result.file);
  return accepter.make(note);
}

}  // namespace gouge
