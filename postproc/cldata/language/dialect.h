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
  nci,
  gcode
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
  std::string_view id = "apt";             ///< value of Toolpath::dialect and of --dialect
  std::string_view title = "APT CL data";  ///< name in messages
  std::string_view format = "text";        ///< its row in the table of formats
  bool is_binary = false;                  ///< records without lines, decimals or units; else text
  bool has_apt_words = true;               ///< the file has the words of APT: arcs, holes and rapids can be rewritten
  CommentForm comments = CommentForm::none;
  bool has_end_word = true;  ///< a whole file ends with `end_name`
  std::string_view end_name = "END or FINI";
  /// The error for a file that ends within a statement.
  std::string_view cut_statement =
      "the file ends within a statement that a $ continues; expected its next line: the file is cut short";
  /// The error for a file without a position; empty: that of text.
  std::string_view no_position = {};
  bool is_fallback = false;        ///< whether it is the dialect of files without the marks of any dialect
  std::string_view other_id = {};  ///< id of another dialect of which the file has a mark too; empty: it has none
  std::size_t other_line = 0;      ///< line of that mark, with other_id

  // Positions.
  bool is_axis_modal = false;             ///< a position without axis keeps the last axis; else it means +Z or TLAXIS
  bool has_known_plain_axis = false;      ///< verified: a position without axis always means +Z
  bool locks_axis = false;                ///< under MULTAX/OFF a position without axis keeps the last axis stated
  bool states_multax = false;             ///< files state MULTAX before the first axis
  bool has_axes_under_multax = false;     ///< under MULTAX every position has an axis, and without it none has
  bool has_points_at_multax_off = false;  ///< six numbers under MULTAX/OFF are always two positions
  bool has_points_without_axis = false;   ///< six numbers that are not a position and a unit axis are two positions
  bool lists_run_along_arc = false;       ///< all positions of a list after a CIRCLE lie on it
  bool may_go_on_round = false;           ///< a single position may continue along the circle of the previous one

  // Frames, operations and tools.
  bool names_operations = false;       ///< has its own words for names of operations, so PPRINT is only text
  bool operations_are_blocks = false;  ///< each operation has its MCS
  bool has_blocks = false;             ///< TOOL PATH to END-OF-PATH: a block has its own frame, tool, axis and feed
  bool is_in_world = false;            ///< positions are in world coordinates, independent of CSYS
  bool has_camera_csys = false;   ///< CAMERA states the coordinate system of the machine, which is that of positions
  bool has_setups = false;        ///< ROTABL and TLAXIS state the orientation of the setup of the positions
  bool gohome_names_axes = true;  ///< in GOHOME/Z, Z is an axis, not a number
  bool pprint_includes_files = false;  ///< PPRINT INCLUD stands for the motion of another file
  bool inserts_are_names = false;      ///< INSERT has names of tools, setups and stock
  bool has_named_tools = false;        ///< tools may differ only in their name
  bool has_tool_angles = true;         ///< a CUTTER without angles is straight; if false, it may have any shape
  bool states_whole_length = false;    ///< the length of a cutter is never that of its flutes
  bool has_tip_diameter = false;       ///< the third number of CUTTER is the diameter of the tip

  // Arcs and cycles.
  ArcForm arc_form = ArcForm::apt;
  ArcSense arc_sense = ArcSense::unknown;  ///< sense of rotation about the vector
  ArcRule arc_rule = ArcRule::by_vector;
  bool has_flat_circles = false;  ///< CIRCLE may omit its vector: a circle perpendicular to Z, of either sense
  bool has_z_alone = false;       ///< writes no tool axis, and only circles about +Z
  CycleForm cycle_form = CycleForm::any;
  FeedInCycle feed_in_cycle = FeedInCycle::before_first_hole;

  // Writing.
  bool is_written = true;
  bool has_positions_alone = false;  ///< cannot state a tool, feed, rapid, CUTCOM or break
  CutterForm cutter_form = CutterForm::whole;
};

/// Returns all dialects of CL data, in the order for the user.
[[nodiscard]] std::span<const Dialect> all_dialects();

[[nodiscard]] const Dialect& dialect_of(DialectKind kind);

/// Returns the row of programs of a machine's control, which are no CL data; ProgramSetup states the control.
[[nodiscard]] const Dialect& gcode_dialect();

/// Returns the dialect with the name `id`, in upper or lower case, also without a leading "apt-". Returns nothing for
/// other names.
[[nodiscard]] std::optional<Dialect> dialect_called(std::string_view id);

/// Returns the dialect with the name `id`; plain APT if there is no such dialect.
[[nodiscard]] Dialect dialect_or_apt(std::string_view id);

/// Returns the names that `dialect_called` accepts: "nx-clsf, apt-catia, ...".
[[nodiscard]] std::string dialect_names();

/// Returns "nx-clsf, apt-catia, ...", the names of the dialects that can be written.
[[nodiscard]] std::string writable_dialect_names();

}  // namespace gouge
