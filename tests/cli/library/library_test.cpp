#include <gtest/gtest.h>

#include <gougecheck/check.h>
#include <gougecheck/penetration.h>
#include <gougecheck/version.h>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "tests/cli/library/block.h"
#include "tests/support/temporary_folder.h"

// The interface for other programs, against results known by hand.

namespace gougecheck::library_test {
namespace {

Tool ball() { return {"ball", {{"diameter", 10}, {"length", 30}}, {{10, 10, 20}}, {{32, 32, 40}}}; }

Path crossing() {
  const std::vector<Vec3> tips = {{-10, 10, 0.5}, {50, 10, 0.5}, {50, 12, 5}, {50, 12, -0.25}, {-10, 12, -0.25}};
  return {tips, kUp};
}

std::string text_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(Version, IsThatOfTheProject) {
  EXPECT_STREQ(version(), GOUGE_PROJECT_VERSION);
  EXPECT_EQ(std::string(GOUGECHECK_VERSION_STRING), std::to_string(GOUGECHECK_VERSION_MAJOR) + "." +
                                                        std::to_string(GOUGECHECK_VERSION_MINOR) + "." +
                                                        std::to_string(GOUGECHECK_VERSION_PATCH));
}

TEST(LibraryMesh, JoinsVerticesAndNamesFacesAsGiven) {
  const std::vector<Vec3> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  const std::vector<Triangle> faces = {{0, 0, 1}, {0, 1, 2}, {3, 4, 2}};
  const Mesh mesh(vertices, faces);
  EXPECT_EQ(mesh.vertices().size(), 4U);
  ASSERT_EQ(mesh.faces().size(), 2U);
  EXPECT_EQ(mesh.given_face()[1], 2U);
  EXPECT_FALSE(mesh.is_solid());
  EXPECT_FALSE(mesh.notes().empty());
  EXPECT_TRUE(block().is_solid());
}

TEST(LibraryCheck, FindsTheGougeItsDepthAndItsWitness) {
  const Report report = check(crossing(), block(), ball());
  ASSERT_EQ(report.size(), 5U);
  EXPECT_EQ(report.verdict(), Verdict::gouges);
  EXPECT_EQ(report.count(State::clean), 4U);
  EXPECT_EQ(report.state()[4], State::gouge);
  EXPECT_NEAR(report.depth()[4], 0.25, 1e-3);
  EXPECT_LE(report.depth()[4], 0.25 + 1e-9);
  EXPECT_GE(report.depth_upper()[4], 0.25 - 1e-9);
  EXPECT_NEAR(report.point()[4][2], 0, 1e-9);
  EXPECT_NEAR(report.normal()[4][2], 1, 0.1);
  EXPECT_TRUE(report.triangle()[4] == 2 || report.triangle()[4] == 3) << "the top";
  EXPECT_EQ(report.mesh()[4], 0);
  EXPECT_EQ(report.is_fixture()[4], 0);
  EXPECT_EQ(report.triangle()[1], -1);
  EXPECT_TRUE(std::isnan(report.t()[1]));
  EXPECT_NE(report.text().find("gouge: 0.250 mm cutter"), std::string::npos) << report.text();
}

TEST(LibraryCheck, TellsBuriedFromClean) {
  const std::vector<Vec3> tips = {{20, 10, -8}};
  const Tool small("ball", {{"diameter", 1}, {"length", 2}});
  const Report report = check(Path(tips, kUp), block(), small);
  EXPECT_EQ(report.state()[0], State::buried);
  EXPECT_TRUE(std::isnan(report.depth()[0]));
  EXPECT_EQ(report.verdict(), Verdict::gouges);
  EXPECT_FALSE(report.reason(0).empty());
}

TEST(LibraryCheck, KnowsFixturesAndClearances) {
  const Scene scene({block(-50)}, {block()});
  CheckOptions options;
  const Report report = check(crossing(), scene, ball(), options);
  EXPECT_EQ(report.is_fixture()[4], 1);
  options.tolerance = 0.3;
  EXPECT_TRUE(check(crossing(), scene, ball(), options).is_clean());
}

TEST(LibraryCheck, IsTheSameAtAnyNumberOfThreads) {
  CheckOptions one, four;
  one.threads = 1;
  four.threads = 4;
  const Report a = check(crossing(), block(), ball(), one), b = check(crossing(), block(), ball(), four);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.state()[i], b.state()[i]);
    EXPECT_EQ(a.depth()[i], b.depth()[i]);
    EXPECT_EQ(a.depth_upper()[i], b.depth_upper()[i]);
  }
}

