#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/samples/batch_folder.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"
#include "tests/support/source_folder.h"

// A check of a long path, in small: its arrays in files whose pages are released all the time, and in a batch its work
// kept after every 256 moves, the least there is. GOUGE_PAGED_BYTES: docs/develop/testing.md.

namespace gouge::testing_samples::long_check_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kPaged = "GOUGE_PAGED_BYTES=1 ";

/// Checks and corrections of all samples, and checks of real toolpaths where they are at hand.
void write_list(const std::string& folder) {
  write_job_list(folder, sample_names());
  Json list = Json::parse(text_of(folder + "/jobs.json"));
  const std::string data = source_folder() + "/../shared/data/";
  if (fs::exists(data)) {
    for (const char* name : {"basemach", "Sacrifice-Board", "SupPetriLED", "Teste-Metrologia", "Paralelipipedo2"})
      list["jobs"].push_back({{"path", data + "toolpaths/solidworks_cam/" + name + ".apt"},
                              {"part", data + "parts/matched/" + name + ".STL"},
                              {"report", false}});
    for (const char* name : {"autodesk_iso4343", "camplete"})
      list["jobs"].push_back({{"path", data + "toolpaths/five_axis_part/subset_" + name + ".apt"},
                              {"part", data + "parts/matched/five_axis_part_inch.stl"},
                              {"find-cures", true},
                              {"report", false}});
    for (const char* file : {"nx_clsf/ust_a2.cls", "solidworks_cam/boss.apt"})
      list["jobs"].push_back({{"path", data + "toolpaths/" + file},
                              {"part", data + "parts/matched/basemach.STL"},
                              {"tool", "ball"},
                              {"tools", "freeform/tools.json"},
                              {"report", false}});
  } else {
    std::puts("without the real toolpaths beside the checkout");
  }
  write_text(folder + "/jobs.json", list.dump());
}

std::string samples_with_real_pairs() {
  const std::string folder = fresh_folder();
  EXPECT_EQ(run_make_samples(folder).exit_status, 0);
  write_list(folder);
  return folder;
}

TEST(LongCheck, LeavesTheBytesOfOneInMemoryAndInOnePiece) {
  const std::string folder = samples_with_real_pairs();
  const Outcome plain = run_script(folder, "$GOUGECHECK batch jobs.json -o plain -q");
  const auto expected = batch_files(folder + "/plain");
  for (const char* how : {"--jobs 1 --threads 3", "--jobs 4"}) {
    const Outcome ran =
        run_script(folder, std::string(kPaged) + "$GOUGECHECK batch jobs.json -o paged -q --fresh --chunk 1 " + how);
    EXPECT_EQ(ran.exit_status, plain.exit_status) << ran.err;
    EXPECT_EQ(difference(expected, batch_files(folder + "/paged")), "") << how;
    EXPECT_FALSE(fs::exists(folder + "/paged/unfinished"));
  }
}

TEST(LongCheck, WritesAllOfItsFilesAsOneInMemoryDoes) {
  const SampleFolder sample = open_sample("freeform");
  const auto outputs_of = [&](const std::string& environment, const std::string& name) {
    const std::string files = " --csv " + name + ".csv --sarif " + name + ".sarif --near-miss 0.2 --threads 3 ";
    const Outcome ran = run_script(
        sample.path, environment + "$GOUGECHECK check freeform.apt --part part.stl --tools tools.json" + files);
    EXPECT_EQ(ran.exit_status, 1) << ran.err;
    return ran.out + text_of(sample.path + "/" + name + ".csv") + text_of(sample.path + "/" + name + ".sarif");
  };
  EXPECT_TRUE(outputs_of("", "plain") == outputs_of(kPaged, "paged"));
}

