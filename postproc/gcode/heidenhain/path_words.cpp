#include "postproc/gcode/heidenhain/path_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gouge {
namespace {

using Kind = KlartextWord::Kind;

class PathWordTaker {
 public:
  PathWordTaker(const PathForm& form, const std::vector<std::string>& harmless, PathWords& taken)
      : form_(form), harmless_(harmless), taken_(taken) {}

  std::string take(std::span<const KlartextWord> words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool is_known_word = take_feed(words, i) || take_function(words, i) || take_axis(words[i]) ||
                                 take_polar(words[i]) || take_arc(words[i]) || take_compensation(words[i]);
      if (is_twice_) return "'" + word_text(words[i]) + "' is a second word of its kind in the block";
      if (!is_known_word) return "'" + word_text(words[i]) + "' has no place in the block";
    }
    return {};
  }

 private:
  template <typename Value>
  bool store(std::optional<Value>& place, const Value& value) {
    if (place) is_twice_ = true;
    place = value;
    return true;
  }

  bool take_axis(const KlartextWord& word) {
    if (!form_.has_coordinates || word.kind != Kind::number) return false;
    std::string_view name = word.name;
    const bool is_step = name.size() == 2 && name[0] == 'I';
    if (is_step) name.remove_prefix(1);
    if (name.size() != 1) return false;
    const PathCoordinate made{word.value, is_step, word.parameter};
    const char axis = name[0];
    if (axis >= 'X' && axis <= 'Z') return store(taken_.xyz.at(static_cast<std::size_t>(axis - 'X')), made);
    return axis >= 'A' && axis <= 'C' && store(taken_.abc.at(static_cast<std::size_t>(axis - 'A')), made);
  }

  bool take_polar(const KlartextWord& word) {
    if (!form_.has_polar || word.kind != Kind::number) return false;
    const bool is_step = word.name.starts_with('I');
    const std::string_view name = std::string_view(word.name).substr(is_step ? 1 : 0);
    const PathCoordinate made{word.value, is_step, word.parameter};
    if (name == "PR") return store(taken_.polar_radius, made);
    return name == "PA" && store(taken_.polar_angle, made);
  }

  bool take_arc(const KlartextWord& word) {
    if (form_.has_radius && word.has_number("R")) return store(taken_.radius, word.value);
    return form_.has_direction && word.kind == Kind::sign && word.name == "DR" &&
           store(taken_.is_clockwise, word.value < 0);
  }

  bool take_compensation(const KlartextWord& word) {
    if (!form_.has_compensation) return false;
    const bool is_zero =
        !form_.has_radius && word.has_number("R") && word.parameter.empty() && std::abs(word.value) <= 0;
    if (is_zero) return store(taken_.compensation, PathCompensation::none);
    if (word.is("RL")) return store(taken_.compensation, PathCompensation::left);
    return word.is("RR") && store(taken_.compensation, PathCompensation::right);
  }

  // F240, FMAX, F MAX, FAUTO. The feed behind M128 is that of its compensating motions.
  bool take_feed(std::span<const KlartextWord> words, std::size_t& i) {
    const KlartextWord& word = words[i];
    const bool is_max = word.is("FMAX"), is_auto = word.is("FAUTO");
    const bool has_next = word.is("F") && i + 1 < words.size();
    const bool is_next_max = has_next && words[i + 1].is("MAX"), is_next_auto = has_next && words[i + 1].is("AUTO");
    if (!is_max && !is_auto && !is_next_max && !is_next_auto && !word.has_number("F")) return false;
    if (is_next_max || is_next_auto) ++i;
    const bool is_of_tip_control = std::exchange(is_after_tip_control_, false) && word.kind == Kind::number;
    if (is_of_tip_control) return true;
    if (has_feed_) is_twice_ = true;
    has_feed_ = true;
    taken_.is_rapid = is_max || is_next_max;
    if (word.kind == Kind::number) taken_.feed = word.value;
    return true;
  }

  bool take_function(std::span<const KlartextWord> words, std::size_t& i) {
    const bool is_function = words[i].name.size() == 1 && words[i].name[0] == 'M';
    const auto number = is_function ? whole_number(words[i]) : std::nullopt;
    if (!number || !words[i].parameter.empty()) return false;
    const KlartextFunction* const row = find_klartext_function(*number);
    if (row == nullptr) return std::ranges::find(harmless_, "M" + std::to_string(*number)) != harmless_.end();
    if (std::ranges::find(taken_.functions, row) != taken_.functions.end()) is_twice_ = true;
    taken_.functions.push_back(row);
    is_after_tip_control_ = row->meaning == KlartextMeaning::tip_control_on;
    if (row->meaning == KlartextMeaning::retract) take_distance(words, i);
    return true;
  }

  // MB50, MB MAX
  static void take_distance(std::span<const KlartextWord> words, std::size_t& i) {
    const std::span<const KlartextWord> rest = words.subspan(i + 1);
    if (!rest.empty() && rest[0].has_number("MB"))
      ++i;
    else if (rest.size() > 1 && rest[0].is("MB") && rest[1].is("MAX"))
      i += 2;
  }

  const PathForm& form_;
  const std::vector<std::string>& harmless_;
  PathWords& taken_;
  bool is_twice_ = false, has_feed_ = false, is_after_tip_control_ = false;
};

}  // namespace

const KlartextFunction* PathWords::function(KlartextMeaning meaning) const {
  const auto found =
      std::ranges::find_if(functions, [&](const KlartextFunction* row) { return row->meaning == meaning; });
  return found == functions.end() ? nullptr : *found;
}

std::string take_path_words(std::span<const KlartextWord> words, const PathForm& form,
                            const std::vector<std::string>& harmless, PathWords& taken) {
  return PathWordTaker(form, harmless, taken).take(words);
}

}  // namespace gouge
