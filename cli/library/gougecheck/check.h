#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <gougecheck/mesh.h>
#include <gougecheck/path.h>
#include <gougecheck/report.h>
#include <gougecheck/tool.h>

namespace gougecheck {

enum class Rapids : std::uint8_t { straight, dogleg, skip };

/// A program that cut the stock before the path. It is not checked itself.
struct EarlierProgram {
  Path path;
  std::variant<Tool, ToolLibrary> tools;  ///< one tool for all moves, or a library
  /// Moves its coordinates into those of the path, "x,y,z" or "x,y,z,rx,ry,rz": mm, then degrees about the fixed axes X,
  /// Y, Z. Empty: they are the same.
  std::string place = {};
};

/// The material before the path. Rapids must be clear of what is left of it with the whole tool, and so must tools that do
/// not cut; all other moves with shank and holder. Method: docs/method/stock.md.
struct Stock {
  std::string shape = "box";      ///< "box", "box=2" (about the parts, larger by 2 mm), or "part+3" (an allowance)
  std::vector<Mesh> meshes = {};  ///< closed meshes in place of the shape
  std::vector<EarlierProgram> before = {};  ///< in the order of time
  double tolerance = 0.1;                   ///< depth of remaining stock that a body may have
  /// Cutters count as wider by this, so material thinner than twice this counts as removed. None: half the tolerance, at
  /// most 0.05.
  std::optional<double> resolution = {};
};

struct CheckOptions {
  double tolerance = 0.01;      ///< depth that a move may have
  double resolution = 0.001;    ///< gap between the certified bounds of a depth
  double stock_to_leave = 0;    ///< enlarges the cutter against parts
  double shank_clearance = 0;   ///< enlarges the shank; any depth in it is then a gouge
  double holder_clearance = 0;  ///< enlarges the holder
  double near_miss = 0;         ///< report moves that come nearer than this; 0: off
  Rapids rapids = Rapids::straight;
  /// Machine file, configuration of LinuxCNC, or "preset:NAME". Its control determines the motion of the tool axis, and
  /// its joint limits hold. Empty: the axis turns on the great circle.
  std::string machine = {};
  /// "vector", "axis", "documented", "any" or "joint", in place of the law of the control; all but "vector" require a machine.
  std::string feed_law = {};
  std::string rapid_law = {};  ///< the same for rapid moves, and "independent"
  /// Length from the gauge point to the tip, mm; "joint" and "independent" need it for a machine with a rotary head.
  std::optional<double> tool_length = {};
  double tool_length_slack = 0;  ///< the true length is at most this much longer or shorter
  /// Facts of joints in place of those of the machine file, such as "A=-30..120", "A=free"; "A=0,0,50" (a point of the
  /// axis); "A=3600" (rate per minute). Degrees, of linear joints mm.
  std::vector<std::string> joint_limits = {}, joint_points = {}, joint_rates = {};
  /// Part zero in machine coordinates with all joints at 0, "x,y,z" or "x,y,z,rx,ry,rz": mm, then degrees about the fixed
  /// axes X, Y, Z. Limits of linear joints then apply. Empty: not known, with axes parallel to those of the machine.
  std::string zero = {};
  double tip_tolerance = 0;   ///< maximum distance of the tip from its path that the control's smoothing may cause
  double axis_tolerance = 0;  ///< degrees, at most 10: maximum angle of the tool axis from its direction by the law
  unsigned threads = 0;       ///< 0: as many as the machine has; the result does not depend on the number
  /// Facts that are taken as stated: "path-unit", "placement", "tool=T3", ... (docs/guide/assumptions.md).
  std::vector<std::string> assume = {};
  bool strict = false;              ///< a path is clean only if no fact is taken by default
  std::optional<Stock> stock = {};  ///< of `check`; none: moves are not checked against remaining stock
};

/// Checks the whole motion of every move against the whole surface of every triangle.
///
/// Ensures  No gouge deeper than tolerance + resolution is missed, and every gouge has a witness. A clean verdict is
///          proved, and none of the facts on which it rests is contradicted or unknown. Meshes that were read without a
///          unit have the unit of the path.
/// Throws   Error: a length that is negative or not a number, or a fact with an unknown name. Code tool-ambiguous: one
///          tool is given for a path that calls several. For a machine: the errors of its file, and machine-law if no
///          law is stated.
/// Thread safe, like all functions here.
[[nodiscard]] GOUGECHECK_EXPORT Report check(const Path& path, const Scene& scene, const Tool& tool,
                                             const CheckOptions& options = {});
/// Checks with each of the path's tools from the library, by number or name, else by the path's own definition.
[[nodiscard]] GOUGECHECK_EXPORT Report check(const Path& path, const Scene& scene, const ToolLibrary& tools,
                                             const CheckOptions& options = {});

/// Contact of a tool at one position.
struct Contact {
  State state = State::clean;
  double depth = 0, depth_upper = 0;  ///< positive inside; depth <= true depth <= depth_upper
  Vec3 point = {0, 0, 0};             ///< the deepest point of the surface; meaningful if depth > 0
  Vec3 normal = {0, 0, 1};            ///< unit; the direction in which the tool must move away
  std::int64_t triangle = -1;         ///< face of its mesh in the given numbering; -1: depth is 0
  Body body = Body::cutter;           ///< the body of the tool that is nearest to the point
};

/// Depth of a tool, position by position, for a haptic loop or an optimiser. With tolerance 0 any depth is a gouge, and
/// its bounds are closed to the resolution. Made once, then queried from any number of threads.
class GOUGECHECK_EXPORT DepthQuery {
 public:
  /// The members tolerance, near_miss, rapids, machine, laws, stock and threads of `options` have no effect here. Throws like
  /// check.
  DepthQuery(const Scene& scene, const Tool& tool, const CheckOptions& options = {});

