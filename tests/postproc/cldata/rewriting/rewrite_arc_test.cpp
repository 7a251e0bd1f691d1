// Arcs that stay arcs with other numbers, in every dialect that describes them in text.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "lib/path/curve.h"
#include "postproc/formats/write_corrected.h"
#include "postproc/formats/write_toolpath.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/corrected.h"
#include "tests/postproc/cldata/path_of.h"
#include "tests/support/scatter.h"

namespace gouge::rewrite_arc_test {
namespace {

constexpr double kDigits_mm = 3e-4;  // half a digit of the file's, in each direction

Pose moved(Pose pose, const Vec3& by) {
  pose.tip += by;
  return pose;
}

// A smaller or larger circle about the same line.
Pose scaled(Pose pose, const PathArc& arc, double factor) {
  const Vec3 away = pose.tip - arc.center;
  const Vec3 height = away.dot(arc.axis) * arc.axis;
  pose.tip = arc.center + height + factor * (away - height);
  return pose;
}

bool is_full_circle(const Toolpath& path, std::size_t i) {
  return std::abs(path.arcs[path.moves[i].curve].sweep_rad) > 2 * std::numbers::pi - 1e-6;
}

// The arc of move `i` becomes `arc` from `start` to `end`; what follows it begins where it began.
std::vector<PathChange> only_this_arc(const Toolpath& path, const RewritableMoves& can, std::size_t i,
                                      const PathArc& arc, const Pose& start, const Pose& end) {
  std::vector<PathChange> changes{{i, end, {start}}};
  changes[0].new_arc = arc;
  if (i + 1 == path.moves.size() || !path.moves[i + 1].has_start) return changes;
  const Move& next = path.moves[i + 1];
  PathChange back{i + 1, std::nullopt, {path.moves[i].end}};
  if (next.kind == MoveKind::arc) {
    if (!can.arc[i + 1]) return {};
    back.new_arc = path.arcs[next.curve];
  }
  if (next.kind == MoveKind::cycle) return changes;
  changes.push_back(back);
  return changes;
}

// First and last byte, from the end, in which two texts differ.
std::pair<std::size_t, std::size_t> difference(std::string_view a, std::string_view b) {
  std::size_t first = 0, last = 0;
  while (first < std::min(a.size(), b.size()) && a[first] == b[first]) ++first;
  while (last < std::min(a.size(), b.size()) - first && a[a.size() - 1 - last] == b[b.size() - 1 - last]) ++last;
  return {first, last};
}

void expect_arc(const Toolpath& after, std::size_t at, const PathArc& arc, const Pose& start, const Pose& end) {
  ASSERT_LT(at, after.moves.size());
  const Move& move = after.moves[at];
  ASSERT_EQ(move.not_checked_reason, "");
  ASSERT_EQ(move.curve_kind, CurveKind::arc);
  const PathArc& found = after.arcs[move.curve];
  EXPECT_LE((found.center - arc.center).norm(), kDigits_mm);
  EXPECT_LE((found.sweep_rad * found.axis - arc.sweep_rad * arc.axis).norm(),
            2e-3 + 2e-3 / (start.tip - arc.center).norm());
  EXPECT_LE((move.end.tip - end.tip).norm(), kDigits_mm);
  EXPECT_LE((after.start_of(at).tip - start.tip).norm(), kDigits_mm);
}

// Only the arc's statements, and the one after it that leads back, differ.
void expect_rest_untouched(const Toolpath& path, const std::string& text, std::size_t i) {
  const std::size_t next = std::min(i + 1, path.moves.size() - 1);
  const auto [first, last] = difference(path.source, text);
  EXPECT_GE(first, path.statements[path.moves[i - 1].statement].last_byte);
  EXPECT_LE(path.source.size() - last,
            std::max(path.statements[path.moves[next].statement].last_byte.operator std::size_t(),
                     path.statements[path.moves[i].statement].last_byte.operator std::size_t()));
}

// `refused`, where given, counts what is refused; else nothing may be.
std::size_t rewrite_each_arc(const Toolpath& path, std::size_t most, std::size_t* refused = nullptr) {
  const RewritableMoves can = rewritable_moves(path);
  std::size_t rewritten = 0;
  for (std::size_t i = 1; i < path.moves.size() && rewritten < most; ++i) {
    if (!can.arc[i]) continue;
    SCOPED_TRACE("move " + std::to_string(i) + " at line " + std::to_string(path.moves[i].line));
    const PathArc& old = path.arcs[path.moves[i].curve];
    const Vec3 lift = 0.0321 * path.moves[i].end.axis;
    PathArc lifted = old;
    lifted.center += lift;
    const double factor = path.dialect == "apt-catia" ? 1.0 : 1.013;
    const Pose starts[] = {moved(path.start_of(i), lift), scaled(path.start_of(i), old, factor)};
    Pose ends[] = {moved(path.moves[i].end, lift), scaled(path.moves[i].end, old, factor)};
    if (is_full_circle(path, i)) ends[1].tip = starts[1].tip;
    const PathArc arcs[] = {lifted, old};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<PathChange> changes = only_this_arc(path, can, i, arcs[k], starts[k], ends[k]);
      if (changes.empty()) continue;
      const Result<std::string> text = write_corrected(path, changes);
      if (!text && refused != nullptr && text.error().code == "write-arc") {
        ++*refused;
        continue;
      }
      if (!text) {
        ADD_FAILURE() << to_text(text.error());
        continue;
      }
      ReadOptions options;
      options.dialect = dialect_called(path.dialect);
      options.is_cutcom_centre = true;
      const ReadOutcome again = read_toolpath(path.file, *text, options);
      if (!again.toolpath) {
        ADD_FAILURE() << to_text(again.errors.front());
        continue;
      }
      EXPECT_EQ(again.toolpath->moves.size(), path.moves.size() + changes.size());
      expect_arc(*again.toolpath, i + 1, arcs[k], starts[k], ends[k]);
      expect_rest_untouched(path, *text, i);
      ++rewritten;
    }
  }
  return rewritten;
}

TEST(RewriteArc, EveryArcOfEveryFileCanBeLiftedAndWidened) {
  std::set<std::string> dialects;
  for (const std::filesystem::path& file : all_cl_files()) {
    SCOPED_TRACE(file.filename().string());
    ReadOptions options;
    options.is_cutcom_centre = true;
    const ReadOutcome outcome = read_toolpath(file.filename().string(), bytes_of(file), options);
    if (!outcome.toolpath) continue;
    if (rewrite_each_arc(*outcome.toolpath, 40) > 0) dialects.insert(outcome.toolpath->dialect);
  }
  for (const char* dialect : {"apt-autodesk", "apt-camplete", "apt-catia", "apt-creo", "apt-mori", "nx-clsf"})
    EXPECT_TRUE(dialects.contains(dialect)) << dialect;
}

// The place of an arc or helix where it has made this share of its turn.
Pose place_on(const Toolpath& path, std::size_t i, double t) {
  const PathArc& arc = path.arcs[path.moves[i].curve];
  Pose pose = path.start_of(i);
  const double rise = (path.moves[i].end.tip - pose.tip).dot(arc.axis);
  pose.tip =
      arc.center + Eigen::AngleAxisd(t * arc.sweep_rad, arc.axis) * (pose.tip - arc.center) + t * rise * arc.axis;
  return pose;
}

// Each arc on its own: the middle of it becomes straight, what is before and after it stays round; or its end does.
std::size_t split_each_arc(const Toolpath& path, std::size_t most) {
  const RewritableMoves can = rewritable_moves(path);
  std::size_t split = 0;
  for (std::size_t i = 1; i < path.moves.size() && split < most; ++i) {
    const Move& move = path.moves[i];
    if (!can.split[i] || arc_length_mm(path.arcs[move.curve], path.start_of(i).tip, move.end.tip) < 0.5) continue;
    SCOPED_TRACE("move " + std::to_string(i) + " at line " + std::to_string(move.line));
    for (const bool is_end_round : {true, false}) {
      PathChange change{i, std::nullopt, {place_on(path, i, 0.45), place_on(path, i, 0.55)}};
      PathArc first = path.arcs[move.curve], last = first;
      first.sweep_rad *= 0.45;
      last.sweep_rad *= 0.45;
      change.inserted_arcs = {first, std::nullopt};
      if (is_end_round) change.new_arc = last;
      change.is_straightened = !is_end_round;
      const Result<std::string> text = write_corrected(path, {change});
      if (!text) {
        ADD_FAILURE() << to_text(text.error());
        continue;
      }
      ReadOptions options;
      options.dialect = dialect_called(path.dialect);
      options.is_cutcom_centre = true;
      const ReadOutcome again = read_toolpath(path.file, *text, options);
      if (!again.toolpath || again.toolpath->moves.size() != path.moves.size() + 2) {
        ADD_FAILURE() << "read as another path";
        continue;
      }
      expect_arc(*again.toolpath, i, first, path.start_of(i), change.inserted_before[0]);
      EXPECT_EQ(again.toolpath->moves[i + 1].curve_kind, CurveKind::none);
      EXPECT_LE((again.toolpath->moves[i + 1].end.tip - change.inserted_before[1].tip).norm(), kDigits_mm);
      if (is_end_round)
        expect_arc(*again.toolpath, i + 2, last, change.inserted_before[1], move.end);
      else
        EXPECT_EQ(again.toolpath->moves[i + 2].curve_kind, CurveKind::none);
      EXPECT_EQ(again.toolpath->moves[i + 2].end.tip, move.end.tip);
      expect_rest_untouched(path, *text, i);
      ++split;
    }
  }
  return split;
}

TEST(RewriteArc, EveryArcWithAPositionOfItsOwnCanBeSplit) {
  std::set<std::string> dialects;
  for (const std::filesystem::path& file : all_cl_files()) {
    SCOPED_TRACE(file.filename().string());
    ReadOptions options;
    options.is_cutcom_centre = true;
    const ReadOutcome outcome = read_toolpath(file.filename().string(), bytes_of(file), options);
    if (!outcome.toolpath) continue;
    if (split_each_arc(*outcome.toolpath, 40) > 0) dialects.insert(outcome.toolpath->dialect);
  }
  for (const char* dialect : {"apt-autodesk", "apt-camplete", "apt-creo", "apt-mori", "nx-clsf"})
    EXPECT_TRUE(dialects.contains(dialect)) << dialect;
  EXPECT_FALSE(dialects.contains("apt-catia")) << "an arc of CATIA is a TLON, whose start is where the tool stands";
}

// A line lost, doubled or moved: what is rewritable there is rewritten as anywhere. An inch in the middle of a file of
// mm may be too coarse for its digits.
TEST(RewriteArc, DamagedFilesToo) {
  test::Scatter random(12);
  std::size_t rewritten = 0, refused = 0;
  for (const std::filesystem::path& file : files_below(corpus())) {
    const std::string text = bytes_of(file);
    if (text.find('\0') != std::string::npos) continue;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size(); at += lines.back().size())
      lines.push_back(text.substr(at, std::min(text.find('\n', at), text.size() - 1) + 1 - at));
    for (int i = 0; i < 60 && !HasFailure(); ++i) {
      std::vector<std::string> damaged = lines;
      const auto any = [&] { return damaged.begin() + static_cast<std::ptrdiff_t>(random.next() % damaged.size()); };
      if (i % 3 == 0) damaged.erase(any());
      if (i % 3 == 1) damaged.insert(any(), *any());
      if (i % 3 == 2) std::swap(*any(), *any());
      std::string bytes;
      for (const std::string& line : damaged) bytes += line;
      const ReadOutcome outcome = read_toolpath(file.filename().string(), bytes);
      if (!outcome.toolpath) continue;
      SCOPED_TRACE(file.filename().string() + " " + std::to_string(i) + "\n" + bytes);
      rewritten += rewrite_each_arc(*outcome.toolpath, 4, &refused);
    }
  }
  EXPECT_GT(rewritten, 300u);
  EXPECT_LT(refused * 20, rewritten);
}

