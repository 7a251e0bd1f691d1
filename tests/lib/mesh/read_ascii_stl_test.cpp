#include "lib/mesh/read_stl.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

namespace gouge::read_ascii_stl_test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

std::string error_of(std::string_view bytes) {
  const Result<TriangleSoup> soup = parse_stl(bytes, "part.stl");
  return soup ? "no error" : to_text(soup.error());
}

TEST(ReadAsciiStl, AsciiInAnyCaseWithExponentsAndAnyLineEnds) {
  const std::string text =
      "\xEF\xBB\xBF Solid a name\r\nFACET Normal 0 0 1\r\n OUTER LOOP\r\n\tVertex 0 0 0\r\nVERTEX +1.0E+000 .5 "
      "-2.5e-1\r\nvertex 0 1. -0\r\nEndLoop\r\nendFacet\r\nEndSolid\r\n";
  for (const std::string& variant : {text, std::string(text).append("\n\n")}) {
    const auto soup = parse_stl(variant, "part.stl");
    ASSERT_TRUE(soup.has_value()) << to_text(soup.error());
    EXPECT_EQ(soup->format, StlFormat::ascii);
    ASSERT_EQ(soup->triangles.size(), 1U);
    EXPECT_EQ(soup->triangles[0][1], Vec3(1, 0.5, -0.25));
    EXPECT_TRUE(soup->notes.empty());
  }
}

TEST(ReadAsciiStl, AFacetNeedsNoNormalAndLinesOfRemarksMayStandBeforeTheSolid) {
  std::string text = shapes::ascii_stl(shapes::tetrahedron());
  for (std::size_t at = text.find(" normal 0 0 0"); at != std::string::npos; at = text.find(" normal 0 0 0"))
    text.erase(at, 13);
  text = "# written by hand\r\n  # solid facet\n\n" + text + "# the end\n";
  const auto soup = parse_stl(text, "part.stl");
  ASSERT_TRUE(soup.has_value()) << to_text(soup.error());
  EXPECT_EQ(soup->triangles.size(), 4U);
  EXPECT_EQ(soup->opposite_normals, 0U);
  EXPECT_EQ(error_of(replaced(text, "vertex 0 10 0", "vertex 0 oops 0")),
            "part.stl:8: error: facet 1: expected a finite number as y of a vertex, found 'oops' [stl-bad-number]");
  EXPECT_EQ(error_of(replaced(text, "outer loop", "inner loop")),
            "part.stl:6: error: expected 'normal' in facet 1, found 'inner' [stl-syntax]");
  EXPECT_EQ(
      parse_stl(std::string_view(
                    "solid a facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid a"),
                "part.stl")
          ->triangles.size(),
      1U);
}

