#include "postproc/report/write_report.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

struct Case {
  std::size_t operation = kNone, tool = kNone;
  std::size_t moves = 0, gouging = 0, buried = 0, open = 0;
  std::size_t worst_move = kNone;
  std::size_t first_open = kNone;
  std::vector<const Event*> events;
};

void count_move(Case& one, const CheckResult& result, std::size_t index) {
  const MoveVerdict& verdict = result.verdicts[index];
  ++one.moves;
  if (verdict.state == MoveState::gouge) {
    ++one.gouging;
    if (one.worst_move == kNone || verdict.depth_mm > result.verdicts[one.worst_move].depth_mm) one.worst_move = index;
  } else if (verdict.state == MoveState::buried) {
    ++one.buried;
  } else if (verdict.state == MoveState::not_checked || verdict.state == MoveState::not_certified) {
    ++one.open;
    if (one.first_open == kNone) one.first_open = index;
  }
}

std::vector<Case> cases_of(const ReportModel& model) {
  std::vector<Case> cases;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
  const std::vector<Move>& moves = model.toolpath->moves;
  const auto case_of = [&](std::size_t move) -> Case& {
    const std::pair key{moves[move].operation, moves[move].tool};
    const auto [entry, is_new] = known.try_emplace(key, cases.size());
    if (is_new) cases.push_back(Case{key.first, key.second, 0, 0, 0, 0, kNone, kNone, {}});
    return cases[entry->second];
  };
  for (std::size_t i = 0; i < moves.size(); ++i) count_move(case_of(i), *model.result, i);
  for (const Event& event : model.result->events) {
    if (event.state == MoveState::gouge || event.state == MoveState::buried) {
      case_of(event.worst_move).events.push_back(&event);
    }
  }
  return cases;
}

std::string case_name(const ReportModel& model, const Case& one) {
  const std::string operation = operation_name(*model.toolpath, one.operation);
  return (operation.empty() ? "toolpath" : operation) + ", " + tool_label(*model.toolpath, one.tool);
}

std::string failure(const ReportModel& model, const Case& one) {
  std::string message;
  if (one.gouging > 0) {
    message = "gouge " + depth_text(model.result->verdicts[one.worst_move].depth_mm, model.toolpath->unit) +
              " deep at line " + std::to_string(model.toolpath->moves[one.worst_move].line) + "; " +
              std::to_string(one.gouging) + " of " + count_text(one.moves, "move") + " gouge";
  }
  if (one.buried > 0) {
    message += (message.empty() ? "" : "; ") + std::string("tool buried in ") + count_text(one.buried, "move");
  }
  std::string out = "   <failure type=\"" + std::string(one.gouging > 0 ? "gouge" : "buried") + "\" message=\"" +
                    xml_escaped(message) + "\">";
  for (const Event* event : one.events) {
    out += xml_escaped(model.toolpath->file + ":" + std::to_string(model.toolpath->moves[event->worst_move].line) +
                       ": " + event_text(model, *event) + span_text(*event)) +
           "\n";
  }
  return out + "</failure>\n";
}

std::string skipped(const ReportModel& model, const Case& one) {
  return "   <skipped message=\"" +
         xml_escaped(std::to_string(one.open) + " of " + count_text(one.moves, "move") +
                     " not checked or not certified: " + reason_text(model.result->verdicts[one.first_open].reason)) +
         "\"/>\n";
}

std::string seconds_text(double seconds) { return fixed_text(seconds, 3); }

// Build servers show it, but it fails no test.
std::string beside_the_verdict(const ReportModel& model) {
  std::string text;
  for (const std::string& reservation : reservations(model)) text += "note: " + xml_escaped(reservation) + "\n";
  for (const Diagnostic& note : model.notes) {
    if (note.severity == Severity::warning) text += xml_escaped(to_text(note)) + "\n";
  }
  return text.empty() ? text : "  <system-out>" + text + "</system-out>\n";
}

}  // namespace

std::string write_junit(const ReportModel& model) {
  const double seconds_per_move =
      model.seconds / static_cast<double>(std::max<std::size_t>(model.result->verdicts.size(), 1));
  const std::vector<Case> cases = cases_of(model);
  std::size_t failures = 0;
  std::size_t skips = 0;
  std::string body;
  for (const Case& one : cases) {
    body += "  <testcase classname=\"" + xml_escaped(model.toolpath->file) + "\" name=\"" +
            xml_escaped(case_name(model, one)) + "\" time=\"" +
            seconds_text(seconds_per_move * static_cast<double>(one.moves)) + "\">\n";
    if (one.gouging + one.buried > 0) {
      ++failures;
      body += failure(model, one);
    } else if (one.open > 0) {
      ++skips;
      body += skipped(model, one);
    }
    body += "  </testcase>\n";
  }
  const std::string counts = "tests=\"" + std::to_string(cases.size()) + "\" failures=\"" + std::to_string(failures) +
                             "\" errors=\"0\" skipped=\"" + std::to_string(skips) + "\" time=\"" +
                             seconds_text(model.seconds) + "\"";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n <testsuite name=\"" +
         xml_escaped(std::string(kProgramName) + " " + model.toolpath->file) + "\" " + counts + ">\n" + body +
         beside_the_verdict(model) + " </testsuite>\n</testsuites>\n";
}

}  // namespace gouge
