#include "postproc/cldata/parsing/spindle_statement.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/postproc/cldata/path_of.h"

namespace gouge::spindle_statement_test {
namespace {

/// Returns the speed in a motion after these statements.
float speed_after(const std::string& statements) {
  return path_of("UNITS/MM\n" + statements + "GOTO/1,2,3\nGOTO/1,2,4\nFINI\n").moves.back().spindle_rpm;
}

TEST(SpindleStatement, StatesTheSpeedInTheFormsOfCamSystems) {
  EXPECT_EQ(speed_after("SPINDL/RPM,12000,CLW\n"), 12000);
  EXPECT_EQ(speed_after("SPINDL / 5000, RPM, CLW\n"), 5000);
  EXPECT_EQ(speed_after("SPINDL/800,CCLW\n"), 800);
  EXPECT_EQ(speed_after("SPINDL/RANGE,2,RPM,900,CLW\n"), 900);
  EXPECT_EQ(speed_after("spindl/rpm,1500.5,clw\n"), 1500.5F);
}

TEST(SpindleStatement, HoldsUntilTheNextOneThatChangesIt) {
  EXPECT_EQ(speed_after("SPINDL/RPM,900,CLW\nSPINDL/ON\n"), 900);
  EXPECT_EQ(speed_after("SPINDL/RPM,900,CLW\nSPINDL/OFF\n"), Move::kSpindleStopped);
  EXPECT_EQ(speed_after("SPINDL/RPM,900,CLW\nSPINDL/SFM,300,CLW\n"), 0) << "a speed along the surface is none in turns";
  EXPECT_EQ(speed_after(""), 0);
}

TEST(SpindleStatement, StopsAndStartsTheSpindle) {
  const auto is_stopped_after = [](const std::string& statements) {
    return path_of("UNITS/MM\n" + statements + "GOTO/1,2,3\nGOTO/1,2,4\nFINI\n").moves.back().is_spindle_stopped();
  };
  EXPECT_FALSE(is_stopped_after("")) << "a file that states nothing runs with a turning spindle";
  for (const char* const stop : {"SPINDL/OFF\n", "spindl / off\n", "SPINDL/ORIENT\n", "SPINDL/LOCK\n",
                                 "SPINDL/NEUTRL\n", "SPINDL/0\n", "SPINDL/RPM,0,CLW\n", "SPINDL/OFF\nSPINDL/0,RPM\n"})
    EXPECT_TRUE(is_stopped_after(stop)) << stop;
  for (const char* const start : {"SPINDL/ON\n", "SPINDL/RPM,900,CLW\n", "SPINDL/800,CCLW\n"})
    EXPECT_FALSE(is_stopped_after(std::string("SPINDL/OFF\n") + start)) << start;
  EXPECT_TRUE(is_stopped_after("SPINDL/OFF\nSPINDL/MAXRPM,6000\n"));
  EXPECT_TRUE(is_stopped_after("SPINDL/OFF\nSPINDL/RANGE,2\n"));
  EXPECT_FALSE(is_stopped_after("SPINDL/MAXRPM,6000\n"));
}

}  // namespace
}  // namespace gouge::spindle_statement_test
