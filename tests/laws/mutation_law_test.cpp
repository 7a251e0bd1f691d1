// A file from which a statement was lost, doubled, cut short, misplaced or contradicted is clean only if
// every motion that it may mean was checked. tests/laws/motion_expander lists those motions; docs/develop/testing.md
// has the figures.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "postproc/formats/read_toolpath.h"
#include "tests/laws/motion_expander.h"
#include "tests/laws/mutation_bases.h"
#include "tests/laws/reading.h"
#include "tests/laws/statement_mutator.h"
#include "tests/support/shapes.h"

namespace gouge::laws::mutation_law_test {
namespace {

constexpr std::size_t kStretch = 120, kStretches = 4;
constexpr std::size_t kObstacleEvery = 25;

std::size_t mutants_of_each_file(std::size_t usual) {
  const char* wanted = std::getenv("GOUGE_MUTANTS");
  return wanted != nullptr ? static_cast<std::size_t>(std::strtoul(wanted, nullptr, 10)) : usual;
}

struct Counts {
  std::size_t refused = 0, not_checked = 0, clean = 0, obstacles = 0;
};

void keep(const MutationBase& base, std::size_t seed, const Mutant& mutant) {
  const char* folder = std::getenv("GOUGE_MUTANTS_FOLDER");
  if (folder == nullptr) return;
  std::ofstream file(std::string(folder) + "/" + std::to_string(seed) + "-" + base.name, std::ios::binary);
  file << mutant.bytes;
}

double distance_from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (a + t * d - p).norm();
}

// A splinter of metal within the tool in the middle of a motion, as far from the other motions as one can be
// found. The check itself must find it: that moves are listed as checked is not enough.
void expect_splinter_is_found(const MutationBase& base, const Toolpath& path, const Mutant& mutant,
                              test::Scatter& random, Counts& counts) {
  if (base.is_tool_given || !base.library_tools.empty()) return;
  const std::vector<PossibleMotion> motions = expand_motions(mutant.bytes, path.dialect).motions;
  Vec3 best = Vec3::Zero();
  double farthest = 1;  // mm
  for (int attempt = 0; attempt < 20; ++attempt) {
    const std::size_t chosen = static_cast<std::size_t>(random.next() % motions.size());
    const PossibleMotion& motion = motions[chosen];
    if (!motion.from || (motion.from->axis - motion.to.axis).norm() > 1e-9) continue;
    const Vec3 tip = motion.curve ? (*motion.curve)[1] : Vec3(0.5 * (motion.from->tip + motion.to.tip));
    const Vec3 at = tip + 0.2 * motion.to.axis;
    double nearest = 1e9;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Pose& from = motions[i].from ? *motions[i].from : motions[i].to;
      if (i != chosen) nearest = std::min(nearest, distance_from_segment(at, from.tip, motions[i].to.tip));
    }
    if (nearest > farthest) {
      farthest = nearest;
      best = at;
    }
  }
  if (farthest <= 1) return;
  ++counts.obstacles;
  const Vec3 half = Vec3::Constant(0.05);
  EXPECT_NE(verdict(path, shapes::box(best - half, best + half)), "clean")
      << mutant.what << ", splinter at " << best.transpose();
}

void hold_for(const MutationBase& base, std::size_t first_seed, std::size_t count, Counts& counts) {
  for (std::size_t seed = first_seed; seed < first_seed + count; ++seed) {
    test::Scatter random(seed);
    const Mutant mutant = mutate(base.bytes, seed % mutation_kinds(), random);
    if (mutant.bytes == base.bytes) continue;
    const ReadOutcome read = read_toolpath(base.name, mutant.bytes);
    if (!read.toolpath) {
      ++counts.refused;
    } else if (!is_wholly_checked(base, *read.toolpath)) {
      ++counts.not_checked;
    } else {
      ++counts.clean;
      const std::string why = violation(base, *read.toolpath, mutant.bytes);
      if (why.empty() && counts.clean % kObstacleEvery == 0)
        expect_splinter_is_found(base, *read.toolpath, mutant, random, counts);
      if (why.empty()) continue;
      keep(base, seed, mutant);
      ADD_FAILURE() << base.name << " " << seed << ": " << mutant.what << "\n  " << why;
    }
  }
}

std::string test_name(const ::testing::TestParamInfo<std::filesystem::path>& test) {
  std::string name = test.param.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

void report(const std::string& name, const Counts& counts) {
  std::cout << name << ": " << counts.refused << " refused, " << counts.not_checked << " not checked, " << counts.clean
            << " clean, " << counts.obstacles << " of them checked against a splinter\n";
}

class MutationLaw : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(MutationLaw, HoldsForTheFileItself) {
  const std::string bytes = bytes_of(GetParam());
  const auto base = mutation_base(GetParam().filename().string(), bytes);
  ASSERT_TRUE(base);
  const ReadOutcome read = read_toolpath(base->name, bytes);
  EXPECT_TRUE(is_wholly_checked(*base, *read.toolpath));
  EXPECT_EQ(violation(*base, *read.toolpath, bytes), "");
}

TEST_P(MutationLaw, IsCleanOnlyWhereEveryReadingWasChecked) {
  const auto base = mutation_base(GetParam().filename().string(), bytes_of(GetParam()));
  ASSERT_TRUE(base);
  Counts counts;
  hold_for(*base, 0, mutants_of_each_file(300), counts);
  report(base->name, counts);
  EXPECT_GT(counts.refused + counts.not_checked, 0u);
  EXPECT_GT(counts.clean, 0u);
}

INSTANTIATE_TEST_SUITE_P(Modal, MutationLaw, ::testing::ValuesIn(modal_files()), test_name);

class MutationLawOfRealFiles : public ::testing::TestWithParam<std::filesystem::path> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MutationLawOfRealFiles);

TEST_P(MutationLawOfRealFiles, IsCleanOnlyWhereEveryReadingWasChecked) {
  Counts counts;
  std::size_t used = 0, unused = 0;
  for (const std::string& bytes : segments(bytes_of(GetParam()), kStretch, kStretches)) {
    const auto base = mutation_base(GetParam().filename().string(), bytes);
    if (base) {
      const ReadOutcome read = read_toolpath(base->name, bytes);
      if (is_wholly_checked(*base, *read.toolpath)) {
        const std::string why = violation(*base, *read.toolpath, bytes);
        if (why.empty()) {
          hold_for(*base, 1000 * ++used, mutants_of_each_file(60), counts);
          continue;
        }
        std::cout << "not used: " << why << "\n";
      }
    }
    ++unused;
  }
  report(GetParam().filename().string(), counts);
  if (used == 0) GTEST_SKIP() << "none of " << unused << " stretches is wholly checked as it is";
}

INSTANTIATE_TEST_SUITE_P(Real, MutationLawOfRealFiles, ::testing::ValuesIn(real_files()), test_name);

}  // namespace
}  // namespace gouge::laws::mutation_law_test
