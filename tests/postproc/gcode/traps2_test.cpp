// Effects of blocks that a reader easily overlooks: none of these programs can be clean, unless the fact is given.
#include "tests/postproc/gcode/program.h"

namespace gouge::test::traps2_test {
namespace {

constexpr const char* kStart = "G17 G21 G90 G94 G40 G49 G80 G98\nT1 M6\nG43 H1 G0 X0. Y0. Z80.\n";

/// Facts of a machine whose G54 is its zero, with tools of 60 mm and 50 mm.
ProgramSetup measured() {
  ProgramSetup setup;
  setup.offsets["G54"] = {};
  setup.lengths_mm = {{1, 60}, {2, 50}};
  setup.home_mm = Vec3(0, 0, 300);
  return setup;
}

std::string program(const std::string& blocks) { return kStart + blocks + "M30\n"; }

TEST(GcodeEffects, MotionsToTheMachineCancelTheLength) {
  for (const char* block : {"G91 G28 Z0.\nG90\n", "G28 X0. Y0. Z90.\n", "G91 G30 Z0.\nG90\n", "G91 G28 X0.\nG90\n"}) {
    for (const char* control : {"haas", "fanuc"}) {
      expect_open(program(std::string(block) + "G0 X5.\nG0 Z50.\n"), control, "cancels the tool length", measured());
      const std::string again = program(std::string(block) + "G43 H1\nG0 X5.\nG0 Y0.\nG0 Z50.\nG1 Z40. F9.\n");
      const Toolpath path = path_of_program(again, control, measured());
      EXPECT_EQ(path.moves.back().not_checked_reason, "") << block << " on " << control;
    }
  }
  expect_open(program("G53 Z300.\nG0 Z50.\n"), "fanuc", "G53 in line 4 cancels the tool length", measured());
  expect_checked(program("G53 Z300.\nG0 Z50.\n"), "haas", measured());
  expect_checked(program("G53 X30.\nG0 Z50.\n"), "fanuc", measured());
  expect_checked(program("G91 G28 Z0.\nG90 G0 X5.\nG0 Z50.\n"), "linuxcnc", measured());
}

// A block with both could move to the machine, drill, or do both.
TEST(GcodeEffects, MotionsToTheMachineEndBeforeACycle) {
  const std::string cycle = "G98 G81 X5. Z50. R70. F9.\n";
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(program("G53 G81 X5. Z50. R70. F9.\n"), control, "G53 while the cycle G81", measured());
    expect_open(program("G28 G81 Z50. R70. F9.\n"), control, "G28 while the cycle G81", measured());
    expect_open(program(cycle + "G53 X5.\n"), control, "expected G80 before it", measured());
    expect_open(program(cycle + "G91 G28 Z0.\n"), control, "expected G80 before it", measured());
    for (const char* end : {"G80\nG53 X5.\n", "G0 G53 X5.\n", "G80 G53 X5.\n"})
      EXPECT_EQ(reasons_of(read_program(program(cycle + end), control, measured())).find("while the cycle"),
                std::string::npos)
          << end;
  }
}

TEST(GcodeEffects, TheLevelOfACycleThatFollowsAnotherMayBeNew) {
  const std::string text = "G99 G81 X5. Z50. R70. F9.\nG98 G81 X6.\n";
  expect_open(program(text + "Z50. R70.\n"), "haas", "begins while another one is in force", measured());
  expect_checked(program("G99 G81 X5. Z50. R70. F9.\nG98 G82 X6. Z50. R70.\n"), "fanuc", measured());
  expect_checked(program("G98 G81 X5. Z50. R70. F9.\nG98 G82 X6. Z50. R70.\n"), "haas", measured());
}

// Source: Fanuc B-64484EN, 4.1, restrictions.
TEST(GcodeEffects, MotionsToTheMachineRunEachAxisAtItsOwnRate) {
  ProgramSetup setup = measured();
  setup.are_joint_rapids_straight = true;
  const std::string z = "G28 G91 Z0.\nG90\n";
  for (const char* block : {"G53 X-100. Y-50.\n", "G1 G53 X-100. Y-50. F9.\n", "G28 X5. Y50.\n"})
    expect_open(program(z + block), "fanuc", "runs each axis at its own rate", setup);
  expect_checked(program(z + "G28 X0.\n"), "fanuc", setup);
  expect_checked(program(z + "G53 X-100.\nG53 Y-50.\n"), "fanuc", setup);
}

TEST(GcodeEffects, AWorkOffsetThatFollowsTheJointsNeedsAMachine) {
  expect_open(program("G254\nG0 X5. Y0.\nG0 Z50.\n"), "haas", "expected --machine", measured());
  expect_open(program("G254\nG0 X5. Y0.\nG255\nG0 X6.\n"), "haas", "expected --machine", measured());
}

// Source: Fanuc B-63944EN, 8.2: the unit is stated in a block of its own.
TEST(GcodeEffects, TheUnitDoesNotChangeInABlockWithAMotion) {
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(program("G20 G0 X5.\n"), control, "changes the unit in a block with axis words", measured());
    expect_checked(program("G21 G0 X5.\n"), control, measured());
  }
}

