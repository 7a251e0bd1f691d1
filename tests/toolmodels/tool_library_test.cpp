#include "toolmodels/tool_library.h"
#include "tests/support/verify_tool.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/base/files.h"
#include "tests/support/source_folder.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge::tool_library_test {
namespace {

constexpr const char* kGood =
    R"({"units":"mm","tools":[{"number":1,"name":"ball D10","cutter":{"shape":"ball","diameter":10,"length":30},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40},{"lower_diameter":40,"upper_diameter":46,"length":30}]}]})";

std::string error_of(const std::string& text) {
  const Result<ToolLibrary> library = read_tool_library("lib.json", text);
  return library ? "none" : to_text(library.error());
}

std::string with_cutter(const std::string& cutter) {
  return "{\"units\":\"mm\",\n\"tools\":[\n{\"number\":3,\"name\":\"x\",\n\"cutter\":" + cutter + "}]}";
}

TEST(ToolLibrary, ReadsTheExampleOfTheFormat) {
  const Result<ToolLibrary> library = read_tool_library("lib.json", kGood);
  ASSERT_TRUE(library.has_value());
  EXPECT_TRUE(library->notes.empty());
  const ToolAssembly* tool = library->with_number(1);
  ASSERT_NE(tool, nullptr);
  EXPECT_EQ(tool, library->with_name("ball D10"));
  EXPECT_EQ(std::get<BallCutter>(tool->cutter).diameter_mm, 10);
  EXPECT_EQ(tool->shank.size(), 1u);
  ASSERT_EQ(tool->holder.size(), 2u);
  EXPECT_EQ(tool->holder[1].upper_diameter_mm, 46);
  EXPECT_EQ(library->with_number(2), nullptr);
  EXPECT_EQ(library->with_name("ball"), nullptr);
}

TEST(ToolLibrary, InchesBecomeMillimetresButAnglesStay) {
  const Result<ToolLibrary> library = read_tool_library("lib.json", R"({"units":"inch","tools":[{"name":"t","cutter":
      {"shape":"tapered","diameter":0.25,"corner_radius":0.125,"taper_angle":3,"length":1}}]})");
  ASSERT_TRUE(library.has_value());
  const auto& cutter = std::get<TaperedCutter>(library->tools[0].cutter);
  EXPECT_EQ(cutter.diameter_mm, 6.35);
  EXPECT_EQ(cutter.taper_angle_deg, 3);
  EXPECT_EQ(cutter.length_mm, 25.4);
}

TEST(ToolLibrary, EveryShapeSurvivesARoundTripInBothUnits) {
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
    ToolLibrary library;
    library.unit = unit;
    for (ToolAssembly tool : test::sample_tools()) {
      tool.number = static_cast<int>(library.tools.size());
      library.tools.push_back(tool);
    }
    library.holders.push_back({"ER32", {{50, 40.1, 33.3}}});
    const std::string text = write_tool_library(library);
    const Result<ToolLibrary> back = read_tool_library("lib.json", text);
    ASSERT_TRUE(back.has_value()) << back.error().message;
    EXPECT_EQ(write_tool_library(*back), text);
    ASSERT_EQ(back->tools.size(), library.tools.size());
    for (std::size_t i = 0; i < library.tools.size(); ++i) {
      EXPECT_EQ(make_profile(back->tools[i])->elements.back().a, make_profile(library.tools[i])->elements.back().a);
      EXPECT_EQ(length_mm(back->tools[i].cutter), length_mm(library.tools[i].cutter));
    }
    EXPECT_EQ(back->holders[0].segments[0].upper_diameter_mm, 40.1);
  }
}

TEST(ToolLibrary, HoldersHaveNamesOrBelongToTools) {
  const Result<ToolLibrary> library = read_tool_library("lib.json", R"({"units":"mm",
    "holders":[{"name":"ER16","segments":[{"lower_diameter":28,"upper_diameter":28,"length":40}]}],
    "tools":[{"number":1,"name":"a","cutter":{"shape":"flat","diameter":6,"length":20},"holder":"ER16"},
             {"number":2,"name":"b","cutter":{"shape":"flat","diameter":6,"length":20}}]})");
  ASSERT_TRUE(library.has_value()) << library.error().message;
  EXPECT_EQ(library->tools[0].holder.size(), 1u);
  ASSERT_TRUE(library->holder_called("ER16").has_value());
  EXPECT_TRUE(library->holder_called("a").has_value());
  EXPECT_FALSE(library->holder_called("b").has_value()) << "this tool has none";
  EXPECT_FALSE(library->holder_called("c").has_value());
}

