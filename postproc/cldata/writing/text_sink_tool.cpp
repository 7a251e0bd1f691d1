#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/cldata/writing/text_sink.h"

// The tools of a written file: CUTTER, TLDATA and the words for their numbers in each dialect.

namespace gouge {
namespace {

bool is_straight(const CutterStatement& cutter) {
  return !(std::abs(cutter.alpha_deg) > 0) && !(std::abs(cutter.beta_deg) > 0);
}

}  // namespace

std::string TextSink::seven(const CutterStatement& c, const char* separator) const {
  const bool is_trimmed = format_.drops_zeros;
  double e = scaled(c.e_mm), f = scaled(c.f_mm);
  // Autodesk's post writes the tip's diameter for e, CAMplete's no e and f; both are recomputed when read.
  if (options_.kind == DialectKind::autodesk && is_straight(c)) e = scaled(c.d_mm - 2 * c.r_mm);
  if (options_.kind == DialectKind::camplete && is_straight(c)) e = f = 0;
  std::string text;
  for (const double value : {scaled(c.d_mm), scaled(c.r_mm), e, f, c.alpha_deg, c.beta_deg, scaled(c.h_mm)}) {
    if (!text.empty()) text += separator;
    text += is_trimmed ? format_.number(value, 6) : fixed_text(value, 6);
  }
  return text;
}

void TextSink::begin_nx_block() {
  if (is_block_open_) line("END-OF-PATH");
  is_block_open_ = true;
  is_block_due_ = false;
  axis_.reset();
  const std::string operation = operation_.empty() ? "OPERATION" : operation_;
  const std::string name = !tool_                 ? "NONE"
                           : !tool_->name.empty() ? tool_->name
                           : tool_->number        ? "T" + std::to_string(*tool_->number)
                                                  : "TOOL";
  line("TOOL PATH/" + operation + ",TOOL," + name);
  if (tool_ && tool_->cutter) {
    const CutterStatement& c = *tool_->cutter;
    std::string text = "TLDATA/MILL";
    for (const double value : {scaled(c.d_mm), scaled(c.r_mm), scaled(c.h_mm), c.beta_deg, c.alpha_deg})
      text += "," + fixed_text(value, format_.decimals);
    line(text);
  }
  line("MSYS/0.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000,0.0000000,1.0000000,0.0000000");
  if (tool_ && tool_->number) line("LOAD/TOOL," + std::to_string(*tool_->number));
}

void TextSink::write_cutter(const PathTool& tool) {
  const CutterStatement& c = *tool.cutter;
  switch (options_.kind) {
    case DialectKind::catia:
      return line("CUTTER/ " + seven(c, ", "));
    case DialectKind::creo:
      return line("$$-> CUTTER / " + fixed_text(scaled(c.d_mm), 6));
    case DialectKind::clt:
      return line("CUTTER/ " + seven(c, ",") + ",");
    case DialectKind::nccs:
    case DialectKind::solidworks_cam:
      return line("CUTTER/" + seven(c, ","));
    case DialectKind::mori:
      return;
    default:
      return line("CUTTER/" + seven(c, ", "));
  }
}

void TextSink::write_number(const PathTool& tool) {
  const std::string number = std::to_string(*tool.number);
  switch (options_.kind) {
    case DialectKind::catia:
      line("TOOLNO/" + number + ",   " + fixed_text(tool.cutter ? scaled(tool.cutter->d_mm) : 0, 6));
      if (!tool.name.empty()) line("TPRINT/" + tool.name);
      return line("LOADTL/" + number);
    case DialectKind::creo:
      return line("LOADTL / " + number);
    case DialectKind::solidworks_cam:
      return line("LOAD/TOOL," + number);
    case DialectKind::mori:
      line("TOOLNO/ " + number + ", MILL");
      return line("LOAD/ TOOL, " + number);
    default:
      return line("LOADTL/" + number);
  }
}

void TextSink::change_tool(const PathTool& tool) {
  tool_ = tool;
  is_alone_ = true;
  if (options_.kind == DialectKind::goto_list) return;
  if (options_.kind == DialectKind::nx_clsf) {
    is_block_due_ = true;
    return;
  }
  if (options_.kind == DialectKind::solidworks_cam && !tool.name.empty()) line("INSERT/" + tool.name);
  if (tool.cutter) write_cutter(tool);
  const bool has_diameter_alone = !tool.cutter && tool.stated_diameter_mm > 0;
  if (has_diameter_alone && options_.kind == DialectKind::creo)
    line("$$-> CUTTER / " + fixed_text(scaled(tool.stated_diameter_mm), 6));
  if (tool.number) write_number(tool);
  const bool has_flutes =
      options_.kind == DialectKind::solidworks_cam || options_.kind == DialectKind::camplete;
  if (has_flutes && tool.flute_length_mm > 0)
    line("CSI_SET_FLUTE_LENGTH/" + format_.number(scaled(tool.flute_length_mm), 6));
}

}  // namespace gouge
