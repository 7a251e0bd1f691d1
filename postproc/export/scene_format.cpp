#include <string_view>

#include "lib/base/files.h"
#include "postproc/export/write_scene.h"

namespace gouge {
namespace {

constexpr struct {
  std::string_view ending;
  WriteScene write;
} kFormats[] = {{".glb", write_glb}, {".vtp", write_vtp}, {".ply", write_ply}};

}  // namespace

WriteScene scene_format_of(const std::string& file) {
  for (const auto& format : kFormats) {
    if (has_ending(file, format.ending)) return format.write;
  }
  return nullptr;
}

}  // namespace gouge
