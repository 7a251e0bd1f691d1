#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "cli/tools/resolve_tools.h"
#include "lib/certify/check.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/support/shapes.h"
#include "toolmodels/compile_tool.h"

// From the text of a toolpath to its verdict, for tests whose part distinguishes a right reading from a wrong one.

namespace gouge {

inline Toolpath read_as(const std::string& text, const std::string& dialect) {
  ReadOptions options;
  if (!dialect.empty()) options.dialect = dialect_called(dialect);
  ReadOutcome outcome = read_toolpath("real.apt", text, options);
  for (const Diagnostic& error : outcome.errors) ADD_FAILURE() << to_text(error);
  return outcome.toolpath ? std::move(*outcome.toolpath) : Toolpath{};
}

/// The state of every move.
inline std::vector<MoveState> check_states(const Toolpath& path, const IndexedMesh& part,
                                           const std::vector<ToolVariants>& tools) {
  Scene scene;
  scene.parts.push_back(part);
  std::vector<const ToolVariants*> variants;
  for (const ToolVariants& tool : tools) variants.push_back(&tool);
  std::vector<MoveState> states;
  const PreparedScene prepared = prepare_scene(scene);
  for (const MoveVerdict& v : check(path, CheckSetup{variants, {}, prepared, {}}).verdicts) states.push_back(v.state);
  return states;
}

/// Verdict of the path: "clean", or the state of its first move that is not.
inline std::string verdict(const Toolpath& path, const IndexedMesh& part, const std::vector<ToolVariants>& tools) {
  for (const MoveState state : check_states(path, part, tools)) {
    if (state != MoveState::clean) return state_name(state);
  }
  return "clean";
}

/// With the tools the file itself defines.
inline std::string verdict(const Toolpath& path, const IndexedMesh& part) {
  const Result<ResolvedTools> resolved = resolve_tools(path, nullptr, {}, "");
  EXPECT_TRUE(resolved.has_value());
  std::vector<ToolVariants> tools;
  for (const std::optional<ToolAssembly>& assembly : resolved->assemblies) {
    EXPECT_TRUE(assembly.has_value());
    tools.push_back(make_tool_variants(assembly.value_or(ToolAssembly{}), 0, 0, 0).value());
  }
  return verdict(path, part, tools);
}

/// Verdict of a file against a box whose top is z = 0; the code of its first error where it cannot be read.
inline std::string outcome_at_box(const std::string& text) {
  const ReadOutcome read = read_toolpath("a.apt", text);
  if (!read.toolpath) return read.errors.empty() ? "no error" : read.errors.front().code;
  return verdict(*read.toolpath, shapes::box({-50, -50, -20}, {50, 50, 0}));
}

}  // namespace gouge
