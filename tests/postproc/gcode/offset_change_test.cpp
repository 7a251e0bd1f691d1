// Changes of the work offset while only some coordinates of the approach are known. They move nothing.
#include <string>
#include <utility>
#include <vector>

#include "tests/postproc/gcode/program.h"

namespace gouge::offset_change_test {
namespace {

using test::can_be_clean;
using test::expect_checked;
using test::path_of_program;
using test::read_program;
using test::reasons_of;

const std::string kHead = "G21 G90 G17 G40 G49 G80 G94\nT1 M6\n", kReason = "coordinates before it are those of ";

ProgramSetup straight_setup() {
  ProgramSetup setup;
  setup.are_joint_rapids_straight = true;
  return setup;
}

/// G55 is 30 mm to the left of G54, and 7 mm lower.
ProgramSetup setup_with_offsets() {
  ProgramSetup setup = straight_setup();
  setup.offsets["G54"] = WorkOffset{};
  setup.offsets["G55"].xyz_mm = Vec3(-30, 0, -7);
  return setup;
}

TEST(OffsetChange, CoordinatesOfTheOffsetBeforeAreNotTakenOver) {
  const std::string end = "Z120.\nG1 Z0. F200.\nY80.\nM30\n";
  const std::vector<std::pair<std::string, std::string>> programs = {
      {"linuxcnc", kHead + "G54\nG0 X20. Y20.\nG55\nG43 H1 " + end},
      {"haas", kHead + "G54\nG0 X20. Y20.\nG55\nG43 H1 " + end},
      {"fanuc", kHead + "G54\nG0 X20. Y20.\nG54.1 P2\nG43 H1 " + end},
      {"haas", kHead + "G0 X20. Y20.\nG55\nG43 H1 " + end},  // G54 is in force at the start
      {"siemens", "G54 G17 G71 G90 G40 G60\nT1 M6\nD1\nG0 X20 Y20\nG55\nG0 Z120\nG1 Z0 F200\nY80\nM30\n"},
      {"heidenhain",
       "BEGIN PGM A MM\nCYCL DEF 247 DATUM Q339=+1\nTOOL CALL 1 Z S5000\nL X+20 Y+20 R0 FMAX\nCYCL DEF 247 DATUM "
       "Q339=+2\nL Z+120 FMAX\nL Z+0 F200\nL Y+80\nEND PGM A MM\n"}};
  for (const auto& [control, text] : programs) {
    const ReadOutcome outcome = read_program(text, control, straight_setup());
    EXPECT_FALSE(can_be_clean(outcome)) << control << "\n" << text;
    EXPECT_NE(reasons_of(outcome).find(kReason), std::string::npos) << control << "\n" << reasons_of(outcome);
  }
}

TEST(OffsetChange, TheReasonNamesBothOffsets) {
  const std::string text = kHead + "G54\nG0 X20. Y20.\nG55\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n";
  EXPECT_NE(reasons_of(read_program(text, "haas", straight_setup())).find("--offset G54=X,Y,Z and --offset G55=X,Y,Z"),
            std::string::npos);
}

TEST(OffsetChange, CoordinatesThatAreStatedAgainAreChecked) {
  expect_checked(kHead + "G54\nG0 X20. Y20.\nG55\nX20. Y20.\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n", "haas",
                 straight_setup());
  test::expect_open(kHead + "G54\nG0 X20. Y20.\nG55\nX20.\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n", "haas", kReason,
                    straight_setup());
  expect_checked(kHead + "G54\nG0 X20. Y20.\nT2 M6\nG55\nX20. Y20.\nG43 H2 Z120.\nG1 Z0. F200.\nM30\n", "haas",
                 straight_setup());
}

// The tool is at X20 of G54, which is X50 of G55.
TEST(OffsetChange, KnownOffsetsConvertEachCoordinate) {
  const std::string text = kHead + "G54\nG0 X20. Y20.\nG55\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n";
  for (const char* control : {"haas", "fanuc", "linuxcnc"}) {
    const Toolpath path = path_of_program(text, control, setup_with_offsets());
    ASSERT_EQ(path.moves.size(), 2U) << control;
    test::expect_tip(path.moves[1], 50, 20, 0);
    EXPECT_EQ(path.work_offset, "G55") << control;
  }
  ProgramSetup of_part = setup_with_offsets();
  of_part.zero = RigidTransform{};
  of_part.tool_length_mm = 100;
  of_part.machine = test::trunnion();
  const std::string turned = kHead + "G54\nG0 A0. C0.\nX20. Y20.\nG55\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n";
  test::expect_tip(path_of_program(turned, "haas", of_part).moves.back(), 20, 20, -7);
  of_part.zero.reset();
  test::expect_tip(path_of_program(turned, "haas", of_part).moves.back(), 50, 20, 0);
}

TEST(OffsetChange, AnglesOfTheOffsetBeforeAreNotTakenOver) {
  ProgramSetup setup = straight_setup();
  setup.machine = test::trunnion();
  setup.tool_length_mm = 100;
  const std::string end = "G55\nG0 X20. Y20.\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n";
  test::expect_open(kHead + "G54\nG0 A0. C0.\n" + end, "haas", kReason, setup);
  expect_checked(kHead + "G54\nG0 A0. C0.\nG55\nA0. C0.\n" + end, "haas", setup);
  ProgramSetup started = setup;
  started.start = "G90 G0 A0. C0.\n";
  expect_checked(kHead + "G54\n" + end, "haas", started);
  ProgramSetup known = setup_with_offsets();
  known.machine = setup.machine;
  known.tool_length_mm = 100;
  expect_checked(kHead + "G54\nG0 A0. C0.\n" + end, "haas", known);
}

// An angle of the machine does not depend on the preset.
TEST(OffsetChange, AnglesOfTheMachineStay) {
  ProgramSetup setup = straight_setup();
  setup.machine = test::trunnion();
  setup.tool_length_mm = 100;
  const auto program = [](const std::string& word) {
    return "BEGIN PGM N MM\nTOOL CALL 1 Z S3000\nL A+0 C+0 FMAX" + word +
           "\nCYCL DEF 247 PRESET Q339=+2\nL X+20 Y+10 FMAX\nL Z+120 FMAX\nL Z+60 F100\nEND PGM N MM\n";
  };
  expect_checked(program(" M91"), "heidenhain", setup);
  test::expect_open(program(""), "heidenhain", kReason, setup);
}

// With offsets of the rotary joint, the same place of A is another angle after the change.
TEST(OffsetChange, KnownOffsetsOfRotaryJointsKeepTheirPlace) {
  ProgramSetup setup = setup_with_offsets();
  setup.machine = test::trunnion();
  setup.tool_length_mm = 100;
  setup.offsets["G54"].abc_deg = Vec3(90, 0, 0);
  const Toolpath path =
      path_of_program(kHead + "G54\nG0 A0. C0.\nG55\nX20. Y20.\nG43 H1 Z120.\nG1 Z0. F200.\nM30\n", "haas", setup);
  EXPECT_NEAR(std::abs(path.moves.back().end.axis.z()), 0, 1e-9);
}

/// A change of frame or length between the motion across and the motion down.
struct FrameChange {
  const char* control;
  const char* blocks;
};

std::string program_with(const FrameChange& change, bool has_height) {
  const std::string control = change.control, height = has_height ? "Z150." : "";
  if (control == "siemens")
    return "G17 G71 G90 G94 G60 G54\nTRAFOOF\nT1 M6\nD1\nG0 A0 C0\nG0 X20 Y10 " + height + "\n" + change.blocks +
           "\nG0 Z120\nG1 Z60 F100\nM30\n";
  if (control == "heidenhain")
    return "BEGIN PGM N MM\nTOOL CALL 1 Z S3000\nL A+0 C+0 FMAX\nL X+20 Y+10 " + height + " R0 FMAX\n" + change.blocks +
           "\nL Z+120 FMAX\nL Z+60 F100\nEND PGM N MM\n";
  return kHead + "G54 G43 H1\nG0 A0. C0.\nX20. Y10. " + height + "\n" + change.blocks +
         "\nG0 Z120.\nG1 Z60. F100.\nM30\n";
}

ProgramSetup setup_with_all_facts() {
  ProgramSetup setup = setup_with_offsets();
  setup.offsets["PRESET"] = WorkOffset{};
  setup.offsets["PRESET2"].xyz_mm = Vec3(-30, 0, -7);
  setup.offsets["G500"].xyz_mm = Vec3(1, 2, 3);
  setup.zero = RigidTransform{Eigen::Matrix3d::Identity(), Vec3(1, 2, 3)};
  setup.machine = test::trunnion();
  setup.lengths_mm = {{1, 100}, {2, 120}};
  setup.tip_frame = TipFrame::table;
  return setup;
}

Vec3 end_of(const ReadOutcome& outcome, const std::string& shown) {
  EXPECT_TRUE(can_be_clean(outcome)) << shown << "\n" << reasons_of(outcome);
  return outcome.toolpath ? outcome.toolpath->moves.back().end.tip : Vec3::Zero();
}

// A place of which only X and Y are known leads to the same motions as a whole one.
TEST(OffsetChange, APartOfAPlaceIsConvertedAsAWholeOne) {
  const std::vector<FrameChange> changes = {
      {"siemens", "TRANS X5 Y6 Z7"},
      {"siemens", "TRANS X5\nATRANS Y6 Z7"},
      {"siemens", "TRANS X5\nTRANS"},
      {"siemens", "G55"},
      {"siemens", "G500"},
      {"siemens", "D0"},
      {"siemens", "TRAORI"},
      {"heidenhain", "CYCL DEF 7.0\nCYCL DEF 7.1 X+5\nCYCL DEF 7.2 Y+6\nCYCL DEF 7.3 Z+7"},
      {"heidenhain", "CYCL DEF 8.0\nCYCL DEF 8.1 X"},
      {"heidenhain", "CYCL DEF 247 PRESET Q339=+2"},
      {"fanuc", "G55"},
      {"fanuc", "G20\nG21"},
      {"fanuc", "G43.4 H1"},
      {"haas", "G55"},
      {"haas", "G254"},
      {"linuxcnc", "G55\nG43 H2"},
      {"linuxcnc", "M428"}};
  const ProgramSetup setup = setup_with_all_facts();
  for (const FrameChange& change : changes) {
    const std::string shown = std::string(change.control) + " " + change.blocks;
    const Vec3 whole = end_of(read_program(program_with(change, true), change.control, setup), shown);
    const Vec3 part = end_of(read_program(program_with(change, false), change.control, setup), shown);
    EXPECT_NEAR((whole - part).norm(), 0, 1e-9) << shown;
  }
}

// A change that mixes the coordinates leaves none of an incomplete place.
TEST(OffsetChange, APartOfAPlaceIsLostWhereTheFrameTurns) {
  for (const char* blocks : {"ROT Z90", "ROT RPL=30", "SCALE X2 Y2 Z2"}) {
    const FrameChange change{"siemens", blocks};
    EXPECT_TRUE(can_be_clean(read_program(program_with(change, true), change.control, setup_with_all_facts())));
    test::expect_open(program_with(change, false), change.control, "the place of the tool is not known",
                      setup_with_all_facts());
  }
}

TEST(OffsetChange, ALevelOfACycleInForceIsOpenWhereZChanges) {
  const std::string head = kHead + "G54\nG0 X0. Y0.\nG43 H1 Z50.\nG98 G81 Z-5. R2. F100.\n",
                    end = "X9. Y9.\nG80\nM30\n";
  ProgramSetup setup = setup_with_offsets();
  test::expect_open(head + "G55\n" + end, "linuxcnc", "while a cycle is in force", setup);
  expect_checked(head + "G80\nG55\nG81 Z-5. R2.\n" + end, "linuxcnc", setup);
  setup.offsets["G55"].xyz_mm.z() = 0;
  expect_checked(head + "G55\n" + end, "linuxcnc", setup);
}

}  // namespace
}  // namespace gouge::offset_change_test