TEST(GcodeEffects, ABlockThatIsLeftOutIsNoPlaceToGoTo) {
  ProgramSetup setup = measured();
  setup.is_block_delete_on = true;
  for (const char* control : {"haas", "fanuc"}) {
    expect_open(program("GOTO5\nG1 X5. F9.\n/N5 G1 X7. F9.\n"), control, "one that is left out", setup);
    expect_open(program("#1=2**3\nG1 X#1 F9.\n"), control, "", setup);
  }
}

// The usual end of a program: the second motion does not depend on the length that the first has ended.
TEST(GcodeEffects, MotionsToTheMachineFollowOneAnother) {
  expect_checked(program("G28 G91 Z0.\nG28 X0. Y0.\n"), "haas", measured());
  expect_checked(program("G28 G91 Z0.\nG28 X0. Y0.\n"), "fanuc", measured());
  ProgramSetup setup = measured();
  setup.are_joint_rapids_straight = true;
  const Toolpath path = path_of_program(program("G53 Z-10.\nG53 X-100.\nG53 Y-50.\n"), "fanuc", setup);
  EXPECT_EQ(path.moves.back().not_checked_reason, "");
  EXPECT_NEAR((path.moves.back().end.tip - Vec3(-100, -50, -10 - 60)).norm(), 0, 1e-9);
  // A length that is applied again finds the tool where it stands.
  const Toolpath again = path_of_program(program("G91 G28 Z0.\nG90 G43 H1\nG0 X5.\nM5\n"), "haas", measured());
  EXPECT_NEAR((again.moves.back().end.tip - Vec3(5, 0, 240)).norm(), 0, 1e-9);
}

TEST(GcodeEffects, ALengthThatIsCancelledStaysSoInTheNextTool) {
  expect_open(program("G91 G28 Z0.\nG90 T2 M6\nG0 X5. Y0. Z20.\nG1 X6. F9.\n"), "haas", "cancels the tool length",
              measured());
  expect_checked(program("G91 G28 Z0.\nG90 T2 M6\nG43 H2\nG0 X5. Y0. Z20.\nG1 X6. F9.\n"), "haas", measured());
}

