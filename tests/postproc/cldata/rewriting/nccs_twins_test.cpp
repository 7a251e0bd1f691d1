// Random NCL programs, written as ASCII and as binary records: read, they are the same moves; corrected in the same
// way, they still are.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/path/chords.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/formats/write_corrected.h"
#include "tests/postproc/cldata/nccs_file.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/postproc/cldata/same_moves.h"
#include "tests/support/scatter.h"

namespace gouge::nccs_twins_test {
namespace {

// One program in two forms.
class Twins {
 public:
  explicit Twins(std::uint64_t seed) : random_(seed) {
    multax(true);
    go_to(1);
    const int steps = 3 + static_cast<int>(random_.next() % 20);
    for (int i = 0; i < steps; ++i) step();
  }

  [[nodiscard]] std::string bytes() const { return file_.bytes(); }
  [[nodiscard]] Toolpath binary() const { return path_of(bytes()); }
  [[nodiscard]] Toolpath text() const { return path_of("REMARK a.as NCLCAM 2019.00\n" + text_ + "FINI\n"); }
  [[nodiscard]] const std::string& shown() const { return text_; }

 private:
  std::size_t pick(std::size_t count) { return random_.next() % count; }
  // Four decimals, so that both forms hold the same numbers.
  double number() { return static_cast<double>(static_cast<int>(pick(400001)) - 200000) / 1e4; }

  void say(std::uint16_t code, const std::vector<NccsFile::Argument>& binary, const std::string& text) {
    file_.post(code, binary);
    text_ += text + "\n";
  }
  static std::string list(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ",") + fixed_text(value, 7);
    return text;
  }

  void multax(bool is_on) {
    has_axes_ = is_on;
    file_.multax(is_on);
    text_ += is_on ? "MULTAX/ON\n" : "MULTAX/OFF\n";
  }

  void write(const std::vector<double>& values, std::size_t numbers) {
    const bool is_expanded = numbers == 6 && values.size() <= 66 && pick(5) == 0;
    if (is_expanded) {
      file_.expanded(values);
    } else {
      file_.points(values, numbers * (2 + pick(19)));
    }
    text_ += "GOTO/" + list(values) + "\n";
    for (std::size_t i = 0; i < 3; ++i) here_[i] = values[values.size() - numbers + i];
    for (std::size_t i = 0; i < 3; ++i) axis_[i] = numbers == 6 ? values[values.size() - 3 + i] : i == 2 ? 1 : 0;
  }

  void go_to(std::size_t points) {
    static constexpr std::array<std::array<double, 3>, 4> kAxes = {
        {{0, 0, 1}, {0, 0.6, 0.8}, {1, 0, 0}, {-0.8, 0, 0.6}}};
    std::vector<double> values;
    for (std::size_t i = 0; i < points; ++i) {
      for (int k = 0; k < 3; ++k) values.push_back(number());
      const auto& axis = kAxes[pick(4)];
      if (has_axes_) values.insert(values.end(), axis.begin(), axis.end());
    }
    write(values, has_axes_ ? 6 : 3);
  }

  // On a circle of radius 5 that the tool stands on, by exact points of it.
  void circle() {
    static constexpr std::array<std::array<double, 2>, 12> kOn = {
        {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}}};
    std::size_t at = pick(12);
    const std::array<double, 3> center = {here_[0] - kOn[at][0], here_[1] - kOn[at][1], here_[2]};
    const double k = pick(2) == 0 ? 1 : -1;
    file_.circle({center[0], center[1], center[2], 0, 0, k, 5});
    text_ += "CIRCLE/" + list({center[0], center[1], center[2], 0, 0, k, 5}) + "\n";
    std::vector<double> values;
    const std::size_t points = 1 + pick(6), way = pick(2) == 0 ? 1 : 11;
    if (pick(4) == 0) at = (at + 12 - way) % 12;
    for (std::size_t i = 0; i < points; ++i) {
      at = (at + way * (1 + pick(4))) % 12;
      values.insert(values.end(), {center[0] + kOn[at][0], center[1] + kOn[at][1], center[2]});
      if (has_axes_) values.insert(values.end(), axis_.begin(), axis_.end());
    }
    write(values, has_axes_ ? 6 : 3);
  }

