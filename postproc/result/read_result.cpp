#include <algorithm>
#include <iterator>

#include "lib/path/motion_key.h"
#include "postproc/record/read_record.h"
#include "postproc/record/result_digest.h"
#include "postproc/result/stored_result.h"

namespace gouge {
namespace {

bool is_finding(MoveState state) { return state == MoveState::gouge || state == MoveState::buried; }

/// Finds values of a record that contradict others, and collects its findings. `root` gives errors their place.
class RecordJudge {
 public:
  RecordJudge(const JsonField& root, const ResultRecord& record)
      : root_(root), record_(record), path_moves_(record.listed_motions()) {}

  void judge() {
    judge_motions();
    judge_runs();
    judge_moves();
    judge_events();
  }

 private:
  void judge_motions() const {
    const JsonField field = root_.at("motions");
    const std::vector<std::string>& texts = record_.motions;
    for (std::size_t k = 0; k < texts.size(); ++k) {
      const std::size_t full = kMotionsOfText * kListedDigits, size = texts[k].size();
      if (k + 1 < texts.size() ? size != full : size > full || size % kListedDigits != 0)
        return field.fail("motions of " + std::to_string(kListedDigits) + " digits, " + std::to_string(kMotionsOfText) +
                          " in each text but the last");
    }
    if (record_.toolpath.moves != path_moves_) field.fail("as many motions as the path has moves");
  }

  void judge_runs() const {
    const std::vector<RunRecord>& runs = record_.runs;
    const bool is_whole = path_moves_ == 0 || (!runs.empty() && runs.front().first_move == 0);
    if (!is_whole || !std::ranges::is_sorted(runs, {}, &RunRecord::first_move))
      root_.at("runs").fail("the runs of all moves, in their order");
  }

  void judge_moves() const {
    const std::vector<MoveRecord>& moves = record_.moves;
    const std::vector<JsonField> fields = root_.at("moves").list();
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const MoveRecord& move = moves[k];
      if (move.move >= path_moves_ || (k > 0 && moves[k - 1].move >= move.move))
        return fields[k].at("move").fail("moves of the path, in their order");
      if (move.motion.size() != kMotionDigits || !move.motion.starts_with(record_.motion(move.move)))
        return fields[k].at("motion").fail("the motion that 'motions' lists for this move");
      if (move.state == MoveState::gouge) judge_gouge(fields[k], move);
    }
  }

  static void judge_gouge(const JsonField& field, const MoveRecord& move) {
    if (!move.depth_mm) return field.at("depth").fail("the depth of a gouge");
    if (move.depth_upper_mm && *move.depth_upper_mm < *move.depth_mm)
      return field.at("depth_upper").fail("no less than the depth");
    if (move.overcut_mm && move.overcut_upper_mm && *move.overcut_upper_mm < *move.overcut_mm)
      return field.at("overcut_upper").fail("no less than the overcut");
    if (!move.witness) return field.at("witness").fail("the witness of a gouge");
    for (std::size_t k = 0; k < move.further.size(); ++k) {
      const FurtherRecord& further = move.further[k];
      if (further.depth_mm.has_value() == further.witness.has_value()) continue;
      return field.at("further").list()[k].at("witness").fail("a witness if there is a depth");
    }
  }

  void judge_events() {
    const std::vector<JsonField> fields = root_.at("events").list();
    for (std::size_t k = 0; k < fields.size(); ++k) judge_event(fields[k], record_.events[k]);
    const auto findings =
        std::ranges::count_if(record_.moves, [](const MoveRecord& move) { return is_finding(move.state); });
    if (in_findings_ != static_cast<std::size_t>(findings))
      root_.at("events").fail("every move that gouges or is buried in one of them");
  }

  void judge_event(const JsonField& field, const EventRecord& event) {
    if (event.first_move < next_move_ || event.last_move >= path_moves_)
      return field.at("first_move").fail("findings of the path, one behind the other");
    next_move_ = event.last_move + 1;
    if (!is_finding(event.state)) return;
    if (!event.number) return field.at("number").fail("the number of a finding");
    if (event.tool_index && *event.tool_index >= record_.tools.size())
      return field.at("tool_index").fail("an index into 'tools'");
    const auto first = std::ranges::lower_bound(record_.moves, event.first_move, {}, &MoveRecord::move);
    const auto end = std::ranges::upper_bound(record_.moves, event.last_move, {}, &MoveRecord::move);
    const auto is_of_it = [&](const MoveRecord& move) { return move.state == event.state; };
    if (std::none_of(first, end, [&](const MoveRecord& m) { return m.move == event.worst_move && is_of_it(m); }))
      return field.at("worst_move").fail("a move of the finding that is listed in 'moves' with its state");
    const auto moves = static_cast<std::size_t>(std::count_if(first, end, is_of_it));
    if (moves != event.moves) return field.at("moves").fail("as many as 'moves' lists of its interval and state");
    in_findings_ += moves;
  }

  JsonField root_;
  const ResultRecord& record_;
  std::size_t path_moves_;
  std::size_t next_move_ = 0;    // the first move after the events so far
  std::size_t in_findings_ = 0;  // number of moves in findings
};

StoredOptions options_of(const ResultRecord& record) {
  const OptionsRecord& o = record.options;
  StoredOptions stored{o.tolerance_mm,       o.resolution_mm,       o.stock_to_leave_mm,
                       o.shank_clearance_mm, o.holder_clearance_mm, o.rapid};
  for (const auto& [name, texts] : o.more) {
    if (name == "part" || name == "fixture") stored.limits.insert(stored.limits.end(), texts.begin(), texts.end());
    if (std::ranges::find(kLawOptions, name) == kLawOptions.end()) continue;
    for (const std::string& text : texts) stored.law.push_back(std::string(name) + "=" + text);
  }
  for (const InputFile& input : record.inputs) {
    if (input.role == "machine") stored.law.push_back(input.checksum);
  }
  std::ranges::sort(stored.limits);
  std::ranges::sort(stored.law);
  return stored;
}

/// Returns the error if the digest does not match the bytes.
std::optional<Diagnostic> find_wrong_digest(const std::string& file, std::string_view bytes) {
  switch (check_digest(bytes)) {
    case DigestState::missing:
      return make_error("result-format",
                        "this result is of an older version of gougecheck and lacks what a comparison needs; "
                        "check again",
                        file, 1);
    case DigestState::wrong:
      return make_error("result-edited",
                        "the file is not as gougecheck wrote it: its digest is of other bytes; expected the file "
                        "itself; check again",
                        file, find_json_lines(bytes).at("/digest"));
    case DigestState::right:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> find_contradiction(const std::string& file, const ReadRecord& read) {
  JsonErrors errors{file, "result-field", &read.json.lines};
  RecordJudge(JsonField(read.json.root, errors), read.record).judge();
  return errors.first;
}

Result<StoredResult> read_result(const std::string& file, std::string_view bytes) {
  Result<ReadRecord> read = read_record(file, bytes);
  const std::optional<Diagnostic> edited = find_wrong_digest(file, bytes);
  const bool is_result = read || read.error().code == "result-field";
  if (is_result && edited) return *edited;
  if (!read) return read.error();
  if (const auto wrong = find_contradiction(file, *read)) return *wrong;
  StoredResult result{file, std::move(read->record), {}, {}};
  result.options = options_of(result.record);
  std::ranges::copy_if(result.record.events, std::back_inserter(result.findings),
                       [](const EventRecord& event) { return is_finding(event.state); });
  return result;
}

}  // namespace gouge
