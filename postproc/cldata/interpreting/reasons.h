#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

// Reasons not to check moves, with the word and the line of their statement: "...: CAMERA in line 74".

namespace gouge {

/// Reasons not to check moves. The texts are shown to the user, some with the word and the line of a statement
/// (NamedReasons).
struct Reasons {
  static constexpr const char* kCurve = "a curve that is not understood";
  static constexpr const char* kMovnrb =
      "a NURBS (MOVNRB) and positions on it: which of both the control runs the file does not say";
  static constexpr const char* kSpline = "a NURBS whose knots, points or axis are not those of a cubic curve";
  static constexpr const char* kCycle = "a cycle whose words are not understood";
  static constexpr const char* kCountersink =
      "a countersink (CSINK) to a diameter that the cone of its tool does not reach, or whose tool is not known";
  static constexpr const char* kCutcom = "compensated by CUTCOM: the positions need not be the cutter centre";
  static constexpr const char* kAfterCutcom =
      "starts at a position compensated by CUTCOM, which need not be the cutter centre";
  static constexpr const char* kAdjust = "shifted by CUTCOM/ADJUST: the registers of the control are not known";
  static constexpr const char* kNccsArc =
      "an arc of NCL that leaves its plane or turns its tool axis: its post-processor may run it straight";
  static constexpr const char* kRetractPlane =
      "a drilling cycle rises to a retract plane whose height it does not state";
  static constexpr const char* kAfterCycle = "starts at an unknown retract height after a drilling cycle";
  static constexpr const char* kCycleOpen = "a hole, or a motion of its own, as its cycle is never ended";
  static constexpr const char* kCycleStrayEnd = "a hole, or a motion of its own, as a cycle ends that never began";
  static constexpr const char* kStrayOff =
      "compensated, shifted or splined perhaps: a statement ends it that nothing began";
  static constexpr const char* kNoToolPath =
      "positions are in no TOOL PATH: in which frame and with which tool the file does not say";
  static constexpr const char* kLateUnit =
      "positions before the first statement of the unit, which is another one than they were taken in";
  static constexpr const char* kMatrixRow =
      "positions follow a row of a matrix without its $$*CATIA0: in which frame the file does not say";
  static constexpr const char* kNoArcEnd =
      "a curve is described and no position says where it ends: the tool may have gone along it";
  static constexpr const char* kNoTlon = "an INDIRV that no TLON follows: a motion may be missing here";
  static constexpr const char* kBetweenBlocks =
      "positions stand between END-OF-PATH and TOOL PATH: in which frame and with which tool the file does not say";
  static constexpr const char* kLateFrame =
      "positions before the first statement of a frame, which is another one than they were taken in";
  static constexpr const char* kMsysOutside =
      "an MSYS stands between END-OF-PATH and this TOOL PATH, which has none: which frame holds the file does not say";
  static constexpr const char* kNoMsys =
      "positions are in a TOOL PATH without MSYS where others of the file have one: in which frame it does not say";
  static constexpr const char* kAfterEnd =
      "follows the end of the program: which unit, tool, tool axis and frame hold, the file does not say";
  static constexpr const char* kSkipped = "left out where the control's block skip is on";
  static constexpr const char* kAfterRetract = "starts at an unknown position after RETRCT";
  static constexpr const char* kAfterHomeOfAxes = "starts at an unknown position after GOHOME of single axes";
  static constexpr const char* kHomeOfAxes =
      "axes go home before Z does: how the tool passes the part the file does not say";
  static constexpr const char* kUnloadedCutter =
      "another cutter of the loaded tool, and no loading since: it may be that of the next tool";
  static constexpr const char* kReadyTool =
      "a tool number behind the loading of another tool: it may be loaded, or only made ready";
  static constexpr const char* kRetractPath =
      "the path up to the plane of CLEARP: whether RETRCT goes there, and at once, the file does not say";
  static constexpr const char* kHoleBounds =
      "a drilling cycle whose position may be the top of the hole or its bottom, and its clearance a height or a plane";
  static constexpr const char* kHigherHole =
      "a hole that lies higher than the tool is: whether it rises before it goes there, the file does not say";
  static constexpr const char* kTurning = "turning and wire tools are not understood";
  static constexpr const char* kContour = "positions are the contour, not the cutter centre (OUTPUT_ON_PROFILE)";
  static constexpr const char* kUnread = "a statement that is not understood may have moved the tool";
  static constexpr const char* kSixNumbers = "six numbers without MULTAX/ON: two positions, or one and its tool axis";
  static constexpr const char* kNineNumbers =
      "nine numbers: a position with its tool axis and a normal, or three positions";
  static constexpr const char* kStepFromUnread = "GODLTA goes on from a position that is not known";
  static constexpr const char* kNccsGoesOn =
      "a position on the circle of the one before it: round or straight, the file does not say";
  static constexpr const char* kPlainAxis =
      "a position without a tool axis after a tilted one: the file does not say which axis it has";
  static constexpr const char* kAfterUnread = "starts at an unknown position after a statement that is not understood";
  static constexpr const char* kAfterUnknown =
      "follows a statement that is not understood: it may move or change the tool, or shift what follows";
  static constexpr const char* kTipElsewhere =
      "a comment says that positions are another point of the tool than its tip";
  static constexpr const char* kUnreadFrame =
      "positions follow a statement that is not understood and may turn or shift them";
  static constexpr const char* kUnreadTool = "follows a statement that is not understood and may change the tool";
  static constexpr const char* kCutShort =
      "a position whose statement may be cut short: a tool axis or further positions may be missing";
  static constexpr const char* kWorkOffset =
      "positions follow another work offset, whose distance from the first one stands in the control alone";
  static constexpr const char* kMachineShift =
      "follows text for the machine's control that may shift, turn or offset positions";
  static constexpr const char* kMachineCycle =
      "follows text for the machine's control that makes each position a cycle";
  static constexpr const char* kMachineSteps =
      "follows text for the machine's control that makes positions steps (G91)";
  static constexpr const char* kMachineMotion =
      "follows text for the machine's control with a motion code (G0 to G3), with which it may run";
  static constexpr const char* kMachineMode =
      "follows text for the machine's control with a code of planes, arc centres or cycles, which may change its way";
  static constexpr const char* kSetup = "follows a setup or selection that may shift or turn positions";
  static constexpr const char* kSkewed =
      "positions are in a frame whose axes are scaled or not at right angles: where it puts them the file does not say";
  static constexpr const char* kTrans = "positions are shifted by a TRANS or ORIGIN that is not applied";
  static constexpr const char* kCsys = "positions are in a coordinate system (CSYS) that is not applied";
  static constexpr const char* kMcsys = "positions are in a coordinate system (MCSYS) that is not understood";
  static constexpr const char* kTurned = "positions are in a turned setup (ROTABL, ROTATE) that is not applied";
  static constexpr const char* kCltAxis =
      "positions are in a setup whose TLAXIS is not +Z of the model: where it lies the file does not say";
  static constexpr const char* kSetupAxis = "ROTABL and TLAXIS contradict each other about the setup of the positions";
  static constexpr const char* kOtherSetup =
      "positions are in another setup than those before: how the two lie to each other the file does not say";
  static constexpr const char* kMultax =
      "follows a MULTAX that is not understood: its numbers may be points or tool axes";
  static constexpr const char* kTrntyp = "positions are not in world coordinates (TRNTYP)";
};

/// Meaning of a reason for its motion, so that code does not compare texts.
enum class ReasonKind : std::uint8_t {
  none,           ///< the motion is checked
  compensated,    ///< the motion is understood, and only CUTCOM excludes it from the check
  after_retract,  ///< its start is unknown, because the tool retracted before it
  around_hole,    ///< it begins or ends at an unknown retract height
  not_understood,
  unread,        ///< the statement moves the tool to an unknown place
  may_be_unread  ///< a statement that is not understood and may not move the tool at all
};

/// Returns the kind of `reason`, which may include the word and the line of its statement.
[[nodiscard]] ReasonKind kind_of(std::string_view reason);

/// Returns whether a statement moves the tool to an unknown place.
[[nodiscard]] inline bool is_unread(std::string_view reason) { return kind_of(reason) >= ReasonKind::unread; }
/// Returns whether the program's own motion is understood: it is checked, or only CUTCOM excludes it from the check.
[[nodiscard]] inline bool is_motion_known(std::string_view reason) {
  return kind_of(reason) <= ReasonKind::compensated;
}

/// Returns the first word of a statement in the form for the user: in capitals, cut to 24 letters. Without a word it is
/// "(no word)" or "(line of numbers)".
[[nodiscard]] std::string word_as_reported(std::string_view major);

class NamedReasons {
 public:
  /// Maximum number of lines named for each pair of reason and word. Later texts name only the word. So a file that
  /// repeats a statement has no list of all its lines.
  static constexpr std::size_t kMaxLines = 20;

  /// Returns `reason` with the word and the line of its statement (0: the word alone). The text is never freed, as
  /// Move::not_checked_reason requires. Equal texts share one string.
  [[nodiscard]] const char* name(std::string_view reason, std::string_view major, std::size_t line = 0);

 private:
  std::map<std::pair<std::string, std::string>, std::size_t> lines_named_;
};

}  // namespace gouge
