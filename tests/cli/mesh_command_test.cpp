#include "cli/commands/mesh_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/mesh/write_stl.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace gouge::mesh_command_test {
namespace {

namespace fs = std::filesystem;

struct Reported {
  int status = 0;
  std::string out;
  std::string err;
};

class MeshCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.at(name); }

  std::string write(const IndexedMesh& mesh, LengthUnit unit = LengthUnit::mm) {
    EXPECT_TRUE(write_file(path("part.stl"), binary_stl_bytes(mesh, unit)).has_value());
    return path("part.stl");
  }

  static Reported run(const MeshArguments& arguments) {
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_mesh(arguments, out, err);
    return {status, out.str(), err.str()};
  }

 private:
  testing_support::TemporaryFolder folder_;
};

TEST_F(MeshCommand, ASoundPartIsReportedInFull) {
  MeshArguments arguments;
  arguments.file = write(shapes::torus(20, 5));
  const Reported reported = run(arguments);
  EXPECT_EQ(reported.status, kExitClean);
  EXPECT_EQ(reported.err, "");
  EXPECT_NE(reported.out.find("  triangles                 576 (864 edges, 288 vertices)\n"), std::string::npos)
      << reported.out;
  EXPECT_NE(reported.out.find("  pieces                    1, 1 through hole\n"), std::string::npos) << reported.out;
  EXPECT_NE(reported.out.find("verdict: sound: closed, manifold, facing outward, free of self-intersections\n"
                              "for a check: depths are found, and a tool wholly inside the part is reported\n"),
            std::string::npos)
      << reported.out;
}

TEST_F(MeshCommand, AnOpenPartHasDefectsWithTheirPlaceInItsOwnUnit) {
  MeshArguments arguments;
  arguments.file = write(shapes::open_cube(25.4), LengthUnit::inch);
  arguments.stl_units = "inch";
  const Reported reported = run(arguments);
  EXPECT_EQ(reported.status, kExitGouges);
  EXPECT_NE(reported.out.find("  open edges                4, first at ("), std::string::npos) << reported.out;
  EXPECT_NE(reported.out.find("1.0000 x 1.0000 x 1.0000 in"), std::string::npos) << reported.out;
  EXPECT_NE(reported.out.find("verdict: 4 defects\nfor a check: depths are found on every triangle; a tool that may be "
                              "wholly inside the part is never clean, but may be reported as not certified only\n"),
            std::string::npos)
      << reported.out;
}

TEST_F(MeshCommand, RepairFillsHolesOnlyWhenAskedAndWritesOnlyWhatIsBetter) {
  MeshArguments arguments;
  arguments.file = write(shapes::open_cube());
  arguments.repair_file = path("out.stl");
  const Reported kept = run(arguments);
  EXPECT_EQ(kept.status, kExitGouges);
  EXPECT_FALSE(fs::exists(path("out.stl")));
  EXPECT_NE(kept.out.find("not written: the repair leaves no fewer defects than there were\n"), std::string::npos);

  arguments.fills_holes = true;
  const Reported filled = run(arguments);
  EXPECT_EQ(filled.status, kExitClean);
  EXPECT_NE(filled.out.find("  holes filled              1 (2 triangles added), 0 left\n"), std::string::npos);
  arguments = {};
  arguments.file = path("out.stl");
  EXPECT_EQ(run(arguments).status, kExitClean);
}

