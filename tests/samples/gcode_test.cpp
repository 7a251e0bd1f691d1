// Programs (G-code) of the samples: the same verdict on every move as the CL data they are made of, under the same law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lib/base/files.h"
#include "lib/base/units.h"
#include "lib/machine/read_machine.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/samples/box_stl.h"
#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/gcode_writer.h"
#include "tests/support/source_folder.h"

namespace gouge::testing_samples::gcode_test {
namespace {

/// A machine, the control of its program, and the facts that the program does not state.
struct ProgramCase {
  const char* preset;
  test::WrittenControl control;
  std::vector<std::string> laws;   ///< options of both checks
  std::vector<std::string> facts;  ///< options of the check of the program
};

const std::vector<std::string> kByAxis = {"--feed-law", "axis", "--rapid-law", "axis"};
const std::vector<std::string> kOfFanuc = {"--control",      "fanuc",         "--tip-frame",   "table-at-zero",
                                           "--rotary-turns", "as-programmed", "--tool-length", "100"};

const ProgramCase kTrunnion = {"linuxcnc-xyzac-trt", test::WrittenControl::linuxcnc, {}, {}};

std::vector<ProgramCase> other_machines() {
  return {
      {"linuxcnc-xyzbc-trt", test::WrittenControl::linuxcnc, {}, {}},
      {"haas-umc750", test::WrittenControl::haas, kByAxis, {"--rotary-turns", "as-programmed", "--tool-length", "100"}},
      {"table-b-head", test::WrittenControl::fanuc, kByAxis, kOfFanuc},
      {"head-ca", test::WrittenControl::fanuc, kByAxis, kOfFanuc},
      {"nutating-45", test::WrittenControl::fanuc, kByAxis, kOfFanuc}};
}

void expect_verdicts_of_cl_data(const char* name, const ProgramCase& of) {
  const SampleFolder sample = open_sample(name);
  const std::string file = sample.path + "/" + sample.toolpath();
  const ReadOutcome read = read_toolpath(file, SourceText(text_of(file)));
  ASSERT_TRUE(read.toolpath.has_value());
  const Machine machine = read_machine(of.preset, find_preset(of.preset)->text).value();
  const auto program = test::write_program(*read.toolpath, machine, of.control);
  if (!program) GTEST_SKIP() << "the writer of this test does not state every move of it";
  write_text(sample.path + "/program.nc", *program);
  std::vector<std::vector<MoveRow>> rows;
  for (const std::string& path : {sample.toolpath(), std::string("program.nc")}) {
    std::vector<std::string> options = {"--machine", std::string("preset:") + of.preset};
    options.insert(options.end(), of.laws.begin(), of.laws.end());
    if (path == "program.nc") options.insert(options.end(), of.facts.begin(), of.facts.end());
    options.insert(options.end(), {"--csv", path + ".csv"});
    const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", path, options));
    EXPECT_NE(ran.exit_status, 3) << ran.err;
    EXPECT_NE(ran.exit_status, 2) << ran.err;
    rows.push_back(parse_moves(text_of(sample.path + "/" + path + ".csv")));
  }
  ASSERT_EQ(rows[0].size(), rows[1].size());
  ASSERT_GT(rows[0].size(), 0u);
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    EXPECT_EQ(rows[0][i].state, rows[1][i].state) << "move " << i << ", line " << rows[1][i].line;
    EXPECT_NEAR(rows[0][i].depth_value(), rows[1][i].depth_value(), 2e-3) << "move " << i;
  }
}

class GcodeSample : public testing::TestWithParam<const char*> {};

TEST_P(GcodeSample, HasTheVerdictsOfItsClData) { expect_verdicts_of_cl_data(GetParam(), kTrunnion); }

INSTANTIATE_TEST_SUITE_P(Samples, GcodeSample,
                         testing::Values("freeform", "pocket", "blade", "between_rib", "thin_post", "inch", "needles",
                                         "big_triangles", "arcs_nx", "arcs_creo", "buried", "between_swing"),
                         [](const auto& test) { return std::string(test.param); });

class GcodeMachine : public testing::TestWithParam<ProgramCase> {};

TEST_P(GcodeMachine, HasTheVerdictsOfItsClData) {
  for (const char* sample : {"freeform", "pocket", "blade", "between_rib", "inch", "between_swing"})
    expect_verdicts_of_cl_data(sample, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Presets, GcodeMachine, testing::ValuesIn(other_machines()), [](const auto& test) {
  std::string name = test.param.preset;
  std::ranges::replace(name, '-', '_');
  return name;
});

/// The public programs, with the figures of their laws of motion.
class PublicProgram : public testing::Test {
 protected:
  void SetUp() override {
    data_ = std::filesystem::path(source_folder()).string() + "/../shared/data/gcode/";
    if (!std::filesystem::exists(data_)) GTEST_SKIP() << "no ../shared/data/gcode";
  }
  [[nodiscard]] std::string laws_of(const std::string& file, const std::string& machine) const {
    const Outcome ran =
        run_gougecheck(fresh_folder(), {"path", "laws", data_ + file, "--machine", machine, "--start", "G61"});
    EXPECT_EQ(ran.exit_status, 0) << ran.err;
    return ran.out + ran.err;
  }

  std::string data_;
};

TEST_F(PublicProgram, LawsOfTheDemosOfLinuxcnc) {
  const std::string impeller =
      laws_of("linuxcnc_table-rotary-tilting__impeller-7bl-xyzac.ngc", "preset:linuxcnc-xyzac-trt");
  EXPECT_NE(impeller.find("1.9078 deg"), std::string::npos) << impeller;
  EXPECT_NE(impeller.find("line 3401"), std::string::npos) << impeller;
  const std::string boat = laws_of("linuxcnc_table-rotary-tilting__boat-xyzac.ngc", "preset:linuxcnc-xyzac-trt");
  EXPECT_NE(boat.find("0.9646 deg"), std::string::npos) << boat;
  EXPECT_NE(boat.find("line 433"), std::string::npos) << boat;
}

TEST_F(PublicProgram, LawsOfTheHaasProgram) {
  const std::string haas = laws_of("haas_umc750_final.txt", "preset:haas-umc750");
  EXPECT_NE(haas.find("0.4143 deg"), std::string::npos) << haas;
  EXPECT_NE(haas.find("line 15419"), std::string::npos) << haas;
  EXPECT_NE(haas.find("12501: warning: the tool axis turns to its opposite"), std::string::npos) << haas;
}

TEST_F(PublicProgram, TheHaasProgramHasThePositionsOfItsClData) {
  for (const auto& file : std::filesystem::directory_iterator(data_ + "../toolpaths/five_axis_part")) {
    std::vector<std::string> arguments = {
        "compare", "--paths", file.path().string(), data_ + "haas_umc750_final.txt", "--machine", "preset:haas-umc750"};
    if (file.path().extension() == ".cl")
      arguments.insert(arguments.end(), {"--path-units", "inch"});  // it states none
    const Outcome ran = run_gougecheck(fresh_folder(), arguments);
    const std::size_t at = ran.out.find("largest distance of a tip");
    ASSERT_NE(at, std::string::npos) << file.path() << ran.out << ran.err;
    const double largest_mm = std::stod(ran.out.substr(at + 32));
    if (file.path().filename() ==
        "subset_nccs.cl")  // its record 225 is straight, where the program has an arc of 90 degrees
      EXPECT_NEAR(largest_mm, 0.375 * (1 - std::sqrt(0.5)) * 25.4, 1e-3) << ran.out;
    else
      EXPECT_LT(largest_mm, 2e-4) << file.path() << "\n" << ran.out;
  }
}

/// A folder with a thin tool, its length of 100 mm, and a box.
class SmallProgram : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fresh_folder();
    write_text(
        folder_ + "/tools.json",
        R"({"units": "mm", "tools": [{"number": 1, "cutter": {"shape": "flat", "diameter": 1, "length": 12}}]})");
    write_text(folder_ + "/lengths.csv", "tool,length\n1,100\n");
  }
  Outcome check(const std::string& text, const Vec3& low, const Vec3& high,
                const std::vector<std::string>& more) const {
    write_text(folder_ + "/program.nc", text);
    write_text(folder_ + "/part.stl", box_stl({low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}));
    std::vector<std::string> all = {"check", "program.nc", "--part",     "part.stl", "--stl-units",
                                    "mm",    "--tools",    "tools.json", "--json",   "check.json"};
    all.insert(all.end(), more.begin(), more.end());
    return run_gougecheck(folder_, all);
  }

