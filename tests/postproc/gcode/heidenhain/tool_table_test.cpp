#include "postproc/gcode/heidenhain/tool_table.h"

#include <gtest/gtest.h>

namespace gouge::tool_table_test {
namespace {

const std::string kTable =
    "BEGIN TOOL.T MM\r\n"
    "T     NAME             L          R        R2       DL      DR\r\n"
    "0                      +0         +0       +0       +0      +0\r\n"
    "1     MILL L 5         +112.5     +5       +0       -0.02   +0\r\n"
    "2     NONE\r\n"
    "5.1   INDEXED          +80        +5       +0       +0      +0\r\n"
    "12    BALL             90         +3       +3               \r\n"
    "[END]\r\n";

Result<ToolTable> table_of(const std::string& text) { return read_heidenhain_tool_table("tool.t", text); }

TEST(HeidenhainToolTable, HasTheLengthsOfItsTools) {
  const auto table = table_of(kTable);
  ASSERT_TRUE(table) << to_text(table.error());
  EXPECT_EQ(table->lengths_mm.size(), 3U);
  EXPECT_DOUBLE_EQ(table->lengths_mm.at(0), 0);
  EXPECT_DOUBLE_EQ(table->lengths_mm.at(1), 112.48);
  EXPECT_DOUBLE_EQ(table->lengths_mm.at(12), 90);
}

TEST(HeidenhainToolTable, HasTheDiametersOfItsTools) {
  std::string text = kTable;
  text.replace(text.find("-0.02   +0"), 10, "-0.02   -0.1");
  const auto table = table_of(text);
  ASSERT_TRUE(table) << to_text(table.error());
  EXPECT_EQ(table->diameters_mm.size(), 2U);  // a radius of 0 states none
  EXPECT_DOUBLE_EQ(table->diameters_mm.at(1), 9.8);
  EXPECT_DOUBLE_EQ(table->diameters_mm.at(12), 6);
}

TEST(HeidenhainToolTable, HasTheCornerRadiiOfItsTools) {
  const auto corners = [](const std::string& row, const std::string& heading = "R2") {
    const auto table = table_of("BEGIN TOOL.T MM\nT  L     R     " + heading + "    DR2\n" + row + "\n[END]\n");
    EXPECT_TRUE(table) << row;
    return table ? table->corners_mm : std::map<int, double>();
  };
  using Corners = std::map<int, double>;
  EXPECT_EQ(corners("1  90    5     2     0.25"), (Corners{{1, 2.25}}));
  EXPECT_EQ(corners("1  90    5     0"), (Corners{{1, 0}}));
  EXPECT_EQ(corners("1  90    5     0     -0.25"), (Corners{{1, 0}}));
  EXPECT_EQ(corners("1  90    0     2"), (Corners{{1, 2}}));
  EXPECT_EQ(corners("1  90    0     0"), Corners()) << "not filled in";
  EXPECT_EQ(corners("1  90    5"), Corners());
  EXPECT_EQ(corners("1  90    5     2", "XX"), Corners());
  EXPECT_EQ(table_of(kTable)->corners_mm, (Corners{{1, 0}, {12, 3}}));
}

TEST(HeidenhainToolTable, IsInItsUnit) {
  std::string text = kTable;
  text.replace(text.find("MM"), 2, "INCH");
  EXPECT_DOUBLE_EQ(table_of(text)->lengths_mm.at(12), 90 * 25.4);
}

TEST(HeidenhainToolTable, IsRecognised) {
  EXPECT_TRUE(is_heidenhain_tool_table(kTable));
  EXPECT_TRUE(is_heidenhain_tool_table("BEGIN TOOL    .T MM\n"));
  EXPECT_FALSE(is_heidenhain_tool_table("tool,length\n1,90\n"));
  EXPECT_FALSE(is_heidenhain_tool_table("BEGIN PGM TOOL.T MM\n"));
}

TEST(HeidenhainToolTable, IsRefusedWithItsLine) {
  const auto expect_wrong = [](const std::string& from, const std::string& to, std::size_t line) {
    std::string text = kTable;
    text.replace(text.find(from), from.size(), to);
    const auto table = table_of(text);
    ASSERT_FALSE(table) << text;
    EXPECT_EQ(table.error().code, "tool-lengths");
    EXPECT_EQ(table.error().line, line);
  };
  expect_wrong(" MM", "", 1);
  expect_wrong(" L ", " X ", 2);
  expect_wrong("+112.5 ", "+11x.5 ", 4);
  expect_wrong("+5 ", "+5a", 4);
  expect_wrong("12    BALL", "1     BALL", 7);
  expect_wrong("[END]", "", 8);
  expect_wrong("-0.02", "-0,02", 4);
  expect_wrong("+3       +3", "+3       +z", 7);
}

TEST(HeidenhainToolTable, HasNoValueThatStandsInTwoColumns) {
  const std::string begin = "BEGIN TOOL.T MM\nT    NAME      L        R     DL    DR    TL\n";
  const auto table = table_of(begin + "1    MILL      +110     +5    +0       +2.5\n[END]\n");
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().line, 3U);
  EXPECT_EQ(table.error().message,
            "'+2.5' stands in two columns of the table; expected each value below the word of its heading");
  EXPECT_FALSE(table_of(begin + "1    A MILL OF10       +5    +0    +2.5\n[END]\n")) << "a name that ends in L";
  EXPECT_TRUE(table_of(begin + "1    A MILL OF +110     +5    +0.02 +2.5  LOCKED AND LONG\n[END]\n"));
  EXPECT_TRUE(table_of(begin + "1    MILL      +110     +5    +0    +2.5\n[END]\n"));
}

}  // namespace
}  // namespace gouge::tool_table_test