TEST(ToolLibrary, ATextMayBeTheNameOfOneToolAndTheNumberOfAnother) {
  const auto tool = [](std::optional<int> number, const std::string& name) {
    ToolAssembly one;
    one.number = number;
    one.name = name;
    return one;
  };
  ToolLibrary library;
  library.tools = {tool(6, "A"), tool(3, "6"), tool(1, "1"), tool(2, "")};
  EXPECT_EQ(library.two_tools_called("6"),
            "the number of T6 \"A\" and the name of T3 \"6\"; expected 'A' for the first, or '3' for the second");
  for (const char* one : {"A", "T6", "3", "1", "2", "7", "B"}) EXPECT_EQ(library.two_tools_called(one), "") << one;
  library.tools = {tool(6, ""), tool({}, "6")};
  EXPECT_EQ(
      library.two_tools_called("6"),
      "the number of T6 and the name of \"6\"; expected 'T6' for the first, or another name in the library for the "
      "second");
}

/// The uncertainty of T1 of a library with these holders, T1's key "holder", and these keys beside "tools".
std::string uncertainty(const std::string& holders, const std::string& holder, const std::string& beside = "") {
  const Result<ToolLibrary> library =
      read_tool_library("lib.json", R"({"units":"mm","holders":[)" + holders +
                                        R"(],"tools":[{"name":"b","cutter":{"shape":"flat","diameter":6,"length":20},
                                    "holder":[{"lower_diameter":28,"upper_diameter":28,"length":40,"unit":"inch"}]},
                                   {"number":1,"cutter":{"shape":"flat","diameter":6,"length":20},"holder":)" +
                                        holder + "}]" + beside + "}");
  EXPECT_TRUE(library.has_value()) << library.error().message;
  if (!library) return "error";
  const Result<ToolLibrary> again = read_tool_library("again.json", write_tool_library(*library));
  EXPECT_TRUE(again.has_value());
  const ToolAssembly& tool = library->tools.at(1);
  const std::string why = tool.uncertainty + tool.missing_holder;
  EXPECT_EQ(again->tools.at(1).uncertainty, why);
  return why;
}

TEST(ToolLibrary, AKeyOfASharedHolderMakesEachOfItsToolsUncertain) {
  const auto of = [](const std::string& keys) { return uncertainty(R"({"name":"E",)" + keys + "}", R"("E")"); };
  const std::string segment = R"({"lower_diameter":28,"upper_diameter":28,"length":40)";
  EXPECT_EQ(of("\"segments\":[" + segment + "}]"), "");
  EXPECT_EQ(of("\"segments\":[" + segment + "}],\"comment\":\"inch\""), "");
  EXPECT_EQ(of("\"units\":\"inch\",\"segments\":[" + segment + "}]"),
            "holder \"E\": its entry has a key \"units\" that is not understood and was left out");
  EXPECT_EQ(of("\"segments\":[" + segment + ",\"unit\":\"inch\"}]"),
            "holder \"E\": its entry has a key \"unit\" that is not understood and was left out");
  EXPECT_EQ(of("\"uncertain\":\"not measured\",\"segments\":[" + segment + "}]"), "holder \"E\": not measured");
  EXPECT_EQ(uncertainty("", R"("b")"),
            "holder \"b\": its entry has a key \"unit\" that is not understood and was left out");
}

TEST(ToolLibrary, AHolderWithoutSegmentsIsMissing) {
  EXPECT_EQ(uncertainty("", "[]"), "its holder has no segments");
  EXPECT_EQ(uncertainty(R"({"name":"E","segments":[]})", R"("E")"), "holder \"E\": it has no segments");
}