  std::string folder_;
};

// Without tool centre point control the tip swings on a circle about the axis A, by the length of the tool.
TEST_F(SmallProgram, SwingsByTheLengthOfItsTool) {
  const std::string text =
      "G21 G17 G90 G94 G40 G49 G80\nT1 M6\nG0 A0. C0.\nX0. Y0.\nG43 H1 Z5.\nG1 X10. Z-5. F100.\nG1 A30. F100.\nM30\n";
  const std::vector<std::string> machine = {
      "--control",      "fanuc",         "--machine",         "preset:head-ca", "--joint-point",  "C=5,0,-10",
      "--joint-point",  "A=5,3,-20",     "--feed-law",        "vector",         "--rapid-law",    "vector",
      "--rotary-turns", "as-programmed", "--joint-rapid-law", "joint",          "--tool-lengths", "lengths.csv"};
  // In the middle the tip is 80 mm from the axis of A, at 15 degrees; 8 degrees aside no tool passes.
  const Vec3 middle(10, 80 * std::sin(15 * kDegree_rad), 75 - 80 * std::cos(15 * kDegree_rad)), half(0.4, 0.4, 0.3);
  const Outcome swung = check(text, middle - half, middle + half, machine);
  EXPECT_EQ(swung.exit_status, 1) << swung.out << swung.err;
  const Outcome verified = run_gougecheck(folder_, {"verify", "check.json"});
  EXPECT_EQ(verified.exit_status, 0) << verified.out << verified.err;
  const Vec3 aside(10, middle.y(), middle.z() - 3);
  const Outcome clear = check(text, aside - half, aside + half, machine);
  EXPECT_EQ(clear.exit_status, 0) << clear.out << clear.err;
  EXPECT_EQ(run_gougecheck(folder_, {"verify", "check.json"}).exit_status, 0);
}

