#include "postproc/formats/toolpath_format.h"

#include <algorithm>
#include <array>
#include <utility>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/lexing/lexer.h"
#include "postproc/cldata/nccs/nccs_edits.h"
#include "postproc/cldata/nccs/nccs_records.h"
#include "postproc/cldata/nccs/nccs_sink.h"
#include "postproc/cldata/nccs/nccs_statements.h"
#include "postproc/cldata/nci/nci_edits.h"
#include "postproc/cldata/nci/nci_motion.h"
#include "postproc/cldata/nci/nci_statements.h"
#include "postproc/cldata/reading/recognise_text.h"
#include "postproc/cldata/rewriting/goto_text.h"
#include "postproc/cldata/rewriting/rewriters.h"
#include "postproc/cldata/writing/text_sink.h"
#include "postproc/gcode/reading/read_gcode.h"

namespace gouge {
namespace {

using EditsOfClData = Result<Edits> (*)(const Toolpath&, const MotionRecords&, const std::vector<PathChange>&);

template <bool (*is_in_format)(std::string_view), DialectKind dialect>
std::optional<Dialect> recognise_by(std::string_view bytes) {
  return is_in_format(bytes) ? std::optional(dialect_of(dialect)) : std::nullopt;
}

template <OpenStatements open>
ReadOutcome read_by(const std::string& file_name, SourceText bytes, const Dialect& dialect, const ReadOptions& options,
                    const ProgressCall& progress) {
  return read_cl_data(file_name, std::move(bytes), dialect, open, options, progress);
}

template <OpenStatements open>
std::shared_ptr<const MotionRecords> records_by(const Toolpath& path) {
  return read_motion_records(path, open);
}

template <OpenStatements open, EditsOfClData edits_of>
Result<Edits> rewrite_by(const Toolpath& path, const std::vector<PathChange>& changes) {
  return edits_of(path, *read_motion_records(path, open), changes);
}

template <OpenStatements open>
Decimals decimals_by(const Toolpath& path, const MotionRecords& records) {
  const GotoText text(path, records, open);
  return {text.coordinate_decimals(), text.axis_decimals()};
}

// Returns the decimals for numbers without decimals: the resolution of a double at the size of a part.
Decimals decimals_of_records(const Toolpath&, const MotionRecords&) { return {7, 9}; }

ReadOutcome read_program(const std::string& file_name, SourceText bytes, const Dialect& /*dialect*/,
                         const ReadOptions& options, const ProgressCall& progress) {
  const GcodeOptions program{options.program ? *options.program : ProgramSetup{}, options.unit, options.harmless_words,
                             options.unnamed_tool};
  return read_gcode(file_name, std::move(bytes), program, progress);
}

// A program has no records of CL data: nothing of its moves is compensated or curved beyond what the path states.
std::shared_ptr<const MotionRecords> records_of_program(const Toolpath& path) {
  auto records = std::make_shared<MotionRecords>();
  records->of_move.resize(path.moves.size());
  return records;
}

Result<Edits> refuse_rewriting(const Toolpath& path, const std::vector<PathChange>& /*changes*/) {
  return make_error("write-gcode", "a program of a machine's control is not corrected; correct its CL data", path.file);
}

Decimals decimals_of_program(const Toolpath&, const MotionRecords&) { return {6, 9}; }

// In order of reliability. The text format accepts every file.
constexpr std::array<ToolpathFormat, 4> kFormats = {{
    {.id = "nccs-records",
     .recognise = recognise_by<is_nccs_binary, DialectKind::nccs_binary>,
     .read = read_by<open_nccs>,
     .records = records_by<open_nccs>,
     .rewrite = rewrite_by<open_nccs, edits_of_nccs>,
     .decimals = decimals_of_records,
     .make_sink = make_nccs_sink},
    {.id = "nci-lines",
     .recognise = recognise_by<is_nci, DialectKind::nci>,
     .read = read_by<open_nci>,
     .records = records_by<open_nci>,
     .rewrite = rewrite_by<open_nci, edits_of_nci>,
     .decimals = decimals_by<open_nci>,
     .make_sink = nullptr},
    {.id = "gcode",
     .recognise =
         [](std::string_view bytes) { return is_gcode(bytes) ? std::optional(gcode_dialect()) : std::nullopt; },
     .read = read_program,
     .records = records_of_program,
     .rewrite = refuse_rewriting,
     .decimals = decimals_of_program,
     .make_sink = nullptr},
    {.id = "text",
     .recognise = [](std::string_view bytes) { return std::optional(recognise_text(bytes)); },
     .read = read_by<open_text>,
     .records = records_by<open_text>,
     .rewrite = rewrite_by<open_text, edits_of_text>,
     .decimals = decimals_by<open_text>,
     .make_sink = make_text_sink},
}};

}  // namespace

const ToolpathFormat& format_called(std::string_view id) {
  const auto* const row = std::ranges::find(kFormats, id, &ToolpathFormat::id);
  return row == kFormats.end() ? kFormats.back() : *row;
}

const ToolpathFormat& format_of(const Toolpath& path) { return format_called(dialect_or_apt(path.dialect).format); }

Dialect recognise_dialect(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  for (const ToolpathFormat& format : kFormats) {
    if (std::optional<Dialect> dialect = format.recognise(bytes)) return *std::move(dialect);
  }
  return dialect_of(DialectKind::apt);
}

}  // namespace gouge
