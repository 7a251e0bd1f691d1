#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"

// The facts that a verdict rests on beside the motion and the surfaces. Each names how it is known. A verdict is clean
// only if none of them is open. docs/guide/assumptions.md has the table.

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
  path_unit,     ///< unit of the toolpath's lengths
  dialect,       ///< how the toolpath file is read
  completeness,  ///< the toolpath file is whole
  statements,    ///< every statement of it is understood
  frame,         ///< the frame of its positions
  motion_law,    ///< tip and axis between two positions
  tool,          ///< the definition of one tool
  holder,        ///< the part above its flutes
  mesh_unit,     ///< unit of the STL files
  solid,         ///< one STL file bounds a solid
  placement      ///< the part lies where the toolpath expects it
};
inline constexpr std::size_t kSubjects = 11;

/// Returns the name of --assume and of reports: "path-unit", "dialect", "complete", "statements", "frame",
/// "motion-law", "tool", "holder", "mesh-unit", "solid", "placement".
[[nodiscard]] const char* subject_name(Subject subject);
[[nodiscard]] std::optional<Subject> subject_called(std::string_view name);
/// Returns all names, separated by commas.
[[nodiscard]] std::string subject_names();

/// One fact.
struct Assumption {
  Subject subject = Subject::path_unit;
  std::string object = {};  ///< its subject where there are several: "T3", "part.stl"; else empty
  Basis basis = Basis::by_default;
  std::string value = {};     ///< the assumed value: "mm", "ball D 10 of tools.json"
  std::string evidence = {};  ///< why, or what contradicts it; one sentence without a full stop
  std::string remedy = {};    ///< of contradicted, unknown and default facts: how to establish it
  std::string code = {};      ///< of the warning where it is open, as in docs/errors.md
  std::string file = {};      ///< where the evidence is; may be empty
  std::size_t line = 0;       ///< of that file; 0: none
  bool is_open = false;       ///< set by settle: the verdict may not be clean
};
using Assumptions = std::vector<Assumption>;

/// A fact that the user vouches for (--assume): a subject, or one object of it.
struct Vouched {
  Subject subject = Subject::path_unit;
  std::string object = {};  ///< empty: all objects of the subject
};

/// Reads "tool" or "tool=T3". Returns nothing where the subject has no such name.
[[nodiscard]] std::optional<Vouched> parse_vouched(std::string_view text);

/// Decides which facts are open.
///
/// Ensures  (1) a fact that the user vouches for becomes stated and keeps its evidence. (2) is_open holds for
///          contradicted and unknown facts, and with `is_strict` for defaults too. (3) the facts stand in the order of
///          their subjects, and those of one subject as given.
void settle(Assumptions& facts, const std::vector<Vouched>& vouched, bool is_strict);

/// Replaces the facts of `subject` in `to` by those in `from`.
void copy_facts(Subject subject, const Assumptions& from, Assumptions& to);

[[nodiscard]] bool has_open(const Assumptions& facts);

/// Returns one warning for each open fact: the evidence, then the remedy.
[[nodiscard]] Diagnostics open_warnings(const Assumptions& facts);

/// Returns all facts in one line for people: "path-unit mm (stated), tool T1 ball D 10 (derived), ...".
[[nodiscard]] std::string assumptions_text(const Assumptions& facts);

}  // namespace gouge
