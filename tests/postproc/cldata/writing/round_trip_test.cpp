#include <gtest/gtest.h>

#include <algorithm>

#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/toolpath_format.h"
#include "postproc/formats/write_corrected.h"
#include "postproc/formats/write_toolpath.h"
#include "tests/postproc/cldata/cl_files.h"
#include "tests/postproc/cldata/path_of.h"

namespace gouge::round_trip_test {
namespace {

// The files that hold CL data, read.
std::vector<Toolpath> all_paths() {
  std::vector<Toolpath> paths;
  for (const auto& file : all_cl_files()) {
    ReadOutcome outcome = read_toolpath(file.string(), bytes_of(file));
    if (outcome.toolpath) paths.push_back(std::move(*outcome.toolpath));
  }
  return paths;
}

// Half of the last digit of a dialect's coordinates, or of those of a file in inches, in mm; and a little.
constexpr double kLastDigit_mm = 0.00051;

void expect_same_motions(const Toolpath& a, const Toolpath& b, double within_mm) {
  ASSERT_EQ(a.moves.size(), b.moves.size()) << a.file;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < a.moves.size() && shown < 3; ++i) {
    const double tip = (a.moves[i].end.tip - b.moves[i].end.tip).cwiseAbs().maxCoeff();
    const double axis = (a.moves[i].end.axis - b.moves[i].end.axis).cwiseAbs().maxCoeff();
    const bool is_same = tip <= within_mm && axis <= 2e-6 && a.moves[i].has_start == b.moves[i].has_start &&
                         a.moves[i].curve_kind == b.moves[i].curve_kind;
    if (is_same && a.moves[i].curve_kind == CurveKind::arc) {
      EXPECT_NEAR(a.arcs[a.moves[i].curve].sweep_rad, b.arcs[b.moves[i].curve].sweep_rad, 0.02) << a.file << " " << i;
    }
    EXPECT_TRUE(is_same) << a.file << ":" << a.moves[i].line << " move " << i << " tip " << tip << " axis " << axis;
    shown += is_same ? 0 : 1;
  }
}

TEST(RoundTrip, WithoutAChangeEveryFileKeepsItsBytes) {
  const std::vector<Toolpath> paths = all_paths();
  EXPECT_GE(paths.size(), 13u);
  for (const Toolpath& path : paths) {
    const Result<std::string> text = write_corrected(path, {});
    ASSERT_TRUE(text) << path.file;
    EXPECT_EQ(*text, path.source) << path.file;
  }
}

TEST(RoundTrip, ThroughTheNeutralModelTheSameDialectHasTheSameMotions) {
  std::size_t written = 0;
  for (const Toolpath& path : all_paths()) {
    const Result<WrittenToolpath> result = write_toolpath(path, *dialect_called(path.dialect));
    if (!result) continue;
    ReadOptions options;
    options.dialect = dialect_called(path.dialect);
    if (!path.is_unit_stated) options.unit = path.unit;
    const ReadOutcome again = read_toolpath("again " + path.file, result->bytes, options);
    ASSERT_TRUE(again.toolpath) << path.file << " " << to_text(again.errors.front());
    const bool has_chords = std::any_of(result->notes.begin(), result->notes.end(),
                                        [](const Diagnostic& note) { return note.code == "convert-chords"; });
    if (has_chords) continue;
    expect_same_motions(path, *again.toolpath, kLastDigit_mm);
    ++written;
  }
  EXPECT_GE(written, 10u);
}

// The names of operations in the order in which motion comes to them.
std::vector<std::string> operation_names(const Toolpath& path) {
  std::vector<std::string> names;
  std::size_t last = kNone;
  for (const Move& move : path.moves) {
    if (move.operation == kNone || move.operation == last) continue;
    last = move.operation;
    names.push_back(path.operations[last].name);
  }
  return names;
}

TEST(RoundTrip, NamesOfOperationsAndWhatShowsTheDialectAreWritten) {
  const Toolpath path = path_of(
      "TOOL PATH/ROUGH,TOOL,A\nTLDATA/MILL,10.0,5.0,75.0,0.0,0.0\nLOAD/TOOL,1\nGOTO/1.0,2.0,3.0\nGOTO/2.0,2.0,3.0\n"
      "END-OF-PATH\nTOOL PATH/FINISH,TOOL,A\nTLDATA/MILL,10.0,5.0,75.0,0.0,0.0\nLOAD/TOOL,1\nGOTO/3.0,2.0,3.0\n"
      "END-OF-PATH\n");
  for (const Dialect& dialect : all_dialects()) {
    if (dialect.kind == DialectKind::nci || dialect.kind == DialectKind::goto_list) continue;
    const Result<WrittenToolpath> result = write_toolpath(path, dialect);
    ASSERT_TRUE(result) << dialect.id;
    EXPECT_EQ(recognise_dialect(result->bytes).id, dialect.id);
    const ReadOutcome again = read_toolpath("again", result->bytes);
    ASSERT_TRUE(again.toolpath) << dialect.id;
    std::vector<std::string> names = operation_names(*again.toolpath);
    for (std::string& name : names) name = name.substr(name.starts_with("FEATNO ") ? 7 : 0);
    if (dialect.kind == DialectKind::solidworks_cam) continue;  // its comments name tools as well
    EXPECT_EQ(names, (std::vector<std::string>{"ROUGH", "FINISH"})) << dialect.id;
  }
}

TEST(RoundTrip, EveryDialectTakesAPathWithTiltsArcsAndTools) {
  const Toolpath path = path_of(bytes_of(corpus() / "autodesk.apt"));
  for (const Dialect& dialect : all_dialects()) {
    const Result<WrittenToolpath> result = write_toolpath(path, dialect);
    if (dialect.kind == DialectKind::nci || dialect.kind == DialectKind::clt) {
      ASSERT_FALSE(result) << dialect.id;
      EXPECT_EQ(result.error().code, "convert-dialect");
      continue;
    }
    ASSERT_TRUE(result) << dialect.id << result.error().message;
    for (const Diagnostic& note : result->notes) EXPECT_NE(note.code, "convert-verify") << dialect.id << note.message;
    ReadOptions options;
    options.dialect = dialect;
    const ReadOutcome again = read_toolpath("again", result->bytes, options);
    ASSERT_TRUE(again.toolpath) << dialect.id;
    EXPECT_EQ(recognise_dialect(result->bytes).id, dialect.id);
    const double factor = mm_per(path.unit) / mm_per(again.toolpath->unit);
    expect_vector(again.toolpath->moves.back().end.tip * factor, 1.5 * 25.4, 0.5 * 25.4, 3.5 * 25.4, 2e-3);
    expect_vector(again.toolpath->moves.back().end.axis, 0.6, 0, 0.8, 1e-6);
  }
}

/// How writing `text` in `target` ends: the code of its error, or of a note that begins with convert-verify, or "".
std::string outcome_of(const std::string& text, const Dialect& target) {
  const Result<WrittenToolpath> result = write_toolpath(path_of(text), target);
  if (!result) return result.error().code;
  for (const Diagnostic& note : result->notes) {
    if (note.code == "convert-verify") return note.code + ": " + note.message;
  }
  return "";
}

// Each with a move that no dialect but the named one can keep from running with the tool before it.
TEST(RoundTrip, NoMoveGetsTheToolOfAnother) {
  const std::string nx_head =
      "TOOL PATH/A,TOOL,flat10\nTLDATA/MILL,10,0,50,0,0\nLOAD/TOOL,1\nGOTO/56,0,-5\n"
      "GOTO/56,10,-5\nEND-OF-PATH\nTOOL PATH/B,TOOL,";
  const std::string motion = "GOTO/56,0,-5\nGOTO/56,10,-5\n";
  struct Case {
    std::string text;
    std::optional<DialectKind> can_say;
  };
  const std::vector<Case> cases = {
      {"UNITS/MM\nCUTTER/10\nGOTO/56,0,-5\nCUTTER/0\n" + motion, std::nullopt},
      {"UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/56,0,-5\nCUTTER/0\n" + motion, std::nullopt},
      {nx_head + "flat20\nTLDATA/MILL,20,0,50,0,0\n" + motion + "END-OF-PATH\n", DialectKind::nx_clsf},
      {nx_head + "flat20\n" + motion + "END-OF-PATH\n", DialectKind::nx_clsf},
  };
  for (const Case& c : cases) {
    for (const Dialect& dialect : all_dialects()) {
      if (dialect.kind == DialectKind::nci) continue;
      // Dialects without these tools or without any leave them to the library, and state so.
      const bool says_no_cutter = dialect.kind == DialectKind::creo || dialect.kind == DialectKind::mori;
      const std::string outcome = outcome_of(c.text, dialect);
      if (dialect.kind == DialectKind::goto_list || c.can_say == dialect.kind) {
        EXPECT_EQ(outcome, "") << dialect.id << "\n" << c.text;
      } else if (!says_no_cutter) {
        EXPECT_EQ(outcome, "convert-tool") << dialect.id << "\n" << c.text;
      } else {
        EXPECT_TRUE(outcome.empty() || outcome.starts_with("convert-")) << dialect.id << outcome << "\n" << c.text;
        EXPECT_TRUE(outcome == "convert-tool" || !c.can_say) << dialect.id << "\n" << c.text;
      }
    }
  }
}

TEST(RoundTrip, AToolThatADialectCannotSayIsReported) {
  const Toolpath path = path_of("UNITS/MM\nCUTTER/0,0,0,0,0,45,20\nLOADTL/1\nGOTO/0,0,0\n");
  const Result<WrittenToolpath> result = write_toolpath(path, dialect_of(DialectKind::nx_clsf));
  ASSERT_TRUE(result);
  EXPECT_TRUE(std::any_of(result->notes.begin(), result->notes.end(),
                          [](const Diagnostic& note) { return note.code == "convert-tools"; }));
  const Toolpath creo = path_of("$$* Pro/CLfile\nUNITS / MM\nLOADTL / 1\n$$-> CUTTER / 12.5\nGOTO / 0, 0, 0\nFINI\n");
  EXPECT_NE(write_toolpath(creo, dialect_of(DialectKind::creo))->bytes.find("$$-> CUTTER / 12.500000\n"),
            std::string::npos);
  EXPECT_FALSE(write_toolpath(creo, dialect_of(DialectKind::apt))->notes.empty());
}

TEST(RoundTrip, ALengthThatIsLeftOutIsReported) {
  const auto notes = [](const std::string& loading) {
    const Toolpath path = path_of("UNITS/MM\nCUTTER/10\n" + loading + "\nGOTO/0,0,0\n");
    const Result<WrittenToolpath> result = write_toolpath(path, dialect_of(DialectKind::creo));
    return std::ranges::count_if(result->notes, [](const Diagnostic& note) {
      return note.code == "convert-tools" && note.message.find("LENGTH") != std::string::npos;
    });
  };
  EXPECT_EQ(notes("LOADTL/1,LENGTH,45"), 1);
  EXPECT_EQ(notes("LOADTL/1"), 0);
}

// Half a turn fits both ways round; of quarters the stated angle shows.
TEST(RoundTrip, ArcsWhoseAngleShowsNoSenseArePartedForAutodesk) {
  const std::string nx = "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nLOAD/TOOL,1\nGOTO/10,0,0\n";
  for (const std::string sign : {"", "-"}) {
    const std::string circle = "CIRCLE/0,0,0,0,0," + sign + "1,10,.06,.5,10,0\n";
    for (const char* end : {"GOTO/-10,0,0\n", "GOTO/10,0,0\n", "GOTO/10,0,3\n", "GOTO/0,10,0\n"}) {
      const std::string text = nx + circle + end + "END-OF-PATH\n";
      EXPECT_EQ(outcome_of(text, dialect_of(DialectKind::autodesk)), "") << text;
    }
  }
}

// A path that was not checked because of CUTCOM must not become one that is.
TEST(RoundTrip, CompensationIsKept) {
  const std::string text =
      "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,0\nCUTCOM/LEFT\nGOTO/5,0,0\nCIRCLE/5,5,0,0,0,1,5\nGOTO/10,5,0\n"
      "GOTO/10,9,0\nCUTCOM/OFF\nGOTO/10,20,0\nGOTO/0,20,0\nCUTCOM/RIGHT\nGOTO/0,15,0\nCUTCOM/OFF\nGOTO/0,0,0\nFINI\n";
  ReadOptions reading;
  reading.dialect = dialect_called("apt-creo");
  const ReadOutcome first = read_toolpath("a.ncl", text, reading);
  ASSERT_TRUE(first.toolpath);
  const Toolpath& path = *first.toolpath;
  const std::vector<bool> is_checked = {true, false, false, false, false, true, false, false};
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    EXPECT_EQ(path.moves[i].not_checked_reason.empty(), is_checked.at(i)) << i;
  EXPECT_EQ(path.moves[2].curve_kind, CurveKind::arc);
  for (const Dialect& dialect : all_dialects()) {
    if (dialect.kind == DialectKind::nci) continue;
    const Result<WrittenToolpath> written = write_toolpath(path, dialect);
    if (dialect.kind == DialectKind::goto_list) {
      ASSERT_FALSE(written);
      EXPECT_EQ(written.error().code, "convert-dialect");
      continue;
    }
    ASSERT_TRUE(written) << dialect.id;
    for (const Diagnostic& note : written->notes) EXPECT_NE(note.code, "convert-verify") << dialect.id;
    ReadOptions again;
    again.dialect = dialect;
    const ReadOutcome outcome = read_toolpath("again", written->bytes, again);
    ASSERT_TRUE(outcome.toolpath) << dialect.id;
    const bool has_chords = outcome.toolpath->moves.size() != path.moves.size();
    for (std::size_t i = 0; !has_chords && i < path.moves.size(); ++i)
      EXPECT_EQ(outcome.toolpath->moves[i].not_checked_reason, path.moves[i].not_checked_reason) << dialect.id << i;
    again.is_cutcom_centre = true;
    const ReadOutcome centre = read_toolpath("again", written->bytes, again);
    for (const Move& move : centre.toolpath->moves) EXPECT_TRUE(move.not_checked_reason.empty()) << dialect.id;
    EXPECT_LE(std::count_if(outcome.toolpath->moves.begin(), outcome.toolpath->moves.end(),
                            [](const Move& move) { return move.not_checked_reason.empty(); }),
              2)
        << dialect.id;
  }
}

// Where the user states that positions are the cutter's centre, Creo's words state it on.
TEST(RoundTrip, CompensationOfPositionsOnTheCentreIsKeptAsWell) {
  ReadOptions options;
  options.is_cutcom_centre = true;
  const ReadOutcome read =
      read_toolpath("a.apt", "UNITS/MM\nGOTO/0,0,0\nCUTCOM/RIGHT\nGOTO/5,0,0\nCUTCOM/OFF\nGOTO/9,0,0\nFINI\n", options);
  ASSERT_TRUE(read.toolpath);
  const Result<WrittenToolpath> creo = write_toolpath(*read.toolpath, *dialect_called("apt-creo"));
  ASSERT_TRUE(creo);
  EXPECT_NE(creo->bytes.find("OUTPUT_ON_CENTER"), std::string::npos);
  EXPECT_NE(creo->bytes.find("CUTCOM / RIGHT\n"), std::string::npos);
  const Toolpath again = path_of(creo->bytes);
  for (const Move& move : again.moves) EXPECT_TRUE(move.not_checked_reason.empty());
  const ReadOutcome two = read_toolpath(
      "a.apt", "UNITS/MM\nPPRINT ONE\nGOTO/0,0,0\nCUTCOM/RIGHT\nGOTO/5,0,0\nGOHOME\nPPRINT TWO\nGOTO/9,0,0\nFINI\n",
      options);
  ASSERT_TRUE(two.toolpath);
  const Result<WrittenToolpath> sequences = write_toolpath(*two.toolpath, *dialect_called("apt-creo"));
  ASSERT_TRUE(sequences);
  const Toolpath sequences_again = path_of(sequences->bytes);
  for (const Move& move : sequences_again.moves) EXPECT_TRUE(move.not_checked_reason.empty()) << sequences->bytes;
  const Result<WrittenToolpath> list = write_toolpath(*read.toolpath, *dialect_called("goto-list"));
  ASSERT_TRUE(list);
  EXPECT_TRUE(std::any_of(list->notes.begin(), list->notes.end(),
                          [](const Diagnostic& note) { return note.code == "convert-cutcom"; }));
}

// A move from an unknown retract is unknown before and after conversion.
TEST(RoundTrip, RetractsAreKept) {
  const Toolpath path = path_of(
      "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/0,0,10\nRETRCT\nCUTCOM/LEFT\nGOTO/10,0,10\nCUTCOM/OFF\nGOTO/20,0,10\n"
      "GOTO/30,0,10\nFINI\n");
  for (const Dialect& dialect : all_dialects()) {
    if (dialect.kind == DialectKind::nci) continue;
    const Result<WrittenToolpath> written = write_toolpath(path, dialect);
    ASSERT_EQ(written.has_value(), dialect.kind != DialectKind::goto_list) << dialect.id;
    if (!written) continue;
    for (const Diagnostic& note : written->notes) EXPECT_NE(note.code, "convert-verify") << dialect.id;
    ReadOptions again;
    again.dialect = dialect;
    const ReadOutcome outcome = read_toolpath("again", written->bytes, again);
    ASSERT_TRUE(outcome.toolpath) << dialect.id;
    ASSERT_EQ(outcome.toolpath->moves.size(), path.moves.size()) << dialect.id;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      EXPECT_EQ(outcome.toolpath->moves[i].not_checked_reason, path.moves[i].not_checked_reason) << dialect.id << i;
      EXPECT_EQ(outcome.toolpath->moves[i].has_start, path.moves[i].has_start) << dialect.id << i;
    }
  }
}

