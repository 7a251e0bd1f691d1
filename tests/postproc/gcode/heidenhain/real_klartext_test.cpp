#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "postproc/formats/read_toolpath.h"
#include "tests/postproc/gcode/heidenhain/klartext.h"
#include "tests/support/source_folder.h"

// The program of a real post-processor beside its CL data (the shared data folder; never part of the project).

namespace gouge::real_klartext_test {
namespace {

const std::string kData = source_folder() + "/../shared/data/";

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool has_data() { return std::filesystem::exists(kData + "gcode/tnc_teste_metrologia_12.h"); }

/// The program states the datum shift and coordinates of the tilted plane: x = -z, y = y, z = x of the CL data.
Vec3 in_program(const Vec3& part) { return {-part.z(), part.y(), part.x()}; }
const Vec3 kShift_mm(183.174, 0, -202.972);
// The program has three decimals: half of the last one on each axis. The smallest arc has a radius of 1.4 mm.
constexpr double kRounding_mm = 0.00087, kRounding_rad = kRounding_mm / 1.4;

/// The moves of the CL data whose tool axis is that of the program.
std::vector<Move> moves_of_twin(const Toolpath& twin) {
  std::vector<Move> moves;
  for (const Move& move : twin.moves)
    if (move.end.axis.x() > 0.999) moves.push_back(move);
  return moves;
}

void expect_same_arc(const PathArc& found, const PathArc& twin, std::size_t line) {
  const Vec3 centre = found.center - kShift_mm - in_program(twin.center);
  EXPECT_LT(centre.head<2>().norm(), kRounding_mm) << "line " << line;
  EXPECT_NEAR(found.sweep_rad, twin.sweep_rad, kRounding_rad) << "line " << line;
  EXPECT_LT((found.axis - in_program(twin.axis)).norm(), 1e-9) << "line " << line;
}

TEST(RealKlartext, HasThePositionsOfItsClData) {
  if (!has_data()) GTEST_SKIP() << "the shared data is not here (" << kData << ")";
  const Toolpath path = klartext::path_of(text_of(kData + "gcode/tnc_teste_metrologia_12.h"));
  ReadOutcome cl = read_toolpath("twin.apt", text_of(kData + "toolpaths/solidworks_cam/Teste-Metrologia.apt"));
  ASSERT_TRUE(cl.toolpath);
  const std::vector<Move> twin = moves_of_twin(*cl.toolpath);
  ASSERT_EQ(path.moves.size(), twin.size() + 1);  // and the last block, to the machine datum
  std::size_t arcs = 0;
  for (std::size_t i = 0; i < twin.size(); ++i) {
    const Move& found = path.moves[i];
    ASSERT_EQ(found.not_checked_reason, "") << "line " << found.line;
    EXPECT_LT((found.end.tip - kShift_mm - in_program(twin[i].end.tip)).norm(), kRounding_mm) << "line " << found.line;
    EXPECT_EQ(found.kind, twin[i].kind) << "line " << found.line;
    if (found.curve_kind != CurveKind::arc || twin[i].curve_kind != CurveKind::arc) continue;
    expect_same_arc(path.arcs[found.curve], cl.toolpath->arcs[twin[i].curve], found.line);
    ++arcs;
  }
  EXPECT_GT(arcs, 30U);
}

// The one block whose place needs a fact that is not in the file.
TEST(RealKlartext, IsReadToItsEnd) {
  if (!has_data()) GTEST_SKIP() << "the shared data is not here (" << kData << ")";
  const std::string text = text_of(kData + "gcode/tnc_teste_metrologia_12.h");
  const Toolpath path = klartext::path_of(text);
  EXPECT_TRUE(path.words_not_understood.empty());
  EXPECT_EQ(klartext::count_open(path), 1U);
  EXPECT_NE(klartext::last_reason(path).find("the place of M91"), std::string::npos);
  GcodeOptions options;
  options.setup.offsets["PRESET"] = {Vec3(100, 200, -500), Vec3::Zero()};
  options.setup.lengths_mm[101] = 1;  // as TOOL DEF states
  const Toolpath placed = klartext::path_of(text, options);
  EXPECT_EQ(klartext::count_open(placed), 0U) << klartext::last_reason(placed);
  EXPECT_NEAR(placed.moves.back().end.tip.z(), -10 + 500 - 1, 1e-9);
}

}  // namespace
}  // namespace gouge::real_klartext_test
