#pragma once

#include <map>
#include <memory>
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
  /// Throws   Error: an unknown shape or dimension, or a dimension that is missing or contradicts another.
  Tool(std::string_view shape, const std::map<std::string, double>& dimensions,
       const std::vector<ToolSegment>& shank = {}, const std::vector<ToolSegment>& holder = {});

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

/// The tools for paths that call several, by number or name. Immutable.
class GOUGECHECK_EXPORT ToolLibrary {
 public:
  /// Reads a library. Throws   Error: those of the tool library.
  [[nodiscard]] static ToolLibrary read(const std::string& file);
  [[nodiscard]] static ToolLibrary from_json(std::string_view json, const std::string& name = "tools");

  [[nodiscard]] std::vector<Tool> tools() const;
  /// Returns a tool by name, or by number written 3 or T3. Throws Error, library-which, if there is none.
  [[nodiscard]] Tool tool(std::string_view name) const;

  struct Content;
  [[nodiscard]] const Content& content() const { return *content_; }

 private:
  explicit ToolLibrary(std::shared_ptr<const Content> content);
  std::shared_ptr<const Content> content_;
};

/// Returns every word that Tool accepts as a shape.
[[nodiscard]] GOUGECHECK_EXPORT std::vector<std::string> tool_shapes();

}  // namespace gougecheck
