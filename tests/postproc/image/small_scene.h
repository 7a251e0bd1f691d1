#pragma once

#include "lib/field/checked_toolpath.h"
#include "postproc/report/report_model.h"
#include "tests/support/whole_check.h"
#include "toolmodels/compile_tool.h"

// A block of 40 x 30 x 10 mm, a ball cutter with a holder and a path that cuts a groove 0.4 mm deep into its
// top on its way: checked for real.

namespace gouge {

inline IndexedMesh box_mesh(const std::string& name, const Vec3& low, const Vec3& high) {
  IndexedMesh mesh;
  mesh.name = name;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                               (k & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) mesh.file_triangle.push_back(t);
  return mesh;
}

inline ToolVariants ball_with_holder() {
  ToolAssembly tool;
  tool.name = "ball D6";
  tool.cutter = BallCutter{6, 15};
  tool.shank = {{6, 6, 10}};
  tool.holder = {{20, 20, 20}};
  return *make_tool_variants(tool, 0, 0, 0);
}

struct SmallScene {
  Scene scene;
  ToolVariants tool = ball_with_holder();
  Toolpath path;
  CheckResult result;
  ReportModel model;
  std::optional<PreparedScene> prepared;
  CheckedToolpath input;

  SmallScene() {
    scene.parts = {box_mesh("block.stl", {0, 0, 0}, {40, 30, 10})};
    path.file = "groove.apt";
    path.tools = {PathTool{4, "ball D6", {}, 0, 1}};
    path.operations = {Operation{"GROOVE", 1}};
    for (const Vec3& tip :
         {Vec3(-10, 15, 20), Vec3(5, 15, 12), Vec3(15, 15, 9.6), Vec3(25, 15, 9.6), Vec3(35, 15, 12)}) {
      Move move;
      move.line = 10 + path.moves.size();
      move.tool = 0;
      move.operation = 0;
      move.has_start = !path.moves.empty();
      move.end.tip = tip;
      path.moves.push_back(move);
    }
    check();
  }
  SmallScene(const SmallScene&) = delete;
  SmallScene& operator=(const SmallScene&) = delete;

  void check(const std::vector<HeadBody>& heads = {}) {
    result = whole_check(path, &tool, scene, model.options, heads);
    model.toolpath = &path;
    model.result = &result;
    model.parts = {MeshFacts{"block.stl", 12, 8, 0, true, ""}};
    model.tools = {ToolFacts{"ball D6", "tools.json", "ball D6"}};
    prepared.emplace(scene);
    input = {&path, &scene, &*prepared, {&tool}, &result, model.options, {}};
  }
};

}  // namespace gouge