TEST(ToolLibrary, AKeyOfTheWholeLibraryMakesAllItsToolsAndHoldersUncertain) {
  const std::string holder = R"({"name":"E","segments":[{"lower_diameter":28,"upper_diameter":28,"length":40}]})";
  EXPECT_EQ(uncertainty(holder, R"("E")", R"(,"holder":"F")"),
            "the library has a key \"holder\" that is not understood and was left out");
  EXPECT_EQ(uncertainty(holder, R"("E")", R"(,"comment":"F","$schema":"s")"), "");
  const Result<ToolLibrary> holders =
      read_tool_library("lib.json", R"({"units":"mm","unit":"inch","tools":[],"holders":[)" + holder + "]}");
  ASSERT_TRUE(holders.has_value());
  EXPECT_EQ(holders->holder_called("E")->uncertainty,
            "the library has a key \"unit\" that is not understood and was left out");
}

TEST(ToolLibrary, UnknownKeysAreReportedWithTheirLine) {
  const Result<ToolLibrary> library = read_tool_library(
      "lib.json", with_cutter("{\"shape\":\"flat\",\"diameter\":6,\"length\":20,\n\"corner_radius\":1}"));
  ASSERT_TRUE(library.has_value());
  ASSERT_EQ(library->notes.size(), 1u);
  EXPECT_EQ(to_text(library->notes[0]),
            "lib.json:5: warning: tool T3 \"x\": cutter has a key \"corner_radius\" that is not understood and was "
            "left out [library-unknown-key]");
}

TEST(ToolLibrary, MistakesNameLineToolAndField) {
  EXPECT_EQ(
      error_of(with_cutter("{\"shape\":\"flat\",\"diameter\":6}")),
      "lib.json:4: error: tool T3 \"x\": cutter has no \"length\"; it needs one, and has \"diameter\", \"shape\" [library-field]");
  EXPECT_EQ(error_of(with_cutter("{\"shape\":\"flat\",\n\"diameter\":\"6 mm\",\"length\":20}")),
            "lib.json:5: error: tool T3 \"x\": cutter: \"diameter\" is a text; expected a number [library-field]");
  EXPECT_EQ(error_of(with_cutter("{\"shape\":\"gimlet\"}")),
            "lib.json:4: error: tool T3 \"x\": cutter: shape is \"gimlet\"; expected one of flat, ball, bull_nose, "
            "tapered, apt, drill, chamfer, lollipop, t_slot, slitting_saw, dovetail, barrel, oval, lens, face_mill, "
            "radius_mill, profile [library-field]");
  EXPECT_EQ(error_of(with_cutter("{\"shape\":\"bull_nose\",\"diameter\":6,\"corner_radius\":4,\"length\":20}")),
            "lib.json:3: error: tool T3 \"x\": cutter: corner_radius 4 mm is larger than half the diameter; at most 3 "
            "mm is possible [tool-corner-radius-too-large]");
  EXPECT_EQ(error_of(with_cutter("{\"shape\":\"flat\",\"diameter\":6,\"length\":20},\n\"shank\":[{\"lower_diameter\":0,"
                                 "\"upper_diameter\":3,\"length\":3}]")),
            "lib.json:3: error: tool T3 \"x\": shank 1: lower_diameter is 0 mm; it must be greater than 0 "
            "[tool-dimension-not-positive]");
}

