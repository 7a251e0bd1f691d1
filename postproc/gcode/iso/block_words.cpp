#include "postproc/gcode/iso/block_words.h"

#include <algorithm>
#include <cmath>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kSameCode = 1e-6;  // of a number times ten

std::optional<CodeNumber> code_number(double value) {
  const double tenfold = value * 10;
  if (!(tenfold >= 0) || tenfold > 1e6 || std::abs(tenfold - std::round(tenfold)) > kSameCode) return std::nullopt;
  return static_cast<CodeNumber>(std::lround(tenfold));
}

constexpr bool is_axis_letter(char letter) {
  return (letter >= 'X' && letter <= 'Z') || (letter >= 'A' && letter <= 'C');
}

std::string word_text(const GcodeWord& word) {
  return std::string(1, word.letter) + (is_known(word.value) ? exact_text(word.value) : "");
}

std::uint32_t bits_of(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char letter : letters)
    if (letter >= 'A' && letter <= 'Z') bits |= 1U << static_cast<unsigned>(letter - 'A');
  return bits;
}

std::string_view words_of(const ControlTable& control, const GcodeRow& row) {
  if (row.meaning != GcodeMeaning::cycle) return row.words;
  const GcodeCycle* const cycle = find_cycle(control, row.number);
  return cycle == nullptr ? row.words : cycle->words;
}

}  // namespace

std::string code_text(char letter, CodeNumber number) { return letter + exact_text(number / 10.0); }

CodeIndex::CodeIndex(const ControlTable& control, const std::vector<std::string>& harmless_words)
    : control_(control), g_(kG, nullptr), m_(kM, nullptr) {
  for (const GcodeRow& row : control.rows) {
    if (row.meaning == GcodeMeaning::tip_control_on) tip_control_group_ = row.group;
    (row.letter == 'G' ? g_ : m_).at(static_cast<std::size_t>(row.number)) = &row;
  }
  for (const std::string& word : harmless_words) {
    const char letter = word.empty() ? '\0' : capital(word[0]);
    if (letter != 'G' && letter != 'M') continue;
    const auto value = parse_number(std::string_view(word).substr(1));
    const auto number = value ? code_number(*value) : std::nullopt;
    if (!number || harmless_row(letter, *number) != nullptr) continue;
    // Axis words beside it would be a motion of an unknown kind.
    harmless_.push_back({.letter = letter, .number = *number, .meaning = GcodeMeaning::harmless, .takes_axes = false});
  }
}

const GcodeRow* CodeIndex::harmless_row(char letter, CodeNumber number) const {
  const auto is_it = [&](const GcodeRow& row) { return row.letter == letter && row.number == number; };
  const auto row = std::ranges::find_if(harmless_, is_it);
  return row == harmless_.end() ? nullptr : &*row;
}

const GcodeRow* CodeIndex::row(const GcodeWord& word) const {
  const auto number = code_number(word.value);
  if (!number) return nullptr;
  const std::vector<const GcodeRow*>& rows = word.letter == 'G' ? g_ : m_;
  const auto at = static_cast<std::size_t>(*number);
  if (at < rows.size() && rows[at] != nullptr) return rows[at];
  return harmless_row(word.letter, *number);
}

