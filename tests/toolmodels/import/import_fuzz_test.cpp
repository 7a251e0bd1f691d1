#include <gtest/gtest.h>

#include "tests/toolmodels/import/import_helpers.h"
#include "tests/toolmodels/sample_tools.h"

// Seeded mutations of real-looking files: whatever comes out must be a library that reads back, or an error; and what no format may have.

namespace gouge::import_fuzz_test {
namespace {

using test::corpus;
using test::Scatter;

std::string mutate(std::string bytes, Scatter& random) {
  static const std::vector<std::string> kPieces = {"-", "0", "1e9", "1e999", "null", "{}",      "[]",     "\"", ",",
                                                   "|", "#", "\n|", "\xFF",  ".",    "\\u0000", "\"mm\"", "}"};
  const std::uint64_t rounds = 1 + random.next() % 4;
  for (std::uint64_t i = 0; i < rounds && !bytes.empty(); ++i) {
    const std::size_t at = random.next() % bytes.size();
    const std::size_t length = random.next() % 12;
    switch (random.next() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random.next());
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, kPieces[random.next() % kPieces.size()]);
        break;
      case 3:
        bytes.replace(at, length, kPieces[random.next() % kPieces.size()]);
        break;
      default:
        bytes.insert(at, bytes.substr(random.next() % bytes.size(), length * 8));
        break;
    }
  }
  return bytes;
}

void fuzz(const std::string& name, ImportFormat format, int runs) {
  const std::string original = corpus(name);
  ImportOptions options;
  options.unit = LengthUnit::mm;
  Scatter random(0x5eed + original.size());
  options.read_beside = [&random](const std::string&) -> Result<std::string> {
    return mutate(corpus("freecad/tapered_ball.fctb"), random);
  };
  int good = 0, bad = 0;
  for (int run = 0; run < runs; ++run) {
    const std::string bytes = mutate(original, random);
    (void)recognise_format(bytes);
    const Result<ImportedTools> made = import_tools("f", bytes, format, options);
    ++(made ? good : bad);
    if (!made) {
      EXPECT_FALSE(made.error().message.empty());
      continue;
    }
    for (const Diagnostic& note : made->notes) EXPECT_FALSE(note.message.empty());
    if (made->library.tools.empty() && made->library.holders.empty()) {
      EXPECT_TRUE(has_error(made->notes));
      continue;
    }
    const std::string text = write_tool_library(made->library);
    const Result<ToolLibrary> back = read_tool_library("back", text);
    ASSERT_TRUE(back.has_value()) << to_text(back.error()) << "\n" << bytes;
    EXPECT_EQ(back->tools.size(), made->library.tools.size());
  }
  EXPECT_GT(good, 0) << name;
  if (format != ImportFormat::nx) {
    EXPECT_GT(bad, 0) << name;
  }
}

TEST(ImportFuzz, FusionLibrariesNeverMakeAToolThatCannotBeReadBack) {
  fuzz("fusion-mill.json", ImportFormat::fusion, 3000);
}
TEST(ImportFuzz, ZippedLibrariesNeverCrash) { fuzz("fusion-mill.tools", ImportFormat::fusion, 3000); }
TEST(ImportFuzz, FreecadBitsNeverMakeAToolThatCannotBeReadBack) {
  fuzz("freecad/bull_6.fctb", ImportFormat::freecad, 6000);
}
TEST(ImportFuzz, FreecadLibrariesNeverMakeAToolThatCannotBeReadBack) {
  fuzz("freecad/shop.fctl", ImportFormat::freecad, 3000);
}
TEST(ImportFuzz, NxDatabasesNeverMakeAToolThatCannotBeReadBack) {
  fuzz("nx/metric/tool_database.dat", ImportFormat::nx, 6000);
}

TEST(ImportTools, WhatIsNestedTooDeepIsReportedAsThatWhateverTheFormat) {
  const std::string deep = "{\"data\": " + std::string(200'000, '[');
  for (const auto format :
       {std::optional<ImportFormat>(), std::optional(ImportFormat::fusion), std::optional(ImportFormat::freecad)}) {
    const Result<ImportedTools> made = import_tools("a.json", deep, format, {});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, "json-too-deep");
  }
}

}  // namespace
}  // namespace gouge::import_fuzz_test
