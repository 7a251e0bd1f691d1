#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "postproc/gcode/language/gcode_block.h"

// A block of a Siemens program as its syntax gives it, before it has a meaning.

namespace gouge {

/// States how a word gives its value: X10, X=AC(10), X=IC(10), and for rotary axes B=DC(10), B=ACP(10), B=ACN(10).
enum class SiemensMeasure : std::uint8_t { modal, absolute, incremental, shortest, positive, negative };

/// An argument in brackets.
struct SiemensArgument {
  bool is_empty = true;
  double value = kUnknownValue;
  std::string text;  ///< of a string or of a name that is no variable; empty: it is a value
};

struct SiemensWord {
  enum class Form : std::uint8_t { alone, number, call };

  std::string name;  ///< in capitals; of G and M with the number: "G54"
  Form form = Form::alone;
  double value = kUnknownValue;  ///< of Form::number
  std::string text;              ///< of a string: T="MILL 8"; of L its digits, as their zeros count: L010
  SiemensMeasure measure = SiemensMeasure::modal;
  std::vector<SiemensArgument> arguments;  ///< of Form::call
  std::vector<std::string> variables;      ///< in its arguments: "R1"; "R": one that an index states
};

struct SiemensAssignment {
  std::string variable;
  double value = kUnknownValue;
};

struct SiemensBlock {
  std::vector<SiemensWord> words;
  std::vector<SiemensAssignment> assignments;
  bool is_skippable = false;   ///< begins with the mark for a block that may be skipped
  std::string flow_word;       ///< IF, GOTOF, DEF and such; empty: none
  std::string_view flow_rest;  ///< text behind it, without the comment
  std::string error;           ///< why the text is no block; empty: it is one

  void clear() {
    words.clear();
    assignments.clear();
    is_skippable = false;
    flow_word.clear();
    flow_rest = {};
    error.clear();
  }
  [[nodiscard]] bool is_empty() const {
    return words.empty() && assignments.empty() && flow_word.empty() && error.empty();
  }
};

}  // namespace gouge
