#include "lib/machine/read_machine.h"

#include <gtest/gtest.h>

// Machine files, and what is refused in them.

namespace gouge::read_machine_test {
namespace {

std::string trunnion() {
  return R"({"name": "trunnion", "joints": [
 {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
 {"name": "A", "type": "rotary", "side": "table", "direction": [1, 0, 0], "min": -100, "max": 50, "preference": -1},
 {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
 {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
 {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}],
 "control": {"name": "any"}})";
}

TEST(ReadMachine, TakesAPreferredSign) {
  const Result<Machine> machine = read_machine("m.json", trunnion());
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_EQ(machine->joints[1].preference, -1);
  EXPECT_EQ(machine->joints[0].preference, 0);
}

TEST(ReadMachine, TakesTheMiddleOfIntervalsAndTheFarthestFromIt) {
  std::string bytes = trunnion();
  const std::string rate = "\"min\": -100";
  bytes.replace(bytes.find(rate), rate.size(), "\"point\": [[4, 10], [-0.3, 0.3], [49.6, 50.4]], " + rate);
  const Result<Machine> machine = read_machine("m.json", bytes);
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_LT((machine->joints[1].point - Vec3(7, 0, 50)).norm(), 1e-12);
  EXPECT_NEAR(machine->joints[1].point_slack_mm, 0.5, 1e-12) << "across the axis, which is along X";
  EXPECT_EQ(machine->joints[0].point_slack_mm, 0);
}

TEST(ReadMachine, RefusesWrongFieldsWithTheirLine) {
  const struct {
    std::string from, to, message;
    std::size_t line;
  } kCases[] = {
      {"\"min\": -100", "\"point\": [[1], 0, 0], \"min\": -100", "a number, or a pair [low, high]", 3},
      {"\"min\": -100", "\"point\": [[1, 0], 0, 0], \"min\": -100", "a pair [low, high] with low <= high", 3},
      {"\"min\": -100", "\"point\": [0, 0], \"min\": -100", "three coordinates", 3},
      {"\"min\": -100", "\"point\": [0, 0, null], \"min\": -100", "expected a number", 3},
      {"\"preference\": -1", "\"preference\": 0.5", "1 or -1", 3},
      {"\"preference\": -1", "\"preference\": 0", "1 or -1", 3},
      {"\"name\": \"Y\"", "\"name\": \"X\"", "a name that no joint before it has", 5},
      {"\"name\": \"Y\"", "\"name\": \"\"", "a name such as X", 5},
      {"\"name\": \"Y\"", "\"name\": \"Y=\"", "a name such as X", 5},
      {"\"name\": \"Y\"", "\"name\": \"a\\nb\"", "a name such as X", 5},
      {"\"name\": \"Y\"", "\"name\": \"move\"", "a name such as X", 5},
      {"\"name\": \"any\"", "\"name\": \"any\", \"program\": \"Siemens\"",
       "'/control/program' is \"Siemens\"; expected one of linuxcnc, haas, fanuc, siemens, heidenhain", 7},
  };
  for (const auto& one : kCases) {
    std::string bytes = trunnion();
    bytes.replace(bytes.find(one.from), one.from.size(), one.to);
    const Result<Machine> machine = read_machine("m.json", bytes);
    ASSERT_FALSE(machine) << one.to;
    EXPECT_EQ(machine.error().code, "machine-field");
    EXPECT_EQ(machine.error().line, one.line) << one.to;
    EXPECT_NE(machine.error().message.find(one.message), std::string::npos) << machine.error().message;
  }
}

TEST(ReadMachine, RefusesValuesThatNoMachineHas) {
  const struct {
    std::string from, to, message;
  } kCases[] = {
      {"\"min\": -100", "\"point\": [1e200, 0, 0], \"min\": -100", "a point more than 100 m away"},
      {"\"min\": -100", "\"min\": -1e300", "a limit that is too large"},
      {"\"min\": -100", "\"rate\": 1e-320, \"min\": -100", "a rate that no machine has"},
      {"\"direction\": [0, 1, 0]", "\"direction\": [0, 1, 0], \"point\": [0, 0, 0]", "joint Y is linear"},
      {"\"direction\": [0, 1, 0]", "\"direction\": [0, 1, 0], \"continuous\": true", "joint Y is linear"},
      {"\"side\": \"head\", \"direction\": [0, 0, 1]}", "\"side\": \"table\", \"direction\": [0, 0, 1]}",
       "in the order from the part to the tool"},
  };
  for (const auto& one : kCases) {
    std::string bytes = trunnion();
    ASSERT_NE(bytes.find(one.from), std::string::npos) << one.from;
    bytes.replace(bytes.find(one.from), one.from.size(), one.to);
    const Result<Machine> machine = read_machine("m.json", bytes);
    ASSERT_FALSE(machine) << one.to;
    EXPECT_EQ(machine.error().code, "machine-joints");
    EXPECT_NE(machine.error().message.find(one.message), std::string::npos) << machine.error().message;
  }
  const std::string bytes = trunnion();
  EXPECT_TRUE(read_machine("m.json", std::string(bytes).replace(bytes.find("[0, 1, 0]"), 9, "[0, 1e200, 0]")));
}

}  // namespace
}  // namespace gouge::read_machine_test
