#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gougecheck/mesh.h>
#include <gougecheck/path.h>
#include <gougecheck/report.h>
#include <gougecheck/tool.h>

namespace gougecheck {

enum class Rapids : std::uint8_t { straight, dogleg, skip };

struct CheckOptions {
  double tolerance = 0.01;      ///< depth a move may have
  double resolution = 0.001;    ///< certified gap
  double stock_to_leave = 0;    ///< grows the cutter against the part
  double shank_clearance = 0;   ///< grows the shank; any depth in it is then a gouge
  double holder_clearance = 0;  ///< grows the holder
  double near_miss = 0;         ///< report what comes nearer than this; 0: not requested
  Rapids rapids = Rapids::straight;
  /// Machine file, configuration of LinuxCNC, or "preset:NAME". Its control states the motion of the tool axis, and its
  /// joint limits hold. Empty: the axis turns on the great circle.
  std::string machine = {};
  /// "vector", "axis" or "joint", in place of the control's; all but "vector" require a machine.
  std::string feed_law = {};
  std::string rapid_law = {};  ///< the same of rapids, and "independent"
  /// From the gauge point to the tip, mm; "joint" and "independent" need it for a machine with a rotary head.
  std::optional<double> tool_length = {};
  unsigned threads = 0;  ///< 0: all; the result is the same at any number
  /// Facts to take as stated: "path-unit", "placement", "tool=T3", ... (docs/guide/assumptions.md).
  std::vector<std::string> assume = {};
  bool strict = false;  ///< clean only where no fact is taken by default
};

/// Checks the whole motion of every move against the whole surface of every triangle.
///
/// Ensures  no gouge deeper than tolerance + resolution is missed; every gouge has a witness; clean is proved, and no fact
///          that it rests on is contradicted or unknown. Meshes that were read without a unit are taken in the path's.
/// Throws   Error: a length that is negative or no number, a fact of another name; tool-ambiguous: one tool for a path
///          that calls several; for a machine: those of its file, and machine-law, where nothing states a law.
/// Thread safe, as everything here is.
[[nodiscard]] GOUGECHECK_EXPORT Report check(const Path& path, const Scene& scene, const Tool& tool,
                                             const CheckOptions& options = {});
/// The same with each of the path's tools from the library, by number or name, else by the path's own definition.
[[nodiscard]] GOUGECHECK_EXPORT Report check(const Path& path, const Scene& scene, const ToolLibrary& tools,
                                             const CheckOptions& options = {});

/// Contact of a tool at one position.
struct Contact {
  State state = State::clean;
  double depth = 0, depth_upper = 0;  ///< positive inside; depth <= true depth <= depth_upper
  Vec3 point = {0, 0, 0};             ///< of the surface, the deepest; meaningful where depth > 0
  Vec3 normal = {0, 0, 1};            ///< unit; the direction in which the tool must move away
  std::int64_t triangle = -1;         ///< face of its mesh as given; -1: depth is 0
  Body body = Body::cutter;           ///< of the tool, the nearest to the point
};

/// Depth of a tool, position after position: for a haptic loop or an optimiser. Tolerance 0: any depth is a
/// gouge, and its gap is closed to the resolution. Made once, then queried from any number of threads.
class GOUGECHECK_EXPORT DepthQuery {
 public:
  /// `options`: tolerance, near_miss, rapids, machine, laws and threads mean nothing here. Throws as check.
  DepthQuery(const Scene& scene, const Tool& tool, const CheckOptions& options = {});

  /// Queries one position; axis of any length but 0. Allocates little; microseconds to a millisecond. Throws Error for a
  /// position or axis that is no number.
  [[nodiscard]] Contact at(const Vec3& tip, const Vec3& axis) const;
  /// Queries many positions, on `threads` threads (0: all). Axes: as many as tips, or one for all.
  [[nodiscard]] std::vector<Contact> at(std::span<const Vec3> tips, std::span<const Vec3> axes,
                                        unsigned threads = 0) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

struct CorrectOptions {
  /// auto, weighted, normal, axis, tilt or trim, for all bodies.
  std::string strategy = "auto";
  double max_shift = 20;                 ///< no tip moves farther
  std::optional<double> max_side_shift;  ///< nor farther across the tool axis; none: by the depth
  double max_tilt = 30;                  ///< degrees from the programmed axis
  double rapid_clearance = 1;            ///< how far a rapid that must change keeps off
};

/// A position that was changed or added.
struct Change {
  std::size_t move = 0;  ///< of the path as it was
  bool is_inserted = false;
  Vec3 shift = {0, 0, 0};
  double tilt = 0;  ///< degrees
  double depth_before = 0, depth_after = 0;
};

/// A move that still gouges or is buried.
struct Uncorrected {
  std::size_t move = 0;  ///< of the path as it was
  double depth = 0;
  std::string reason;
};

struct Correction {
  Path path;      ///< with the same statements but for those changed
  Report before;  ///< of the path as it was
  Report after;   ///< of `path`, checked like any other
  std::vector<Change> changes;
  std::vector<Uncorrected> uncorrected;
};

/// A path without the gouges of `path`, as far as the limits allow. No clean move becomes anything else, none becomes
/// deeper. Throws as check.
[[nodiscard]] GOUGECHECK_EXPORT Correction correct(const Path& path, const Scene& scene, const Tool& tool,
                                                   const CheckOptions& options = {}, const CorrectOptions& how = {});
[[nodiscard]] GOUGECHECK_EXPORT Correction correct(const Path& path, const Scene& scene, const ToolLibrary& tools,
                                                   const CheckOptions& options = {}, const CorrectOptions& how = {});

}  // namespace gougecheck
