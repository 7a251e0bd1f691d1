#pragma once

#include <cstddef>
#include <string_view>

#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/nccs/nccs_records.h"

// The records of a binary NCCS file as statements. Each is expressed in words of APT, with the arguments of an ASCII
// file of the same program. So one interpreter reads both. Lines are record numbers, counted from 1. A record that is
// not decoded but may be important for motion becomes a statement of that fact.

namespace gouge {

class NccsStatements final : public StatementSource {
 public:
  /// `bytes` must outlive the statements.
  explicit NccsStatements(std::string_view bytes) : words_(bytes) {}

  /// Reads the next record. Returns false after FINI or at the end. A record that is longer than the rest of the file
  /// becomes an unterminated statement.
  [[nodiscard]] bool next(Statement& statement) override;

 private:
  void take_record(const NccsHeader& header, Statement& statement);
  void take_post(const NccsHeader& header, Statement& statement);
  void take_motion(const NccsHeader& header, Statement& statement);
  void take_expanded(const NccsHeader& header, Statement& statement);
  void take_circle(const NccsHeader& header, Statement& statement);
  void take_cutter(const NccsHeader& header, Statement& statement);
  [[nodiscard]] Argument number_at(std::size_t index) const;
  [[nodiscard]] Argument argument_at(std::size_t index) const;
  [[nodiscard]] std::string_view text_of(const NccsHeader& header) const;

  NccsWords words_;
  std::size_t word_ = 0;  // the first word of the record
  std::size_t record_ = 0;
  bool is_over_ = false;
  bool is_multax_off_ = false;
};

/// Opens the statements, always from the first record on.
[[nodiscard]] std::unique_ptr<StatementSource> open_nccs(std::string_view bytes, std::size_t first_byte,
                                                         std::size_t line);

}  // namespace gouge
