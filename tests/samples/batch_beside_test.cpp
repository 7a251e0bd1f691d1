#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/samples/batch_folder.h"
#include "tests/samples/box_stl.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Files that a job looks for beside its program or its tool library. A stored result holds only as long as those that
// were absent are absent.

namespace gouge::testing_samples::batch_beside_test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

constexpr const char* kTools =
    R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"flat","diameter":4,"length":30},)"
    R"("holder":[{"lower_diameter":20,"upper_diameter":20,"length":40}]}]})";
constexpr const char* kToolDatabase =
    "#CLASS END_MILL_NON_INDEXABLE\n"
    "FORMAT LIBRF T ST UGT UGST DESCR TLNUM DIA FN HEI ZOFF DROT FLEN TAPA COR1 HLD HLDREF HOFF\n"
    "DATA | e1 | 02 | 01 | 02 | 01 | mill | 1 | 4 | 2 | 60 | 0 | 3 | 30 | 0 | 0 | 1 | HLD1 | 20\n"
    "#END_DATA\n";
constexpr const char* kHolderDatabase =
    "#CLASS MILLING_DRILLING\n"
    "FORMAT RTYPE LIBRF DESCR MAXDIA MINDIA MAXOFFS\n"
    "DATA | 1 | HLD1 | d | 0 | 0 | 0\n"
    "FORMAT LIBRF RTYPE SEQ DIAM LENGTH TAPER CRAD\n"
    "DATA | HLD1 | 2 | 1 | 40 | 40 | 0 | 0\n"
    "#END_DATA\n";

class BatchBeside : public testing::Test {
 protected:
  void SetUp() override {
    write("part.stl", box_stl({-100, -100, -30}, {100, 100, 0}));
    write("t.json", kTools);
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories(fs::path(folder_ + "/" + file).parent_path());
    write_text(folder_ + "/" + file, text);
  }
  [[nodiscard]] Outcome batch(const Words& job, const Words& more = {}) const {
    Words words = job;
    words.insert(words.end(), {"--part", "part.stl", "--assume", "placement"});
    words.insert(words.end(), more.begin(), more.end());
    if (std::ranges::find(more, "-o") == more.end()) words.insert(words.end(), {"-o", "out"});
    return run_batch(folder_, words);
  }
  /// Runs a batch, adds a file, and expects that the job is run again, with the status that `check` gives.
  void expect_again(const Words& job, const std::string& file, const std::string& text) const {
    SCOPED_TRACE(file);
    const Outcome first = batch(job, {"--fresh"});
    EXPECT_EQ(first.exit_status, 0) << first.out << first.err;
    EXPECT_EQ(runs_of(batch(job)), "1 job taken from the store, 0 run");
    write(file, text);
    Words words = {"check"};
    words.insert(words.end(), job.begin(), job.end());
    words.insert(words.end(), {"--part", "part.stl", "--assume", "placement"});
    const int checked = run_gougecheck(folder_, words).exit_status;
    EXPECT_NE(checked, 0);
    const Outcome again = batch(job);
    EXPECT_EQ(again.exit_status, checked) << again.out << again.err;
    EXPECT_EQ(runs_of(again), "");
    const Outcome resumed = batch(job, {"--resume"});
    EXPECT_EQ(resumed.exit_status, checked);
    EXPECT_EQ(runs_of(resumed), "1 job taken from the store, 0 run") << "the file that was found counts too";
    fs::remove(folder_ + "/" + file);
    EXPECT_EQ(batch(job, {"--resume"}).exit_status, 0) << "the file is gone again";
  }
  /// Returns the line about stored results; empty: all jobs were run.
  static std::string runs_of(const Outcome& ran) {
    const std::size_t at = ran.out.find(" taken from the store");
    if (at == std::string::npos) return {};
    const std::size_t begin = ran.out.rfind('\n', at) + 1;
    return ran.out.substr(begin, ran.out.find('\n', at) - begin);
  }

  std::string folder_ = fresh_folder();
};

