#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"

// The facts on which a verdict rests, besides the motion and the surfaces. Each states how it is known. A verdict is
// clean only if none of them is open. docs/guide/assumptions.md has the table.

namespace gouge {

/// Source of a fact.
enum class Basis : std::uint8_t {
  stated,        ///< by a file or by the user
  derived,       ///< from evidence in the inputs
  by_default,    ///< nothing states otherwise
  contradicted,  ///< the inputs disagree about it
  unknown        ///< nothing establishes it
};
/// Returns "stated", "derived", "default", "contradicted" or "unknown".
[[nodiscard]] const char* basis_name(Basis basis);

/// Subject of a fact. Reports list them in this order.
enum class Subject : std::uint8_t {
  path_unit,     ///< unit of lengths in the toolpath
  dialect,       ///< dialect in which the toolpath file is read
  completeness,  ///< the toolpath file is complete
  statements,    ///< every statement of the file is understood
  frame,         ///< the frame of the file's positions
  motion_law,    ///< law of the motion of tip and axis between two positions
  machine,       ///< the kinematics of the machine; only with a machine
  smoothing,     ///< the distance by which the control leaves its law of motion; only with a machine
  tool,          ///< the definition of one tool
  holder,        ///< the part of one tool above its flutes
  head,          ///< turn and place of the bodies that move with the tool; only with heads
  mesh_unit,     ///< unit of the STL files
  solid,         ///< one STL file bounds a solid
  placement,     ///< the part lies where the toolpath expects it
  stock          ///< the material before the path, and what removes it; only with --stock
};
inline constexpr std::size_t kSubjects = 15;

/// Returns the name used by --assume and in reports: "path-unit", "dialect", "complete", "statements", "frame",
/// "motion-law", "machine", "smoothing", "tool", "holder", "head", "mesh-unit", "solid", "placement", "stock".
[[nodiscard]] const char* subject_name(Subject subject);
[[nodiscard]] std::optional<Subject> subject_called(std::string_view name);
/// Returns all subject names, separated by commas.
[[nodiscard]] std::string subject_names();

/// One fact on which a verdict rests.
struct Assumption {
  Subject subject = Subject::path_unit;
  std::string object = {};  ///< name of the object if the subject has several: "T3", "part.stl"; else empty
  Basis basis = Basis::by_default;
  std::string value = {};     ///< the assumed value: "mm", "ball D 10 of tools.json"
  std::string evidence = {};  ///< reason for the value, or contradicting evidence; one sentence without a full stop
  std::string remedy = {};    ///< for contradicted, unknown and default facts: how to establish the fact
  std::string code = {};      ///< code of the warning if the fact is open, as in docs/errors.md
  std::string file = {};      ///< file with the evidence; may be empty
  std::size_t line = 0;       ///< line in that file; 0: none
  bool is_open = false;       ///< set by settle: the verdict may not be clean
};
using Assumptions = std::vector<Assumption>;

/// A fact that the user vouches for (--assume): a subject, or one object of it.
struct Vouched {
  Subject subject = Subject::path_unit;
  std::string object = {};  ///< empty: all objects of the subject
};

/// Reads a text such as "tool" or "tool=T3". Returns nothing if no subject has this name.
[[nodiscard]] std::optional<Vouched> parse_vouched(std::string_view text);

/// Decides which facts are open.
///
/// Ensures  (1) A fact that the user vouches for becomes stated and keeps its evidence. (2) is_open is true for
///          contradicted and unknown facts, and with `is_strict` for defaults too. (3) The facts are in the order of
///          their subjects; those of one subject keep their order.
void settle(Assumptions& facts, const std::vector<Vouched>& vouched, bool is_strict);

/// Replaces the facts of `subject` in `to` by those in `from`.
void copy_facts(Subject subject, const Assumptions& from, Assumptions& to);

[[nodiscard]] bool has_open(const Assumptions& facts);

/// Returns one warning for each open fact, with the evidence and then the remedy.
[[nodiscard]] Diagnostics open_warnings(const Assumptions& facts);

/// Returns all facts in one line for people, such as "path-unit mm (stated), tool T1 ball D 10 (derived), ...".
[[nodiscard]] std::string assumptions_text(const Assumptions& facts);

}  // namespace gouge