// A job whose output cannot be written ends with status 5 and keeps its work, as one does that is killed at its end.
TEST(LongCheck, TakesWhatOneThatFailedHasKept) {
  const std::string folder = fresh_folder();
  ASSERT_EQ(run_make_samples(folder).exit_status, 0);
  write_job_list(folder, {"freeform"});
  Json list = Json::parse(text_of(folder + "/jobs.json"));
  list["jobs"].erase(1);
  list["jobs"][0]["csv"] = "moves.csv";
  write_text(folder + "/jobs.json", list.dump());
  const auto csv_of = [&](const std::string& out, const std::string& more) {
    EXPECT_EQ(run_script(folder,
                         "ln -sf there.csv moves.csv; : > there.csv; $GOUGECHECK batch jobs.json -q --no-reports -o " +
                             out + more)
                  .exit_status,
              1);
    return text_of(folder + "/there.csv");
  };
  const auto fail = [&](const std::string& out) {
    EXPECT_EQ(run_script(folder,
                         "ln -sf /dev/full moves.csv; $GOUGECHECK batch jobs.json -q --no-reports --chunk 1 "
                         "--resume -o " +
                             out)
                  .exit_status,
              5);
    std::vector<std::string> kept;
    for (const auto& entry : fs::directory_iterator(folder + "/" + out + "/unfinished"))
      kept.push_back(entry.path().string());
    EXPECT_EQ(kept.size(), 1U);
    return kept.front();
  };
  // How many stretches are done again after `sql` was done to those that are kept.
  const auto done_again = [&](const std::string& out, const std::string& sql) {
    change_store(fail(out),
                 sql +
                     "; CREATE TABLE again(stretch); CREATE TRIGGER note AFTER INSERT ON stretches BEGIN INSERT INTO "
                     "again VALUES(new.stretch); END");
    return number_in_store(fail(out), "SELECT count(*) FROM again");
  };
  const std::string expected = csv_of("whole", "");
  EXPECT_EQ(done_again("failed", "SELECT 1"), 0);
  EXPECT_TRUE(csv_of("failed", " --chunk 1 --resume") == expected);
  EXPECT_FALSE(fs::exists(folder + "/failed/unfinished"));
  // A stretch that is not what was kept is no verdict.
  const std::pair<const char*, const char*> wrongs[] = {
      {"moved",
       "UPDATE stretches SET bytes = (SELECT bytes FROM stretches WHERE stretch = 1), digest = (SELECT digest "
       "FROM stretches WHERE stretch = 1) WHERE stretch = 2"},
      {"shorter", "UPDATE stretches SET bytes = substr(bytes, 2) WHERE stretch = 2"},
      {"flipped",
       "UPDATE stretches SET bytes = CAST(substr(bytes, 1, 40) || x'5a' || substr(bytes, 42) AS BLOB) WHERE "
       "stretch = 2"},
      {"lost", "DELETE FROM stretches WHERE stretch = 2"}};
  for (const auto& [out, sql] : wrongs) {
    EXPECT_GE(done_again(out, sql), 1) << out;
    EXPECT_TRUE(csv_of(out, " --chunk 1 --resume") == expected) << out;
  }
  static_cast<void>(fail("anew"));
  EXPECT_TRUE(csv_of("anew", " --chunk 1 --fresh") == expected);
}

TEST(LongCheck, GoesOnWithoutWhereNothingCanBeKept) {
  const std::string folder = fresh_folder();
  ASSERT_EQ(run_make_samples(folder).exit_status, 0);
  write_job_list(folder, {"freeform"});
  ASSERT_EQ(run_script(folder, "$GOUGECHECK batch jobs.json -o whole -q --no-reports").exit_status, 1);
  fs::create_directories(folder + "/odd");
  write_text(folder + "/odd/unfinished", "somebody's file");
  ASSERT_EQ(run_script(folder, "$GOUGECHECK batch jobs.json -o odd -q --no-reports --chunk 1").exit_status, 1);
  EXPECT_EQ(difference(batch_files(folder + "/whole"), batch_files(folder + "/odd")), " +unfinished");
  EXPECT_EQ(text_of(folder + "/odd/unfinished"), "somebody's file");
}

}  // namespace
}  // namespace gouge::testing_samples::long_check_test
