#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lib/path/chords.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/write_corrected.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/support/scatter.h"

namespace gouge::mutation_test {
namespace {

constexpr const char* kApt =
    "$$ CATIA APT VERSION 1.0\r\n$$*CATIA0\r\n$$ X\r\n$$ 1 0 0 0\r\n$$ 0 1 0 0\r\n$$ 0 0 1 "
    "0\r\nPARTNO/'A'\r\nUNITS/MM\r\nMULTAX/ON\r\n"
    "CUTTER/10,2,3,2,0,0,40\r\nLOADTL/1\r\nFEDRAT/100,MMPM\r\nFROM/0,0,50\r\nRAPID\r\nGOTO/1.,2.,3.,$\r\n0,0,1\r\n"
    "GOTO  /   -1.50000,    2.00000,    3.00000,-1.000000, 0.000000, "
    "0.000000\r\nTLON,GOFWD/(CIRCLE/1,2,3,4),ON,(LINE/1,2,3,$\r\n"
    "4,5,6)\r\nCYCLE/DRILL,5\r\nGOTO/4,5,6,0,0,1\r\nCYCLE/OFF\r\nGODLTA/1,2,3\r\nGOHOME/0,0,50\r\nFINI\r\n";
constexpr const char* kClsf =
    "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10.0,5.0,75.0,0.0,0.0\nMSYS/1.0,2.0,3.0,0.0,1.0,0.0,1.0,0.0,0.0\nPAINT/PATH\n"
    "LOAD/TOOL,2\nRAPID\nGOTO/1.0,2.0,3.0,0.0,0.0,-1.0\nGOTO/2.0,2.0,3.0\nNURBS/\nKNOT/1.0\nCNTRL/4.0,5.0,6.0\n"
    "CIRCLE/1.0,2.0,3.0,0.0,0.0,1.0,4.0,0.06,0.5,1.0,2.0\nGOTO/7.0,8.0,9.0\nEND-OF-PATH\n";

std::string mutated(std::string text, test::Scatter& random) {
  const int edits = 1 + static_cast<int>(random.next() % 6);
  for (int i = 0; i < edits && !text.empty(); ++i) {
    const std::size_t at = random.next() % text.size();
    const std::size_t length = std::min<std::size_t>(1 + random.next() % 12, text.size() - at);
    static constexpr std::string_view kLikely = "0123456789.,-+/$ \n\rEe()=";
    switch (random.next() % 5) {
      case 0:
        text[at] = static_cast<char>(random.next());
        break;
      case 1:
        text[at] = kLikely[random.next() % kLikely.size()];
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(random.next() % text.size(), length));
        break;
      default:
        text.resize(at);
    }
  }
  return text;
}

void expect_sound(const Toolpath& path) {
  for (const Move& move : path.moves) {
    EXPECT_TRUE(move.end.tip.allFinite());
    EXPECT_NEAR(move.end.axis.norm(), 1, 1e-12);
    EXPECT_LT(move.statement, path.statements.size());
    EXPECT_TRUE(move.tool == kNone || move.tool < path.tools.size());
    EXPECT_TRUE(move.operation == kNone || move.operation < path.operations.size());
  }
  std::size_t end = 0;
  for (const SourceStatement& statement : path.statements) {
    EXPECT_LE(end, statement.first_byte);
    EXPECT_LT(statement.first_byte, statement.last_byte);
    end = statement.last_byte;
  }
  EXPECT_LE(end, path.source.size());
  EXPECT_EQ(*write_corrected(path, {}), path.source);
}

TEST(MutatedPath, IsReadSoundlyOrRefusedWithAnError) {
  test::Scatter random(20240607);
  std::size_t read = 0;
  std::size_t refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const ReadOutcome outcome = read_toolpath("mutated", mutated(i % 2 == 0 ? kApt : kClsf, random));
    EXPECT_EQ(outcome.toolpath.has_value(), outcome.errors.empty());
    if (outcome.toolpath) {
      expect_sound(*outcome.toolpath);
      ++read;
    } else {
      EXPECT_LE(outcome.errors.size(), 21u);
      ++refused;
    }
    if (testing::Test::HasFailure()) FAIL() << "mutation " << i;
  }
  EXPECT_GT(read, 1000u);
  EXPECT_GT(refused, 1000u);
}

// Whatever was read can be changed and read again with the same number of moves.
TEST(MutatedPath, CanBeCorrectedAndReadAgain) {
  test::Scatter random(99);
  std::size_t written = 0;
  for (int i = 0; i < 4000; ++i) {
    const ReadOutcome outcome = read_toolpath("mutated", mutated(i % 2 == 0 ? kApt : kClsf, random));
    if (!outcome.toolpath) continue;
    const Toolpath& path = *outcome.toolpath;
    std::vector<PathChange> changes;
    for (std::size_t move = 0; move < path.moves.size(); ++move) {
      if (path.moves[move].kind != MoveKind::feed && path.moves[move].kind != MoveKind::rapid) continue;
      if (is_unread(path.moves[move].not_checked_reason)) continue;
      if (move + 1 < path.moves.size() && path.moves[move + 1].kind == MoveKind::arc) continue;
      Pose end = path.moves[move].end;
      end.tip.z() += 1.25;
      changes.push_back({move, end, {}});
    }
    const Result<std::string> text = write_corrected(path, changes);
    if (!text && text.error().code == "write-arc") continue;  // it begins where a change ends
    ASSERT_TRUE(text.has_value()) << text.error().message;
    const ReadOutcome again = read_toolpath("again", *text);
    ASSERT_TRUE(again.toolpath) << to_text(again.errors.front()) << "\n" << *text;
    ASSERT_EQ(again.toolpath->moves.size(), path.moves.size()) << *text;
    for (const PathChange& change : changes) {
      EXPECT_LT((again.toolpath->moves[change.move].end.tip - change.new_end->tip).norm(), 2e-4) << *text;
    }
    ++written;
    if (testing::Test::HasFailure()) FAIL() << "mutation " << i;
  }
  EXPECT_GT(written, 300u);
}

