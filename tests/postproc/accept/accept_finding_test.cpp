#include "postproc/accept/accept_findings.h"
#include "postproc/accept/accepted.h"

#include <gtest/gtest.h>

#include "lib/path/motion_key.h"
#include "postproc/report/write_report.h"
#include "tests/postproc/report/small_report.h"

namespace gouge::accept_finding_test {
namespace {

const AcceptanceNote kNote = {"stock allowance", "R. Miller", "2026-11-23"};

struct Accepting : SmallReport {
  Accepting() {
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      path.moves[i].end.tip = Vec3(static_cast<double>(i * i), 0, 0);  // no two motions are alike
      path.moves[i].has_start = i > 0;
    }
    model.tools[0].identity = "ball 10";
  }
  [[nodiscard]] StoredResult stored() const { return *read_result("r.json", write_json(model)); }
  [[nodiscard]] static std::string error_of(const Result<Acceptance>& made) {
    return made ? "" : made.error().code + ": " + made.error().message;
  }
};

TEST(AcceptFinding, HoldsEachMotionWithItsDepth) {
  const Accepting report;
  const Result<Acceptance> made = accept_finding(report.stored(), 2, kNote);
  ASSERT_TRUE(made.has_value()) << Accepting::error_of(made);
  EXPECT_EQ(made->reason, "stock allowance");
  EXPECT_EQ(made->finding, "0.333 mm cutter T1 at (12.3, 4.5, 6.7), move 2");
  EXPECT_EQ(made->setup.tool, "ball 10");
  ASSERT_EQ(made->moves.size(), 2U);
  EXPECT_EQ(made->moves[0].motion, motion_key(report.path, 1, false));
  EXPECT_EQ(made->moves[1].depth_mm, 0.3333);
  EXPECT_EQ(made->moves[1].depth_upper_mm, 0.3338);
  EXPECT_EQ(made->moves[0].passes, 1U);
}

TEST(AcceptFinding, TheFileReadsBackAsWritten) {
  const Accepting report;
  const Acceptance made = *accept_finding(report.stored(), 2, kNote);
  const std::string text = write_accepted({made});
  const Result<std::vector<Acceptance>> read = read_accepted("a.json", text);
  ASSERT_TRUE(read.has_value()) << to_text(read.error());
  ASSERT_EQ(read->size(), 1U);
  EXPECT_EQ(write_accepted(*read), text);
  EXPECT_EQ(read->front().moves[1].depth_upper_mm, made.moves[1].depth_upper_mm);
  EXPECT_FALSE(find_change(made.setup, read->front().setup, LengthUnit::mm).has_value());
}

TEST(AcceptFinding, NeitherTwiceNorWhatIsOpen) {
  Accepting report;
  const Acceptance made = *accept_finding(report.stored(), 2, kNote);
  const AcceptedFindings again = accept_findings(report.stored(), {2}, kNote, {made});
  EXPECT_EQ(again.known, std::vector<std::size_t>{2});
  EXPECT_TRUE(again.made.empty());
  EXPECT_TRUE(Accepting::error_of(accept_finding(report.stored(), 9, kNote)).starts_with("usage"));
  const Result<Acceptance> buried = accept_finding(report.stored(), 1, kNote);
  EXPECT_TRUE(Accepting::error_of(buried).starts_with("accept-impossible")) << Accepting::error_of(buried);
  report.result.verdicts[2].depth_upper_mm = 0.4;
  EXPECT_NE(Accepting::error_of(accept_finding(report.stored(), 2, kNote)).find("not certified"), std::string::npos);
  report.result.verdicts[2].depth_upper_mm = 0.3338;
  report.model.tools[0].identity.clear();
  EXPECT_NE(Accepting::error_of(accept_finding(report.stored(), 2, kNote)).find("not defined"), std::string::npos);
}

// An entry of another program has one of two motions, so the finding needs an entry of its own.
TEST(AcceptFindings, AMotionThatIsAcceptedLeavesTheRestToAccept) {
  const Accepting report;
  const StoredResult stored = report.stored();
  Acceptance part = *accept_finding(stored, 2, kNote);
  part.toolpath = "other.apt";
  part.moves.pop_back();
  EXPECT_EQ(find_unaccepted(stored, {2}, {part}).at(0).why, "line 12 was not accepted (1 of 2 moves accepted)");
  const AcceptedFindings outcome = accept_findings(stored, {1, 2, 9}, kNote, {part});
  ASSERT_EQ(outcome.made.size(), 1U);
  EXPECT_EQ(outcome.made[0].moves.size(), 2U);
  EXPECT_EQ(outcome.refused.size(), 2U) << "a buried tool, and a number that is not there";
  EXPECT_EQ(outcome.kept, std::vector<std::size_t>{2});
  EXPECT_TRUE(find_unaccepted(stored, outcome.kept, {part, outcome.made[0]}).empty());
}

// Every number and word of an entry is held by its seal; order of keys and white space are not.
TEST(ReadAccepted, AnEditedEntryIsRefused) {
  const Accepting report;
  const std::string text = write_accepted({*accept_finding(report.stored(), 2, kNote)});
  const std::size_t first = text.find("\"accepted\""), last = text.find("\"seal\"");
  for (std::size_t at = first + 20; at < last; ++at) {
    if (std::isdigit(static_cast<unsigned char>(text[at])) == 0) continue;
    std::string changed = text;
    changed[at] = text[at] == '9' ? '8' : static_cast<char>(text[at] + 1);
    EXPECT_FALSE(read_accepted("a.json", changed).has_value()) << changed.substr(at - 20, 40);
  }
  std::string spaced = text;
  for (std::size_t at = 0; (at = spaced.find("\": ", at)) != std::string::npos; at += 5)
    spaced.replace(at, 3, "\" :  ");
  EXPECT_TRUE(read_accepted("a.json", spaced).has_value());
}

TEST(AcceptedSetup, EveryPartOfItVoids) {
  const Accepting report;
  const AcceptedSetup then = accept_finding(report.stored(), 2, kNote)->setup;
  const auto change = [&](auto&& edit) {
    AcceptedSetup now = then;
    edit(now);
    return find_change(then, now, LengthUnit::mm).value_or("");
  };
  EXPECT_EQ(change([](AcceptedSetup&) {}), "");
  EXPECT_EQ(change([](AcceptedSetup& s) { s.parts.emplace_back("x"); }), "the part is another one");
  EXPECT_EQ(change([](AcceptedSetup& s) { s.fixtures.emplace_back("x"); }), "the fixtures are others");
  EXPECT_EQ(change([](AcceptedSetup& s) { s.heads.emplace_back("x"); }), "the heads are others");
  EXPECT_NE(change([](AcceptedSetup& s) { s.placement += "x"; }), "");
  EXPECT_NE(change([](AcceptedSetup& s) { s.rapid = "dogleg"; }), "");
  for (double AcceptedSetup::*length :
       {&AcceptedSetup::tolerance_mm, &AcceptedSetup::resolution_mm, &AcceptedSetup::stock_to_leave_mm,
        &AcceptedSetup::shank_clearance_mm, &AcceptedSetup::holder_clearance_mm})
    EXPECT_NE(change([&](AcceptedSetup& s) { s.*length += 0.001; }), "");
}

}  // namespace
}  // namespace gouge::accept_finding_test
