#include "cli/job/find_differences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"
#include "postproc/record/record_leaves.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxDifferences = 100;  // more of them tell nothing new
constexpr std::size_t kMaxShownBytes = 80;

/// Last keys of texts for people, whose words another version of the program may choose differently.
constexpr std::array kWordings = {"/value",   "/evidence", "/remedy", "/description",
                                  "/meaning", "/promise",  "/why",    "/why_not"};

/// Key of a finding that a search found.
constexpr const char* kNotCompared = "cures";

bool is_same_number(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return !std::isfinite(a) && !std::isfinite(b);
  const double largest = std::max(std::abs(a), std::abs(b));
  return std::abs(a - b) <= std::max(Tolerance::kRounding_mm, Tolerance::kRounding * largest);
}

bool is_same(const RecordLeaf& a, const RecordLeaf& b) {
  if (a.number && b.number) return is_same_number(*a.number, *b.number);
  return a.text == b.text;
}

/// Returns a value for people. Of a long text this is the part about its first difference from the `other` one.
std::string shown(const RecordLeaf& leaf, const RecordLeaf& other) {
  if (!leaf.is_free_text) return leaf.text;
  const std::string_view text = leaf.text;
  if (text.size() <= kMaxShownBytes) return "\"" + leaf.text + "\"";
  const auto first = std::ranges::mismatch(text, other.text).in1;
  const auto same = static_cast<std::size_t>(first - text.begin());
  const std::size_t from = same < kMaxShownBytes / 2 ? 0 : same - kMaxShownBytes / 4;
  return (from > 0 ? "\"..." : "\"") + valid_utf8(text.substr(from, kMaxShownBytes)) +
         (from + kMaxShownBytes < text.size() ? "...\"" : "\"");
}

