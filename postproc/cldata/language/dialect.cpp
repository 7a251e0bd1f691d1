#include "postproc/cldata/language/dialect.h"

#include <algorithm>
#include <array>

#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::array<Dialect, 13> kDialects = {{
    {DialectKind::nx_clsf, "nx-clsf", "Siemens NX CLSF", true, false, true, false},
    {DialectKind::catia, "apt-catia", "CATIA V5 APT source", false, false, true, true},
    {DialectKind::creo, "apt-creo", "PTC Creo (Pro/CLfile) NCL", false, true, true, true},
    {DialectKind::solidworks_cam, "apt-solidworks-cam", "SolidWorks CAM / CAMWorks APT", false, true, true,
     true},
    {DialectKind::clt, "camworks-clt", "CAMWorks CLT", false, true, true, true},
    {DialectKind::autodesk, "apt-autodesk", "Autodesk ISO 4343 APT", false, true, false, true},
    {DialectKind::camplete, "apt-camplete", "CAMplete APT", false, true, true, true},
    {DialectKind::mori, "apt-mori", "DMG Mori APT", false, false, true, true},
    {DialectKind::nccs, "apt-nccs", "NCCS NCL CL data (ASCII)", false, false, false, true},
    {DialectKind::nccs_binary, "nccs-binary", "NCCS NCL CL data (binary)", false, false, false, true},
    {DialectKind::nci, "mastercam-nci", "Mastercam NCI", false, true, true, false},
    {DialectKind::goto_list, "goto-list", "bare GOTO lines", false, false, false, false},
    {DialectKind::apt, "apt", "APT CL data", false, false, false, false},
}};

}  // namespace

std::span<const Dialect> all_dialects() {
  return kDialects;
}

const Dialect& dialect_of(DialectKind kind) {
  const auto* const it =
      std::find_if(kDialects.begin(), kDialects.end(), [&](const Dialect& d) { return d.kind == kind; });
  return it == kDialects.end() ? kDialects.back() : *it;
}

std::optional<Dialect> dialect_called(std::string_view id) {
  constexpr std::string_view kApt = "apt-";
  for (const Dialect& dialect : kDialects) {
    const bool is_short =
        dialect.id.starts_with(kApt) && equals_ignoring_case(id, dialect.id.substr(kApt.size()));
    if (is_short || equals_ignoring_case(id, dialect.id)) return dialect;
  }
  return std::nullopt;
}

std::string dialect_names() {
  std::string names;
  for (const Dialect& dialect : kDialects) names += (names.empty() ? "" : ", ") + std::string(dialect.id);
  return names;
}

}  // namespace gouge