  void cycle() {
    static constexpr std::array<std::pair<std::uint16_t, const char*>, 8> kTypes = {{{163, "DRILL"},
                                                                                     {81, "FACE"},
                                                                                     {153, "DEEP"},
                                                                                     {152, "THRU"},
                                                                                     {168, "TAP"},
                                                                                     {213, "BORE9"},
                                                                                     {82, "BORE"},
                                                                                     {151, "MILL"}}};
    const auto [code, name] = kTypes[pick(kTypes.size())];
    std::vector<NccsFile::Argument> arguments = {Minor{code}, Minor{281}, 7.5, Minor{280}, 2.0};
    std::string text = std::string("CYCLE/") + name + ",FEDTO,7.5,RAPTO,2";
    const auto more = [&](std::uint16_t word, const char* word_text, double value) {
      arguments.insert(arguments.end(), {Minor{word}, value});
      text += std::string(",") + word_text + "," + fixed_text(value, 4);
    };
    if (pick(2) == 0) more(295, "RTRCTO", static_cast<double>(pick(20)));
    if (pick(2) == 0) more(92, "STEP", 1.5);
    if (pick(8) == 0) more(814, "OFFSET", 0.5);
    if (pick(2) == 0) more(197, "DWELL", 1);
    say(1054, arguments, text);
    for (std::size_t i = pick(4); i > 0; --i) go_to(1 + pick(2));
    if (pick(3) != 0) say(1054, {Minor{72}}, "CYCLE/OFF");
  }

  void step() {
    switch (pick(18)) {
      case 0:
      case 1:
        return go_to(1 + pick(30));
      case 2:
      case 3:
      case 4:
        return circle();
      case 5:
        return cycle();
      case 6:
        say(1007, {Minor{8}, Minor{33}, 3.0}, "CUTCOM/LEFT,XYPLAN,3");
        go_to(1);
        if (pick(2) == 0) say(1007, {Minor{159}, Minor{72}}, "CUTCOM/ADJUST,OFF");
        return say(1007, {Minor{72}}, "CUTCOM/OFF");
      case 7:
        return multax(pick(2) == 0);
      case 8:
        return say(5, {}, "RAPID");
      case 9:
        return say(1009, {Minor{315}, 250.0}, "FEDRAT/MMPM,250");
      case 10:
        return say(14, {}, "GOHOME");
      case 11:
        return say(7, {}, "RETRCT");
      case 12:
        return say(1234, {1.0, Minor{777}}, "STRANGE/1,WORD");
      case 13:
        return pick(4) == 0 ? say(1049, {1.5}, "COUPLE/1.5") : say(1054, {Minor{88}, Minor{71}}, "CYCLE/AUTO,ON");
      case 14: {
        const double shift = pick(2) == 0 ? 1 : 0;
        return say(1037, {shift, 0.0, 0.0}, "TRANS/" + list({shift, 0, 0}));
      }
      case 15: {
        const double tool = static_cast<double>(1 + pick(3));
        return say(1055, {tool}, "LOADTL/" + fixed_text(tool, 0));
      }
      default:
        return go_to(1);
    }
  }

  test::Scatter random_;
  NccsFile file_;
  std::string text_;
  bool has_axes_ = true;
  std::array<double, 3> here_{}, axis_{0, 0, 1};
};

