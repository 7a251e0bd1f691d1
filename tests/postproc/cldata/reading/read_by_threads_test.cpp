// A long file whose statements a second thread reads ahead means the same as one that one thread reads.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "lib/base/files.h"
#include "lib/base/parallel.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/support/source_folder.h"

namespace gouge::read_by_threads_test {
namespace {

constexpr std::size_t kLong = std::size_t{3} << 19U;  // more than read_cl_data reads without a second thread

ReadOutcome read_by(unsigned threads, const std::string& name, const std::string& text) {
  set_default_threads(threads);
  ReadOutcome outcome = read_toolpath(name, text);
  set_default_threads(0);
  return outcome;
}

std::string described(const Diagnostics& all) {
  std::string text;
  for (const Diagnostic& one : all) text += to_text(one) + "\n";
  return text;
}

std::string described(const Move& move) {
  std::string text = std::string(kind_name(move.kind)) + " " + std::string(move.not_checked_reason);
  for (const double x : {move.end.tip.x(), move.end.tip.y(), move.end.tip.z(), move.end.axis.x(), move.end.axis.y(),
                         move.end.axis.z(), move.feed_mm, static_cast<double>(move.spindle_rpm)})
    text += " " + std::to_string(x);
  for (const std::size_t i : {std::size_t{move.line}, std::size_t{move.statement}, std::size_t{move.tool},
                              std::size_t{move.operation}, std::size_t{move.curve}})
    text += " " + std::to_string(i);
  for (const auto part :
       {static_cast<int>(move.curve_kind), static_cast<int>(move.feed_unit), static_cast<int>(move.cover),
        static_cast<int>(move.has_start), static_cast<int>(move.is_linked), static_cast<int>(move.runs_joints)})
    text += " " + std::to_string(part);
  return text;
}

void expect_same(const ReadOutcome& a, const ReadOutcome& b) {
  EXPECT_EQ(described(a.errors), described(b.errors));
  ASSERT_EQ(a.toolpath.has_value(), b.toolpath.has_value());
  if (!a.toolpath) return;
  EXPECT_EQ(described(a.toolpath->notes), described(b.toolpath->notes));
  EXPECT_EQ(a.toolpath->words_not_understood, b.toolpath->words_not_understood);
  ASSERT_EQ(a.toolpath->statements.size(), b.toolpath->statements.size());
  ASSERT_EQ(a.toolpath->moves.size(), b.toolpath->moves.size());
  for (std::size_t i = 0; i < a.toolpath->moves.size(); ++i)
    ASSERT_EQ(described(a.toolpath->moves[i]), described(b.toolpath->moves[i])) << "move " << i;
}

// A file becomes long by its own text again and again, so each of its statements follows each state it leaves.
TEST(ReadByThreads, EveryFileOfTheCorpusMeansTheSame) {
  std::size_t files = 0, read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + "/tests/corpus")) {
    if (!entry.is_regular_file()) continue;
    const Result<std::string> bytes = read_file(entry.path());
    ASSERT_TRUE(bytes) << entry.path();
    if (bytes->empty()) continue;
    SCOPED_TRACE(entry.path());
    std::string text;
    while (text.size() < kLong) text += *bytes + "\n";
    const ReadOutcome alone = read_by(1, entry.path(), text);
    expect_same(read_by(2, entry.path(), text), alone);
    ++files;
    if (alone.toolpath) ++read;
  }
  EXPECT_GT(files, 50U);
  EXPECT_GT(read, 20U);
}

}  // namespace
}  // namespace gouge::read_by_threads_test
