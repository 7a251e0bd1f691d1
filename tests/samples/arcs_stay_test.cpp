#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// An arc that must change stays an arc in the file.

namespace gouge::testing_samples::arcs_stay_test {
namespace {

/// A box from -40 to 40 in x and y and from -10 to 0 in z.
std::string box_stl() {
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
  std::ostringstream text;
  text << "solid box\n";
  for (const auto& face : kFaces) {
    for (const std::array<std::size_t, 3> corners : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (const std::size_t corner : corners) {
        const int v = face[corner];
        text << "vertex " << ((v & 4) != 0 ? 40 : -40) << " " << ((v & 2) != 0 ? 40 : -40) << " "
             << ((v & 1) != 0 ? 0 : -10) << "\n";
      }
      text << "endloop\nendfacet\n";
    }
  }
  return text.str() + "endsolid box\n";
}

TEST(ArcsStay, OneCircleALittleTooDeepIsOneCircleStill) {
  const std::string folder = fresh_folder();
  const std::string before =
      "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10.0000,0.0000,30.0000,0.0000,0.0000\nLOAD/TOOL,1\nRAPID\n"
      "GOTO/10.0000,0.0000,20.0000,0.0000000,0.0000000,1.0000000\nFEDRAT/MMPM,250.0000\nGOTO/10.0000,0.0000,-0.0310\n"
      "CIRCLE/0.0000,0.0000,-0.0310,0.0000000,0.0000000,-1.0000000,10.0000,0.0600,0.5000,10.0000,0.0000\n"
      "GOTO/10.0000,0.0000,-0.0310\nGOTO/10.0000,0.0000,20.0000\nEND-OF-PATH\n";
  write_text(folder + "/circle.cls", before);
  write_text(folder + "/box.stl", box_stl());
  const Outcome ran = run_gougecheck(folder, {"correct", "circle.cls", "--part", "box.stl", "-o", "out.cls"});
  ASSERT_EQ(ran.exit_status, 0) << ran.out << ran.err;
  const std::string after = text_of(folder + "/out.cls");
  const std::size_t circle = after.find("CIRCLE/0.0000,0.0000,");
  ASSERT_NE(circle, std::string::npos) << after;
  const std::string height = after.substr(circle + 21, after.find(',', circle + 21) - circle - 21);
  std::string expected = before;
  for (std::size_t at = expected.find("-0.0310"); at != std::string::npos; at = expected.find("-0.0310"))
    expected.replace(at, 7, height);
  EXPECT_EQ(after, expected) << "nothing but the height differs";
  EXPECT_LT(std::abs(std::stod(height)), 0.01);
}

}  // namespace
}  // namespace gouge::testing_samples::arcs_stay_test
