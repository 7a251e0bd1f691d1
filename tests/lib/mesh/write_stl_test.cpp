#include "lib/mesh/write_stl.h"

#include <gtest/gtest.h>

#include "lib/mesh/load_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

namespace gouge::write_stl_test {
namespace {

TEST(WriteStl, WhatIsWrittenReadsBackTheSame) {
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
    const std::string first = binary_stl_bytes(shapes::sphere(), unit);
    const auto loaded = load_mesh_bytes(first, "part.stl", {unit, {}});
    ASSERT_TRUE(loaded.has_value());
    EXPECT_TRUE(loaded->findings.is_solid());
    EXPECT_EQ(loaded->findings.opposite_normals.count, 0U);
    const std::string second = binary_stl_bytes(loaded->mesh, unit);
    ASSERT_EQ(second.size(), first.size());
    for (std::size_t t = 0; t < loaded->mesh.triangles.size(); ++t) {  // normals may round differently
      ASSERT_EQ(second.substr(84 + 50 * t + 12, 36), first.substr(84 + 50 * t + 12, 36)) << t;
    }
  }
}

TEST(WriteStl, TheHeaderDoesNotPassForAscii) {
  EXPECT_EQ(binary_stl_bytes(shapes::cube(), LengthUnit::mm).substr(0, 10), "binary STL");
}

TEST(WriteStl, NormalsPointOutwardAndATriangleWithoutAreaHasNone) {
  IndexedMesh mesh = shapes::sheet(1, 1, 0);
  mesh.vertices.emplace_back(2, 2, 0);
  shapes::add_triangle(mesh, 0, 3, 4);
  const std::string bytes = binary_stl_bytes(mesh, LengthUnit::mm);
  EXPECT_EQ(bytes.substr(84, 12), std::string("\0\0\0\0\0\0\0\0\0\0\x80\x3f", 12));
  EXPECT_EQ(bytes.substr(84 + 100, 12), std::string(12, '\0'));
}

}  // namespace
}  // namespace gouge::write_stl_test
