#pragma once

#include "postproc/report/report_model.h"

// A path of eight moves that has every state once at least, for the writers' tests.

namespace gouge {

struct SmallReport {
  Toolpath path;
  CheckResult result;
  ReportModel model;

  SmallReport() {
    path.file = "path.apt";
    path.dialect = "apt";
    path.source = "GOTO/0\nGOTO/1\nGOTO/2\nGOTO/3\n";
    path.tools = {PathTool{1, "ball D10", {}, 0, 3}, PathTool{{}, "long, \"thin\"", {}, 0, 9}};
    path.operations = {Operation{"finish <1>", 2}, Operation{"", 20}};
    for (std::size_t i = 0; i < 8; ++i) {
      Move move;
      move.line = 10 + i;
      move.tool = i < 6 ? 0 : 1;
      move.operation = i < 6 ? 0 : 1;
      path.moves.push_back(move);
    }
    path.moves[0].kind = MoveKind::rapid;
    path.words_not_understood["PPRINT"] = 2;
    result.verdicts.resize(8);
    set_gouge(1, 0.25);
    set_gouge(2, 0.3333);
    result.verdicts[2].witness->t = 0.42;
    result.verdicts[3].state = MoveState::near_miss;
    result.verdicts[3].clearance_mm = 0.125;
    result.verdicts[3].witness = Witness{0.5, {1, 2, 3}, {0, 0, 1}, Body::holder, Against::fixture, 0, 7};
    result.verdicts[4].state = MoveState::buried;
    result.verdicts[5].state = MoveState::not_certified;
    result.verdicts[5].depth_upper_mm = 0.5;
    result.verdicts[5].reason = {Reason::Kind::of_path, Body::cutter, 0, std::string("budget of 10 bounds spent")};
    for (const std::size_t i : {6U, 7U}) {
      result.verdicts[i].state = MoveState::not_checked;
      result.verdicts[i].reason = {Reason::Kind::of_path, Body::cutter, 0, std::string("arcs, as yet, are not read")};
    }
    result.events = {{MoveState::gouge, 1, 2, 2, 2, 0, Body::cutter, Against::part},
                     {MoveState::near_miss, 3, 3, 3, 1, 0, Body::holder, Against::fixture},
                     {MoveState::buried, 4, 4, 4, 1, 0, Body::cutter, Against::part}};
    result.counts = {1, 1, 2, 1, 2, 1, 0};
    result.worst_depth_mm = 0.3333;
    result.worst_move = 2;
    model.toolpath = &path;
    model.result = &result;
    model.inputs = {describe_input("toolpath", "path.apt", path.source)};
    model.parts = {MeshFacts{"part.stl", 12, 8, 0, true, "closed: a buried tool is reported"}};
    model.fixtures = {MeshFacts{"vise.stl", 12, 8, 0, false, ""}};
    model.tools = {ToolFacts{"ball D10", "tools.json", "ball D10"}, ToolFacts{"long, \"thin\"", "", ""}};
    model.notes = {make_warning("apt-word", "word not understood", "path.apt", 4)};
  }
  SmallReport(const SmallReport&) = delete;
  SmallReport& operator=(const SmallReport&) = delete;

  void set_gouge(std::size_t move, double depth_mm) {
    MoveVerdict& verdict = result.verdicts[move];
    verdict.state = MoveState::gouge;
    verdict.depth_mm = depth_mm;
    verdict.depth_upper_mm = depth_mm + 0.0005;
    verdict.witness = Witness{0.25, {12.3, 4.5, 6.7}, {0, 0, 1}, Body::cutter, Against::part, 0, 5};
  }

  void add_correction() {
    model.has_correction = true;
    model.correction.output_file = "out.apt";
    model.correction.strategy = "weighted";
    model.correction.changes = {{1, 11, "weighted", false, {0, 0, 0.25}, 0.25, 0, 0.25, 0, 3},
                                {2, 12, "inserted", true, {0, 0, 0.3}, 0.3, 0, 0.3333, 0, 1}};
    model.correction.uncorrected = {{4, 14, 0.8, "the shift would exceed 0.5 mm"}};
    model.correction.toolpath_before = &path;
    model.correction.result_before = &result;
  }
};

}  // namespace gouge