TEST_F(MeshCommand, NearVerticesAreJoinedWhenAskedAndReportedSo) {
  IndexedMesh cube = shapes::cube(10);
  cube.vertices.push_back(cube.vertices[cube.triangles[0][0]] + Vec3(0, 0, 0.003));
  cube.triangles[0][0] = static_cast<Corner>(cube.vertices.size() - 1);
  MeshArguments arguments;
  arguments.file = write(cube);
  arguments.weld = "0.01";
  arguments.json_file = path("out.json");
  const Reported reported = run(arguments);
  EXPECT_EQ(reported.status, kExitGouges) << "the file is as it was";
  EXPECT_NE(reported.out.find("weld: vertices no more than 0.01 mm apart become one\n"
                              "  vertices joined           1, moved by up to 0.003"),
            std::string::npos)
      << reported.out;
  EXPECT_NE(reported.out.find("welded: sound: closed, manifold, facing outward, free of self-intersections\n"
                              "not written: give --repair OUT.stl to write the welded mesh\n"),
            std::string::npos)
      << reported.out;
  const nlohmann::json json = nlohmann::json::parse(*read_file(path("out.json")));
  EXPECT_EQ(json["weld"]["vertices_joined"], 1);
  EXPECT_NEAR(json["weld"]["largest_displacement"].get<double>(), 0.003, 1e-6);
  EXPECT_EQ(json["weld"]["result"]["sound"], true);
  EXPECT_EQ(json["mesh"]["sound"], false);

  arguments.repair_file = path("out.stl");
  EXPECT_EQ(run(arguments).status, kExitClean);
  arguments = {};
  arguments.file = path("out.stl");
  EXPECT_EQ(run(arguments).status, kExitClean);
}

TEST_F(MeshCommand, AWeldThatMakesNoSenseIsRefused) {
  MeshArguments arguments;
  arguments.file = write(shapes::cube(10));
  for (const char* weld : {"0", "-1", "near", "nan"}) {
    arguments.weld = weld;
    EXPECT_EQ(run(arguments).status, kExitUsage) << weld;
  }
  arguments.weld = "50";
  const Reported reported = run(arguments);
  EXPECT_EQ(reported.status, kExitUsage);
  EXPECT_NE(reported.err.find("every triangle collapses when vertices within 50 mm are joined"), std::string::npos);
}

TEST_F(MeshCommand, AnyUnitOfAnStlFile) {
  MeshArguments arguments;
  for (const auto& [unit, size] : {std::pair{LengthUnit::um, "10000 x 10000 x 10000 um"},
                                   {LengthUnit::cm, "1.0000 x 1.0000 x 1.0000 cm"},
                                   {LengthUnit::m, "0.010000 x 0.010000 x 0.010000 m"}}) {
    arguments.file = write(shapes::cube(10), unit);
    arguments.stl_units = std::string(facts_of(unit).option);
    const Reported reported = run(arguments);
    EXPECT_EQ(reported.status, kExitClean) << reported.err;
    EXPECT_NE(reported.out.find(size), std::string::npos) << reported.out;
  }
}

TEST_F(MeshCommand, JsonOnStandardOutputIsAlone) {
  MeshArguments arguments;
  arguments.file = write(shapes::cubes_crossing(10));
  arguments.json_file = "-";
  const Reported reported = run(arguments);
  EXPECT_EQ(reported.status, kExitGouges);
  const nlohmann::json json = nlohmann::json::parse(reported.out);
  EXPECT_EQ(json["mesh"]["sound"], false);
  EXPECT_EQ(json["mesh"]["triangles"], 24);
  EXPECT_GT(json["mesh"]["defects"]["self_intersections"]["pairs"], 0);
  EXPECT_TRUE(json["mesh"]["volume"].is_null());
}

TEST_F(MeshCommand, WhatCannotBeReadOrWrittenIsOneClearError) {
  MeshArguments arguments;
  arguments.file = path("missing.stl");
  const Reported missing = run(arguments);
  EXPECT_EQ(missing.status, kExitInput);
  EXPECT_EQ(missing.err, path("missing.stl") + ": error: no such file [file-not-found]\n");
  EXPECT_EQ(missing.out, "");

  arguments.file = write(shapes::inside_out(shapes::cube()));
  arguments.repair_file = "/no/such/folder/out.stl";
  const Reported unwritable = run(arguments);
  EXPECT_EQ(unwritable.status, kExitInternal);
  EXPECT_NE(unwritable.err.find("[file-unwritable]"), std::string::npos);
}

}  // namespace
}  // namespace gouge::mesh_command_test
