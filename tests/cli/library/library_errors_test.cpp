#include <gtest/gtest.h>

#include <gougecheck/check.h>
#include <gougecheck/penetration.h>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>

#include "tests/cli/library/block.h"
#include "tests/support/temporary_folder.h"

// Bad input is an Error with its code, not a result.

namespace gougecheck::library_errors_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string code_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(error.code()), std::string::npos);
    return error.code();
  }
  return "no error";
}

/// A toolpath file in a folder of its own.
struct Written {
  explicit Written(const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
  gouge::testing_support::TemporaryFolder folder;
  std::string file = folder.at("path.apt");
};

TEST(LibraryErrors, OfMeshes) {
  const std::vector<Vec3> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, broken = {{0, 0, 0}, {1, 0, 0}, {0, kNaN, 0}};
  const std::vector<Triangle> one = {{0, 1, 2}}, beyond = {{0, 1, 3}}, line = {{0, 1, 1}};
  EXPECT_EQ(code_of([&] { Mesh(vertices, beyond); }), "mesh-corner");
  EXPECT_EQ(code_of([&] { Mesh(broken, one); }), "mesh-not-finite");
  EXPECT_EQ(code_of([&] { Mesh(vertices, line); }), "stl-no-surface");
  EXPECT_EQ(code_of([&] { Mesh(vertices, {}); }), "stl-no-surface");
  EXPECT_EQ(code_of([&] { (void)Mesh::read_stl("/no/such/file.stl"); }), "file-not-found");
  EXPECT_EQ(code_of([&] { (void)Mesh::read_stl("/no/such/file.stl", "ell"); }), "usage");
  EXPECT_EQ(code_of([] { Scene({}, {}); }), "usage");
}

TEST(LibraryErrors, OfTools) {
  EXPECT_EQ(code_of([] { Tool("bal", {{"diameter", 1}}); }), "library-field");
  EXPECT_EQ(code_of([] { Tool("ball", {{"diameter", 1}}); }), "tool-dimension-name");
  EXPECT_EQ(code_of([] {
              Tool("ball", {{"diameter", 1}, {"length", 3}, {"corner_radius", 1}});
            }),
            "tool-dimension-name");
  EXPECT_EQ(code_of([] { Tool("ball", {{"diameter", -1}, {"length", 3}}); }), "tool-dimension-not-positive");
  EXPECT_EQ(code_of([] { (void)Tool::from_json("{"); }), "library-syntax");
  const std::string two = R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"flat","diameter":1,"length":2}},
                              {"number":2,"cutter":{"shape":"flat","diameter":2,"length":2}}]})";
  EXPECT_EQ(code_of([&] { (void)Tool::from_json(two); }), "library-which");
  EXPECT_EQ(code_of([&] { (void)ToolLibrary::from_json(two).tool("7"); }), "library-which");
  EXPECT_EQ(ToolLibrary::from_json(two).tool("T2").height(), 2);
}

TEST(LibraryErrors, OfPaths) {
  const std::vector<Vec3> tips = {{0, 0, 0}, {1, 0, 0}}, three = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, flat = {{0, 0, 0}},
                          wrong = {{0, 0, kNaN}}, far = {{1e6, 0, 0}};
  EXPECT_EQ(code_of([&] { Path({}, kUp); }), "path-no-motion");
  EXPECT_EQ(code_of([&] { Path(tips, three); }), "path-count");
  EXPECT_EQ(code_of([&] { Path(tips, {}); }), "path-count");
  EXPECT_EQ(code_of([&] { Path(tips, flat); }), "path-axis");
  EXPECT_EQ(code_of([&] { Path(wrong, kUp); }), "path-too-far");
  EXPECT_EQ(code_of([&] { Path(far, kUp); }), "path-too-far");
}

