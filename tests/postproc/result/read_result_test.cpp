#include <gtest/gtest.h>

#include "postproc/record/result_digest.h"
#include "postproc/report/write_report.h"
#include "postproc/result/stored_result.h"
#include "tests/postproc/report/small_report.h"

namespace gouge::read_result_test {
namespace {

std::string error_of(const std::string& bytes) {
  const Result<StoredResult> read = read_result("r.json", bytes);
  return read ? "" : to_text(read.error());
}

/// The report's JSON with `from` replaced by `to`, and the digest of the new bytes.
std::string rewritten(const std::string& bytes, const std::string& from, const std::string& to) {
  std::string text = bytes.substr(0, bytes.rfind(",\n \"digest\"")) + "\n}\n";
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return with_digest(text.replace(at, from.size(), to));
}

TEST(ReadResult, WhatWasWrittenIsRead) {
  SmallReport report;
  report.model.tools[0].identity = "flat 10";
  const Result<StoredResult> read = read_result("r.json", write_json(report.model));
  ASSERT_TRUE(read.has_value()) << to_text(read.error());
  EXPECT_EQ(read->file, "r.json");
  EXPECT_EQ(read->record.toolpath.file, "path.apt");
  EXPECT_EQ(read->record.verdict, "gouges");
  EXPECT_EQ(read->options.tolerance_mm, report.model.options.tolerance_mm);
  EXPECT_EQ(read->record.listed_motions(), 8U);
  ASSERT_EQ(read->record.tools.size(), 2U);
  EXPECT_EQ(read->record.tools[0].identity, "flat 10");
  EXPECT_EQ(read->contents_of("toolpath"), report.model.inputs[0].checksum + "\n");
  // A near miss is no finding of it; the buried tool is the worst.
  ASSERT_EQ(read->findings.size(), 2U);
  const EventRecord& gouge = read->findings[0];
  EXPECT_EQ(gouge.state, MoveState::gouge);
  EXPECT_EQ(gouge.worst_move, 2U);
  EXPECT_EQ(read->findings[1].state, MoveState::buried);
  EXPECT_EQ(read->moves_of(gouge).size(), 2U);
  EXPECT_EQ(read->worst_of(gouge).depth_mm, 0.3333);
  EXPECT_EQ(read->worst_of(gouge).depth_upper_mm, 0.3338);
  EXPECT_EQ(read->worst_of(gouge).witness->point_mm, Vec3(12.3, 4.5, 6.7));
  EXPECT_EQ(read->find_move(0), nullptr) << "clean";
  EXPECT_EQ(read->find_move(7)->state, MoveState::not_checked);
}

TEST(ReadResult, LengthsOfAnInchPathAreInMillimetres) {
  SmallReport report;
  report.path.unit = LengthUnit::inch;
  const Result<StoredResult> read = read_result("r.json", write_json(report.model));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->record.unit, LengthUnit::inch);
  EXPECT_NEAR(*read->worst_of(read->findings[0]).depth_mm, 0.3333, 1e-15);
  EXPECT_NEAR(read->worst_of(read->findings[0]).witness->point_mm.x(), 12.3, 1e-13);
}

TEST(ReadResult, RunsSayWhichMovesAreOfOneOperationAndTool) {
  const SmallReport report;
  const Result<StoredResult> read = read_result("r.json", write_json(report.model));
  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->record.runs.size(), 2U);
  EXPECT_EQ(read->run_of(5).operation, "finish <1>");
  EXPECT_EQ(read->run_of(6).first_move, 6U);
  EXPECT_EQ(read->moves_like(read->record.runs[0], 4, 8), 2U);
}

TEST(ReadResult, EveryByteIsHeldByTheDigest) {
  const SmallReport report;
  const std::string bytes = write_json(report.model);
  const std::size_t end = bytes.rfind(",\n \"digest\"");
  for (std::size_t at = 0; at < end; at += 97) {
    std::string changed = bytes;
    changed[at] = changed[at] == '1' ? '2' : '1';
    const Result<StoredResult> read = read_result("r.json", changed);
    ASSERT_FALSE(read.has_value()) << at;
    EXPECT_TRUE(read.error().code == "result-edited" || read.error().code == "result-syntax" ||
                read.error().code == "result-format" || read.error().code == "result-duplicate-key")
        << at << " " << read.error().code;
  }
}

TEST(ReadResult, WhatContradictsItselfIsRefusedWithItsLine) {
  const SmallReport report;
  const std::string bytes = write_json(report.model);
  ASSERT_EQ(error_of(rewritten(bytes, "\"gouges\"", "\"gouges\"")), "");
  const auto expect_error = [&](const std::string& from, const std::string& to, const std::string& words) {
    const std::string error = error_of(rewritten(bytes, from, to));
    EXPECT_NE(error.find("r.json:"), std::string::npos) << error;
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_NE(error.find("[result-field]"), std::string::npos) << error;
  };
  expect_error("\"depth_upper\": 0.3338", "\"depth_upper\": 0.3", "no less than the depth");
  expect_error("\"last_move\": 2", "\"last_move\": 1", "a move of the finding");
  expect_error("\"tool_index\": 0", "\"tool_index\": 7", "an index into 'tools'");
  expect_error("\"depth\": 0.25", "\"depth\": -0.25", "a length of 0 or more");
  expect_error("\"state\": \"gouge\"", "\"state\": \"goudge\"", "");
}

TEST(ReadResult, OtherFilesAndVersionsAreRefused) {
  const SmallReport report;
  const std::string bytes = write_json(report.model);
  EXPECT_NE(error_of("[]").find("[result-format]"), std::string::npos);
  EXPECT_NE(error_of("{}").find("[result-format]"), std::string::npos);
  EXPECT_NE(error_of("{\"format\": \"gougecheck-report\", \"format\": 1}").find("[result-duplicate-key]"),
            std::string::npos);
  const std::string newer = rewritten(bytes, "\"format_version\": 1", "\"format_version\": 2");
  EXPECT_NE(error_of(newer).find("of another version of the format"), std::string::npos);
  const std::string without = bytes.substr(0, bytes.rfind(",\n \"digest\"")) + "\n}\n";
  EXPECT_NE(error_of(without).find("of an older version of gougecheck"), std::string::npos);
}

TEST(StoredFinding, IsToldAsInTheReport) {
  const SmallReport report;
  const Result<StoredResult> read = read_result("r.json", write_json(report.model));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(stored_finding_text(*read, read->findings[0]), "0.333 mm cutter T1 at (12.3, 4.5, 6.7), move 2");
  EXPECT_EQ(stored_tool_label("12"), "T12");
  EXPECT_EQ(stored_tool_label(""), "the unnamed tool");
}

}  // namespace
}  // namespace gouge::read_result_test
