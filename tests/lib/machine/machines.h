#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "lib/machine/machine.h"
#include "lib/machine/read_machine.h"
#include "tests/support/scatter.h"

// Machines of all arrangements, for tests.

namespace gouge::test {

inline Joint linear(const std::string& name, const Vec3& direction) {
  Joint joint;
  joint.name = name;
  joint.direction = direction;
  return joint;
}

inline Joint rotary(const std::string& name, const Vec3& direction, JointSide side, const Vec3& point = Vec3::Zero()) {
  Joint joint;
  joint.name = name;
  joint.type = JointType::rotary;
  joint.side = side;
  joint.direction = direction;
  joint.point = point;
  joint.has_point = true;
  joint.is_continuous = true;
  return joint;
}

inline Machine machine(const std::string& name, std::vector<Joint> joints) {
  Machine made;
  made.name = name;
  made.joints = std::move(joints);
  return make_machine(std::move(made)).value();
}

inline const Joint kX = linear("X", Vec3::UnitX()), kY = linear("Y", Vec3::UnitY()), kZ = linear("Z", Vec3::UnitZ());

/// Table/table, table/head and head/head, square and at 45 degrees.
inline std::vector<Machine> machines() {
  const auto table = JointSide::table, head = JointSide::head;
  return {machine("C on A", {rotary("C", Vec3::UnitZ(), table, {1, 2, 3}), rotary("A", Vec3::UnitX(), table, {4, 5, 6}),
                             kX, kY, kZ}),
          machine("C on B",
                  {rotary("C", Vec3::UnitZ(), table), rotary("B", Vec3::UnitY(), table, {0, 0, -50}), kX, kY, kZ}),
          machine("C table, B head", {rotary("C", Vec3::UnitZ(), table, {10, 0, 0}), kX, kY, kZ,
                                      rotary("B", Vec3::UnitY(), head, {0, 0, 150})}),
          machine("C head, A head",
                  {kX, kY, kZ, rotary("C", Vec3::UnitZ(), head), rotary("A", Vec3::UnitX(), head, {0, 30, 200})}),
          machine("nutating head", {rotary("C", Vec3::UnitZ(), table), kX, kY, kZ,
                                    rotary("B", Vec3(0, 1, 1).normalized(), head, {0, 0, 100})})};
}

/// Returns any part zero within 300 mm, turned in any direction.
inline RigidTransform random_zero(Scatter& scatter) {
  const auto number = [&] { return scatter.in(-300, 300); };
  const double x = number(), y = number(), z = number();
  const double a = number(), b = number(), c = number();
  RigidTransform zero;
  zero.rotation =
      (Eigen::AngleAxisd(a, Vec3::UnitX()) * Eigen::AngleAxisd(b, Vec3::UnitY()) * Eigen::AngleAxisd(c, Vec3::UnitZ()))
          .toRotationMatrix();
  zero.shift = Vec3(x, y, z);
  return zero;
}

/// The same machines, then each of them with a part at a random zero.
inline std::vector<Machine> machines_and_placed() {
  std::vector<Machine> all = machines();
  Scatter scatter(61);
  const std::size_t count = all.size();
  for (std::size_t k = 0; k < count; ++k) all.push_back(place_part(all[k], random_zero(scatter)));
  return all;
}

/// Returns a chain of X, Y, Z and two rotary joints in any order, with the head from any joint on. The directions are those of the
/// axes. If `is_skew`, they are any.
inline Machine random_chain(Scatter& scatter, bool is_skew) {
  const auto number = [&](double low, double high) { return scatter.in(low, high); };
  const auto one_of = [&](std::size_t count) {
    return static_cast<std::size_t>(number(0, 0.999999) * static_cast<double>(count));
  };
  const auto skew = [&](const Vec3& direction) {
    if (!is_skew) return direction;
    const double x = number(-0.5, 0.5), y = number(-0.5, 0.5), z = number(-0.5, 0.5);
    return Vec3(direction + Vec3(x, y, z));
  };
  const std::size_t first = one_of(3), second = (first + 1 + one_of(2)) % 3;
  std::vector<Joint> joints = {kX, kY, kZ};
  for (const std::size_t along : {first, second}) {
    const double x = number(-200, 200), y = number(-200, 200), z = number(-200, 200);
    joints.push_back(rotary(std::string(1, "ABC"[along]), Vec3::Unit(static_cast<Eigen::Index>(along)),
                            JointSide::table, {x, y, z}));
  }
  std::string name;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    std::swap(joints[k], joints[k + one_of(joints.size() - k)]);
    joints[k].direction = skew(joints[k].direction);
    joints[k].rate = is_rotary(joints[k]) ? number(20, 60) : number(2000, 6000);
    name += joints[k].name;
  }
  const std::size_t head = one_of(joints.size() + 1);
  for (std::size_t k = 0; k < joints.size(); ++k) joints[k].side = k < head ? JointSide::table : JointSide::head;
  return machine(name, std::move(joints));
}

/// All presets, with points in place of those that they leave empty.
inline std::vector<Machine> presets() {
  std::vector<Machine> all;
  for (const MachinePreset& preset : machine_presets())
    all.push_back(read_machine(std::string(preset.name), preset.text).value());
  for (Machine& machine : all) {
    for (std::size_t k = 0; k < machine.joints.size(); ++k)
      if (is_rotary(machine.joints[k]) && !machine.joints[k].has_point)
        machine.joints[k].point = Vec3(3, -2, 5) * static_cast<double>(k + 1);
  }
  return all;
}

/// These machines and all presets, in their own zeros and in others.
inline std::vector<Machine> machines_and_presets() {
  std::vector<Machine> all = machines_and_placed();
  for (Machine& preset : presets()) all.push_back(std::move(preset));
  return all;
}

}  // namespace gouge::test
