#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "tests/samples/sealed_result.h"
#include "tests/samples/small_shop.h"

// gougecheck verify on the folder of a batch, as the batch wrote it and as it was changed by hand.

namespace gouge::testing_samples::verify_batch_test {
namespace {

constexpr const char* kTwoJobs = R"({"defaults": {"part": "part.stl"}, "jobs": [
  {"name": "deep", "path": "deep.apt", "certificate": "deep.gcp"}, {"name": "flat", "path": "flat.apt"}]})";

class VerifyBatch : public ::testing::Test {
 protected:
  VerifyBatch() {
    shop_.write("deep.apt", path_text(stations({{40, -0.2}})));
    shop_.write("flat.apt", path_text(stations()));
  }

  void batch(const std::string& list, const std::vector<std::string>& more = {}) {
    shop_.write("jobs.json", list);
    std::vector<std::string> words = {"batch", "jobs.json", "-o", "night", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    (void)shop_.run(words);
  }
  [[nodiscard]] Outcome verify(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"verify", "night"};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  }
  /// Changes the summary, and states its new SHA-256 in the manifest.
  void change_summary(const std::function<void(nlohmann::json&)>& change) const {
    nlohmann::json summary = shop_.json("night/summary.json");
    change(summary);
    shop_.write("night/summary.json", summary.dump(1) + "\n");
    nlohmann::json manifest = shop_.json("night/manifest.json");
    for (auto& file : manifest.at("files")) {
      if (file.at("name") != "summary.json") continue;
      file["bytes"] = shop_.read("night/summary.json").size();
      file["sha256"] = shop_.run_script("sha256sum night/summary.json").out.substr(0, 64);
    }
    shop_.write("night/manifest.json", manifest.dump(1) + "\n");
  }

  SmallShop shop_;
};

void expect_lines(const Outcome& ran, const std::vector<const char*>& lines) {
  for (const char* line : lines) EXPECT_NE(ran.out.find(line), std::string::npos) << line << "\n" << ran.out << ran.err;
}

TEST_F(VerifyBatch, VerifiesEachJobWithTheCertificateThatItWrote) {
  batch(kTwoJobs);
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  expect_lines(ran, {"job deep: verified: every bound is proved\n",
                     "job flat: not refuted: only sampled: 13 moves said to be clean (no certificate)\n",
                     "night\n2 jobs: 1 not refuted, 1 verified\n",
                     "only sampled: 13 moves said to be clean, of 1 job (1 without a certificate)\n",
                     "result: not refuted; what is only sampled may be wrong all the same\n"});
  EXPECT_EQ(verify({"-q"}).out, "");
  const Outcome one = verify({"--threads", "1"}), eight = verify({"--threads", "8"});
  EXPECT_EQ(one.out, ran.out);
  EXPECT_EQ(eight.out, ran.out);
  expect_lines(verify({"-v"}), {"\n  verified: 11 moves proved clean", "\n  result: verified\n"});
  batch(
      R"({"defaults": {"part": "part.stl"}, "jobs": [{"name": "deep", "path": "deep.apt", "certificate": "deep.gcp"}]})");
  expect_lines(verify(), {"night\n1 job: 1 verified\n", "result: verified\n"});
}

TEST_F(VerifyBatch, EveryCheckOfABatchMayWriteItsCertificate) {
  batch(R"({"defaults": {"part": "part.stl"}, "jobs": [
    {"name": "deep", "path": "deep.apt", "certificate": "own.gcp"}, {"name": "flat", "path": "flat.apt"},
    {"name": "better", "path": "deep.apt", "command": "correct"}]})",
        {"--certificates"});
  EXPECT_EQ(shop_.run_script("ls night/certificates own.gcp").out, "own.gcp\n\nnight/certificates:\nflat.gcp\n");
  expect_lines(verify(),
               {"job deep: verified: every bound is proved\n", "job flat: verified: every bound is proved\n"});
  const Outcome other = shop_.run({"check", "flat.apt", "--part", "part.stl", "--csv", "night/certificates/flat.gcp"});
  EXPECT_EQ(other.exit_status, 2);
  EXPECT_NE(other.err.find("is a file of the report or the batch in "), std::string::npos) << other.err;
}

