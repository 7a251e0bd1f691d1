#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "lib/base/files.h"
#include "lib/path/path_info.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/write_corrected.h"
#include "tests/support/source_folder.h"

namespace gouge::real_paths_test {
namespace {

const std::string kFolder = source_folder() + "/../shared/data/toolpaths/";

#define SKIP_WITHOUT_DATA() \
  if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << "no real toolpaths beside the checkout (" << kFolder << ")"

ReadOutcome read(const std::string& name) {
  Result<std::string> bytes = read_file(kFolder + name);
  if (!bytes) {
    ADD_FAILURE() << bytes.error().message << ": " << name;
    return {};
  }
  return read_toolpath(name, std::move(*bytes));
}

struct Expected {
  const char* dialect;
  std::size_t feed, rapid, arc, cycle;
  std::size_t orientations;
  std::size_t tools;
  std::size_t not_checkable;
};

// Counted in the files with other means (grep of the major words); orientations of ust_a2 as in FORMATS.
const std::map<std::string, Expected> kExpected = {
    {"bare_goto/impeller_channel.txt", {"goto-list", 52, 0, 0, 0, 52, 0, 0}},
    {"bare_goto/iso_s.apt", {"goto-list", 16, 0, 0, 0, 16, 0, 0}},
    {"camworks_clt/Interface-glue.clt", {"camworks-clt", 1976, 24, 30, 23, 1, 3, 45}},
    {"catia_aptsource/DEMO3.aptsource", {"apt-catia", 138, 59, 0, 2, 1, 4, 197}},
    {"catia_aptsource/DEMO5.aptsource", {"apt-catia", 5, 0, 3, 0, 1, 1, 8}},
    {"catia_aptsource/PrepaFlans_Pointage.aptsource", {"apt-catia", 2, 36, 0, 24, 1, 1, 0}},
    {"creo_ncl/creo9_remark_excerpt.ncl", {"apt-creo", 156, 2, 0, 0, 108, 1, 0}},
    {"creo_ncl/op010.ncl.1", {"apt-creo", 87, 66, 0, 0, 1, 2, 0}},
    {"creo_ncl/schruppen_1.ncl.1", {"apt-creo", 4552, 619, 419, 0, 1, 1, 0}},
    {"five_axis_part/subset_autodesk_iso4343.apt", {"apt-autodesk", 1173, 62, 99, 0, 484, 3, 0}},
    {"five_axis_part/subset_camplete.apt", {"apt-camplete", 1173, 62, 99, 0, 484, 3, 0}},
    {"five_axis_part/subset_catia.aptsource", {"apt-catia", 1173, 62, 99, 0, 484, 3, 0}},
    {"five_axis_part/subset_creo.ncl.1", {"apt-creo", 1173, 62, 99, 0, 484, 3, 0}},
    {"five_axis_part/subset_nccs.cl", {"nccs-binary", 1272, 62, 0, 0, 487, 3, 0}},
    {"nccs_ncl/pmill_test1_4.as", {"apt-nccs", 3716, 0, 0, 0, 3674, 1, 0}},
    {"nccs_ncl/pmill_test1_4.cl", {"nccs-binary", 3716, 0, 0, 0, 3682, 1, 0}},
    {"nx_clsf/TORETC_250_BOK.cls", {"nx-clsf", 8, 2, 0, 0, 1, 1, 0}},
    {"nx_clsf/_1_KONTUR_NAR_40_N2.cls", {"nx-clsf", 24, 3, 19, 0, 1, 1, 0}},
    {"nx_clsf/_3_PAZ_125_N2.cls", {"nx-clsf", 280, 60, 300, 0, 1, 1, 0}},
    {"nx_clsf/cutcom.clsf", {"nx-clsf", 350, 76, 140, 0, 1, 1, 0}},
    {"nx_clsf/nurbs.clsf", {"nx-clsf", 77, 1, 70, 0, 1, 1, 0}},
    {"nx_clsf/standart_drill.clsf", {"nx-clsf", 0, 0, 0, 6, 1, 1, 0}},
    {"nx_clsf/ust_a2.cls", {"nx-clsf", 19598, 459, 0, 0, 1529, 1, 0}},
    {"solidworks_cam/Paralelipipedo2.apt", {"apt-solidworks-cam", 136, 58, 32, 0, 1, 1, 80}},
    {"solidworks_cam/Sacrifice-Board.apt", {"apt-solidworks-cam", 246, 150, 70, 108, 2, 4, 154}},
    {"solidworks_cam/SupPetriLED.apt", {"apt-solidworks-cam", 122, 59, 107, 46, 1, 3, 94}},
    {"solidworks_cam/Teste-Metrologia.apt", {"apt-solidworks-cam", 297, 92, 65, 0, 2, 1, 50}},
    {"solidworks_cam/basemach.apt", {"apt-solidworks-cam", 1331, 374, 369, 63, 1, 4, 618}},
    {"solidworks_cam/boss.apt", {"apt-solidworks-cam", 8013, 775, 1026, 0, 2, 2, 1017}},
};

const std::map<std::string, const char*> kRefused = {
    {"apt_source_programs/multax.apt", "path-part-program"},
    {"apt_source_programs/pocket.apt", "path-part-program"},
    {"apt_source_programs/sample2.apt", "path-part-program"},
    {"nccs_ncl/no_motion.cl", "path-no-motion"},
    {"nx_clsf/aptwords.tbl", "path-count"},
};

TEST(RealPaths, AreReadWithTheCountsOfTheirSources) {
  SKIP_WITHOUT_DATA();
  for (const auto& [name, expected] : kExpected) {
    SCOPED_TRACE(name);
    const ReadOutcome outcome = read(name);
    ASSERT_TRUE(outcome.toolpath) << to_text(outcome.errors.front());
    const Toolpath& path = *outcome.toolpath;
    const PathInfo info = describe_path(path);
    EXPECT_EQ(path.dialect, expected.dialect);
    EXPECT_EQ(info.moves_by_kind, (std::array{expected.feed, expected.rapid, expected.arc, expected.cycle}));
    EXPECT_EQ(info.orientations, expected.orientations);
    EXPECT_EQ(path.tools.size(), expected.tools);
    std::size_t not_checkable = 0;
    for (const auto& reason : info.not_checkable) not_checkable += reason.second;
    EXPECT_EQ(not_checkable, expected.not_checkable);
    EXPECT_TRUE(path.words_not_understood.empty());
  }
}

TEST(RealPaths, OfOtherKindsAreRefused) {
  SKIP_WITHOUT_DATA();
  for (const auto& [name, code] : kRefused) {
    const ReadOutcome outcome = read(name);
    ASSERT_FALSE(outcome.errors.empty()) << name;
    EXPECT_EQ(outcome.errors.front().code, code) << name;
  }
}

TEST(RealPaths, AreAllListedHere) {
  SKIP_WITHOUT_DATA();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kFolder)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = std::filesystem::relative(entry.path(), kFolder).string();
    EXPECT_TRUE(kExpected.contains(name) || kRefused.contains(name)) << name;
  }
}

