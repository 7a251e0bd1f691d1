// The further contacts of random gouging moves, with cutters, shanks, holders and heads of every shape, compared with a
// search of own arithmetic in each body alone. GOUGE_FURTHER sets the number of gouging moves, GOUGE_SEED which.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "tests/laws/random_moves.h"
#include "tests/support/reference_contour.h"
#include "tests/support/reference_hunt.h"
#include "tests/support/whole_check.h"

namespace gouge::further_law_test {
namespace {

constexpr double kRounding_mm = 1e-9, kWitness_mm = 1e-6;
constexpr int kLooks = 300;

std::size_t wanted_gouges() {
  const char* given = std::getenv("GOUGE_FURTHER");
  return given == nullptr ? 600 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// A body alone and an obstacle.
struct Pair {
  Body body;
  Against against;
};

class FurtherLaw : public testing::Test {
 protected:
  void examine(const laws::RandomJob& job) {
    CheckOptions options;
    options.threads = 1;
    options.tolerance_mm = gouges_ % 2 == 0 ? 0.01 : 0.05;
    options.budget_per_move = 20'000;
    std::vector<HeadBody> heads;
    for (const IndexedMesh& head : job.heads) heads.push_back(*build_head_body(head));
    const CheckResult result = whole_check(job.path, &job.tool, job.scene, options, heads);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      if (result.verdicts[i].state != MoveState::gouge) {
        EXPECT_TRUE(result.further_of(i).empty());
        continue;
      }
      ++gouges_;
      for (const Against against : {Against::part, Against::fixture}) {
        for (const Body body : {Body::cutter, Body::shank, Body::holder})
          judge_body(job, options, result, i, {body, against});
        if (!job.heads.empty()) judge_heads(job, options, result, i, against);
      }
    }
  }

  std::size_t gouges_ = 0, contacts_ = 0, open_ = 0, absent_ = 0;

 private:
  static const std::vector<IndexedMesh>& meshes_of(const laws::RandomJob& job, Against against) {
    return against == Against::part ? job.scene.parts : job.scene.fixtures;
  }

  static const FurtherContact* find(const CheckResult& result, std::size_t move, const Pair& pair) {
    for (const FurtherContact& one : result.further_of(move))
      if (one.body == pair.body && one.against == pair.against) return &one;
    return nullptr;
  }

  void judge_body(const laws::RandomJob& job, const CheckOptions& options, const CheckResult& result, std::size_t move,
                  const Pair& pair) {
    const BodiesAlone& alone =
        pair.against == Against::part ? job.tool.alone->against_part : job.tool.alone->against_fixture;
    const reference::Contour contour(*alone[static_cast<std::size_t>(pair.body)]);
    const FurtherContact* const contact = find(result, move, pair);
    if (contour.is_empty()) {
      EXPECT_EQ(contact, nullptr);
      return;
    }
    const reference::Movement movement = reference::movement(job.path, move);
    if (contact != nullptr && contact->witness) {
      const double depth_mm = contour.depth(movement.at(contact->witness->t), contact->witness->point);
      EXPECT_NEAR(depth_mm, contact->depth_mm, kWitness_mm) << job.tool_name << ", move " << move;
    }
    judge(options, result, move, pair, contact, [&](double mark_mm) {
      return reference::Hunt(reference::MovingTool(contour, movement), meshes_of(job, pair.against), kLooks)
          .run(mark_mm);
    });
  }

  void judge_heads(const laws::RandomJob& job, const CheckOptions& options, const CheckResult& result, std::size_t move,
                   Against against) {
    const Pair pair{Body::head, against};
    const reference::Movement movement = reference::movement(job.path, move);
    judge(options, result, move, pair, find(result, move, pair), [&](double mark_mm) {
      return reference::Hunt(reference::MovingHead(job.heads.front(), movement), meshes_of(job, against), kLooks)
          .run(mark_mm);
    });
  }

  template <class Hunt>
  void judge(const CheckOptions& options, const CheckResult& result, std::size_t move, const Pair& pair,
             const FurtherContact* contact, const Hunt& hunt) {
    const MoveVerdict& verdict = result.verdicts[move];
    const bool is_of_verdict = verdict.witness->body == pair.body && verdict.witness->against == pair.against;
    if (is_of_verdict) {
      EXPECT_EQ(contact, nullptr);
      return;
    }
    contacts_ += contact != nullptr && contact->witness ? 1U : 0U;
    open_ += contact != nullptr && !contact->witness ? 1U : 0U;
    absent_ += contact == nullptr ? 1U : 0U;
    const double upper_mm = contact == nullptr ? options.tolerance_mm + options.resolution_mm : contact->depth_upper_mm;
    const reference::Found found = hunt(upper_mm);
    EXPECT_LE(found.depth_mm, upper_mm + kRounding_mm)
        << body_name(pair.body) << " in " << against_name(pair.against) << ", move " << move
        << (contact == nullptr ? ", which has no such contact" : "");
    if (contact == nullptr) return;
    EXPECT_GT(contact->depth_upper_mm, options.tolerance_mm);
    EXPECT_EQ(contact->depth_mm > 0, contact->witness.has_value());
    if (contact->witness) {
      EXPECT_GT(contact->depth_mm, options.tolerance_mm);
      EXPECT_LE(contact->depth_mm, verdict.depth_upper_mm + kRounding_mm) << "deeper than the move";
    }
  }
};

TEST_F(FurtherLaw, HoldsForRandomGouges) {
  for (std::uint64_t stream = 0; gouges_ < wanted_gouges() && !HasFailure(); ++stream) {
    laws::RandomJobs jobs(stream);
    for (int k = 0; k < 8 && !HasFailure(); ++k) {
      const laws::RandomJob job = jobs.next();
      if (job.tool.alone == nullptr) continue;
      SCOPED_TRACE("stream " + std::to_string(stream) + ", job " + std::to_string(k));
      examine(job);
    }
  }
  std::cerr << gouges_ << " gouging moves: " << contacts_ << " further contacts, " << open_ << " open, " << absent_
            << " absent\n";
  EXPECT_GT(contacts_, wanted_gouges() / 20);
  EXPECT_LT(open_, gouges_ / 10);
}

}  // namespace
}  // namespace gouge::further_law_test