TEST(LibraryReport, IsWrittenInTheFormOfItsExtension) {
  const Report report = check(crossing(), block(), ball());
  const gouge::testing_support::TemporaryFolder folder;
  for (const char* extension : {".json", ".csv", ".sarif", ".xml", ".html", ".txt"}) {
    const std::string file = folder.at(std::string("report") + extension);
    report.write(file);
    EXPECT_FALSE(text_of(file).empty()) << extension;
  }
}

TEST(LibraryPath, OfMemoryReadsBackFromItsText) {
  const std::vector<Vec3> tips = {{0.1, 1.0 / 3, -7e-5}, {1e3, 2, 3}}, axes = {{0, 0, 2}, {1, 1, 1}};
  const bool rapids[] = {false, true};
  const Path path(tips, axes, rapids);
  const gouge::testing_support::TemporaryFolder folder;
  const std::string file = folder.at("path.apt");
  std::ofstream(file, std::ios::binary) << path.text();
  const Path read = Path::read(file);
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.tips()[i], path.tips()[i]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(read.axes()[i][k], path.axes()[i][k], 1e-15);
    EXPECT_EQ(read.kinds()[i], path.kinds()[i]);
  }
}

TEST(LibraryTool, IsTheSameFromItsJson) {
  EXPECT_EQ(Tool::from_json(ball().to_json()).to_json(), ball().to_json());
  EXPECT_EQ(ball().height(), 90);
  EXPECT_TRUE(ball().has_holder());
  const Tool alone = Tool::from_json(R"({"units":"inch","cutter":{"shape":"flat","diameter":1,"length":2}})");
  EXPECT_DOUBLE_EQ(alone.height(), 50.8);
  EXPECT_GE(tool_shapes().size(), 17U);
}

/// A post beside a tool that leans by 10 degrees and turns about its resting tip. On the great circle it leans less
/// half-way, and its holder passes the post.
struct PostBesideTurn {
  Mesh post = [] {
    std::vector<Vec3> corners;
    for (const double z : {50.0, 70.0})
      corners.insert(corners.end(), {{-5, 27, z}, {5, 27, z}, {5, 47, z}, {-5, 47, z}});
    const Mesh box = block();
    return Mesh(corners, box.faces(), "post");
  }();
  std::vector<Vec3> tips = {{0, 0, 0}, {0, 0, 0}};
  std::vector<Vec3> axes = {leaning(50), leaning(130)};

  static Vec3 leaning(double azimuth_deg) {
    constexpr double kDegree = 0.017453292519943295;
    const double out = std::sin(10 * kDegree);
    return {out * std::cos(azimuth_deg * kDegree), out * std::sin(azimuth_deg * kDegree), std::cos(10 * kDegree)};
  }
};

TEST(LibraryCheck, FollowsTheMachineAndItsLaws) {
  const PostBesideTurn scene;
  const Path path(scene.tips, scene.axes);
  EXPECT_TRUE(check(path, scene.post, ball()).is_clean()) << "on the great circle";
  CheckOptions options;
  options.machine = "preset:linuxcnc-xyzac-trt";
  const Report turned = check(path, scene.post, ball(), options);
  EXPECT_EQ(turned.state()[1], State::gouge) << turned.text();
  EXPECT_NEAR(turned.t()[1], 0.5, 0.1);
  options.feed_law = "vector";
  EXPECT_TRUE(check(path, scene.post, ball(), options).is_clean());
}

