#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/temporary_folder.h"

// gougecheck.json as a user meets it: found, named, outvoted by the command line, refused.

namespace gouge::testing_samples::project_test {
namespace {

namespace fs = std::filesystem;

const char* const kProject = R"({
  "part": "part.stl",
  "tools": "tools.json",
  "tolerance": 0.02,
  "clearance": {"holder": 0.5}
}
)";

/// A sample in a repository, with a project file.
SampleFolder open_project(const std::string& text = kProject) {
  SampleFolder sample = open_sample("between_rib");
  fs::create_directory(sample.path + "/.git");
  write_text(sample.path + "/gougecheck.json", text);
  return sample;
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

TEST(Project, SaysWhatTheCommandLineDoesNotAndIsNamed) {
  const SampleFolder sample = open_project();
  const Outcome ran = run_gougecheck(sample.path, {"check", sample.toolpath(), "--json", "r.json"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_TRUE(has(ran.out, "\nnote: part, tools, tolerance 0.02 and clearance holder=0.5 come from gougecheck.json\n"))
      << ran.out;
  const nlohmann::json report = nlohmann::json::parse(text_of(sample.path + "/r.json"));
  EXPECT_EQ(report["inputs"].back()["role"], "project");
  EXPECT_EQ(report["inputs"].back()["name"], "gougecheck.json");
  EXPECT_EQ(report["options"]["tolerance"], 0.02);
  const Outcome quiet = run_gougecheck(sample.path, {"check", sample.toolpath(), "-q"});
  EXPECT_EQ(quiet.out, "");
  EXPECT_TRUE(has(quiet.err, "gougecheck.json: note: part, tools,")) << "named all the same: " << quiet.err;
  const Outcome data = run_gougecheck(sample.path, {"check", sample.toolpath(), "--json", "-"});
  EXPECT_TRUE(nlohmann::json::accept(data.out));
  EXPECT_TRUE(has(data.err, "[project-file]")) << data.err;
}

TEST(Project, IsTheSameRunAsWithItsOptionsTyped) {
  const SampleFolder sample = open_project();
  const Outcome by_file = run_gougecheck(sample.path, {"check", sample.toolpath(), "--csv", "a.csv"});
  const Outcome typed =
      run_gougecheck(sample.path, {"check", sample.toolpath(), "--no-config", "--part", "part.stl", "--tools",
                                   "tools.json", "--tolerance", "0.02", "--clearance", "holder=0.5", "--csv", "b.csv"});
  EXPECT_EQ(by_file.exit_status, typed.exit_status);
  EXPECT_EQ(text_of(sample.path + "/a.csv"), text_of(sample.path + "/b.csv"));
  EXPECT_FALSE(has(typed.out, "gougecheck.json"));
}

TEST(Project, TheCommandLineWins) {
  const SampleFolder sample = open_project();
  const Outcome ran =
      run_gougecheck(sample.path, {"check", sample.toolpath(), "--tolerance", "0.3", "--json", "r.json"});
  EXPECT_EQ(nlohmann::json::parse(text_of(sample.path + "/r.json"))["options"]["tolerance"], 0.3);
  EXPECT_TRUE(has(ran.out, "part, tools and clearance holder=0.5 come from gougecheck.json")) << ran.out;
  const Outcome without = run_gougecheck(sample.path, {"check", sample.toolpath(), "--no-config"});
  EXPECT_EQ(without.exit_status, 2);
  EXPECT_TRUE(has(without.err, "needs --part")) << without.err;
}

TEST(Project, IsSearchedUpToTheRootOfTheRepositoryAndItsFilesLieBesideIt) {
  const SampleFolder sample = open_project();
  fs::create_directories(sample.path + "/ops/finish");
  const std::string folder = sample.path + "/ops/finish";
  fs::copy_file(sample.path + "/" + sample.toolpath(), folder + "/path.apt");
  const Outcome ran = run_gougecheck(folder, {"check", "path.apt"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_TRUE(has(ran.out, "come from ../../gougecheck.json")) << ran.out;
  EXPECT_TRUE(has(ran.out, "path.apt against ../../part.stl")) << ran.out;
  fs::create_directory(sample.path + "/ops/.git");
  EXPECT_EQ(run_gougecheck(folder, {"check", "path.apt"}).exit_status, 2) << "above the root it is none of ours";
  write_text(folder + "/gougecheck.json", R"({"part": "../../part.stl", "tools": "../../tools.json"})");
  EXPECT_EQ(run_gougecheck(folder, {"check", "path.apt"}).exit_status, 1) << "the nearest holds";
}

// The folder of the samples may lie in a repository, so the test takes another one.
TEST(Project, IsSearchedUpToTheHomeFolderWithoutARepository) {
  const SampleFolder sample = open_project();
  const testing_support::TemporaryFolder top;
  const std::string home = top.at("home"), folder = home + "/ops/finish";
  fs::create_directories(folder);
  for (const char* file : {"part.stl", "tools.json", "gougecheck.json"})
    fs::copy_file(sample.path + "/" + file, top.at(file));
  fs::copy_file(sample.path + "/" + sample.toolpath(), folder + "/path.apt");
  const auto run = [&] { return run_script(folder, "HOME='" + home + "' $GOUGECHECK check path.apt"); };
  EXPECT_EQ(run().exit_status, 2) << "above the home folder";
  write_text(home + "/gougecheck.json", R"({"part": "../part.stl", "tools": "../tools.json"})");
  const Outcome ran = run();
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_TRUE(has(ran.out, "come from ../../gougecheck.json")) << ran.out;
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  ASSERT_EQ(::chown((home + "/ops").c_str(), 65534, 65534), 0);
  EXPECT_EQ(run().exit_status, 2) << "the folder of another user is not searched, nor those above it";
}

TEST(Project, OfSomebodyElseIsRefused) {
  const SampleFolder sample = open_project();
  const std::string file = sample.path + "/gougecheck.json";
  ::chmod(file.c_str(), 0666);
  const Outcome open = run_gougecheck(sample.path, {"check", sample.toolpath()});
  EXPECT_EQ(open.exit_status, 3);
  EXPECT_TRUE(has(open.err, "everybody may write this project file")) << open.err;
  EXPECT_TRUE(has(open.err, "[project-foreign]")) << open.err;
  ::chmod(file.c_str(), 0644);
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a file away";
  ASSERT_EQ(::chown(file.c_str(), 65534, 65534), 0);
  const Outcome foreign = run_gougecheck(sample.path, {"check", sample.toolpath()});
  EXPECT_EQ(foreign.exit_status, 3);
  EXPECT_TRUE(has(foreign.err, "belongs to somebody else")) << foreign.err;
  EXPECT_EQ(run_gougecheck(sample.path, {"check", "--help"}).exit_status, 0);
}

TEST(Project, WrongKeysAndValuesAreReportedWithTheirLine) {
  const auto said = [](const std::string& text) {
    const SampleFolder sample = open_project(text);
    const Outcome ran = run_gougecheck(sample.path, {"check", sample.toolpath()});
    EXPECT_EQ(ran.exit_status, 3) << text << ran.err;
    EXPECT_EQ(ran.out, "");
    return ran.err;
  };
  EXPECT_TRUE(has(said("{\"part\": \"part.stl\",\n \"tolerence\": 1}"),
                  "gougecheck.json:2: error: \"tolerence\" is no option of check or correct; expected the long name of "
                  "one without its --; did you mean \"tolerance\"? [project-option]"));
  const std::string refused = "may; say it on the command line [project-option]";
  for (const char* key : {"report", "json", "csv", "sarif", "junit", "force"})
    EXPECT_TRUE(has(said("{\"part\": \"part.stl\",\n\"" + std::string(key) + "\": \"x\"}"), refused)) << key;
  EXPECT_TRUE(has(said(R"({"output": "x.apt"})"), refused));
  EXPECT_TRUE(has(said(R"({"threads": 1})"), "cannot stand in a project file"));
  EXPECT_TRUE(has(said(R"({"quiet": true})"), "cannot stand in a project file"));
  EXPECT_TRUE(has(said(R"({"no-config": true})"), "\"no-config\" cannot stand in a project file"));
  const std::string value = said("{\"part\": \"part.stl\",\n\n\"tolerance\": \"-1\"}");
  EXPECT_TRUE(has(value, "gougecheck.json:3: error: --tolerance '-1': expected ")) << value;
  const std::string choice = said("{\"part\": \"part.stl\",\n\"rapid\": \"slow\"}");
  EXPECT_TRUE(has(choice, "gougecheck.json:2: error: --rapid 'slow': expected straight")) << choice;
  EXPECT_TRUE(has(said("{\"part\": 1,\n\"part\": 2}"), "[project-duplicate-key]"));
  EXPECT_TRUE(has(said("[]"), "[project-syntax]"));
  EXPECT_TRUE(has(said("{"), "[project-syntax]"));
  EXPECT_TRUE(has(said(R"({"part": "part.stl", "clearance": {"holder": true}})"), "expected a length"));
}

TEST(Project, OfCorrectHoldsForItAlone) {
  const SampleFolder sample =
      open_project(R"({"part": "part.stl", "tools": "tools.json", "strategy": "axis", "max-shift": 7})");
  const Outcome checked = run_gougecheck(sample.path, {"check", sample.toolpath()});
  EXPECT_TRUE(has(checked.out, "part and tools come from gougecheck.json")) << checked.out;
  const Outcome corrected =
      run_gougecheck(sample.path, {"correct", sample.toolpath(), "-o", "out.apt", "--json", "r.json"});
  EXPECT_EQ(corrected.exit_status, 0) << corrected.err;
  EXPECT_EQ(nlohmann::json::parse(text_of(sample.path + "/r.json"))["correction"]["strategy"], "axis");
  EXPECT_TRUE(has(corrected.out, "strategy axis and max-shift 7 come from gougecheck.json")) << corrected.out;
}

TEST(Project, ABatchNeverReadsIt) {
  const SampleFolder sample = open_project(R"({"tolerance": 5, "tools": "no such file.json"})");
  const Outcome ran = run_gougecheck(
      sample.path, {"batch", sample.toolpath(), "--part", "part.stl", "--tools", "tools.json", "-o", "night"});
  EXPECT_EQ(ran.exit_status, 1) << ran.err;
  EXPECT_FALSE(has(ran.out + ran.err, "gougecheck.json"));
}

TEST(Project, ConfigSaysWhatHoldsAndWhereItComesFrom) {
  const SampleFolder sample = open_project();
  const Outcome ran = run_gougecheck(sample.path, {"config", "correct", "--tolerance", "0.05"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  const auto line_of = [&](const std::string& key) {
    const std::size_t at = ran.out.find("\n" + key + " ");
    return at == std::string::npos ? "" : ran.out.substr(at + 1, ran.out.find('\n', at + 1) - at - 1);
  };
  EXPECT_TRUE(ran.out.starts_with("project file: gougecheck.json\n")) << ran.out;
  EXPECT_TRUE(line_of("part").ends_with(" gougecheck.json:2")) << ran.out;
  EXPECT_TRUE(has(line_of("tolerance"), " 0.05 ")) << ran.out;
  EXPECT_TRUE(line_of("tolerance").ends_with("command line")) << ran.out;
  EXPECT_TRUE(line_of("resolution").ends_with("default")) << ran.out;
  EXPECT_TRUE(line_of("max-shift").ends_with("default")) << ran.out;
  EXPECT_TRUE(run_gougecheck(sample.path, {"config", "--no-config"}).out.starts_with("project file: found, not used"));
  EXPECT_EQ(run_gougecheck(sample.path, {"config", "--no-such"}).exit_status, 2);
  EXPECT_EQ(run_gougecheck(sample.path, {"config", "chek"}).exit_status, 2);
}

TEST(Project, InitWritesWhatLiesInTheFolderAndNeverOverAFile) {
  const SampleFolder sample = open_sample("between_rib");
  const Outcome wrote = run_gougecheck(sample.path, {"init", "--tolerance", "0.05"});
  EXPECT_EQ(wrote.exit_status, 0) << wrote.err;
  const std::string text = text_of(sample.path + "/gougecheck.json");
  const nlohmann::json project = nlohmann::json::parse(text);
  EXPECT_EQ(project["part"], "part.stl") << text;
  EXPECT_EQ(project["tools"], "tools.json") << text;
  EXPECT_EQ(project["tolerance"], 0.05) << text;
  EXPECT_EQ(run_gougecheck(sample.path, {"check", sample.toolpath()}).exit_status, 1) << "it is read as written";
  const Outcome again = run_gougecheck(sample.path, {"init"});
  EXPECT_EQ(again.exit_status, 2);
  EXPECT_TRUE(has(again.err, "exists already")) << again.err;
  EXPECT_EQ(text_of(sample.path + "/gougecheck.json"), text);
  const std::string empty = fresh_folder() + "/empty";
  fs::create_directory(empty);
  EXPECT_EQ(run_gougecheck(empty, {"init", "--json", "x.json"}).exit_status, 2) << "an output is no part of a project";
  EXPECT_FALSE(fs::exists(empty + "/gougecheck.json"));
  const Outcome nothing = run_gougecheck(empty, {"init"});
  EXPECT_EQ(nothing.exit_status, 3);
  EXPECT_TRUE(has(nothing.err, "nothing to write: this folder has no part ")) << nothing.err;
  EXPECT_TRUE(has(nothing.err, "gougecheck init --part PART.stl [init-nothing]")) << nothing.err;
  EXPECT_FALSE(fs::exists(empty + "/gougecheck.json")) << "an empty file would stand in the way";
  const Outcome wrote_one = run_gougecheck(empty, {"init", "--tolerance", "0.02"});
  EXPECT_EQ(wrote_one.exit_status, 0);
  EXPECT_TRUE(has(wrote_one.out, "no part: name it")) << "and nothing is guessed";
}

TEST(Project, InitFindsALibraryOfAnotherProgram) {
  const std::string folder = fresh_folder() + "/fusion";
  fs::create_directory(folder);
  write_text(
      folder + "/mills.json",
      R"({"data":[{"type":"flat end mill","unit":"millimeters","description":"EM 10","post-process":{"number":1},)"
      R"("geometry":{"DC":10,"LCF":22,"LB":40,"OAL":72,"SFDM":10}}]})");
  write_text(folder + "/other.json", R"({"tools":[{"key":"flat"}]})");
  const Outcome wrote = run_gougecheck(folder, {"init"});
  EXPECT_EQ(wrote.exit_status, 0) << wrote.err;
  EXPECT_EQ(nlohmann::json::parse(text_of(folder + "/gougecheck.json")), nlohmann::json({{"tools", "mills.json"}}));
}

TEST(Project, InitNamesAsUnusedOnlyFilesThatStandNowhereInTheProject) {
  const std::string folder = fresh_folder() + "/unused";
  fs::create_directory(folder);
  for (const char* file : {"plate.stl", "root.stl", "vise.stl", "spare.stl", "clamp.stl"})
    write_text(folder + "/" + file, "");
  const Outcome wrote = run_gougecheck(
      folder, {"init", "--part", "./plate.stl,tolerance=0.005", "--stock", "root.stl", "--fixture", "vise.stl"});
  EXPECT_EQ(wrote.exit_status, 0) << wrote.err;
  EXPECT_NE(wrote.out.find("\nnot used: spare.stl (a part, a fixture?)\nnot used: clamp.stl (a fixture?)\n"),
            std::string::npos)
      << wrote.out;
  for (const char* used : {"not used: plate.stl", "not used: root.stl", "not used: vise.stl"})
    EXPECT_EQ(wrote.out.find(used), std::string::npos) << wrote.out;
}

TEST(Project, InitKnowsFilesByTheirNamesInSeveralLanguages) {
  const auto project_of = [](const std::vector<std::string>& files) {
    const std::string folder = fresh_folder() + "/names";
    fs::remove_all(folder);
    fs::create_directory(folder);
    for (const std::string& file : files) write_text(folder + "/" + file, "");
    EXPECT_EQ(run_gougecheck(folder, {"init"}).exit_status, 0);
    return nlohmann::json::parse(text_of(folder + "/gougecheck.json"));
  };
  EXPECT_EQ(project_of({"op10.stl", "op10.cls", "other.stl", "Spannbacke.stl"}),
            nlohmann::json({{"part", "op10.stl"}, {"fixture", "Spannbacke.stl"}}));
  EXPECT_EQ(project_of({"Bauteil.stl", "Rohteil.stl"}), nlohmann::json({{"part", "Bauteil.stl"}}));
  EXPECT_EQ(project_of({"mordaza.stl", "pieza.stl", "cabezal.stl"}),
            nlohmann::json({{"part", "pieza.stl"}, {"fixture", "mordaza.stl"}, {"head", "cabezal.stl"}}));
}

}  // namespace
}  // namespace gouge::testing_samples::project_test
