#include "tests/laws/statement_mutator.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace gouge::laws {
namespace {

using Lines = std::vector<std::string>;  // statements with their continuation lines, line ends included

Lines statements_of(const std::string& bytes) {
  Lines statements;
  std::string statement;
  std::size_t begin = 0;
  while (begin < bytes.size()) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size() - 1) + 1;
    const std::string line = bytes.substr(begin, end - begin);
    statement += line;
    begin = end;
    const std::size_t last = line.find_last_not_of(" \t\r\n");
    const bool goes_on = last != std::string::npos && line[last] == '$' && (last == 0 || line[last - 1] != '$');
    if (goes_on && begin < bytes.size()) continue;
    statements.push_back(std::exchange(statement, ""));
  }
  return statements;
}

std::string joined(const Lines& lines) {
  std::string bytes;
  for (const std::string& line : lines) bytes += line;
  return bytes;
}

std::size_t pick(test::Scatter& random, std::size_t count) { return static_cast<std::size_t>(random.next() % count); }

// The places of the characters that `wanted` takes.
template <typename Wanted>
std::vector<std::size_t> places(const std::string& bytes, Wanted wanted) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (wanted(i)) found.push_back(i);
  }
  return found;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

enum class CharacterDamage { lose, repeat };

void damage(std::string& bytes, const std::vector<std::size_t>& where, CharacterDamage how, test::Scatter& random) {
  if (where.empty()) return;
  const std::size_t place = where[pick(random, where.size())];
  if (how == CharacterDamage::lose)
    bytes.erase(place, 1);
  else
    bytes.insert(place, 1, bytes[place]);
}

void damage_all(std::string& bytes, char c, CharacterDamage how, test::Scatter& random) {
  damage(bytes, places(bytes, [&](std::size_t i) { return bytes[i] == c; }), how, random);
}

struct Opposite {
  std::string_view word, addition;
};

// Words that take back what the statement states, or state it again otherwise.
constexpr std::array<Opposite, 14> kOpposites{{{"UNIT", ",INCHES"},
                                               {"UNIT", ",MM"},
                                               {"CYCLE", ",OFF"},
                                               {"CYCLE", ",FEDTO,15"},
                                               {"CYCLE", ",DEPTH,15"},
                                               {"CYCLE", ",RAPTO,0.5"},
                                               {"MULTAX", ",OFF"},
                                               {"MULTAX", ",ON"},
                                               {"CUTCOM", ",LEFT"},
                                               {"CUTCOM", ",OFF"},
                                               {"CIRCLE", ",CLOCKWISE"},
                                               {"MOVARC", ",ANGLE,-90"},
                                               {"LOAD/TOOL", ",TOOL,7"},
                                               {"TRNTYP", ",LOCAL"}}};

void contradict(Lines& lines, test::Scatter& random) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = 0; k < kOpposites.size(); ++k) {
      if (lines[i].starts_with(kOpposites[k].word)) found.emplace_back(i, k);
    }
  }
  if (found.empty()) return;
  const auto [line, opposite] = found[pick(random, found.size())];
  const std::size_t end = std::min(lines[line].find_last_not_of(" \r\n") + 1, lines[line].size());
  lines[line].insert(end, kOpposites[opposite].addition);
}

using Damage = void (*)(Lines&, test::Scatter&);

// A damage to one statement that depends on its own text only.
template <typename Change>
void to_one(Lines& lines, test::Scatter& random, Change change) {
  change(lines[pick(random, lines.size())]);
}

void cut_short(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    const auto where = places(s, [&](std::size_t i) { return s[i] == ',' || s[i] == '/'; });
    if (where.empty()) return;
    const std::size_t place = where[pick(random, where.size())] + pick(random, 2);
    s = s.substr(0, place) + "\n";
  });
}

void part_it(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    if (s.size() > 2) s.insert(1 + pick(random, s.size() - 2), "\n");
  });
}

void part_after_comma(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    const auto where = places(s, [&](std::size_t i) { return s[i] == ','; });
    if (!where.empty()) s.insert(where[pick(random, where.size())] + pick(random, 2), "\n");
  });
}

void lose_major_word(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    const std::size_t slash = s.find('/');
    if (slash != std::string::npos) s.erase(0, slash + pick(random, 2));
  });
}

void lose_slash(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    const std::size_t slash = s.find('/');
    if (slash != std::string::npos) s.erase(slash, 1);
  });
}

void glue(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    const std::size_t slash = s.find('/');
    if (slash == std::string::npos) return;
    const std::size_t number = s.find_first_not_of(" \t", slash + 1);
    const std::size_t word = s.find_last_not_of(" \t", slash - (slash > 0 ? 1 : 0));
    if (number != std::string::npos && word != std::string::npos) s.erase(word + 1, number - word - 1);
  });
}

