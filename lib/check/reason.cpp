#include "lib/check/reason.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

struct Text {
  Reason::Kind kind;
  std::string_view text;
};

// Texts with placeholders. {body} and {detail} are members of the reason. {count} is the amount as a whole number, {mm}
// the amount as a length. {reach} is the length of thin_feature. {whole} is the body; for the cutter it is the whole
// tool. {in head} is "in the head" for a head, else "there".
constexpr std::array kTexts{
    Text{Reason::Kind::of_path, "{detail}"},
    Text{Reason::Kind::rapid_skipped, "rapid moves are skipped as asked"},
    Text{Reason::Kind::rapid_unsure,
         "whether RAPID is for further positions of its statement is not known, and rapids run differently from feeds"},
    Text{Reason::Kind::no_tool, "no tool is defined before this move"},
    Text{Reason::Kind::tool_undefined, "the tool has no definition"},
    Text{Reason::Kind::no_start, "the path does not hold the position this move starts at"},
    Text{Reason::Kind::no_curve, "the path does not hold the curve of this move"},
    Text{Reason::Kind::axis_reversed, "the axis turns by 180 degrees: its path is not defined"},
    Text{Reason::Kind::link_gouges,
         "how the tool gets here from line {count} the file does not say, and straight it would gouge: a retract or a "
         "tool change is missing"},
    Text{Reason::Kind::out_of_reach,
         "the motion, the tool or a mesh reaches more than 100 m from the origin: check the units"},
    Text{Reason::Kind::axis_not_unit, "the tool axis is no unit vector"},
    Text{Reason::Kind::options_invalid, "an option of the check is no finite length, or the resolution is not above 0"},
    Text{Reason::Kind::buried, "the {whole} is inside the solid; no surface is inside the {whole}"},
    Text{Reason::Kind::side_unknown, "whether the {body} is inside the solid cannot be determined: {detail}"},
    Text{Reason::Kind::body_too_thin,
         "the tolerance lets the surface reach the middle of the {body}, so the tool may be buried; give a smaller "
         "tolerance"},
    Text{Reason::Kind::head_too_thin,
         "the tolerance is as large as the head is thick: it may be buried; give a smaller tolerance"},
    Text{Reason::Kind::thin_feature,
         "a thin or pointed feature of the tool may reach into the solid by {reach}, although nothing comes deeper "
         "into the tool than the tolerance; give a smaller tolerance"},
    Text{Reason::Kind::out_of_budget,
         "the budget of {count} bounds ran out before the depth was known to the resolution"},
    Text{Reason::Kind::head_out_of_budget,
         "the head comes too close to the surface for too long: the budget of bounds ran out"},
    Text{Reason::Kind::turn_undecided,
         "it is not proved for all positions of the rotary joints between the ends of the move"},
    Text{Reason::Kind::stock_unknown,
         "whether stock is still {in head} is not known: the motion of {detail} is not known"},
    Text{Reason::Kind::stock_touched,
         "whether stock is still {in head} is not known: a tool touched it before without cutting it for certain"},
    Text{Reason::Kind::stock_motion_open, "it is not checked against the stock: its motion, or its tool, is not known"},
    Text{Reason::Kind::stock_met_too, "the {body} is in remaining stock too: {detail}"},
    Text{Reason::Kind::stock_open_too, "it may be in remaining stock too: {detail}"},
    Text{Reason::Kind::clearance_entered, "the clearance of the {body} is entered by {mm} mm"},
    Text{Reason::Kind::mesh_clearance_entered, "the {body} enters the clearance of this mesh by {mm} mm"},
    Text{Reason::Kind::mesh_tolerance_exceeded, "the {body} is {mm} mm deep, beyond the tolerance of this mesh"},
    Text{Reason::Kind::stock_met, "{detail}"},
};

// Returns a length with two digits, rounded up.
std::string reach_text(double reach_mm) {
  if (!std::isfinite(reach_mm)) return "any amount";
  const double unit = std::pow(10.0, std::floor(std::log10(reach_mm)) - 1);
  const double steps = std::ceil(reach_mm / unit);
  return "up to " + exact_text(unit < 1 ? steps / std::round(1 / unit) : steps * unit) + " mm";
}

std::string value_of(std::string_view name, const Reason& reason) {
  if (name == "detail") return std::string(reason.detail());
  if (name == "count") return std::to_string(static_cast<std::uint64_t>(reason.amount()));
  if (name == "mm") return exact_text(reason.amount());
  if (name == "reach") return reach_text(reason.amount());
  if (name == "in head") return reason.body == Body::head ? "in the head" : "there";
  // For the cutter the word "tool" stays, because reports have always used it.
  return name == "whole" && reason.body == Body::cutter ? "tool" : body_name(reason.body);
}

std::string filled(std::string_view text, const Reason& reason) {
  std::string out;
  for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{')) {
    const std::size_t close = text.find('}', open);
    out += std::string(text.substr(0, open)) + value_of(text.substr(open + 1, close - open - 1), reason);
    text.remove_prefix(close + 1);
  }
  return out + std::string(text);
}

// Returns whether a text consists of the words of `form`, with any text in place of each placeholder.
bool has_form(std::string_view text, std::string_view form) {
  const std::size_t open = form.find('{');
  if (!text.starts_with(form.substr(0, open))) return false;
  text.remove_prefix(std::min(open, form.size()));
  while ((form = form.substr(std::min(form.find('}'), form.size() - 1) + 1)).find('{') != std::string_view::npos) {
    const std::string_view words = form.substr(0, form.find('{'));
    const std::size_t at = text.find(words);
    if (at == std::string_view::npos) return false;
    text.remove_prefix(at + words.size());
  }
  return text.ends_with(form);
}

}  // namespace

bool is_text_of_stock_too(std::string_view text) {
  for (const Body body : {Body::cutter, Body::shank, Body::holder, Body::head}) {
    if (text.starts_with(reason_text({Reason::Kind::stock_met_too, body}))) return true;
  }
  return text.starts_with(reason_text({Reason::Kind::stock_open_too}));
}

// The sentence about stock may end with that of a limit.
bool is_text_of_limit(std::string_view text) {
  return !is_text_of_stock_too(text) && std::ranges::any_of(kTexts, [&](const Text& one) {
    const bool has_words = one.kind != Reason::Kind::stock_met;
    return Reason{one.kind}.names_limit() && has_words && has_form(text, one.text);
  });
}

std::string reason_text(const Reason& reason) {
  for (const Text& one : kTexts) {
    if (one.kind == reason.kind) return filled(one.text, reason);
  }
  return {};
}

}  // namespace gouge
