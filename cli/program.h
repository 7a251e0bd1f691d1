#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/batch/merge_command.h"
#include "cli/commands/accept_command.h"
#include "cli/commands/check_command.h"
#include "cli/commands/clash_command.h"
#include "cli/commands/compare_command.h"
#include "cli/commands/machine_command.h"
#include "cli/commands/mesh_command.h"
#include "cli/commands/path_command.h"
#include "cli/commands/tool_command.h"
#include "cli/commands/verify_command.h"
#include "cli/options/batch_options.h"
#include "cli/options/correct_options.h"
#include "cli/options/help_text.h"
#include "cli/self_commands.h"

namespace gouge {

struct Arguments {
  AcceptArguments accept;
  CheckArguments check;
  CorrectArguments correct;
  BatchArguments batch;
  ClashArguments clash;
  CompareArguments compare;
  MergeArguments merge;
  MachineArguments machine;
  MeshArguments mesh;
  PathArguments path;
  ToolArguments tool;
  VerifyArguments verify;
  SelfArguments self;
  std::string colour = "auto";
  bool is_without_project = false;
};

/// The table of all commands and their options, and the variables for their values.
struct Program {
  /// The `columns` are those of help pages.
  explicit Program(const HelpColumns& columns = HelpColumns());
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Returns the value of --color, even for a wrong command line; auto if it is not given.
  [[nodiscard]] std::string colour() const;

  /// Parses a command line, without the program's name, of which required options may be missing. Returns whether that is
  /// possible; false too if the line requests help.
  [[nodiscard]] bool parse_incomplete(const std::vector<std::string>& words);

  Arguments arguments;
  CLI::App app;
};

}  // namespace gouge