TEST(LibraryErrors, OfChecks) {
  const std::vector<Vec3> tips = {{0, 0, 9}};
  const Path path(tips, kUp);
  const Tool tool("flat", {{"diameter", 1}, {"length", 2}});
  for (const double value : {-1.0, kNaN, 1e9}) {
    CheckOptions options;
    options.tolerance = value;
    EXPECT_EQ(code_of([&] { (void)check(path, block(), tool, options); }), "usage") << value;
  }
  CheckOptions options;
  options.resolution = 0;
  EXPECT_EQ(code_of([&] { (void)check(path, block(), tool, options); }), "usage");
  CorrectOptions how;
  how.strategy = "magic";
  EXPECT_EQ(code_of([&] { (void)correct(path, block(), tool, {}, how); }), "usage");
  const DepthQuery query(block(), tool);
  EXPECT_EQ(code_of([&] { (void)query.at({0, 0, kNaN}, {0, 0, 1}); }), "path-axis");
  EXPECT_EQ(code_of([&] { (void)query.at({0, 0, 0}, {0, 0, 0}); }), "path-axis");
  EXPECT_EQ(code_of([&] { (void)penetration(block(), block(), {{2, 0, 0, 0, 2, 0, 0, 0, 2}, {0, 0, 0}}); }), "usage");
}

TEST(LibraryErrors, OfMachinesAndLaws) {
  const std::vector<Vec3> tips = {{0, 0, 9}};
  const Path path(tips, kUp);
  const Tool tool("flat", {{"diameter", 1}, {"length", 2}});
  const struct {
    std::string machine, feed, rapid, code;
  } kCases[] = {{"preset:none", "", "", "usage"},
                {"nowhere.json", "", "", "file-not-found"},
                {"", "axis", "", "usage"},
                {"", "", "sideways", "usage"},
                {"preset:linuxcnc-xyzac-trt", "sideways", "", "usage"},
                {"preset:haas-umc750", "axis", "", "machine-law"}};
  for (const auto& one : kCases) {
    CheckOptions options;
    options.machine = one.machine;
    options.feed_law = one.feed;
    options.rapid_law = one.rapid;
    EXPECT_EQ(code_of([&] { (void)check(path, block(), tool, options); }), one.code) << one.machine << one.feed;
  }
}

TEST(LibraryErrors, OneToolIsNotForAPathOfSeveral) {
  const Written written("UNITS/MM\nLOADTL/1\nGOTO/0,0,9\nLOADTL/2\nGOTO/5,0,9\nFINI\n");
  const Path path = Path::read(written.file);
  const Tool tool("flat", {{"diameter", 1}, {"length", 2}});
  EXPECT_EQ(code_of([&] { (void)check(path, block(), tool); }), "tool-ambiguous");
  const ToolLibrary one = ToolLibrary::from_json(
      R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"flat","diameter":1,"length":2}}]})");
  const Report report = check(path, block(), one);
  EXPECT_EQ(report.state()[0], State::clean);
  EXPECT_EQ(report.state()[1], State::not_checked);
  EXPECT_EQ(report.verdict(), Verdict::not_fully_checked);
  const ToolLibrary other = ToolLibrary::from_json(
      R"({"units":"mm","tools":[{"number":9,"cutter":{"shape":"flat","diameter":1,"length":2}}]})");
  EXPECT_EQ(code_of([&] { (void)check(path, block(), other); }), "no-tool");
}

TEST(LibraryErrors, AReportDoesNotOverwriteItsInputs) {
  const Written written("UNITS/MM\nLOADTL/1\nGOTO/0,0,9\nFINI\n");
  const Report report = check(Path::read(written.file), block(), Tool("flat", {{"diameter", 1}, {"length", 2}}));
  EXPECT_EQ(code_of([&] { report.write(written.file); }), "usage");
  EXPECT_EQ(code_of([&] { report.write("report.pdf"); }), "usage");
  EXPECT_EQ(code_of([&] { report.write("/no/such/folder/report.txt"); }), "file-unwritable");
}

}  // namespace
}  // namespace gougecheck::library_errors_test