TEST(GcodeEffects, VariablesOfTheControlChangeItsOffsetsAndLengths) {
  for (const char* control : {"haas", "fanuc"}) {
    for (const char* variable : {"#5221", "#2001", "#11001", "#7001", "#1000"})
      expect_open(program(std::string(variable) + "=10.\nG1 X5. F9.\n"), control, std::string(variable) + ",",
                  measured());
    expect_open(program("#100=5221\n#[#100]=10.\nG1 X5. F9.\n"), control, "line 5 is not understood: #5221",
                measured());
    expect_open(program("IF [1 EQ 1] THEN #5221=10.\nG1 X5. F9.\n"), control, "#5221", measured());
    expect_open(program("G1 X#3001 F9.\n"), control, "the value of X", measured());
    expect_checked(program("#999=5.\nG1 X#999 F9.\n"), control, measured());
  }
  expect_open(program("#5241=10\nG1 X5 F9\n"), "linuxcnc", "#5241,", measured());
  expect_checked(program("#5000=5\nG1 X#5000 F9\n"), "linuxcnc", measured());
  ProgramSetup setup = measured();
  setup.start = "#5221=10.\n";
  expect_open(program("G1 X5. F9.\n"), "haas", "set variables", setup);
}

TEST(GcodeEffects, LinuxcncBeginsWithoutATolerance) {
  const std::string plain = "G17 G21 G90 G94\nG0 X0 Y0 Z1\nG1 X10 F5000\nG1 Y10\nM2\n";
  const auto read = [](const std::string& text, ProgramSetup setup) {
    setup.control = "linuxcnc";
    return read_gcode("program.ngc", SourceText(text), {std::move(setup), std::nullopt, {}, ""}, {});
  };
  const ReadOutcome outcome = read(plain, {});
  EXPECT_FALSE(can_be_clean(outcome));
  EXPECT_NE(reasons_of(outcome).find("--start G61 or --tip-tolerance"), std::string::npos) << reasons_of(outcome);
  ProgramSetup told;
  told.tip_tolerance_mm = 0.02;
  EXPECT_TRUE(can_be_clean(read(plain, told)));
  ProgramSetup exact;
  exact.start = "G61\n";
  EXPECT_TRUE(can_be_clean(read(plain, exact)));
  for (const char* block : {"G61\n", "G61.1\n"}) EXPECT_TRUE(can_be_clean(read(block + plain, {}))) << block;
}

TEST(GcodeEffects, DistancesOfSmoothingAreThoseOfTheControl) {
  const auto smoothed = [](const std::string& block) {
    return "G21 G90 G94 G17\n" + block + "\nG0 X0. Y0. Z1.\nG1 X10. F100.\nM2\n";
  };
  ProgramSetup setup;
  setup.are_joint_rapids_straight = true;
  expect_open(smoothed("G64 P0"), "linuxcnc", "an unknown distance");
  expect_open(smoothed("G64 Q0.5"), "linuxcnc", "an unknown distance");
  expect_open(smoothed("G187 P1"), "haas", "an unknown distance", setup);
  setup.tip_tolerance_mm = 0.02;
  expect_checked(smoothed("G64 P0"), "linuxcnc", setup);
  expect_checked(smoothed("G64 P0.01 Q0.01"), "linuxcnc", setup);
  expect_open(smoothed("G64 P0.01 Q0.5"), "linuxcnc", "by 0.51 mm", setup);
  expect_open(smoothed("G64 Q0.5"), "linuxcnc", "an unknown distance", setup);
  expect_open(smoothed("G187 E0.5"), "haas", "by 0.5 mm", setup);
  expect_open(smoothed("G187 P3 E0.5"), "haas", "by 0.5 mm", setup);
  expect_checked(smoothed("G187 P3 E0.02"), "haas", setup);
}

TEST(GcodeEffects, CodesOfLengthMayMoveZOnFanuc) {
  for (const char* block : {"G49\n", "G43 H2\n", "G49 G91 G0 Z-21.\n", "G49 G0 X5.\n", "G49\nG0 Z90.\n"}) {
    expect_open(program(block), "fanuc", "parameter 5006#6", measured());
    expect_checked(program(block), "haas", measured());
  }
  for (const char* block : {"G49 G0 Z90.\nG1 X5. F9.\n", "G43 H1\nG0 X5.\n", "G43 H2 Z70.\nG1 X5. F9.\n"})
    expect_checked(program(block), "fanuc", measured());
}

