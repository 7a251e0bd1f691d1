#include "lib/machine/linuxcnc_ini.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/units.h"
#include "lib/machine/kinematics.h"
#include "tests/support/scatter.h"

// Configurations of LinuxCNC against the formulas of its forward kinematics (src/emc/kinematics/trtfuncs.c).

namespace gouge::linuxcnc_ini_test {
namespace {

std::string configuration(const std::string& kinematics, int conventional) {
  return "[KINS]\nKINEMATICS = " + kinematics + "\n[TRAJ]\nLINEAR_UNITS = mm\n[HAL]\nHALCMD = setp " + kinematics +
         ".conventional-directions " + std::to_string(conventional) + "\n";
}

/// Factors of the linear joints in xyzacKinematicsForward; `sign` is its `con`.
Eigen::Matrix3d xyzac(double c, double a, double sign) {
  Eigen::Matrix3d m;
  m << std::cos(c), -sign * std::sin(c) * std::cos(a), std::sin(c) * std::sin(a),  //
      sign * std::sin(c), std::cos(c) * std::cos(a), -sign * std::cos(c) * std::sin(a), 0, sign * std::sin(a),
      std::cos(a);
  return m;
}

/// The same of xyzbcKinematicsForward.
Eigen::Matrix3d xyzbc(double c, double b, double sign) {
  Eigen::Matrix3d m;
  m << std::cos(c) * std::cos(b), -sign * std::sin(c), sign * std::cos(c) * std::sin(b),
      sign * std::sin(c) * std::cos(b), std::cos(c), std::sin(c) * std::sin(b), -sign * std::sin(b), 0, std::cos(b);
  return m;
}

TEST(LinuxCncIni, TurnsTheToolByTheFormulasOfTheControl) {
  test::Scatter scatter(5);
  for (const int conventional : {0, 1}) {
    const double sign = conventional == 1 ? 1 : -1;
    for (const bool is_ac : {true, false}) {
      const Result<Machine> machine =
          read_linuxcnc_ini("a.ini", configuration(is_ac ? "xyzac-trt-kins" : "xyzbc-trt-kins", conventional));
      ASSERT_TRUE(machine) << machine.error().message;
      for (int n = 0; n < 1'000; ++n) {
        const double c = scatter.in(-7, 7), tilt = scatter.in(-2, 2);
        const Eigen::Matrix3d expected = is_ac ? xyzac(c, tilt, sign) : xyzbc(c, tilt, sign);
        ASSERT_LT((tool_axes(*machine, {c, tilt}) - expected).norm(), 1e-12) << is_ac << " " << conventional;
      }
    }
  }
}

TEST(LinuxCncIni, WarnsOfAxesWithoutTheirSection) {
  const std::string bytes = configuration("xyzac-trt-kins", 0), linear = "[AXIS_X]\n[AXIS_Y]\n[AXIS_Z]\n";
  const auto warning_of = [&](const std::string& sections) {
    const Diagnostics all = describe_missing_axes(read_linuxcnc_ini("a.ini", bytes + sections).value(), "a.ini");
    return all.empty() ? "" : to_text(all.front());
  };
  EXPECT_NE(warning_of("").find("no section [AXIS_C], [AXIS_A], [AXIS_X], [AXIS_Y], [AXIS_Z], so"), std::string::npos)
      << warning_of("");
  EXPECT_NE(warning_of(linear + "[AXIS_C]\n").find("a.ini: warning: there is no section [AXIS_A], so"),
            std::string::npos);
  EXPECT_EQ(warning_of(linear + "[AXIS_C]\n[AXIS_A]\n"), "");
  Machine stated = read_linuxcnc_ini("a.ini", bytes + linear + "[AXIS_C]\n").value();
  stated.joints[1].max = 1;
  EXPECT_TRUE(describe_missing_axes(stated, "a.ini").empty());
}

TEST(LinuxCncIni, TakesTheNarrowerLimitsOfAxisAndJoint) {
  std::string bytes = configuration("xyzbc-trt-kins", 0) +
                      "[AXIS_B]\nMIN_LIMIT = -36000\nMAX_LIMIT = 40\nMAX_VELOCITY = 30\n"
                      "[JOINT_3]\nMIN_LIMIT = -100\nMAX_LIMIT = 50\nMAX_VELOCITY = 20\n[JOINT_4]\nMIN_LIMIT = -720\n";
  const auto degrees = [](const std::optional<double>& rad) { return rad.value() / kDegree_rad; };
  const Machine machine = read_linuxcnc_ini("a.ini", bytes).value();
  ASSERT_EQ(machine.joints[1].name, "B");
  EXPECT_NEAR(degrees(machine.joints[1].min), -100, 1e-9);
  EXPECT_NEAR(degrees(machine.joints[1].max), 40, 1e-9);
  EXPECT_NEAR(degrees(machine.joints[1].rate), 20 * 60, 1e-9);
  EXPECT_NEAR(degrees(machine.joints[0].min), -720, 1e-9) << "C is the fifth of XYZBC";
  const std::string stated = "KINEMATICS = xyzbc-trt-kins";
  bytes.insert(bytes.find(stated) + stated.size(), " coordinates=XYZCB");
  const Machine other = read_linuxcnc_ini("a.ini", bytes).value();
  EXPECT_NEAR(degrees(other.joints[0].min), -100, 1e-9) << "now joint 3 is C";
}

TEST(LinuxCncIni, RefusesWhatItDoesNotKnow) {
  const std::string good = configuration("xyzac-trt-kins", 0);
  const struct {
    std::string from, to, message;
  } kCases[] = {
      {"xyzac-trt-kins", "trivkins", "KINEMATICS is 'trivkins'"},
      {"KINEMATICS = xyzac-trt-kins", "", "[KINS] has no KINEMATICS"},
      {"= mm", "= cubit", "LINEAR_UNITS is 'cubit'"},
      {"LINEAR_UNITS = mm", "", "[TRAJ] has no LINEAR_UNITS"},
      {"= mm", "= mm\nANGULAR_UNITS = rad", "ANGULAR_UNITS is 'rad'"},
      {"directions 0", "directions maybe", "conventional-directions is 'maybe'"},
      {"setp ", "sets ", "no HALCMD states the rotary directions"},
      {"[TRAJ]", "[AXIS_C]\nMAX_VELOCITY = fast\n[TRAJ]", "MAX_VELOCITY is 'fast'"},
  };
  for (const auto& one : kCases) {
    std::string bytes = good;
    bytes.replace(bytes.find(one.from), one.from.size(), one.to);
    const Result<Machine> machine = read_linuxcnc_ini("a.ini", bytes);
    ASSERT_FALSE(machine) << one.message;
    EXPECT_NE(machine.error().message.find(one.message), std::string::npos) << machine.error().message;
  }
}

TEST(LinuxcncIni, NamesSettingsThatProgramsAreNotReadBy) {
  const auto control_of = [](const std::string& more, const std::string& sparm) {
    std::string text = configuration("xyzac-trt-kins", true);
    text.replace(text.find("xyzac-trt-kins"), 14, "xyzac-trt-kins" + sparm);
    return read_linuxcnc_ini("machine.ini", text + more).value().control;
  };
  const std::string first = " sparm=identityfirst";
  EXPECT_EQ(control_of("[RS274NGC]\nREMAP = M428 modalgroup=10 ngc=428remap\n[AXIS_B]\nWRAPPED_ROTARY = 0\n", first)
                .unread_setting,
            "");
  EXPECT_EQ(control_of("[RS274NGC]\nRS274NGC_STARTUP_CODE = G18 G61\n", first).start, "G18 G61");
  EXPECT_NE(control_of("", "").unread_setting.find("without sparm=identityfirst"), std::string::npos);
  EXPECT_NE(control_of("[RS274NGC]\nREMAP = M428 ngc=a\nREMAP = M8 ngc=coolant\n", first).unread_setting.find("M8"),
            std::string::npos);
  EXPECT_NE(control_of("[AXIS_B]\nWRAPPED_ROTARY = 1\n", first).unread_setting.find("WRAPPED_ROTARY"),
            std::string::npos);
}

}  // namespace
}  // namespace gouge::linuxcnc_ini_test