TEST(RoundTrip, WhatIsNotUnderstoodIsNotConverted) {
  const Toolpath path = path_of("UNITS/MM\nGOTO/1,2,3\nMOVETO/4,5,6\nGOTO/7,8,9\n");
  const Result<WrittenToolpath> result = write_toolpath(path, *dialect_called("creo"));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "convert-not-understood");
  EXPECT_EQ(result.error().line, 3u);
}

// The source speaks the same dialect, so that the dialect cannot be the reason.
TEST(RoundTrip, SplinesAreDistinguishedFromArcsAndCountedInTheSingular) {
  const Toolpath path = path_of(
      "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10.0,5.0,75.0,0.0,0.0\nFEDRAT/MMPM,250.0\nGOTO/-254.9774,466.5681,206.8891\n"
      "NURBS/\n"
      "KNOT/0.0416667,0.3750000,0.6250000,0.9583333,1.0000000\nCNTRL/-254.9774,466.2698,206.9401\n"
      "CNTRL/-254.9775,463.5692,207.2380\nCNTRL/-254.9776,459.2589,209.0136\nCNTRL/-254.9778,454.6135,213.9021\n"
      "CNTRL/-254.9779,453.0599,218.2973\nCNTRL/-254.9779,452.9000,221.0096\nCNTRL/-254.9779,452.8642,221.3100\n"
      "RAPID\nGOTO/-254.9779,452.7668,223.7424\nEND-OF-PATH\n");
  const auto reported = [&](const char* dialect) {
    std::vector<std::string> messages;
    const Result<WrittenToolpath> written = write_toolpath(path, *dialect_called(dialect));
    EXPECT_TRUE(written.has_value());
    for (const Diagnostic& note : written->notes) messages.push_back(note.message);
    return messages;
  };
  const std::string spline =
      "1 spline written as straight moves within 0.001 mm: splines are read, and written in no dialect";
  EXPECT_EQ(reported("nx-clsf"), std::vector<std::string>{spline});
  const std::vector<std::string> list = reported("goto-list");
  ASSERT_GE(list.size(), 4U);
  EXPECT_EQ(list[0], spline);
  EXPECT_EQ(list[1], "1 rapid move written as feed: the dialect has no rapid moves");
  EXPECT_EQ(list[2], "2 feed moves whose feed is left out: the dialect has no feeds");
  EXPECT_EQ(list[3], "1 tool without the whole shape, which the dialect cannot say; give it in a tool library");
}

