#include "postproc/cldata/parsing/control_list.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

using enum ControlMeaning;

// The documents of the rows; docs/formats/machine_text.md lists them.
constexpr std::string_view kIso = "ISO 6983-1", kFanuc = "Fanuc 30i", kHaas = "Haas mill", kSiemens = "Siemens 840D",
                           kHeidenhain = "Heidenhain TNC", kOkuma = "Okuma OSP", kLinuxCnc = "LinuxCNC";

constexpr auto kCodes = std::to_array<ControlCode>({
    {'G', 0, 30, path, "", kIso},
    {'G', 40, 40, harmless, "PXUH", kIso},
    {'G', 50, 50, smooths, "PRQ", kFanuc},
    {'G', 50, 53, path, "PQ", kLinuxCnc},
    {'G', 51, 51, smooths, "QRP", kFanuc},
    {'G', 80, 80, harmless, "P", kFanuc},
    {'G', 90, 90, harmless, "", kIso},
    {'G', 120, 120, path, "DIKQLRP", kHaas},
    {'G', 130, 130, path, "DIKQLRP", kHaas},
    {'G', 131, 131, harmless, "", kFanuc},
    {'G', 150, 150, harmless, "", kFanuc},
    {'G', 150, 150, offset, "", kOkuma},
    {'G', 170, 190, plane, "", kIso},
    {'G', 200, 200, inch, "", kFanuc},
    {'G', 210, 210, mm, "", kFanuc},
    {'G', 250, 260, harmless, "PQR", kFanuc},
    {'G', 270, 310, moves, "PQRH", kFanuc},
    {'G', 320, 339, path, "QRK", kFanuc},
    {'G', 400, 400, ends_compensation, "", kIso},
    {'G', 401, 429, shifts, "PQR", kFanuc},
    {'G', 430, 449, length, "PQR", kFanuc},
    {'G', 490, 490, length, "", kFanuc},
    {'G', 500, 500, shifts_with_axes, "", kFanuc},
    {'G', 501, 501, harmless, "XYZABC", kFanuc},
    {'G', 510, 529, shifts, "PIJK", kFanuc},
    {'G', 530, 531, moves, "P", kFanuc},
    {'G', 540, 541, offset, "P", kFanuc},
    {'G', 542, 542, shifts, "P", kFanuc},
    {'G', 550, 599, offset, "P", kFanuc},
    {'G', 601, 603, harmless, "", kSiemens},
    {'G', 610, 620, harmless, "", kFanuc},
    {'G', 640, 640, blends, "PQ", kLinuxCnc},
    {'G', 660, 661, begins_cycle, "P", kFanuc},
    {'G', 670, 670, ends_cycle, "", kFanuc},
    {'G', 680, 689, shifts, "RPQIJK", kFanuc},
    {'G', 690, 690, ends_tilt, "", kFanuc},
    {'G', 691, 691, harmless, "", kFanuc},
    {'G', 700, 700, inch, "", kSiemens},
    {'G', 700, 700, shifts, "PQ", kFanuc},
    {'G', 710, 710, mm, "", kSiemens},
    {'G', 710, 710, shifts, "PQ", kFanuc},
    {'G', 730, 769, begins_cycle, "RPQKLEHD", kFanuc},
    {'G', 800, 800, ends_cycle, "", kIso},
    {'G', 810, 899, begins_cycle, "RPQKLEHD", kIso},
    {'G', 900, 900, ends_steps, "", kIso},
    {'G', 901, 901, centres_absolute, "", kLinuxCnc},
    {'G', 910, 910, begins_steps, "", kIso},
    {'G', 911, 911, centres_from_start, "", kLinuxCnc},
    {'G', 920, 929, shifts_with_axes, "PQR", kFanuc},
    {'G', 930, 950, harmless, "", kIso},
    {'G', 960, 970, harmless, "RP", kIso},
    {'G', 980, 990, level, "", kFanuc},
    {'G', 1130, 1130, harmless, "", kFanuc},
    {'G', 1130, 1130, offset, "", kHaas},
    {'G', 1530, 1530, moves, "", kSiemens},
    {'G', 1540, 1549, offset, "P", kHaas},
    {'G', 1870, 1870, smooths, "PE", kHaas},
    {'G', 2340, 2340, length, "", kHaas},
    {'G', 2550, 2550, ends_tilt, "", kHaas},
    {'G', 5000, 5000, offset, "", kSiemens},
    {'G', 5050, 5990, offset, "", kSiemens},
    {'G', 6010, 6030, harmless, "", kSiemens},
    {'G', 6410, 6450, smooths, "", kSiemens},
    {'G', 7000, 7000, inch, "", kSiemens},
    {'G', 7100, 7100, mm, "", kSiemens},
    {'M', 0, 10, harmless, "", kIso},
    {'M', 20, 20, ends_program, "", kIso},
    {'M', 30, 50, harmless, "R", kIso},
    {'M', 60, 60, changes_tool, "", kIso},
    {'M', 70, 90, harmless, "", kIso},
    {'M', 100, 110, harmless, "", kIso},
    {'M', 130, 140, harmless, "", kIso},
    {'M', 190, 190, harmless, "RPQ", kIso},
    {'M', 290, 290, harmless, "", kFanuc},
    {'M', 300, 300, ends_program, "", kIso},
    {'M', 310, 310, harmless, "", kHaas},
    {'M', 330, 350, harmless, "", kHaas},
    {'M', 400, 450, harmless, "", kIso},
    {'M', 480, 490, harmless, "", kIso},
    {'M', 830, 840, harmless, "", kHaas},
    {'M', 880, 880, harmless, "", kHaas},
    {'M', 890, 890, begins_cycle, "", kHeidenhain},
    {'M', 1070, 1080, harmless, "", kHeidenhain},
    {'M', 1260, 1280, harmless, "", kHeidenhain},
    {'M', 1290, 1290, shifts, "", kHeidenhain},
    {'M', 1360, 1370, harmless, "", kHeidenhain},
});

