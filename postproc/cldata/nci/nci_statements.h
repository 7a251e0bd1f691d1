#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/nci/nci_motion.h"
#include "postproc/program/cutcom.h"

// The pairs of lines of a Mastercam NCI file as statements in words of APT. Lines, arcs and five-axis lines are motion.
// Drilling and tool planes become motion or frames that are not read. docs/formats/mastercam_nci.md.

namespace gouge {

class NciStatements final : public StatementSource {
 public:
  /// `bytes` must outlive the statements.
  NciStatements(std::string_view bytes, std::size_t first_byte, std::size_t line) : lines_(bytes, first_byte, line) {}

  /// Reads the next statement. A pair may give several, of which only the last one spans bytes. For a motion that is
  /// its GOTO. Its numbers are those of the pair, except the axis, which has no text.
  [[nodiscard]] bool next(Statement& statement) override;

 private:
  void take_pair();
  void take_motion();
  void take_compensation(std::optional<double> value);
  void take_speed(const NciMotion& motion);
  void take_plane();
  void take_tool();
  void add(Word word, std::string_view major);
  void add_circle(const NciMotion& motion);
  [[nodiscard]] std::vector<Argument>& decoded() { return queue_[queued_ - 1].decoded; }
  /// Returns the parameters of the pair; valid until the next call.
  [[nodiscard]] const std::vector<Argument>& read_fields();

  NciLines lines_;
  NciPair pair_;
  std::vector<Argument> fields_;
  std::array<Statement, 4> queue_;  // room for CUTCOM, RAPID or FEDRAT, CIRCLE, GOTO
  std::size_t queued_ = 0, given_ = 0;
  CutcomSide cutcom_ = CutcomSide::none;
  std::optional<std::string_view> wcs_;
  std::optional<double> diameter_;  // diameter of the next tool
};

[[nodiscard]] std::unique_ptr<StatementSource> open_nci(std::string_view bytes, std::size_t first_byte,
                                                        std::size_t line);

}  // namespace gouge
