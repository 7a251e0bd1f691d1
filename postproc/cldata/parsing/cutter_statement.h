#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "lib/path/toolpath.h"
#include "postproc/cldata/language/arguments.h"

// The numbers of CUTTER/ and TLDATA/ as APT cutter parameters in mm.

namespace gouge {

/// A cutter; or why the numbers are wrong; or nothing. It is nothing where the numbers are not wrong but define no
/// cutter that CUTTER/ can express (diameter 0, an upper corner radius). The `note` states which.
struct CutterOutcome {
  std::optional<CutterStatement> cutter;
  double flute_length_mm = 0;
  std::string error;
  std::string note;
  bool is_recomputed = false;  ///< e and f differ from those the file has
};

/// Makes the cutter of CUTTER/d | d,r | d,r,e,f,alpha,beta,h. Where alpha = beta = 0, e and f follow from d and r,
/// because CAM systems disagree about what they write there. An e whose corner circle would reach beyond d/2
/// contradicts d and r. With `has_tip_diameter` (Dialect) that is so for other angles too, because e is then the
/// diameter of the tip. A corner radius beyond d/2 by rounding only is taken as d/2.
[[nodiscard]] CutterOutcome make_cutter(std::span<const Argument> arguments, double mm_per_unit,
                                        bool has_tip_diameter = false);

/// TLDATA/MILL,D,R,length,taper,tip[,x,y[,upper radius,x,y]] and TLDATA/DRILL[,MILL],D,R,length,point,flutes.
/// `arguments` without the first word; `is_drill` shows which form.
[[nodiscard]] CutterOutcome make_tldata_cutter(std::span<const Argument> arguments, bool is_drill, double mm_per_unit);

/// Returns true of the text that SolidWorks CAM writes before a CUTTER. It has a dimension with its unit, or a word for
/// a kind of tool. It has nothing of a macro outside of square brackets.
[[nodiscard]] bool is_tool_name(std::string_view text);

/// Returns true of the two other texts that SolidWorks CAM writes by itself: "Stock Size X95. Y95. Z10." and "STOP"
/// with a message for the operator.
[[nodiscard]] bool is_setup_text(std::string_view text);

}  // namespace gouge
