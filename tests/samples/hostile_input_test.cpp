#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Inputs that never end or are larger than anything a user means, at every place a command reads.

namespace gouge::testing_samples::hostile_input_test {
namespace {

using Words = std::vector<std::string>;

// Each command with `file` at one of the places it reads from.
std::vector<Words> reading(const std::string& file) {
  const std::string path = "cavity.cls", part = "cavity.stl";
  return {{"check", file, "--part", part},
          {"check", path, "--part", file},
          {"check", path, "--part", part, "--fixture", file},
          {"check", path, "--part", part, "--head", file},
          {"check", path, "--part", part, "--tools", file},
          {"correct", file, "--part", part, "-o", "out.cls"},
          {"mesh", file},
          {"tool", "list", "--tools", file},
          {"tool", "show", "--tools", file},
          {"tool", "draw", "--tools", file, "-o", "out.png"},
          {"tool", "import", file, "-o", "out.json"},
          {"tool", "import", "-o", "out.json", "x.tools", "--holder", "h", "--tools", file},
          {"path", "info", file},
          {"path", "convert", file, "-o", "out.cls"},
          {"path", "plot", file, "-o", "out.png"}};
}

class HostileInput : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fresh_folder();
    write_text(folder_ + "/cavity.cls",
               "TOOL PATH/A,TOOL,T\nTLDATA/MILL,10.,0.,40.,0.,0.\nGOTO/0.,0.,9.,0.,0.,1.\nEND-OF-PATH\n");
    write_text(folder_ + "/cavity.stl",
               "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 "
               "0\nendloop\nendfacet\nendsolid\n");
    std::signal(SIGPIPE, SIG_IGN);
  }

  std::string folder_;
};

TEST_F(HostileInput, ADeviceIsRefusedWhereverAFileIsRead) {
  for (const std::string device : {"/dev/zero", "/dev/urandom"}) {
    for (const Words& words : reading(device)) {
      const Outcome outcome = run_gougecheck(folder_, words);
      EXPECT_EQ(outcome.exit_status, 3) << words[0] << " " << words[1];
      EXPECT_NE(outcome.err.find(device + ": error: is a device; expected a file or a pipe [input-is-device]\n"),
                std::string::npos)
          << words[0] << " " << words[1] << ": " << outcome.err;
    }
  }
}

TEST_F(HostileInput, AFileAboveTheLimitIsRefusedWhereverAFileIsRead) {
  write_text(folder_ + "/large", std::string(2'000, ' '));
  for (Words words : reading("large")) {
    words.insert(words.end(), {"--max-input", "1.5kB"});
    const Outcome outcome = run_gougecheck(folder_, words);
    EXPECT_EQ(outcome.exit_status, 3) << words[0] << " " << words[1];
    EXPECT_EQ(outcome.err,
              "large: error: has 2000 bytes; expected at most 1.5 kB; check that it is the right file, or allow more "
              "with --max-input [input-too-large]\n")
        << words[0] << " " << words[1];
  }
  const Outcome wrong = run_gougecheck(folder_, {"mesh", "large", "--max-input", "8 apples"});
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_EQ(wrong.err,
            "gougecheck: error: --max-input '8 apples': expected a size above 0 with a unit or in bytes, such as 8GB "
            "[usage]\n");
}

TEST_F(HostileInput, APipeThatNeverEndsIsReadUpToTheLimit) {
  const std::string pipe = folder_ + "/pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (Words words : reading("pipe")) {
    words.insert(words.end(), {"--max-input", "200kB"});
    std::thread writer([&] {
      std::ofstream stream(pipe);
      while (stream << "GOTO/1,2,3\n") {
      }
    });
    const Outcome outcome = run_gougecheck(folder_, words);
    writer.join();
    EXPECT_EQ(outcome.exit_status, 3) << words[0] << " " << words[1];
    EXPECT_NE(outcome.err.find("pipe: error: goes on after 200 kB; expected at most 200 kB"), std::string::npos)
        << words[0] << " " << words[1] << ": " << outcome.err;
  }
}

TEST_F(HostileInput, APipeThatEndsIsReadLikeAFile) {
  const std::string pipe = folder_ + "/pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << text_of(folder_ + "/cavity.cls"); });
  const Outcome outcome = run_gougecheck(folder_, {"check", "pipe", "--path-units", "mm", "--part", "cavity.stl"});
  writer.join();
  EXPECT_EQ(outcome.exit_status, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace gouge::testing_samples::hostile_input_test
