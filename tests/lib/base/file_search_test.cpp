#include "lib/base/file_search.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/base/files.h"
#include "tests/support/temporary_folder.h"

namespace gouge::file_search_test {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

class FileSearches : public ::testing::Test {
 protected:
  void add(const std::string& name) const {
    fs::create_directories(fs::path(temporary_.at(name)).parent_path());
    ASSERT_TRUE(write_file(temporary_.at(name), name));
  }
  [[nodiscard]] FileSearch search(SearchRule rule, const std::string& name) const {
    return {rule, temporary_.at("shop"), name};
  }
  /// Returns the names of the files that fit, relative to the test's folder.
  [[nodiscard]] Names found(SearchRule rule, const std::string& name) const {
    Names names;
    for (const std::string& file : repeat_search(search(rule, name)))
      names.push_back(fs::path(file).lexically_relative(temporary_.path()).string());
    return names;
  }

  testing_support::TemporaryFolder temporary_;
};

TEST_F(FileSearches, AreNotedAlsoWhereNothingIsFound) {
  SearchLog log;
  const FileSearch looked = search(SearchRule::program_beside, "O2000");
  EXPECT_EQ(find_files(looked, log), Names{});
  EXPECT_EQ(find_files(looked, log), Names{});
  ASSERT_EQ(log.size(), 1U) << "the same search is noted once";
  EXPECT_EQ(log[0].search, looked);
  add("shop/o02000.NC");
  const Names there = find_files(looked, log);
  EXPECT_EQ(there, Names{temporary_.at("shop/o02000.NC")});
  ASSERT_EQ(log.size(), 2U) << "a file came while the job read";
  EXPECT_EQ(log[1].found, there);
}

TEST_F(FileSearches, OfToolFilesTryBothPlacesInAnyCase) {
  constexpr SearchRule kRule = SearchRule::named_by_tools;
  EXPECT_EQ(found(kRule, "sub/em6.fctb"), Names{});
  add("Bit/Sub/EM6.fctb");
  EXPECT_EQ(found(kRule, "sub/em6.fctb"), Names{}) << "there is no folder shop, and so no folder beside it";
  add("shop/tools.fctl");
  EXPECT_EQ(found(kRule, "sub/em6.fctb"), Names{"Bit/Sub/EM6.fctb"});
  add("shop/sub/Em6.fctb");
  EXPECT_EQ(found(kRule, "sub/em6.fctb"), Names{"shop/sub/Em6.fctb"});
  add("shop/sub/EM6.fctb");
  EXPECT_EQ(found(kRule, "sub/em6.fctb"), (Names{"shop/sub/EM6.fctb", "shop/sub/Em6.fctb"}));
  add("shop/sub/em6.fctb");
  EXPECT_EQ(found(kRule, "sub/em6.fctb"), Names{"shop/sub/em6.fctb"}) << "the exact name counts first";
}

TEST_F(FileSearches, TakeNoLinkThatLeadsNowhereForAFile) {
  add("Bit/em6.fctb");
  add("shop/tools.fctl");
  fs::create_symlink("gone", temporary_.at("shop/em6.fctb"));
  EXPECT_EQ(found(SearchRule::named_by_tools, "em6.fctb"), Names{"Bit/em6.fctb"});
}

TEST(SearchRules, HaveNamesThatReadBack) {
  for (const SearchRule rule : {SearchRule::program_beside, SearchRule::named_by_tools})
    EXPECT_EQ(search_rule_called(rule_name(rule)), rule);
  EXPECT_EQ(search_rule_called("toolpath"), std::nullopt);
}

}  // namespace
}  // namespace gouge::file_search_test
