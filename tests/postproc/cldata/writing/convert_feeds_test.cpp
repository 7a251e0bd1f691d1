// A path written in another dialect runs at rapid where it did, at the feeds it had and with the tools it had.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/write_toolpath.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/postproc/cldata/written_states.h"

namespace gouge::convert_feeds_test {
namespace {

bool is_written_with_feeds(const Dialect& dialect) {
  return dialect.kind != DialectKind::nci && dialect.kind != DialectKind::goto_list;
}

// Effect of the written bytes: by the test's own scanner where they are text.
MotionStates states_in(const std::string& bytes, const Dialect& dialect, LengthUnit unit) {
  if (dialect.kind != DialectKind::nccs_binary) return scan_states(bytes, unit);
  ReadOptions options;
  options.dialect = dialect;
  options.unit = unit;
  const ReadOutcome again = read_toolpath("again", bytes, options);
  EXPECT_TRUE(again.toolpath);
  return again.toolpath ? states_of(*again.toolpath) : MotionStates{};
}

void expect_kept(const Toolpath& path, const Dialect& dialect) {
  const Result<WrittenToolpath> written = write_toolpath(path, dialect);
  ASSERT_TRUE(written) << path.file << " to " << dialect.id << ": " << to_text(written.error());
  const MotionStates wanted = states_of(path), found = states_in(written->bytes, dialect, path.unit);
  EXPECT_TRUE(are_same(found, wanted)) << path.file << " to " << dialect.id << "\nfound\n"
                                       << text_of(found) << "expected\n"
                                       << text_of(wanted) << written->bytes;
}

std::string refusal(const std::string& text, DialectKind target) {
  const Result<WrittenToolpath> written = write_toolpath(path_of(text), dialect_of(target));
  return written ? "written" : written.error().code;
}

constexpr const char* kHead = "PARTNO A\nUNITS/MM\nCUTTER/6\nLOADTL/1\nRAPID\nGOTO/0,0,50\n";

// Each ends in a plunge to z = -15 at 120 mm/min, whatever stands before.
TEST(ConvertFeeds, APlungeHasTheFeedOfItsCycle) {
  const std::string nx = "TOOL PATH/A,TOOL,B\nTLDATA/MILL,6,0,50,0,0\nLOAD/TOOL,1\nRAPID\nGOTO/0,0,50\n";
  const std::string creo = "$$* Pro/CLfile\nUNITS / MM\nLOADTL / 1\nRAPID\nGOTO / 0, 0, 50\n";
  const std::vector<std::string> texts = {
      std::string(kHead) + "CYCLE/DRILL,RAPTO,2,FEDTO,-15,RTRCTO,5,MMPM,120\nGOTO/20,10,0\nCYCLE/OFF\nFINI\n",
      std::string(kHead) +
          "FEDRAT/2000,MMPM\nGOTO/1,0,50\nCYCLE/DRILL,RAPTO,2,FEDTO,15,MMPM,120\nGOTO/20,10,0\nCYCLE/OFF\nFINI\n",
      nx + "CYCLE/DRILL,RAPTO,2,FEDTO,-15,MMPM,120\nGOTO/20,10,0\nCYCLE/OFF\nEND-OF-PATH\n",
      nx +
          "UNITS/MM\nFEDRAT/MMPM,2000\nGOTO/1,0,50\nCYCLE/DRILL,DEEP,RAPTO,2,FEDTO,-15,IPM,4.724409448819\nGOTO/20,10,0\nCYCLE/"
          "OFF\nEND-OF-PATH\n",
      creo + "CYCLE / DEEP, DEPTH, 15, STEP, 1, MMPM, 120, CLEAR,$\n 2\nGOTO / 20, 10, 0\nCYCLE / OFF\nFINI\n",
      "UNIT/MM\nCUTTER/6.,0,3.,0,0,0,50.\nLOAD/TOOL,1\nTRNTYP/WORLD,0,0,0\nRAPID/\nGOTO/0,0,50.\n"
      "CYCLE/DRILL,FEDTO,15.,MMPM,120.,RAPTO,2.,RTRCTO,25.,DWELL,0\nGOTO/20.,10.,0\nCYCLE/OFF\nFINI\n",
      "UNITS/ MM\nCUTTER/ 6,0,3,0,0,0,50,\nOPFEATSTART/A\nRAPID/\nGOTO/ 0,0,50\nCYCLE/ ON\n"
      "CYCLE/ DRILL,G98,15,PECKING,5,2,MMPM,120,2,46 46 DWELL,0\nGOTO/ 20,10,0\nCYCLE/ OFF\nFINI\n",
      "$$     CATIA APT VERSION 1.0\nCUTTER/ 6\nTOOLNO/1, 6\nLOADTL/1\nRAPID\nGOTO / 0,0,50\nFEDRAT/ 300,MMPM\n"
      "CYCLE/DRILL,DEPTH, 15,MMPM, 120,CLEAR, 2,$\nRETURN, 9\nGOTO / 20,10,0\nCYCLE/OFF\nEND\n"};
  for (const std::string& text : texts) {
    const Toolpath path = path_of(text);
    const auto plunge = std::find_if(path.moves.begin(), path.moves.end(),
                                     [](const Move& move) { return std::abs(move.end.tip.z() + 15) <= 1e-9; });
    ASSERT_NE(plunge, path.moves.end()) << text;
    EXPECT_EQ(plunge->feed_unit, FeedUnit::per_minute) << text;
    EXPECT_NEAR(plunge->feed_mm, 120, 1e-6) << text;
    for (const Dialect& dialect : all_dialects()) {
      if (is_written_with_feeds(dialect)) expect_kept(path, dialect);
    }
  }
}

TEST(ConvertFeeds, APlungeWithoutAFeedStaysAFeedMove) {
  const std::string cycle = "CYCLE/DRILL,RAPTO,2,FEDTO,15\nGOTO/20,10,0\nCYCLE/OFF\nFINI\n";
  for (const Dialect& dialect : all_dialects()) {
    if (!is_written_with_feeds(dialect)) continue;
    expect_kept(path_of(kHead + cycle), dialect);
    const Result<WrittenToolpath> written = write_toolpath(path_of(kHead + cycle), dialect);
    EXPECT_TRUE(std::any_of(written->notes.begin(), written->notes.end(), [](const Diagnostic& note) {
      return note.code == "convert-feed";
    })) << dialect.id;
    expect_kept(path_of(std::string(kHead) + "FEDRAT/90,MMPM\n" + cycle), dialect);
  }
}

// NX states no feed in the second block; elsewhere that of the first one would still be in force.
TEST(ConvertFeeds, AMoveWithoutAFeedIsNotRunAtAnEarlierOne) {
  const std::string block = "TOOL PATH/A,TOOL,B\nTLDATA/MILL,6,0,50,0,0\nLOAD/TOOL,1\nRAPID\nGOTO/0,0,50\n";
  const std::string text = block + "FEDRAT/MMPM,2000\nGOTO/0,0,0\nEND-OF-PATH\n" + block + "GOTO/0,0,0\nEND-OF-PATH\n";
  EXPECT_EQ(refusal(text, DialectKind::creo), "convert-feed");
  EXPECT_EQ(refusal(text, DialectKind::nccs_binary), "convert-feed");
  expect_kept(path_of(text), dialect_of(DialectKind::nx_clsf));
}

TEST(ConvertFeeds, AreKeptPerRevolution) {
  const std::string text =
      std::string(kHead) +
      "FEDRAT/2000,MMPM\nGOTO/0,0,20\nFEDRAT/0.08,MMPR\nGOTO/0,0,10\nFEDRAT/IPR,.00025\nGOTO/0,0,5\n"
      "CYCLE/DRILL,RAPTO,2,FEDTO,15,MMPR,0.05\nGOTO/20,10,0\nCYCLE/OFF\nFEDRAT/500,MMPM\nGOTO/0,0,60\nFINI\n";
  const Toolpath path = path_of(text);
  EXPECT_EQ(path.moves.at(2).feed_unit, FeedUnit::per_revolution);
  EXPECT_NEAR(path.moves.at(3).feed_mm, 0.00635, 1e-12);
  for (const Dialect& dialect : all_dialects()) {
    if (is_written_with_feeds(dialect)) expect_kept(path, dialect);
  }
}

TEST(ConvertFeeds, ThatAreNotUnderstoodAreRefused) {
  for (const char* feed : {"FEDRAT/INVERS,2.5", "FEDRAT/100,MMPM,IPM", "FEDRAT/0", "FEDRAT/-5,MMPM", "FEDRAT/100,200",
                           "FEDRAT/0.1,MMPR\nFEDRAT/0.2", "FEDRAT/AUTO"}) {
    const std::string text = std::string(kHead) + "FEDRAT/100,MMPM\nGOTO/0,0,20\n" + feed + "\nGOTO/0,0,10\nFINI\n";
    EXPECT_EQ(refusal(text, DialectKind::nx_clsf), "convert-feed") << feed;
    EXPECT_EQ(refusal(text, DialectKind::goto_list), "written") << feed;
  }
  for (const char* feed : {"MMPM", "MMPM,120,IPM,4", "TPI,20", "FEDRAT,120", "MMPM,0"}) {
    const std::string text = std::string(kHead) + "FEDRAT/100,MMPM\nGOTO/0,0,20\nCYCLE/DRILL,RAPTO,2,FEDTO,15," + feed +
                             "\nGOTO/20,10,0\nCYCLE/OFF\nFINI\n";
    EXPECT_EQ(refusal(text, DialectKind::creo), "convert-feed") << feed;
  }
  EXPECT_EQ(refusal(std::string(kHead) + "FEDRAT/100,MMPM\nFEDRAT/INVERS,AUTO\nGOTO/0,0,20\nFINI\n", DialectKind::creo),
            "written");
}

TEST(ConvertFeeds, OfAFileInInches) {
  const std::string text =
      "PARTNO A\nUNITS/INCHES\nCUTTER/.5\nLOADTL/1\nRAPID\nGOTO/0,0,5\nFEDRAT/20\nGOTO/0,0,1\n"
      "FEDRAT/254,MMPM\nGOTO/0,0,.5\nFEDRAT/7.5,IPM\nGOTO/0,0,0\nFEDRAT/.001,IPR\nGOTO/1,0,0\nFINI\n";
  for (const Dialect& dialect : all_dialects()) {
    if (is_written_with_feeds(dialect)) expect_kept(path_of(text), dialect);
  }
}

TEST(ConvertFeeds, ReamedAndBoredHolesAreLeftAtTheFeed) {
  for (const std::string type : {"REAM", "BORE"}) {
    const Toolpath path =
        path_of(std::string(kHead) + "CYCLE/" + type + ",RAPTO,2,FEDTO,15,MMPM,120\nGOTO/20,10,0\nCYCLE/OFF\nFINI\n");
    EXPECT_EQ(path.moves.back().feed_unit, FeedUnit::per_minute) << type;
    expect_kept(path, dialect_of(DialectKind::creo));
  }
}

// Plain moves would pull the tap out while the spindle still turns in.
TEST(ConvertFeeds, ATapIsNotWrittenAsPlainMoves) {
  const std::string text = std::string(kHead) + "CYCLE/TAP,RAPTO,2,FEDTO,15,MMPR,1.25\nGOTO/20,10,0\nCYCLE/OFF\nFINI\n";
  EXPECT_EQ(refusal(text, DialectKind::nx_clsf), "convert-cycle");
  EXPECT_EQ(refusal(text, DialectKind::goto_list), "written");
}

// RAPID holds for one motion; an arc or spline that is written as chords needs one for each.
TEST(ConvertFeeds, ARapidArcIsRapidInAllItsChords) {
  const Toolpath path = path_of(
      "TOOL "
      "PATH/A,TOOL,B\nTLDATA/MILL,6,0,50,0,0\nLOAD/TOOL,1\nRAPID\nGOTO/10,0,5\nFEDRAT/MMPM,300\nGOTO/10,0,0\nRAPID\n"
      "CIRCLE/0,0,0,0,0,-1,10,.06,.5,6,0\nGOTO/-10,0,0\nGOTO/-10,0,5\nEND-OF-PATH\n");
  EXPECT_EQ(path.moves.at(2).feed_unit, FeedUnit::rapid);
  EXPECT_EQ(path.moves.at(3).feed_unit, FeedUnit::per_minute);
  for (const Dialect& dialect : all_dialects()) {
    if (is_written_with_feeds(dialect)) expect_kept(path, dialect);
  }
}

// Our samples of every dialect and the real files: what can be converted keeps its rapids, feeds and tools.
TEST(ConvertFeeds, OfAllSamplesAreKeptInAllDialects) {
  std::size_t written = 0, refused = 0;
  for (const auto& file : all_cl_files()) {
    const ReadOutcome outcome = read_toolpath(file.string(), bytes_of(file));
    if (!outcome.toolpath) continue;
    for (const Dialect& dialect : all_dialects()) {
      if (!is_written_with_feeds(dialect)) continue;
      if (const Result<WrittenToolpath> result = write_toolpath(*outcome.toolpath, dialect); !result) {
        ++refused;
        EXPECT_TRUE(result.error().code.starts_with("convert-")) << result.error().message;
        continue;
      }
      expect_kept(*outcome.toolpath, dialect);
      ++written;
    }
  }
  EXPECT_GE(written, 100u) << refused << " refused";
}

}  // namespace
}  // namespace gouge::convert_feeds_test
