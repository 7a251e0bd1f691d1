#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/geom/vec.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/language/text.h"

// Content and location of a motion pair of a Mastercam NCI file. The reader makes statements of it, and the writer puts
// other numbers into its fields. Evidence for each field: docs/formats/mastercam_nci.md.

// The container of Mastercam NCI files: pairs of lines, first a code alone, then its parameters separated by
// blanks.

namespace gouge {

struct NciCode {
  static constexpr int kRapid = 0, kLinear = 1, kClockwise = 2, kCounterClockwise = 3, kDwell = 4, kFiveAxis = 11;
  static constexpr int kCycleOff = 80, kToolFirst = 1000, kToolLast = 1002, kEnd = 1003, kCancelComp = 1004,
                       kEntryFirst = 1005, kEntrySecond = 1006, kEntryLast = 1007, kComment = 1008, kToolSize = 1013,
                       kToolPlane = 1014, kSubBegin = 1018, kSubEnd = 1019, kWcs = 1027;
};

[[nodiscard]] constexpr bool is_nci_motion(int code) {
  return (code >= NciCode::kRapid && code <= NciCode::kCounterClockwise) || code == NciCode::kFiveAxis;
}

/// Reason not to read a motion pair; reported as its word, which is cut after 24 letters.
struct NciProblems {
  static constexpr const char* kNumbers = "NCI motion, few numbers";
  static constexpr const char* kPlane = "NCI arc, plane or comp.";
  static constexpr const char* kFullCircle = "NCI arc, circle flag";
  static constexpr const char* kVector = "NCI 11, no tool axis";
  static constexpr const char* kFlags = "NCI 11, comp. in flags";
};

enum class NciForm : std::uint8_t { linear, arc, five_axis };
enum class NciPlane : std::uint8_t { xy, yz, xz };

/// Notation: fields are counted from 0; lengths are in the file's unit.
struct NciMotion {
  const char* problem = nullptr;       ///< one of NciProblems: then only `compensation` states anything
  std::optional<double> compensation;  ///< 0: no change; 40 and 140: off; nothing: not stated
  NciForm form = NciForm::linear;
  bool is_rapid = false;
  std::array<std::size_t, 3> tip{};  ///< fields of the end's x, y and z
  std::optional<std::size_t> comp;   ///< field; nothing where the pair has none
  std::size_t feed = 0, flags = 0;   ///< fields; that of the flags may be missing
  Vec3 axis = Vec3::UnitZ();         ///< of five axes: unit
  double axis_length = 1;            ///< of five axes: how far above the tip the second point is
  Vec3 center = Vec3::Zero();        ///< of arcs; along their axis it is where the end is
  NciPlane plane = NciPlane::xy;     ///< of arcs
  bool is_clockwise = false;         ///< of arcs
  bool is_full_circle = false;       ///< of arcs, where the pair states so
};

/// Fields of the second point of a five-axis line.
inline constexpr std::array<std::size_t, 3> kNciSecondPoint = {3, 4, 5};

/// Requires is_nci_motion(code).
[[nodiscard]] NciMotion read_nci_motion(int code, std::span<const Argument> fields);

struct NciPair {
  std::size_t line = 0;  ///< of the code
  std::size_t first_byte = 0, last_byte = 0;
  std::optional<int> code;      ///< nothing where the line is not one whole number
  std::string_view code_text;   ///< its line, trimmed
  std::string_view parameters;  ///< trimmed
  bool is_whole = false;        ///< the file does not end between code and parameters
};

class NciLines {
 public:
  NciLines(std::string_view bytes, std::size_t first_byte, std::size_t line)
      : bytes_(bytes), at_(first_byte), line_(line) {
    if (at_ == 0 && bytes_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  [[nodiscard]] bool next(NciPair& pair);

 private:
  [[nodiscard]] bool take_line(std::string_view& text);

  std::string_view bytes_;
  std::size_t at_;
  std::size_t line_;
};

/// The fields of a line of parameters into `fields` (whose memory is used again). Blanks alone separate them:
/// a comma makes a field no number. Stops at a hundred, of which none but the first twenty mean anything
/// here.
void split_nci_fields(std::string_view parameters, std::vector<Argument>& fields);

/// Returns true where the first pairs of lines are codes and parameters, with a motion among them.
[[nodiscard]] bool is_nci(std::string_view bytes);

}  // namespace gouge
