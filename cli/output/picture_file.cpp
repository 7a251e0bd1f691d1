#include "cli/output/picture_file.h"

#include "lib/base/file_ending.h"
#include "postproc/image/font.h"

namespace gouge {
Result<bool> is_svg_file(const std::string& file) {
  if (has_ending(file, ".svg")) return true;
  if (has_ending(file, ".png")) return false;
  return make_error("usage", "-o '" + file + "': the picture must be a .png or an .svg file");
}

Diagnostics find_missing_letters(const Toolpath& path, const std::vector<std::string>& meshes) {
  std::vector<std::string> names = meshes;
  names.push_back(path.file);
  for (const PathTool& tool : path.tools) names.push_back(tool.name);
  for (const Operation& operation : path.operations) names.push_back(operation.name);
  return find_missing_letters(names);
}

}  // namespace gouge