std::vector<PathChange> random_changes(const Toolpath& path, test::Scatter& random) {
  std::vector<PathChange> changes;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (!move.not_checked_reason.empty() || !move.has_start || move.kind == MoveKind::cycle || random.next() % 3 == 0)
      continue;
    PathChange change;
    change.move = i;
    if (move.curve_kind == CurveKind::arc) {
      change.is_straightened = true;
      change.inserted_before = chords_of(path, i, 0.2);
      change.inserted_before.pop_back();
      for (Pose& pose : change.inserted_before) pose.tip += 0.5 * pose.axis;
    } else if (move.kind != MoveKind::arc) {
      if (random.next() % 2 == 0)
        change.inserted_before.push_back({0.5 * (path.start_of(i).tip + move.end.tip), move.end.axis});
      // A hole begins at the height the tool has.
      const bool meets_hole = i + 1 < path.moves.size() && path.moves[i + 1].kind == MoveKind::cycle;
      if (!meets_hole && random.next() % 4 == 0) change.new_end = Pose{move.end.tip + Vec3(0.125, 0, 1), move.end.axis};
    }
    if (change.new_end || change.is_straightened || !change.inserted_before.empty()) changes.push_back(change);
  }
  return changes;
}

// GOUGE_NCCS_PROGRAMS sets another number of them.
std::uint64_t programs() {
  const char* wanted = std::getenv("GOUGE_NCCS_PROGRAMS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 3000;
}

TEST(NccsTwins, AreTheSameMoves) {
  std::size_t arcs = 0, cycles = 0, unchecked = 0;
  for (std::uint64_t seed = 0; seed < programs(); ++seed) {
    const Twins twins(seed);
    const Toolpath binary = twins.binary();
    expect_same_moves(binary, twins.text());
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << "\n" << twins.shown();
    arcs += binary.arcs.size();
    for (const Move& move : binary.moves) {
      cycles += move.kind == MoveKind::cycle ? 1U : 0U;
      unchecked += move.not_checked_reason.empty() ? 0U : 1U;
    }
  }
  EXPECT_GT(arcs, 1000u);
  EXPECT_GT(cycles, 1000u);
  EXPECT_GT(unchecked, 1000u);
}

TEST(NccsTwins, CorrectedInTheSameWayTheyAreStillTheSameMoves) {
  std::size_t written = 0, written_in_records = 0, refused = 0, straightened = 0;
  for (std::uint64_t seed = 0; seed < programs(); ++seed) {
    const Twins twins(seed);
    test::Scatter random(seed);
    const Toolpath binary = twins.binary(), text = twins.text();
    // The records of a list behind a RAPID stay a list, while its text is split into statements at feed.
    const auto may_be_rapid = [](const Move& move) {
      return move.kind == MoveKind::feed && move.feed_unit == FeedUnit::rapid;
    };
    if (std::ranges::any_of(text.moves, may_be_rapid)) continue;
    const std::vector<PathChange> changes = random_changes(binary, random);
    const Result<std::string> bytes = write_corrected(binary, changes);
    const Result<std::string> lines = write_corrected(text, changes);
    if (!bytes || !lines) {
      ASSERT_FALSE(lines) << "seed " << seed << "\n" << twins.shown() << to_text(bytes.error());
      ASSERT_EQ(lines.error().code, "write-arc");
      bytes ? ++written_in_records : ++refused;  // whose arcs on one circle need not stay or go together
      continue;
    }
    expect_same_moves(path_of(*bytes), path_of(*lines), 1e-3);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << "\n" << twins.shown() << *lines;
    ++written;
    for (const PathChange& change : changes) straightened += change.is_straightened ? 1U : 0U;
  }
  EXPECT_GT(written, 200u);
  EXPECT_GT(written_in_records, 50u);
  EXPECT_GT(refused, 30u);
  EXPECT_GT(straightened, 200u);
}

// Some words of the file are others: headers, numbers, minor words, anything.
std::string mutated(std::string bytes, test::Scatter& random) {
  const std::size_t words = NccsWords(bytes).words();
  const int edits = 1 + static_cast<int>(random.next() % 4);
  for (int i = 0; i < edits; ++i) {
    const std::size_t at = NccsWords::offset(17 + random.next() % (words - 17));
    static constexpr std::array<std::uint16_t, 10> kClasses = {1000, 1001, 2000, 3000, 5000,
                                                               5200, 5210, 6000, 9000, 14000};
    switch (random.next() % 5) {
      case 0:
        bytes[at + random.next() % 8] = static_cast<char>(random.next());
        break;
      case 1:
        bytes.replace(at, 8, nccs_word(NccsHeader{static_cast<std::uint16_t>(random.next() % 1100), 7, 7, 0}));
        break;
      case 2:
        bytes.replace(at, 8, nccs_word(static_cast<double>(random.next() % 100) / 8));
        break;
      case 3:
        bytes.replace(at, 8,
                      nccs_word(NccsHeader{static_cast<std::uint16_t>(random.next() % 9),
                                           kClasses[random.next() % kClasses.size()],
                                           static_cast<std::uint16_t>(random.next() % 8), 1}));
        break;
      default:
        bytes.resize(at);
        return bytes;
    }
  }
  return bytes;
}

// A reason names the line of its statement, which inserted positions move on.
std::string_view without_line(std::string_view reason) { return reason.substr(0, reason.rfind(" in line ")); }

// `after` is `before` with the changes and nothing else.
void expect_changed(const Toolpath& after, const Toolpath& before, const std::vector<PathChange>& changes) {
  std::size_t at = 0, next = 0;
  for (std::size_t i = 0; i < before.moves.size(); ++i, ++at) {
    const PathChange* change = next < changes.size() && changes[next].move == i ? &changes[next++] : nullptr;
    if (change != nullptr) at += change->inserted_before.size();
    ASSERT_LT(at, after.moves.size());
    const Move& move = after.moves[at];
    const Pose& end = change != nullptr && change->new_end ? *change->new_end : before.moves[i].end;
    const bool has_end = !is_unread(move.not_checked_reason);  // else that of the move before
    const double off = (move.end.tip - end.tip).norm() + (move.end.axis - end.axis).norm();
    ASSERT_LE(has_end ? off : 0.0, 1e-9) << "move " << i;
    ASSERT_EQ(without_line(move.not_checked_reason), without_line(before.moves[i].not_checked_reason)) << "move " << i;
    const bool is_straightened = change != nullptr && change->is_straightened;
    ASSERT_EQ(move.curve_kind, is_straightened ? CurveKind::none : before.moves[i].curve_kind) << "move " << i;
  }
  ASSERT_EQ(at, after.moves.size());
}

TEST(NccsMutated, IsReadSoundlyOrRefusedAndWhatWasReadCanBeCorrected) {
  std::size_t read = 0, refused = 0, corrected = 0;
  for (std::uint64_t seed = 0; seed < programs(); ++seed) {
    test::Scatter random(seed);
    const ReadOutcome outcome = read_toolpath("a.cl", mutated(Twins(seed).bytes(), random));
    ASSERT_EQ(outcome.toolpath.has_value(), outcome.errors.empty());
    refused += outcome.toolpath ? 0U : 1U;
    if (!outcome.toolpath) continue;
    ++read;
    const Toolpath& path = *outcome.toolpath;
    for (const Move& move : path.moves) {
      ASSERT_TRUE(move.end.tip.allFinite());
      ASSERT_NEAR(move.end.axis.norm(), 1, 1e-12);
    }
    ASSERT_EQ(write_corrected(path, {}).value(), path.source) << "seed " << seed;
    const std::vector<PathChange> changes = random_changes(path, random);
    const Result<std::string> bytes = write_corrected(path, changes);
    if (!bytes) continue;
    ReadOptions options;
    options.dialect = dialect_of(DialectKind::nccs_binary);
    options.unit = path.unit;
    const ReadOutcome again = read_toolpath("b.cl", *bytes, options);
    ASSERT_TRUE(again.toolpath) << "seed " << seed << " " << to_text(again.errors.front());
    expect_changed(*again.toolpath, path, changes);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    ++corrected;
  }
  EXPECT_GT(read, programs() / 10);
  EXPECT_GT(refused, programs() / 10);
  EXPECT_GT(corrected, programs() / 20);
}

}  // namespace
}  // namespace gouge::nccs_twins_test
