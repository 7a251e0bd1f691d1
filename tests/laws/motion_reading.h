#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/laws/expander_cycles.h"
#include "tests/laws/motion_expander.h"

// State of the mutation law's own reader between statements.

namespace gouge::laws {

struct OpenCycle {
  std::size_t line = 0;
  std::optional<StatedCycle> stated;  ///< nothing: not understood
  std::optional<Vec3> last_hole;      ///< part coordinates
  std::string contradicted;           ///< by what; empty: by nothing
  std::size_t holes = 0;
};

struct LooseFrame {
  Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), origin_mm = Vec3::Zero();
  bool operator==(const LooseFrame&) const = default;

  [[nodiscard]] Vec3 turned(const Vec3& v) const { return v.x() * x + v.y() * y + v.z() * z; }
  [[nodiscard]] Vec3 placed(const Vec3& v_mm) const { return turned(v_mm) + origin_mm; }
};

enum class Multax { unsaid, on, off };

struct MotionReading {
  std::optional<Pose> at;           ///< nothing: the next position stands alone
  std::optional<Pose> step_from;    ///< what GODLTA goes on from behind a change of tool
  Vec3 axis = Vec3::UnitZ();        ///< of the last position
  Vec3 plain_axis = Vec3::UnitZ();  ///< TLAXIS, in the frame of the file
  Multax multax = Multax::unsaid;
  double mm = 1;  ///< the unit in force
  bool is_unit_said = false;
  LooseFrame frame;
  bool has_frames = false;       ///< some block or section of the file states its frame
  bool is_frame_said = true;     ///< in this block or section
  bool is_block_open = true;     ///< NX: between TOOL PATH and END-OF-PATH
  bool has_block_moved = false;  ///< since its block or section began
  std::optional<OpenCycle> cycle;
  bool has_had_cycle = false;               ///< anywhere before
  bool is_behind_cycle = false;             ///< nothing moved since a cycle was ended
  bool is_rapid = false;                    ///< the next motion, which is no hole then
  std::size_t positions_without_cycle = 0;  ///< since the last cycle, tool or operation
  std::optional<StatedArc> arc;             ///< waits for its end
  std::optional<Vec3> direction;            ///< INDIRV waits for its TLON
  std::vector<Vec3> control;                ///< CNTRL since NURBS
  std::vector<double> knots;
  bool is_spline_open = false;
  bool is_compensated = false, is_cutter_centre = false;
  std::size_t positions_without_cutcom = 0;
  bool was_compensated = false;  ///< somewhere before
  std::optional<int> tool;
  std::string tool_name;           ///< NX: of the block
  std::string lost_word;           ///< a line that may have switched something; empty: none
  std::string unknown_word;        ///< before any motion; empty: none
  std::string tool_uncertainty;    ///< why unknown which tool is in; empty: it is known
  std::string cutter_uncertainty;  ///< why the cutter is unknown until the next CUTTER; empty: it is known
  std::string matrix_uncertainty;  ///< why the frame is unknown until the next whole matrix; empty: it is known
  std::optional<double> diameter_mm;
  std::optional<double> stated_diameter;  ///< of `$$-> CUTTER`, in the unit of the file
  bool is_cutter_new = false;             ///< nothing was cut with it yet
  std::set<int> library_tools;            ///< whose cutters no statement has to define
  std::map<int, double> known_tools;      ///< number -> diameter
  bool has_moved = false;
};

}  // namespace gouge::laws
