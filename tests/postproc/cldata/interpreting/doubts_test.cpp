#include "postproc/cldata/interpreting/doubts.h"

#include <gtest/gtest.h>

#include "postproc/cldata/interpreting/block_state.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {
namespace {

using Range = std::pair<std::size_t, std::size_t>;

TEST(Doubts, ReportTheFirstOfThoseInForce) {
  Doubts doubts;
  EXPECT_EQ(doubts.reason(), nullptr);
  doubts.set(Doubt::machine_steps, "steps");
  doubts.set(Doubt::turning, "turning");
  EXPECT_STREQ(doubts.reason(), "turning");
  doubts.clear(Doubt::turning);
  EXPECT_STREQ(doubts.reason(), "steps");
  EXPECT_TRUE(doubts.has(Doubt::machine_steps));
  EXPECT_FALSE(doubts.has(Doubt::turning));
}

TEST(Doubts, RememberSinceWhenEachWasLastSwitched) {
  Doubts doubts;
  EXPECT_EQ(doubts.begin_run(Doubt::trans, 3), 0U);
  EXPECT_EQ(doubts.begin_run(Doubt::origin, 4), 0U);
  EXPECT_EQ(doubts.begin_run(Doubt::trans, 5), 3U);
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
}  // namespace gouge
