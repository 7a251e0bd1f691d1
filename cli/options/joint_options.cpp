#include "cli/options/joint_options.h"

#include <CLI/CLI.hpp>

namespace gouge {

const OptionRows<StatedJoints>& joint_options() {
  using A = StatedJoints;
  static const OptionRows<StatedJoints> rows = {
      {.name = "--joint-limit",
       .field = &A::limits,
       .type = "JOINT=LOW..HIGH",
       .group = kMachineGroup,
       .help = "Limits of a joint in place of those of the machine file: A=-30..120, A=..120, A=-30.., or A=free for a "
               "rotary joint that turns without end (degrees, linear joints mm; repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--joint-point",
       .field = &A::points,
       .type = "JOINT=X,Y,Z",
       .help =
           "Point on the axis of a rotary joint, in place of that of the machine file: of a table in part coordinates, "
           "of a head relative to the gauge point (repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--joint-rate",
       .field = &A::rates,
       .type = "JOINT=RATE",
       .help = "Maximum rate of a joint in place of that of the machine file, in degrees or mm per minute (repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::repeated}};
  return rows;
}

void add_joint_options(CLI::App& command, StatedJoints& stated) {
  const std::string group = command.option_defaults()->get_group();
  add_options(command, stated, joint_options());
  command.option_defaults()->group(group);
}

}  // namespace gouge
