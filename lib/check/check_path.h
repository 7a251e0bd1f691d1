#pragma once

#include <functional>
#include <vector>

#include "lib/check/check_move.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// Told after each finished chunk of moves: done and total, from any thread but never from two at once.
using ProgressCall = std::function<void(std::size_t done, std::size_t total)>;

/// Checks every move of a toolpath.
///
/// Shape    `tools[k]` belongs to toolpath.tools[k]; null or missing: that tool has no definition, its moves are
///          not checked.
/// Ensures  (1) one verdict a move, in order; the counts add up to the moves. A move whose start or curve the path
///          does not hold (one cut out of another path) is not checked.
///          (2) the same result, bit for bit, at any number of threads.
///          (3) a move is clean only if every body of the tool is proved outside of all solids during it, and
///              buried only if one is proved inside; else it is not certified (buried.h).
/// Source   design of docs/method.md; docs/algorithms/certified_sweep.md.
[[nodiscard]] CheckResult check_path(const Toolpath& toolpath, const std::vector<const ToolForms*>& tools,
                                     const PreparedScene& scene, const CheckOptions& options,
                                     const ProgressCall& progress = {});

/// Neighbouring moves of one state, tool, operation, body and counterpart as one event each, in path order; buried ones
/// only with the same reason.
/// Clean and not-checked moves make none.
[[nodiscard]] std::vector<Event> gather_events(const Toolpath& toolpath,
                                               const std::vector<MoveVerdict>& verdicts);

/// Counts the states and finds the worst move anew, once verdicts have been changed.
void count_states(CheckResult& result);

/// The motion of a move of `toolpath`, along its arc or spline where it has one; rapids in the mode asked
/// for.
[[nodiscard]] Motion motion_of(const Toolpath& toolpath, std::size_t move, RapidMode rapid);

/// The straight motion to a position alone from where the tool was before it (Move::is_linked); nothing where the path
/// has no link there. It is not what the file says; that it is clean is what the check asks of it.
[[nodiscard]] std::optional<Motion> link_of(const Toolpath& toolpath, std::size_t index);

/// Why a position alone is not checked whose link is not clean. Requires link_of(toolpath, index).
[[nodiscard]] std::string unswept_link_reason(const Toolpath& toolpath, std::size_t index);

}  // namespace gouge
