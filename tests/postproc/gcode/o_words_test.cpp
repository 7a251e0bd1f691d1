#include "tests/postproc/gcode/program.h"

// O-words of LinuxCNC: which subprogram a call reaches, and loops whose state the interpreter keeps.
// Source: LinuxCNC 2.9, src/emc/rs274ngc/interp_o_word.cc, and the interpreter itself.

namespace gouge::test::o_words_test {
namespace {

constexpr std::string_view kStart = "G17 G21 G90 G94\nG0 X0 Y0 Z10\nF100\n";

ProgramSetup with_file(const std::string& name, const std::string& text) {
  ProgramSetup setup;
  setup.read_beside = [name, text](const std::string& asked) {
    return asked == name ? std::vector{text} : std::vector<std::string>{};
  };
  return setup;
}

std::string program(const std::string& blocks) { return std::string(kStart) + blocks; }

double x_after(const std::string& blocks, const ProgramSetup& setup = {}) {
  expect_checked(program(blocks), "linuxcnc", setup);
  const Toolpath path = path_of_program(program(blocks), "linuxcnc", setup);
  return path.moves.empty() ? AxisPlace::kUnknownCoordinate : path.moves.back().end.tip.x();
}

void expect_lost(const std::string& blocks, const std::string& reason, const ProgramSetup& setup = {}) {
  expect_open(program(blocks), "linuxcnc", reason, setup);
}

std::string sub(const std::string& label, const std::string& x) {
  return "o" + label + " sub\nG1 X" + x + "\no" + label + " endsub\n";
}

TEST(OWordCalls, ReachASubThatIsDefinedFirst) {
  EXPECT_DOUBLE_EQ(x_after(sub("1", "5") + "o1 call\nM2\n"), 5);
  EXPECT_DOUBLE_EQ(x_after(sub("1", "5") + "o1 call\nM2\n", with_file("1.ngc", sub("1", "30"))), 5);
}

TEST(OWordCalls, ReachASubBehindThem) {
  EXPECT_DOUBLE_EQ(x_after("o1 call\nM2\n" + sub("1", "5")), 5);
  EXPECT_DOUBLE_EQ(x_after("o1 call\no1 call\nM2\n" + sub("2", "9") + sub("1", "5")), 5);
}

TEST(OWordCalls, ReachAFileBesideTheProgram) {
  EXPECT_DOUBLE_EQ(x_after("o<pos> call\nM2\n", with_file("pos.ngc", sub("<pos>", "30"))), 30);
  EXPECT_DOUBLE_EQ(x_after("o1 call\nM2\n", with_file("1.ngc", sub("2", "9") + sub("1", "30"))), 30);
}

TEST(OWordCalls, OfAFileAndOfASubBehindThemAreNotRead) {
  const ProgramSetup setup = with_file("1.ngc", sub("1", "30"));
  expect_lost("o1 call\nM2\n" + sub("1", "5"), "called before its sub", setup);
  const ProgramSetup named = with_file("pos.ngc", sub("<pos>", "30"));
  expect_lost("o<pos> call\nM2\n" + sub("<POS>", "5"), "called before its sub", named);
}

TEST(OWordCalls, OfACalledFileReachASubOfTheProgram) {
  const std::string file = sub("2", "-30") + "o1 sub\no2 call\no1 endsub\n";
  EXPECT_DOUBLE_EQ(x_after(sub("2", "5") + "o1 call\nM2\n", with_file("1.ngc", file)), 5);
  expect_lost("o1 call\nM2\n", "subprogram O2 is not defined before its call", with_file("1.ngc", file));
}

TEST(OWordCalls, OfACalledFileLookForAFileToo) {
  ProgramSetup setup;
  setup.read_beside = [](const std::string& name) -> std::vector<std::string> {
    if (name == "1.ngc") return std::vector{"o1 sub\no2 call\no1 endsub\n" + sub("2", "-30")};
    if (name == "2.ngc") return std::vector{sub("2", "30")};
    return {};
  };
  expect_lost("o1 call\nM2\n", "called before its sub", setup);
}

TEST(OWordCalls, NeedASubThatHasRun) {
  for (const char* skipped : {"o9 if [0]\n", "o9 while [0]\n", "o9 repeat [0]\n"}) {
    const std::string word = std::string(skipped).substr(3, std::string(skipped).find(' ', 3) - 3);
    const std::string text = skipped + sub("1", "-30") + "o9 end" + word + "\n";
    EXPECT_DOUBLE_EQ(x_after(text + sub("1", "30") + "o1 call\nM2\n"), 30) << text;
    EXPECT_DOUBLE_EQ(x_after(text + "o1 call\nM2\n" + sub("1", "30")), 30) << text;
    EXPECT_DOUBLE_EQ(x_after(text + "o1 call\nM2\n", with_file("1.ngc", sub("1", "30"))), 30) << text;
    expect_lost(text + "o1 call\nM2\n", "subprogram O1 is not defined before its call");
  }
}

TEST(OWordCalls, DoNotReachASubInAStructure) {
  const std::string reason = "in a subprogram, a loop or a condition";
  expect_lost("o9 if [1]\n" + sub("1", "5") + "o9 endif\no1 call\nM2\n", reason);
  expect_lost("o9 if [0]\n" + sub("1", "5") + "o9 else\n" + sub("1", "6") + "o9 endif\no1 call\nM2\n", reason);
  expect_lost("o9 repeat [1]\n" + sub("1", "5") + "o9 endrepeat\no1 call\nM2\n", reason);
  expect_lost("o9 do\n" + sub("1", "5") + "o9 while [0]\no1 call\nM2\n", reason);
  expect_lost("o1 call\nM2\no9 if [0]\n" + sub("1", "5") + "o9 endif\n", reason);
  expect_lost("o1 call\nM2\no1 sub\n" + sub("2", "5") + "o1 endsub\n", reason);
}

TEST(OWordCalls, DoNotReachASubThatIsDefinedTwice) {
  expect_lost(sub("1", "5") + sub("1", "6") + "o1 call\nM2\n", "already defined");
  expect_lost("o1 call\n" + sub("1", "5") + "M2\n", "already defined");
  expect_lost("o1 call\n" + sub("1", "5") + "M2\n", "called before its sub", with_file("1.ngc", sub("1", "6")));
}

TEST(OWordCalls, EndAtTheEndOfTheirSub) {
  expect_lost("o1 call\nM2\n", "the file ends within subprogram O1", with_file("1.ngc", "o1 sub\nG1 X5\n"));
  expect_lost("o1 sub\nG1 X5\no2 return\no1 endsub\no1 call\nM2\n", "outside of its subprogram");
}

TEST(OWordLabels, AreOfOneSpelling) {
  EXPECT_DOUBLE_EQ(x_after(sub("01", "5") + "o1 call\nM2\n"), 5);
  EXPECT_DOUBLE_EQ(x_after(sub("1", "5") + "o<1> call\nM2\n"), 5);
  EXPECT_DOUBLE_EQ(x_after(sub("1 0", "5") + "o10 call\nM2\n"), 5);
  EXPECT_DOUBLE_EQ(x_after("o1 if [0]\nG1 X5\no01 el se\nG1 X6\no1 end if\nM2\n"), 6);
}

TEST(OWordRepeats, MayNotBeLeft) {
  const std::string reason = "whose count then stays";
  expect_lost("o1 sub\no2 repeat [5]\no3 if [1]\no1 return\no3 endif\no2 endrepeat\no1 endsub\no1 call\nG1 X5\nM2\n",
              reason);
  for (const char* word : {"break", "continue"})
    expect_lost("#1=0\no1 while [#1 lt 2]\n#1=[#1+1]\no2 repeat [3]\no1 " + std::string(word) +
                    "\no2 endrepeat\no1 endwhile\nG1 X5\nM2\n",
                reason);
}

TEST(OWordRepeats, MayNotRunWithinThemselves) {
  expect_lost(
      "#100=0\no1 sub\n#100=[#100+1]\no2 repeat [2]\nG1 X#100\no3 if [#100 lt 3]\no1 call\no3 endif\n"
      "o2 endrepeat\no1 endsub\no1 call\nM2\n",
      "runs within itself");
  expect_lost("o2 repeat [2]\no2 repeat [3]\nG1 X5\no2 endrepeat\no2 endrepeat\nM2\n", "");
}

TEST(OWordRepeats, OfASubAndOfItsCallerHaveTheirOwnCounts) {
  EXPECT_DOUBLE_EQ(x_after("#100=0\no<s> sub\no1 repeat [3]\n#100=[#100+1]\no1 endrepeat\no<s> endsub\n"
                           "o1 repeat [2]\no<s> call\no1 endrepeat\nG1 X#100\nM2\n"),
                   6);
}

TEST(OWordNames, AreTheFirstBlockOfAProgram) {
  EXPECT_TRUE(can_be_clean(
      read_program("%\n(a part)\nO1000 (FACE)\nG21 G90 G94 G17\nG0 X0 Y0 Z9\nG1 X4 F9\nM2\n%\n", "linuxcnc")));
  expect_lost("O1000\nG1 X5\nM2\n", "as the first block alone");
}

TEST(OWordBreaks, EndTheNextDoOfTheInterpreter) {
  const std::string reason = "do in a program with a break";
  const std::string loop = "#1=0\no3 do\n#1=[#1+1]\nG1 X#1\no3 while [#1 lt 6]\nM2\n";
  expect_lost("o1 while [1]\no1 break\no1 endwhile\n" + loop, reason);
  expect_lost("o1 while [0]\no1 break\no1 endwhile\n" + loop, reason);
  expect_lost("o<s> sub\no1 while [1]\no1 break\no1 endwhile\no<s> endsub\no<s> call\n" + loop, reason);
  expect_lost("o<s> call\n" + loop, reason,
              with_file("s.ngc", "o<s> sub\no1 while [1]\no1 break\no1 endwhile\no<s> endsub\n"));
  EXPECT_DOUBLE_EQ(x_after(loop), 6);
}

TEST(OWordBreaks, LeaveLoopsOfWhile) {
  const std::string loop =
      "#1=0\no1 while [#1 lt 9]\n#1=[#1+1]\nG1 X#1\no2 if [#1 eq 4]\no1 break\no2 endif\no1 endwhile\n";
  EXPECT_DOUBLE_EQ(x_after(loop + "M2\n"), 4);
  EXPECT_DOUBLE_EQ(x_after(loop + "o3 do\nG1 X7\no3 while [0]\nM2\n"), 7);
  EXPECT_DOUBLE_EQ(x_after(loop + "#2=0\no4 while [#2 lt 3]\n#2=[#2+1]\nG1 X#2\no4 endwhile\nM2\n"), 3);
}

}  // namespace
}  // namespace gouge::test::o_words_test
