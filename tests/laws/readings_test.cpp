// Numbers of real files read in the dialect's way and in another one: the part is clean only in the right
// way.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "lib/motion/motion_law.h"
#include "tests/laws/reading.h"
#include "tests/support/real_arcs.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::readings_test {
namespace {

struct ForcedArc {
  const char* name;
  const char* dialect;  // that of a writer who means the other sense, or none that is known
  const char* verdict;
};

void PrintTo(const ForcedArc& c, std::ostream* out) { *out << c.name; }

class ForcedSense : public ::testing::TestWithParam<ForcedArc> {};

INSTANTIATE_TEST_SUITE_P(
    All, ForcedSense,
    ::testing::Values(ForcedArc{"Nx", "apt-solidworks-cam", "gouge"}, ForcedArc{"Creo", "nx-clsf", "gouge"},
                      ForcedArc{"SolidWorks", "nx-clsf", "gouge"},
                      // These state more than the sense, so that the contradiction is seen.
                      ForcedArc{"Camplete", "apt-creo", "not-checked"}, ForcedArc{"Autodesk", "nx-clsf", "not-checked"},
                      ForcedArc{"Clt", "nx-clsf", "not-checked"}, ForcedArc{"Catia", "nx-clsf", "clean"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(ForcedSense, MeetsThePostUnlessTheStatementItselfShowsTheWay) {
  const auto* arc = std::find_if(std::begin(real_arcs::kArcs), std::end(real_arcs::kArcs),
                                 [](const auto& a) { return a.name == std::string(GetParam().name); });
  ASSERT_NE(arc, std::end(real_arcs::kArcs));
  const auto with_tool = [&](const std::string& dialect) {
    Toolpath path = read_as(arc->text, dialect);
    path.tools.resize(1);
    for (Move& move : path.moves) move.tool = 0;
    return path;
  };
  const Toolpath right = with_tool("");
  const Vec3 middle = MotionLaw().of(right, 2).at(0.5).tip;
  const PathArc& circle = right.arcs.at(0);
  const Vec3 across = 2 * (circle.center - circle.axis.dot(circle.center - middle) * circle.axis) - middle;
  const IndexedMesh post = shapes::box(across - Vec3(0.1, 0.1, 5), across + Vec3(0.1, 0.1, 5));
  const std::vector<ToolVariants> tool = {tools::ball(1)};
  EXPECT_EQ(verdict(right, post, tool), "clean");
  EXPECT_EQ(verdict(with_tool(GetParam().dialect), post, tool), GetParam().verdict);
}

// A half circle beside the part: counter-clockwise it bows away from it, clockwise into it.
TEST(AutodeskArc, AHalfCircleOfAnOlderAutodeskPostIsNoCleanOne) {
  const std::string head = "MODE/MILL\nUNITS/MM\nMULTAX/OFF\nCUTTER/10, 0, 0, 0, 0, 0, 30\nLOADTL/1, 0, 30, 1\n";
  const std::string half =
      "GOTO/66,0,-5\nGOTO/61,0,-5\nMOVARC/61,10,-5,0,0,1,10,ANGLE,180\nGOTO/61,20,-5\nGOTO/66,20,-5\nEND\nFINI\n";
  const std::string turned = "GOTO/70,0,50\nMOVARC/70,10,50,0,0,-1,10,ANGLE,90\nGOTO/60,10,50\nGOTO/66,0,50\n";
  const IndexedMesh part = shapes::box({-50, -50, -20}, {50, 50, 0});
  EXPECT_EQ(verdict(read_as(head + half, ""), part), "not-checked");
  EXPECT_EQ(verdict(read_as(head + half, "nx-clsf"), part), "gouge");
  EXPECT_EQ(verdict(read_as(head + turned + half, ""), part), "clean");
}

// The corner's circle reaches farther out than the diameter.
TEST(TldataReading, ATldataWhoseCornerLiesElsewhereIsNoSmallerTool) {
  const auto tools_of = [](const std::string& corner) {
    return read_as("TOOL PATH/A,TOOL,B\nTLDATA/MILL,20,5,50,0,0" + corner + "\nGOTO/61,0,-10\nEND-OF-PATH\n", "").tools;
  };
  EXPECT_TRUE(tools_of(",5,5").at(0).cutter.has_value());
  EXPECT_FALSE(tools_of(",8,5").at(0).cutter.has_value());
}

// A face mill leans back from a wall. Read as +Z it would stand in it.
TEST(Modality, OfTheAxisInNx) {
  const std::string text =
      "TOOL PATH/VARIABLE_CONTOUR,TOOL,BPR-SNR-323S32\nTLDATA/MILL,32.0000,5.0000,75.0000,0.0000,0.0000\n"
      "GOTO/266.5600,14.3672,-78.6854,0.0679850,-0.9833858,-0.1683164\nGOTO/266.5600,13.2188,-71.9757\nEND-OF-PATH\n";
  const IndexedMesh wall = shapes::box({200, 18, -140}, {330, 60, 0});
  EXPECT_EQ(verdict(read_as(text, ""), wall), "clean");
  EXPECT_EQ(verdict(read_as(text, "apt-solidworks-cam"), wall), "gouge");
}

// Two sides of a board: three numbers mean +Z, whatever the side before was.
TEST(Modality, OfTheAxisIsNoneInSolidWorks) {
  const std::string text =
      "TRNTYP/WORLD,0,0,0\nUNIT/MM\nCUTTER/50.,0,25.,0,0,0,40.\nLOAD/TOOL,4\nGOTO/390.,145.,-55.,0,0,-1.\n"
      "CUTTER/14.,0,7.,0,0,0,84.\nLOAD/TOOL,3\nGOTO/467.5,20.,25.\nFINI\n";
  const IndexedMesh board = shapes::box({440, 0, 0}, {490, 40, 24.9});
  EXPECT_EQ(verdict(read_as(text, ""), board), "clean");
  EXPECT_EQ(verdict(read_as(text, "nx-clsf"), board), "gouge");
}

// The block's system looks down: seen from it, the plate lies on the other side of the tool.
TEST(Frame, OfAnNxBlockIsApplied) {
  const std::string tool =
      "TOOL PATH/8_KONTUR_NAR_40_N2,TOOL,FACE_MILL_1\nTLDATA/MILL,40.0000,1.0000,50.0000,0.0,0.0\n";
  const std::string msys = "MSYS/393.0000,-297.5000,3.0000,0.0,1.0,0.0,1.0,0.0,0.0\n";
  const std::string motion =
      "GOTO/738.7532,39.9400,478.0000,0.0,0.0,1.0\nGOTO/738.7532,39.9400,466.0000\n"
      "GOTO/741.2841,-9.9637,466.0000\nEND-OF-PATH\n";
  const IndexedMesh plate = shapes::box({300, -100, -462.9}, {1000, 600, 470});
  EXPECT_EQ(verdict(read_as(tool + msys + motion, ""), plate), "clean");
  EXPECT_NE(verdict(read_as(tool + motion, ""), plate), "clean");
}

// Positions 20 mm above where they are in the part's own axes.
TEST(Frame, OfCatiaIsApplied) {
  const std::string text =
      "$$     CATIA APT VERSION 1.0\n$$*CATIA0\n$$ Programme de fabrication.1\n"
      "$$     1.00000     0.00000     0.00000  -220.00000\n$$     0.00000     1.00000     0.00000  -170.00000\n"
      "$$     0.00000     0.00000     1.00000    20.00000\nPARTNO PART TO BE MACHINED\nMULTAX\n"
      "CUTTER/ 10.000000,  0.000000,  5.000000,  5.000000, 45.000000,$\n         0.000000, 50.000000\nLOADTL/2\n"
      "GOTO  /   98.00000,  100.00000,   35.00000, 0.000000, 0.000000, 1.000000\n"
      "GOTO  /   98.00000,  100.00000,   25.00000, 0.000000, 0.000000, 1.000000\nEND\n";
  const IndexedMesh plate = shapes::box({-200, -170, 0}, {200, 170, 40});
  EXPECT_EQ(verdict(read_as(text, ""), plate), "clean");
  EXPECT_EQ(verdict(read_as(text, "apt"), plate), "clean") << "no other system writes such a comment";
  std::string without = text;
  without.replace(without.find("*CATIA0"), 7, " CATIA ");
  EXPECT_EQ(verdict(read_as(without, ""), plate), "not-checked") << "rows of a matrix that is lost";
}

// SolidWorks CAM writes CSYS beside positions that are in the part's axes already.
TEST(Frame, OfSolidWorksIsNotApplied) {
  const std::string text =
      "TRNTYP/WORLD,0,0,0\nUNIT/MM\nCUTTER/14.,0,7.,0,0,0,84.\nLOAD/TOOL,1\nCSYS/0,0,1.,0,0,1.,0,0,-1.,0,0,0\n"
      "GOTO/87.5,35.8375,-12.1625,1.,0,0\nGOTO/78.,35.8375,-12.1625,1.,0,0\nGOTO/78.,22.749812,-12.1625,1.,0,0\nFINI\n";
  const IndexedMesh part = shapes::box({-40, 0, -100}, {77.9, 60, 20});
  Toolpath path = read_as(text, "");
  EXPECT_EQ(verdict(path, part), "clean");
  EXPECT_EQ(verdict(read_as(text, "apt"), part), "not-checked") << "nothing says whether to apply it";
  const RigidTransform csys{(Eigen::Matrix3d() << 0, 0, 1, 0, 1, 0, -1, 0, 0).finished(), Vec3::Zero()};
  for (Move& move : path.moves) move.end = csys.pose(move.end);
  EXPECT_NE(verdict(path, part), "clean");
}

struct CutterReading {
  const char* name;
  const char* text;    // a tool and where it stands
  ToolVariants wrong;  // what the same numbers are where some of them are not understood
  IndexedMesh part;
};

void PrintTo(const CutterReading& c, std::ostream* out) { *out << c.name; }

class ToolReading : public ::testing::TestWithParam<CutterReading> {};

constexpr double kInch = 25.4;

INSTANTIATE_TEST_SUITE_P(
    All, ToolReading,
    ::testing::Values(
        // The cone of a drill, above a ledge a flat end would cut.
        CutterReading{
            "DrillOfSolidWorks",
            "TRNTYP/WORLD,0,0,0\nUNIT/MM\nCUTTER/6.,0,3.,1.802582,31.,0,102.\nLOAD/TOOL,1\nGOTO/0,0,0\nFINI\n",
            tools::flat(6), shapes::box({2, -5, -5}, {10, 5, 1.1})},
        CutterReading{
            "DrillOfCatia",
            "$$ CATIA APT VERSION 1.0\nUNITS/MM\nCUTTER/  2.500000,  0.000000,  1.250000,  0.751076, 31.000000,$\n"
            "         0.000000, 50.000000\nLOADTL/1\nGOTO  /    0.00000,    0.00000,    0.00000\nEND\n",
            tools::flat(2.5), shapes::box({1, -5, -5}, {10, 5, 0.5})},
        CutterReading{"CountersinkOfNx",
                      "TOOL PATH/A,TOOL,B\nTLDATA/MILL,30.0000,0.0000,30.0000,0.0000,45.0000\nGOTO/0.0,0.0,0.0\n"
                      "END-OF-PATH\n",
                      tools::flat(30), shapes::box({10, -5, -5}, {20, 5, 9.5})},
        // A ball whose e and f are written as 0.
        CutterReading{"BallOfCamplete",
                      "CSI_TOOL_PATH/A\nUNITS/INCHES\nCUTTER/0.236000, 0.118000, 0.000000, 0.000000, 0.000000, "
                      "0.000000, 2.000000\nLOADTL/3\nGOTO/0.000000, 0.000000, 0.000000\nFINI\n",
                      tools::flat(0.236 * kInch), shapes::box({0.09 * kInch, -5, -5}, {10, 5, 0.035 * kInch})},
        CutterReading{"BallOfNx",
                      "TOOL PATH/A,TOOL,B\nTLDATA/MILL,30.0000,15.0000,75.0000,0.0000,0.0000\nGOTO/0.0,0.0,0.0\n"
                      "END-OF-PATH\n",
                      tools::flat(30), shapes::box({12, -5, -5}, {20, 5, 5})},
        // e is the diameter of the tip: taken as the distance of the corner from the axis it is a tool twice
        // as wide.
        CutterReading{
            "FlatOfAutodesk",
            "MODE/MILL\nUNITS/INCHES\nCUTTER/0.750000, 0.000000, 0.750000, 0.000000, 0.000000, 0.000000, 2.000000\n"
            "LOADTL/1, 0, 2.0, 1\nGOTO/0.000000, 0.000000, 0.000000\nFINI\n",
            tools::flat(1.5 * kInch), shapes::box({0.38 * kInch, -5, -5}, {30, 5, 20})}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(ToolReading, OnlyTheWrongToolMeetsThePart) {
  const Toolpath path = read_as(GetParam().text, "");
  EXPECT_EQ(verdict(path, GetParam().part), "clean");
  EXPECT_EQ(verdict(path, GetParam().part, {GetParam().wrong}), "gouge");
}

}  // namespace
}  // namespace gouge::readings_test