TEST(LibraryCheck, ReadsAProgramAsItsMachineRunsIt) {
  const gouge::testing_support::TemporaryFolder folder;
  const std::string file = folder.at("turn.ngc");
  // Around the corner of the block without tool centre point control, and straight through it with.
  std::ofstream(file) << "G21 G90 G17 G94 G61\n#<way>=1\nG0 X60 Y0 Z-8 A0 C0\nG1 C90 F500\nM2\n";
  ProgramOptions options;
  options.machine = "preset:linuxcnc-xyzac-trt";
  options.joint_points = {"A=0,0,-50", "C=0,0,0"};
  const Path path = Path::read_program(file, options);
  ASSERT_EQ(path.size(), 2u);
  EXPECT_NEAR(std::abs(path.tips()[1][1]), 60, 1e-9);
  CheckOptions check_options;
  EXPECT_THROW((void)check(path, block(), ball(), check_options), Error) << "read with a machine, checked without";
  check_options.machine = options.machine;
  EXPECT_THROW((void)check(path, block(), ball(), check_options), Error) << "other points";
  check_options.joint_points = options.joint_points;
  const Report free = check(path, block(), ball(), check_options);
  EXPECT_EQ(free.state()[1], State::clean) << free.text();
  std::ofstream(file) << "G21 G90 G17 G94 G61\nM428\nG0 X60 Y0 Z-8 A0 C0\nG1 X0 Y60 F500\nM2\n";
  const Report straight = check(Path::read_program(file, options), block(), ball(), check_options);
  EXPECT_EQ(straight.state()[1], State::gouge) << straight.text();
  options.control = "none";
  EXPECT_THROW((void)Path::read_program(file, options), Error);
}

TEST(LibraryCheck, LeavesPositionsBeyondJointLimitsUnchecked) {
  // The A joint of this machine ends at -100 and 50 degrees.
  const std::vector<Vec3> tips = {{0, 0, 200}, {0, 0, 200}};
  const std::vector<Vec3> axes = {{0, 0, 1}, {0, -0.2, -0.98}};
  CheckOptions options;
  EXPECT_EQ(check(Path(tips, axes), block(), ball(), options).state()[1], State::clean);
  options.machine = "preset:linuxcnc-xyzac-trt";
  const Report report = check(Path(tips, axes), block(), ball(), options);
  EXPECT_EQ(report.state()[1], State::not_checked);
}

TEST(LibraryCheck, TakesFactsOfJoints) {
  const std::vector<Vec3> tips = {{0, 0, 200}, {0, 0, 200}};
  const std::vector<Vec3> axes = {{0, 0, 1}, {0, -0.2, 0.98}};
  CheckOptions options;
  options.machine = "preset:linuxcnc-xyzac-trt";
  EXPECT_EQ(check(Path(tips, axes), block(), ball(), options).state()[1], State::clean);
  options.joint_limits = {"A=0..5"};
  EXPECT_EQ(check(Path(tips, axes), block(), ball(), options).state()[1], State::not_checked);
  options.joint_limits = {};
  options.feed_law = "joint";
  options.joint_points = {"A=0,0,-50", "C=0,0,0"};
  const Report report = check(Path(tips, axes), block(), ball(), options);
  EXPECT_EQ(report.state()[1], State::clean) << report.text();
  const auto facts = report.assumptions();
  EXPECT_TRUE(std::ranges::any_of(
      facts, [](const Assumption& fact) { return fact.evidence.find("joint_points A=0,0,-50") != std::string::npos; }));
  options.zero = "500,0,0";
  EXPECT_EQ(check(Path(tips, axes), block(), ball(), options).state()[1], State::not_checked) << "X ends at 200";
  options.zero = "";
  options.joint_rates = {"Q=1"};
  EXPECT_THROW((void)check(Path(tips, axes), block(), ball(), options), Error);
}

TEST(LibraryCheck, CoversTheTolerancesOfTheControlAndIntervals) {
  // The tip is 0.2 mm above the block.
  const std::vector<Vec3> tips = {{20, 10, 0.2}, {21, 10, 0.2}};
  const gouge::testing_support::TemporaryFolder folder;
  const std::string file = folder.at("machine.json");
  std::ofstream(file) << R"({"name": "m", "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "continuous": true},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]},
    {"name": "B", "type": "rotary", "side": "head", "direction": [0, 1, 0], "point": [0, 0, 0]}],
    "control": {"name": "any", "feed_law": "vector", "rapid_law": "vector", "tip_tolerance": 0.5}})";
  CheckOptions options;
  options.machine = file;
  const Report smoothed = check(Path(tips, kUp), block(), ball(), options);
  EXPECT_NEAR(smoothed.depth()[1], 0.3, 2e-3) << "by the tolerance of the control";
  options.tip_tolerance = 0.1;
  EXPECT_TRUE(check(Path(tips, kUp), block(), ball(), options).is_clean()) << "an option replaces it";
  options.tool_length = 100;
  options.tool_length_slack = 0.25;
  EXPECT_NEAR(check(Path(tips, kUp), block(), ball(), options).depth()[1], 0.15, 2e-3);
  options.tool_length_slack = -1;
  EXPECT_THROW((void)check(Path(tips, kUp), block(), ball(), options), Error);
}