// The rapid from the tool change may pass through all that is as high as its end.
TEST_F(SmallProgram, ThatBeginsBelowTheTopIsNotFullyChecked) {
  const auto with = [&](const std::string& first, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"--control", "haas", "--assume", "placement"};
    all.insert(all.end(), more.begin(), more.end());
    return check("G21 G17 G90 G94 G40 G49 G80\nT1 M6\nG43 H1\n" + first + "G1 X55. F100.\nM30\n", Vec3(40, -50, -10),
                 Vec3(48, 50, 60), all);
  };
  for (const char* first : {"G0 X50. Y0. Z5.\n", "G0 X50. Y0.\nZ5.\n", "G0 Z5.\nX50. Y0.\n"}) {
    const Outcome ran = with(first, {"--joint-rapid-law", "joint"});
    EXPECT_EQ(ran.exit_status, 4) << first << ran.out;
    EXPECT_NE(ran.out.find("at height 5 mm, not above the top of 60 mm"), std::string::npos) << first << ran.out;
    EXPECT_EQ(with(first, {"--joint-rapid-law", "joint", "--assume", "complete"}).exit_status, 0) << first;
  }
  EXPECT_EQ(with("G0 X50. Y0. Z61.\nZ5.\n", {"--joint-rapid-law", "joint"}).exit_status, 0);
}

// A missing fact is never taken as 0: the place of one work offset against another.
TEST_F(SmallProgram, CutsTheStockInItsOwnWorkOffset) {
  const auto slot = [](const std::string& offset, const char* cut) {
    return "G21 G17 G90 G94 G40 G49 G80\nT1 M6\nG0 " + offset + " X-50. Y0. Z60.\n" + cut +
           "X50. F100.\nG0 Z60.\nM30\n";
  };
  for (const std::string offset : {"G54", "G55"}) {
    write_text(folder_ + "/before.nc", slot(offset, "G0 Z30.\nG1 Z-5.2 F100.\n"));
    const auto after = [&](const std::string& place) {
      return check(slot("G54", "Z-5.\nG1 "), Vec3(-40, -10, -20), Vec3(40, 10, -6),
                   {"--control", "haas", "--joint-rapid-law", "joint", "--stock", "part+6", "--before",
                    "before.nc" + place, "--assume", "complete"});
    };
    const Outcome as_it_is = after("");
    EXPECT_EQ(as_it_is.exit_status == 3, offset == "G55") << as_it_is.out << as_it_is.err;
    EXPECT_EQ(as_it_is.err.find("before-place") != std::string::npos, offset == "G55") << as_it_is.err;
    EXPECT_NE(after(",place=0,0,0").exit_status, 3);
  }
}