std::string BlockWords::take_codes(const GcodeBlock& block, const CodeIndex& index) {
  const GcodeRow* alone = nullptr;
  for (const GcodeWord& word : block.words) {
    if (word.letter != 'G' && word.letter != 'M') {
      if (has(word.letter)) return "the word " + std::string(1, word.letter) + " occurs twice in the block";
      words_[bit(word.letter)] = &word;
      present_ |= 1U << bit(word.letter);
      continue;
    }
    const GcodeRow* const row = index.row(word);
    if (row == nullptr)
      return word_text(word) + " is not in the table of control " + std::string(index.control().title);
    if (std::ranges::find(rows_, row) != rows_.end()) return word_text(word) + " occurs twice in the block";
    rows_.push_back(row);
    if (row->group == ModalGroup::none) {
      if (row->letter != 'G') continue;
      // Of several codes of group 00 one control takes the last, and another one none.
      if (alone != nullptr)
        return code_text(alone->letter, alone->number) + " and " + word_text(word) + " exclude each other in a block";
      alone = row;
      continue;
    }
    const GcodeRow*& of_group = groups_[static_cast<std::size_t>(row->group)];
    if (of_group != nullptr)
      return code_text(of_group->letter, of_group->number) + " and " + word_text(word) +
             " exclude each other in a block";
    of_group = row;
  }
  const GcodeRow *const end = row_of(ModalGroup::cycle_end), *const motion = row_of(ModalGroup::motion);
  if (end != nullptr && motion != nullptr && motion->meaning == GcodeMeaning::cycle)
    return code_text(end->letter, end->number) + " and " + code_text(motion->letter, motion->number) +
           " exclude each other in a block";
  return {};
}

std::string BlockWords::take(const GcodeBlock& block, const CodeIndex& index, const GcodeRow* modal) {
  words_ = {};
  groups_ = {};
  present_ = axes_ = 0;
  rows_.clear();
  std::string wrong = take_codes(block, index);
  if (!wrong.empty()) return wrong;
  std::uint32_t taken = bits_of(index.control().always);
  std::uint32_t of_codes = 0;
  bool may_have_axes = true;
  for (const GcodeRow* row : rows_) {
    of_codes |= bits_of(words_of(index.control(), *row));
    may_have_axes = may_have_axes && row->takes_axes;
    if (row->meaning == GcodeMeaning::cycle) of_codes |= bits_of("R");
    const bool needs_word = row->meaning == GcodeMeaning::harmless && !row->takes_axes && !row->words.empty();
    if (needs_word && !has_any(row->words)) return code_text(row->letter, row->number) + " lacks its word";
  }
  const bool is_modal_cycle = modal != nullptr && modal->meaning == GcodeMeaning::cycle;
  if (modal != nullptr && row_of(ModalGroup::motion) == nullptr && row_of(ModalGroup::cycle_end) == nullptr)
    taken |= bits_of(words_of(index.control(), *modal)) | (is_modal_cycle ? bits_of("R") : 0U);
  constexpr std::string_view kAxes = "XYZABC";
  axes_ = present_ & bits_of(kAxes) & ~of_codes;
  taken |= of_codes | (may_have_axes ? bits_of(kAxes) : 0U);
  if ((present_ & ~taken) == 0) return {};
  for (const GcodeWord& word : block.words) {
    if (word.letter == 'G' || word.letter == 'M' || (taken >> bit(word.letter) & 1U) != 0) continue;
    return why_not_taken(word);
  }
  return {};
}

std::string BlockWords::why_not_taken(const GcodeWord& word) const {
  if (!is_axis_letter(word.letter)) return word_text(word) + " belongs to no code of the block";
  const auto row = std::ranges::find(rows_, false, &GcodeRow::takes_axes);
  if (row == rows_.end()) return word_text(word) + " has no meaning in this block";
  return "a motion beside " + code_text((*row)->letter, (*row)->number) + ", here " + word_text(word) +
         ", is not read; expected a block of its own";
}

std::optional<int> BlockWords::integer(char letter) const {
  if (!has(letter)) return std::nullopt;
  const double number = value(letter);
  constexpr double kLargest = 1e9;
  if (!(std::abs(number) <= kLargest) || std::abs(number - std::round(number)) > 0) return std::nullopt;
  return static_cast<int>(std::lround(number));
}

bool BlockWords::has_any(std::string_view letters) const { return (present_ & bits_of(letters)) != 0; }

const GcodeRow* BlockWords::row_of(GcodeMeaning meaning) const {
  for (const GcodeRow* row : rows_)
    if (row->meaning == meaning) return row;
  return nullptr;
}

}  // namespace gouge
