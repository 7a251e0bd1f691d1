#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/uncertainties.h"
#include "postproc/cldata/parsing/cutter_statement.h"

namespace gouge {

/// The tool of the positions that follow, as defined by CUTTER, TLDATA and similar words, and the number that is
/// loaded. It stays until the file names another one.
class ToolState {
 public:
  ToolState(StatementContext& in, Uncertainties& uncertainties) : in_(in), uncertainties_(uncertainties) {}

  void take_cutter(double mm_per_unit, bool is_behind_insert);
  /// Takes a comment of Creo that states only the diameter.
  void take_diameter(std::string_view text, double mm_per_unit);
  void take_tldata(double mm_per_unit);
  void take_flute_length(double mm_per_unit);
  void take_stickout(double mm_per_unit);
  /// Takes LENGTH,l, and ADJUST,n or OSETNO,n, of the loading of the present number.
  void take_length_words(double mm_per_unit);
  /// Takes the register of the length of the present tool. 0 and the number of the tool state nothing.
  void take_length_register(double number);
  void take_diameter_of_toolno(double mm_per_unit);
  void take_name(std::string_view text);
  /// Takes a name that stands beside the present number.
  void take_name_of_number(const std::string& name);
  /// Takes text that may be the name of the tool that is defined next.
  void take_insert(std::string_view text);
  /// Changes the number. Ensures  A tool that was not described since the last motion is the one last seen with this
  /// number. Else it is a tool about which the file states nothing, never the previous one.
  void change_number(int number);
  /// Notes that the tool with the present number is in the spindle: LOADTL, LOAD/TOOL.
  void note_load() { is_loaded_ = true, is_used_ = false; }
  /// Returns whether a number may only be prepared, or belong to another tool. This is so after the loading of another
  /// tool whose positions were read.
  [[nodiscard]] bool may_be_ready_only(int number) const { return is_loaded_ && tool_.number != number; }
  void begin_block(const std::string& name);
  /// Forgets the cutter, because it may be another one from here on.
  void forget_cutter();

  [[nodiscard]] const std::optional<int>& number() const { return tool_.number; }
  /// Returns the depth of the tip of a pointed tool at which its cone has the diameter `diameter_mm`; nothing for any
  /// other tool.
  [[nodiscard]] std::optional<double> countersink_depth(double diameter_mm) const;
  /// Resolves the tool at a motion. Returns whether it is another one than before. Then index() is that of the tool.
  [[nodiscard]] bool resolve();
  /// Returns the index in Toolpath::tools; kNone: no tool is named.
  [[nodiscard]] std::size_t index() const { return index_; }
  void write_note() const;

 private:
  struct Tool {
    std::optional<int> number;
    std::optional<CutterStatement> cutter;
    std::string name;
    double flute_length_mm = 0;
    double stickout_mm = 0;
    double loaded_length_mm = 0;
    std::optional<int> other_register;
    double diameter_mm = 0;         // from $$-> CUTTER of Creo, which states only the diameter
    double toolno_diameter_mm = 0;  // diameter after the number in TOOLNO; 0 if there is none
    std::size_t toolno_line = 0;
    std::size_t line = 0;
    bool is_fresh = false;  // defined since the last motion
  };
  struct Key {  // properties that identify a tool of the file
    std::optional<int> number;
    std::optional<std::array<double, 7>> cutter;
    double diameter_mm = 0;
    std::string name;
    auto operator<=>(const Key&) const = default;
  };
  /// The statements whose number is that of the tool with the present name.
  enum class NameUse : std::uint8_t {
    none,          ///< none: the name is that of a tool that has its number
    until_motion,  ///< the next one, up to the next motion
    in_block       ///< the next one of the block that is named so
  };
  void set_name(std::string name);
  void add_lengths(PathTool& tool) const;
  void set_cutter(const CutterOutcome& outcome);
  [[nodiscard]] bool is_cutter_unloaded() const;
  [[nodiscard]] std::size_t find_or_add();

  StatementContext& in_;
  Uncertainties& uncertainties_;
  Tool tool_;
  bool is_changed_ = false;  // since the last motion
  NameUse name_use_ = NameUse::none;
  bool is_loaded_ = false;  // a tool was loaded, or its block begun
  bool is_used_ = false;    // by a motion since then
  std::size_t index_ = kNone;
  std::map<Key, std::size_t> index_of_key_;
  std::map<std::pair<int, std::string>, std::size_t>
      index_of_number_;  // the last tool of number and name, or of any name
  std::string last_insert_;
  std::size_t cutters_without_tool_ = 0;
  Tally recomputed_;
};

}  // namespace gouge
