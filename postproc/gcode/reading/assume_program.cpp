#include "postproc/gcode/reading/assume_program.h"

#include "lib/base/number_text.h"

namespace gouge {
namespace {

Assumption unit_of_program(const Toolpath& path, const GcodeOptions& options, const ProgramFacts& facts) {
  Assumption fact{.subject = Subject::path_unit, .value = std::string(facts_of(path.unit).option), .code = "path-unit"};
  fact.remedy = "give --path-units mm or --path-units inch";
  if (facts.has_assumed_unit) {
    fact.basis = Basis::unknown;
    fact.evidence = "the program states no unit; mm was taken";
    if (facts.unit_line > 0) {
      fact.evidence = "lengths stand before the block that states their unit; mm was taken";
      fact.remedy = "give the unit at the start: --start G21 or G20";
    }
  } else if (facts.unit_line > 0) {
    fact.basis = Basis::stated;
    fact.evidence = facts.unit_word;
    fact.line = facts.unit_line;
  } else if (path.is_unit_stated) {
    fact.basis = Basis::stated;
    fact.evidence = options.unit ? "--path-units" : "the blocks in force at the start";
  } else {
    fact.basis = Basis::unknown;
    fact.evidence = "the program states no unit; mm was taken";
  }
  return fact;
}

Assumption control_of_program(std::string_view control, const ProgramSetup& setup) {
  Assumption fact{.subject = Subject::dialect, .value = "program of " + std::string(control), .code = "gcode-control"};
  fact.basis = setup.is_control_of_program ? Basis::derived : Basis::stated;
  fact.evidence = setup.is_control_of_program ? "the program begins with BEGIN PGM"
                  : setup.is_control_stated   ? "--control"
                                              : "the control of the machine";
  fact.remedy = "give --control";
  return fact;
}

Assumption end_of_program(const ProgramFacts& facts, const ProgramMotion& motion) {
  const Tally& approach = motion.approach();
  Assumption fact{.subject = Subject::completeness, .value = "whole program", .code = "path-cut-short"};
  fact.remedy = "save it again, or state that it is whole with --assume complete";
  if (facts.end_line > 0) {
    fact.basis = Basis::derived;
    fact.evidence = "the program has its end";
    fact.line = facts.end_line;
  } else {
    fact.basis = Basis::unknown;
    fact.evidence = "the program does not have its end, such as M30";
    if (motion.is_rest_unknown()) {
      fact.evidence = "the program is not understood to its end";
      fact.remedy = "correct the program, or state words of your shop with --harmless-word";
    }
  }
  if (fact.basis == Basis::derived && facts.other) {
    fact.basis = Basis::unknown;
    fact.value = "not all programs of the file";
    fact.evidence = facts.other->evidence;
    fact.line = facts.other->line;
    fact.remedy =
        "split the file, and check each program by itself, or state that nothing else runs with --assume complete";
  }
  if (fact.basis == Basis::derived && approach.count > 0) {
    fact.basis = Basis::by_default;
    fact.value = "whole program without " + count_text(approach.count, "rapid") + " of its approach";
    fact.evidence = "nothing is swept before the tool has a height, at the start and after tool changes";
    fact.line = approach.first_line;
    fact.remedy = "state that nothing is in its way with --assume complete";
  }
  return fact;
}

Assumption words_of_program(const Toolpath& path, const ProgramFacts& facts) {
  Assumption fact{.subject = Subject::statements, .value = "all understood", .code = "path-words"};
  fact.basis = Basis::derived;
  fact.evidence = count_text(path.statements.size(), "block") + " understood";
  if (path.words_not_understood.empty() && facts.loading_line > 0) {
    fact.basis = Basis::by_default;
    fact.value = "all understood, where T loads its tool at once";
    fact.evidence = "the program has no M6, so that T is taken to load its tool (MD22550 of 0)";
    fact.remedy = "load tools by M6 in the program, or state that T loads them with --assume statements";
    fact.line = facts.loading_line;
  }
  if (path.words_not_understood.empty()) return fact;
  fact.basis = Basis::unknown;
  fact.value = "not understood to its end";
  fact.evidence = "not understood: " + listed(words_by_line(path));
  fact.remedy = "correct the program, or state words of your shop with --harmless-word";
  return fact;
}

Assumption frame_of_program(const ProgramSetup& setup, const ProgramMotion& motion, const ProgramFacts& facts) {
  Assumption fact{.subject = Subject::frame, .value = "part coordinates", .code = "path-frame"};
  fact.remedy = "state that positions are in part coordinates with --assume frame";
  fact.line = facts.offset_line;
  const std::string& offset = motion.part_offset();
  if (setup.zero) {
    fact.basis = Basis::stated;
    fact.evidence = "the part zero of the machine is stated";
  } else {
    fact.basis = Basis::by_default;
    fact.value = "coordinates of work offset " + offset;
    fact.evidence = "positions are taken as those of the tip in work offset " + offset +
                    (setup.machine ? ", with the rotary joints at 0" : "");
  }
  if (motion.has_lengths()) return fact;
  const std::size_t needed_line = motion.length_needed_line();
  if (needed_line == 0 && motion.tools_loaded() == 0) {
    fact.evidence += "; the program applies no tool length, so the work offset includes that of its tool";
    return fact;
  }
  fact.basis = Basis::unknown;
  fact.evidence = "the program loads a tool and applies no tool length";
  if (needed_line > 0) {
    fact.line = needed_line;
    fact.evidence = "the program applies no tool length, and from line " + std::to_string(needed_line) +
                    " on the place of the tip depends on it";
  }
  fact.remedy =
      "apply the length in the program (G43), or state that positions are those of the tip with --assume frame";
  return fact;
}

}  // namespace

Assumptions assume_program(const Toolpath& path, std::string_view control, const GcodeOptions& options,
                           const ProgramMotion& motion, const ProgramFacts& facts) {
  Assumptions all = {unit_of_program(path, options, facts), control_of_program(control, options.setup),
                     end_of_program(facts, motion), words_of_program(path, facts),
                     frame_of_program(options.setup, motion, facts)};
  for (Assumption& fact : all) fact.file = path.file;
  return all;
}

}  // namespace gouge