TEST(RealPaths, WrittenWithoutChangesAreTheSameBytes) {
  SKIP_WITHOUT_DATA();
  for (const auto& [name, expected] : kExpected) {
    const ReadOutcome outcome = read(name);
    ASSERT_TRUE(outcome.toolpath);
    EXPECT_TRUE(*write_corrected(*outcome.toolpath, {}) == outcome.toolpath->source) << name;
  }
}

std::size_t count_lines_kept(std::string_view before, const std::string& after) {
  std::multiset<std::string_view> lines;
  for (std::size_t at = 0; at < before.size(); at = std::min(before.find('\n', at), before.size() - 1) + 1) {
    lines.insert(before.substr(at, before.find('\n', at) - at));
  }
  std::size_t kept = 0;
  for (std::size_t at = 0; at < after.size(); at = std::min(after.find('\n', at), after.size() - 1) + 1) {
    const auto it = lines.find(std::string_view(after).substr(at, after.find('\n', at) - at));
    if (it == lines.end()) continue;
    lines.erase(it);
    ++kept;
  }
  return kept;
}

// An arc or a cycle that begins at a position depends on it.
bool is_start_of_a_curve(const Toolpath& path, std::size_t i) {
  if (i + 1 >= path.moves.size()) return false;
  const MoveKind next = path.moves[i + 1].kind;
  return next == MoveKind::arc || next == MoveKind::cycle;
}