// Three quarter turns that lines lead to and from, so that dialects whose arcs have no sense have one too.
TEST(RewriteArc, EveryDialectWrittenCanBe) {
  const Toolpath path = path_of(
      "UNITS/MM\nGOTO/0.,-5.,1.\nGOTO/5.,-5.,1.\nCIRCLE/5.,0.,1.,0.,0.,1.,5.\nGOTO/10.,0.,1.\nGOTO/10.,10.,1.\n"
      "CIRCLE/5.,10.,1.,0.,0.,1.,5.\nGOTO/5.,15.,1.\nGOTO/0.,15.,1.\nCIRCLE/0.,10.,1.,0.,0.,1.,5.\nGOTO/-5.,10.,1.\n"
      "GOTO/-5.,0.,1.\nFINI\n");
  ASSERT_EQ(path.arcs.size(), 3u);
  for (const Dialect& dialect : all_dialects()) {
    SCOPED_TRACE(dialect.id);
    const Result<WrittenToolpath> written = write_toolpath(path, dialect);
    if (!written) continue;
    ReadOptions options;
    options.dialect = dialect;
    const ReadOutcome outcome = read_toolpath("test", written->bytes, options);
    ASSERT_TRUE(outcome.toolpath);
    if (outcome.toolpath->arcs.size() != 3) continue;
    const bool is_text = dialect.kind != DialectKind::nccs_binary;
    EXPECT_EQ(rewrite_each_arc(*outcome.toolpath, 100), is_text ? 6u : 0u);
  }
}

