#include "cli/output/report_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>

#include "lib/base/files.h"
#include "postproc/image/report_pictures.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/image/small_scene.h"
#include "tests/support/other_user.h"
#include "tests/support/temporary_folder.h"

namespace gouge::report_folder_test {
namespace {

namespace fs = std::filesystem;
using Content = std::map<std::string, std::string>;

class Folder : public testing::Test {
 protected:
  void SetUp() override {}

  /// The code of the first error, or "".
  std::string report(const Content& files, bool is_forced = false) {
    ReportFolder report(folder_, is_forced);
    Outcome done = report.open();
    if (done) done = report.stage(named(files));
    if (done) done = report.commit();
    message_ = done ? "" : done.error().message;
    return done ? "" : done.error().code;
  }
  [[nodiscard]] static std::vector<NamedFile> named(const Content& files) {
    std::vector<NamedFile> all;
    for (const auto& [name, bytes] : files) all.push_back({name, bytes, ""});
    return all;
  }
  void put(const std::string& name, const std::string& bytes) const {
    fs::create_directories(folder_);
    std::ofstream(folder_ + "/" + name) << bytes;
  }
  /// All that is in the folder but the manifest.
  [[nodiscard]] Content content() const {
    Content files;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name != kManifestName) files[name] = entry.is_regular_file() ? *read_file(entry.path().string()) : "no file";
    }
    return files;
  }

  const Content small_ = {{"report.html", "a"}, {"moves.csv", "b"}, {"event_1.png", "c"}};
  const Content large_ = {{"report.html", "A"}, {"moves.csv", "b"}, {"event_1.png", "C"}, {"event_5.png", "E"}};
  testing_support::TemporaryFolder temporary_;
  std::string root_ = temporary_.path(), folder_ = root_ + "/of/today", message_;
};

TEST_F(Folder, NamesTheToolpathOfTheReportThatItReplaces) {
  const auto replaced = [&](const std::string& toolpath) {
    ReportFolder report(folder_, false);
    report.set_toolpath(toolpath);
    EXPECT_TRUE(report.open());
    EXPECT_TRUE(report.stage(named({{"report.html", toolpath}})));
    const std::string other = report.replaced_toolpath();
    EXPECT_TRUE(report.commit());
    return other;
  };
  EXPECT_EQ(replaced("op10.cls"), "");
  EXPECT_EQ(replaced("./op10.cls"), "") << "the same file by another name";
  EXPECT_EQ(replaced("op20.cls"), "./op10.cls");
  EXPECT_EQ(report({{"report.html", "of no toolpath"}}), "");
  EXPECT_EQ(replaced("op30.cls"), "");
}

TEST_F(Folder, AReportTakesThePlaceOfAnOlderOneAndOfNothingElse) {
  const Content foreign = {{"event_10.png", "m"}, {"event_.png", "m"},    {"event_2.PNG", "m"},
                           {"event_0.png", "m"},  {"result.jsonl", "m"},  {"moves.csv.bak", "m"},
                           {"my.png", "m"},       {"manifest.json~", "m"}};
  for (const auto& [name, bytes] : foreign) put(name, bytes);
  for (const Content& files : {small_, large_, small_}) {
    EXPECT_EQ(report(files), "") << message_;
    Content expected = files;
    expected.insert(foreign.begin(), foreign.end());
    EXPECT_EQ(content(), expected);
    const auto manifest = read_manifest(*read_file(folder_ + "/" + kManifestName));
    ASSERT_TRUE(manifest.has_value());
    EXPECT_TRUE(manifest->is_complete);
    EXPECT_EQ(manifest->files.size(), files.size());
    for (const auto& [name, bytes] : files) EXPECT_TRUE(manifest->has(describe_bytes(name, bytes))) << name;
  }
}

