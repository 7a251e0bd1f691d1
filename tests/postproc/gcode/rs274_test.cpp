// LinuxCNC's own interpreter against this reader: where a program is read to its end, every motion is the same. Programs are
// generated, and damaged: a word is removed, doubled or changed. What the interpreter refuses must not be clean.
//
// Needs rs274 of Debian's linuxcnc-uspace: in the path, or named by GOUGE_RS274. GOUGE_PROGRAMS: number of programs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "lib/base/number_text.h"
#include "tests/postproc/gcode/program.h"
#include "tests/support/scatter.h"
#include "tests/support/source_folder.h"
#include "tests/support/temporary_folder.h"

namespace gouge::test::rs274_test {
namespace {

constexpr double kSame_mm = 1.01e-4;  // four decimals

struct OracleMove {
  bool is_rapid = false;
  Vec3 end;
  double a = 0, c = 0;
  double digit_mm = kSame_mm;
};

struct OracleRun {
  std::vector<OracleMove> moves;
  bool is_refused = false;
  std::string last_line;  ///< of its output
};

std::string oracle() {
  if (const char* named = std::getenv("GOUGE_RS274")) return named;
  return std::system("command -v rs274 >/dev/null 2>&1") == 0 ? "rs274" : "";
}

std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  std::stringstream list(line.substr(line.find('(') + 1));
  for (std::string part; std::getline(list, part, ',');)
    if (const auto number = parse_number(trim_blanks(std::string_view(part).substr(0, part.find(')')))))
      numbers.push_back(*number);
  return numbers;
}

class Folder {
 public:
  Folder() {
    std::ofstream(folder_.at("v.var")) << "";
    std::ofstream(folder_.at("t.tbl")) << "T1 P1 Z0 D1\nT2 P2 Z0 D8\n";
  }

  /// Runs a program; once more where it is refused, as the machine may have been too busy for the time limit.
  OracleRun run(const std::string& text) const {
    OracleRun first = run_once(text);
    return first.is_refused ? run_once(text) : first;
  }

 private:
  OracleRun run_once(const std::string& text) const {
    const std::string in = folder_.at("p.ngc"), out = folder_.at("p.out");
    std::ofstream(in) << text;
    const std::string command =
        "cd " + folder_.path() + " && timeout 20 " + oracle() + " -g -v v.var -t t.tbl " + in + " >" + out + " 2>&1";
    OracleRun run;
    run.is_refused = std::system(command.c_str()) != 0;
    std::ifstream lines(out);
    double mm_per_unit = 1;
    for (std::string line; std::getline(lines, line);) {
      run.last_line = line;
      const std::vector<double> n = numbers_in(line);
      if (line.find("USE_LENGTH_UNITS(") != std::string::npos)
        mm_per_unit = line.find("INCH") != std::string::npos ? 25.4 : 1;
      OracleMove move;
      if (line.find("STRAIGHT_TRAVERSE(") != std::string::npos || line.find("STRAIGHT_FEED(") != std::string::npos) {
        if (n.size() < 6) continue;
        move = {line.find("TRAVERSE") != std::string::npos, {n[0], n[1], n[2]}, n[3], n[5]};
      } else if (line.find("ARC_FEED(") != std::string::npos) {
        // First and second end, centre, rotation, end of the axis: of the plane of G17.
        if (n.size() < 9) continue;
        move = {false, {n[0], n[1], n[5]}, n[6], n[8]};
      } else {
        continue;
      }
      move.end *= mm_per_unit;
      move.digit_mm *= mm_per_unit;
      run.moves.push_back(move);
    }
    return run;
  }

  testing_support::TemporaryFolder folder_;
};

/// Motions without those that stand: both sides state some.
std::vector<OracleMove> without_rests(const std::vector<OracleMove>& all) {
  std::vector<OracleMove> moves;
  for (const OracleMove& move : all) {
    const bool stands = !moves.empty() &&
                        (moves.back().end - move.end).norm() < std::max(move.digit_mm, moves.back().digit_mm) &&
                        std::abs(moves.back().a - move.a) + std::abs(moves.back().c - move.c) < kSame_mm;
    if (!stands) moves.push_back(move);
  }
  return moves;
}

std::vector<OracleMove> moves_of(const Toolpath& path) {
  std::vector<OracleMove> moves;
  constexpr double kDegrees = 180 / std::numbers::pi;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    OracleMove move{path.moves[i].kind == MoveKind::rapid, path.moves[i].end.tip, 0, 0};
    if (path.joints != nullptr && path.joints->end[i]) {
      move.c = (*path.joints->end[i])[0] * kDegrees;
      move.a = (*path.joints->end[i])[1] * kDegrees;
    }
    moves.push_back(move);
  }
  return moves;
}