struct Example {
  const char* dialect;
  const char* before;
  std::string text;
  const char* rewritten;
};

// A quarter turn from (5, 0, 1) to (0, 5, 1), of which the plane is raised by 0.25 and the radius widened
// to 6.
TEST(RewriteArc, LooksLikeTheFilesOwnArcs) {
  const Example examples[] = {
      {"nx-clsf", "",
       "TOOL PATH/A,TOOL,B\nGOTO/5.0000,0.0000,1.0000,0.0000000,0.0000000,1.0000000\n"
       "CIRCLE/0.0000,0.0000,1.0000,0.0000000,0.0000000,-1.0000000,5.0000,0.0600,0.5000,40.0000,1.0000\n"
       "PAINT/COLOR,31\nGOTO/0.0000,5.0000,1.0000\nEND-OF-PATH\n",
       "TOOL PATH/A,TOOL,B\nGOTO/6.0000,0.0000,1.2500,0.0000000,0.0000000,1.0000000\n"
       "CIRCLE/0.0000,0.0000,1.2500,0.0000000,0.0000000,-1.0000000,6.0000,0.0600,0.5000,40.0000,1.0000\n"
       "PAINT/COLOR,31\nGOTO/0.0000,6.0000,1.2500\nEND-OF-PATH\n"},
      {"apt-autodesk", "",
       "UNITS/MM\r\nGOTO/5.000000, 0.000000, 1.000000\r\nMOVARC/0.000000, 0.000000, 1.000000, 0.000000, 0.000000, "
       "1.000000, 5.000000, ANGLE, 90.000000\r\nGOTO/0.000000, 5.000000, 1.000000\r\nFINI\r\n",
       "UNITS/MM\r\nGOTO/6.000000, 0.000000, 1.250000\r\nMOVARC/0.000000, 0.000000, 1.250000, 0.000000, 0.000000, "
       "1.000000, 6.000000, ANGLE, 90.000000\r\nGOTO/0.000000, 6.000000, 1.250000\r\nFINI\r\n"},
      {"apt-creo", "",
       "$$-> MFGNO / A\nUNITS / MM\nGOTO / 5.0000000000, 0.0000000000, 1.0000000000\n"
       "CIRCLE / 0.0000000000, 0.0000000000, 1.0000000000,  $\n0.0000000000, 0.0000000000, 1.0000000000,  "
       "5.0000000000\n"
       "GOTO / 0.0000000000, 5.0000000000, 1.0000000000\nFINI\n",
       "$$-> MFGNO / A\nUNITS / MM\nGOTO / 6.0000000000, 0.0000000000, 1.2500000000\n"
       "CIRCLE / 0.0000000000, 0.0000000000, 1.2500000000,  $\n0.0000000000, 0.0000000000, 1.0000000000,  "
       "6.0000000000\n"
       "GOTO / 0.0000000000, 6.0000000000, 1.2500000000\nFINI\n"},
      {"apt-catia", "",
       "$$ CATIA APT VERSION 1.0\r\nMULTAX\r\nGOTO  /    5.00000,    0.00000,    1.00000, 0.000000, 0.000000, "
       "1.000000\r\n"
       "AUTOPS\r\nINDIRV/    0.00000,    1.00000,    0.00000\r\nTLON,GOFWD/      (CIRCLE/      0.00000,      0.00000,  "
       "    1.00000,$\r\n       5.00000),ON,(LINE/      0.00000,      0.00000,      1.00000,$\r\n"
       "                               0.00000,      5.00000,      1.00000)\r\nEND\r\n",
       "$$ CATIA APT VERSION 1.0\r\nMULTAX\r\nGOTO  /    6.00000,    0.00000,    1.25000, 0.000000, 0.000000, "
       "1.000000\r\n"
       "AUTOPS\r\nINDIRV/    0.00000,    1.00000,    0.00000\r\nTLON,GOFWD/      (CIRCLE/      0.00000,      0.00000,  "
       "    1.25000,$\r\n       6.00000),ON,(LINE/      0.00000,      0.00000,      1.25000,$\r\n"
       "                               0.00000,      6.00000,      1.25000)\r\nEND\r\n"},
  };
  for (const Example& example : examples) {
    SCOPED_TRACE(example.dialect);
    const Toolpath path = path_of(example.text);
    ASSERT_EQ(path.dialect, example.dialect);
    ASSERT_EQ(path.moves.size(), 2u);
    ASSERT_TRUE(rewritable_moves(path).arc[1]);
    PathChange start{0, Pose{Vec3(6, 0, 1.25), Vec3::UnitZ()}, {}}, arc{1, Pose{Vec3(0, 6, 1.25), Vec3::UnitZ()}, {}};
    arc.new_arc = path.arcs[0];
    arc.new_arc->center.z() = 1.25;
    EXPECT_EQ(written(path, {start, arc}), example.rewritten);
  }
}

