#include "lib/mesh/read_stl.h"

#include <gtest/gtest.h>

#include <limits>

#include "lib/mesh/write_stl.h"
#include "tests/support/shapes.h"
#include "tests/support/stl_text.h"

namespace gouge::read_stl_test {
namespace {

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0.5F};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

std::string error_of(std::string_view bytes) {
  const Result<TriangleSoup> soup = parse_stl(bytes, "part.stl");
  return soup ? "no error" : to_text(soup.error());
}

TEST(ReadStl, BinaryGivesEveryCoordinate) {
  const std::string bytes = shapes::binary_stl("a part", 2, {kTriangle, kTriangle});
  const auto soup = parse_stl(bytes, "part.stl");
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->format, StlFormat::binary);
  EXPECT_EQ(soup->name, "part.stl");
  ASSERT_EQ(soup->triangles.size(), 2U);
  EXPECT_EQ(soup->triangles[1][2], Vec3(0, 1, 0.5));
  EXPECT_TRUE(soup->notes.empty());
}

TEST(ReadStl, BinaryHeaderMayBeginWithSolid) {
  const std::string bytes = shapes::binary_stl("solid basemach", 1, {kTriangle});
  const auto soup = parse_stl(bytes, "part.stl");
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->format, StlFormat::binary);
}

TEST(ReadStl, BinaryWithSolidHeaderAndOneTrailingByteIsReadWithANote) {
  const std::string bytes = shapes::binary_stl("solid test.stl", 1, {kTriangle}) + "x";
  const auto soup = parse_stl(bytes, "part.stl");
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->triangles.size(), 1U);
  ASSERT_EQ(soup->notes.size(), 1U);
  EXPECT_EQ(to_text(soup->notes[0]), "part.stl: note: 1 byte after the last triangle ignored [stl-trailing-bytes]");
}

TEST(ReadStl, ZeroPaddingIsNoGeometryButOtherBytesMightBe) {
  const std::string one = shapes::binary_stl("x", 1, {kTriangle});
  const std::string padded = one + std::string(512, '\0');
  EXPECT_TRUE(parse_stl(padded, "part.stl").has_value());
  EXPECT_EQ(error_of(one + std::string(50, 'x')),
            "part.stl: error: the header states 1 triangle but 50 bytes follow them; expected the file to end there, "
            "export it again [stl-trailing-data]");
}

// The facets of a mesh with the normals that belong to them, and with an attribute and bytes behind each.
std::string spread_stl(const IndexedMesh& mesh, const std::vector<std::uint16_t>& attributes,
                       const std::vector<std::size_t>& bytes_behind, bool has_normals = true) {
  const std::string plain = binary_stl_bytes(mesh, LengthUnit::mm);
  std::string bytes = plain.substr(0, 84);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::string facet = plain.substr(84 + 50 * t, 48);
    if (!has_normals) facet.replace(0, 12, 12, '\0');
    bytes += facet;
    const std::uint16_t attribute = attributes[t % attributes.size()];
    bytes += {static_cast<char>(attribute & 0xffU), static_cast<char>(attribute >> 8U)};
    bytes.append(bytes_behind[t % bytes_behind.size()], '\x11');
  }
  return bytes;
}

const char* const kUncertain = "part.stl: error: the header states 12 triangles (684 bytes) but the file has ";

void expect_cube(const std::string& bytes, const std::string& code) {
  const auto soup = parse_stl(bytes, "part.stl");
  ASSERT_TRUE(soup.has_value()) << to_text(soup.error());
  ASSERT_EQ(soup->triangles.size(), 12U);
  const IndexedMesh cube = shapes::cube();
  for (std::size_t t = 0; t < 12; ++t)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(soup->triangles[t][k], cube.corner(t, k)) << t;
  ASSERT_EQ(soup->notes.size(), code.empty() ? 0U : 1U);
  if (!code.empty()) {
    EXPECT_EQ(soup->notes[0].code, code);
  }
}

TEST(ReadStl, BytesBehindEachFacetAreSkippedWhereTheirCountsAddUpToTheFile) {
  for (const bool has_normals : {true, false}) {
    expect_cube(spread_stl(shapes::cube(), {2}, {2}, has_normals), "stl-attribute-bytes");
    expect_cube(spread_stl(shapes::cube(), {4}, {4}, has_normals), "stl-attribute-bytes");
    expect_cube(spread_stl(shapes::cube(), {300}, {300}, has_normals), "stl-attribute-bytes");
    expect_cube(spread_stl(shapes::cube(), {0, 7, 1}, {0, 7, 1}, has_normals), "stl-attribute-bytes");
  }
  const std::string bytes = spread_stl(shapes::cube(), {2}, {2});
  EXPECT_EQ(to_text(parse_stl(bytes, "part.stl")->notes[0]),
            "part.stl: note: 24 bytes behind the triangles ignored, as their attribute byte counts state "
            "[stl-attribute-bytes]");
}

