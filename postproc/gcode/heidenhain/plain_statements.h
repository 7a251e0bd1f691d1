#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gouge {

class QParameters;

/// Reads a statement that neither moves nor changes anything: BLK FORM, and FN 14, 15, 16, 20 and 38. `text`: in capitals.
/// Returns why it is not understood; an empty text: it is. None: it is another statement.
/// Source   iTNC 530 60642x-04: BLK FORM, FN 14 to FN 16 and FN 20; TNC 640, 34059x-05: BLK FORM CYLINDER and ROTATION.
[[nodiscard]] std::optional<std::string> read_plain_statement(std::string_view text, const QParameters& parameters);

/// Returns whether a text is what FN 18 reads: ID210 NR4 IDX3.
[[nodiscard]] bool is_value_of_control(std::string_view text, const QParameters& parameters);

/// Returns whether a text is two values around a word: +Q1 LEN +Q2.
[[nodiscard]] bool is_pair_of_operands(std::string_view text, std::string_view word, const QParameters& parameters);

}  // namespace gouge
