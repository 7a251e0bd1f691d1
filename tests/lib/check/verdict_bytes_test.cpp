#include "lib/check/verdict_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace gouge::verdict_bytes_test {
namespace {

std::string bytes_of(const MoveVerdict& verdict) {
  std::string bytes;
  append_bytes(verdict, bytes);
  return bytes;
}

MoveVerdict gouge_with_all() {
  MoveVerdict v;
  v.state = MoveState::gouge;
  v.depth_mm = 0.1;
  v.depth_upper_mm = std::numeric_limits<double>::infinity();
  v.witness =
      Witness{0.25, Vec3(1, -0.0, 3e-300), Vec3(0, 0.6, -0.8), Body::holder, Against::fixture, 7, 4'000'000'000};
  v.clearance_mm = 0;
  v.overcut = OvercutBounds{0.5, 0.625};
  v.reason = {Reason::Kind::clearance_entered, Body::shank, -1.5, std::string("text\0of\nall bytes\xff", 18)};
  return v;
}

std::vector<MoveVerdict> verdicts() {
  std::vector<MoveVerdict> all = {
      {}, gouge_with_all(), not_checked({Reason::Kind::of_path, Body::cutter, 0, std::string("an arc")})};
  for (const MoveState state : {MoveState::near_miss, MoveState::buried, MoveState::not_certified}) {
    all.emplace_back();
    all.back().state = state;
    all.back().depth_mm = -0.0;
  }
  return all;
}

TEST(VerdictBytes, ReadBackToEveryBit) {
  std::string all;
  for (const MoveVerdict& verdict : verdicts()) append_bytes(verdict, all);
  std::string_view left = all;
  for (const MoveVerdict& verdict : verdicts()) {
    MoveVerdict read = gouge_with_all();
    ASSERT_TRUE(take_bytes(left, read));
    EXPECT_EQ(bytes_of(read), bytes_of(verdict));
    EXPECT_EQ(read.state, verdict.state);
    EXPECT_EQ(std::signbit(read.depth_mm), std::signbit(verdict.depth_mm));
    EXPECT_EQ(read.witness.has_value(), verdict.witness.has_value());
    EXPECT_EQ(read.clearance_mm.optional(), verdict.clearance_mm.optional());
    EXPECT_EQ(read.overcut.has_value(), verdict.overcut.has_value());
    EXPECT_TRUE(read.reason.is_same(verdict.reason));
  }
  EXPECT_TRUE(left.empty());
}

TEST(VerdictBytes, OfACleanMoveAreNine) { EXPECT_EQ(bytes_of({}).size(), 9U); }

TEST(VerdictBytes, CutShortAreRefused) {
  for (const MoveVerdict& verdict : verdicts()) {
    const std::string whole = bytes_of(verdict);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      std::string_view part = std::string_view(whole).substr(0, length);
      MoveVerdict read;
      EXPECT_FALSE(take_bytes(part, read)) << length << " of " << whole.size();
    }
  }
}

TEST(VerdictBytes, OfNoStateAreRefused) {
  std::string bytes = bytes_of({});
  bytes[0] = 7;
  std::string_view left = bytes;
  MoveVerdict read;
  EXPECT_FALSE(take_bytes(left, read));
}

// Possible content of a foreign file: each would be an index out of range, or no number, later.
TEST(VerdictBytes, WhatNoVerdictCanBeIsNotTaken) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto is_taken = [](const auto& change) {
    MoveVerdict verdict = gouge_with_all(), read;
    change(verdict);
    const std::string bytes = bytes_of(verdict);
    std::string_view left = bytes;
    return take_bytes(left, read);
  };
  EXPECT_TRUE(is_taken([](MoveVerdict&) {}));
  EXPECT_FALSE(is_taken([](MoveVerdict& v) { v.witness->body = static_cast<Body>(4); }));
  EXPECT_FALSE(is_taken([](MoveVerdict& v) { v.witness->against = static_cast<Against>(2); }));
  EXPECT_FALSE(is_taken([](MoveVerdict& v) { v.witness->t = 1.5; }));
  EXPECT_FALSE(is_taken([&](MoveVerdict& v) { v.witness->point.x() = nan; }));
  EXPECT_FALSE(is_taken([&](MoveVerdict& v) { v.depth_mm = nan; }));
  EXPECT_FALSE(is_taken([&](MoveVerdict& v) { v.depth_mm = infinity; }));
  EXPECT_FALSE(is_taken([&](MoveVerdict& v) { v.depth_upper_mm = nan; }));
  EXPECT_FALSE(is_taken([&](MoveVerdict& v) { v.overcut = OvercutBounds{-1, 0}; }));
  EXPECT_FALSE(is_taken([&](MoveVerdict& v) { v.clearance_mm = infinity; }));
  EXPECT_FALSE(is_taken([](MoveVerdict& v) { v.reason.kind = static_cast<Reason::Kind>(200); }));
  EXPECT_FALSE(is_taken([](MoveVerdict& v) { v.reason.body = static_cast<Body>(9); }));
  EXPECT_FALSE(is_taken([](MoveVerdict& v) { v.reason = {Reason::Kind::link_gouges, Body::cutter, 1e300}; }));
  const auto scene = [](std::size_t parts, std::size_t fixtures) {
    return Scene{std::vector<IndexedMesh>(parts), std::vector<IndexedMesh>(fixtures)};
  };
  EXPECT_TRUE(is_of_meshes(gouge_with_all(), scene(0, 8)));
  EXPECT_FALSE(is_of_meshes(gouge_with_all(), scene(9, 7)));
  EXPECT_TRUE(is_of_meshes({}, scene(0, 0))) << "it names none";
}

}  // namespace
}  // namespace gouge::verdict_bytes_test