TEST(ReadStl, ShiftedFacetsAreNeverRead) {
  const IndexedMesh cube = shapes::cube();
  // More or fewer bytes than the counts state, or bytes without a count.
  EXPECT_EQ(
      error_of(spread_stl(cube, {3}, {2})),
      std::string(kUncertain) +
          "708, and the others may lie between the triangles, so that their places are uncertain; export it again "
          "without attributes [stl-facet-bytes]");
  EXPECT_NE(error_of(spread_stl(cube, {0}, {1})).find("[stl-facet-bytes]"), std::string::npos);
  EXPECT_NE(error_of(spread_stl(cube, {0}, {4}, false)).find("[stl-facet-bytes]"), std::string::npos);
  EXPECT_NE(error_of(spread_stl(cube, {2}, {2}) + "\n").find("[stl-facet-bytes]"), std::string::npos);
  const std::string cut = spread_stl(cube, {2}, {2});
  for (std::size_t size = 684; size < cut.size(); ++size)
    EXPECT_NE(error_of(std::string_view(cut).substr(0, size)).find("[stl-facet-bytes]"), std::string::npos) << size;
}

TEST(ReadStl, AttributesThatAreColoursAreNoCounts) {
  expect_cube(spread_stl(shapes::cube(), {0x8123, 0xffff, 31}, {0}), "");
  IndexedMesh open = shapes::cube();
  open.triangles.pop_back();
  for (const bool has_normals : {true, false})
    EXPECT_TRUE(parse_stl(std::string_view(spread_stl(open, {0x8123}, {0}, has_normals)), "part.stl").has_value());
  // With bytes at the end, whatever the attributes add up to.
  for (const std::size_t tail : {1U, 2U, 12U, 49U})
    for (const std::uint16_t attribute : {std::uint16_t{0x8123}, static_cast<std::uint16_t>(tail), std::uint16_t{1}})
      expect_cube(spread_stl(shapes::cube(), {attribute}, {0}) + std::string(tail, 'x'), "stl-trailing-bytes");
  // One facet whose attribute is the number of bytes at the end: the counts add up, and the facets behind it would be
  // shifted.
  const std::vector<std::uint16_t> first = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  expect_cube(spread_stl(shapes::cube(), first, {0}, false) + std::string(1, '\0'), "stl-trailing-bytes");
}

TEST(ReadStl, ASurfaceThatIsOpenAndHasNoNormalsConfirmsNoReading) {
  IndexedMesh open = shapes::cube();
  open.triangles.pop_back();
  EXPECT_NE(error_of(spread_stl(open, {2}, {2}, false)).find("[stl-facet-bytes]"), std::string::npos);
  const std::string with_normals = spread_stl(open, {2}, {2});
  EXPECT_EQ(parse_stl(with_normals, "part.stl")->triangles.size(), 11U);
}

TEST(ReadStl, TruncatedBinarySaysHowManyOfHowMany) {
  const std::string two = shapes::binary_stl("x", 2, {kTriangle, kTriangle});
  EXPECT_EQ(error_of(std::string_view(two).substr(0, two.size() - 1)),
            "part.stl: error: the header states 2 triangles (184 bytes) but the file holds 1 whole (183 bytes); it is "
            "cut off or not an STL, export or copy it again [stl-truncated]");
  EXPECT_EQ(error_of(std::string("\x01\x02\x03", 3)),
            "part.stl: error: the file has 3 bytes; a binary STL has at least 84 and an ASCII one begins with 'solid' "
            "[stl-truncated]");
}

