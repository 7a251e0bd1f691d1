#include "cli/options/short_help.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>
#include <string_view>

#include "cli/options/command_doc.h"
#include "cli/options/help_text.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

struct UsualOption {
  std::string_view option;
  std::string_view text;
};

constexpr UsualOption kInputs[] = {{"--part", "Finished part (STL; repeatable)"},
                                   {"--fixture", "Fixture that must not be touched (STL; repeatable)"},
                                   {"--tools", "Tools: JSON, Fusion, FreeCAD, NX, CAMotics, LinuxCNC"},
                                   {"--place", "Placement of the STL files: x,y,z[,rx,ry,rz]"},
                                   {"--stl-units", "Unit of the STL files"},
                                   {"--control", "Control that runs the program (G-code)"},
                                   {"--machine", "Machine with its rotary joints and control laws"}};

constexpr UsualOption kLimits[] = {{"--tolerance", "Maximum depth of a move [0.01mm]"},
                                   {"--stock-to-leave", "Allowance that the cutter leaves on the part [0mm]"},
                                   {"--clearance", "Distance of shank and holder: shank=0.5,holder=1"},
                                   {"--assume", "State a fact that the inputs do not establish"}};

constexpr UsualOption kOfCheck[] = {{"--stock", "Find rapids, shanks and holders in remaining stock"},
                                    {"--find-cures", "State for findings the tilt and lift that free them"},
                                    {"--baseline", "Findings that are accepted ('gougecheck accept')"}};

constexpr UsualOption kOfCorrect[] = {{"--output", "Corrected toolpath"},
                                      {"--strategy", "How gouges are corrected [auto]"},
                                      {"--max-shift", "Maximum distance by which a position moves"},
                                      {"--max-tilt", "Maximum angle by which the tool axis tilts"}};

constexpr UsualOption kOfBatch[] = {{"--output", "Folder for the results"},
                                    {"--resume", "Continue an interrupted batch"},
                                    {"--watch", "Check the toolpaths that appear in a folder"},
                                    {"--jobs", "Maximum number of jobs at once"}};

constexpr UsualOption kOutputs[] = {{"--report", "Folder for the report: page, pictures, data"},
                                    {"--json", "Result as JSON; also --csv, --sarif, --junit"},
                                    {"--quiet", "Print only errors and warnings of open facts"}};

constexpr UsualOption kOutputsOfBatch[] = {{"--quiet", "Print errors only"}};

struct Page {
  std::string_view command, usage;
  std::vector<std::span<const UsualOption>> options;
};

const std::vector<Page>& pages() {
  static const std::vector<Page> all = {{"check",
                                         "gougecheck PATH PART.stl [TOOLS] [OPTIONS]   (report beside the path)\n"
                                         "       gougecheck check PATH --part PART.stl [OPTIONS]",
                                         {kInputs, kLimits, kOfCheck, kOutputs}},
                                        {"correct",
                                         "gougecheck correct PATH --part PART.stl -o OUTPUT [OPTIONS]",
                                         {kOfCorrect, kInputs, kLimits, kOutputs}},
                                        {"batch",
                                         "gougecheck batch JOBS.json|PATH... -o FOLDER [OPTIONS]",
                                         {kOfBatch, kInputs, kLimits, kOutputsOfBatch}}};
  return all;
}

// A choice of many words would leave no room for the text.
std::string value_of(const OptionDoc& doc) {
  constexpr std::size_t kMaxValue = 14;
  return doc.value.size() <= kMaxValue ? doc.value : "NAME";
}

std::string row(const CLI::App& command, const UsualOption& usual, const HelpColumns& columns) {
  constexpr std::size_t kTextAt = 28;
  const OptionDoc doc = document(*command.get_option(std::string(usual.option)));
  return columns.row(listed(doc.names) + (doc.value.empty() ? "" : " " + value_of(doc)),
                     std::string(usual.text) + (doc.is_required ? " [required]" : ""), kTextAt);
}

}  // namespace

std::string short_help(const CLI::App& command, const HelpColumns& columns) {
  const auto page = std::ranges::find(pages(), command.get_name(), &Page::command);
  if (page == pages().end() || command.get_parent() == nullptr || command.get_parent()->get_parent() != nullptr)
    return {};
  std::string text = columns.paragraph(command.get_description() + "\nUsage: " + std::string(page->usage) + "\n");
  for (const std::span<const UsualOption> options : page->options)
    for (const UsualOption& usual : options) text += row(command, usual, columns);
  return text + columns.paragraph("\nLengths are in mm, or have a unit: 0.5mm, 20um, 0.02in.\nAll options: " +
                                  std::string(kProgramName) + " help " + command.get_name() + " --all");
}

}  // namespace gouge
