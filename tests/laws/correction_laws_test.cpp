// No correction makes anything worse: random programs, the samples and real pairs. GOUGE_CORRECTIONS sets how many random
// programs, GOUGE_FIRST_CORRECTION the number of the first.
#include "tests/laws/correction_laws.h"

#include <gtest/gtest.h>

#include <iostream>

#include "postproc/cldata/write_corrected.h"
#include "tests/laws/correction_scenes.h"

namespace gouge::laws {
namespace {

std::size_t number_of(const char* name, std::size_t usual) {
  const char* given = std::getenv(name);
  return given == nullptr ? usual : std::strtoull(given, nullptr, 10);
}

Result<LawfulCorrection> correct(const CorrectionScene& made, const CheckResult& before, const PreparedScene& scene,
                                 const CheckOptions& options, const CorrectOptions& correct) {
  const auto change = [&](const std::vector<PathChange>& changes) -> Result<ChangedPath> {
    const Result<std::string> text = write_corrected(made.path, changes);
    if (!text) return text.error();
    ReadOutcome read = read_toolpath("corrected.ncl", *text);
    if (!read.toolpath) return read.errors.front();
    CheckResult result = check_path(*read.toolpath, {&made.tool}, scene, options);
    return ChangedPath{std::move(*read.toolpath), std::move(result)};
  };
  return correct_lawfully(made.path, before, {&made.tool}, scene, options, correct, change);
}

TEST(CorrectionLaws, HoldForRandomPrograms) {
  const std::size_t first = number_of("GOUGE_FIRST_CORRECTION", 0), count = number_of("GOUGE_CORRECTIONS", 60);
  Figures figures;
  std::size_t with_gouges = 0;
  for (std::size_t n = first; n < first + count; ++n) {
    const CorrectionScene made = CorrectionScatter(n).scene();
    ASSERT_FALSE(made.path.moves.empty()) << n << "\n" << made.text;
    CheckOptions options;
    options.threads = 1;
    options.budget_per_move = 200'000;
    options.tolerance_mm = made.tolerance_mm;
    const PreparedScene scene = prepare_scene(made.scene, 1);
    const CheckResult before = check_path(made.path, {&made.tool}, scene, options);
    with_gouges += before.counts.gouge > 0 ? 1 : 0;
    CorrectOptions how;
    how.max_side_shift_mm = made.max_side_shift_mm;
    const Result<LawfulCorrection> corrected = correct(made, before, scene, options, how);
    ASSERT_TRUE(corrected.has_value()) << n << ": " << corrected.error().message;
    const Corrected all{&made.path, &before, &corrected->after.path, &corrected->after.result, &corrected->correction,
                        &made.scene, &scene, {&made.tool}, options, made.max_side_shift_mm, how.max_shift_mm};
    for (const std::string& broken : LawBook(all).broken(figures)) ADD_FAILURE() << "program " << n << " " << broken;
    if (::testing::Test::HasFailure()) {
      std::cout << made.text << "---- becomes\n" << corrected->after.path.source;
      for (const Uncorrected& u : corrected->correction.uncorrected) std::cout << u.move << ": " << u.reason << "\n";
      break;
    }
  }
  std::cout << count << " programs, " << with_gouges << " of them gouge: " << figures.gouges_before
            << " gouging moves became " << figures.gouges_after << ", " << figures.left << " of them listed as left; "
            << figures.changed << " moves changed; " << figures.left_path_samples << " of " << figures.kept_samples
            << " places of changed feeds leave the programmed path though it is clean there\n";
  EXPECT_GT(with_gouges * 3, count);
  EXPECT_GT(figures.changed, count);
  EXPECT_LT(figures.left_path_samples * 10, figures.kept_samples + 20);
}

}  // namespace
}  // namespace gouge::laws
