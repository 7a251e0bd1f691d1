#include "cli/commands/clash_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/mesh/write_stl.h"
#include "tests/support/solids.h"
#include "tests/support/temporary_folder.h"

namespace gouge::clash_command_test {
namespace {

namespace fs = std::filesystem;

struct RunResult {
  int status = 0;
  std::string out, err;
};

class ClashCommand : public testing::Test {
 protected:
  void SetUp() override {
    arguments_.a = write("part.stl", shapes::box(Vec3(0, 0, 0), Vec3(100, 60, 40)));
    arguments_.b = write("jaw.stl", shapes::box(Vec3(-20, -30, -10), Vec3(120, 2, 30)));
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.at(name); }

  [[nodiscard]] std::string write(const std::string& name, const IndexedMesh& mesh,
                                  LengthUnit unit = LengthUnit::mm) const {
    EXPECT_TRUE(write_file(path(name), binary_stl_bytes(mesh, unit)).has_value());
    return path(name);
  }

  [[nodiscard]] RunResult run() const {
    std::ostringstream out, err;
    const int status = run_clash(arguments_, out, err);
    return {status, out.str(), err.str()};
  }

  [[nodiscard]] nlohmann::json json() {
    arguments_.json_file = path("clash.json");
    EXPECT_EQ(run().err, "");
    return nlohmann::json::parse(*read_file(path("clash.json")));
  }

  ClashArguments arguments_;

