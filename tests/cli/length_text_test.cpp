#include "cli/length_text.h"

#include <gtest/gtest.h>

namespace gouge {
namespace {

TEST(LengthText, ALengthMayCarryItsUnit) {
  EXPECT_EQ(parse_length_mm("0.5"), 0.5);
  EXPECT_EQ(parse_length_mm("0.5mm"), 0.5);
  EXPECT_EQ(parse_length_mm("2in"), 50.8);
  EXPECT_EQ(parse_length_mm("2inch"), 50.8);
  for (const char* text : {"", "in", "inch", "2inches", "2 cm", "2inin", "2inchin", "mm2"})
    EXPECT_FALSE(parse_length_mm(text)) << text;
}

TEST(LengthText, ATurnByAHugeAngleIsARotation) {
  const auto place = parse_place("0,0,0,45,4500000000000000000000000000000000000000000000000000000000,450");
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE((place->rotation * place->rotation.transpose()).isIdentity(1e-12));
  EXPECT_NEAR(place->rotation.determinant(), 1, 1e-12);
}

}  // namespace
}  // namespace gouge