TEST_F(Folder, AForeignFileUnderANameOfAReportIsRefused) {
  ASSERT_EQ(report(small_), "");
  // One the report would write, one it has changed since, and one it would take for its own and remove.
  put("event_3.png", "a photograph");
  put("moves.csv", "edited");
  const Content before = content();
  EXPECT_EQ(report(large_), "report-foreign");
  EXPECT_EQ(message_,
            "a report would replace or remove moves.csv and event_3.png, which no report wrote or which was changed "
            "since (manifest.json); expected a folder without them: name another one, move them away, or let --force "
            "replace or remove them");
  EXPECT_EQ(content(), before);
  EXPECT_EQ(report(large_, true), "") << message_;
  EXPECT_EQ(content(), large_);
  EXPECT_EQ(report(small_), "") << "what --force wrote is a report's own";
}

TEST_F(Folder, AReportWithoutAManifestIsReportedOnce) {
  for (const auto& [name, bytes] : large_) put(name, bytes);
  EXPECT_EQ(report(small_), "report-foreign");
  EXPECT_EQ(message_,
            "a report would replace or remove report.html, moves.csv, event_1.png and event_5.png, and no "
            "manifest.json says that a report wrote them: they are yours, or of an earlier version of gougecheck; "
            "expected a folder without them: name another one, move them away, or let --force replace or remove them");
  EXPECT_EQ(content(), large_);
  EXPECT_EQ(report(small_, true), "") << message_;
  EXPECT_EQ(content(), small_);
}