// Every sample with each straight move lifted and a position put before it.
TEST(RoundTrip, CorrectionsOfEverySampleAreReadBack) {
  std::size_t corrected = 0;
  for (const auto& file : files_below(corpus())) {
    const Toolpath path = path_of(bytes_of(file));
    std::vector<PathChange> changes;
    std::size_t inserted = 0;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Move& move = path.moves[i];
      const bool is_straight = move.kind == MoveKind::feed || move.kind == MoveKind::rapid;
      const bool meets_arc = i + 1 < path.moves.size() && path.moves[i + 1].curve_kind != CurveKind::none;
      const bool meets_step = i + 1 < path.moves.size() && path.moves[i + 1].kind != MoveKind::feed &&
                              path.moves[i + 1].kind != MoveKind::rapid;
      if (!is_straight || meets_arc || meets_step || !move.not_checked_reason.empty() || !move.has_start) continue;
      Pose end = move.end;
      end.tip += 1.25 * end.axis;
      Pose between{0.5 * (path.start_of(i).tip + end.tip), end.axis};
      changes.push_back({i, end, {between}});
      ++inserted;
    }
    if (inserted == 0) continue;  // every straight move meets an arc
    ++corrected;
    const Result<std::string> text = write_corrected(path, changes);
    ASSERT_TRUE(text) << file << text.error().message;
    ReadOptions options;
    options.dialect = dialect_called(path.dialect);
    const ReadOutcome again = read_toolpath("again", *text, options);
    ASSERT_TRUE(again.toolpath) << file << to_text(again.errors.front()) << *text;
    EXPECT_EQ(again.toolpath->moves.size(), path.moves.size() + inserted) << file << "\n" << *text;
    const Pose& last = *changes.back().new_end;
    const Move& read = again.toolpath->moves[changes.back().move + inserted];
    EXPECT_LE((read.end.tip - last.tip).norm(), 1e-3) << file << "\n" << *text;
    EXPECT_LE((read.end.axis - last.axis).norm(), 1e-5) << file;
    EXPECT_EQ(read.kind, path.moves[changes.back().move].kind) << file;
  }
  EXPECT_GE(corrected, 8u);
}

}  // namespace
}  // namespace gouge::round_trip_test
