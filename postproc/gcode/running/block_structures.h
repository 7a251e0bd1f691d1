#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gouge {

/// A word of a program that begins, divides or ends a loop, a condition or a subprogram.
struct StructureWord {
  enum class Kind : std::uint8_t { begin, condition, otherwise, end };

  Kind kind = Kind::begin;
  std::string pair;  ///< equal for all words of one structure, such as "IF" for IF, ELSE and ENDIF
  std::string name;  ///< as messages state it
};

/// Tests whether loops and conditions of a program are complete and nested. A control refuses other programs. If one is
/// read nevertheless, a line is lost, and nothing is known about the order of the blocks.
class BlockStructures {
 public:
  /// Adds the next word of the program, with the number of its line.
  void add(std::size_t line, const StructureWord& word);

  /// Ends the program. A structure that is still open is a fault.
  void finish();
  /// Makes a fault of a text.
  void refuse(const std::string& fault) { fault_ = fault; }

  /// Returns whether the innermost structure that is open at this place has this pair.
  [[nodiscard]] bool is_innermost(const std::string& pair) const;

  /// Returns the first fault: "ENDIF in line 12 has no beginning". Empty: there is none.
  [[nodiscard]] const std::string& fault() const { return fault_; }

  /// Returns whether a jump between two lines enters a structure other than by its beginning, which controls refuse.
  [[nodiscard]] bool is_entered(std::size_t from_line, std::size_t to_line) const;

 private:
  struct Open {
    StructureWord word;
    std::size_t line = 0, otherwise_line = 0;  ///< 0: it has no ELSE yet
  };

  struct Closed {
    std::size_t first_line = 0, last_line = 0;
  };

  std::vector<Open> open_;
  std::vector<Closed> closed_;
  std::string fault_;
};

}  // namespace gouge
