#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "postproc/formats/read_toolpath.h"

namespace gouge {

/// The toolpath that `text` is, or an empty one after a test failure that shows the error.
inline Toolpath path_of(const std::string& text) {
  ReadOutcome outcome = read_toolpath("test.apt", text);
  if (!outcome.toolpath) {
    ADD_FAILURE() << (outcome.errors.empty() ? "no error told" : to_text(outcome.errors.front()));
    return {};
  }
  return std::move(*outcome.toolpath);
}

inline void expect_vector(const Vec3& found, double x, double y, double z, double within = 1e-12) {
  EXPECT_NEAR(found.x(), x, within);
  EXPECT_NEAR(found.y(), y, within);
  EXPECT_NEAR(found.z(), z, within);
}

}  // namespace gouge