 private:
  testing_support::TemporaryFolder folder_;
};

TEST_F(ClashCommand, OfBodiesThatPenetrateSaysHowDeepWhereAndWhichShiftFreesThem) {
  const RunResult outcome = run();
  EXPECT_EQ(outcome.status, kExitGouges);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.rfind(arguments_.a + ": clash: 2.000 mm with " + arguments_.b + " at (", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("\ndepth: 2.000 mm, proved to be at most 2.00"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(" moves away along (0, -1, 0)\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nshift: " + arguments_.b + " by (0, -2.001, 0), 2.001 mm, is proved free"),
            std::string::npos)
      << outcome.out;
}

TEST_F(ClashCommand, TheShiftItNamesIsOneThatFreesThem) {
  const nlohmann::json by = json().at("shift").at("by");
  arguments_.place_b = by[0].dump() + "," + by[1].dump() + "," + by[2].dump();
  EXPECT_EQ(run().status, kExitClean) << arguments_.place_b;
}

TEST_F(ClashCommand, TouchingAndFreeAreStatusZero) {
  arguments_.place_b = "0,-2,0";
  RunResult outcome = run();
  EXPECT_EQ(outcome.status, kExitClean);
  EXPECT_NE(outcome.out.find(": touching: "), std::string::npos) << outcome.out;
  arguments_.place_b = "0,-5,0";
  outcome = run();
  EXPECT_EQ(outcome.status, kExitClean);
  EXPECT_NE(outcome.out.find(": free: 3.000 mm from "), std::string::npos) << outcome.out;
}

TEST_F(ClashCommand, TheToleranceIsWhatStillCountsAsTouching) {
  arguments_.tolerance = "2.01";
  EXPECT_EQ(run().status, kExitClean);
  arguments_.tolerance = "0.05in";
  EXPECT_EQ(run().status, kExitGouges);
}

TEST_F(ClashCommand, BIsTurnedBeforeItIsShifted) {
  arguments_.place_b = "0,0,0,0,0,180";  // now beyond the origin, x -120 to 20 and y -2 to 30
  EXPECT_EQ(json().at("deepest").size(), 2U);
  arguments_.place_b = "-200,0,0,0,0,180";
  EXPECT_EQ(run().status, kExitClean);
}

TEST_F(ClashCommand, JsonHasEveryNumberInTheUnitOfTheFiles) {
  arguments_.a = write("part.stl", shapes::box(Vec3(0, 0, 0), Vec3(101.6, 50.8, 25.4)), LengthUnit::inch);
  arguments_.b = write("jaw.stl", shapes::box(Vec3(-25.4, -25.4, -25.4), Vec3(127, 2.54, 20)), LengthUnit::inch);
  arguments_.stl_units = "inch";
  const nlohmann::json result = json();
  EXPECT_EQ(result.at("unit"), "in");
  EXPECT_EQ(result.at("state"), "penetrating");
  EXPECT_TRUE(result.at("inside").is_null());
  EXPECT_NEAR(result.at("depth"), 0.1, 1e-7);
  EXPECT_GE(result.at("depth_upper"), result.at("depth"));
  EXPECT_NEAR(result.at("depth_upper"), 0.1, 0.00004);
  EXPECT_NEAR(result.at("deepest").at(0).at("normal").at(1), -1, 1e-12);
  EXPECT_NEAR(result.at("shift").at("by").at(1), -0.1, 0.0005);
  EXPECT_EQ(result.at("shift").at("state"), "free");
}

TEST_F(ClashCommand, ABodyInsideTheOtherPenetrates) {
  arguments_.b = write("pin.stl", shapes::box(Vec3(10, 10, 10), Vec3(20, 20, 20)));
  const RunResult outcome = run();
  EXPECT_EQ(outcome.status, kExitGouges);
  EXPECT_EQ(outcome.out.rfind(arguments_.b + ": clash: wholly inside " + arguments_.a + "\n", 0), 0U) << outcome.out;
  EXPECT_EQ(json().at("inside"), "b");
}

TEST_F(ClashCommand, AnOpenMeshWithinReachIsNotCertified) {
  arguments_.a = write("part.stl", shapes::open_cube(10));
  arguments_.b = write("jaw.stl", shapes::moved(shapes::cube(1), Vec3(5, 5, 5)));
  const RunResult outcome = run();
  EXPECT_EQ(outcome.status, kExitNotChecked);
  EXPECT_NE(outcome.out.find(": not certified: "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("[mesh-open]"), std::string::npos) << outcome.err;
  arguments_.is_quiet = true;
  EXPECT_EQ(run().out + run().err, "");
}

// The nearest facet of a point in both boxes states outside; the winding number does not.
TEST_F(ClashCommand, ABodyOfBoxesThatOverlapHidesNothingInTheirOverlap) {
  arguments_.a = write("part.stl", shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(10, 10, 10)),
                                                  shapes::box(Vec3(9, -5, -5), Vec3(30, 15, 15))));
  arguments_.b = write("pin.stl", shapes::box(Vec3(9.3, 4, 4), Vec3(9.7, 6, 6)));
  EXPECT_EQ(run().status, kExitGouges);
  arguments_.b = write("pin.stl", shapes::box(Vec3(8.5, 4, 4), Vec3(9.4, 6, 6)));
  EXPECT_EQ(run().status, kExitGouges);
}

TEST_F(ClashCommand, AWrongCommandLineIsStatusTwoAndWritesNothing) {
  const auto message = [this] {
    const RunResult outcome = run();
    EXPECT_EQ(outcome.status, kExitUsage) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  arguments_.place_b = "1,2";
  EXPECT_NE(message().find("--place-b '1,2': expected x,y,z or x,y,z,rx,ry,rz: lengths in mm, or with a unit"),
            std::string::npos);
  arguments_.place_b.clear();
  arguments_.tolerance = "-1";
  EXPECT_NE(message().find("--tolerance '-1'"), std::string::npos);
  arguments_.tolerance = "0";
  arguments_.resolution = "0";
  EXPECT_NE(message().find("--resolution '0'"), std::string::npos);
  arguments_.resolution = "0.001";
  arguments_.is_quiet = arguments_.is_verbose = true;
  EXPECT_NE(message().find("-q and -v"), std::string::npos);
  arguments_.is_quiet = arguments_.is_verbose = false;
  const std::string before = *read_file(arguments_.b);
  arguments_.json_file = arguments_.b;
  EXPECT_NE(message().find("is a mesh itself"), std::string::npos);
  EXPECT_EQ(*read_file(arguments_.b), before);
}

TEST_F(ClashCommand, AFileThatIsNoMeshOrTooFarIsStatusThree) {
  arguments_.place_b = "200000,0,0";
  RunResult outcome = run();
  EXPECT_EQ(outcome.status, kExitUsage) << "no length beyond 100 m";
  arguments_.place_b = "99999,0,0";
  outcome = run();
  EXPECT_EQ(outcome.status, kExitInput);
  EXPECT_NE(outcome.err.find("[mesh-too-far]"), std::string::npos) << outcome.err;
  arguments_.a = path("none.stl");
  EXPECT_EQ(run().status, kExitInput);
}

TEST_F(ClashCommand, JsonToStandardOutputStandsThereAlone) {
  arguments_.json_file = "-";
  const RunResult outcome = run();
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("state"), "penetrating");
}

}  // namespace
}  // namespace gouge::clash_command_test
