#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "postproc/image/heat_map.h"
#include "tests/postproc/image/small_scene.h"

namespace gouge {

/// The pages of a small scene as drawings, for what they state.
struct SmallPages {
  explicit SmallPages(const SmallScene& small)
      : scene(*small.prepared),
        field(small.input),
        overcuts(small.input, field),
        set{small.model,
            small.input,
            scene,
            field,
            overcuts,
            worst_events(small.input, 6),
            make_colour_scale(0.01, 1, small.path.unit),
            make_colour_scale(0.01, 1, small.path.unit),
            {Vec3(1, -1, 1).normalized()},
            gouge_witnesses(small.input, 100)} {}
  PictureScene scene;
  DepthField field;
  OvercutField overcuts;
  PictureSet set;
};

inline std::vector<DrawnText> texts_of(const Page& page) {
  std::vector<DrawnText> all;
  for (const auto& item : page.drawing.items)
    if (const auto* text = std::get_if<DrawnText>(&item)) all.push_back(*text);
  return all;
}

inline std::size_t count_with(const Page& page, const std::string& wanted) {
  const std::vector<DrawnText> all = texts_of(page);
  return static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [&](const DrawnText& text) { return text.text.find(wanted) != std::string::npos; }));
}

}  // namespace gouge