// Every straight move of a damaged NCI file lifted and led up to, every arc made straight.
std::vector<PathChange> changes_everywhere(const Toolpath& path) {
  std::vector<PathChange> changes;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    const bool is_arc = move.kind == MoveKind::arc;
    const bool meets_arc = i + 1 < path.moves.size() && path.moves[i + 1].kind == MoveKind::arc;
    if (is_unread(move.not_checked_reason) || meets_arc || (is_arc && move.curve_kind == CurveKind::none)) continue;
    PathChange change{i, move.end, {}, is_arc};
    change.new_end->tip.z() += 1.25;
    if (is_arc) {
      change.inserted_before = chords_of(path, i, 1);
      change.inserted_before.pop_back();
    } else if (move.has_start) {
      change.inserted_before.push_back({path.start_of(i).tip + Vec3(1, 2, 3), move.end.axis});
    }
    changes.push_back(change);
  }
  return changes;
}

TEST(MutatedNci, CanBeCorrectedAndReadAgain) {
  test::Scatter random(11);
  const std::string whole = bytes_of(corpus() / "five_axis.nci");
  ReadOptions options;
  options.dialect = dialect_called("mastercam-nci");
  options.is_cutcom_centre = true;
  std::size_t written = 0;
  for (int i = 0; i < 6000 && !HasFailure(); ++i) {
    const ReadOutcome outcome = read_toolpath("mutated", mutated(whole, random), options);
    if (!outcome.toolpath) continue;
    const Toolpath& path = *outcome.toolpath;
    SCOPED_TRACE(path.source.view());
    EXPECT_EQ(*write_corrected(path, {}), path.source);
    const std::vector<PathChange> changes = changes_everywhere(path);
    const Result<std::string> text = write_corrected(path, changes);
    if (!text && text.error().code.starts_with("write-a")) continue;  // an arc that stays, or no five-axis line
    ASSERT_TRUE(text.has_value()) << to_text(text.error());
    const ReadOutcome again = read_toolpath("again", *text, options);
    ASSERT_TRUE(again.toolpath) << to_text(again.errors.front()) << "\n" << *text;
    std::size_t added = 0, next = 0;
    for (std::size_t k = 0; k < path.moves.size(); ++k) {
      const bool is_changed = next < changes.size() && changes[next].move == k;
      if (is_changed) added += changes[next].inserted_before.size();
      const Pose& expected = is_changed ? *changes[next].new_end : path.moves[k].end;
      next += is_changed ? 1 : 0;
      ASSERT_LT(k + added, again.toolpath->moves.size()) << *text;
      if (is_unread(path.moves[k].not_checked_reason)) continue;
      EXPECT_LT((again.toolpath->moves[k + added].end.tip - expected.tip).norm(), 2e-4) << k << *text;
      EXPECT_LT((again.toolpath->moves[k + added].end.axis - expected.axis).norm(), 1.01e-5) << k << *text;
    }
    EXPECT_EQ(again.toolpath->moves.size(), path.moves.size() + added) << *text;
    EXPECT_EQ(again.toolpath->words_not_understood, path.words_not_understood) << *text;
    ++written;
  }
  EXPECT_GT(written, 1000u);
}

// The origins that a reader keeps equal those of a new reading.
TEST(MutatedPath, IsCorrectedTheSameWithOriginsKept) {
  test::Scatter random(41);
  const std::string nci = bytes_of(corpus() / "five_axis.nci");
  ReadOptions keeping;
  keeping.keeps_origins = true;
  std::size_t corrected = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string text = mutated(i % 3 == 0 ? kApt : i % 3 == 1 ? kClsf : nci, random);
    const ReadOutcome plain = read_toolpath("mutated", text), kept = read_toolpath("mutated", text, keeping);
    ASSERT_EQ(plain.toolpath.has_value(), kept.toolpath.has_value());
    if (!plain.toolpath) continue;
    ASSERT_FALSE(plain.toolpath->origins);
    ASSERT_TRUE(kept.toolpath->origins);
    const std::vector<PathChange> changes = changes_everywhere(*plain.toolpath);
    const Result<std::string> again = write_corrected(*plain.toolpath, changes);
    const Result<std::string> once = write_corrected(*kept.toolpath, changes);
    ASSERT_EQ(again.has_value(), once.has_value()) << text;
    if (again) {
      ASSERT_EQ(*again, *once) << text;
    } else {
      ASSERT_EQ(again.error().message, once.error().message) << text;
    }
    if (again) ++corrected;
  }
  EXPECT_GT(corrected, 500u);
}

}  // namespace
}  // namespace gouge::mutation_test
