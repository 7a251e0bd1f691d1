// Holes of drilling cycles that go elsewhere: one GOTO is all that changes.
#include <set>

#include "postproc/formats/write_corrected.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/corrected.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::rewrite_hole_test {
namespace {

PathChange shifted(std::size_t move, const Vec3& by) {
  PathChange change;
  change.move = move;
  change.hole_shift_mm = by;
  return change;
}

// They point into the path.
std::vector<const Move*> moves_of(const Toolpath& path, std::size_t line) {
  std::vector<const Move*> moves;
  for (const Move& move : path.moves) {
    if (move.line == line) moves.push_back(&move);
  }
  return moves;
}

Vec3 lowest(const std::vector<const Move*>& moves) {
  return (*std::min_element(
              moves.begin(), moves.end(),
              [](const Move* a, const Move* b) { return a->end.tip.dot(a->end.axis) < b->end.tip.dot(b->end.axis); }))
      ->end.tip;
}

TEST(RewriteHole, ItsPositionAloneChangesAndAllHeightsWithIt) {
  const std::string text =
      "TOOL PATH/A,TOOL,B\nCYCLE/DRILL,RAPTO,3.0000,FEDTO,-10.0000,RTRCTO,5.0000,MMPM,250.0000\n"
      "GOTO/66.0000,0.0000,24.0000,0.0000000,0.0000000,1.0000000\nGOTO/70.0000,0.0000,24.0000\n"
      "CYCLE/OFF\nEND-OF-PATH\n";
  const Toolpath path = path_of(text);
  const RewritableMoves can = rewritable_moves(path);
  const std::vector<const Move*> second = moves_of(path, 4);
  ASSERT_GE(second.size(), 3u);
  const auto first = static_cast<std::size_t>(second.front() - path.moves.data());
  EXPECT_TRUE(can.hole[first]);
  EXPECT_FALSE(can.hole[first + 1]) << "one change for the whole hole";
  const std::string result = written(path, {shifted(first, Vec3(0.25, 0, 0.5))});
  std::string expected = text;
  expected.replace(expected.find("GOTO/70.0000,0.0000,24.0000"), 27, "GOTO/70.2500,0.0000,24.5000");
  EXPECT_EQ(result, expected);
  const Toolpath after = path_of(result);
  expect_vector(lowest(moves_of(after, 4)) - lowest(second), 0.25, 0, 0.5, 1e-9);
}

TEST(RewriteHole, OneOfAListMovesAlone) {
  const Toolpath path =
      path_of("CYCLE/DRILL,DEPTH,10,MMPM,100,CLEAR,2\nGOTO/0.,0.,0.,10.,0.,0.,20.,0.,0.\nCYCLE/OFF\nFINI\n");
  const RewritableMoves can = rewritable_moves(path);
  std::vector<std::size_t> holes;
  for (std::size_t i = 0; i < can.hole.size(); ++i) {
    if (can.hole[i]) holes.push_back(i);
  }
  if (holes.empty()) GTEST_SKIP() << "the dialect reads no such cycle";
  ASSERT_EQ(holes.size(), 3u);
  EXPECT_EQ(written(path, {shifted(holes[1], Vec3(0, 0, 0.011))}),
            "CYCLE/DRILL,DEPTH,10,MMPM,100,CLEAR,2\nGOTO/0.,0.,0.,10.,0.,0.011,20.,0.,0.\nCYCLE/OFF\nFINI\n");
}

TEST(RewriteHole, EveryHoleOfEveryFileCanBeRaised) {
  std::set<std::string> dialects;
  for (const std::filesystem::path& file : all_cl_files()) {
    SCOPED_TRACE(file.filename().string());
    const ReadOutcome outcome = read_toolpath(file.filename().string(), bytes_of(file));
    if (!outcome.toolpath) continue;
    const Toolpath& path = *outcome.toolpath;
    const RewritableMoves can = rewritable_moves(path);
    std::size_t rewritten = 0;
    for (std::size_t i = 0; i < path.moves.size() && rewritten < 20; ++i) {
      if (!can.hole[i]) continue;
      const Vec3 shift = 0.0321 * path.moves[i].end.axis;
      const Result<std::string> text = write_corrected(path, {shifted(i, shift)});
      ASSERT_TRUE(text.has_value()) << to_text(text.error());
      ReadOptions options;
      options.dialect = dialect_called(path.dialect);
      const ReadOutcome again = read_toolpath(path.file, *text, options);
      ASSERT_TRUE(again.toolpath) << to_text(again.errors.front());
      const SourceStatement& span = path.statements[path.moves[i].statement];
      EXPECT_EQ(text->substr(0, span.first_byte), path.source.substr(0, span.first_byte));
      EXPECT_TRUE(text->ends_with(path.source.substr(span.last_byte)));
      const std::vector<const Move*> before = moves_of(path, path.moves[i].line);
      const std::vector<const Move*> after = moves_of(*again.toolpath, path.moves[i].line);
      const bool is_one_hole = std::count_if(before.begin(), before.end(), [&](const Move* move) {
                                 return can.hole[static_cast<std::size_t>(move - path.moves.data())];
                               }) == 1;
      if (is_one_hole) {
        EXPECT_LE((after.back()->end.tip - before.back()->end.tip - shift).norm(), 3e-4);
        EXPECT_LE((lowest(after) - lowest(before) - shift).norm(), 3e-4);
      }
      ++rewritten;
    }
    if (rewritten > 0) dialects.insert(path.dialect);
  }
  for (const char* dialect : {"apt", "apt-camplete", "apt-catia", "apt-creo", "apt-mori", "nx-clsf"})
    EXPECT_TRUE(dialects.contains(dialect)) << dialect;
}

TEST(RewriteHole, WhatIsCountedFromAHoleKeepsIt) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nCYCLE/DRILL,RAPTO,3.0000,FEDTO,-10.0000,RTRCTO,5.0000\n"
      "GOTO/66.0000,0.0000,24.0000,0.0000000,0.0000000,1.0000000\nGODLTA/10.0000,0.0000,0.0000\nCYCLE/"
      "OFF\nEND-OF-PATH\n");
  for (const bool can : rewritable_moves(path).hole) EXPECT_FALSE(can);
  const Result<std::string> text = write_corrected(path, {shifted(0, Vec3(0, 0, 1))});
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().code, "write-arc");
}

TEST(RewriteHole, NothingElseOfAHoleCanChangeWithIt) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nCYCLE/DRILL,RAPTO,3.0000,FEDTO,-10.0000,RTRCTO,5.0000\n"
      "GOTO/66.0000,0.0000,24.0000,0.0000000,0.0000000,1.0000000\nCYCLE/OFF\nEND-OF-PATH\n");
  PathChange change = shifted(0, Vec3(0, 0, 1));
  change.new_end = path.moves[0].end;
  const Result<std::string> text = write_corrected(path, {change});
  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().code, "write-move");
}

}  // namespace
}  // namespace gouge::rewrite_hole_test
