#include "postproc/report/write_report.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/excess_text.h"
#include "postproc/report/findings.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

struct Case {
  std::size_t operation = kNone, tool = kNone;
  std::size_t moves = 0, gouging = 0, buried = 0, open = 0, left_out = 0;
  std::size_t worst_move = kNone;
  std::size_t first_open = kNone;
  std::vector<const Event*> events;
};

void count_move(Case& one, const CheckResult& result, std::size_t index, bool is_accepted) {
  const MoveVerdict& verdict = result.verdicts[index];
  ++one.moves;
  if (is_accepted) return;
  if (verdict.state == MoveState::gouge) {
    ++one.gouging;
    if (one.worst_move == kNone || verdict.depth_mm > result.verdicts[one.worst_move].depth_mm) one.worst_move = index;
  } else if (verdict.state == MoveState::buried) {
    ++one.buried;
  } else if (verdict.reason.is(Reason::Kind::rapid_skipped)) {
    ++one.left_out;
  } else if (verdict.state == MoveState::not_checked || verdict.state == MoveState::not_certified) {
    ++one.open;
    if (one.first_open == kNone) one.first_open = index;
  }
}

std::vector<Case> cases_of(const ReportModel& model) {
  std::vector<Case> cases;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
  const Moves& moves = model.toolpath->moves;
  const auto case_of = [&](std::size_t move) -> Case& {
    const std::pair key{moves[move].operation, moves[move].tool};
    const auto [entry, is_new] = known.try_emplace(key, cases.size());
    if (is_new) cases.push_back(Case{.operation = key.first, .tool = key.second, .events = {}});
    return cases[entry->second];
  };
  const std::vector<Event>& events = model.result->events;
  std::vector<bool> is_accepted(moves.size(), false);
  for (std::size_t k = 0; k < events.size(); ++k) {
    for (std::size_t i = events[k].first_move; model.baseline.is_accepted(k) && i <= events[k].last_move; ++i)
      is_accepted[i] = true;
  }
  for (std::size_t i = 0; i < moves.size(); ++i) count_move(case_of(i), *model.result, i, is_accepted[i]);
  for (const Event& event : events) {
    if (is_accepted[event.worst_move]) continue;
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

std::string failure_message(const ReportModel& model, const Case& one) {
  std::string message;
  if (one.gouging > 0) {
    message = "gouge " +
              depth_text(model.result->verdicts[one.worst_move].depth_mm, model.toolpath->unit, model.options) +
              " deep at line " + std::to_string(model.toolpath->moves[one.worst_move].line) + "; " +
              std::to_string(one.gouging) + " of " + count_text(one.moves, "move") + " gouge";
  }
  if (one.buried > 0) {
    message += (message.empty() ? "" : "; ") + std::string("tool buried in ") + count_text(one.buried, "move");
  }
  return message;
}

std::string failure_text(const ReportModel& model, const Case& one) {
  std::string text;
  for (const Event* event : one.events) {
    text += model.toolpath->file + ":" + std::to_string(model.toolpath->moves[event->worst_move].line) + ": " +
            event_text(model, *event) + span_text(*event) + "\n";
  }
  return text;
}

std::string open_text(const ReportModel& model, const Case& one) {
  return std::to_string(one.open) + " of " + count_text(one.moves, "move") +
         " not checked or not certified: " + reason_text(model.result->verdicts[one.first_open].reason);
}

JunitCase case_of(const ReportModel& model, const Case& one) {
  JunitCase made;
  made.name = case_name(model, one);
  made.moves = one.moves;
  if (one.gouging + one.buried > 0) {
    made.failure_type = one.gouging > 0 ? "gouge" : "buried";
    made.failure_message = failure_message(model, one);
    if (one.open > 0) made.failure_message += "; " + open_text(model, one);
    made.failure_text = failure_text(model, one);
  } else if (one.open > 0) {
    made.error_message = open_text(model, one);  // build servers count skipped cases as passed
  } else if (one.left_out == one.moves) {
    made.skipped_message = left_out_text(one.left_out);
  }
  return made;
}

// Returns a separate test case for facts, because they concern the whole path, not an operation.
JunitCase open_case(const std::vector<std::string>& facts) {
  JunitCase made;
  made.name = "assumptions";
  for (const std::string& fact : facts) made.error_message += (made.error_message.empty() ? "" : "; ") + fact;
  return made;
}

// Returns a separate test case for the material that is left on the part.
JunitCase excess_case(const ReportModel& model) {
  const ExcessFacts& facts = *model.result->excess;
  JunitCase made;
  made.name = kExcessCase;
  std::string places;
  for (const ExcessPlaceFacts& place : facts.places)
    places += model.parts[place.part].name + ": " + excess_kind(place) + ": " + excess_place_text(model, place) + "\n";
  made.failure_text = places;
  if (facts.proved() > 0) {
    made.failure_type = kExcessFailure;
    made.failure_message = excess_text(model);
  } else if (!facts.places.empty()) {
    made.error_message = excess_text(model);
  }
  return made;
}

// Returns text that build servers show, but that fails no test.
std::string beside_the_verdict(const ReportModel& model) {
  std::string text;
  for (std::size_t k = 0; k < model.result->events.size(); ++k) {
    if (!model.baseline.is_accepted(k)) continue;
    const Event& event = model.result->events[k];
    text += model.toolpath->file + ":" + std::to_string(model.toolpath->moves[event.worst_move].line) + ": accepted " +
            event_text(model, event) + span_text(event) + "\n";
  }
  if (const std::size_t rapids = model.result->counts.skipped; rapids > 0)
    text += "note: " + left_out_text(rapids) + "\n";
  text += baseline_lines(model);
  for (const std::string& reservation : reservations(model)) text += "note: " + reservation + "\n";
  for (const Diagnostic& note : model.notes) {
    if (note.severity == Severity::warning) text += to_text(note) + "\n";
  }
  return text;
}

std::string suite_name(const std::string& toolpath) { return std::string(kProgramName) + " " + toolpath; }

std::string seconds_text(double seconds) { return fixed_text(seconds, 3); }

// Escapes a text line by line, because an escaped line end would become a blank.
std::string lines_escaped(const std::string& text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    escaped += xml_escaped(text.substr(at, end - at)) + "\n";
    at = end + 1;
  }
  return escaped;
}

std::string attribute(const char* name, const std::string& value) {
  return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}

std::string case_xml(const JunitSuite& suite, const JunitCase& one) {
  const double seconds_per_move = suite.seconds / static_cast<double>(std::max<std::size_t>(suite.moves, 1));
  std::string xml = "  <testcase" + attribute("classname", suite.toolpath) + attribute("name", one.name) +
                    attribute("time", seconds_text(seconds_per_move * static_cast<double>(one.moves))) + ">\n";
  if (!one.failure_type.empty()) {
    xml += "   <failure" + attribute("type", one.failure_type) + attribute("message", one.failure_message) + ">" +
           lines_escaped(one.failure_text) + "</failure>\n";
  }
  if (!one.skipped_message.empty()) xml += "   <skipped" + attribute("message", one.skipped_message) + "/>\n";
  if (!one.error_message.empty()) xml += "   <error" + attribute("message", one.error_message) + "/>\n";
  return xml + "  </testcase>\n";
}

std::string suite_xml(const JunitSuite& suite) {
  const auto count = [&](auto has) { return std::to_string(std::ranges::count_if(suite.cases, has)); };
  std::string xml = " <testsuite" + attribute("name", suite.name) +
                    attribute("tests", std::to_string(suite.cases.size())) +
                    attribute("failures", count([](const JunitCase& one) { return !one.failure_type.empty(); })) +
                    attribute("errors", count([](const JunitCase& one) { return !one.error_message.empty(); })) +
                    attribute("skipped", count([](const JunitCase& one) { return !one.skipped_message.empty(); })) +
                    attribute("time", seconds_text(suite.seconds)) + ">\n";
  for (const JunitCase& one : suite.cases) xml += case_xml(suite, one);
  if (!suite.beside.empty()) xml += "  <system-out>" + lines_escaped(suite.beside) + "</system-out>\n";
  return xml + " </testsuite>\n";
}

}  // namespace

JunitSuite junit_suite_of(const ReportModel& model) {
  JunitSuite suite{
      model.toolpath->file,     suite_name(model.toolpath->file), model.seconds, model.result->verdicts.size(), {},
      beside_the_verdict(model)};
  for (const Case& one : cases_of(model)) suite.cases.push_back(case_of(model, one));
  if (model.result->excess) suite.cases.push_back(excess_case(model));
  if (const std::vector<std::string> open = open_facts(model); !open.empty()) suite.cases.push_back(open_case(open));
  return suite;
}

std::string write_junit(const std::vector<JunitSuite>& suites) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const JunitSuite& suite : suites) xml += suite_xml(suite);
  return xml + "</testsuites>\n";
}

std::string write_junit(const ReportModel& model) { return write_junit(std::vector{junit_suite_of(model)}); }

std::string write_junit(const FailedRun& run) {
  JunitCase one;
  one.name = "toolpath";
  one.error_message = "exit status " + std::to_string(run.exit_status);
  for (const Diagnostic& error : run.errors) one.error_message += "; " + to_text(error);
  return write_junit({JunitSuite{run.toolpath, suite_name(run.toolpath), 0, 0, {one}, {}}});
}

}  // namespace gouge