/// Rapids before all coordinates are known are no moves here; the interpreter begins at 0.
void drop_approach(const std::vector<OracleMove>& ours, std::vector<OracleMove>& theirs) {
  if (ours.empty()) return;
  const auto same = [&](const OracleMove& move) {
    return (move.end - ours.front().end).cwiseAbs().maxCoeff() < move.digit_mm;
  };
  theirs.erase(theirs.begin(), std::ranges::find_if(theirs, same));
}

void expect_same(const Toolpath& path, const OracleRun& run, const std::string& what) {
  const std::vector<OracleMove> ours = without_rests(moves_of(path));
  std::vector<OracleMove> theirs = without_rests(run.moves);
  drop_approach(ours, theirs);
  ASSERT_EQ(ours.size(), theirs.size()) << what;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_LE((ours[i].end - theirs[i].end).cwiseAbs().maxCoeff(), theirs[i].digit_mm)
        << what << "\nmotion " << i << ": " << ours[i].end.transpose() << " and " << theirs[i].end.transpose();
    ASSERT_LE(std::abs(ours[i].a - theirs[i].a) + std::abs(ours[i].c - theirs[i].c), 2 * kSame_mm) << what;
    ASSERT_EQ(ours[i].is_rapid, theirs[i].is_rapid) << what << "\nmotion " << i;
  }
}

std::string number_text(Scatter& random, double half) {
  constexpr double kMin = 0.01;  // above the last digit of the interpreter
  const double number = random.in(kMin, half);
  return fixed_text(random.is(0.5) ? number : -number, 3);
}

/// A program of motions, arcs, cycles, frames and expressions.
std::string generated(Scatter& random) {
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random.next() % count); };
  std::string text = "G21 G90 G17 G40 G49 G94 G98 G61\nG0 X" + number_text(random, 50) + " Y" +
                     number_text(random, 50) + " Z" + fixed_text(20 + random.in(0, 5), 3) + "\nF500\n";
  bool is_absolute = true;
  const std::size_t blocks = 5 + pick(25);
  for (std::size_t i = 0; i < blocks; ++i) {
    const double half = is_absolute ? 40 : 3;
    switch (pick(12)) {
      case 0:
        is_absolute = !is_absolute;
        text += is_absolute ? "G90\n" : "G91\n";
        break;
      case 1:
        text += "G3 X" + number_text(random, half) + " Y" + number_text(random, half) + " R60\n";
        break;
      case 2:
        text += "G2 I" + number_text(random, 5) + " J" + fixed_text(1 + random.in(0, 5), 3) + "\n";
        break;
      case 3:
        if (is_absolute)
          text += "G81 X" + number_text(random, half) + " Z" + fixed_text(-5 + random.in(-1, 1), 3) + " R2\nY" +
                  number_text(random, half) + "\nG80\nG0 Z20\n";
        break;
      case 4:
        text += "#1=[" + number_text(random, 5) + "*2+1]\nG1 X#1 Y[#1/2]\n";
        break;
      case 5:
        text += "G1 Z" + number_text(random, is_absolute ? 20 : 1) + "\n";
        break;
      case 6:
        text += "G20\nG1 X" + fixed_text(random.in(-1, 1), 4) + "\nG21\n";
        break;
      case 7:
        text += "N" + std::to_string(i + 10) + " G0 X" + number_text(random, half) + " (rapid)\n";
        break;
      case 8:
        text += "o" + std::to_string(100 + i) + " repeat [" + std::to_string(1 + pick(3)) + "]\nG1 Y" +
                number_text(random, half) + "\no" + std::to_string(100 + i) + " endrepeat\n";
        break;
      default:
        text += "G1 X" + number_text(random, half) + " Y" + number_text(random, half) + "\n";
        break;
    }
  }
  return text + "M2\n";
}

