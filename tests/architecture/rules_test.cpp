#include <gtest/gtest.h>

#include "tests/architecture/source_rules.h"
#include "tests/architecture/wording_rules.h"

// The rules themselves, tried on small bad and good examples.

namespace gouge::architecture::rules_test {
namespace {

Module room(const std::string& path, const std::vector<std::string>& imports) { return {path, imports, {}, {}}; }

const std::vector<Module> kModules = {room("lib/base", {}),
                                      room("lib/mesh", {"lib/base"}),
                                      room("lib/check", {"lib/base", "lib/mesh"}),
                                      room("toolmodels", {"lib/base"}),
                                      room("postproc/report", {"lib/base", "lib/check"}),
                                      room("cli", {"lib/base", "toolmodels", "postproc/report"})};

TEST(Modules, AreReadFromCMakeCalls) {
  const auto modules =
      modules_of("gouge_module(lib/mesh\n  SOURCES a.cpp\n  IMPORTS lib/base lib/geom\n  LIBRARIES X::y)\n");
  ASSERT_EQ(modules.size(), 1U);
  EXPECT_EQ(modules[0].path, "lib/mesh");
  EXPECT_EQ(modules[0].imports, (std::vector<std::string>{"lib/base", "lib/geom"}));
}

TEST(Modules, OneWayImportsAreAccepted) { EXPECT_EQ(check_modules(kModules), Complaints{}); }

TEST(Modules, UpwardSidewaysUnknownAndCircularImportsAreRefused) {
  EXPECT_EQ(check_modules({room("lib/base", {"toolmodels"}), room("toolmodels", {})}),
            (Complaints{"lib/base: imports toolmodels, which does not lie below it"}));
  EXPECT_EQ(check_modules({room("toolmodels", {"postproc/report"}), room("postproc/report", {})}),
            (Complaints{"toolmodels: imports postproc/report, which does not lie below it"}));
  EXPECT_EQ(check_modules({room("cli", {"samples"}), room("samples", {})}),
            (Complaints{"cli: imports samples, which does not lie below it"}));
  EXPECT_EQ(check_modules({room("cli/tools", {}), room("cli", {"cli/tools"})}), Complaints{});
  EXPECT_EQ(check_modules({room("cli/tools", {"cli"}), room("cli", {})}),
            (Complaints{"cli/tools: imports cli, which does not lie below it"}));
  EXPECT_EQ(check_modules({room("cli", {"lib/nowhere"})}),
            (Complaints{"cli: imports lib/nowhere, which is no module"}));
  EXPECT_EQ(check_modules({room("lib/a", {"lib/b"}), room("lib/b", {"lib/a"}), room("lib/c", {})}),
            (Complaints{"lib/a: imports itself through other rooms", "lib/b: imports itself through other rooms"}));
}

TEST(Includes, OfImportedModulesAndOfTheOwnModuleAreAccepted) {
  EXPECT_EQ(check_includes({{"lib/check/a.cpp",
                             "#include \"lib/check/a.h\"\n#include <vector>\n"
                             "#include \"lib/mesh/m.h\"\n"}},
                           kModules),
            Complaints{});
}

TEST(Includes, OfOtherModulesAreRefusedWithTheirLine) {
  EXPECT_EQ(check_includes({{"lib/mesh/m.h", "#pragma once\n#  include \"lib/check/verdict.h\"\n"}}, kModules),
            (Complaints{"lib/mesh/m.h:2: includes lib/check/verdict.h, but lib/mesh does not import lib/check"}));
  EXPECT_EQ(check_includes({{"toolmodels/t.cpp", "#include \"t.h\"\n"}}, kModules),
            (Complaints{"toolmodels/t.cpp:1: includes t.h, which lies in no module"}));
}

TEST(ClosedHeaders, AreForTheirRoomForThoseItNamesAndForTheirTests) {
  const std::vector<Module> modules = {
      modules_of("gouge_module(lib/a HEADERS a.h CLOSED part.h CLOSED_FOR lib/all)\n")[0], room("lib/all", {"lib/a"}),
      room("lib/other", {"lib/a"}), room("cli", {"lib/a"})};
  const std::string text = "#include \"lib/a/part.h\"\n#include \"lib/a/a.h\"\n";
  for (const char* allowed :
       {"lib/a/a.cpp", "lib/all/x.h", "tests/lib/a/t.cpp", "tests/lib/all/t.cpp", "tests/bench/b.cpp"})
    EXPECT_EQ(check_closed_headers({{allowed, text}}, modules), Complaints{}) << allowed;
  for (const std::string refused :
       {"lib/other/o.h", "cli/c.cpp", "tests/laws/l.cpp", "tests/lib/other/t.cpp", "tests/support/s.h"}) {
    EXPECT_EQ(check_closed_headers({{refused, text}}, modules),
              (Complaints{refused + ":1: includes lib/a/part.h, which lib/a keeps closed"}));
  }
}

TEST(HeavyLibraries, StayInFewSourcesOfTheirModule) {
  EXPECT_EQ(check_heavy_libraries({{"lib/validate/v.cpp", "#include <CGAL/Surface_mesh.h>\n"},
                                   {"postproc/image/c.cpp", "#include <opencv2/core.hpp>\n"}}),
            Complaints{});
  EXPECT_EQ(check_heavy_libraries({{"lib/mesh/m.cpp", "#include <CGAL/Surface_mesh.h>\n"}}),
            (Complaints{"lib/mesh/m.cpp:1: includes CGAL/Surface_mesh.h, which only a source of lib/validate/ may"}));
  EXPECT_EQ(check_heavy_libraries({{"postproc/image/a.h", "#include <opencv2/core.hpp>\n"}}).size(), 1U);
  EXPECT_EQ(check_heavy_libraries({{"postproc/image/a.cpp", "#include <opencv2/core.hpp>\n"},
                                   {"postproc/image/b.cpp", "#include <opencv2/core.hpp>\n"}}),
            (Complaints{"opencv2/ is included by 2 files; it may be by 1"}));
}

TEST(BannedWords, AreFoundInCodeBelowCli) {
  EXPECT_EQ(check_banned_words({{"lib/mesh/m.cpp", "void f() {\n  std::cout << 1;\n}\n"}}),
            (Complaints{"lib/mesh/m.cpp:2: uses cout below cli"}));
  for (const char* line : {"std::printf(\"x\");", "exit(1);", "std::abort();", "throw 1;", "std::hypot(a, b);"}) {
    EXPECT_EQ(check_banned_words({{"toolmodels/t.cpp", line}}).size(), 1U) << line;
  }
}

TEST(BannedWords, MayStandInCommentsInTextInLongerNamesAndInCli) {
  EXPECT_EQ(check_banned_words({{"lib/a.cpp",
                                 "// never exit here\n/* printf\n throw */ int on_exit = 0;\n"
                                 "auto s = \"cannot exit\"; auto r = R\"(throw \")\"; int n = 1'000;\n"},
                                {"lib/b.cpp", "  throw;\n"},
                                {"cli/main.cpp", "std::exit(1);\n"}}),
            Complaints{});
}

TEST(Seams, MotionsAreMadeByTheirLawAlone) {
  for (const char* line : {"const Motion m(from, to);", "Motion(start, end)", "f(Motion(motion.at(0), to));"})
    EXPECT_EQ(check_seams({{"lib/tilt/t.cpp", line}}).size(), 1U) << line;
  EXPECT_EQ(check_seams(
                {{"lib/motion/motion_law.cpp", "Motion(from, to)"},
                 {"lib/tilt/t.cpp", "void f(const Motion& a); Motion shifted(std::size_t i); law.straight(from, to)"}}),
            Complaints{});
}

TEST(Seams, KindsOfObstaclesAreNamedInTheContactTableAlone) {
  const std::string both = "f(scene.parts); g(scene.fixtures);";
  EXPECT_EQ(check_seams({{"lib/head/h.cpp", both}}).size(), 1U);
  EXPECT_EQ(check_seams({{"lib/head/h.cpp", "a = Against::part; b = Against::fixture;"}}).size(), 1U);
  EXPECT_EQ(check_seams(
                {{"lib/check/contact_rule.h", both}, {"lib/verify/v.cpp", both}, {"lib/head/h.cpp", "f(scene.parts)"}}),
            Complaints{});
}

TEST(Seams, FormatsAreNamedInTheirTableAlone) {
  const std::string line = "#include \"postproc/cldata/nccs/nccs_records.h\"\n";
  EXPECT_EQ(check_formats({{"postproc/cldata/reading/read_cl_data.cpp", line}}).size(), 1U);
  EXPECT_EQ(check_formats({{"cli/job/job.cpp", line}}).size(), 1U);
  EXPECT_EQ(check_formats({{"postproc/formats/toolpath_format.cpp", line},
                           {"postproc/cldata/nccs/nccs_edits.cpp", line},
                           {"tests/postproc/cldata/nccs_file.h", line}}),
            Complaints{});
}

TEST(Tolerances, AreNamedInTheirHeader) {
  for (const char* line : {"constexpr double kRounding_mm = 1e-9;", "if (x < 1e-12) f();", "if (x > 2.5e-6) f();"})
    EXPECT_EQ(check_tolerances({{"lib/tilt/t.cpp", line}}).size(), 1U) << line;
  for (const char* line : {"constexpr double kLeast = 1e-6;", "if (x < 1e-3) f();", "max(x, 1e-30F);", "// 1e-9",
                           "f(Tolerance::kRounding_mm);"})
    EXPECT_EQ(check_tolerances({{"lib/tilt/t.cpp", line}}), Complaints{}) << line;
  EXPECT_EQ(check_tolerances({{"lib/verify/v.cpp", "if (x < 1e-12) f();"}}), Complaints{});
}

TEST(RandomNumbers, OfAStandardLibraryAreRefused) {
  for (const char* line : {"std::mt19937 r(1);", "std::uniform_real_distribution<double> u;", "std::shuffle(a, b, r);",
                           "p = Vec3::Random();", "n = rand() % 6;"}) {
    EXPECT_EQ(check_random_numbers({{"tests/t.cpp", line}}).size(), 1U) << line;
  }
  EXPECT_EQ(check_random_numbers({{"tests/t.cpp", "random.shuffle(a); // not std::shuffle\noperand(x);\n"}}),
            Complaints{});
}

TEST(TemporaryFolders, OfFixedNamesAreRefused) {
  for (const char* line : {"file = testing::TempDir() + name;", "folder = fs::temp_directory_path() / name;"}) {
    EXPECT_EQ(check_temporary_folders({{"tests/t.cpp", line}}).size(), 1U) << line;
    EXPECT_EQ(check_temporary_folders({{"cli/a.cpp", line}, {"tests/support/temporary_folder.h", line}}), Complaints{});
  }
}

TEST(FileSearches, OfReadersThatNoteNoneAreRefused) {
  for (const char* line : {"for (fs::directory_iterator at(folder), end; at != end; ++at) {}",
                           "if (fs::exists(file)) {}", "if (std::filesystem::is_regular_file(file)) {}"}) {
    EXPECT_EQ(check_file_searches({{"toolmodels/import/a.cpp", line}, {"cli/machine/b.cpp", line}}).size(), 2U) << line;
    EXPECT_EQ(check_file_searches({{"cli/batch/a.cpp", line}, {"lib/base/file_search.cpp", line}}), Complaints{});
  }
}

TEST(Shape, LongFilesAndHeadersWithoutPragmaOnceAreRefused) {
  std::string long_text;
  for (int i = 0; i < 501; ++i) long_text += "\n";
  const Complaints complaints =
      check_shape({{"lib/a.cpp", long_text}, {"lib/b.h", "int x;\n"}, {"lib/c.h", "#pragma once\n"}});
  EXPECT_EQ(complaints,
            (Complaints{"lib/a.cpp:501: is longer than 500 lines", "lib/b.h:1: a header begins with #pragma once"}));
}

TEST(Shape, ALargeMedianIsRefused) {
  std::string text;
  for (int i = 0; i < 151; ++i) text += "\n";
  EXPECT_EQ(check_shape({{"lib/a.cpp", text}}),
            (Complaints{"the median length of a file is 151 lines; at most 150 is wanted"}));
}

TEST(StrayText, NotesToSelfAndMachinePathsAreRefused) {
  EXPECT_EQ(check_stray_text({{"docs/a.md", std::string("fine\nTO") + "DO: later\n"}}),
            (Complaints{std::string("docs/a.md:2: has a TO") + "DO"}));
  EXPECT_EQ(check_stray_text({{"lib/a.h", std::string("// see /wo") + "rk/x\n"}}).size(), 1U);
  EXPECT_EQ(check_stray_text({{"lib/a.h", "// framework/x, a method\n"}}), Complaints{});
}

TEST(Wording, RelativeClausesPrivateWordsAndOldLimitsAreRefused) {
  const std::vector<SourceFile> files = {
      {"lib/a/a.h", "/// What it is.\n/// What goes on in the same comment may.\nint a;\nint b;  ///< Whether b\n"},
      {"lib/a/b.h", "// Nobody knows.\n// \"nobodys\" is another word.\n"},
      {"lib/a/b.cpp", "// What a source's comment begins with is free.\nconstexpr int kMostThings = 1;\n"},
      {"cli/c.cpp", "help(\"as it was looked at\");\n"},
      {"docs/p.md", "In vain.\n```\nin vain\n```\n"}};
  EXPECT_EQ(check_wording(files), (Complaints{"lib/a/a.h:1: begins a comment with \"What\"; begin with a verb",
                                              "lib/a/a.h:4: begins a comment with \"Whether\"; begin with a verb",
                                              "lib/a/b.h:1: uses \"nobody\"; see docs/conventions.md",
                                              "lib/a/b.cpp:2: names a limit; expected kMax or kMin",
                                              "cli/c.cpp:1: uses \"looked at\"; see docs/conventions.md",
                                              "docs/p.md:1: uses \"in vain\"; see docs/conventions.md"}));
}

TEST(TypeNames, OfTwoHeadersAreTwo) {
  const std::string head = "#pragma once\nnamespace gouge {\n";
  EXPECT_EQ(check_type_names({{"lib/a.h", head + "struct A {\n};\nstruct C;\n"},
                              {"lib/b.h", head + "class A final : public C {\n};\nstruct C;\n"}}),
            (Complaints{"lib/b.h:3: defines A again, after lib/a.h"}));
  EXPECT_EQ(check_type_names({{"lib/a.h", head + "class X_EXPORT A {\n"}, {"lib/b.h", head + "class X_EXPORT B {\n"}}),
            Complaints{});
  EXPECT_EQ(
      check_type_names({{"lib/a.h", head + "struct A {\n"}, {"lib/b.h", "namespace gouge::detail {\nstruct A {\n"}}),
      Complaints{});
}

TEST(MessageCodes, AreReadFromSourcesAndFromTables) {
  EXPECT_EQ(message_codes_of("make_error(\"stl-empty\", \"is empty\"); f(\"path-\" + x); g(\"clean\");"),
            (std::set<std::string>{"stl-empty"}));
  EXPECT_EQ(documented_codes_of("\n| `stl-empty` | the file |\n| `clean` | `mesh-open` |\n"),
            (std::set<std::string>{"stl-empty"}));
}

TEST(Documents, LinksToFilesAndQuotedPathsAreRead) {
  EXPECT_EQ(file_links_of("[a](b.md#part) ![c](d/e.png) [f](https://example.org/x) [g](#h)"),
            (std::vector<std::string>{"b.md", "d/e.png"}));
  EXPECT_EQ(quoted_paths_of("`lib/mesh` and `a b` and `tests/x_test` or `lib/*`, `not/ours`"),
            (std::vector<std::string>{"lib/mesh", "tests/x_test"}));
}

}  // namespace
}  // namespace gouge::architecture::rules_test
