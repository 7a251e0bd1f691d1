// Corrections of binary NCCS files: arcs that become straight positions, and what stays as it was.
#include "lib/path/chords.h"
#include "postproc/formats/write_corrected.h"
#include "postproc/formats/write_toolpath.h"
#include "tests/postproc/cldata/nccs_file.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/postproc/cldata/same_moves.h"

namespace gouge::straighten_nccs_test {
namespace {

PathChange straightening(const Toolpath& path, std::size_t move) {
  PathChange change;
  change.move = move;
  change.is_straightened = true;
  change.inserted_before = chords_of(path, move, 0.1);
  change.inserted_before.pop_back();
  return change;
}

Toolpath corrected(const Toolpath& path, const std::vector<PathChange>& changes) {
  const Result<std::string> bytes = write_corrected(path, changes);
  if (!bytes) {
    ADD_FAILURE() << to_text(bytes.error());
    return {};
  }
  EXPECT_EQ(bytes->size() % 288, 0u);
  return path_of(*bytes);
}

std::string refusal(const Toolpath& path, const std::vector<PathChange>& changes) {
  const Result<std::string> bytes = write_corrected(path, changes);
  return bytes ? "written" : bytes.error().code;
}

// Two arcs with a line between, then a rapid.
NccsFile two_arcs() {
  NccsFile file;
  file.multax(true).post(1055, {1.0}).points({5, 0, 1, 0, 0, 1}).circle({0, 0, 1, 0, 0, 1, 5});
  file.points({0, 5, 1, 0, 0, 1})
      .points({-4, 5, 1, 0, 0, 1})
      .circle({-4, 9, 1, 0, 0, 1, 4})
      .points({-8, 9, 1, 0, 0, 1});
  file.post(5).points({-8, 9, 50, 0, 0, 1});
  return file;
}

std::size_t count_circles(std::string_view bytes) {
  const NccsWords words(bytes);
  std::size_t circles = 0;
  for (std::size_t word = 0; word < words.words() && words.header(word).words > 0; word += words.header(word).words) {
    circles += words.header(word).klass == NccsClass::kCircle ? 1U : 0U;
    if (words.header(word).klass == NccsClass::kFini) break;
  }
  return circles;
}

TEST(StraightenNccs, TheCircleGoesAndTheArcBesideStays) {
  const Toolpath path = path_of(two_arcs().bytes());
  ASSERT_EQ(path.arcs.size(), 2u);
  PathChange change = straightening(path, 1);
  change.inserted_before.at(1).tip.z() += 1;
  const Result<std::string> bytes = write_corrected(path, {change});
  ASSERT_TRUE(bytes);
  EXPECT_EQ(count_circles(path.source), 2u);
  EXPECT_EQ(count_circles(*bytes), 1u);
  const Toolpath after = path_of(*bytes);
  const std::size_t more = change.inserted_before.size();
  ASSERT_EQ(after.moves.size(), path.moves.size() + more);
  for (std::size_t i = 1; i <= more; ++i) {
    EXPECT_EQ(after.moves[i].curve_kind, CurveKind::none);
    EXPECT_LE((after.moves[i].end.tip - change.inserted_before[i - 1].tip).norm(), 1e-12);
  }
  expect_vector(after.moves[1 + more].end.tip, 0, 5, 1);
  EXPECT_EQ(after.moves[3 + more].curve_kind, CurveKind::arc);
  EXPECT_EQ(after.moves[4 + more].kind, MoveKind::rapid);
  for (const Move& move : after.moves) EXPECT_TRUE(move.not_checked_reason.empty());
}

TEST(StraightenNccs, AnArcThatStaysMayNotLoseItsStart) {
  const Toolpath path = path_of(two_arcs().bytes());
  PathChange change;
  change.move = 2;
  change.new_end = Pose{Vec3(-4, 5, 3), Vec3::UnitZ()};
  EXPECT_EQ(refusal(path, {change}), "write-arc");
  EXPECT_EQ(refusal(path, {change, straightening(path, 3)}), "written");
  change.new_end.reset();
  change.inserted_before.push_back({Vec3(-2, 5, 9), Vec3::UnitZ()});
  const Toolpath after = corrected(path, {change});
  ASSERT_EQ(after.moves.size(), path.moves.size() + 1);
  EXPECT_EQ(after.arcs.size(), 2u);
}

// One circle, four points of which two stand in a continuation record.
NccsFile list_on_circle() {
  NccsFile file;
  file.multax(false).points({5, 0, 0}).circle({0, 0, 0, 0, 0, 1, 5});
  file.points({4, 3, 0, 3, 4, 0, 0, 5, 0, -3, 4, 0}, 6).points({-9, 4, 0});
  return file;
}

TEST(StraightenNccs, AllPointsOnOneCircleMayGo) {
  const Toolpath path = path_of(list_on_circle().bytes());
  ASSERT_EQ(path.arcs.size(), 4u);
  std::vector<PathChange> all;
  for (std::size_t i = 1; i <= 4; ++i) all.push_back(straightening(path, i));
  const Toolpath after = corrected(path, all);
  EXPECT_TRUE(after.arcs.empty());
  std::size_t more = 0;
  for (const PathChange& change : all) more += change.inserted_before.size();
  EXPECT_EQ(after.moves.size(), path.moves.size() + more);
  expect_vector(after.moves.back().end.tip, -9, 4, 0);
}

TEST(StraightenNccs, ThoseThatStayGetACircleOfTheirOwn) {
  const Toolpath path = path_of(list_on_circle().bytes());
  for (std::size_t gone = 1; gone <= 4; ++gone) {
    SCOPED_TRACE(gone);
    const PathChange change = straightening(path, gone);
    const std::size_t more = change.inserted_before.size();
    const Toolpath after = corrected(path, {change});
    ASSERT_EQ(after.moves.size(), path.moves.size() + more);
    EXPECT_EQ(count_circles(after.source), 3u);
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Move& before = path.moves[i];
      const Move& now = after.moves[i < gone ? i : i + more];
      EXPECT_EQ(now.end.tip, before.end.tip);
      EXPECT_EQ(now.not_checked_reason, "");
      EXPECT_EQ(now.curve_kind, i == gone ? CurveKind::none : before.curve_kind);
      if (now.curve_kind != CurveKind::arc) continue;
      EXPECT_NEAR(after.arcs[now.curve].sweep_rad, path.arcs[before.curve].sweep_rad, 1e-12);
    }
  }
}

TEST(StraightenNccs, AListThatBeginsWhereTheToolStandsMayBecomeStraight) {
  NccsFile file;
  file.multax(false).points({5, 0, 0}).circle({0, 0, 0, 0, 0, 1, 5}).points({5, 0, 0, 3, 4, 0, 0, 5, 0});
  const Toolpath path = path_of(file.bytes());
  ASSERT_EQ(path.arcs.size(), 2u);
  const Toolpath after = corrected(path, {straightening(path, 2), straightening(path, 3)});
  EXPECT_TRUE(after.arcs.empty());
  for (const Move& move : after.moves) EXPECT_TRUE(move.not_checked_reason.empty());
}

TEST(StraightenNccs, TiltedChordsUnderMultaxOffSwitchItOn) {
  const Toolpath path = path_of(list_on_circle().bytes());
  PathChange change;
  change.move = 5;
  change.inserted_before.push_back({Vec3(-6, 4, 2), Vec3(0, 0.6, 0.8)});
  const Toolpath after = corrected(path, {change});
  ASSERT_EQ(after.moves.size(), path.moves.size() + 1);
  expect_vector(after.moves[5].end.axis, 0, 0.6, 0.8);
  expect_vector(after.moves[6].end.axis, 0, 0, 1);
}

TEST(CorrectNccs, AChangedPointOfExpandedMotionBecomesPlainAndTheOthersStay) {
  NccsFile file;
  file.multax(true).expanded({1, 2, 3, 0, 0, 1, 4, 5, 6, 0, 0.6, 0.8, 7, 8, 9, 0, 0, -1});
  const Toolpath path = path_of(file.bytes());
  PathChange change;
  change.move = 1;
  change.new_end = Pose{Vec3(4, 5, 7), Vec3(0, 0.6, 0.8)};
  change.inserted_before.push_back({Vec3(2, 3, 4), Vec3(0, 0, 1)});
  const Result<std::string> bytes = write_corrected(path, {change});
  ASSERT_TRUE(bytes);
  const Toolpath after = path_of(*bytes);
  ASSERT_EQ(after.moves.size(), 4u);
  expect_vector(after.moves[1].end.tip, 2, 3, 4);
  expect_vector(after.moves[2].end.tip, 4, 5, 7);
  expect_vector(after.moves[3].end.tip, 7, 8, 9);
  expect_vector(after.moves[3].end.axis, 0, 0, -1);
  std::size_t expanded = 0;
  const NccsWords words(*bytes);
  for (std::size_t word = 0; words.header(word).klass != NccsClass::kFini; word += words.header(word).words)
    expanded += words.header(word).klass == NccsClass::kExpanded ? 1U : 0U;
  EXPECT_EQ(expanded, 2u);
}

TEST(CorrectNccs, AHoleCannotBeChanged) {
  NccsFile file;
  file.multax(true).points({0, 0, 9, 0, 0, 1}).post(1054, {Minor{163}, Minor{281}, 5.0, Minor{280}, 1.0});
  file.points({10, 0, 0, 0, 0, 1}).post(1054, {Minor{72}}).points({20, 0, 9, 0, 0, 1});
  const Toolpath path = path_of(file.bytes());
  PathChange change;
  change.move = 1;
  change.new_end = path.moves[1].end;
  EXPECT_EQ(refusal(path, {change}), "write-arc");
  change.move = path.moves.size() - 1;
  change.new_end = Pose{Vec3(20, 0, 12), Vec3::UnitZ()};
  const Toolpath after = corrected(path, {change});
  ASSERT_EQ(after.moves.size(), path.moves.size());
  expect_vector(after.moves.back().end.tip, 20, 0, 12);
}

TEST(ConvertToNccs, ShortPlanarArcsStayArcs) {
  const Toolpath path = path_of(
      "UNITS/MM\nMODE/MILL\nGOTO/5.000000, 0.000000, 1.000000\nMOVARC/0.000000, 0.000000, 1.000000, 0.000000, "
      "0.000000, 1.000000, 5.000000, ANGLE, 90.000000\nGOTO/0.000000, 5.000000, 1.000000\nMOVARC/0.000000, 0.000000, "
      "1.000000, 0.000000, 0.000000, 1.000000, 5.000000, ANGLE, 270.000000\nGOTO/5.000000, 0.000000, 1.000000\nFINI\n");
  ASSERT_EQ(path.arcs.size(), 2u);
  const Result<WrittenToolpath> written = write_toolpath(path, dialect_of(DialectKind::nccs_binary));
  ASSERT_TRUE(written);
  EXPECT_EQ(count_circles(written->bytes), 1u) << "three quarters of a turn would be read as one quarter";
  for (const Diagnostic& note : written->notes) EXPECT_NE(note.code, "convert-verify");
  const Toolpath again = path_of(written->bytes);
  ASSERT_EQ(again.arcs.size(), 1u);
  EXPECT_NEAR(again.arcs[0].sweep_rad * again.arcs[0].axis.z(), path.arcs[0].sweep_rad, 1e-9);
  EXPECT_GT(again.moves.size(), 20u);
}

}  // namespace
}  // namespace gouge::straighten_nccs_test
