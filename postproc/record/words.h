#pragma once

#include <string>
#include <vector>

// The possible words of fields of a result, in the order of their enumerations.

namespace gouge {

using Words = std::vector<std::string>;

[[nodiscard]] const Words& state_words();     ///< MoveState
[[nodiscard]] const Words& body_words();      ///< Body
[[nodiscard]] const Words& against_words();   ///< Against
[[nodiscard]] const Words& kind_words();      ///< MoveKind
[[nodiscard]] const Words& subject_words();   ///< Subject
[[nodiscard]] const Words& basis_words();     ///< Basis
[[nodiscard]] const Words& severity_words();  ///< Severity
[[nodiscard]] const Words& uncut_words();     ///< Uncut::Kind
[[nodiscard]] const Words& rapid_words();     ///< RapidMode
[[nodiscard]] const Words& verdict_words();   ///< of the whole result
[[nodiscard]] const Words& role_words();      ///< of inputs
[[nodiscard]] const Words& use_words();       ///< of acceptances: BaselineEntry::Use
[[nodiscard]] const Words& written_words();   ///< of statements of a corrected file

}  // namespace gouge