TEST(ToolLibrary, WrongFilesGetOneClearMessage) {
  EXPECT_EQ(error_of(""),
            "lib.json: error: the file is empty (0 bytes); expected a tool library (JSON) [library-syntax]");
  EXPECT_EQ(error_of("{\"units\":\"mm\",\n\"tools\":[\n{,}]}"),
            "lib.json:3: error: this is not JSON: there is a mistake at or before column 2: found '{,'; expected a "
            "tool library [library-syntax]");
  EXPECT_EQ(error_of("{\"units\":\"mm\",\n\"tools\":["),
            "lib.json:2: error: this is not JSON: it ends before its last bracket is closed; the file may be cut off; "
            "expected a tool library [library-syntax]");
  EXPECT_EQ(error_of("  \"units\": mm"),
            "lib.json:1: error: this is not JSON: there is a mistake at or before column 10: found '\"units\":'; "
            "expected a tool library [library-syntax]");
  EXPECT_EQ(error_of("[1]"), "lib.json:1: error: the library is a list; expected an object [library-field]");
  EXPECT_EQ(error_of("{\"tools\":[]}"),
            "lib.json:1: error: the library does not say its unit; add \"units\": \"mm\" or \"inch\" [library-field]");
  EXPECT_EQ(error_of("{\"units\":\"cm\",\"tools\":[]}"),
            "lib.json:1: error: units is \"cm\"; expected \"mm\" or \"inch\" [library-field]");
  EXPECT_EQ(error_of("{\"units\":\"mm\",\"tools\":[]}"),
            "lib.json:1: error: the list of tools is empty; it needs at least one [library-empty]");
  EXPECT_EQ(error_of("{\"units\":\"mm\",\n\"units\":\"inch\",\"tools\":[]}"),
            "lib.json:2: error: the key /units is there twice; remove one [library-duplicate-key]");
  EXPECT_EQ(error_of(R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"flat","diameter":6,"length":20}},
                     {"number":1,"cutter":{"shape":"flat","diameter":8,"length":20}}]})"),
            "lib.json:2: error: tool T1: number 1 is already taken; give every tool a number of its own "
            "[library-duplicate-number]");
  EXPECT_EQ(error_of(R"({"units":"mm","tools":[{"cutter":{"shape":"flat","diameter":6,"length":20}}]})"),
            "lib.json:1: error: tool at position 1 has neither \"number\" nor \"name\"; it needs one to be found by "
            "[library-field]");
  EXPECT_NE(error_of(with_cutter("{\"shape\":\"flat\",\"diameter\":1e400,\"length\":20}")), "none");
  EXPECT_NE(error_of(with_cutter("{\"shape\":\"flat\",\"diameter\":nan,\"length\":20}")), "none");
}

ToolLibrary sample_library() {
  const Result<std::string> bytes = read_file(source_folder() + "/samples/tool_shapes.json");
  EXPECT_TRUE(bytes.has_value());
  const Result<ToolLibrary> library = read_tool_library("tool_shapes.json", *bytes);
  EXPECT_TRUE(library.has_value()) << (library ? "" : library.error().message);
  return library ? *library : ToolLibrary{};
}

TEST(ToolLibrary, TheSampleLibraryShowsEveryShapeAndSurvivesARoundTrip) {
  const ToolLibrary library = sample_library();
  EXPECT_TRUE(library.notes.empty());
  std::set<std::string> shapes;
  for (const ToolAssembly& tool : library.tools) {
    shapes.insert(shape_name(tool.cutter));
    const Result<ToolVariants> variants = make_tool_variants(tool, 0.2, 0.5, 1);
    ASSERT_TRUE(variants.has_value()) << tool.name << ": " << variants.error().message;
    EXPECT_EQ(test::verify_tool(variants->against_part), std::vector<std::string>{}) << tool.name;
  }
  EXPECT_EQ(shapes.size(), every_shape().size());
  const std::string text = write_tool_library(library);
  const Result<ToolLibrary> back = read_tool_library("back.json", text);
  ASSERT_TRUE(back.has_value()) << back.error().message;
  EXPECT_EQ(write_tool_library(*back), text);
  for (std::size_t i = 0; i < library.tools.size(); ++i) {
    const Profile one = *make_profile(library.tools[i]), other = *make_profile(back->tools[i]);
    ASSERT_EQ(one.elements.size(), other.elements.size()) << library.tools[i].name;
    for (std::size_t k = 0; k < one.elements.size(); ++k) EXPECT_EQ(one.elements[k].b, other.elements[k].b);
  }
}

