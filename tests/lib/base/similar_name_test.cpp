#include "lib/base/similar_name.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace gouge::similar_name_test {
namespace {

TEST(SimilarName, IsTheNearestByLetters) {
  const std::vector<std::string> names{"roughing.apt", "finishing.apt", "drill.apt"};
  EXPECT_EQ(find_similar_name("finishign.apt", names), "finishing.apt");
  EXPECT_EQ(find_similar_name("drll.apt", names), "drill.apt");
  EXPECT_EQ(find_similar_name("contour.apt", names), "");
}

TEST(SimilarName, OfEqualsHasTheLongerCommonBeginning) {
  EXPECT_EQ(find_similar_name("barell", {"flat", "ball", "barrel"}), "barrel");
  EXPECT_EQ(find_similar_name("barell", {"barrel", "ball"}), "barrel");
  EXPECT_EQ(find_similar_name("abcd", {"abxx", "abdx", "abxy"}), "abdx") << "the same letters decide then";
  EXPECT_EQ(find_similar_name("cat", {"bat", "hat"}), "bat") << "the first of equals";
}

TEST(SimilarName, IsTheOnlyOneThatTheWordBegins) {
  EXPECT_EQ(find_similar_name("bull", {"flat", "ball", "bull_nose"}), "bull_nose");
  EXPECT_EQ(find_similar_name("bull", {"ball", "bull_nose", "bull_end"}), "ball") << "two begin with it";
  EXPECT_EQ(find_similar_name("tool.json", {"tool.json.orig", "tools.json"}), "tools.json");
  EXPECT_EQ(find_similar_name("bu", {"bull_nose"}), "");
}

struct MissingFile : testing::Test {
  testing_support::TemporaryFolder temporary;
  std::filesystem::path folder = temporary.path();

  MissingFile() {
    std::filesystem::create_directories(folder / "blade.stl.d");
    for (const char* name : {"blade.STL", "op10 finish.apt", "op20 finish.apt"}) std::ofstream(folder / name) << "x";
  }

  [[nodiscard]] std::string message(const std::string& name) const {
    return describe_missing_file((folder / name).string()).message;
  }
};

TEST_F(MissingFile, IsNamedWithTheOneThatWasProbablyMeant) {
  EXPECT_EQ(message("blade.stl"), "no such file; did you mean blade.STL?");
  EXPECT_EQ(message("op10 finsh.apt"), "no such file; did you mean op10 finish.apt?");
  EXPECT_EQ(message("op20 finish.cls"), "no such file; did you mean op20 finish.apt?");
  EXPECT_EQ(message("fixture.stl"), "no such file");
}

TEST_F(MissingFile, OfABrokenLinkIsItsTarget) {
  std::filesystem::create_symlink("nowhere.apt", folder / "op30.apt");
  EXPECT_EQ(message("op30.apt"), "is a link to nowhere.apt, which does not exist");
}

TEST_F(MissingFile, IsNamedWithTheFolderThatIsMissingToo) {
  EXPECT_EQ(message("parts/blade.stl"), "no such file; the folder " + (folder / "parts").string() + " does not exist");
  EXPECT_EQ(describe_missing_file("/no/such/file").code, "file-not-found");
}

TEST_F(MissingFile, WithBackslashesIsNamedWithSlashes) {
  const std::string file = (folder / "blade.STL").string();
  const std::string typed = folder.string() + "\\blade.STL";
  EXPECT_EQ(describe_missing_file(typed).message, "no such file; did you mean " + file + "?");
}

}  // namespace
}  // namespace gouge::similar_name_test