constexpr auto kWords = std::to_array<ControlWord>({
    {"BRISK", ControlForm::alone, kSiemens},
    {"CFC", ControlForm::alone, kSiemens},
    {"CFIN", ControlForm::alone, kSiemens},
    {"CFTCP", ControlForm::alone, kSiemens},
    {"COMPCAD", ControlForm::alone, kSiemens, smooths},
    {"COMPCURV", ControlForm::alone, kSiemens, smooths},
    {"COMPOF", ControlForm::alone, kSiemens},
    {"COMPON", ControlForm::alone, kSiemens, smooths},
    {"COMPSURF", ControlForm::alone, kSiemens, smooths},
    {"CYCLE832", ControlForm::values, kSiemens, smooths},
    {"FFWOF", ControlForm::alone, kSiemens},
    {"FFWON", ControlForm::alone, kSiemens},
    {"FGROUP", ControlForm::values, kSiemens},
    {"FIFOCTRL", ControlForm::alone, kSiemens},
    {"LIMS", ControlForm::values, kSiemens},
    {"MSG", ControlForm::message, kSiemens},
    {"ORIAXES", ControlForm::alone, kSiemens, turns_axes},
    {"ORIMKS", ControlForm::alone, kSiemens, turns_axes},
    {"ORIVECT", ControlForm::alone, kSiemens},
    {"ORIWKS", ControlForm::alone, kSiemens},
    {"SETMS", ControlForm::values, kSiemens},
    {"SOFT", ControlForm::alone, kSiemens},
    {"SPATH", ControlForm::alone, kSiemens},
    {"SPOS", ControlForm::values, kSiemens, stops_spindle},
    {"STARTFIFO", ControlForm::alone, kSiemens},
    {"STOP", ControlForm::addresses, kHeidenhain},
    {"STOPFIFO", ControlForm::alone, kSiemens},
    {"STOPRE", ControlForm::alone, kSiemens},
    {"TRAORI", ControlForm::values, kSiemens},
    {"UPATH", ControlForm::alone, kSiemens},
    {"WORKPIECE", ControlForm::values, kSiemens},
});

// Whole blocks: two words, then only those of `rest`, which may have numbers. Rows of cycles also state the number of
// the cycle.
constexpr auto kPhrases = std::to_array<ControlPhrase>({
    {"TOOL", "CALL", "S F", ControlPhrase::kNoNumber, harmless},
    {"TOOL", "DEF", "", ControlPhrase::kAnyNumber, harmless},
    {"LBL", "", "", ControlPhrase::kAnyNumber, harmless},
    {"BLK", "FORM", "X Y Z R RI L DIST CYLINDER", ControlPhrase::kAnyNumber, harmless},
    {"CYCL", "DEF", "TOLERANCE TOLERANZ T TA HSC MODE", 32, smooths},
    {"CYCL", "DEF", "DWELL TIME VERWEILZEIT V ZEIT", 9, harmless},
    {"CYCL", "DEF", "ORIENTATION ORIENTIERUNG ANGLE WINKEL", 13, harmless},
    {"CYCL", "DEF", "DATUM SETTING Q", 247, offset},
    {"FUNCTION", "TCPM", "F TCP CONT AXIS POS SPAT PATHCTRL VECTOR", ControlPhrase::kNoNumber, turns_axes},
});

}  // namespace

std::vector<const ControlCode*> find_control_code(char letter, double number) {
  std::vector<const ControlCode*> rows;
  constexpr double kWholeTenth = 1e-6;  // rounding of codes that are read from decimals
  const auto tenfold = static_cast<int>(std::lround(std::clamp(number, -1.0, 10000.0) * 10));
  const bool is_tenth = std::abs(number * 10 - tenfold) < kWholeTenth;
  for (const ControlCode& row : kCodes) {
    // A range of several numbers with little effect includes only integers: G1.5 is not one of G0 to G3.
    constexpr auto kLittle = std::to_array({harmless, smooths, plane, level, path, offset});
    const bool does_little = std::ranges::find(kLittle, row.meaning) != kLittle.end();
    const bool has_tenths = row.letter == 'G' && (!does_little || row.first / 10 == row.last / 10);
    const bool is_whole = tenfold % 10 == 0 || has_tenths;
    if (row.letter == letter && is_tenth && is_whole && tenfold >= row.first && tenfold <= row.last)
      rows.push_back(&row);
  }
  return rows;
}

const ControlWord* find_control_word(std::string_view word) {
  const auto* const row =
      std::ranges::find_if(kWords, [&](const ControlWord& known) { return equals_ignoring_case(known.word, word); });
  return row == kWords.end() ? nullptr : row;
}

std::span<const ControlPhrase> control_phrases() { return kPhrases; }

bool is_among_words(std::string_view word, std::string_view words) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (equals_ignoring_case(word, words.substr(0, end))) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

}  // namespace gouge