TEST(GcodeEffects, M99InTheMainProgramBeginsItAgain) {
  for (const char* control : {"haas", "fanuc"}) {
    const ReadOutcome outcome =
        read_program("%\nO0001\n" + std::string(kStart) + "G1 X5. F9.\nM99\n%\n", control, measured());
    EXPECT_NE(reasons_of(outcome).find("begins it again"), std::string::npos) << reasons_of(outcome);
    ASSERT_TRUE(outcome.toolpath.has_value());
    for (const Assumption& fact : outcome.toolpath->assumptions) {
      if (fact.subject == Subject::completeness) {
        EXPECT_EQ(fact.basis, Basis::unknown);
      }
    }
  }
}

TEST(GcodeEffects, SubprogramsOfLinuxcncHaveThirtyVariablesOfTheirOwn) {
  const std::string start = "G17 G21 G90 G94\nG0 X0 Y0 Z10\n";
  const auto after_call = [&](const std::string& variable) {
    return path_of_program(
        start + variable + "=5\no100 sub\n" + variable + "=9\no100 endsub\no100 call\nG1 X" + variable + " F100\nM2\n",
        "linuxcnc");
  };
  expect_tip(after_call("#31").moves.back(), 9, 0, 10);
  expect_tip(after_call("#30").moves.back(), 5, 0, 10);
}

TEST(GcodeEffects, RepeatRoundsToTheNearest) {
  for (const auto& [count, depth] : {std::pair{"0.3/0.1", 3}, {"2.4", 2}, {"2.5", 3}, {"0.4", 0}}) {
    const Toolpath path = path_of_program(
        "G17 G21 G94 G90\nG0 X0 Y0 Z0\nG91\no1 repeat [" + std::string(count) + "]\nG1 Z-1 F100\no1 endrepeat\nM2\n",
        "linuxcnc");
    EXPECT_EQ(path.moves.size(), static_cast<std::size_t>(depth) + 1) << count;
  }
}

TEST(GcodeEffects, OffsetsOfAToolBesideItsAxisAreNotRead) {
  ProgramSetup setup = measured();
  setup.lengths_mm[1] = kSidewaysLength;
  setup.tool_length_mm = 60;
  const std::string text = "G17 G21 G90 G94\nT1 M6\nG43 H2\nG0 X0 Y0 Z80\nG1 X5 Z9 F100\nM2\n";
  expect_open(text, "linuxcnc", "other axes than Z", setup);
  expect_open("G17 G21 G90 G94\nT2 M6\nG43 H1\nG0 X0 Y0 Z80\nG1 X5 F100\nM2\n", "linuxcnc", "other axes than Z", setup);
  expect_checked("G17 G21 G90 G94\nT2 M6\nG43 H2\nG0 X0 Y0 Z80\nM2\n", "linuxcnc", setup);
}

TEST(GcodeEffects, G80MayStandBesideAMotionCodeThatIsNoCycle) {
  const std::string text = "G21 G94\nG0 G17 G40 G49 G80 G90\nX0. Y0. Z10.\nG1 Z0.1 F100.\nM30\n";
  for (const char* control : {"haas", "fanuc"}) {
    expect_checked(text, control);
    expect_open(program("G80 G81 Z-1. R1. F9.\n"), control, "exclude each other");
    expect_open(program("G0 G81 Z-1. R1. F9.\n"), control, "exclude each other");
    expect_open(program("G80 X5.\n"), control, "without a motion code");
    const Toolpath path = path_of_program(program("G81 G98 Z-1. R1. F9.\nG80 G0 X5.\nG1 Y5.\n"), control);
    expect_tip(path.moves.back(), 5, 5, 80);
  }
  expect_open("G21 G17 G90\nG0 G80\nX0 Y0 Z0\nM2\n", "linuxcnc", "exclude each other");
}

