#include "postproc/record/words.h"

#include <cstddef>

#include "lib/base/diagnostic.h"
#include "lib/check/scene.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion_law.h"
#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"
#include "postproc/cldata/rewriting/list_written.h"

namespace gouge {
namespace {

/// Returns the names of all values of an enumeration; `last` is its last value.
template <typename Enum>
Words names_up_to(Enum last, const char* (*name_of)(Enum)) {
  Words words;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(last); ++k) words.emplace_back(name_of(static_cast<Enum>(k)));
  return words;
}

}  // namespace

const Words& state_words() {
  static const Words words = names_up_to(MoveState::not_certified, state_name);
  return words;
}
const Words& body_words() {
  static const Words words = names_up_to(Body::head, body_name);
  return words;
}
const Words& against_words() {
  static const Words words = names_up_to(Against::stock, against_name);
  return words;
}
const Words& kind_words() {
  static const Words words = names_up_to(MoveKind::cycle, kind_name);
  return words;
}
const Words& subject_words() {
  static const Words words = names_up_to(Subject::stock, subject_name);
  return words;
}
const Words& basis_words() {
  static const Words words = names_up_to(Basis::unknown, basis_name);
  return words;
}
const Words& written_words() {
  static const Words words = names_up_to(WrittenKind::removed, written_name);
  return words;
}
const Words& rapid_words() {
  static const Words words(kRapidWords.begin(), kRapidWords.end());
  return words;
}
const Words& severity_words() {
  static const Words words = {"note", "warning", "error"};
  return words;
}
const Words& uncut_words() {
  static const Words words = {"left-out", "hole", "lifted"};
  return words;
}
const Words& verdict_words() {
  static const Words words = {"clean", "gouges", "not-fully-checked", "accepted-gouges", "material-left"};
  return words;
}
const Words& role_words() {
  static const Words words = {"toolpath", "machine",        "part",         "fixture",       "head",
                              "tools",    "named-by-tools", "stock",        "before",        "before-tools",
                              "baseline", "project",        "tool-lengths", "program-beside"};
  return words;
}
const Words& use_words() {
  static const Words words = {"applied", "unused", "void", "elsewhere", "partly"};
  return words;
}

}  // namespace gouge