TEST(ToolLibrary, PointsAndExtensionsAreReadWithCare) {
  const auto with_points = [](const std::string& points) {
    return with_cutter("{\"shape\":\"profile\",\"points\":" + points + "}");
  };
  EXPECT_EQ(error_of(with_cutter("{\"shape\":\"profile\"}")),
            "lib.json:4: error: tool T3 \"x\": cutter has no \"points\"; it needs them [library-field]");
  EXPECT_EQ(error_of(with_points("[{\"r\":0,\"z\":0},{\"r\":2,\"z\":0,\"arc\":\"round\",\"radius\":3}]")),
            "lib.json:4: error: tool T3 \"x\": cutter: point 2: arc is \"round\"; expected \"convex\" or \"concave\" "
            "[library-field]");
  EXPECT_EQ(error_of(with_points("[{\"r\":0,\"z\":0},{\"r\":2,\"z\":0,\"radius\":3}]")),
            "lib.json:4: error: tool T3 \"x\": cutter: point 2 has a radius but no \"arc\"; add \"arc\": \"convex\" or "
            "\"concave\" [library-field]");
  const std::string flat = "{\"shape\":\"flat\",\"diameter\":6,\"length\":20}";
  EXPECT_EQ(error_of(with_cutter(flat + ",\"extensions\":[{\"name\":\"a\"}]")),
            "lib.json:4: error: tool T3 \"x\": extension 1 has no \"segments\"; it needs at least one [library-field]");
  EXPECT_EQ(error_of(with_cutter(
                flat + ",\"stickout\":30,\"holder\":[{\"lower_diameter\":30,\"upper_diameter\":30,\"length\":30}]")),
            "lib.json:3: error: tool T3 \"x\": stickout 30 mm is more than flutes and shank reach, 20 mm; give at most "
            "that, or a longer shank [tool-stickout]");
  const Result<ToolLibrary> gauge = read_tool_library(
      "lib.json",
      with_cutter(flat +
                  ",\"gauge_length\":90,\"holder\":[{\"lower_diameter\":30,\"upper_diameter\":30,\"length\":30}]"));
  ASSERT_TRUE(gauge.has_value());
  ASSERT_EQ(gauge->notes.size(), 1u);
  EXPECT_EQ(to_text(gauge->notes[0]),
            "lib.json:4: warning: tool T3 \"x\": gauge_length 90 mm is more than the assembly, which ends at 50 mm; "
            "what is between is not in the file and not checked [tool-gauge-length]");
}

TEST(ToolLibrary, AToolThatDoesNotCutStaysOne) {
  const std::string flat = "{\"shape\":\"flat\",\"diameter\":6,\"length\":20}";
  const Result<ToolLibrary> probe = read_tool_library("lib.json", with_cutter(flat + ",\"cuts\":false"));
  ASSERT_TRUE(probe.has_value());
  EXPECT_FALSE(probe->tools.front().cuts);
  const Result<ToolLibrary> again = read_tool_library("lib.json", write_tool_library(*probe));
  ASSERT_TRUE(again.has_value());
  EXPECT_FALSE(again->tools.front().cuts);
  EXPECT_EQ(error_of(with_cutter(flat + ",\"cuts\":\"no\"")),
            "lib.json:4: error: tool T3 \"x\": \"cuts\" is neither true nor false [library-field]");
}

// Every single damage to a good file is a clean result, never a crash, and what reads builds.
TEST(ToolLibrary, DamagedFilesNeverCrash) {
  test::Scatter random(31);
  ToolLibrary sample = sample_library();
  sample.holders.clear();
  const std::string all = write_tool_library(sample);
  const std::string good(kGood);
  for (int k = 0; k < 30000; ++k) {
    std::string text = k % 30 == 0 ? all : good;
    for (std::uint64_t n = 1 + random.next() % 3; n > 0; --n) {
      const std::size_t at = random.next() % text.size();
      switch (random.next() % 4) {
        case 0:
          text[at] = static_cast<char>(random.next() % 256);
          break;
        case 1:
          text.erase(at, 1 + random.next() % 20);
          break;
        case 2:
          text.insert(at, std::string(1, "{}[],:\"0-e"[random.next() % 10]));
          break;
        default:
          text.resize(at + 1);
      }
      if (text.empty()) text = "{";
    }
    const Result<ToolLibrary> library = read_tool_library("lib.json", text);
    if (!library) continue;
    for (const ToolAssembly& tool : library->tools) EXPECT_TRUE(make_profile(tool).has_value());
  }
}

TEST(ToolLibrary, DeepNestingIsNotAProblem) {
  EXPECT_NE(error_of(std::string(200000, '[')), "none");
  EXPECT_NE(error_of("{\"units\":\"mm\",\"tools\":" + std::string(20000, '[') + std::string(20000, ']') + "}"), "none");
}

}  // namespace
}  // namespace gouge::tool_library_test