void lose_physical_line(Lines& lines, test::Scatter& random) {
  to_one(lines, random, [&](std::string& s) {
    const auto ends = places(s, [&](std::size_t i) { return s[i] == '\n'; });
    if (ends.size() < 2) return;
    const std::size_t which = pick(random, ends.size());
    const std::size_t begin = which == 0 ? 0 : ends[which - 1] + 1;
    s.erase(begin, ends[which] + 1 - begin);
  });
}

template <char kCharacter, CharacterDamage kHow>
void character(Lines& lines, test::Scatter& random) {
  std::string bytes = joined(lines);
  damage_all(bytes, kCharacter, kHow, random);
  lines = {bytes};
}

void lose_line_end(Lines& lines, test::Scatter& random) {
  std::string bytes = joined(lines);
  const auto ends = places(bytes, [&](std::size_t i) { return bytes[i] == '\n'; });
  if (ends.empty()) return;
  const std::size_t end = ends[pick(random, ends.size())];
  const bool with_return = end > 0 && bytes[end - 1] == '\r' && pick(random, 2) == 0;
  bytes.erase(end - (with_return ? 1 : 0), with_return ? 2 : 1);
  lines = {bytes};
}

template <CharacterDamage kHow>
void letter(Lines& lines, test::Scatter& random) {
  to_one(lines, random,
         [&](std::string& s) { damage(s, places(s, [&](std::size_t i) { return is_letter(s[i]); }), kHow, random); });
}

struct Kind {
  std::string_view name;
  Damage damage;
};

constexpr std::array<Kind, 24> kKinds{{
    {"statement lost", [](Lines& l, test::Scatter& r) { l[pick(r, l.size())].clear(); }},
    {"statement twice", [](Lines& l, test::Scatter& r) { to_one(l, r, [](std::string& s) { s += s; }); }},
    {"statement cut short", cut_short},
    {"statement parted", part_it},
    {"statement parted at a comma", part_after_comma},
    {"statement misplaced",
     [](Lines& l, test::Scatter& r) {
       const std::string s = std::exchange(l[pick(r, l.size())], "");
       l.insert(l.begin() + static_cast<std::ptrdiff_t>(pick(r, l.size())), s);
     }},
    {"statements exchanged",
     [](Lines& l, test::Scatter& r) {
       const std::size_t i = pick(r, l.size());
       if (i + 1 < l.size()) std::swap(l[i], l[i + 1]);
     }},
    {"statement copied elsewhere",
     [](Lines& l, test::Scatter& r) {
       const std::string s = l[pick(r, l.size())];
       l.insert(l.begin() + static_cast<std::ptrdiff_t>(pick(r, l.size())), s);
     }},
    {"statement contradicted", contradict},
    {"major word lost", lose_major_word},
    {"slash lost", lose_slash},
    {"number glued to its word", glue},
    {"line of a statement lost", lose_physical_line},
    {"letter lost", letter<CharacterDamage::lose>},
    {"letter twice", letter<CharacterDamage::repeat>},
    {"$ lost", character<'$', CharacterDamage::lose>},
    {"$ twice", character<'$', CharacterDamage::repeat>},
    {"comma lost", character<',', CharacterDamage::lose>},
    {"comma twice", character<',', CharacterDamage::repeat>},
    {"slash twice", character<'/', CharacterDamage::repeat>},
    {"blank lost", character<' ', CharacterDamage::lose>},
    {"line end lost", lose_line_end},
    {"$ put at a line's end",
     [](Lines& l, test::Scatter& r) {
       to_one(l, r, [](std::string& s) { s.insert(std::min(s.find_last_not_of("\r\n") + 1, s.size()), "$"); });
     }},
    {"letters exchanged",
     [](Lines& l, test::Scatter& r) {
       to_one(l, r, [&](std::string& s) {
         const auto where =
             places(s, [&](std::size_t i) { return i + 1 < s.size() && is_letter(s[i]) && is_letter(s[i + 1]); });
         if (where.empty()) return;
         const std::size_t i = where[pick(r, where.size())];
         std::swap(s[i], s[i + 1]);
       });
     }},
}};

}  // namespace

std::size_t mutation_kinds() { return kKinds.size(); }

std::string_view mutation_name(std::size_t kind) { return kKinds[kind].name; }

Mutant mutate(const std::string& bytes, std::size_t kind, test::Scatter& random) {
  Lines lines = statements_of(bytes);
  Mutant mutant;
  mutant.kind = kind;
  kKinds[kind].damage(lines, random);
  mutant.bytes = joined(lines);
  const auto [before, after] = std::mismatch(bytes.begin(), bytes.end(), mutant.bytes.begin(), mutant.bytes.end());
  mutant.what =
      std::string(kKinds[kind].name) + " at line " + std::to_string(1 + std::count(bytes.begin(), before, '\n'));
  return mutant;
}

}  // namespace gouge::laws
