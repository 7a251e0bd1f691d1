#include "tests/laws/motion_coverage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace gouge::laws {
namespace {

constexpr double kSame_mm = 1e-4;     // roundings of unlike arithmetic
constexpr double kSameAxis = 2e-3;    // axes within 0.001 of unit length are made unit
constexpr double kSameArc_mm = 0.05;  // where start and end of an arc differ in radius by the rounding of the file

bool is_same(const Pose& a, const Pose& b) {
  return (a.tip - b.tip).norm() <= kSame_mm * (1 + 1e-2 * a.tip.norm()) && (a.axis - b.axis).norm() <= kSameAxis;
}

std::optional<CurvePoints> curve_of(const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  if (move.curve_kind == CurveKind::none || !move.has_start) return std::nullopt;
  if (move.curve_kind == CurveKind::arc) {
    const PathArc& arc = path.arcs[move.curve];
    return turned_points(arc.center, arc.axis, arc.sweep_rad, path.start_of(index).tip, move.end.tip);
  }
  CurvePoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double u = 0.25 * static_cast<double>(i + 1);
    for (const SplinePiece& piece : path.splines[move.curve].pieces) {
      if (u >= piece.u0 && u <= piece.u1) points[i] = piece.at((u - piece.u0) / (piece.u1 - piece.u0));
    }
  }
  return points;
}

bool is_same(const std::optional<CurvePoints>& a, const std::optional<CurvePoints>& b) {
  if (!a || !b) return !a && !b;
  for (std::size_t i = 0; i < a->size(); ++i) {
    if (((*a)[i] - (*b)[i]).norm() > kSameArc_mm) return false;
  }
  return true;
}

bool is_same_tool(const PossibleMotion& motion, const Toolpath& path, const Move& move) {
  if (move.tool == kNone) return !motion.tool;
  const PathTool& tool = path.tools[move.tool];
  if (motion.tool && tool.number && *motion.tool != *tool.number) return false;
  return !motion.diameter_mm || !tool.cutter || std::abs(tool.cutter->d_mm - *motion.diameter_mm) < 1e-6;
}

bool sweeps(const PossibleMotion& motion, const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  if (!is_same(motion.to, move.end) || !is_same_tool(motion, path, move)) return false;
  if (!motion.from) return true;
  return move.has_start && is_same(*motion.from, path.start_of(index)) && is_same(motion.curve, curve_of(path, index));
}

std::string text_of(const PossibleMotion& motion) {
  std::ostringstream text;
  const auto put = [&](const Pose& pose) {
    text << "(" << pose.tip.transpose() << "; " << pose.axis.transpose() << ")";
  };
  text << "line " << motion.line << ": ";
  if (motion.from) put(*motion.from);
  text << (motion.curve ? " ~> " : " -> ");
  put(motion.to);
  if (motion.tool) text << " tool " << *motion.tool;
  if (motion.diameter_mm) text << " diameter " << *motion.diameter_mm;
  return text.str();
}

}  // namespace

bool is_wholly_checked(const Toolpath& path, const std::set<int>& library_tools, bool is_tool_given) {
  return std::all_of(path.moves.begin(), path.moves.end(), [&](const Move& move) {
    if (!move.not_checked_reason.empty()) return false;
    if (is_tool_given) return true;
    if (move.tool == kNone) return false;
    const PathTool& tool = path.tools[move.tool];
    return tool.cutter.has_value() || (tool.number && library_tools.contains(*tool.number));
  });
}

std::optional<std::string> first_not_swept(const Expansion& expansion, const Toolpath& path) {
  std::multimap<std::size_t, std::size_t> moves_of_line;
  for (std::size_t i = 0; i < path.moves.size(); ++i) moves_of_line.emplace(path.moves[i].line, i);
  for (const PossibleMotion& motion : expansion.motions) {
    const bool is_still = motion.from && !motion.curve && is_same(*motion.from, motion.to);
    if (is_still) continue;
    const auto [begin, end] = moves_of_line.equal_range(motion.line);
    bool is_swept = std::any_of(begin, end, [&](const auto& entry) { return sweeps(motion, path, entry.second); });
    // A spline's motion is known where the next statement ends it.
    for (std::size_t i = 0; !is_swept && motion.curve && i < path.moves.size(); ++i)
      is_swept = path.moves[i].curve_kind == CurveKind::spline && sweeps(motion, path, i);
    if (!is_swept) return text_of(motion);
  }
  return std::nullopt;
}

}  // namespace gouge::laws