TEST_F(VerifyBatch, CertificatesAreMadeForAFinishedBatchToo) {
  const std::vector<std::string> words = {"batch", "flat.apt", "--part", "part.stl", "-o", "night", "--resume"};
  ASSERT_EQ(shop_.run(words).exit_status, 0);
  std::vector<std::string> with = words;
  with.emplace_back("--certificates");
  ASSERT_EQ(shop_.run(with).exit_status, 0);
  expect_lines(verify(), {"job flat: verified: every bound is proved\n"});
  expect_lines(shop_.run(with), {"1 job taken from the store, 0 run\n"});
  ASSERT_EQ(shop_.run_script("rm night/certificates/flat.gcp").exit_status, 0);
  EXPECT_EQ(shop_.run(with).out.find("taken from the store"), std::string::npos) << "the job runs again";
}

TEST_F(VerifyBatch, NamesJobsWithoutAResultAndNeverCountsThemAsVerified) {
  batch(R"({"defaults": {"part": "part.stl"}, "jobs": [
    {"name": "flat", "path": "flat.apt"}, {"name": "none", "path": "none.apt"},
    {"name": "silent", "path": "flat.apt", "report": false},
    {"name": "corrected", "path": "deep.apt", "command": "correct"}]})");
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 4) << ran.out << ran.err;
  expect_lines(ran, {"job none: no result: the job failed in the batch (status 3): none.apt: error: no such file",
                     "job silent: no result: the batch wrote no report of it\n",
                     "job corrected: not covered: it is a correction",
                     "job flat: not refuted: ", "4 jobs: 2 without a result, 1 not covered, 1 not refuted\n",
                     "result: not refuted, but not all of it is covered\n"});
  batch(R"({"defaults": {"part": "part.stl"}, "jobs": [
    {"name": "none", "path": "none.apt"}, {"name": "flat", "path": "flat.apt"}]})",
        {"--stop-on", "error", "--jobs", "1", "--fresh"});
  if (shop_.json("night/summary.json").at("jobs")[1].at("status").is_null())
    expect_lines(verify(), {"job flat: no result: the job has not run\n"});
}

TEST_F(VerifyBatch, RefutesAReportThatWasCopiedFromAnotherJob) {
  batch(kTwoJobs);
  (void)shop_.run_script("rm -r night/reports/deep; cp -r night/reports/flat night/reports/deep");
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 1) << ran.out << ran.err;
  expect_lines(ran,
               {"job deep: night/reports/deep/result.json: refuted: is not the result that the batch wrote for job "
                "deep, by its SHA-256 in summary.json; ",
                "2 jobs: 1 refuted, 1 not refuted\n", "result: refuted; "});
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"compare", "night", "night"},
        {"accept", "night"},
        {"accept", "night", "--all", "--reason", "r", "--by", "b", "-o", "a"}}) {
    const Outcome other = shop_.run(words);
    EXPECT_EQ(other.exit_status, 3) << words.front() << other.out;
    EXPECT_NE(
        other.err.find("night/reports/deep/result.json: error: is not the result that the batch wrote for job deep"),
        std::string::npos)
        << other.err;
  }
  EXPECT_FALSE(shop_.run_script("test -e a").exit_status == 0);
}

TEST_F(VerifyBatch, RefutesAChangedResultAndAChangedInput) {
  batch(kTwoJobs);
  nlohmann::json result = shop_.json("night/reports/deep/result.json");
  result["moves"][0]["depth"] = 0.1;
  result["totals"]["worst_depth"] = 0.1;
  shop_.write("night/reports/deep/result.json", sealed(result));
  EXPECT_EQ(verify().exit_status, 1) << "the summary has another SHA-256";
  change_summary([&](nlohmann::json& summary) {
    for (auto& output : summary["jobs"][0]["outputs"])
      if (output["file"] == "reports/deep/result.json")
        output["sha256"] = shop_.run_script("sha256sum night/reports/deep/result.json").out.substr(0, 64);
  });
  expect_lines(verify(), {"\n  deep.apt:13: refuted: its witness: "});
  shop_.write("flat.apt", shop_.read("flat.apt") + "$$\n");
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 1);
  expect_lines(ran, {"job flat: flat.apt: refuted: the toolpath flat.apt is not the file that was checked",
                     "2 jobs: 2 refuted\n"});
}

TEST_F(VerifyBatch, AResultThatCannotBeReadGivesStatusThree) {
  batch(kTwoJobs);
  (void)shop_.run_script("rm -r night/reports/flat");
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 3) << ran.out;
  expect_lines(ran,
               {"job flat: cannot be verified: night/reports/flat/result.json: error: no such file",
                "2 jobs: 1 cannot be verified, 1 verified\n", "result: not refuted, but not all of it is covered\n"});
  (void)shop_.run_script("mkdir night/reports/flat; mkfifo night/reports/flat/result.json");
  expect_lines(verify(), {"night/reports/flat/result.json: error: is no plain file"});
  (void)shop_.run_script("rm -r night/reports/flat");
  const Outcome quiet = verify({"-q"});
  EXPECT_EQ(quiet.out, "");
  EXPECT_NE(quiet.err.find("job flat: night/reports/flat/result.json: error: "), std::string::npos) << quiet.err;
}

