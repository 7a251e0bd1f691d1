#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lib/base/files.h"
#include "tests/support/source_folder.h"
#include "toolmodels/import/import_tools.h"

namespace gouge::test {

inline std::string corpus(const std::string& name) {
  const Result<std::string> bytes = read_file(source_folder() + "/tests/corpus/tool/" + name);
  EXPECT_TRUE(bytes.has_value()) << name;
  return bytes ? *bytes : std::string();
}

/// Every note of `code`, one a line, as the user reads them.
inline std::string notes_of(const ImportedTools& made, const std::string& code) {
  std::string text;
  for (const Diagnostic& note : made.notes)
    if (note.code == code) text += to_text(note) + "\n";
  return text;
}

inline std::string all_notes(const ImportedTools& made) {
  std::string text;
  for (const Diagnostic& note : made.notes) text += to_text(note) + "\n";
  return text;
}

inline void expect_segment(const ToolSegment& s, double lower, double upper, double length) {
  EXPECT_NEAR(s.lower_diameter_mm, lower, 1e-9);
  EXPECT_NEAR(s.upper_diameter_mm, upper, 1e-9);
  EXPECT_NEAR(s.length_mm, length, 1e-9);
}

/// A written library reads back, tool for tool, with the same contours.
inline void expect_round_trip(const ToolLibrary& library) {
  const std::string text = write_tool_library(library);
  const Result<ToolLibrary> back = read_tool_library("back.json", text);
  ASSERT_TRUE(back.has_value()) << to_text(back.error()) << "\n" << text;
  EXPECT_EQ(write_tool_library(*back), text);
  ASSERT_EQ(back->tools.size(), library.tools.size());
  ASSERT_EQ(back->holders.size(), library.holders.size());
  for (std::size_t i = 0; i < library.tools.size(); ++i) {
    EXPECT_EQ(back->tools[i].number, library.tools[i].number);
    EXPECT_EQ(back->tools[i].name, library.tools[i].name);
    const Profile before = *make_profile(library.tools[i]), after = *make_profile(back->tools[i]);
    ASSERT_EQ(after.elements.size(), before.elements.size());
    for (std::size_t k = 0; k < before.elements.size(); ++k) {
      EXPECT_EQ(after.elements[k].a, before.elements[k].a);
      EXPECT_EQ(after.elements[k].center, before.elements[k].center);
      EXPECT_EQ(after.elements[k].body, before.elements[k].body);
    }
  }
}

}  // namespace gouge::test
