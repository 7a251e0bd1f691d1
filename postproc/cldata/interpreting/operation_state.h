#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "postproc/cldata/interpreting/statement_context.h"

namespace gouge {

/// The operation of the positions that follow. One without a position is none.
class OperationState {
 public:
  explicit OperationState(StatementContext& in) : in_(in) {}

  void name(std::string text) {
    name_ = std::move(text);
    line_ = in_.line();
    is_new_ = true;
  }
  /// At a motion: its operation in Toolpath::operations, or kNone.
  [[nodiscard]] std::size_t resolve() {
    if (!std::exchange(is_new_, false)) return index_;
    index_ = in_.path.operations.size();
    in_.make_room(in_.path.operations);
    in_.path.operations.push_back({name_, line_});
    return index_;
  }
  [[nodiscard]] std::size_t index() const { return index_; }

 private:
  StatementContext& in_;
  std::string name_;
  std::size_t line_ = 0;
  bool is_new_ = false;
  std::size_t index_ = kNone;
};

}  // namespace gouge