const Words kLinuxcnc = {"l.ngc", "--tools", "t.json", "--control", "linuxcnc"};
constexpr const char* kLinuxcncText =
    "G17 G21 G40 G49 G80 G90 G94 G54 G61\nT1 M6\nG43 H1 G0 X0 Y0 Z50\no<foo> call\nG0 Z50\nM2\no<foo> sub\n"
    "G1 X5 Z5 F100\no<foo> endsub\n";
constexpr const char* kLinuxcncBeside = "o<foo> sub\nG1 X5 Z-5 F100\no<foo> endsub\nM2\n";

constexpr const char* kFanucText =
    "O1\nG17 G21 G40 G49 G80 G90 G94 G54\nT1\nM6\nG0 G43 H1 X0. Y0. Z50.\nM98 P2000\nG0 Z50.\nM30\nO2000\n"
    "G1 X5. Z5. F100.\nM99\n";
constexpr const char* kFanucBeside = "O2000\nG1 X5. Z-5. F100.\nM99\n";

TEST_F(BatchBeside, AProgramThatIsPutThereRunsItsCallersAgain) {
  write("l.ngc", kLinuxcncText);
  expect_again(kLinuxcnc, "foo.ngc", kLinuxcncBeside);
  write("m.nc", kFanucText);
  expect_again({"m.nc", "--tools", "t.json", "--control", "fanuc", "--joint-rapid-law", "joint"}, "O02000.TXT",
               kFanucBeside);
  write("s.mpf", "G17 G71 G40 G90 G94 G54 G60\nT1\nM6\nD1\nG0 X0 Y0 Z50\nF100\nCYCLE81(50,5,2,1)\nG0 Z50\nM30\n");
  expect_again({"s.mpf", "--tools", "t.json", "--control", "siemens", "--joint-rapid-law", "joint"}, "CYCLE81.SPF",
               "G1 X5 Z-5 F100\nM17\n");
}

// The control may run the file, so the program of that name within the file is not taken in its place.
TEST_F(BatchBeside, AProgramThatCannotBeReadIsAnError) {
  write("m.nc", kFanucText);
  write("O2000.nc", kFanucBeside + std::string(9000, ' '));
  const Outcome ran = run_gougecheck(folder_, {"check", "m.nc", "--part", "part.stl", "--tools", "t.json", "--control",
                                               "fanuc", "--joint-rapid-law", "joint", "--max-input", "8kB"});
  EXPECT_EQ(ran.exit_status, 3) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("O2000.nc: error: has 9028 bytes; expected at most 8 kB"), std::string::npos) << ran.err;
}

TEST_F(BatchBeside, AHolderDatabaseThatIsPutThereRunsTheJobAgain) {
  write("part.stl", box_stl({-100, 5, -5}, {100, 9, 60}));
  write("a.apt", "PARTNO/A\nUNITS/MM\nLOADTL/1\nFEDRAT/100,MMPM\nGOTO/-30,0,1\nGOTO/30,0,1\nFINI\n");
  write("metric/tool_database.dat", kToolDatabase);
  expect_again({"a.apt", "--tools", "metric/tool_database.dat", "--assume", "tool"}, "metric/holder_database.dat",
               kHolderDatabase);
}

TEST_F(BatchBeside, AStoreWithoutItsSearchesIsNotBelieved) {
  write("l.ngc", kLinuxcncText);
  for (const char* sql :
       {"DELETE FROM searches", "UPDATE searches SET name = 'other'", "UPDATE searches SET role = 'named-by-tools'",
        "INSERT INTO found VALUES(0, 0, 0, 'foo.ngc')"}) {
    ASSERT_EQ(batch(kLinuxcnc).exit_status, 0);
    change_store(folder_ + "/out/results.sqlite", sql);
    EXPECT_EQ(runs_of(batch(kLinuxcnc)), "") << sql;
  }
}

