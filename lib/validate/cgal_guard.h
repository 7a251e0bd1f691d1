#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "lib/base/result.h"

namespace gouge::detail {

/// Runs `work`, in which CGAL neither prints nor aborts. Error (cgal-failed) where CGAL threw one; its own words
/// ("p1p2p3_2d!=COLLINEAR") are of no use to a user with a part to check. Running out of memory is not the mesh's
/// fault: it goes on.
[[nodiscard]] Outcome run_guarded(const std::string& task, const std::function<void()>& work);

/// Returns the value of `work`, or the error of run_guarded.
template <class Value, class Work>
Result<Value> guarded(const std::string& task, const Work& work) {
  std::optional<Result<Value>> result;
  const Outcome done = run_guarded(task, [&] { result.emplace(work()); });
  if (!done) return done.error();
  return *std::move(result);
}

}  // namespace gouge::detail