TEST_F(VerifyBatch, FilesThatStandInForResultsAreNamed) {
  batch(kTwoJobs);
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n";
  shop_.write("night/reports/flat/result.json", pointer);
  shop_.write("deep.gcp", pointer);
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 3) << ran.out;
  expect_lines(ran, {"job deep: cannot be verified: ",
                     "deep.gcp: error: is a pointer of Git LFS, not the file itself; get the file with 'git lfs pull'",
                     "job flat: cannot be verified: night/reports/flat/result.json: error: is a pointer of Git LFS"});
  (void)shop_.run_script("cp night/reports/deep/result.json a.json; gzip a.json; mv a.json.gz a.json");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"verify", "a.json"},
                                                {"compare", "a.json", "a.json"},
                                                {"accept", "a.json"},
                                                {"check", "flat.apt", "--part", "part.stl", "--baseline", "a.json"}}) {
    const Outcome refused = shop_.run(words);
    EXPECT_EQ(refused.exit_status, 3) << words.front() << refused.out;
    EXPECT_NE(refused.err.find("a.json: error: is a compressed file (gzip); unpack it first"), std::string::npos)
        << words.front() << refused.err;
  }
}

TEST_F(VerifyBatch, AnEditedSummaryIsRefused) {
  batch(kTwoJobs);
  nlohmann::json summary = shop_.json("night/summary.json");
  summary["jobs"].erase(0);
  shop_.write("night/summary.json", summary.dump());
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"verify", "night"}, {"compare", "night", "night"}, {"accept", "night"}}) {
    const Outcome ran = shop_.run(words);
    EXPECT_EQ(ran.exit_status, 3) << ran.out;
    EXPECT_NE(ran.err.find("night/summary.json: error: is not the summary that the batch wrote"), std::string::npos)
        << ran.err;
  }
  (void)shop_.run_script("rm night/manifest.json");
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 4) << ran.out;
  expect_lines(ran, {"not covered: whether summary.json is as the batch wrote it"});
}

TEST_F(VerifyBatch, AStatusOfTheSummaryThatIsNotThatOfTheResultIsRefuted) {
  batch(kTwoJobs);
  change_summary([](nlohmann::json& summary) {
    summary["jobs"][0]["status"] = 0;
    summary["jobs"][0]["verdict"] = "clean";
  });
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 1) << ran.out;
  expect_lines(ran, {"its exit status is 1, that of the job in summary.json 0"});
}

TEST_F(VerifyBatch, ACertificateThatIsNotTheOneOfTheJobIsRefused) {
  batch(kTwoJobs);
  const std::string proofs = shop_.read("deep.gcp");
  shop_.write("deep.gcp", proofs.substr(0, proofs.size() / 2));
  const Outcome ran = verify();
  EXPECT_EQ(ran.exit_status, 3) << ran.out;
  expect_lines(ran, {"deep.gcp: error: is not the certificate that the job wrote"});
  (void)shop_.run_script("rm deep.gcp");
  const Outcome without = verify();
  EXPECT_EQ(without.exit_status, 0) << without.out;
  expect_lines(without, {"job deep: not refuted: only sampled: 11 moves said to be clean (no certificate)"});
}

TEST_F(VerifyBatch, AFolderThatWasMovedWithItsInputsIsVerified) {
  batch(kTwoJobs);
  (void)shop_.run_script("mkdir away; mv night deep.apt flat.apt part.stl away");
  const Outcome ran = shop_.run({"verify", "away/night/"});
  EXPECT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  expect_lines(ran, {"job deep: verified: ", "2 jobs: 1 not refuted, 1 verified\n"});
}

TEST_F(VerifyBatch, OptionsThatDoNotFitABatchAreRefused) {
  batch(kTwoJobs);
  const Outcome ran = verify({"--certificate", "deep.gcp"});
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("--certificate belongs to one result"), std::string::npos) << ran.err;
  EXPECT_EQ(verify({"-q", "-v"}).exit_status, 2);
  (void)shop_.run_script("rm night/summary.json");
  const Outcome interrupted = verify();
  EXPECT_EQ(interrupted.exit_status, 2);
  EXPECT_NE(interrupted.err.find("is the folder of a batch that was interrupted"), std::string::npos)
      << interrupted.err;
}

}  // namespace
}  // namespace gouge::testing_samples::verify_batch_test
