#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// The dialect of a CAM system that a file follows, recognised by its content or stated by the user. A dialect is data:
// one row of traits for readers and writers. No code depends on the dialect itself. Evidence for each trait:
// docs/formats/.

namespace gouge {

enum class DialectKind : std::uint8_t {
  apt,
  nx_clsf,
  solidworks_cam,
  autodesk,
  camplete,
  catia,
  creo,
  nccs,
  clt,
  mori,
  goto_list,
  nccs_binary,
  nci
};

/// Kinds of comments that are statements.
enum class CommentForm : std::uint8_t {
  none,
  creo,  ///< `$$->` and `REMARK ->` are statements
  catia  ///< `$$ OPERATION NAME`, and rows of the matrix of `$$*CATIA0`
};

enum class ArcSense : std::uint8_t { right_handed, left_handed, unknown };

/// Arguments of a CIRCLE or MOVARC.
enum class ArcForm : std::uint8_t {
  apt,         ///< centre, vector, radius, and what NX writes after them
  with_sweep,  ///< like apt, or with an eighth number: the sweep in degrees
  ncl,         ///< NCCS NCL: any list that begins like apt
  nci          ///< Mastercam NCI: its reader makes the arguments
};

/// Sense of arcs with a stated vector.
enum class ArcRule : std::uint8_t {
  by_vector,
  by_vector_or_against,  ///< some posts reverse the vector of a clockwise arc, others keep it
  shorter_path           ///< the post-processor takes the shorter arc between two points, independent of the vector
};

/// Meaning of the words and numbers of a CYCLE.
enum class CycleForm : std::uint8_t { any, nx, depths, depths_without_rapto, creo, catia, clt, ncl, unknown };

/// Places where FEDRAT may occur while a cycle drills.
enum class FeedInCycle : std::uint8_t { anywhere, nowhere, before_first_hole };

/// The data of a cutter that the dialect can state.
enum class CutterForm : std::uint8_t { whole, with_diameter, without_angles, diameter_alone, none };

struct Dialect {
  DialectKind kind = DialectKind::apt;     ///< its row in the tables of dialects; it is used for nothing else
  std::string_view id = "apt";             ///< Toolpath::dialect, and what --dialect takes
  std::string_view title = "APT CL data";  ///< for people
  std::string_view format = "text";        ///< its row in the table of formats
  bool is_binary = false;                  ///< records without lines, decimals or units; else text
  bool has_apt_words = true;  ///< its file spells the words of APT: arcs, holes and rapids can be rewritten
  CommentForm comments = CommentForm::none;
  bool has_end_word = true;  ///< ends with `end_name`, so that a file without is cut short
  std::string_view end_name = "END or FINI";
  /// The error of a file that ends within a statement.
  std::string_view cut_statement =
      "the file ends within a statement that a $ continues; expected its next line: the file is cut short";
  /// The error of a file without a position; empty: that of text.
  std::string_view no_position = {};
  bool is_fallback = false;  ///< the dialect of a file without the marks of any

  // Positions.
  bool is_axis_modal = false;             ///< one without axis keeps the last one; else it means +Z or TLAXIS
  bool has_known_plain_axis = false;      ///< verified that one without axis means +Z whatever came before
  bool locks_axis = false;                ///< under MULTAX/OFF one without axis has the axis of the last one with it
  bool states_multax = false;             ///< MULTAX stands before the first axis
  bool has_axes_under_multax = false;     ///< every position has one under MULTAX, and none without it
  bool has_points_at_multax_off = false;  ///< six numbers under MULTAX/OFF are two positions, whatever they look like
  bool has_points_without_axis = false;   ///< six numbers that are not a position and unit axis are two positions
  bool lists_run_along_arc = false;       ///< all positions of a list behind a CIRCLE lie on it
  bool may_go_on_round = false;           ///< a position alone may go on along the circle of the one before it

  // Frames, operations and tools.
  bool names_operations = false;       ///< has words of its own for it, so that PPRINT is only text
  bool operations_are_blocks = false;  ///< each has its MCS
  bool has_blocks = false;             ///< TOOL PATH to END-OF-PATH: frame, tool, axis and feed are of a block
  bool is_in_world = false;            ///< positions are in world coordinates, whatever CSYS states
  bool has_camera_csys = false;        ///< CAMERA states the machine's coordinate system, in which positions are
  bool has_setups = false;             ///< ROTABL and TLAXIS state how the setup of the positions lies
  bool gohome_names_axes = true;       ///< GOHOME/Z: an axis, not a number
  bool pprint_includes_files = false;  ///< PPRINT INCLUD: the motion of another file stands here
  bool inserts_are_names = false;      ///< INSERT holds names of tools, setups and stock
  bool has_named_tools = false;        ///< the name distinguishes tools
  bool has_tool_angles = true;         ///< a CUTTER without angles is straight; else it may be of any shape
  bool has_tip_diameter = false;       ///< the third number of CUTTER is the diameter of the tip

  // Arcs and cycles.
  ArcForm arc_form = ArcForm::apt;
  ArcSense arc_sense = ArcSense::unknown;  ///< about the vector
  ArcRule arc_rule = ArcRule::by_vector;
  bool has_flat_circles = false;  ///< CIRCLE may leave its vector out: a circle across Z that runs either way
  bool has_z_alone = false;       ///< writes no tool axis, and circles about +Z only
  CycleForm cycle_form = CycleForm::any;
  FeedInCycle feed_in_cycle = FeedInCycle::before_first_hole;

  // Writing.
  bool is_written = true;
  bool has_positions_alone = false;  ///< no tool, feed, rapid, CUTCOM or break can be stated
  CutterForm cutter_form = CutterForm::whole;
};

/// Returns all dialects, in the order they are listed for the user.
[[nodiscard]] std::span<const Dialect> all_dialects();

[[nodiscard]] const Dialect& dialect_of(DialectKind kind);

/// Returns the dialect called `id`, upper or lower case, also without a leading "apt-"; nothing for other names.
[[nodiscard]] std::optional<Dialect> dialect_called(std::string_view id);

/// Returns the dialect called `id`; plain APT where there is no such dialect.
[[nodiscard]] Dialect dialect_or_apt(std::string_view id);

/// Returns "nx-clsf, apt-catia, ...", the names that `dialect_called` takes.
[[nodiscard]] std::string dialect_names();

}  // namespace gouge
