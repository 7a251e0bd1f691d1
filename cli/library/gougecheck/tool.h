#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gougecheck/types.h>

namespace gougecheck {

/// A cylinder or frustum of a shank or holder. Each segment stands on the one below.
struct ToolSegment {
  double lower_diameter = 0, upper_diameter = 0, length = 0;
};

/// A tool assembly: one solid of revolution about the tool axis, with z = 0 at the tip and z growing towards the
/// spindle. Immutable.
class GOUGECHECK_EXPORT Tool {
 public:
  /// Builds a tool with the names of docs/formats/tool_library.md: Tool("ball", {{"diameter", 10}, {"length", 30}}).
  /// An empty `name` stands for the shape.
  /// Throws   Error: an unknown shape or dimension, or a dimension that is missing or contradicts another.
  Tool(std::string_view shape, const std::map<std::string, double>& dimensions,
       const std::vector<ToolSegment>& shank = {}, const std::vector<ToolSegment>& holder = {},
       std::string_view name = {});

  /// Reads the JSON of one tool ({"units": "mm", "cutter": {...}, ...}) or of a library. For a library, `name` selects
  /// the tool by name or number; empty: its only one.
  /// Throws   Error: those of the tool library; library-which if it has several tools, or none with that name.
  [[nodiscard]] static Tool from_json(std::string_view json, std::string_view name = {});

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] bool has_holder() const;
  [[nodiscard]] double height() const;  ///< from tip to top
  /// Returns the text of a tool library file that reads back as the same tool.
  [[nodiscard]] std::string to_json() const;

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  explicit Tool(std::shared_ptr<const Content> content);
  friend class ToolLibrary;
  std::shared_ptr<const Content> content_;
};

/// Facts that a library of another program may leave open.
struct ImportFacts {
  std::optional<double> stickout;  ///< mm, tip to holder, of tools whose file does not state it
  std::string unit;                ///< mm or inch, of an NX library that states none
};

/// The tools for paths that call several, by number or name. Immutable.
class GOUGECHECK_EXPORT ToolLibrary {
 public:
  /// Reads a library of this project, Fusion, FreeCAD or NX, recognised by its content.
  /// Throws   Error: those of the tool library and of imports (docs/formats/tool_import.md). Code usage: facts for a
  ///          library of this project, which states them.
  [[nodiscard]] static ToolLibrary read(const std::string& file, const ImportFacts& facts = {});
  [[nodiscard]] static ToolLibrary from_json(std::string_view json, const std::string& name = "tools");

  /// Builds a library. Throws   Error: those of the tool library, such as two tools with one number.
  explicit ToolLibrary(const std::vector<Tool>& tools);

  /// Returns a library without tools, for a path that defines its tools itself (CUTTER, TLDATA).
  [[nodiscard]] static ToolLibrary empty();

  [[nodiscard]] std::vector<Tool> tools() const;
  /// Returns a tool by name, or by number written 3 or T3. Throws Error, library-which, if there is none, or if it is the
  /// name of one tool and the number of another.
  [[nodiscard]] Tool tool(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const;  ///< whether `tool` returns one
  [[nodiscard]] std::vector<Note> notes() const;        ///< what the reader assumed or left out
  /// Returns the text of a library file of this project that reads back as the same tools.
  [[nodiscard]] std::string to_json() const;

  /// Returns the library for `from_bytes` of this version, in this or another process.
  [[nodiscard]] std::string to_bytes() const;
  /// Throws   Error: saved-bytes.
  [[nodiscard]] static ToolLibrary from_bytes(std::string_view bytes);

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  explicit ToolLibrary(std::shared_ptr<const Content> content);
  std::shared_ptr<const Content> content_;
};

/// Returns every word that Tool accepts as a shape.
[[nodiscard]] GOUGECHECK_EXPORT std::vector<std::string> tool_shapes();

}  // namespace gougecheck
