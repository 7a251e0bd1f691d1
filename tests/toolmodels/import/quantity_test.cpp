#include "toolmodels/import/quantity.h"

#include <gtest/gtest.h>

namespace gouge::quantity_test {
namespace {

double value(const std::string& text) {
  const std::optional<Quantity> quantity = parse_quantity(text);
  return quantity ? quantity->value : -999;
}

TEST(Quantity, UnitsBecomeMillimetresAndDegrees) {
  EXPECT_EQ(value("6.0000 mm"), 6);
  EXPECT_EQ(value("0.25 in"), 6.35);
  EXPECT_DOUBLE_EQ(value("0.375 \""), 9.525);
  EXPECT_EQ(value("2cm"), 20);
  EXPECT_EQ(value(" 500 \xC2\xB5m "), 0.5);
  EXPECT_EQ(value("60 \xC2\xB0"), 60);
  EXPECT_EQ(value("1e1 mm"), 10);
  EXPECT_EQ(parse_quantity("12")->unit, QuantityUnit::none);
  EXPECT_EQ(parse_quantity("12 deg")->unit, QuantityUnit::degree);
}

TEST(Quantity, OneCommaIsADecimalComma) {
  EXPECT_NEAR(value("0,69488188976378 in"), 17.65, 1e-9);
  EXPECT_TRUE(parse_quantity("20,0 deg")->has_decimal_comma);
  EXPECT_FALSE(parse_quantity("20.0 deg")->has_decimal_comma);
}

TEST(Quantity, WhatCanBeReadInTwoWaysIsRefused) {
  for (const char* text : {"1,234.5 mm", "1.234,5 mm", "1,2,3 mm", "", "mm", "6 furlong", "6 mm 7", "nan", "1/4 in"})
    EXPECT_FALSE(parse_quantity(text).has_value()) << text;
}

TEST(Quantity, TextsBecomeUtf8WithoutControlCharacters) {
  EXPECT_EQ(clean_text(" Fr\xC3\xA4ser \n"), "Fr\xC3\xA4ser");
  EXPECT_EQ(clean_text("Fr\xE4ser"), "Fr\xC3\xA4ser") << "Latin-1";
  EXPECT_EQ(clean_text("a\tb\x01"), "a b ");
  EXPECT_EQ(plain_word("Bull Nose-End_mill 2"), "bullnoseendmill2");
}

}  // namespace
}  // namespace gouge::quantity_test
