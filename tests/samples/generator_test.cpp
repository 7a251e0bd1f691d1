#include <gtest/gtest.h>

#include <algorithm>

#include "lib/mesh/load_mesh.h"
#include "lib/validate/validate_mesh.h"
#include "samples/cases.h"
#include "samples/cl_text.h"
#include "samples/write_sample.h"

// The generator by itself: what it writes is sound input.

namespace gouge::samples::generator_test {
namespace {

TEST(SampleSolids, AreClosedManifoldOutwardAndDoNotCrossThemselves) {
  std::size_t solids = 0;
  for (const Sample& sample : make_all()) {
    for (const auto* list : {&sample.parts, &sample.fixtures, &sample.heads}) {
      for (const NamedSolid& solid : *list) {
        const auto loaded = load_mesh_bytes(stl_bytes(solid.solid), solid.file);
        ASSERT_TRUE(loaded.has_value()) << sample.name;
        const MeshFindings& findings = loaded->findings;
        EXPECT_TRUE(findings.is_solid() && findings.is_manifold()) << sample.name;
        EXPECT_EQ(findings.degenerate_triangles.count + findings.collinear_triangles.count, 0U) << sample.name;
        EXPECT_EQ(findings.components, 1U) << sample.name;
        EXPECT_GT(findings.signed_volume_mm3, 0) << sample.name;
        EXPECT_TRUE(validate_mesh(loaded->mesh, findings).is_sound()) << sample.name;
        ++solids;
      }
    }
  }
  EXPECT_EQ(solids, 27U);
}

TEST(SampleSolids, ABoxHasTheVolumeOfItsSides) {
  const auto loaded = load_mesh_bytes(stl_bytes(make_box({1, 2, 3}, {2, 4, 6})), "box.stl");
  ASSERT_TRUE(loaded.has_value());
  EXPECT_DOUBLE_EQ(loaded->findings.signed_volume_mm3, 6);
}

TEST(SampleText, NamesTheLineOfThePositionNotOfItsRapid) {
  ClText cl(ClText::Form::apt);
  cl.line("UNITS/MM");
  EXPECT_EQ(cl.feed({Vec3(1, -2, 3), Vec3::UnitZ()}), 2U);
  EXPECT_EQ(cl.rapid({Vec3(0, 0, 0.000001), Vec3::UnitX()}), 4U);
  EXPECT_EQ(cl.positions(), 2U);
  EXPECT_EQ(cl.text(),
            "UNITS/MM\nGOTO/ 1.00000, -2.00000, 3.00000, 0.0000000, 0.0000000, 1.0000000\n"
            "RAPID\nGOTO/ 0.00000, 0.00000, 0.00000, 1.0000000, 0.0000000, 0.0000000\n");
}

TEST(SampleText, NxWritesTheAxisOnlyWhenItChangesAndBlockCoordinates) {
  RigidTransform to_block;
  to_block.shift = Vec3(1, 0, 0);
  ClText cl(ClText::Form::nx, to_block);
  cl.feed({Vec3(0, 0, 0), Vec3::UnitZ()});
  cl.feed({Vec3(1, 0, 0), Vec3::UnitZ()});
  EXPECT_EQ(cl.text(), "GOTO/1.0000,0.0000,0.0000,0.0000000,0.0000000,1.0000000\nGOTO/2.0000,0.0000,0.0000\n");
}

TEST(SampleFindings, StandOnLinesThatHoldPositions) {
  for (const Sample& sample : make_all()) {
    EXPECT_EQ(sample.check_exit, sample.findings.empty() ? 0 : 1) << sample.name;
    std::size_t line = 1, positions = 0;
    std::size_t start = 0;
    for (std::size_t end; (end = sample.toolpath.find('\n', start)) != std::string::npos; start = end + 1, ++line) {
      const bool is_position =
          sample.toolpath.compare(start, 4, "GOTO") == 0 || sample.toolpath.compare(start, 4, "TLON") == 0;
      positions += is_position ? 1 : 0;
      const bool has_finding =
          std::any_of(sample.findings.begin(), sample.findings.end(), [&](const auto& f) { return f.line == line; });
      EXPECT_TRUE(is_position || !has_finding) << sample.name << " line " << line;
    }
    EXPECT_EQ(positions, sample.moves) << sample.name;
  }
}

}  // namespace
}  // namespace gouge::samples::generator_test
