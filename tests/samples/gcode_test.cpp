// Programs (G-code) of the samples: the same verdict on every move as the CL data they are made of, under the same law.
#include <gtest/gtest.h>

#include <filesystem>

#include "lib/base/files.h"
#include "lib/machine/read_machine.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/samples/csv.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/gcode_writer.h"
#include "tests/support/source_folder.h"

namespace gouge::testing_samples {
namespace {

constexpr const char* kPreset = "linuxcnc-xyzac-trt";

Machine preset() { return read_machine(kPreset, find_preset(kPreset)->text).value(); }

class GcodeSample : public testing::TestWithParam<const char*> {};

TEST_P(GcodeSample, HasTheVerdictsOfItsClData) {
  const SampleFolder sample = open_sample(GetParam());
  const std::string file = sample.path + "/" + sample.toolpath();
  const ReadOutcome read = read_toolpath(file, SourceText(text_of(file)));
  ASSERT_TRUE(read.toolpath.has_value());
  const auto program = test::write_program(*read.toolpath, preset());
  if (!program) GTEST_SKIP() << "the writer of this test does not state every move of it";
  write_text(sample.path + "/program.ngc", *program);
  const std::vector<std::string> more = {"--machine", std::string("preset:") + kPreset, "--csv"};
  std::vector<std::vector<MoveRow>> rows;
  for (const std::string& path : {sample.toolpath(), std::string("program.ngc")}) {
    std::vector<std::string> options = more;
    options.push_back(path + ".csv");
    const Outcome ran = run_gougecheck(sample.path, sample.arguments("check", path, options));
    EXPECT_NE(ran.exit_status, 3) << ran.err;
    rows.push_back(parse_moves(text_of(sample.path + "/" + path + ".csv")));
  }
  ASSERT_EQ(rows[0].size(), rows[1].size());
  ASSERT_GT(rows[0].size(), 0u);
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    EXPECT_EQ(rows[0][i].state, rows[1][i].state) << "move " << i << ", line " << rows[1][i].line;
    EXPECT_NEAR(rows[0][i].depth_value(), rows[1][i].depth_value(), 2e-3) << "move " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, GcodeSample,
                         testing::Values("freeform", "pocket", "blade", "between_rib", "thin_post", "inch", "needles",
                                         "big_triangles", "arcs_nx", "arcs_creo", "buried", "between_swing"),
                         [](const auto& test) { return std::string(test.param); });

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
    EXPECT_LT(std::stod(ran.out.substr(at + 32)), 2e-4) << file.path() << "\n" << ran.out;
  }
}

}  // namespace
}  // namespace gouge::testing_samples
