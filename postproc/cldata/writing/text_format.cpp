#include "postproc/cldata/writing/text_format.h"

#include <algorithm>
#include <array>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr std::size_t kColumnsOfCoordinate = 6;  // in addition to the decimals: sign, four digits, point
constexpr std::size_t kColumnsOfAxis = 3;        // sign, digit, point

std::string without_zeros(std::string text) {
  text.erase(text.find_last_not_of('0') + 1);
  if (text == "0." || text == "-0.") return "0";
  if (text.starts_with("0.")) text.erase(0, 1);
  return text;
}

std::string aligned(const std::string& text, std::size_t columns) {
  return std::string(columns > text.size() ? columns - text.size() : 0, ' ') + text;
}

constexpr std::array<TextFormat, 11> kFormats = {{
    {.kind = DialectKind::apt,
     .always_has_axis = true,
     .head = "PARTNO {name}\nUNITS/{unit}\nMULTAX/ON",
     .operation = "PPRINT/'{name}'"},
    {.kind = DialectKind::goto_list, .always_has_axis = true, .end = {}},
    {.kind = DialectKind::nx_clsf,
     .decimals = 4,
     .axis_decimals = 7,
     .end = {},
     .feed = "FEDRAT/{unit},{feed}",
     .feed_decimals = 4,
     .circle = "CIRCLE/{center},{left},{radius},0.0600,0.5000,{d},{r}"},
    {.kind = DialectKind::catia,
     .line_end = "\r\n",
     .go_to = "GOTO  /",
     .decimals = 5,
     .axis_decimals = 6,
     .is_aligned = true,
     .always_has_axis = true,
     .head = "$$ -----------------------------------------------------------------\n"
             "$$     CATIA APT VERSION 1.0\n"
             "$$ -----------------------------------------------------------------\n"
             "$$*CATIA0\n"
             "$$ {name}\n"
             "$$     1.00000     0.00000     0.00000     0.00000\n"
             "$$      0.00000    1.00000     0.00000     0.00000\n"
             "$$      0.00000     0.00000    1.00000     0.00000\n"
             "PARTNO {name}\n"
             "{units_if_inch}\n"
             "MULTAX",
     .end = "END",
     .operation = "$$ OPERATION NAME : {name}",
     .feed = "FEDRAT/ {feed},{unit}",
     .feed_decimals = 4,
     .has_tlon = true,
     .cutter = "CUTTER/ {seven}",
     .number = "TOOLNO/{number},   {d}\n{tprint}\nLOADTL/{number}"},
    {.kind = DialectKind::creo,
     .go_to = "GOTO / ",
     .separator = ", ",
     .decimals = 10,
     .axis_decimals = 10,
     .breaks_before_axis = true,
     .head = "$$*          Pro/CLfile\nPARTNO / {name}\n{on_centre}\nUNITS / {unit}\n{multax_if_tilted}",
     .end = "$$-> END / \nFINI ",
     .operation = "$$-> FEATNO / {featno}\n{on_centre}",
     .has_separate_operations = true,
     .cutcom = "CUTCOM / ",
     .rapid = "RAPID ",
     .feed = "FEDRAT / {feed},  {unit}",
     .circle = "CIRCLE / {center},  $\n{right},  {radius}",
     .cutter = "$$-> CUTTER / {d}",
     .number = "LOADTL / {number}"},
    {.kind = DialectKind::solidworks_cam,
     .axis_decimals = 6,
     .drops_zeros = true,
     .head = "PARTNO/{name}\nUNIT/{unit_once}\nTRNTYP/WORLD,0,0,0",
     .operation = "PPRINT/{name}",
     .gohome = "GOHOME/",
     .rapid = "RAPID/",
     .feed = "FEDRAT/{feed},{unit}",
     .circle = "CIRCLE/{center},{right}",
     .tool_name = "INSERT/{certain_name}",
     .cutter_separator = ",",
     .number = "LOAD/TOOL,{number}",
     .flutes = "CSI_SET_FLUTE_LENGTH/{flutes}"},
    {.kind = DialectKind::clt,
     .go_to = "GOTO/ ",
     .go_to_end = " ",
     .axis_decimals = 6,
     .head = "UNITS/ {unit} \nOPFEATSTART/{name}",  // these words mark the dialect
     .operation = "OPFEATSTART/{name}",
     .gohome = "GOHOME/",
     .cutcom = "CUTCOM/ ",
     .rapid = "RAPID/ ",
     .feed = "FEDRAT/ {unit},{feed}",
     .circle = "CIRCLE/ {center},{plus_z},{radius},{sense} ",
     .cutter = "CUTTER/ {seven},",
     .cutter_separator = ","},
    {.kind = DialectKind::autodesk,
     .line_end = "\r\n",
     .separator = ", ",
     .has_axis_when_tilted = true,
     .head = "MODE/MILL\nPARTNO/'{name}'\nUNITS/{unit}\nMULTAX/{multax}",
     .end = "END\nFINI",
     .operation = "PPRINT/'{name}'",
     .circle = "MOVARC/{center}, {right}, {radius}, ANGLE, {turn}"},
    {.kind = DialectKind::camplete,
     .line_end = "\r\n",
     .separator = ", ",
     .has_axis_when_tilted = true,
     // The frame of this head is the identity, as positions are written in part coordinates.
     .head = "MODE/MILL\nPARTNO/'{name}'\nUNITS/{unit}\nMULTAX/{multax}\n"
             "MCS/1.000000000, 0.000000000, 0.000000000, $\n"
             "0.000000000, 1.000000000, 0.000000000, $\n"
             "0.000000000, 0.000000000, 1.000000000, $\n"
             "0.000000, 0.000000, 0.000000",
     .end = "END\nFINI",
     .operation = "CSI_TOOL_PATH/{name}",
     .circle = "CIRCLE/{center}, {left}, {radius}, {turn}, 0.0, 0.0, 0.0",
     .has_no_corner = true,
     .flutes = "CSI_SET_FLUTE_LENGTH/{flutes}"},
    {.kind = DialectKind::mori,
     .line_end = "\r\n",
     .go_to = "GOTO/ ",
     .separator = ", ",
     .always_has_axis = true,
     .head = "BEGIN\nUNITS/ {unit}\nMCSYS/ NUM, 1, POINT, 0, 0, 0, VECTOR, 1, 0, 0, VECTOR, 0, 1, 0\nMULTAX/ ON",
     .end = "END/",
     .operation = "OPNAME/ {name}",
     .cutcom = "CUTCOM/ ",
     .feed = "FEDRAT/ {per}, {exact}",
     .circle = "MOVARC/ CENTER, {center}, AXIS, {right}, RADIUS, {radius}",
     .cutter = {},
     .number = "TOOLNO/ {number}, MILL\nLOAD/ TOOL, {number}"},
    {.kind = DialectKind::nccs,
     .go_to = "GOTO  /",
     .decimals = 4,
     .axis_decimals = 7,
     .is_aligned = true,
     .always_has_axis = true,
     .head = "REMARK {name} NCLCAM\nUNITS/{unit}\nMULTAX/ON",
     .operation = "PPRINT/'{name}'",
     .rapid = "RAPID ",
     .feed = "FEDRAT/ {exact}{unit_after_turn}",
     .cutter_separator = ","},
}};

std::string triple(const TextFormat& format, const Vec3& value, int count, std::size_t columns) {
  std::string text;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i > 0) text += format.separator;
    const std::string token = format.number_text(value[i], count);
    text += format.is_aligned ? aligned(token, static_cast<std::size_t>(count) + columns) : token;
  }
  return text;
}

}  // namespace

std::string TextFormat::number_text(double value, int count) const {
  std::string text = fixed_text(value, count);
  return drops_zeros && count > 0 ? without_zeros(std::move(text)) : text;
}

std::string TextFormat::point(const Vec3& value) const { return triple(*this, value, decimals, kColumnsOfCoordinate); }

std::string TextFormat::direction(const Vec3& value) const {
  return triple(*this, value, axis_decimals, kColumnsOfAxis);
}

const TextFormat& text_format(DialectKind kind) {
  const auto* const row = std::ranges::find_if(kFormats, [&](const TextFormat& format) { return format.kind == kind; });
  return row == kFormats.end() ? kFormats.front() : *row;
}

}  // namespace gouge