TEST(RewriteArc, AVectorTurnedRoundIsTheSameArc) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nGOTO/5.0000,0.0000,1.0000,0.0000000,0.0000000,1.0000000\n"
      "CIRCLE/0.0000,0.0000,1.0000,0.0000000,0.0000000,-1.0000000,5.0000,0.0600,0.5000,40.0000,1.0000\n"
      "GOTO/0.0000,5.0000,1.0000\nEND-OF-PATH\n");
  PathChange arc{1, std::nullopt, {}};
  arc.new_arc = path.arcs[0];
  arc.new_arc->axis = -arc.new_arc->axis;
  arc.new_arc->sweep_rad = -arc.new_arc->sweep_rad;
  EXPECT_EQ(written(path, {arc}), path.source);
}

std::string refusal(const Toolpath& path, const std::vector<PathChange>& changes) {
  const Result<std::string> text = write_corrected(path, changes);
  return text ? "none" : text.error().code;
}

constexpr const char* kQuarter =
    "TOOL PATH/A,TOOL,B\nGOTO/5.0000,0.0000,1.0000,0.0000000,0.0000000,1.0000000\n"
    "CIRCLE/0.0000,0.0000,1.0000,0.0000000,0.0000000,-1.0000000,5.0000,0.0600,0.5000,40.0000,1.0000\n"
    "GOTO/0.0000,5.0000,1.0000\nGOTO/0.0000,9.0000,1.0000\nEND-OF-PATH\n";

