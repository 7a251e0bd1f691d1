#include "postproc/cldata/interpreting/uncertainties.h"

#include <gtest/gtest.h>

#include "postproc/cldata/interpreting/block_state.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge::uncertainties_test {
namespace {

using Range = std::pair<std::size_t, std::size_t>;

TEST(Uncertainties, ReportTheFirstOfThoseInForce) {
  Uncertainties uncertainties;
  EXPECT_EQ(uncertainties.reason(), nullptr);
  uncertainties.set(Uncertainty::machine_steps, "steps");
  uncertainties.set(Uncertainty::turning, "turning");
  EXPECT_STREQ(uncertainties.reason(), "turning");
  uncertainties.clear(Uncertainty::turning);
  EXPECT_STREQ(uncertainties.reason(), "steps");
  EXPECT_TRUE(uncertainties.has(Uncertainty::machine_steps));
  EXPECT_FALSE(uncertainties.has(Uncertainty::turning));
}

TEST(Uncertainties, RememberSinceWhenEachWasLastSwitched) {
  Uncertainties uncertainties;
  EXPECT_EQ(uncertainties.begin_run(Uncertainty::trans, 3), 0U);
  EXPECT_EQ(uncertainties.begin_run(Uncertainty::origin, 4), 0U);
  EXPECT_EQ(uncertainties.begin_run(Uncertainty::trans, 5), 3U);
}

TEST(Blocks, LoseTheirFrameWhereOthersStateOne) {
  BlockState blocks;
  blocks.begin(2);  // what stands before the first block is in none
  blocks.begin(4);
  blocks.note_frame(4);
  blocks.begin(6);
  blocks.note_frame(7);  // behind a position: not the block's
  blocks.require_frames();
  EXPECT_EQ(blocks.without_frame(9), (std::vector<Range>{{2, 4}, {6, 9}}));
}

TEST(Blocks, NeedNoFrameWhereNoneStatesOne) {
  BlockState blocks;
  blocks.begin(0);
  blocks.begin(4);
  EXPECT_TRUE(blocks.without_frame(9).empty());
}

TEST(ReasonKinds, HoldWithAndWithoutTheWordBehindThem) {
  EXPECT_EQ(kind_of(""), ReasonKind::none);
  EXPECT_EQ(kind_of(Reasons::kUnread), ReasonKind::may_be_unread);
  EXPECT_EQ(kind_of(std::string(Reasons::kUnread) + ": FOO in line 3"), ReasonKind::may_be_unread);
  EXPECT_EQ(kind_of(std::string(Reasons::kUnread) + " far away"), ReasonKind::not_understood);
  EXPECT_EQ(kind_of(Reasons::kTrans), ReasonKind::not_understood);
  EXPECT_TRUE(is_unread(Reasons::kCutShort));
  EXPECT_FALSE(is_unread(Reasons::kAfterRetract));
  EXPECT_TRUE(is_motion_known(Reasons::kAfterCutcom));
  EXPECT_FALSE(is_motion_known(Reasons::kRetractPlane));
}

}  // namespace
}  // namespace gouge::uncertainties_test
