#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/paged_memory.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/write_corrected.h"
#include "postproc/formats/write_toolpath.h"

// How much memory reading takes at its peak, for each byte of the file: every allocation is counted. The
// files are the worst of their kind, of statements as short as they can be. Large arrays are in files here, as they are
// for long paths: of paths with small arrays, plain memory is bounded by PagedLimits.

namespace {

std::atomic<std::size_t> in_use{0}, peak{0};

void* counted_new(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) std::abort();
  const std::size_t now = in_use += malloc_usable_size(memory);
  if (now > peak) peak = now;
  return memory;
}

void counted_delete(void* memory) {
  in_use -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return counted_new(size); }
void* operator new[](std::size_t size) { return counted_new(size); }
void operator delete(void* memory) noexcept { counted_delete(memory); }
void operator delete[](void* memory) noexcept { counted_delete(memory); }
void operator delete(void* memory, std::size_t) noexcept { counted_delete(memory); }
void operator delete[](void* memory, std::size_t) noexcept { counted_delete(memory); }

namespace gouge::reading_memory_test {
namespace {

constexpr std::size_t kBytes = 8 << 20;
const PagedLimits kLimitsBefore = set_paged_limits({std::size_t{64} << 20U, std::size_t{512} << 20U, 0});

std::string repeated(const std::function<std::string(std::size_t)>& piece) {
  std::string text;
  text.reserve(kBytes + 100);
  for (std::size_t i = 0; text.size() < kBytes; ++i) text += piece(i);
  text.shrink_to_fit();
  return text;
}

std::string repeated(const std::string& piece) {
  return repeated([&](std::size_t) { return piece; });
}

/// Peak of the memory while `text` is read and held, the text included, divided by its size. A text that is no file is
/// copied once.
double memory_for_each_byte(std::string text) {
  const std::size_t size = text.size();
  const std::size_t before = in_use - malloc_usable_size(text.data());
  peak = in_use.load();
  const ReadOutcome outcome = read_toolpath("long.apt", std::move(text));
  return static_cast<double>(peak - before) / static_cast<double>(size);
}

std::string number(std::size_t i) { return std::to_string(i); }

std::string list_of_positions(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += "1,1,1,";
  return text;
}

/// An NX spline of as many control points and different knots as fit.
std::string smooth_spline() {
  constexpr std::size_t kPoints = 300000;
  std::string knots, points;
  for (std::size_t i = 1; i <= kPoints - 3; ++i) {
    const std::string digits = number(i);
    knots += "KNOT/." + std::string(6 - digits.size(), '0') + digits + "\n";
  }
  for (std::size_t i = 0; i < kPoints; ++i) points += "CNTRL/0,0,1\n";
  return "TOOL PATH/A,TOOL,B\nGOTO/0,0,0\nNURBS/\n" + knots + "KNOT/1\n" + points + "GOTO/0,0,0\nEND-OF-PATH\n";
}

std::string binary_positions() {
  std::string text;
  for (std::size_t i = 0; i < 200000; ++i) text += "GOTO/1,1,1\n";
  const ReadOutcome outcome = read_toolpath("short.apt", text);
  return write_toolpath(*outcome.toolpath, dialect_of(DialectKind::nccs_binary)).value().bytes;
}

struct LongFile {
  const char* name;
  std::function<std::string()> text;
  double most;  ///< bytes of memory for each byte of the file
};

std::vector<LongFile> long_files() {
  return {
      {"five axes", [] { return repeated("GOTO/12.345678,-1.234567,0.123456,0.600000,0.000000,0.800000\n"); }, 4.5},
      {"shortest positions", [] { return repeated("GOTO/1,1,1\n"); }, 12},
      {"positions in one statement", [] { return "GOTO/" + repeated("1,1,1,"); }, 12},
      {"positions on continued lines", [] { return "GOTO/" + repeated("1,1,1,$\n"); }, 12},
      {"lists of positions", [] { return repeated("GOTO/" + list_of_positions(10000) + "1,1,1\n"); }, 20},
      {"commas", [] { return "GOTO/" + repeated(","); }, 12},
      {"continued lines of nothing", [] { return "GOTO/1,1,1$\n" + repeated("$\n"); }, 12},
      {"blank lines", [] { return "GOTO/1,1,1\n" + repeated("\n"); }, 12},
      {"words", [] { return "GOTO/1,1,1\n" + repeated("A\n"); }, 12},
      {"different words",
       [] { return repeated([](std::size_t i) { return "A" + number(i) + "\n"; }) + "GOTO/1,1,1\n"; }, 12},
      {"errors", [] { return "GOTO/1,1,1\n" + repeated("GOTO/A\n"); }, 12},
      {"operations", [] { return repeated("PPRINT A\nGOTO/1,1,1\n"); }, 12},
      {"tools", [] { return repeated([](std::size_t i) { return "LOADTL/" + number(i) + "\nGOTO/1,1,1\n"; }); }, 12},
      {"cutters", [] { return repeated([](std::size_t i) { return "CUTTER/" + number(i + 1) + "\nGOTO/1,1,1\n"; }); },
       12},
      {"wrong cutters", [] { return "GOTO/1,1,1\n" + repeated("CUTTER/0\n"); }, 12},
      // an arc of unknown sense is read either way round
      {"arcs", [] { return repeated("CIRCLE/0,0,0,0,0,1,1\nGOTO/1,0,0\nGOTO/0,1,0\n"); }, 16},
      // a hole is four moves
      {"holes", [] { return "CYCLE/DRILL,DEPTH,3,CLEAR,2,MMPM,1\n" + repeated("GOTO/1,1,1\nGOTO/0,1,1\n"); }, 42},
      {"tapes", [] { return repeated("TOOL PATH/A,TOOL,B\nGOTO/1,1,1\n"); }, 12},
      {"splines", [] { return repeated("GOTO/0,0,0\nNURBS/\nKNOT/1\nCNTRL/0,0,1\nCNTRL/0,0,2\nCNTRL/0,0,3\n"); }, 12},
      {"one spline", [] { return "TOOL PATH/A,TOOL,B\nGOTO/0,0,0\nNURBS/\n" + repeated("CNTRL/0,0,1\n"); }, 12},
      {"one smooth spline", smooth_spline, 12},
      {"Mastercam NCI", [] { return repeated("0\n0 1 1 1 1\n"); }, 13},
      {"Mastercam NCI arcs", [] { return repeated("0\n0 1 0 0 1\n3\n41 0 0 1 0 0 0 1\n1\n40 0 1 0 1\n"); }, 15},
      {"Mastercam NCI five axes", [] { return repeated("11\n0 0 0 0 0 1 1\n"); }, 13},
      {"binary NCCS", binary_positions, 12},
      {"comments", [] { return "GOTO/1,1,1\n" + repeated("$$\n"); }, 12},
  };
}

// The file is read once more, to know the state each position was read in.
TEST(WritingMemory, IsASmallMultipleOfTheFileToo) {
  const std::string shortest = repeated("GOTO/1,1,1\n");
  const std::string usual = repeated("GOTO/12.345678,-1.234567,0.123456,0.600000,0.000000,0.800000\n");
  for (const auto& [text, most] : {std::pair{shortest, 22.0}, std::pair{usual, 5.0}}) {
    const ReadOutcome outcome = read_toolpath("long.apt", text);
    peak = in_use.load();
    const std::size_t before = in_use;
    const Result<std::string> written = write_corrected(*outcome.toolpath, {});
    EXPECT_TRUE(written.has_value() && *written == text);
    EXPECT_LT(static_cast<double>(peak - before) / static_cast<double>(text.size()), most);
  }
}

TEST(ReadingMemory, NoFileNeedsMoreThanASmallMultipleOfItsSize) {
  for (const LongFile& file : long_files()) {
    const double found = memory_for_each_byte(file.text());
    EXPECT_LT(found, file.most) << file.name;
  }
}

}  // namespace
}  // namespace gouge::reading_memory_test
