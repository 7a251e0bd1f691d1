#include "lib/base/file_kind.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace gouge::file_kind_test {
namespace {

std::string kind_of(const std::string& path, const std::string& bytes) {
  const auto kind = recognise_file(path, bytes);
  return kind ? std::string(kind->name) : "";
}

TEST(FileKind, IsRecognisedByItsFirstBytes) {
  const std::string iges = std::string(72, ' ') + "S      1\n" + std::string(72, 'x') + "G      1\n";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"version https://git-lfs.github.com/spec/v1\noid sha256:00\n", "a pointer of Git LFS, not the file itself"},
      {std::string("\x00\x05\x16\x07\x00\x02", 6), "a property file of macOS, not the file itself"},
      {"ISO-10303-21;\nHEADER;", "a STEP file"},
      {"\xef\xbb\xbfISO-10303-21;", "a STEP file"},
      {iges, "an IGES file"},
      {std::string("V5_CFV2\x00\x00", 9), "a CATIA part"},
      {"#UGC:2 PART 1234", "a Creo part"},
      {"\x1f\x8b\x08", "a compressed file (gzip)"},
      {"<html><body>", "a web page (HTML)"},
      {"  {\"a\": 1}", "JSON"}};
  for (const auto& [bytes, name] : files) EXPECT_EQ(kind_of("part.stl", bytes), name) << bytes;
}

TEST(FileKind, IsRecognisedByTheNameWhereTheBytesDoNotStateIt) {
  const std::string zip = "PK\x03\x04";
  EXPECT_EQ(kind_of("a/b.CATPart", "anything"), "a CATIA part");
  EXPECT_EQ(kind_of("b.prt", "anything"), "a part of NX or Creo");
  EXPECT_EQ(kind_of("b.PRT.12", "anything"), "a Creo part");
  EXPECT_EQ(kind_of("b.IGS", ""), "an IGES file");
  EXPECT_EQ(kind_of("x/._part.stl", "Mac OS X"), "a property file of macOS, not the file itself");
  EXPECT_EQ(kind_of("b.3mf", zip), "a 3MF mesh");
  EXPECT_EQ(kind_of("b.zip", zip), "a ZIP archive");
  EXPECT_EQ(kind_of("b.stl", zip), "a ZIP archive");
  EXPECT_EQ(kind_of("b.prt", "ISO-10303-21;"), "a STEP file") << "bytes count before the name";
}

TEST(FileKind, IsNotStatedOfInputs) {
  for (const char* text : {"solid part\nfacet normal", "GOTO/1,2,3\n", "TOOL PATH/A,TOOL,B\n", "%\nO1000\n", "", "S 1"})
    EXPECT_EQ(kind_of("input", text), "") << text;
}

TEST(FileKind, OfClDataIsRecognisedByAWordOfItsFirstLines) {
  EXPECT_TRUE(looks_like_cl_data("$$ by hand\n  GOTO / 1,2,3"));
  EXPECT_TRUE(looks_like_cl_data("PARTNO A"));
  EXPECT_FALSE(looks_like_cl_data("G0 X1\nM30\n"));
  EXPECT_FALSE(looks_like_cl_data(""));
}

}  // namespace
}  // namespace gouge::file_kind_test
