#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "lib/path/toolpath.h"
#include "postproc/cldata/language/arguments.h"

// Converts the numbers of CUTTER/ and TLDATA/ to APT cutter parameters in mm.

namespace gouge {

/// A cutter, an error, or neither. It is neither if the numbers are not wrong but define no cutter that CUTTER/ can
/// express (diameter 0, an upper corner radius). The `note` states the reason.
struct CutterOutcome {
  std::optional<CutterStatement> cutter;
  double flute_length_mm = 0;
  std::string error;
  std::string note;
  bool is_recomputed = false;  ///< e and f differ from those in the file
};

/// Makes the cutter of CUTTER/d | d,r | d,r,e,f,alpha,beta,h. If alpha = beta = 0, e and f follow from d and r, because
/// CAM systems disagree about their meaning. An e whose corner circle would reach beyond d/2 contradicts d and r. With
/// `has_tip_diameter` (Dialect) e and f follow for other angles too, because e is then the diameter of the tip. A
/// corner radius that is larger than d/2 only by rounding is taken as d/2.
[[nodiscard]] CutterOutcome make_cutter(std::span<const Argument> arguments, double mm_per_unit,
                                        bool has_tip_diameter = false);

/// Makes the cutter of TLDATA/MILL,D,R,length,taper,tip[,x,y[,upper radius,x,y]] or
/// TLDATA/DRILL[,MILL],D,R,length,point,flutes. `arguments` has no first word; `is_drill` states which form it is.
[[nodiscard]] CutterOutcome make_tldata_cutter(std::span<const Argument> arguments, bool is_drill, double mm_per_unit);

/// Returns whether a text is the tool name that SolidWorks CAM writes before a CUTTER. It has a dimension with its
/// unit, or a word for a kind of tool. Outside of square brackets it has no characters of a macro.
[[nodiscard]] bool is_tool_name(std::string_view text);

/// Returns whether a text is one of the two other texts that SolidWorks CAM writes itself. They are "Stock Size X95.
/// Y95. Z10.", and "STOP" with a message for the operator.
[[nodiscard]] bool is_setup_text(std::string_view text);

}  // namespace gouge
