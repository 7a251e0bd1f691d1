#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/uncertainties.h"
#include "postproc/cldata/parsing/cutter_statement.h"

namespace gouge {

/// The tool of the positions that follow, as CUTTER, TLDATA and their like define it, and the number that is loaded. It
/// stays until the file names another one.
class ToolState {
 public:
  ToolState(StatementContext& in, Uncertainties& uncertainties) : in_(in), uncertainties_(uncertainties) {}

  void take_cutter(double mm_per_unit, bool is_behind_insert);
  /// Creo's comment, which states the diameter alone.
  void take_diameter(std::string_view text, double mm_per_unit);
  void take_tldata(double mm_per_unit);
  void take_flute_length(double mm_per_unit);
  void take_diameter_of_toolno(double mm_per_unit);
  void take_name(std::string_view text);
  /// Text that may name the tool that is defined next.
  void take_insert(std::string_view text);
  /// Ensures  A tool that was not described since the last motion is the one last seen under that number. Else it is
  ///          one that the file states nothing about, never the one before it.
  void change_number(int number);
  /// The tool of that number is in the spindle: LOADTL, LOAD/TOOL.
  void note_load() { is_loaded_ = true, is_used_ = false; }
  /// A number that is only made ready, or is that of another tool: behind the loading of one, while which positions
  /// were read.
  [[nodiscard]] bool may_be_ready_only(int number) const { return is_loaded_ && tool_.number != number; }
  void begin_block(const std::string& name);
  /// It may be another cutter from here on.
  void forget_cutter();

  [[nodiscard]] const std::optional<int>& number() const { return tool_.number; }
  /// Returns how deep the tip of a pointed tool is where its cone is `diameter_mm` wide; nothing of any other tool.
  [[nodiscard]] std::optional<double> countersink_depth(double diameter_mm) const;
  /// Resolves the tool at a motion. Returns true where it is another one than before. index() is then its own.
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
    double diameter_mm = 0;         // of Creo, whose $$-> CUTTER states nothing else
    double toolno_diameter_mm = 0;  // behind the number of TOOLNO; 0 where none stands there
    std::size_t toolno_line = 0;
    std::size_t line = 0;
    bool is_fresh = false;  // defined since the last motion
  };
  struct Key {  // properties that make two tools of the file the same
    std::optional<int> number;
    std::optional<std::array<double, 7>> cutter;
    double diameter_mm = 0;
    std::string name;
    auto operator<=>(const Key&) const = default;
  };
  void set_cutter(const CutterOutcome& outcome);
  [[nodiscard]] bool is_cutter_unloaded() const;
  [[nodiscard]] std::size_t find_or_add();

  StatementContext& in_;
  Uncertainties& uncertainties_;
  Tool tool_;
  bool is_changed_ = false;  // since the last motion
  bool is_loaded_ = false;   // a tool was loaded, or its block begun
  bool is_used_ = false;     // by a motion since then
  std::size_t index_ = kNone;
  std::map<Key, std::size_t> index_of_key_;
  std::map<int, std::size_t> index_of_number_;  // the last one seen under a number
  std::string last_insert_;
  std::size_t cutters_without_tool_ = 0;
  Tally recomputed_;
};

}  // namespace gouge
