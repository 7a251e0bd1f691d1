// No correction makes anything worse: random programs, the samples and real pairs. GOUGE_CORRECTIONS sets how many
// random programs, GOUGE_FIRST_CORRECTION the number of the first.
#include "tests/laws/correction_laws.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>

#include "lib/base/files.h"
#include "postproc/formats/write_corrected.h"
#include "samples/cases.h"
#include "samples/write_sample.h"
#include "tests/laws/correction_scenes.h"
#include "tests/laws/guarantee.h"
#include "tests/support/rotary_head_law.h"
#include "tests/support/source_folder.h"
#include "tests/support/temporary_folder.h"

namespace gouge::laws::correction_laws_test {
namespace {

std::size_t number_of(const char* name, std::size_t usual) {
  const char* given = std::getenv(name);
  return given == nullptr ? usual : std::strtoull(given, nullptr, 10);
}

Result<LawfulCorrection> correct(const CorrectionScene& made, const CheckResult& before, const CheckSetup& setup,
                                 const CorrectOptions& correct) {
  const auto rewrite = [&](const std::vector<PathChange>& changes) -> Result<Toolpath> {
    const Result<std::string> text = write_corrected(made.path, changes);
    if (!text) return text.error();
    ReadOutcome read = read_toolpath("corrected.ncl", *text);
    if (!read.toolpath) return read.errors.front();
    return std::move(*read.toolpath);
  };
  return correct_lawfully(made.path, before, setup, correct, rewrite);
}

std::string places(const Figures& figures) {
  return std::to_string(figures.left_path_samples) + " of " + std::to_string(figures.kept_samples) +
         " places of changed feeds leave the programmed path though it is clean there, " +
         std::to_string(figures.listed_samples) + " of them on moves listed as left\n";
}

struct Way {
  BodyStrategies strategies = {};
  MotionLaw law = {};
  double max_shift_mm = 20;
  bool has_stock = false;  ///< the parts are cut from a block that is up to 20 mm larger
  std::optional<BodyStrategies> of_every_second = std::nullopt;  ///< strategies of every second program, if others
};

StockSetup block_about(const CorrectionScene& made, std::size_t number) {
  const Vec3 more = Vec3::Constant(static_cast<double>(number % 21));
  const Box3 box = box_of(made.scene.parts);
  return {.solid = StockSolid::box(box.min() - more, box.max() + more),
          .tools = {{&made.tool, true}},
          .options = {.tolerance_mm = 0.1, .resolution_mm = 0.05}};
}

/// Figures of all random programs, corrected in this way.
Figures hold_for_random(const Way& way) {
  const std::size_t first = number_of("GOUGE_FIRST_CORRECTION", 0), count = number_of("GOUGE_CORRECTIONS", 40);
  Figures figures;
  std::size_t with_gouges = 0;
  for (std::size_t n = first; n < first + count; ++n) {
    const CorrectionScene made = CorrectionScatter(n).scene();
    EXPECT_FALSE(made.path.moves.empty()) << n << "\n" << made.text;
    CheckOptions options;
    options.threads = 1;
    options.budget_per_move = 200'000;
    options.tolerance_mm = made.tolerance_mm;
    options.law = way.law;
    const PreparedScene scene = prepare_scene(made.scene, 1);
    const std::vector<HeadBody> heads;
    CheckSetup setup{{&made.tool}, heads, scene, options};
    const CheckResult before = check(made.path, setup);
    with_gouges += before.counts.gouge > 0 ? 1 : 0;
    CorrectOptions how;
    how.strategies = n % 2 == 1 ? way.of_every_second.value_or(way.strategies) : way.strategies;
    how.max_shift_mm = way.max_shift_mm;
    const RewritableMoves rewritable = rewritable_moves(made.path);
    how.rewritable = &rewritable;
    how.max_side_shift_mm = made.max_side_shift_mm;
    const StockSetup stock = block_about(made, n);
    if (way.has_stock) setup.stock = &stock;
    const Result<LawfulCorrection> corrected = correct(made, before, setup, how);
    setup.stock = nullptr;
    EXPECT_TRUE(corrected.has_value()) << n << ": " << corrected.error().message;
    if (!corrected) break;
    figures.uncut += corrected->correction.uncut.size();
    const CheckResult in_mesh = way.has_stock ? check(corrected->after.path, setup) : CheckResult();
    const Corrected all{.before = &made.path,
                        .result_before = &before,
                        .after = &corrected->after.path,
                        .result_after = way.has_stock ? &in_mesh : &corrected->after.result,
                        .correction = &corrected->correction,
                        .setup = &setup,
                        .max_side_shift_mm = made.max_side_shift_mm,
                        .max_shift_mm = how.max_shift_mm,
                        .in_stock = way.has_stock ? &corrected->after.result : nullptr};
    for (const std::string& broken : LawBook(all).broken(figures)) ADD_FAILURE() << "program " << n << " " << broken;
    if (::testing::Test::HasFailure()) {
      std::cout << made.text << "---- becomes\n" << corrected->after.path.source.view();
      for (const Uncorrected& u : corrected->correction.uncorrected) std::cout << u.move << ": " << u.reason << "\n";
      break;
    }
  }
  std::cout << count << " programs, " << with_gouges << " of them gouge: " << figures.gouges_before
            << " gouging moves became " << figures.gouges_after << ", " << figures.left << " of them listed as left; "
            << figures.changed << " moves changed, " << figures.added << " positions added, " << figures.uncut
            << " stretches left out, " << figures.rapids << " rapids measured, " << figures.low_rapids
            << " listed as low; " << places(figures);
  EXPECT_GT(with_gouges * 3, count);
  EXPECT_TRUE(way.has_stock || figures.left_path_samples * 100 <= figures.kept_samples + 500);
  return figures;
}

TEST(CorrectionLaws, HoldForRandomPrograms) {
  EXPECT_GT(hold_for_random({}).changed, number_of("GOUGE_CORRECTIONS", 40));
}

TEST(CorrectionLaws, HoldForRandomProgramsThatAreTrimmed) {
  EXPECT_GT(hold_for_random({.strategies = BodyStrategies::all(Strategy::trim)}).uncut,
            number_of("GOUGE_CORRECTIONS", 40) / 4);
}

TEST(CorrectionLaws, HoldWhereShiftsAreShort) {
  EXPECT_GT(hold_for_random({.max_shift_mm = 0.5}).changed, number_of("GOUGE_CORRECTIONS", 40) / 4);
}

TEST(CorrectionLaws, HoldInStock) {
  const Way way{.has_stock = true, .of_every_second = BodyStrategies::all(Strategy::trim)};
  EXPECT_GT(hold_for_random(way).changed, number_of("GOUGE_CORRECTIONS", 40));
}

TEST(CorrectionLaws, HoldUnderALawOfRotaryAxes) {
  const MotionLaw law(RapidMode::straight, std::make_shared<test::RotaryHeadLaw>());
  EXPECT_GT(hold_for_random({.law = law}).changed, number_of("GOUGE_CORRECTIONS", 40));
}

/// Corrects this toolpath as the program does and holds the laws against what was written.
void hold_for(const JobArguments& arguments) {
  const Job job = guarantee::load(arguments);
  const PreparedScene scene = prepare_scene(job.scene());
  const CheckSetup setup = job.setup(scene);
  const CheckResult before = check(job.toolpath, setup);
  const auto rewrite = [&](const std::vector<PathChange>& changes) -> Result<Toolpath> {
    const Result<std::string> text = write_corrected(job.toolpath, changes);
    if (!text) return text.error();
    return read_again(job, "corrected.apt", *text);
  };
  const RewritableMoves rewritable = rewritable_moves(job.toolpath);
  CorrectOptions how;
  how.rewritable = &rewritable;
  const Result<LawfulCorrection> corrected = correct_lawfully(job.toolpath, before, setup, how, rewrite);
  ASSERT_TRUE(corrected.has_value()) << corrected.error().message;
  const Corrected all{&job.toolpath,          &before, &corrected->after.path, &corrected->after.result,
                      &corrected->correction, &setup,  std::nullopt,           20};
  Figures figures;
  for (const std::string& broken : LawBook(all).broken(figures)) ADD_FAILURE() << broken;
  std::cout << figures.gouges_before << " gouging moves became " << figures.gouges_after << "; " << figures.changed
            << " changed, " << figures.added << " positions added; " << places(figures);
  EXPECT_LE(figures.left_path_samples * 100, figures.kept_samples + 500);
}

TEST(CorrectionLaws, HoldForEverySample) {
  const testing_support::TemporaryFolder folder;
  for (const samples::Sample& sample : samples::make_all()) {
    if (!sample.heads.empty()) continue;  // the laws' own means know no heads
    SCOPED_TRACE(sample.name);
    ASSERT_TRUE(samples::write_sample(sample, folder.path()).has_value());
    const std::string own = folder.at(sample.name) + "/";
    JobArguments arguments;
    arguments.path = own + sample.toolpath_file;
    arguments.tools_file = own + "tools.json";
    for (const auto& part : sample.parts) arguments.parts.push_back(own + part.file);
    for (const auto& fixture : sample.fixtures) arguments.fixtures.push_back(own + fixture.file);
    std::cout << sample.name << ": ";
    hold_for(arguments);
  }
}

struct Pair {
  const char* name;
  const char* toolpath;
  const char* part;
};

void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

class CorrectionLawsOnRealPairs : public ::testing::TestWithParam<Pair> {
 protected:
  // The toolpath with this change of each of its lines.
  void hold(const std::function<std::string(const std::string&)>& edit) {
    const std::filesystem::path data = std::filesystem::path(source_folder()) / "../shared/data";
    const std::filesystem::path path = data / "toolpaths" / GetParam().toolpath;
    JobArguments arguments;
    arguments.parts = {(data / "parts/matched" / GetParam().part).string()};
    if (!std::filesystem::exists(path) || !std::filesystem::exists(arguments.parts[0]))
      GTEST_SKIP() << "the shared data is not here";
    const testing_support::TemporaryFolder folder;
    const std::string file = folder.at("path.apt");
    std::ofstream(file, std::ios::binary) << edit(read_file(path.string()).value());
    arguments.path = file;
    arguments.reading.cutcom = "centre";
    const bool is_inch = std::string(GetParam().part).find("inch") != std::string::npos;
    arguments.stl_units = is_inch ? "inch" : "mm";
    hold_for(arguments);
  }
};

const Pair kPairs[] = {{"five_axis_part", "five_axis_part/subset_autodesk_iso4343.apt", "five_axis_part_inch.stl"},
                       {"Sacrifice_Board", "solidworks_cam/Sacrifice-Board.apt", "Sacrifice-Board.STL"},
                       {"SupPetriLED", "solidworks_cam/SupPetriLED.apt", "SupPetriLED.STL"},
                       {"basemach", "solidworks_cam/basemach.apt", "basemach.STL"},
                       {"Paralelipipedo2", "solidworks_cam/Paralelipipedo2.apt", "Paralelipipedo2.STL"}};

INSTANTIATE_TEST_SUITE_P(All, CorrectionLawsOnRealPairs, ::testing::ValuesIn(kPairs),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(CorrectionLawsOnRealPairs, Hold) {
  hold([](const std::string& text) { return text; });
}

// A cause that pushed the tool through the surface into solid metal: the right part, and one sign of the tool axis wrong.
TEST_P(CorrectionLawsOnRealPairs, HoldWithJNegated) {
  hold([](const std::string& text) {
    std::istringstream lines(text);
    std::string edited;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t slash = line.find("GOTO/");
      std::vector<std::string> numbers;
      std::istringstream rest(slash == std::string::npos ? "" : line.substr(slash + 5));
      for (std::string number; std::getline(rest, number, ',');) numbers.push_back(number);
      if (numbers.size() == 6) {
        std::string& j = numbers[4];
        const std::size_t minus = j.find('-');
        minus == std::string::npos ? j.insert(j.find_first_not_of(' '), "-") : j.erase(minus, 1);
        line = line.substr(0, slash + 5) + numbers[0];
        for (std::size_t k = 1; k < 6; ++k) line += "," + numbers[k];
      }
      edited += line + "\n";
    }
    return edited;
  });
}

}  // namespace
}  // namespace gouge::laws::correction_laws_test
