#pragma once

#include <optional>

#include "lib/field/overcut_field.h"
#include "postproc/image/picture_scene.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// A path and the fields of its gouges. `input`, and the objects to which it points, must outlive it.
struct PicturedPath {
  explicit PicturedPath(const CheckedToolpath& of) : input(of), depths(of), overcuts(of, depths) {}

  const CheckedToolpath& input;
  DepthField depths;
  OvercutField overcuts;
};

/// Source of the pictures and the 3D view of a report, made once for both.
///
/// Shape    `input` belongs to model.toolpath and model.result, and `before` to the path as read. `before` is used only
///          for a correction and may be empty. All of them, and the objects to which they point, must outlive it.
struct ReportScene {
  ReportScene(const ReportModel& of, const CheckedToolpath& input, const CheckedToolpath& path_before = {})
      : model(of), scene(*input.prepared), path(input) {
    if (of.has_correction && path_before.toolpath != nullptr && path_before.result != nullptr)
      before.emplace(path_before);
  }

  const ReportModel& model;
  PictureScene scene;
  PicturedPath path;
  std::optional<PicturedPath> before;  ///< set only for a correction
};

}  // namespace gouge
