#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "lib/base/result.h"

namespace gouge::detail {

/// Runs `work`; meanwhile CGAL neither prints nor aborts. Returns an error (cgal-failed) if CGAL throws an exception.
/// CGAL's text ("p1p2p3_2d!=COLLINEAR") is left out, because it does not help a user with a part to check. An exception
/// for lack of memory passes through, because it is not an error of the mesh.
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