TEST_F(BatchBeside, ChangedToolLengthsRunTheJobAgain) {
  write("l.ngc", kLinuxcncText);
  write("lengths.csv", "tool,length\n1,100\n");
  Words job = kLinuxcnc;
  job.insert(job.end(), {"--tool-lengths", "lengths.csv"});
  EXPECT_EQ(batch(job).exit_status, 0);
  EXPECT_EQ(runs_of(batch(job)), "1 job taken from the store, 0 run");
  write("lengths.csv", "tool,length\n1,120\n");
  EXPECT_EQ(runs_of(batch(job)), "");
}

TEST_F(BatchBeside, SharesThatFoundDifferentFilesAreNotJoined) {
  write("l.ngc", kLinuxcncText);
  write("k.ngc", kLinuxcncText);
  Words job = {"k.ngc"};
  job.insert(job.end(), kLinuxcnc.begin(), kLinuxcnc.end());
  EXPECT_EQ(batch(job, {"--shard", "1/2", "-o", "s1"}).exit_status, 0);
  write("foo.ngc", kLinuxcncBeside);
  EXPECT_NE(batch(job, {"--shard", "2/2", "-o", "s2"}).exit_status, 0);
  const Outcome merged = run_gougecheck(folder_, {"merge", "s1", "s2", "-o", "m"});
  EXPECT_EQ(merged.exit_status, 3) << merged.out << merged.err;
  EXPECT_NE(
      merged.err.find("s2: error: its program-beside foo.ngc is another file than in s1, or only one of them has such"
                      " a file"),
      std::string::npos)
      << merged.err;
  EXPECT_EQ(runs_of(batch(job, {"--shard", "1/2", "-o", "s1"})), "");
  EXPECT_NE(run_gougecheck(folder_, {"merge", "s1", "s2", "-o", "m"}).exit_status, 3);
}

TEST_F(BatchBeside, AResultIsRefutedAfterAFileWasPutThere) {
  write("l.ngc", kLinuxcncText);
  Words words = {"check"};
  words.insert(words.end(), kLinuxcnc.begin(), kLinuxcnc.end());
  words.insert(words.end(), {"--part", "part.stl", "--assume", "placement", "--json", "r.json"});
  ASSERT_EQ(run_gougecheck(folder_, words).exit_status, 0);
  EXPECT_EQ(run_gougecheck(folder_, {"verify", "r.json"}).exit_status, 0);
  write("foo.ngc", kLinuxcncBeside);
  const Outcome verified = run_gougecheck(folder_, {"verify", "r.json"});
  EXPECT_EQ(verified.exit_status, 1) << verified.out << verified.err;
  EXPECT_NE(verified.out.find("the program-beside foo.ngc is read now, but was not there when this was checked"),
            std::string::npos)
      << verified.out;
}

// The file is no toolpath, so the folder alone shows nothing new.
TEST_F(BatchBeside, AWatchRunsCallersAgain) {
  write("hot/m.nc", kFanucText);
  write("beside", kFanucBeside);
  const Outcome ran = run_script(
      folder_,
      "wait_for() { for i in $(seq 300); do grep -q \"$1\" $2 2>/dev/null && return; sleep 0.1; done; echo no $1; }\n"
      "$GOUGECHECK batch --watch hot --part part.stl --tools t.json --control fanuc --joint-rapid-law joint --assume "
      "placement -o out > log & watch=$!\n"
      "wait_for '1 clean' log; cp beside hot/O2000.txt; wait_for '^1 job: 1 [ng]' log\n"
      "rm hot/O2000.txt; for i in $(seq 300); do [ \"$(grep -c '^1 job: 1 clean' log)\" = 2 ] && break; sleep 0.1; done\n"
      "kill -TERM $watch; wait $watch; grep '^1 job' log");
  EXPECT_EQ(ran.out.find("no "), std::string::npos) << ran.out << ran.err;
  EXPECT_EQ(std::ranges::count(ran.out, '\n'), 3) << ran.out;
}

}  // namespace
}  // namespace gouge::testing_samples::batch_beside_test