// The tool stands at X20 of G54, which is X50 of G55, above the wall.
TEST_F(SmallProgram, KeepsItsPlaceWhenTheOffsetChanges) {
  const std::string text =
      "G21 G17 G90 G94 G40 G49 G80\nT1 M6\nG54\nG0 X20. Y20.\nG55\nG43 H1 Z60.\nG1 Z0. F250.\nY80.\nG0 Z60.\nM30\n";
  const auto with = [&](const std::vector<std::string>& offsets) {
    std::vector<std::string> options = {"--control", "haas", "--joint-rapid-law", "joint", "--assume", "placement"};
    options.insert(options.end(), offsets.begin(), offsets.end());
    return check(text, Vec3(45, 0, -20), Vec3(55, 100, 20), options);
  };
  const Outcome unknown = with({});
  EXPECT_EQ(unknown.exit_status, 3) << unknown.out << unknown.err;
  EXPECT_NE(unknown.err.find("--offset G54=X,Y,Z and --offset G55=X,Y,Z"), std::string::npos) << unknown.err;
  const Outcome in_wall = with({"--offset", "G54=0,0,0", "--offset", "G55=-30,0,0"});
  EXPECT_EQ(in_wall.exit_status, 1) << in_wall.out << in_wall.err;
  const Outcome beside = with({"--offset", "G54=0,0,0", "--offset", "G55=0,0,0"});
  EXPECT_EQ(beside.exit_status, 0) << beside.out << beside.err;
}

// The second program of the file cuts into the part, and does not run with the first one.
TEST_F(SmallProgram, WithAnotherOneInItsFileIsNotFullyChecked) {
  const std::string blocks = "G21 G17 G90 G94 G40 G49 G80\nT1 M6\nG0 X20. Y20.\nG43 H1 Z60.\nG1 Z0. F250.\nY80.\n";
  const auto with = [&](const std::string& end) {
    return check("%\nO1000\n" + blocks + "G0 Z60.\nM30\nO2000\n" + blocks + "Z-5.\nG0 Z60.\n" + end + "\n%\n",
                 Vec3(0, 0, -20), Vec3(100, 100, 0), {"--control", "fanuc", "--joint-rapid-law", "joint"});
  };
  const Outcome main_program = with("M30");
  EXPECT_EQ(main_program.exit_status, 4) << main_program.out << main_program.err;
  EXPECT_NE(main_program.err.find("program.nc:11: warning: program O2000, which ends with M30,"), std::string::npos)
      << main_program.err;
  const Outcome subprogram = with("M99");
  EXPECT_EQ(subprogram.exit_status, 0) << subprogram.out << subprogram.err;
}

// No manual states which of both solutions of the rotary joints a control takes for a vector.
TEST_F(SmallProgram, WithVectorsIsCheckedByTheLawOfVectorsAlone) {
  const std::string text =
      "G17 G71 G90 G40 G60 G94\nTRAFOOF\nT1 M6\nD1\nG54\nTRAORI\nG0 X0 Y0 B0 C0\nZ50\nG1 Z0 F100\nB60 C0 X10\n"
      "A3=-0.852868532 B3=0.150383733 C3=0.5 X20\nX30\nM30\n";
  const auto with = [&](const std::string& law) {
    return check(text, Vec3(500, 0, 0), Vec3(501, 1, 1),
                 {"--control", "siemens", "--machine", "preset:table-b-head", "--feed-law", law, "--rapid-law", law,
                  "--rotary-turns", "as-programmed", "--tool-length", "100", "--joint-rapid-law", "joint", "--assume",
                  "placement"});
  };
  for (const char* law : {"axis", "documented", "any"}) {
    const Outcome ran = with(law);
    EXPECT_EQ(ran.exit_status, 4) << law << ran.out << ran.err;
    EXPECT_NE(ran.out.find(":11: not checked: the program states the tool axis as a vector"), std::string::npos)
        << ran.out << ran.err;
  }
  const Outcome by_vector = with("vector");
  EXPECT_EQ(by_vector.exit_status, 0) << by_vector.out << by_vector.err;
}

}  // namespace
}  // namespace gouge::testing_samples::gcode_test