TEST(GcodeEffects, CyclesRepeatBySteps) {
  for (const auto& [control, word] : {std::pair{"haas", "L3"}, {"fanuc", "K3"}, {"linuxcnc", "L3"}}) {
    const std::string text =
        "G17 G21 G90 G94\nT1 M6\nG0 X0. Y0. Z10.\nG91 G99 G81 X5. R-8. Z-1.5 " + std::string(word) + " F100.\nM30\n";
    const Toolpath path = path_of_program(text, control);
    std::vector<double> bottoms;
    for (const Move& move : path.moves) {
      EXPECT_EQ(move.not_checked_reason, "") << control;
      if (move.kind != MoveKind::feed) continue;
      bottoms.push_back(move.end.tip.x());
      EXPECT_NEAR(move.end.tip.z(), 0.5, 1e-9) << control;
    }
    EXPECT_EQ(bottoms, (std::vector<double>{5, 10, 15})) << control;
  }
  expect_open(program("G98 G81 X5. R2. Z-1.5 L0 F100.\n"), "haas", "L of the cycle is 0");
  expect_open(program("G91 G99 G81 X5. R-8. Z-1.5 F100.\nX5.\n"), "haas", "R of the cycle counts");
}

TEST(GcodeEffects, BehindACycleThatIsNotUnderstoodThePlaceIsNotKnown) {
  const std::string start = "G17 G21 G90 G94\nT1 M6\nG54 G0 X0. Y0.\nG43 H1 Z50.\n";
  const auto is_place_known = [&](const std::string& control, const std::string& blocks) {
    const Toolpath path = path_of_program(start + blocks + "G80\nG90 G0 Y30.\nM30\n", control);
    return path.moves.back().not_checked_reason.empty();
  };
  for (const std::string control : {"haas", "fanuc", "linuxcnc"}) {
    EXPECT_TRUE(is_place_known(control, "G98 G81 X5. Z-3. R5. F100.\n")) << control;
    EXPECT_FALSE(is_place_known(control, "G91 G98 G81 X5. Z-3. R-45. F100. L0\n")) << "repeats, " << control;
    EXPECT_FALSE(is_place_known(control, "G0 Z1.\nG98 G81 X5. Z-3. R5. F100.\n")) << "below R, " << control;
    EXPECT_FALSE(is_place_known(control, "G98 G81 X5. Z9. R5. F100.\n")) << "bottom above R, " << control;
    EXPECT_FALSE(is_place_known(control, "G18\nG98 G81 X5. Z-3. R5. F100.\n")) << "another plane, " << control;
  }
  // The tool bores across the hole, and ends above it.
  EXPECT_TRUE(is_place_known("haas", "G98 G76 X5. Z-3. R5. Q0.1 F100.\n"));
  EXPECT_FALSE(is_place_known("haas", "G99 G81 X5. Z-3. R5. F100.\nG98 G83 X6. Z-3. R5. Q1.\n")) << "another level";
}

TEST(GcodeEffects, MotionsBesideCodesThatEndOrCallAreNotRead) {
  for (const char* code : {"M30", "M2", "M99", "M98 P5", "M6", "G4 P1."})
    expect_open(
        program(std::string("T1 Y5. ") + code + "\n"), "fanuc",
        "a motion beside " + std::string(code).substr(0, std::string(code).find(' ')) + ", here Y5, is not read");
}

TEST(GcodeEffects, NamesTheWordAndItsLine) {
  const ReadOutcome outcome = read_program("G17 G21 G90 G94\nG0 X0 Y0 Z10\nG1 X5 X10 F100\nM2\n", "linuxcnc");
  ASSERT_TRUE(outcome.toolpath.has_value());
  for (const Assumption& fact : outcome.toolpath->assumptions) {
    if (fact.subject == Subject::statements) {
      EXPECT_EQ(fact.evidence, "not understood: line 3: the word X occurs twice in the block");
    }
    if (fact.subject == Subject::completeness) {
      EXPECT_EQ(fact.line, 4u);
    }
  }
}

}  // namespace
}  // namespace gouge::test::traps2_test
