#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/cldata/parsing/tool_name.h"
#include "postproc/cldata/writing/text_sink.h"

// The tools of a written file: CUTTER, TLDATA and the words for their numbers in each dialect.

namespace gouge {
namespace {

bool is_straight(const CutterStatement& cutter) {
  return !(std::abs(cutter.alpha_deg) > 0) && !(std::abs(cutter.beta_deg) > 0);
}

// Other text than the name of a tool would be text for the control.
std::string certain_name(const std::string& name, const std::string& size) {
  if (is_tool_name(name)) return name;
  return is_tool_name(name + " " + size) ? name + " " + size : size;
}

}  // namespace

std::string TextSink::seven(const CutterStatement& c) const {
  double e = scaled(c.e_mm), f = scaled(c.f_mm);
  // Some posts write the tip's diameter for e, others no e and f; both are recomputed when read.
  if (options_.dialect.has_tip_diameter && is_straight(c)) e = scaled(c.d_mm - 2 * c.r_mm);
  if (format_.has_no_corner && is_straight(c)) e = f = 0;
  std::string text;
  for (const double value : {scaled(c.d_mm), scaled(c.r_mm), e, f, c.alpha_deg, c.beta_deg, scaled(c.h_mm)}) {
    if (!text.empty()) text += format_.cutter_separator;
    text += format_.number_text(value, 6);
  }
  return text;
}

void TextSink::begin_block() {
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

void TextSink::write_tool(const PathTool& tool) {
  const bool is_diameter_stated =
      options_.dialect.cutter_form == CutterForm::diameter_alone && tool.stated_diameter_mm > 0;
  const double diameter_mm = tool.cutter ? tool.cutter->d_mm : is_diameter_stated ? tool.stated_diameter_mm : 0;
  const std::string d = fixed_text(scaled(diameter_mm), 6);
  const char* const unit = options_.unit == LengthUnit::mm ? "MM" : "IN";
  if (!tool.name.empty() && (tool.cutter || !options_.dialect.inserts_are_names))
    fill(format_.tool_name, {{"name", tool.name}, {"certain_name", certain_name(tool.name, d + unit)}});
  if (tool.cutter || is_diameter_stated)
    fill(format_.cutter, {{"seven", tool.cutter ? seven(*tool.cutter) : ""}, {"d", d}});
  if (tool.number) {
    fill(format_.number, {{"number", std::to_string(*tool.number)},
                          {"d", d},
                          {"tprint", tool.name.empty() ? "" : "TPRINT/" + tool.name}});
  }
  if (tool.flute_length_mm > 0)
    fill(format_.flutes, {{"flutes", format_.number_text(scaled(tool.flute_length_mm), 6)}});
}

void TextSink::change_tool(const PathTool& tool) {
  tool_ = tool;
  is_alone_ = true;
  if (options_.dialect.has_positions_alone) return;
  is_block_due_ = options_.dialect.has_blocks;
  if (!is_block_due_) write_tool(tool);
}

}  // namespace gouge
