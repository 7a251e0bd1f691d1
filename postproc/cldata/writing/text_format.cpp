#include "postproc/cldata/writing/text_format.h"

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr std::size_t kColumnsOfCoordinate = 6;  // beside the decimals: sign, four digits, point
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

}  // namespace

std::string TextFormat::number(double value, int count) const {
  std::string text = fixed_text(value, count);
  return drops_zeros && count > 0 ? without_zeros(std::move(text)) : text;
}

std::string TextFormat::point(const Vec3& value) const {
  std::string text;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i > 0) text += separator;
    const std::string token = number(value[i], decimals);
    text += is_aligned ? aligned(token, static_cast<std::size_t>(decimals) + kColumnsOfCoordinate) : token;
  }
  return text;
}

std::string TextFormat::direction(const Vec3& value) const {
  std::string text;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i > 0) text += separator;
    const std::string token = number(value[i], axis_decimals);
    text += is_aligned ? aligned(token, static_cast<std::size_t>(axis_decimals) + kColumnsOfAxis) : token;
  }
  return text;
}

TextFormat text_format(DialectKind kind) {
  switch (kind) {
    case DialectKind::nx_clsf:
      return {"GOTO/", ",", "RAPID", "\n", 4, 7, false, false, false, false};
    case DialectKind::catia:
      return {"GOTO  /", ",", "RAPID", "\r\n", 5, 6, true, false, false, true};
    case DialectKind::creo:
      return {"GOTO / ", ", ", "RAPID ", "\n", 10, 10, false, false, true, false};
    case DialectKind::solidworks_cam:
      return {"GOTO/", ",", "RAPID/", "\n", 6, 6, false, true, false, false};
    case DialectKind::clt:
      return {"GOTO/ ", ",", "RAPID/ ", "\n", 6, 6, false, false, false, false};
    case DialectKind::autodesk:
    case DialectKind::camplete:
      return {"GOTO/", ", ", "RAPID", "\r\n", 6, 9, false, false, false, true};
    case DialectKind::mori:
      return {"GOTO/ ", ", ", "RAPID", "\r\n", 6, 9, false, false, false, true};
    case DialectKind::nccs:
      return {"GOTO  /", ",", "RAPID ", "\n", 4, 7, true, false, false, true};
    case DialectKind::goto_list:
    case DialectKind::apt:
    case DialectKind::nccs_binary:
    case DialectKind::nci:
      break;
  }
  return {"GOTO/", ",", "RAPID", "\n", 6, 9, false, false, false, true};
}

}  // namespace gouge
