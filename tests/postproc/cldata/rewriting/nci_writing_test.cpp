// Corrections written into Mastercam NCI files.

#include "lib/path/chords.h"
#include "postproc/formats/write_corrected.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/corrected.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/support/scatter.h"

namespace gouge::nci_writing_test {
namespace {

constexpr const char* kStart = "0\r\n0 0. 0. 50. -2. 0\r\n";

TEST(NciWriting, ALineChangesOnlyTheNumberThatChanged) {
  const Toolpath path = path_of(std::string(kStart) + "1\r\n41 4.5  2. 0.5 200. 100\r\n1003\r\n0\r\n");
  EXPECT_EQ(written(path, {lift(path, 1, 1.25)}),
            std::string(kStart) + "1\r\n41 4.5  2. 1.75 200. 100\r\n1003\r\n0\r\n");
}

TEST(NciWriting, AFiveAxisLineMovesItsSecondPointAlong) {
  const Toolpath path = path_of(std::string(kStart) + "11\r\n1. 2. 3. 16. 2. 23. 200. 7 1 0. 0. 1.\r\n");
  Pose end = path.moves[1].end;
  end.tip += 2.5 * end.axis;
  EXPECT_EQ(written(path, {{1, end, {}}}), std::string(kStart) + "11\r\n2.5 2. 5. 17.5 2. 25. 200. 7 1 0. 0. 1.\r\n");
}

TEST(NciWriting, AnotherAxisGetsTheDecimalsItNeeds) {
  const Toolpath path = path_of("11\n1.000 2.000 3.000 1.000 2.000 4.000 200. 0 0\n");
  const Pose end{Vec3(1, 2, 3), Vec3(0.12, -0.345, 0.9).normalized()};
  const Toolpath again = path_of(written(path, {{0, end, {}}}));
  expect_vector(again.moves[0].end.tip, 1, 2, 3);
  EXPECT_LT((again.moves[0].end.axis - end.axis).norm(), 1e-5);
}

TEST(NciWriting, InsertedPositionsSwitchNothing) {
  const Toolpath path = path_of(std::string(kStart) + "1\r\n41 4. 2. 1. 200. 100\r\n1\r\n40 5. 2. 1. -1. 100\r\n");
  const Pose above{Vec3(1, 2, 30), Vec3::UnitZ()};
  EXPECT_EQ(written(path, {{1, std::nullopt, {above, above}}}),
            std::string(kStart) +
                "1\r\n0 1. 2. 30. 200. 0\r\n1\r\n0 1. 2. 30. 200. 0\r\n1\r\n41 4. 2. 1. 200. 100\r\n"
                "1\r\n40 5. 2. 1. -1. 100\r\n");
}

TEST(NciWriting, InsertedPositionsAreAsRapidAsWhatTheyStandBefore) {
  const Toolpath path = path_of("1\n0 0. 0. 5. 200. 0\n0\n0 4. 0. 5. -2. 0\n11\n4. 0. 9. 4. 0. 10. -2. 0 0");
  const Pose a{Vec3(1, 2, 30), Vec3::UnitZ()}, b{Vec3(4, 0, 30), Vec3(0.6, 0, 0.8)};
  const std::string text = written(path, {{1, std::nullopt, {a}}, {2, std::nullopt, {b}}});
  EXPECT_EQ(text,
            "1\n0 0. 0. 5. 200. 0\n0\n0 1. 2. 30. -2. 0\n0\n0 4. 0. 5. -2. 0\n11\n4. 0. 30. 4.6 0. 30.8 -2. 0 0\n"
            "11\n4. 0. 9. 4. 0. 10. -2. 0 0");
  const Toolpath again = path_of(text);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(again.moves[i].kind, MoveKind::rapid) << i;
}

TEST(NciWriting, WhatNoPairCanSayIsRefused) {
  const Pose tilted{Vec3(1, 0, 6), Vec3(0.6, 0, 0.8)};
  const Toolpath path = path_of(std::string(kStart) + "1\n0 4. 0. 5. 350. 0\n");
  EXPECT_EQ(write_corrected(path, {{1, tilted, {}}}).error().code, "write-axis");
  EXPECT_EQ(write_corrected(path, {{1, std::nullopt, {tilted}}}).error().code, "write-axis");
  // The axis of the line would be in doubt, whatever five-axis lines the file has.
  const Toolpath five = path_of("1002\n0 100 2 7 7 7\n11\n0. 0. 5. 0. 0. 30. 9. 1 0\n1\n0 4. 0. 5. -1. 0\n1003\n0\n");
  EXPECT_EQ(write_corrected(five, {{1, std::nullopt, {tilted}}}).error().code, "write-axis");
  EXPECT_EQ(write_corrected(five, {{0, tilted, {}}}).error().code, "write-axis");
  const Toolpath arc = path_of("1\n0 5. 0. 0. 9. 0\n1\n0 5. 0. 1. 9. 0\n3\n0 0 0. 5. 0. 0. 1. 9. 0 0\n");
  EXPECT_EQ(write_corrected(arc, {lift(arc, 1, 1)}).error().code, "write-arc");
  EXPECT_EQ(write_corrected(arc, {lift(arc, 2, 1)}).error().code, "write-arc");
  const Toolpath xz = path_of("1\n0 5. 0. 0. 9. 0\n1\n0 5. 0. 1. 9. 0\n3\n0 2 0. 6. 0. 1. 0. 9. 0 0\n");
  EXPECT_EQ(write_corrected(xz, {lift(xz, 1, 1)}).error().code, "write-arc");
  const Toolpath drill = path_of("1\n0 5. 0. 0. 9. 0\n81\n1. 2. 3. 4. 5.\n");
  EXPECT_EQ(write_corrected(drill, {lift(drill, 1, 1)}).error().code, "write-move");
}

PathChange straightened(const Toolpath& path, std::size_t move) {
  PathChange change{move, std::nullopt, chords_of(path, move, 0.1), true};
  change.inserted_before.pop_back();
  return change;
}

TEST(NciWriting, AStraightenedArcBecomesLinesOfItsFeedAndSwitchesAtItsEnd) {
  const std::string start = "1\r\n0 5.00 0.00 1.00 200. 0\r\n", end = "1\r\n0 0.00 9.00 1.00 -1. 0\r\n";
  for (const char* fields : {"42 0 0.00 5.00 0.00 0.00 1.00 -1. 10 0", "0 42 0.00 5.00 0.00 0.00 1.00 -1. 10 0"}) {
    ReadOptions options;
    options.is_cutcom_centre = true;
    const std::string text = start + "3\r\n" + fields + "\r\n" + end;
    const Toolpath path = *read_toolpath("a.nci", text, options).toolpath;
    const PathChange change = straightened(path, 1);
    const std::string found = written(path, {change});
    EXPECT_TRUE(found.starts_with(start + "1\r\n0 ")) << found;
    EXPECT_TRUE(found.ends_with(" -1. 0\r\n1\r\n42 0.00 5.00 1.00 -1. 10\r\n" + end)) << found;
    EXPECT_EQ(path_of(found).moves.size(), 3 + change.inserted_before.size());
  }
}

TEST(NciWriting, AnArcOfTheYzPlaneIsStraightenedIntoXyz) {
  const std::string start = "1\n0 7. 5. 0. 200. 0\n";
  const Toolpath path = path_of(start + "2\n1 0 0. -5. 0. 0. 8. 150.\n");
  const std::string found = written(path, {straightened(path, 1)});
  EXPECT_TRUE(found.ends_with("1\n0 8. 0. -5. 150.\n")) << found;
  expect_vector(path_of(found).moves.back().end.tip, 8, 0, -5);
}

TEST(NciWriting, NumbersWiderThanTheirColumnStayApart) {
  const Toolpath path = path_of("1\n0    1.5   20.5    3.5 100. 0\n1\n0    1.5  120.5    3.5 100. 0\n");
  const Pose far{Vec3(1.5, -12345.5, -12345.5), Vec3::UnitZ()};
  const Toolpath again = path_of(written(path, {{1, far, {}}}));
  expect_vector(again.moves[1].end.tip, 1.5, -12345.5, -12345.5);
}

// A file of every kind of pair, at random; each number with as many decimals as the file has.
class RandomNci {
 public:
  explicit RandomNci(test::Scatter& random) : random_(random), decimals_(3 + pick(4)) {
    line_end_ = pick(2) == 0 ? "\n" : "\r\n";
    length_ = std::vector<double>{1, 25, 0.5}[pick(3)];
    add("1002", "0 100 2 7 7 7");
    add("0", "0 5. 0. 60. -2. 0");
    for (int i = 0; i < 25; ++i) add_motion();
    if (pick(2) == 0) add("1003", "0");
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::size_t pick(std::size_t count) { return random_.next() % count; }
  double real(double most) { return random_.in(-most, most); }
  std::string number(double value) {
    return std::to_string(value).substr(0, std::to_string(value).find('.') + 1 + decimals_);
  }
  std::string feed() { return std::vector<std::string>{"-1.", "-2.", "250."}[pick(3)]; }
  std::string comp() { return std::vector<std::string>{"0", "0", "0", "40", "41", "42", "140"}[pick(7)]; }
  std::string flags() { return std::vector<std::string>{"0", "1", "100", "10"}[pick(4)]; }
  void add(const std::string& code, const std::string& fields) { text_ += code + line_end_ + fields + line_end_; }
  void add_point(const std::string& code) {
    add(code, comp() + " " + number(x_) + " " + number(y_) + "  " + number(z_) + " " + (code == "0" ? "-2." : feed()) +
                  (pick(2) == 0 ? "" : " " + flags()));
  }
  void move() { x_ = real(90), y_ = real(90), z_ = real(90); }

  void add_five_axis(const Vec3& axis) {
    add("11", number(x_) + " " + number(y_) + " " + number(z_) + " " + number(x_ + axis.x() * length_) + " " +
                  number(y_ + axis.y() * length_) + " " + number(z_ + axis.z() * length_) + " " + feed() + " 0 " +
                  flags() + (pick(2) == 0 ? "" : " 0. 0. 1."));
  }

  void add_motion() {
    switch (pick(5)) {
      case 0:
        move();
        return add_point("0");
      case 1:
        move();
        return add_point("1");
      case 2:
        move();
        add_five_axis(Vec3(real(1), real(1), 1.1).normalized());
        return add_five_axis(Vec3::UnitZ());  // the axis of a line behind a tilted one is in doubt
      default:
        return add_arc(pick(2) == 0);
    }
  }
  // Half a turn about a centre whose numbers are exact, with a step across the plane.
  void add_arc(bool is_yz) {
    move();
    x_ = std::round(x_), y_ = std::round(y_), z_ = std::round(z_);
    add_point("1");
    double& a = is_yz ? y_ : x_;
    double& b = is_yz ? z_ : y_;
    double& across = is_yz ? x_ : z_;
    const double center = a + 3 + static_cast<double>(pick(9));
    a = 2 * center - a;
    across += pick(2) == 0 ? 0 : 2;
    const std::string plane = is_yz ? "1" : "0";
    add(pick(2) == 0 ? "2" : "3", (pick(2) == 0 ? comp() + " " + plane : plane + " " + comp()) + " " + number(a) + " " +
                                      number(b) + " " + number(center) + " " + number(b) + " " + number(across) + " " +
                                      feed() + (pick(2) == 0 ? "" : " " + flags() + (pick(2) == 0 ? "" : " 0")));
  }

  test::Scatter& random_;
  std::size_t decimals_;
  double length_ = 1;
  double x_ = 5, y_ = 0, z_ = 60;
  std::string line_end_, text_;
};

struct Expected {
  Pose end;
  MoveKind kind;
  bool is_new;
  bool was_arc;        // straight now, at its feed, which may be rapid
  std::size_t before;  // the move of the file, or kNone
};

std::string statement_of(const Toolpath& path, std::size_t move) {
  const SourceStatement& span = path.statements[path.moves[move].statement];
  return path.source.substr(span.first_byte, span.last_byte - span.first_byte);
}

// A random change of some moves, and what the path must then be.
std::vector<PathChange> random_changes(const Toolpath& path, test::Scatter& random, std::vector<Expected>& expected) {
  const auto shift = [&](const Pose& pose) { return Pose{pose.tip + random.point(5), pose.axis}; };
  std::vector<PathChange> changes;
  std::vector<bool> is_straightened(path.moves.size());
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    is_straightened[i] = path.moves[i].curve_kind == CurveKind::arc && random.next() % 2 == 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    PathChange change{i, std::nullopt, {}, is_straightened[i]};
    const bool is_arc = move.kind == MoveKind::arc;
    const bool is_fixed =
        i + 1 < path.moves.size() && path.moves[i + 1].kind == MoveKind::arc && !is_straightened[i + 1];
    if ((!is_arc || is_straightened[i]) && !is_fixed && random.next() % 3 == 0) change.new_end = shift(move.end);
    if (is_straightened[i]) {
      change.inserted_before = chords_of(path, i, 0.5);
      change.inserted_before.pop_back();
    } else if (!is_arc && move.has_start && random.next() % 3 == 0) {
      for (std::size_t k = 1 + random.next() % 3; k > 0; --k) {
        Pose between = shift(path.start_of(i));
        between.axis = (path.start_of(i).axis + 0.3 * static_cast<double>(k) * move.end.axis).normalized();
        change.inserted_before.push_back(between);
      }
    }
    for (const Pose& pose : change.inserted_before) expected.push_back({pose, move.kind, true, is_arc, kNone});
    expected.push_back(
        {change.new_end.value_or(move.end), move.kind, change.new_end || is_straightened[i], is_straightened[i], i});
    if (change.new_end || !change.inserted_before.empty() || change.is_straightened) changes.push_back(change);
  }
  return changes;
}

TEST(NciWriting, RandomFilesAreReadBackWithTheirCorrections) {
  test::Scatter random(20261121);
  ReadOptions options;
  options.is_cutcom_centre = true;
  std::size_t inserted = 0, straight = 0;
  for (int round = 0; round < 400 && !HasFailure(); ++round) {
    const RandomNci file(random);
    SCOPED_TRACE(file.text());
    const ReadOutcome outcome = read_toolpath("random.nci", file.text(), options);
    ASSERT_TRUE(outcome.toolpath);
    const Toolpath& path = *outcome.toolpath;
    EXPECT_EQ(written(path, {}), file.text());
    std::vector<Expected> expected;
    const std::vector<PathChange> changes = random_changes(path, random, expected);
    const Result<std::string> text = write_corrected(path, changes);
    if (!text && text.error().code == "write-axis") continue;  // no five-axis line in the file
    ASSERT_TRUE(text) << to_text(text.error());
    SCOPED_TRACE(*text);
    const ReadOutcome again = read_toolpath("again.nci", *text, options);
    ASSERT_TRUE(again.toolpath);
    ASSERT_EQ(again.toolpath->moves.size(), expected.size());
    EXPECT_TRUE(again.toolpath->words_not_understood.empty());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Move& move = again.toolpath->moves[i];
      const double tip = expected[i].is_new ? 0.9e-4 : 1e-12;
      EXPECT_LT((move.end.tip - expected[i].end.tip).norm(), tip) << i;
      EXPECT_LT((move.end.axis - expected[i].end.axis).norm(), expected[i].is_new ? 1.01e-5 : 1e-12) << i;
      if (expected[i].was_arc) {
        EXPECT_EQ(move.curve_kind, CurveKind::none) << i;
      } else {
        EXPECT_EQ(move.kind, expected[i].kind) << i;
      }
      if (!expected[i].is_new) {
        EXPECT_EQ(statement_of(*again.toolpath, i), statement_of(path, expected[i].before)) << i;
      }
      EXPECT_TRUE(move.not_checked_reason.empty()) << i << move.not_checked_reason;
      EXPECT_EQ(move.tool, path.moves.front().tool);
    }
    for (const PathChange& change : changes) (change.is_straightened ? straight : inserted) += 1;
    const bool has_returns = file.text().find('\r') != std::string::npos;
    const auto lines = std::count(text->begin(), text->end(), '\n');
    EXPECT_EQ(std::count(text->begin(), text->end(), '\r'), has_returns ? lines : 0);
  }
  EXPECT_GT(inserted, 1000u);
  EXPECT_GT(straight, 500u);
}

// The compensation of each move, reported by whether it is checked.
TEST(NciWriting, InsertionsLeaveTheCompensationOfAllOtherMoves) {
  test::Scatter random(7);
  for (int round = 0; round < 200 && !HasFailure(); ++round) {
    const RandomNci file(random);
    SCOPED_TRACE(file.text());
    const Toolpath path = path_of(file.text());
    std::vector<PathChange> changes;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Move& move = path.moves[i];
      if (move.kind != MoveKind::arc && move.has_start && random.next() % 2 == 0)
        changes.push_back({i, std::nullopt, {Pose{path.start_of(i).tip + Vec3(1, 1, 1), move.end.axis}}});
    }
    const std::string text = written(path, changes);
    const Toolpath again = path_of(text);
    SCOPED_TRACE(text);
    ASSERT_EQ(again.moves.size(), path.moves.size() + changes.size());
    std::size_t added = 0;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      if (added < changes.size() && changes[added].move == i) ++added;
      EXPECT_EQ(again.moves[i + added].not_checked_reason, path.moves[i].not_checked_reason) << i;
    }
  }
}

}  // namespace
}  // namespace gouge::nci_writing_test
