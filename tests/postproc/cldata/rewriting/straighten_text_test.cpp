// Arcs and splines that become straight positions, in the file's own way of writing them.
#include "lib/path/chords.h"
#include "postproc/formats/write_corrected.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::straighten_text_test {
namespace {

struct Written {
  Toolpath before, after;
  std::string text;
  std::size_t chords = 0;
};

// The curve that is move `index` becomes chords, the second of which is lifted.
Written straightened(const std::string& text, std::size_t index) {
  Written w;
  w.before = path_of(text);
  PathChange change;
  change.move = index;
  change.is_straightened = true;
  change.inserted_before = chords_of(w.before, index, 0.1);
  w.chords = change.inserted_before.size();
  change.inserted_before.pop_back();
  change.inserted_before.at(1).tip.z() += 1;
  const Result<std::string> written = write_corrected(w.before, {change});
  if (!written) {
    ADD_FAILURE() << to_text(written.error());
    return w;
  }
  w.text = *written;
  w.after = path_of(w.text);
  return w;
}

void expect_chords(const Written& w, std::size_t index) {
  ASSERT_EQ(w.after.moves.size(), w.before.moves.size() + w.chords - 1);
  for (std::size_t i = 0; i < w.after.moves.size(); ++i) {
    EXPECT_EQ(w.after.moves[i].curve_kind, CurveKind::none) << i;
    EXPECT_TRUE(w.after.moves[i].not_checked_reason.empty()) << i;
    EXPECT_NEAR((w.after.moves[i].end.axis - w.before.moves[index].end.axis).norm(), 0, 1e-6) << i;
  }
  expect_vector(w.after.moves[index + w.chords - 1].end.tip - w.before.moves[index].end.tip, 0, 0, 0, 1e-4);
  EXPECT_NEAR(w.after.moves[index + 1].end.tip.z() - w.after.moves[index].end.tip.z(), 1, 0.2);
}

TEST(StraightenText, NxLosesTheCircleAndGainsItsOwnKindOfPosition) {
  const Written w = straightened(
      "TOOL PATH/A,TOOL,B\nGOTO/5.0000,0.0000,1.0000,0.0000000,0.0000000,1.0000000\n"
      "CIRCLE/0.0000,0.0000,1.0000,0.0000000,0.0000000,-1.0000000,5.0000,0.0600,0.5000,40.0000,1.0000\n"
      "PAINT/COLOR,31\nGOTO/0.0000,5.0000,1.0000\nGOTO/0.0000,9.0000,1.0000\nEND-OF-PATH\n",
      1);
  expect_chords(w, 1);
  EXPECT_EQ(w.text.find("CIRCLE"), std::string::npos);
  EXPECT_NE(w.text.find("PAINT/COLOR,31\nGOTO/"), std::string::npos);
  EXPECT_NE(w.text.find("GOTO/0.0000,5.0000,1.0000\nGOTO/0.0000,9.0000,1.0000\nEND-OF-PATH\n"), std::string::npos);
}

TEST(StraightenText, AutodeskKeepsItsBlanksAndDigits) {
  const Written w = straightened(
      "UNITS/MM\r\nGOTO/5.000000, 0.000000, 1.000000\r\nMOVARC/0.000000, 0.000000, 1.000000, 0.000000, 0.000000, "
      "1.000000, 5.000000, ANGLE, 90.000000\r\nGOTO/0.000000, 5.000000, 1.000000\r\nFINI\r\n",
      1);
  expect_chords(w, 1);
  EXPECT_EQ(w.text.find("MOVARC"), std::string::npos);
  EXPECT_NE(w.text.find("GOTO/0.000000, 5.000000, 1.000000\r\nFINI\r\n"), std::string::npos);
}

TEST(StraightenText, CatiaGetsPositionsInPlaceOfItsTlon) {
  const Written w = straightened(
      "$$ CATIA APT VERSION 1.0\r\nMULTAX\r\nGOTO  /    5.00000,    0.00000,    1.00000, 0.000000, 0.000000, "
      "1.000000\r\n"
      "AUTOPS\r\nINDIRV/    0.00000,    1.00000,    0.00000\r\n"
      "TLON,GOFWD/ (CIRCLE/ 0.00000, 0.00000, 1.00000,$\r\n 5.00000),ON,(LINE/ 0.00000, 0.00000, 1.00000,$\r\n"
      " 0.00000, 5.00000, 1.00000)\r\nGOTO  /    0.00000,    9.00000,    1.00000, 0.000000, 0.000000, "
      "1.000000\r\nEND\r\n",
      1);
  expect_chords(w, 1);
  EXPECT_EQ(w.text.find("TLON"), std::string::npos);
  EXPECT_EQ(w.text.find("INDIRV"), std::string::npos);
  EXPECT_NE(
      w.text.find(
          "GOTO  /    0.00000,    5.00000,    1.00000, 0.000000, 0.000000, 1.000000\r\nGOTO  /    0.00000,    9.0"),
      std::string::npos);
}

TEST(StraightenText, ANurbsGoesWithItsKnotsAndPoints) {
  const Written w = straightened(
      "TOOL PATH/A,TOOL,B\nGOTO/0.0000,0.0000,1.0000,0.0000000,0.0000000,1.0000000\nNURBS/\nKNOT/0.5000000,1.0000000\n"
      "CNTRL/5.0000,9.0000,1.0000\nCNTRL/9.0000,-9.0000,1.0000\nCNTRL/15.0000,9.0000,1.0000\n"
      "CNTRL/20.0000,0.0000,1.0000\nGOTO/30.0000,0.0000,1.0000\nEND-OF-PATH\n",
      1);
  expect_chords(w, 1);
  for (const char* word : {"NURBS", "KNOT", "CNTRL"}) EXPECT_EQ(w.text.find(word), std::string::npos) << word;
  EXPECT_NE(w.text.find("GOTO/20.0000,0.0000,1.0000\nGOTO/30.0000,0.0000,1.0000\n"), std::string::npos);
}

TEST(StraightenText, AnArcThatStaysMayNotLoseItsStart) {
  const Toolpath path =
      path_of("TRNTYP/WORLD,0,0,0\nGOTO/0,0,0\nGOTO/5.,0,0\nCIRCLE/0,0,0,0,0,1.\nGOTO/0,5.,0\nFINI\n");
  PathChange change;
  change.move = 1;
  change.new_end = Pose{Vec3(5, 0, 1), Vec3::UnitZ()};
  const Result<std::string> text = write_corrected(path, {change});
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().code, "write-arc");
}

}  // namespace
}  // namespace gouge::straighten_text_test
