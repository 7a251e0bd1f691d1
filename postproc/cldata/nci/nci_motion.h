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

// Content and place of a motion pair of a Mastercam NCI file. The reader makes statements from it, and the writer puts
// other numbers into its fields. Evidence for each field: docs/formats/mastercam_nci.md.

// Also the container of Mastercam NCI files: pairs of lines, each of which is a code alone and then its parameters,
// separated by blanks.

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

/// Reasons not to read a motion pair. They are reported as its word, which is cut after 24 letters.
struct NciProblems {
  static constexpr const char* kNumbers = "NCI motion, few numbers";
  static constexpr const char* kPlane = "NCI arc, plane or comp.";
  static constexpr const char* kFullCircle = "NCI arc, circle flag";
  static constexpr const char* kVector = "NCI 11, no tool axis";
  static constexpr const char* kFlags = "NCI 11, comp. in flags";
};

enum class NciForm : std::uint8_t { linear, arc, five_axis };
enum class NciPlane : std::uint8_t { xy, yz, xz };

/// A motion pair. Fields are counted from 0, and lengths are in the file's unit.
struct NciMotion {
  const char* problem = nullptr;       ///< one of NciProblems: then only `compensation` has a meaning
  std::optional<double> compensation;  ///< 0: no change; 40 and 140: off; nothing: the pair does not state it
  NciForm form = NciForm::linear;
  bool is_rapid = false;
  std::array<std::size_t, 3> tip{};  ///< indices of the fields with x, y and z of the end
  std::optional<std::size_t> comp;   ///< index of the field with the compensation; nothing if the pair has none
  std::size_t feed = 0, flags = 0;   ///< indices of fields; the flags may be missing
  Vec3 axis = Vec3::UnitZ();         ///< unit axis of a five-axis line
  double axis_length = 1;            ///< for five axes: distance of the second point from the tip
  Vec3 center = Vec3::Zero();        ///< of an arc; its coordinate along the arc's axis is that of the end
  NciPlane plane = NciPlane::xy;     ///< plane of an arc
  bool is_clockwise = false;         ///< for an arc
  bool is_full_circle = false;       ///< for an arc, if the pair states it
};

/// Indices of the fields with the second point of a five-axis line.
inline constexpr std::array<std::size_t, 3> kNciSecondPoint = {3, 4, 5};

/// Reads a motion pair. Requires is_nci_motion(code).
[[nodiscard]] NciMotion read_nci_motion(int code, std::span<const Argument> fields);

struct NciPair {
  std::size_t line = 0;  ///< line of the code
  std::size_t first_byte = 0, last_byte = 0;
  std::optional<int> code;      ///< nothing if the line is not a single integer
  std::string_view code_text;   ///< line of the code, trimmed
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

/// Splits a line of parameters into `fields`, whose memory is reused. Only blanks separate fields, so a field with a
/// comma is not a number. Stops at a hundred fields, of which only the first twenty are used.
void split_nci_fields(std::string_view parameters, std::vector<Argument>& fields);

/// Returns whether the first pairs of lines are codes and parameters, with a motion among them.
[[nodiscard]] bool is_nci(std::string_view bytes);

}  // namespace gouge
