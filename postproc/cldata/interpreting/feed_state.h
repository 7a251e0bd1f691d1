#pragma once

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/parsing/feed_statement.h"

namespace gouge {

/// FEDRAT, which holds until the next one, and RAPID, which holds for one motion. One that the file never follows by a
/// motion says nothing.
class FeedState {
 public:
  explicit FeedState(StatementContext& in) : in_(in) {}

  // One without a unit after one per revolution: of which kind it is no file says.
  void take_fedrat(double mm_per_unit) {
    if (switches_inverse_time(in_.arguments)) return;
    feed_ = read_feed(in_.arguments, mm_per_unit);
    if (has_feed_per_turn_ && !has_feed_unit(in_.arguments)) feed_ = {0, FeedUnit::not_understood};
    has_feed_per_turn_ = has_feed_per_turn_ || feed_.unit == FeedUnit::per_revolution;
  }
  void begin_rapid() {
    is_rapid_ = true;
    rapid_statement_ = in_.index();
  }
  void end_rapid() { is_rapid_ = false; }
  void begin_block() { feed_ = {}; }

  [[nodiscard]] const Feed& feed() const { return feed_; }
  [[nodiscard]] bool is_rapid() const { return is_rapid_; }
  /// The last RAPID, or kNone.
  [[nodiscard]] std::size_t rapid_statement() const { return rapid_statement_; }

 private:
  StatementContext& in_;
  Feed feed_;
  bool has_feed_per_turn_ = false;  // a FEDRAT stated one: what one without a unit means is then not known
  bool is_rapid_ = false;
  std::size_t rapid_statement_ = kNone;
};

}  // namespace gouge
