#include "cli/picture_file.h"

#include <algorithm>
#include <string_view>

#include "postproc/image/font.h"

namespace gouge {
namespace {

bool ends_with(const std::string& path, std::string_view ending) {
  return path.size() > ending.size() && std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char e, char p) {
           return e == (p >= 'A' && p <= 'Z' ? static_cast<char>(p - 'A' + 'a') : p);
         });
}

}  // namespace

Result<bool> is_svg_file(const std::string& file) {
  if (ends_with(file, ".svg")) return true;
  if (ends_with(file, ".png")) return false;
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