TEST(ReadStl, AnotherKindOfFileIsCalledByItsName) {
  const auto reported = [](const std::string& bytes) { return error_of(bytes); };
  EXPECT_EQ(
      reported("ISO-10303-21;\nHEADER;\n"),
      "part.stl: error: the file is a STEP file, exact geometry without triangles; save the part as STL in the CAD "
      "system [stl-not-stl]");
  for (const char* path : {"UNITS/MM\nGOTO/0,0,0\n", "$$ by hand\n  GOTO / 1,2,3", "TOOL PATH/A,TOOL,B\n"})
    EXPECT_EQ(reported(path), "part.stl: error: the file is a toolpath (CL data); expected an STL file [stl-not-stl]");
  EXPECT_EQ(reported(std::string("PK\x03\x04\0\0", 6) + std::string(200, '\0')),
            "part.stl: error: the file is a ZIP archive; unpack it, or save the part as STL [stl-not-stl]");
  EXPECT_EQ(reported("# cube\nv 0 0 0\n"), "part.stl: error: the file is an OBJ mesh; save it as STL [stl-not-stl]");
  EXPECT_EQ(reported("once upon a time"),
            "part.stl: error: the file is text but not ASCII STL; expected it to begin with 'solid' [stl-not-stl]");
}

TEST(ReadStl, AHeaderOfABinaryFileMayHoldAnyWords) {
  for (const char* header : {"UNITS/MM", "{", "OFF", "ISO-10303-21", "GOTO"}) {
    const std::string one = shapes::binary_stl(header, 1, {kTriangle});
    EXPECT_TRUE(parse_stl(one, "part.stl").has_value()) << header;
    const std::string longer = one + '\n';
    EXPECT_TRUE(parse_stl(longer, "part.stl").has_value()) << header;
  }
}

TEST(ReadStl, EmptyAndEmptied) {
  EXPECT_EQ(error_of(""), "part.stl: error: the file is empty (0 bytes); expected a binary or ASCII STL [stl-empty]");
  EXPECT_EQ(error_of(shapes::binary_stl("x", 0, {})),
            "part.stl: error: the binary STL holds no triangle; expected at least one [stl-no-triangles]");
  EXPECT_EQ(error_of("solid Empty\nendsolid Empty"),
            "part.stl: error: the ASCII STL holds no facet; expected at least one [stl-no-triangles]");
}

TEST(ReadStl, BinaryCoordinateThatIsNoNumberNamesTheTriangle) {
  std::vector<float> bad = kTriangle;
  bad[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_of(shapes::binary_stl("x", 2, {kTriangle, bad})),
            "part.stl: error: triangle 2 of 2 has a coordinate that is infinite or not a number; expected finite "
            "coordinates [stl-bad-number]");
  bad[4] = std::numeric_limits<float>::infinity();
  const std::string bytes = shapes::binary_stl("x", 1, {bad});
  EXPECT_EQ(parse_stl(bytes, "").error().code, "stl-bad-number");
}

TEST(ReadStl, TextThatIsNoStlIsReportedSo) {
  EXPECT_EQ(error_of("BLADE 1\n1,2,3\n"),
            "part.stl: error: the file is text but not ASCII STL; expected it to begin with 'solid' [stl-not-stl]");
}

TEST(ReadStl, StoredNormalsOfTheOtherSideAreCounted) {
  std::string text = shapes::ascii_stl(shapes::tetrahedron());
  text = replaced(text, "normal 0 0 0", "normal 0 0 -1");  // the bottom: right
  text = replaced(text, "normal 0 0 0", "normal 0 1 0");   // the front: wrong
  const auto soup = parse_stl(text, "part.stl");
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->opposite_normals, 1U);
  EXPECT_EQ(soup->first_opposite_normal, 1U);
}

TEST(ReadStl, EveryPrefixOfAFileIsReadOrRefusedWithoutHarm) {
  const std::string binary = binary_stl_bytes(shapes::cube(), LengthUnit::mm);
  const std::string ascii = shapes::ascii_stl(shapes::cube());
  for (const std::string& whole : {binary, ascii}) {
    const std::size_t end = std::min(whole.size(), whole.find("endsolid") + 8);
    for (std::size_t n = 0; n < end; ++n) {
      const auto soup = parse_stl(std::string_view(whole).substr(0, n), "part.stl");
      EXPECT_TRUE(!soup || !soup->notes.empty()) << n << " bytes of " << whole.size();
    }
  }
}

TEST(ReadStl, ReadsTwoMillionBinaryTriangles) {
  const IndexedMesh sheet = shapes::sheet(100, 100, 0, 1000, 1000);
  const std::string bytes = binary_stl_bytes(sheet, LengthUnit::mm);
  const auto soup = parse_stl(bytes, "part.stl");
  ASSERT_TRUE(soup.has_value());
  EXPECT_EQ(soup->triangles.size(), 2000000U);
}

}  // namespace
}  // namespace gouge::read_stl_test
