#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "postproc/cldata/language/dialect.h"
#include "tests/postproc/cldata/corrected.h"
#include "tests/postproc/cldata/nccs_file.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/support/scatter.h"

// Tool axes that a correction writes into files whose positions state none. Read again, each position must have the axis
// that was intended, and none may be uncertain.

namespace gouge::new_axes_test {
namespace {

const std::string kPlain =
    "GOTO/1.0,2.0,3.0\nGOTO/4.0,5.0,6.0\nGOTO/7.0,8.0,9.0\nGOTO/7.0,9.0,9.0\nGOTO/7.0,9.0,12.0\n";

Toolpath read_as(const Dialect& dialect, const std::string& text) {
  ReadOptions options;
  options.dialect = dialect;
  ReadOutcome outcome = read_toolpath("test.apt", text, options);
  if (!outcome.toolpath) {
    ADD_FAILURE() << dialect.id << ": " << to_text(outcome.errors.front()) << "\n" << text;
    return {};
  }
  return std::move(*outcome.toolpath);
}

Pose tilted(const Move& move, const Vec3& axis) { return {move.end.tip, axis}; }

/// Expects that `after` has the moves of `before`, with the ends and insertions of `changes` and no uncertain move.
void expect_changed(const Toolpath& before, const std::vector<PathChange>& changes, const Toolpath& after) {
  std::vector<Pose> wanted;
  for (std::size_t i = 0; i < before.moves.size(); ++i) {
    const auto change = std::ranges::find(changes, i, &PathChange::move);
    const bool is_changed = change != changes.end();
    if (is_changed) wanted.insert(wanted.end(), change->inserted_before.begin(), change->inserted_before.end());
    wanted.push_back(is_changed && change->new_end ? *change->new_end : before.moves[i].end);
  }
  ASSERT_EQ(after.moves.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_LT((after.moves[i].end.tip - wanted[i].tip).norm(), 1e-4) << "move " << i;
    EXPECT_LT((after.moves[i].end.axis - wanted[i].axis).norm(), 1e-6) << "move " << i;
    EXPECT_EQ(after.moves[i].not_checked_reason, "") << "move " << i;
  }
}

// Three numbers behind the tilted axis would be uncertain, although the second position has the axis of the first.
TEST(NewAxes, TwoPositionsWithTheSameTiltBothStateIt) {
  const Toolpath path = path_of("UNITS/MM\n" + kPlain + "FINI\n");
  const Vec3 axis(0.6, 0, 0.8);
  const std::string axis_text = ",0.600000000,0.000000000,0.800000000\n";
  EXPECT_EQ(written(path, {{1, tilted(path.moves[1], axis), {}}, {2, tilted(path.moves[2], axis), {}}}),
            "UNITS/MM\nGOTO/1.0,2.0,3.0\nMULTAX/ON\nGOTO/4.0,5.0,6.0" + axis_text + "MULTAX/OFF\nMULTAX/ON\n" +
                "GOTO/7.0,8.0,9.0" + axis_text + "MULTAX/OFF\nMULTAX/ON\nGOTO/7.0,9.0,9.0" +
                ",0.000000000,0.000000000,1.000000000\nMULTAX/OFF\nGOTO/7.0,9.0,12.0\nFINI\n");
}

// CATIA locks the axis at MULTAX/OFF, so that the second position keeps its three numbers.
TEST(NewAxes, ALockedAxisIsNotRepeated) {
  const Toolpath path = path_of("$$ CATIA APT VERSION 1.0\n" + kPlain + "FINI\n");
  const Vec3 axis(0.6, 0, 0.8);
  const std::string text = written(path, {{1, tilted(path.moves[1], axis), {}}, {2, tilted(path.moves[2], axis), {}}});
  EXPECT_NE(text.find("MULTAX/OFF\nGOTO/7.0,8.0,9.0\nMULTAX/ON\nGOTO/7.0,9.0,9.0,"), std::string::npos) << text;
}

// The file has an axis elsewhere, so MULTAX is not written. The position after the tilted one states its axis.
TEST(NewAxes, APositionAfterATiltedOneStatesTheUsualAxis) {
  const Toolpath path = path_of("UNITS/MM\nGOTO/0.0,0.0,9.0,0.0,0.0,1.0\n" + kPlain + "FINI\n");
  EXPECT_EQ(written(path, {{2, tilted(path.moves[2], Vec3(0.6, 0, 0.8)), {}}}),
            "UNITS/MM\nGOTO/0.0,0.0,9.0,0.0,0.0,1.0\nGOTO/1.0,2.0,3.0\nGOTO/4.0,5.0,6.0,0.600000,0.000000,0.800000\n"
            "GOTO/7.0,8.0,9.0,0.000000,0.000000,1.000000\nGOTO/7.0,9.0,9.0\nGOTO/7.0,9.0,12.0\nFINI\n");
}

// A correction must not state an axis that the file leaves open.
TEST(NewAxes, APositionWhoseAxisIsUncertainInTheFileKeepsItsBytes) {
  const Toolpath path = path_of("UNITS/MM\nGOTO/0.0,0.0,9.0,0.6,0.0,0.8\n" + kPlain + "FINI\n");
  const std::string text = written(path, {{0, tilted(path.moves[0], Vec3(0.8, 0, 0.6)), {}}});
  EXPECT_EQ(text, "UNITS/MM\nGOTO/0.0,0.0,9.0,0.800000,0.0,0.600000\n" + kPlain + "FINI\n");
}

std::string random_file(const Dialect& dialect, test::Scatter& random) {
  const auto number = [&random] { return std::to_string(static_cast<int>(random.next() % 200)) + ".0"; };
  std::string text = random.next() % 2 == 0 ? "UNITS/MM\n" : "UNITS/INCHES\n";
  if (const std::uint64_t multax = random.next() % 4; multax < 2) text += multax == 0 ? "MULTAX/ON\n" : "MULTAX/OFF\n";
  // Without MULTAX six numbers would be uncertain in dialects that state it, and lists are uncertain with it.
  const bool is_on = text.find("ON") != std::string::npos;
  const bool has_axes = is_on && random.next() % 2 == 0;
  const bool has_lists = !is_on && !dialect.is_axis_modal && random.next() % 3 == 0;
  for (std::size_t i = 0; i < 8; ++i) {
    if (i > 0 && random.next() % 4 == 0) {
      text += "GODLTA/" + number() + ",0.0," + number() + "\n";
      continue;
    }
    text += "GOTO/" + number() + "," + number() + "," + number();
    if (has_axes && random.next() % 2 == 0) {
      text += ",0.0,0.0,1.0";
    } else if (has_lists) {
      // Nine numbers are uncertain if three of them have the length of an axis.
      text += ",250.0," + number() + "," + number() + ",260.0," + number() + "," + number();
    }
    text += "\n";
  }
  return text + "FINI\n";
}

std::vector<PathChange> random_tilts(const Toolpath& path, test::Scatter& random) {
  const std::vector<Vec3> axes = {{0, 0, 1}, {0.6, 0, 0.8}, {0.6, 0, 0.8}, {0, -0.8, 0.6}};
  std::vector<PathChange> changes;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (random.next() % 3 == 0) continue;
    PathChange change;
    change.move = i;
    if (random.next() % 4 != 0) change.new_end = tilted(path.moves[i], axes[random.next() % axes.size()]);
    if (path.moves[i].has_start && random.next() % 3 == 0)
      change.inserted_before = {{path.moves[i].end.tip + Vec3(0, 0, 5), axes[random.next() % axes.size()]}};
    if (change.new_end || !change.inserted_before.empty()) changes.push_back(change);
  }
  return changes;
}

TEST(NewAxes, AreReadAsTheyWereIntendedInEveryDialect) {
  std::size_t compared = 0;
  for (const Dialect& dialect : all_dialects()) {
    if (dialect.is_binary || !dialect.has_apt_words) continue;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      test::Scatter random(seed);
      const std::string text = random_file(dialect, random);
      const Toolpath path = read_as(dialect, text);
      const auto is_open = [](const Move& move) { return !move.not_checked_reason.empty(); };
      if (std::ranges::any_of(path.moves, is_open)) continue;
      const std::vector<PathChange> changes = random_tilts(path, random);
      const std::string changed = written(path, changes);
      expect_changed(path, changes, read_as(dialect, changed));
      if (testing::Test::HasFailure()) FAIL() << dialect.id << " seed " << seed << "\n" << text << "\n" << changed;
      ++compared;
    }
  }
  EXPECT_GT(compared, 2000U);
}

TEST(NewAxes, AreReadAsTheyWereIntendedInBinaryRecords) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    test::Scatter random(seed);
    NccsFile file;
    const bool has_axes = random.next() % 3 == 0;
    file.multax(has_axes);
    for (std::size_t i = 0; i < 5; ++i) {
      std::vector<double> numbers;
      for (std::size_t k = 0; k <= random.next() % 3; ++k) {
        for (int c = 0; c < 3; ++c) numbers.push_back(static_cast<double>(random.next() % 200));
        if (has_axes) numbers.insert(numbers.end(), {0, 0, 1});
      }
      file.points(numbers);
    }
    const Toolpath path = path_of(file.bytes());
    const std::vector<PathChange> changes = random_tilts(path, random);
    expect_changed(path, changes, path_of(written(path, changes)));
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
  }
}

}  // namespace
}  // namespace gouge::new_axes_test