/// Removes, doubles or changes a word or a character.
std::string damaged(std::string text, Scatter& random) {
  std::vector<std::size_t> words;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] >= 'A' && text[i] <= 'Z') words.push_back(i);
  const std::size_t at = words[static_cast<std::size_t>(random.next() % words.size())];
  const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
  switch (random.next() % 5) {
    case 0:
      return text.erase(at, end - at);
    case 1:
      return text.insert(at, text.substr(at, end - at) + " ");
    case 2:
      text[at] = "GXYZFIJKRMNHSDPQL"[random.next() % 17];
      return text;
    case 3:
      return text.erase(at + 1, 1);
    default:
      text[std::min(at + 1, text.size() - 1)] = "0123456789.-"[random.next() % 12];
      return text;
  }
}

std::size_t programs() {
  const char* wanted = std::getenv("GOUGE_PROGRAMS");
  return wanted != nullptr ? static_cast<std::size_t>(std::strtoul(wanted, nullptr, 10)) : 100;
}

class Rs274 : public ::testing::Test {
 protected:
  void SetUp() override {
    if (oracle().empty()) GTEST_SKIP() << "rs274 of linuxcnc-uspace is not installed, and GOUGE_RS274 names none";
  }
};

TEST_F(Rs274, AgreesOnGeneratedPrograms) {
  const Folder folder;
  std::size_t read = 0;
  for (std::size_t seed = 1; seed <= programs(); ++seed) {
    Scatter random(seed);
    const std::string text = generated(random);
    const ReadOutcome outcome = read_program(text, "linuxcnc");
    const OracleRun run = folder.run(text);
    if (run.is_refused) {
      EXPECT_FALSE(can_be_clean(outcome)) << seed << "\n" << text;
      continue;
    }
    if (!can_be_clean(outcome)) continue;
    ++read;
    expect_same(*outcome.toolpath, run, "program " + std::to_string(seed) + "\n" + text);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(read, programs() / 2);
}

TEST_F(Rs274, NoDamagedProgramIsCleanWithOtherMotions) {
  const Folder folder;
  std::size_t refused = 0, open = 0, same = 0;
  for (std::size_t seed = 1; seed <= programs(); ++seed) {
    Scatter random(seed + 1000000);
    const std::string text = damaged(generated(random), random);
    const ReadOutcome outcome = read_program(text, "linuxcnc");
    if (!can_be_clean(outcome)) {
      ++open;
      continue;
    }
    const OracleRun run = folder.run(text);
    EXPECT_FALSE(run.is_refused) << "program " << seed << " is refused by LinuxCNC: " << run.last_line << "\n" << text;
    if (run.is_refused) {
      ++refused;
      continue;
    }
    ++same;
    expect_same(*outcome.toolpath, run, "program " + std::to_string(seed) + "\n" + text);
    if (HasFatalFailure()) return;
  }
  std::printf("%zu not checked, %zu with the same motions, %zu refused by LinuxCNC alone\n", open, same, refused);
}

TEST_F(Rs274, AgreesOnTheDemosOfLinuxcnc) {
  const std::string data = source_folder() + "/../shared/data/gcode/linuxcnc_table-rotary-tilting__";
  if (!std::filesystem::exists(data + "impeller-7bl-xyzac.ngc")) GTEST_SKIP() << "no ../shared/data";
  const Folder folder;
  for (const char* name : {"impeller-7bl-xyzac.ngc", "boat-xyzac.ngc"}) {
    std::ifstream file(data + name);
    std::stringstream bytes;
    bytes << file.rdbuf();
    std::string text = bytes.str();
    ProgramSetup setup;
    setup.machine = machine_of("linuxcnc-xyzac-trt");
    const Toolpath path = path_of_program(text, "linuxcnc", setup);
    // The interpreter alone does not have the remapped codes that switch the kinematics.
    for (const char* code : {"M428", "M429"}) {
      if (const std::size_t at = text.find(code); at != std::string::npos) text.erase(at, 4);
    }
    expect_same(path, folder.run(text), name);
  }
}

}  // namespace
}  // namespace gouge::test::rs274_test
