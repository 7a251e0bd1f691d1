#include "postproc/gcode/siemens/siemens_words.h"

#include <algorithm>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

using Form = SiemensWord::Form;

// Addresses whose values a code or a mode takes.
constexpr CapitalSet kLetters("XYZABCIJKFDTPL");
constexpr auto kLongAddresses = std::to_array<std::string_view>(
    {"A3", "B3", "C3", "I1", "J1", "K1", "CR", "TURN", "AR", "ADIS", "ADISPOS", "CTOL", "OTOL", "RPL"});

bool is_address(std::string_view name) {
  if (name.size() == 1) return kLetters.has(name[0]);
  return std::ranges::find(kLongAddresses, name) != kLongAddresses.end();
}

// G54, M30; not GOHOME, which may be a program.
bool is_code_name(std::string_view name) {
  return (name[0] == 'G' || name[0] == 'M') && (name.size() == 1 || is_digit(name[1]));
}

bool is_of_fixed_point(std::string_view name) {
  return name.size() == 2 && std::string_view("XYZABC").find(name[0]) != std::string_view::npos && name[1] == '1';
}

std::string text_of(const SiemensWord& word) {
  const bool has_number = word.form == Form::number && is_known(word.value);
  return word.name + (has_number ? "=" + exact_text(word.value) : "");
}

bool is_spindle_code(const SiemensWord& word) {
  constexpr auto kSpindleCodes = std::to_array<double>({3, 4, 5, 19});
  return std::ranges::any_of(kSpindleCodes, [&](double code) { return std::abs(word.value - code) <= 0; });
}

}  // namespace

const SiemensWord* SiemensWords::find_long_value(std::string_view address) const {
  for (const SiemensWord* word : long_values_)
    if (word->name == address) return word;
  return nullptr;
}

bool SiemensWords::has_axes() const {
  constexpr CapitalSet kAxes("XYZABC");
  return letters_.has_any(kAxes) || (!long_values_.empty() && has_any({"A3", "B3", "C3"}));
}

bool SiemensWords::has_arc_words() const {
  constexpr CapitalSet kCentre("IJK");
  return letters_.has_any(kCentre) || (!long_values_.empty() && has_any({"I1", "J1", "K1", "CR", "AR", "TURN"}));
}

bool SiemensWords::has_any(std::initializer_list<std::string_view> addresses) const {
  return std::ranges::any_of(addresses, [&](std::string_view address) { return value(address) != nullptr; });
}

const SiemensWords::Code* SiemensWords::code(SiemensMeaning meaning) const {
  for (const Code& one : codes_)
    if (one.row->meaning == meaning) return &one;
  return nullptr;
}

const SiemensWords::Code* SiemensWords::code_of(SiemensGroup group) const {
  for (const Code& one : codes_)
    if (one.row->group == group) return &one;
  return nullptr;
}

std::string SiemensWords::take_code(const SiemensWord& word, const SiemensRow& row) {
  if (word.form == Form::call && !row.takes_arguments)
    return word.name + " has arguments, which the word does not take";
  for (const Code& other : codes_) {
    if (other.word->name == word.name) return word.name + " occurs twice in the block";
    if (row.group != SiemensGroup::none && other.row->group == row.group)
      return other.word->name + " and " + word.name + " exclude each other in a block";
  }
  codes_.push_back({&row, &word});
  return {};
}

std::string SiemensWords::take_value(const SiemensWord& word) {
  if (value(word.name) != nullptr) return word.name + " occurs twice in the block";
  if (!word.text.empty() && word.name != "T" && word.name != "L") return word.name + " has a text in place of a number";
  if (word.name == "M1" && !is_spindle_code(word)) return text_of(word) + " is no code of a spindle";
  const bool is_known_address = is_address(word.name) || is_harmless_value(word.name) ||
                                (is_of_fixed_point(word.name) && code(SiemensMeaning::leave_to_fixed_point) != nullptr);
  if (!is_known_address) return text_of(word) + " is not in the table of Siemens 840D";
  if (!is_letter(word.name)) {
    long_values_.push_back(&word);
    return {};
  }
  letters_.add(word.name[0]);
  by_letter_.at(index_of(word.name[0])) = &word;
  return {};
}

std::string SiemensWords::take(const SiemensBlock& block, const std::vector<std::string>& harmless) {
  codes_.clear();
  letters_ = {};
  long_values_.clear();
  called_.clear();
  const auto is_stated_harmless = [&](const SiemensWord& word) {
    return std::ranges::any_of(harmless, [&](const std::string& name) { return in_capitals(name) == word.name; });
  };
  for (const SiemensWord& word : block.words) {
    std::string wrong;
    const SiemensRow* const row = word.form == Form::number ? nullptr : find_siemens_row(word.name);
    if (row != nullptr)
      wrong = take_code(word, *row);
    else if (word.form == Form::number)
      wrong = take_value(word);
    else if (is_stated_harmless(word))
      continue;
    else if (called_.empty() && !is_code_name(word.name) && word.arguments.empty())
      called_ = word.name;
    else
      wrong = word.name + " is not in the table of Siemens 840D";
    if (!wrong.empty()) return wrong;
  }
  if (const SiemensWord* const program = value("L"); program != nullptr) {
    if (!called_.empty() || !is_known(program->value)) return "L does not name a program that is called alone";
    called_ = "L" + (program->text.empty() ? exact_text(program->value) : program->text);
  }
  return find_conflict();
}

std::string SiemensWords::find_conflict() const {
  const bool is_call_alone = called_.empty() || (codes_.empty() && !has_axes() && !has_arc_words());
  if (!is_call_alone) return called_ + " is not in the table of Siemens 840D";
  if (value("P") != nullptr && called_.empty()) return "P belongs to no call of a program";
  const Code* const frame = code_of(SiemensGroup::frame);
  const bool is_frame_with_axes = frame != nullptr && !frame->row->takes_arguments;
  if (value("RPL") != nullptr && code(SiemensMeaning::rotate) == nullptr) return "RPL belongs to no frame";
  const bool has_other_axes = has_any({"A", "B", "C", "A3", "B3", "C3"}) || has_arc_words();
  if (is_frame_with_axes && (codes_.size() > 1 || has_other_axes || has_any({"D", "T", "F"})))
    return frame->word->name + " stands in a block with other words";
  for (const Code& one : codes_) {
    if (!one.row->is_alone || &one == frame) continue;
    if (has_axes() || has_arc_words()) return one.word->name + " stands in a block with axis words";
  }
  if (frame != nullptr && !is_frame_with_axes && (has_axes() || has_arc_words()))
    return frame->word->name + " stands in a block with axis words";
  return {};
}

}  // namespace gouge