TEST(LibraryStock, RapidsMeetWhatIsLeftOfTheStock) {
  const std::vector<Vec3> tips = {{-20, 10, 2}, {60, 10, 2}};
  const std::array<bool, 2> rapids = {true, true};
  const Path rapid(tips, kUp, rapids), cut(tips, kUp);
  CheckOptions options;
  options.stock.emplace();
  options.stock->shape = "part+6";
  const Report met = check(rapid, block(), ball(), options);
  EXPECT_FALSE(met.is_clean());
  EXPECT_NE(met.text().find("rapid into stock"), std::string::npos) << met.text();
  options.stock->before.push_back({cut, ball()});
  const Report after = check(rapid, block(), ball(), options);
  EXPECT_TRUE(after.is_clean()) << after.text();
  options.stock->before.back().place = "0,3,0";
  EXPECT_FALSE(check(rapid, block(), ball(), options).is_clean());
  EXPECT_THROW(static_cast<void>(correct(rapid, block(), ball(), options)), Error);
  options.stock->tolerance = 0;
  EXPECT_THROW(static_cast<void>(check(rapid, block(), ball(), options)), Error);
}

TEST(LibraryCorrection, IsCleanByTheLawOfTheMachine) {
  const PostBesideTurn scene;
  CheckOptions options;
  options.machine = "preset:linuxcnc-xyzac-trt";
  const Correction corrected = correct(Path(scene.tips, scene.axes), scene.post, ball(), options);
  EXPECT_EQ(corrected.before.count(State::gouge), 1U);
  EXPECT_TRUE(corrected.after.is_clean()) << corrected.after.text();
  EXPECT_TRUE(check(corrected.path, scene.post, ball(), options).is_clean());
}

TEST(LibraryDepth, IsThatOfEachPositionAlone) {
  const DepthQuery query(block(), ball());
  EXPECT_EQ(query.at({20, 10, 1}, {0, 0, 1}).depth, 0);
  EXPECT_EQ(query.at({20, 10, 1}, {0, 0, 1}).state, State::clean);
  const std::vector<Vec3> tips = {{20, 10, 1}, {20, 10, -0.5}, {20, 10, -2}};
  const std::vector<Contact> contacts = query.at(tips, kUp, 2);
  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_EQ(contacts[0].depth, 0);
  EXPECT_NEAR(contacts[1].depth, 0.5, 1e-3);
  EXPECT_NEAR(contacts[2].depth, 2, 1e-3);
  EXPECT_LE(contacts[2].depth_upper - contacts[2].depth, 0.001 + 1e-12);
  EXPECT_EQ(contacts[2].body, Body::cutter);
}

TEST(LibraryCorrection, LiftsWhatGougesAndChecksItAgain) {
  const Correction correction = correct(crossing(), block(), ball());
  EXPECT_FALSE(correction.before.is_clean());
  EXPECT_TRUE(correction.after.is_clean()) << correction.after.text();
  EXPECT_FALSE(correction.changes.empty());
  EXPECT_TRUE(correction.uncorrected.empty());
  EXPECT_EQ(correction.path.tips()[1], crossing().tips()[1]) << "a clean move stays";
}

TEST(LibraryPenetration, OfTwoCubesTurned) {
  const double c = std::sqrt(0.5);
  Transform pose{{c, -c, 0, c, c, 0, 0, 0, 1}, {60, 10, 0}};
  EXPECT_EQ(penetration(block(), block(), pose).state, ClashState::free);
  PenetrationOptions options;
  options.find_shift = true;
  const Penetration same = penetration(block(), block(0), {}, options);
  EXPECT_EQ(same.state, ClashState::penetrating);
  EXPECT_LE(same.depth, 5);
  EXPECT_GE(same.depth_upper, 5 - 1e-9);
  ASSERT_TRUE(same.shift.has_value());
  pose = {};
  pose.shift = *same.shift;
  const ClashState after = penetration(block(), block(), pose).state;
  EXPECT_TRUE(after == ClashState::free || after == ClashState::touching);
}

}  // namespace
}  // namespace gougecheck::library_test