TEST(RewriteArc, WhatIsNoArcBetweenItsEndsIsRefused) {
  const Toolpath path = path_of(kQuarter);
  PathChange arc{1, std::nullopt, {}};
  arc.new_arc = path.arcs[0];
  arc.new_arc->center.x() += 0.5;
  EXPECT_EQ(refusal(path, {arc}), "write-arc") << "its ends are off the circle";
  arc.new_arc = path.arcs[0];
  arc.new_arc->sweep_rad = path.arcs[0].sweep_rad + (path.arcs[0].sweep_rad < 0 ? 1 : -1) * -2 * std::numbers::pi;
  EXPECT_EQ(refusal(path, {arc}), "write-arc") << "the other way round";
  PathChange uneven{1, std::nullopt, {path.moves[1].end}};
  uneven.new_arc = path.arcs[0];
  uneven.inserted_arcs = {std::nullopt, path.arcs[0]};
  EXPECT_EQ(refusal(path, {uneven}), "write-arc") << "two arcs for one position";
  PathChange straight{2, std::nullopt, {}};
  straight.new_arc = path.arcs[0];
  EXPECT_EQ(refusal(path, {straight}), "write-arc") << "not an arc";
}

TEST(RewriteArc, SeveralTurnsAndListsOnOneCircleAreNotRewritable) {
  const Toolpath turns = path_of(
      "TOOL PATH/A,TOOL,B\nGOTO/5.0000,0.0000,1.0000,0.0000000,0.0000000,1.0000000\n"
      "CIRCLE/0.0000,0.0000,1.0000,0.0000000,0.0000000,-1.0000000,5.0000,0.0600,0.5000,40.0000,1.0000,TIMES,2\n"
      "GOTO/5.0000,0.0000,0.0000\nEND-OF-PATH\n");
  ASSERT_EQ(turns.moves[1].curve_kind, CurveKind::arc);
  EXPECT_FALSE(rewritable_moves(turns).arc[1]);
  const Toolpath list = path_of(
      "MULTAX/OFF\nGOTO/20.0000,0.0000,0.0000\nCIRCLE/0.0000,0.0000,0.0000,0.0000000,0.0000000,1.0000000,20.0000\n"
      "GOTO/0.0000,20.0000,0.0000,-20.0000,0.0000,0.0000\nFINI\n");
  for (const bool can : rewritable_moves(list).arc) EXPECT_FALSE(can);
}

TEST(RewriteArc, AChangeOfTheStartAloneNeedsTheArcRewritten) {
  const Toolpath path = path_of(kQuarter);
  PathChange start{0, Pose{Vec3(5, 0, 1.25), Vec3::UnitZ()}, {}};
  EXPECT_EQ(refusal(path, {start}), "write-arc");
}

}  // namespace
}  // namespace gouge::rewrite_arc_test
