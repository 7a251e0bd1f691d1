#include "cli/pages/write_man.h"

#include <algorithm>

#include "lib/base/letters.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

// Escapes a text for roff. A backslash begins an escape. A point or quote at the beginning of a line begins a request.
// A typed hyphen is "\-".
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (out.empty() && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

std::string page_name(std::string name) {
  std::ranges::replace(name, ' ', '-');
  return name;
}

class ManPage {
 public:
  explicit ManPage(const CommandDoc& command) : command_(command) {}

  std::string write() {
    text_ = ".TH " + in_capitals(man_name(command_)) + " 1 \"\" \"" + kProgramName + " " + kProgramVersion +
            "\" \"User Commands\"\n";
    section("NAME");
    const std::vector<std::string> description = lines_of(command_.description);
    text_ += roff(man_name(command_)) + " \\- " + roff(description.empty() ? "" : description.front()) + "\n";
    synopsis();
    if (description.size() > 1) {
      section("DESCRIPTION");
      for (std::size_t k = 1; k < description.size(); ++k) text_ += roff(description[k]) + "\n";
    }
    commands();
    options();
    footer();
    see_also();
    return std::move(text_);
  }

 private:
  void section(const std::string& title) { text_ += ".SH " + title + "\n"; }

  void synopsis() {
    section("SYNOPSIS");
    text_ += bold(command_.name);
    text_ += command_.commands.empty() ? " [OPTIONS]" : " COMMAND ...";
    for (const OptionDoc& option : command_.options) {
      if (!option.is_positional) continue;
      const std::string name = italic(option.names.front()) + (option.is_repeatable ? " ..." : "");
      text_ += option.is_required ? " " + name : " [" + name + "]";
    }
    text_ += "\n";
  }

  void commands() {
    if (command_.commands.empty()) return;
    section("COMMANDS");
    for (const CommandDoc& one : command_.commands)
      text_ += ".TP\n" + bold(one.word()) + "\n" + roff(lines_of(one.description).front()) + "\n";
  }

  void options() {
    std::vector<std::string> groups;
    for (const OptionDoc& option : command_.options) {
      if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
    }
    if (!groups.empty()) section("OPTIONS");
    for (const std::string& group : groups) {
      if (groups.size() > 1) text_ += ".SS " + roff(group) + "\n";
      for (const OptionDoc& option : command_.options) {
        if (option.group == group) add(option);
      }
    }
  }

  void add(const OptionDoc& option) {
    text_ += ".TP\n";
    for (std::size_t k = 0; k < option.names.size(); ++k) {
      text_ += k > 0 ? ", " : "";
      text_ += option.is_positional ? italic(option.names[k]) : bold(option.names[k]);
    }
    if (!option.is_positional && !option.value.empty()) text_ += " " + italic(option.value);
    text_ += "\n" + roff(option.full_description()) + "\n";
  }

  // Writes the examples and notes. Lines of the footer that begin with a blank are examples.
  void footer() {
    std::string example, rest;
    for (const std::string& one : lines_of(command_.footer)) {
      if (one == "Example:" || one == "Examples:" || one.empty()) continue;
      (one.front() == ' ' ? example : rest) += one.front() == ' ' ? roff(one) + "\n" : ".PP\n" + roff(one) + "\n";
    }
    if (!example.empty()) {
      section("EXAMPLES");
      text_ += ".nf\n" + example + ".fi\n";
    }
    if (rest.empty()) return;
    section("NOTES");
    text_ += rest.substr(rest.find('\n') + 1);  // the section begins with a paragraph anyway
  }

  void see_also() {
    std::vector<std::string> pages;
    const std::size_t blank = command_.name.rfind(' ');
    if (blank != std::string::npos) pages.push_back(page_name(command_.name.substr(0, blank)));
    for (const CommandDoc& one : command_.commands) pages.push_back(man_name(one));
    if (pages.empty()) return;
    section("SEE ALSO");
    for (std::size_t k = 0; k < pages.size(); ++k)
      text_ += ".BR " + roff(pages[k]) + " (1)" + (k + 1 < pages.size() ? "," : "") + "\n";
  }

  const CommandDoc& command_;
  std::string text_;
};

}  // namespace

std::string write_man(const CommandDoc& command) { return ManPage(command).write(); }

std::string man_name(const CommandDoc& command) { return page_name(command.name); }

}  // namespace gouge