  /// Queries one position; the axis may have any length but 0. Allocates little, and takes microseconds to a
  /// millisecond. Throws Error for a position or axis that is not a number.
  [[nodiscard]] Contact at(const Vec3& tip, const Vec3& axis) const;
  /// Queries many positions, on `threads` threads (0: all). `axes` has as many elements as `tips`, or one for all.
  [[nodiscard]] std::vector<Contact> at(std::span<const Vec3> tips, std::span<const Vec3> axes,
                                        unsigned threads = 0) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

struct CorrectOptions {
  /// The strategy for all bodies: auto, weighted, normal, axis, tilt or trim.
  std::string strategy = "auto";
  double max_shift = 20;                 ///< maximum motion of a tip
  std::optional<double> max_side_shift;  ///< maximum motion across the tool axis; none: it depends on the depth
  double max_tilt = 30;                  ///< maximum angle to the programmed axis, in degrees
  double rapid_clearance = 1;            ///< distance that a changed rapid move keeps
};

/// A position that was changed or added.
struct Change {
  std::size_t move = 0;  ///< in the path before the correction
  bool is_inserted = false;
  Vec3 shift = {0, 0, 0};
  double tilt = 0;  ///< in degrees
  double depth_before = 0, depth_after = 0;
};

/// A move that still gouges or is buried.
struct Uncorrected {
  std::size_t move = 0;  ///< in the path before the correction
  double depth = 0;
  std::string reason;
};

struct Correction {
  Path path;      ///< with the same statements, except those changed
  Report before;  ///< on the path before the correction
  Report after;   ///< on `path`, which is checked like any other
  std::vector<Change> changes;
  std::vector<Uncorrected> uncorrected;
};

/// Returns a path without the gouges of `path`, as far as the limits allow. Every clean move stays clean, and no move
/// becomes deeper. Throws like check. Code usage: options.stock is given, which corrections do not cover.
[[nodiscard]] GOUGECHECK_EXPORT Correction correct(const Path& path, const Scene& scene, const Tool& tool,
                                                   const CheckOptions& options = {}, const CorrectOptions& how = {});
[[nodiscard]] GOUGECHECK_EXPORT Correction correct(const Path& path, const Scene& scene, const ToolLibrary& tools,
                                                   const CheckOptions& options = {}, const CorrectOptions& how = {});

}  // namespace gougecheck