TEST_F(Folder, AManifestOfSomethingElseIsForeign) {
  for (const char* text : {"{\"name\":\"a web page\"}", "no JSON", "[]", ""}) {
    put(kManifestName, text);
    EXPECT_EQ(report(small_), "report-foreign") << text;
    EXPECT_EQ(*read_file(folder_ + "/" + kManifestName), text);
  }
  put(kManifestName, std::string(100'000, '['));
  EXPECT_EQ(report(small_), "report-foreign");
}

TEST_F(Folder, OfABatchIsNotTakenOverByAReportAndNeitherTheOtherWay) {
  const auto batch = [&](bool is_forced) {
    ReportFolder folder(folder_, is_forced, names_of_batch());
    Outcome done = folder.open();
    if (done) done = folder.stage(named({{"index.html", "i"}, {kBatchSummaryName, "{}"}}));
    if (done) done = folder.commit();
    message_ = done ? "" : done.error().message;
    return done ? "" : done.error().code;
  };
  ASSERT_EQ(batch(false), "");
  EXPECT_EQ(report({{"report.html", "r"}, {"result.json", "{}"}}), "report-foreign");
  EXPECT_NE(message_.find("is the folder of a batch, which a report would take over"), std::string::npos) << message_;
  EXPECT_EQ(batch(false), "") << "its manifest is as it was";
  fs::remove_all(root_);
  ASSERT_EQ(report({{"report.html", "r"}, {"result.json", "{}"}}), "");
  EXPECT_EQ(batch(false), "report-foreign");
  EXPECT_NE(message_.find("is the folder of a report, which a batch would take over"), std::string::npos) << message_;
}

TEST_F(Folder, WhatIsNoPlainFileIsRefusedEvenWithForce) {
  fs::create_directories(folder_ + "/event_5.png");
  EXPECT_EQ(report(small_, true), "report-foreign");
  EXPECT_EQ(message_,
            "event_5.png is no plain file, so no report can replace it; move it away, or name another folder");
  fs::remove(folder_ + "/event_5.png");
  std::ofstream(root_ + "/precious") << "mine";
  fs::create_symlink("../../precious", folder_ + "/report.html");
  EXPECT_EQ(report(small_, true), "report-foreign");
  EXPECT_EQ(*read_file(root_ + "/precious"), "mine");
}

TEST_F(Folder, WhatIsNotCommittedLeavesNothing) {
  {
    ReportFolder unfinished(folder_, false);
    ASSERT_TRUE(unfinished.open().has_value());
    EXPECT_FALSE(fs::exists(root_ + "/of")) << "nothing is made before the work";
    ASSERT_TRUE(unfinished.stage(named(small_)).has_value());
    EXPECT_EQ(content(), Content());
  }
  EXPECT_FALSE(fs::exists(root_ + "/of"));
  ASSERT_EQ(report(small_), "");
  {
    ReportFolder unfinished(folder_, false);
    ASSERT_TRUE(unfinished.open().has_value());
    ASSERT_TRUE(unfinished.stage(named(large_)).has_value());
  }
  EXPECT_EQ(content(), small_);
}

TEST_F(Folder, TwoAtOnceAreRefused) {
  ASSERT_EQ(report(small_), "");
  {
    ReportFolder first(folder_, false);
    ASSERT_TRUE(first.open().has_value());
    EXPECT_EQ(report(large_), "report-busy");
    EXPECT_EQ(
        message_,
        "another gougecheck is about to write its report here; expected a folder for each, or one after the other");
  }
  EXPECT_EQ(report(large_), "");
}

TEST_F(Folder, ALinkToTheFolderIsFollowed) {
  fs::create_directories(root_ + "/of");
  fs::create_directory_symlink("../elsewhere", root_ + "/of/today");
  EXPECT_EQ(report(small_), "") << message_;
  EXPECT_TRUE(fs::is_symlink(folder_));
  EXPECT_TRUE(fs::is_regular_file(root_ + "/elsewhere/report.html"));
}

TEST_F(Folder, AReportOfAnotherUserIsRefused) {
  ASSERT_EQ(report(small_), "");
  for (const auto& entry : fs::recursive_directory_iterator(root_)) fs::permissions(entry, fs::perms::all);
  if (::geteuid() != 0) GTEST_SKIP() << "only root can be another user";
  EXPECT_EQ(testing_support::as_nobody([&] { return report(large_) == "file-unwritable" ? 0 : 1; }), 0);
  EXPECT_EQ(content(), small_);
}

TEST(ReportManifest, ReadIsAsWritten) {
  const ReportManifest manifest{{describe_bytes("a", "abc"), describe_bytes("a", "")}, false};
  const std::string text = write_manifest(manifest);
  const auto read = read_manifest(text);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->files, manifest.files);
  EXPECT_FALSE(read->is_complete);
  EXPECT_EQ(manifest.files.front().sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  for (std::size_t cut = 0; cut + 2 < text.size(); ++cut) EXPECT_FALSE(read_manifest(text.substr(0, cut))) << cut;
}

// Else no later report replaces or removes it, or nobody sees it.
TEST(ReportManifest, EveryPictureIsANameOfTheReportAndOnItsPage) {
  SmallScene small;
  const SmallScene before;
  small.path.moves[1].end.axis = Vec3(0.2, 0, 1).normalized();
  small.model.has_correction = true;
  small.model.correction.toolpath_before = &before.path;
  small.model.correction.result_before = &before.result;
  small.model.correction.axes = AxisFacts{};
  std::vector<std::size_t> origins(small.path.moves.size());
  std::iota(origins.begin(), origins.end(), std::size_t{0});
  small.model.correction.axes->tilts = find_axis_tilts(before.path, small.path, origins);
  const Result<std::vector<NamedFile>> pictures = draw_report_pictures({small.model, small.input, before.input});
  ASSERT_TRUE(pictures && !pictures->empty());
  const std::string page = write_html(small.model, *pictures);
  const std::vector<std::string>& names = names_of_report();
  for (const char* drawn : {"heat_map.png", "before_after.png", "tilt_field.png", "event_1.png"}) {
    EXPECT_TRUE(std::ranges::any_of(*pictures, [&](const NamedFile& file) { return file.name == drawn; })) << drawn;
  }
  for (const NamedFile& picture : *pictures) {
    EXPECT_NE(std::find(names.begin(), names.end(), picture.name), names.end()) << picture.name;
    const std::string figure = "<figure id=\"" + picture.name.substr(0, picture.name.find('.')) + "\">";
    EXPECT_NE(page.find(figure), std::string::npos) << picture.name;
  }
}

}  // namespace
}  // namespace gouge::report_folder_test