/// Replaces the places where inputs were found by the names that the result states.
class StatedNames {
 public:
  explicit StatedNames(const ClaimedResult& result) {
    std::size_t found = 0;
    for (const InputFile& input : result.record.inputs) {
      if (found >= result.inputs.size()) break;
      if (input.role != result.inputs[found].role || input.checksum != result.inputs[found].checksum) continue;
      const std::string& there = result.inputs[found++].name;
      if (there != input.name) names_.emplace_back(there, input.name);
    }
    std::ranges::sort(names_, [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  }

  void apply_to(std::string& text) const {
    for (const auto& [found, stated] : names_) {
      for (std::size_t at = text.find(found); at != std::string::npos; at = text.find(found, at + stated.size()))
        text.replace(at, found.size(), stated);
    }
  }

 private:
  std::vector<std::pair<std::string, std::string>> names_;  // found and stated, the longest first
};

class DifferenceFinder {
 public:
  DifferenceFinder(const ClaimedResult& result, const ExpectedRecord& expected)
      : claimed_(result.record),
        expected_(expected.record),
        is_fit_known_(expected.is_fit_known),
        has_warnings_as_errors_(result.arguments.has_warnings_as_errors),
        names_(result),
        has_same_wording_(result.record.program.version == expected.record.program.version) {}

  RecordDifferences run() {
    if (claimed_.unit != expected_.unit) {
      add("its lengths are in another unit than those of the toolpath");
      return std::move(found_);
    }
    compare_closeness();
    compare_facts();
    if (!found_.is_placement_open) compare_text("/promise", claimed_.guarantee, expected_.guarantee);
    compare_text("/placement", claimed_.placement, expected_.placement);
    compare("/toolpath", claimed_.toolpath, expected_.toolpath);
    compare_lists("/parts", claimed_.parts, expected_.parts);
    compare_lists("/fixtures", claimed_.fixtures, expected_.fixtures);
    compare_lists("/heads", claimed_.heads, expected_.heads);
    compare_lists("/tools", claimed_.tools, expected_.tools);
    compare("/totals", claimed_.totals, expected_.totals);
    compare_lists("/events", claimed_.events, expected_.events);
    compare_baseline();
    compare_lists("/reasons", claimed_.reasons, expected_.reasons);
    compare_lists("/moves", claimed_.moves, expected_.moves);
    compare_lists("/runs", claimed_.runs, expected_.runs);
    compare_motions();
    if (has_warnings_as_errors_) compare_warnings();
    return std::move(found_);
  }

 private:
  void add(std::string what) {
    if (found_.wrong.size() < kMaxDifferences) found_.wrong.push_back(std::move(what));
  }

  void compare_text(const std::string& place, const std::string& claimed, const std::string& expected) {
    compare_leaves({{place, claimed, {}, true}}, {{place, valid_utf8(expected), {}, true}});
  }

  template <typename Record>
  void compare(const std::string& place, const Record& claimed, const Record& expected) {
    compare_leaves(leaves_of(place, claimed), leaves_of(place, expected));
  }

  template <typename Record>
  void compare_lists(const std::string& place, const std::vector<Record>& claimed,
                     const std::vector<Record>& expected) {
    if (claimed.size() != expected.size())
      return add("its '" + place + "' has " + count_text(claimed.size(), "entry", "entries") +
                 ", and its moves and inputs give " + std::to_string(expected.size()));
    for (std::size_t k = 0; k < claimed.size() && found_.wrong.size() < kMaxDifferences; ++k)
      compare(place + "/" + std::to_string(k), claimed[k], expected[k]);
  }

  [[nodiscard]] bool is_compared(const RecordLeaf& leaf) const {
    if (leaf.place.starts_with("/events/")) {
      const std::string key = leaf.place.substr(leaf.place.find('/', std::string("/events/").size()) + 1);
      if (key.starts_with(kNotCompared)) return false;
    }
    return has_same_wording_ ||
           std::ranges::none_of(kWordings, [&](const char* key) { return leaf.place.ends_with(key); });
  }

  [[nodiscard]] std::vector<RecordLeaf> compared(std::vector<RecordLeaf> leaves) const {
    std::erase_if(leaves, [&](const RecordLeaf& leaf) { return !is_compared(leaf); });
    return leaves;
  }

  /// Compares the leaves of two records of the same kind. An object that only one of them has differs in its first leaf.
  void compare_leaves(std::vector<RecordLeaf> claimed, std::vector<RecordLeaf> expected) {
    claimed = compared(std::move(claimed));
    expected = compared(std::move(expected));
    for (RecordLeaf& leaf : expected)
      if (leaf.is_free_text) names_.apply_to(leaf.text);
    for (std::size_t k = 0; k < std::min(claimed.size(), expected.size()); ++k) {
      if (claimed[k].place != expected[k].place)
        return add("its '" + claimed[k].place + "' is not what its moves and inputs give");
      if (!is_same(claimed[k], expected[k]))
        add("its '" + claimed[k].place + "' is " + shown(claimed[k], expected[k]) + ", and its moves and inputs give " +
            shown(expected[k], claimed[k]));
    }
    if (claimed.size() != expected.size())
      add("its '" + (claimed.size() > expected.size() ? claimed : expected).back().place +
          "' is not what its moves and inputs give");
  }

  /// Compares the distances of path and part. A clean move may touch the part, and is not listed.
  void compare_closeness() {
    if (claimed_.closeness.has_value() != expected_.closeness.has_value())
      return add("its '/closeness' is not what its moves and inputs give");
    if (!claimed_.closeness) return;
    ClosenessRecord expected = *expected_.closeness;
    const std::optional<double>& nearest_mm = claimed_.closeness->nearest_mm;
    const bool is_touching = nearest_mm && !(*nearest_mm > 0);
    is_nearest_known_ = !is_touching || (expected.nearest_mm && !(*expected.nearest_mm > 0));
    if (!is_nearest_known_) expected.nearest_mm = nearest_mm;
    compare("/closeness", *claimed_.closeness, expected);
  }

  [[nodiscard]] std::string name_of(const Assumption& fact) const {
    std::string object = valid_utf8(fact.object);
    names_.apply_to(object);
    return subject_name(fact.subject) + (object.empty() ? "" : " " + object);
  }

  /// Compares the facts on which the verdict rests.
  void compare_facts() {
    std::vector<bool> is_expected(claimed_.assumptions.size(), false);
    for (const Assumption& fact : expected_.assumptions) {
      const std::string name = name_of(fact);
      std::size_t k = 0;
      while (k < is_expected.size() && (is_expected[k] || stated_name(claimed_.assumptions[k]) != name)) ++k;
      if (k == is_expected.size()) {
        add("it leaves out the fact " + name + " (" + basis_name(fact.basis) + ")");
        continue;
      }
      is_expected[k] = true;
      compare_fact(k, claimed_.assumptions[k], fact);
    }
    for (std::size_t k = 0; k < is_expected.size(); ++k)
      if (!is_expected[k])
        add("it states the fact " + stated_name(claimed_.assumptions[k]) + ", which its inputs do not have");
  }

  static std::string stated_name(const Assumption& fact) {
    return subject_name(fact.subject) + (fact.object.empty() ? "" : " " + fact.object);
  }

  void compare_fact(std::size_t k, const Assumption& claimed, const Assumption& expected) {
    const std::size_t before = found_.wrong.size();
    if (claimed.basis != expected.basis)
      add("it states the fact " + stated_name(claimed) + " as " + basis_name(claimed.basis) +
          ", and its moves and inputs show it as " + basis_name(expected.basis));
    else
      compare("/assumptions/" + std::to_string(k), claimed, expected);
    const bool may_depend_on_clean_moves =
        expected.subject == Subject::placement && !(is_fit_known_ && is_nearest_known_);
    if (found_.wrong.size() == before || !may_depend_on_clean_moves) return;
    found_.wrong.resize(before);
    found_.is_placement_open = true;
  }

  void compare_baseline() {
    if (claimed_.baseline.has_value() != expected_.baseline.has_value())
      return add("its '/baseline' is not what its inputs give");
    if (!claimed_.baseline) return;
    compare("/baseline", *claimed_.baseline, *expected_.baseline);
  }

  void compare_motions() {
    const std::vector<std::string_view> claimed = claimed_.motion_list(), expected = expected_.motion_list();
    const auto [at, other] = std::ranges::mismatch(claimed, expected);
    if (at != claimed.end() || other != expected.end())
      add("its 'motions' do not have the motion of move " + std::to_string(at - claimed.begin()) + " of the toolpath");
  }

  /// Finds warnings about inputs that the result does not have, where its verdict depends on them.
  void compare_warnings() {
    for (const Diagnostic& warning : expected_.notes) {
      const auto is_it = [&](const Diagnostic& note) {
        return note.severity == Severity::warning && note.code == warning.code && note.line == warning.line;
      };
      if (warning.severity == Severity::warning && std::ranges::none_of(claimed_.notes, is_it))
        add("it leaves out the warning " + warning.code);
    }
  }

  const ResultRecord& claimed_;
  const ResultRecord& expected_;
  bool is_fit_known_, is_nearest_known_ = true;
  bool has_warnings_as_errors_;
  StatedNames names_;
  bool has_same_wording_;
  RecordDifferences found_;
};

}  // namespace

RecordDifferences find_differences(const ClaimedResult& result, const ExpectedRecord& expected) {
  return DifferenceFinder(result, expected).run();
}

}  // namespace gouge
