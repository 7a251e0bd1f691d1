#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "lib/path/toolpath.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {

/// A reason without the word and the line it names, which may differ between two files that mean the same.
inline std::string_view unnamed(std::string_view reason) { return reason.substr(0, reason.rfind(": ")); }

/// Two files that mean the same, to `within_mm`: every motion, and why it is not checked.
inline void expect_same_moves(const Toolpath& found, const Toolpath& expected, double within_mm = 1e-9) {
  ASSERT_EQ(found.moves.size(), expected.moves.size());
  for (std::size_t i = 0; i < found.moves.size(); ++i) {
    SCOPED_TRACE("move " + std::to_string(i));
    const Move& a = found.moves[i];
    const Move& b = expected.moves[i];
    ASSERT_EQ(a.kind, b.kind);
    // Facts that a binary file states by its records and its text leaves open.
    const bool is_open = b.not_checked_reason == Reasons::kNccsGoesOn;
    ASSERT_EQ(unnamed(a.not_checked_reason), unnamed(is_open ? a.not_checked_reason : b.not_checked_reason));
    ASSERT_LE((a.end.tip - b.end.tip).norm(), within_mm);
    ASSERT_LE((a.end.axis - b.end.axis).norm(), within_mm);
    ASSERT_EQ(a.has_start, b.has_start);
    ASSERT_NEAR(a.feed_mm, b.feed_mm, 1e-9);
    ASSERT_EQ(a.feed_unit, b.feed_unit);
    ASSERT_EQ(a.tool == kNone, b.tool == kNone);
    ASSERT_EQ(a.curve_kind, b.curve_kind);
    if (a.curve_kind != CurveKind::arc) continue;
    const PathArc& arc_a = found.arcs[a.curve];
    const PathArc& arc_b = expected.arcs[b.curve];
    ASSERT_LE((arc_a.center - arc_b.center).norm(), within_mm);
    ASSERT_LE((arc_a.axis - arc_b.axis).norm(), 1e-9);
    ASSERT_NEAR(arc_a.sweep_rad, arc_b.sweep_rad, 10 * within_mm);
  }
}

}  // namespace gouge
