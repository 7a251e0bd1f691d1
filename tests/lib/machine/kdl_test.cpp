#include <gtest/gtest.h>

#include <cstdlib>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

#include "lib/machine/kinematics.h"
#include "tests/lib/machine/machines.h"
#include "tests/support/scatter.h"

// Forward kinematics beside an implementation of others: Orocos KDL. GOUGE_MACHINE_POSES sets how many poses.

namespace gouge::kdl_test {
namespace {

KDL::Vector vector_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Returns the chain from the part to the gauge point, every frame at its place with all joints at 0.
KDL::Chain chain_of(const Machine& machine) {
  KDL::Chain chain;
  for (const Joint& joint : machine.joints) {
    const bool is_rotary = joint.type == JointType::rotary;
    chain.addSegment(
        KDL::Segment(KDL::Joint(joint.name, vector_of(is_rotary ? joint.point : Vec3(Vec3::Zero())),
                                vector_of(joint.direction), is_rotary ? KDL::Joint::RotAxis : KDL::Joint::TransAxis)));
  }
  return chain;
}

std::size_t poses() {
  const char* const many = std::getenv("GOUGE_MACHINE_POSES");
  return many != nullptr ? std::strtoull(many, nullptr, 10) : 20'000;
}

TEST(Kinematics, ForwardIsThatOfOrocosKdl) {
  test::Scatter scatter(43);
  std::vector<Machine> all = test::machines();
  for (Machine& preset : test::presets()) all.push_back(std::move(preset));
  for (const Machine& machine : all) {
    const KDL::Chain chain = chain_of(machine);
    KDL::ChainFkSolverPos_recursive solver(chain);
    for (std::size_t n = 0; n < poses(); ++n) {
      JointValues joints(machine.joints.size());
      KDL::JntArray values(static_cast<unsigned>(joints.size()));
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const bool is_rotary = machine.joints[k].type == JointType::rotary;
        joints[k] = is_rotary ? scatter.in(-6.3, 6.3) : scatter.in(-300, 300);
        if (is_rotary && scatter.in(0, 1) < 0.1) joints[k] = 0;
        values(static_cast<unsigned>(k)) = joints[k];
      }
      const double length = scatter.in(0, 200);
      KDL::Frame frame;
      ASSERT_GE(solver.JntToCart(values, frame), 0);
      const KDL::Vector tip = frame * KDL::Vector(0, 0, -length), axis = frame.M.UnitZ();
      const Pose pose = forward(machine, joints, length);
      ASSERT_LT((pose.tip - Vec3(tip.x(), tip.y(), tip.z())).norm(), 1e-9) << machine.name;
      ASSERT_LT((pose.axis - Vec3(axis.x(), axis.y(), axis.z())).norm(), 1e-9) << machine.name;
    }
  }
}

}  // namespace
}  // namespace gouge::kdl_test
