#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// The head of a report: docs/guide/sign_off.md.

namespace gouge::testing_samples::sign_off_test {
namespace {

class SignOffOfReport : public testing::Test {
 protected:
  void SetUp() override { sample_ = open_sample("pocket"); }

  [[nodiscard]] std::string report_of(const std::string& folder, const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"--report", folder};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_gougecheck(sample_.path, sample_.arguments("check", "pocket.apt", words)).exit_status, 1);
    return text_of(sample_.path + "/" + folder + "/report.html");
  }

  SampleFolder sample_;
};

TEST_F(SignOffOfReport, SaysWhoWhenAndHow) {
  const std::string html = report_of("r", {"--project", "Impeller <7>", "--reviewer", "A. Noether"});
  for (const char* words : {"<dt>Project</dt><dd>Impeller &lt;7&gt;</dd>", "<dt>Reviewer</dt><dd>A. Noether</dd>",
                            "<dt>Date</dt><dd>2023-11-14 22:13 UTC</dd>", "<dt>Program</dt><dd>gougecheck ",
                            "<dt>Command</dt><dd>gougecheck check pocket.apt <span>--part</span> part.stl",
                            "<b>Reviewed by</b><p>A. Noether</p>"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
}

TEST_F(SignOffOfReport, TheCommandIsTheSameHoweverItIsRun) {
  const std::string one = report_of("one", {"--threads", "1", "--csv", "a.csv"});
  EXPECT_TRUE(one == report_of("two", {"--threads", "3", "--progress", "never", "-q"}));
}

TEST_F(SignOffOfReport, TheCommandIsQuotedForAShell) {
  std::filesystem::copy_file(sample_.path + "/pocket.apt", sample_.path + "/it's mine.apt");
  ASSERT_EQ(run_gougecheck(sample_.path, sample_.arguments("check", "it's mine.apt", {"--report", "r"})).exit_status,
            1);
  const std::string html = text_of(sample_.path + "/r/report.html");
  EXPECT_NE(html.find("gougecheck check &#39;it&#39;\\&#39;&#39;s mine.apt&#39; <span>--part</span>"),
            std::string::npos);
}

TEST_F(SignOffOfReport, ADateThatIsNoneIsRefused) {
  const Outcome ran =
      run_script(sample_.path, "SOURCE_DATE_EPOCH=yesterday $GOUGECHECK check pocket.apt --part part.stl");
  EXPECT_EQ(ran.exit_status, 2);
  EXPECT_NE(ran.err.find("SOURCE_DATE_EPOCH 'yesterday' of the environment: expected seconds since 1970-01-01"),
            std::string::npos)
      << ran.err;
}

}  // namespace
}  // namespace gouge::testing_samples::sign_off_test