TEST(ReadAsciiStl, RemarksMakeNoStlOfOtherText) {
  EXPECT_NE(error_of("# Blender\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("[stl-not-stl]"), std::string::npos);
  EXPECT_NE(error_of("solid a\nfacet normal 0 0 1 # up\nouter loop\n").find("[stl-syntax]"), std::string::npos);
}

TEST(ReadAsciiStl, SeveralSolidsWithOddNamesAreOneSoup) {
  const std::string text =
      shapes::ascii_stl(shapes::cube(), "\xe6\x9c\x88 \xff facet") + shapes::ascii_stl(shapes::tetrahedron(), "");
  const auto soup = parse_stl(text, "part.stl");
  ASSERT_TRUE(soup.has_value()) << to_text(soup.error());
  EXPECT_EQ(soup->triangles.size(), 16U);
}

TEST(ReadAsciiStl, ABinaryStlBehindTextIsNoNameOfASolid) {
  const std::string binary = "solid of a CAD system" + std::string(59, '\0') + std::string(4, '\0');
  EXPECT_NE(error_of(shapes::ascii_stl(shapes::cube(), "a") + binary).find("a binary STL may follow"),
            std::string::npos);
}

TEST(ReadAsciiStl, OldMacLineEndsCountAsLines) {
  std::string text = replaced(shapes::ascii_stl(shapes::tetrahedron()), "vertex 0 10 0", "vertex 0 oops 0");
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(error_of(text),
            "part.stl:5: error: facet 1: expected a finite number as y of a vertex, found 'oops' [stl-bad-number]");
}

TEST(ReadAsciiStl, AsciiBadNumbersAreReportedWithTheirLine) {
  const std::string good = shapes::ascii_stl(shapes::tetrahedron());
  for (const std::string bad : {"nan", "inf", "1.2.3", "1e400", "1,5", "-nan(ind)"}) {
    EXPECT_EQ(
        error_of(replaced(good, "vertex 0 10 0", "vertex 0 10 " + bad)),
        "part.stl:5: error: facet 1: expected a finite number as z of a vertex, found '" + bad + "' [stl-bad-number]");
  }
}

TEST(ReadAsciiStl, ANormalThatIsNoNumberIsIgnored) {
  const std::string text =
      replaced(shapes::ascii_stl(shapes::tetrahedron()), "normal 0 0 0", "normal nan -nan(ind) 1.#IND");
  EXPECT_TRUE(parse_stl(text, "part.stl").has_value());
}

TEST(ReadAsciiStl, AsciiOutOfPlaceIsReportedWithTheLine) {
  const std::string good = shapes::ascii_stl(shapes::tetrahedron());
  EXPECT_EQ(
      error_of(replaced(good, "      vertex 10 0 0\n", "")),
      "part.stl:6: error: facet 1 has 2 vertices; expected 3: found 'endloop' where 'vertex' should be [stl-syntax]");
  EXPECT_EQ(
      error_of(replaced(good, "    endloop\n", "vertex 1 1 1\nendloop\n")),
      "part.stl:7: error: a fourth vertex in facet 1; expected triangles only: export it triangulated [stl-syntax]");
  EXPECT_EQ(error_of(replaced(good, "normal 0 0 0", "normal 0 0")),
            "part.stl:3: error: the normal of facet 1 has 2 numbers; expected 3 [stl-syntax]");
  EXPECT_EQ(error_of(replaced(good, "endfacet", "endfact")),
            "part.stl:8: error: expected 'endfacet' in facet 1, found 'endfact' [stl-syntax]");
  EXPECT_EQ(error_of("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 1"),
            "part.stl:4: error: the file ends inside facet 1; it is cut off, export or copy it again [stl-truncated]");
  EXPECT_EQ(error_of("solid a\nsquare 1 2 3\n"),
            "part.stl:2: error: expected 'facet' or 'endsolid', found 'square' [stl-syntax]");
  EXPECT_EQ(error_of("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 1 1\0"
                     "2\n"),
            "part.stl:4: error: the file ends inside facet 1; it is cut off, export or copy it again [stl-truncated]");
}

TEST(ReadAsciiStl, WordsThatSayNothingOfTheirOwnMayBeMissingOrApart) {
  const std::string good = shapes::ascii_stl(shapes::tetrahedron());
  const auto everywhere = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  const auto expected = parse_stl(good, "part.stl");
  for (const std::string& text :
       {everywhere("endsolid", "end solid"), everywhere("endsolid", "END Solid"), everywhere("endfacet", "end facet"),
        everywhere("endloop", "End Loop"), everywhere("endloop", ""), everywhere("endfacet", ""),
        everywhere("endloop\n  endfacet", ""), everywhere("outer loop", "loop"), everywhere("outer loop", ""),
        everywhere("outer", "outer\n"), everywhere("loop\n      vertex", "vertex"), everywhere("normal 0 0 0", "0 0 0"),
        everywhere("solid test\n  facet", "facet")}) {
    const auto soup = parse_stl(text, "part.stl");
    ASSERT_TRUE(soup.has_value()) << to_text(soup.error()) << text;
    ASSERT_EQ(soup->triangles.size(), 4U) << text;
    for (std::size_t t = 0; t < 4; ++t) EXPECT_EQ(soup->triangles[t], expected->triangles[t]);
    EXPECT_TRUE(soup->notes.empty()) << text;
  }
}

TEST(ReadAsciiStl, MissingWordsMakeNoTriangleOfOtherNumbersOfVertices) {
  const std::string good = shapes::ascii_stl(shapes::tetrahedron());
  EXPECT_EQ(error_of(replaced(good, "endloop", "end loops")),
            "part.stl:7: error: expected 'endloop' in facet 1, found 'end' [stl-syntax]");
  EXPECT_EQ(error_of("solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid"),
            "part.stl:5: error: facet 1 has 2 vertices; expected 3: found 'endfacet' where 'vertex' should be "
            "[stl-syntax]");
  EXPECT_EQ(error_of("solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0"),
            "part.stl:5: error: the file ends inside facet 1; it is cut off, export or copy it again [stl-truncated]");
  EXPECT_EQ(error_of("solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1\nfacet\n"),
            "part.stl:6: error: facet 1: expected a finite number as z of a vertex, found 'facet' [stl-bad-number]");
}

TEST(ReadAsciiStl, ANameMayHoldTheWordsOfAFacet) {
  for (const char* name : {"facet normal", "facet normal part", "facet normal 1 0 0 part", "facet normal 1 0 0",
                           "facet outer", "facet outer ring", "a facet normal 3", "facet", "endsolid facet normal 1"}) {
    const std::string text = shapes::ascii_stl(shapes::tetrahedron(), name);
    const auto soup = parse_stl(text, "part.stl");
    ASSERT_TRUE(soup.has_value()) << name << ": " << to_text(soup.error());
    EXPECT_EQ(soup->triangles.size(), 4U) << name;
  }
}

TEST(ReadAsciiStl, TextInUtf16IsReadWithANote) {
  const std::string ascii = shapes::ascii_stl(shapes::tetrahedron());
  const auto utf16 = [&](bool is_big, const std::string& mark) {
    std::string bytes = mark;
    for (const char c : ascii) bytes += is_big ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
  };
  for (const std::string& bytes :
       {utf16(false, "\xff\xfe"), utf16(true, "\xfe\xff"), utf16(false, ""), utf16(true, "")}) {
    const auto soup = parse_stl(bytes, "part.stl");
    ASSERT_TRUE(soup.has_value()) << to_text(soup.error());
    EXPECT_EQ(soup->format, StlFormat::ascii);
    EXPECT_EQ(soup->triangles.size(), 4U);
    EXPECT_EQ(soup->triangles[0][1], parse_stl(ascii, "part.stl")->triangles[0][1]);
    ASSERT_EQ(soup->notes.size(), 1U);
    EXPECT_EQ(to_text(soup->notes[0]), "part.stl: note: the file is UTF-16 text; read as ASCII [stl-utf16]");
  }
  EXPECT_EQ(error_of(std::string("\xff\xfeG\0O\0T\0O\0", 10)),
            "part.stl: error: the file is UTF-16 text but not ASCII STL; expected it to begin with 'solid' "
            "[stl-not-stl]");
  const std::string whole = utf16(false, "\xff\xfe");
  for (std::size_t n = 0; n < whole.size() - 2 * std::string("endsolid test\n").size(); ++n) {
    const auto soup = parse_stl(std::string_view(whole).substr(0, n), "part.stl");
    EXPECT_TRUE(!soup || soup->notes.size() == 2) << n << " bytes of " << whole.size();
  }
}

TEST(ReadAsciiStl, MissingEndsolidIsAWarning) {
  const std::string text = shapes::ascii_stl(shapes::tetrahedron());
  const auto soup = parse_stl(std::string_view(text).substr(0, text.find("endsolid")), "part.stl");
  ASSERT_TRUE(soup.has_value());
  ASSERT_EQ(soup->notes.size(), 1U);
  EXPECT_EQ(to_text(soup->notes[0]),
            "part.stl:30: warning: the file ends without 'endsolid' after facet 4; it may be cut off, export it again "
            "to be sure [stl-no-endsolid]");
}

}  // namespace
}  // namespace gouge::read_ascii_stl_test