// Every third straight move is moved, every fifth gets positions on the way with axes between its own.
TEST(RealPaths, CorrectionsReadBackAndLeaveTheRestAlone) {
  SKIP_WITHOUT_DATA();
  std::size_t changed = 0;
  for (const auto& [name, expected] : kExpected) {
    SCOPED_TRACE(name);
    const ReadOutcome outcome = read(name);
    ASSERT_TRUE(outcome.toolpath);
    const Toolpath& path = *outcome.toolpath;
    std::vector<PathChange> changes;
    std::vector<Move> wanted;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      Move move = path.moves[i];
      PathChange change{i, std::nullopt, {}};
      const bool is_straight = move.kind == MoveKind::feed || move.kind == MoveKind::rapid;
      if (is_straight && i % 5 == 0 && move.has_start && move.not_checked_reason.empty()) {
        for (const double t : {0.25, 0.75}) {
          Move between = move;
          between.end.tip = path.start_of(i).tip * (1 - t) + move.end.tip * t + Vec3(0.1, 0.2, 0.3);
          const Vec3 axis = path.start_of(i).axis * (1 - t) + move.end.axis * t;
          between.end.axis = axis.norm() > 1e-6 ? Vec3(axis.normalized()) : move.end.axis;
          change.inserted_before.push_back(between.end);
          wanted.push_back(between);
        }
      }
      if (is_straight && i % 3 == 0 && !is_start_of_a_curve(path, i)) {
        move.end.tip += Vec3(0.111, -0.222, 0.333);
        change.new_end = move.end;
      }
      wanted.push_back(move);
      if (change.new_end || !change.inserted_before.empty()) changes.push_back(change);
    }
    const Result<std::string> text = write_corrected(path, changes);
    ASSERT_TRUE(text.has_value()) << text.error().message;
    const ReadOutcome again = read_toolpath(name, *text);
    ASSERT_TRUE(again.toolpath) << to_text(again.errors.front());
    ASSERT_EQ(again.toolpath->moves.size(), wanted.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const Move& found = again.toolpath->moves[i];
      const bool is_same =
          (found.end.tip - wanted[i].end.tip).norm() < 3e-4 && (found.end.axis - wanted[i].end.axis).norm() < 3e-6 &&
          found.kind == wanted[i].kind && found.tool == wanted[i].tool && found.operation == wanted[i].operation &&
          found.not_checked_reason == wanted[i].not_checked_reason && found.has_start == wanted[i].has_start;
      if (!is_same && wrong++ < 3) ADD_FAILURE() << "move " << i << " at line " << found.line;
    }
    EXPECT_EQ(wrong, 0u);
    if (path.dialect != "nccs-binary") {
      EXPECT_GE(count_lines_kept(path.source, *text), path.statements.size() - changes.size());
    }
    changed += changes.size();
  }
  EXPECT_GT(changed, 5000u);
}

std::size_t path_before(const ReadOutcome& outcome, std::size_t i) { return outcome.toolpath->moves[i - 1].operation; }

TEST(RealPaths, OnePartInFourDialectsIsOneToolpath) {
  SKIP_WITHOUT_DATA();
  const ReadOutcome first = read("five_axis_part/subset_autodesk_iso4343.apt");
  ASSERT_TRUE(first.toolpath);
  for (const char* name : {"camplete.apt", "catia.aptsource", "creo.ncl.1"}) {
    SCOPED_TRACE(name);
    const ReadOutcome other = read(std::string("five_axis_part/subset_") + name);
    ASSERT_TRUE(other.toolpath);
    ASSERT_EQ(other.toolpath->moves.size(), first.toolpath->moves.size());
    for (std::size_t i = 0; i < first.toolpath->moves.size(); ++i) {
      const Move& a = first.toolpath->moves[i];
      const Move& b = other.toolpath->moves[i];
      ASSERT_LT((a.end.tip - b.end.tip).norm(), 2e-5) << i;
      ASSERT_LT((a.end.axis - b.end.axis).norm(), 2e-6) << i;
      ASSERT_EQ(a.kind, b.kind) << i;
      ASSERT_EQ(a.tool, b.tool) << i;
      ASSERT_EQ(a.operation, b.operation) << i;
      // Between the sequences of Creo the machine goes home.
      const bool is_new_sequence = std::string(name) == "creo.ncl.1" && i > 0 && b.operation != path_before(other, i);
      if (is_new_sequence) continue;
      ASSERT_EQ(a.has_start, b.has_start) << i;
    }
  }
}

TEST(RealPaths, TheImpellerBlockStandsInAbsoluteCoordinates) {
  SKIP_WITHOUT_DATA();
  const ReadOutcome outcome = read("nx_clsf/ust_a2.cls");
  ASSERT_TRUE(outcome.toolpath);
  const Move& move = outcome.toolpath->moves.front();
  EXPECT_EQ(move.line, 11u);
  EXPECT_NEAR(move.end.tip.x(), -120.2591 + 222.6719, 1e-9);
  EXPECT_NEAR(move.end.tip.y(), -1196.5, 1e-9);
  EXPECT_NEAR(move.end.tip.z(), 142.5 + 177.5, 1e-9);
  EXPECT_NEAR(move.end.axis.z(), 1, 1e-12);
}

}  // namespace
}  // namespace gouge::real_paths_test
