#include "lib/json/json_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <string>

#include "toolmodels/tool_library.h"

namespace gouge::json_file_test {
namespace {

std::string repeated(const std::string& piece, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += piece;
  return text;
}

std::string error_of(const std::string& text) {
  const auto json = parse_json("a.json", text, {"some-syntax", "some-duplicate-key", "a list"});
  return json ? "" : to_text(json.error());
}

long max_memory_kB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(JsonFile, NestingEndsAtSixtyFourLevels) {
  EXPECT_EQ(error_of(repeated("[", 64) + repeated("]", 64)), "");
  EXPECT_EQ(error_of("{\n\"a\":" + repeated("[", 64) + repeated("]", 64) + "}"),
            "a.json:2: error: objects and lists are nested deeper than 64 levels; expected a list, which needs no more "
            "than ten; the file is damaged or not one [json-too-deep]");
  EXPECT_EQ(error_of(repeated("{\"[[{{\\\"\":", 64) + "\"" + repeated("[", 100) + "\"" + repeated("}", 64)), "")
      << "brackets within texts are no levels";
  EXPECT_EQ(error_of("[" + repeated("[],", 1000) + "[]]"), "") << "what is closed is no level";
}

TEST(JsonFile, NestingTakesNoMemory) {
  const long before = max_memory_kB();
  for (const std::string& text : {repeated("[", 200'000), repeated("{\"a\":", 40'000), repeated("[{\"a\":", 40'000)}) {
    EXPECT_NE(error_of(text).find("[json-too-deep]"), std::string::npos);
    const auto library = read_tool_library("a.json", text);
    ASSERT_FALSE(library);
    EXPECT_EQ(library.error().code, "json-too-deep");
  }
  // Gigabytes, if every value kept the names of all around it.
  const std::string key = repeated("k", 2'000);
  EXPECT_EQ(error_of(repeated("{\"" + key + "\":", 60) + "[" + repeated("0,", 30'000) + "0]" + repeated("}", 60)), "");
  EXPECT_LT(max_memory_kB() - before, 64'000);
}

TEST(JsonFile, TextsAndNumbersHaveALimit) {
  EXPECT_EQ(error_of("[\"" + std::string(1'000'000, 'x') + "\"]"), "");
  EXPECT_EQ(error_of("[\n\"" + std::string(1'000'001, 'x') + "\"]"),
            "a.json:2: error: a text of more than 1000000 characters; expected a list; the file is damaged or not one "
            "[json-too-long]");
  EXPECT_EQ(error_of("[0." + std::string(998, '1') + "]"), "");
  EXPECT_EQ(error_of("[0." + std::string(999, '1') + "]"),
            "a.json:1: error: a number of more than 1000 characters; expected a list; the file is damaged or not one "
            "[json-too-long]");
}

TEST(JsonFile, OneKeyTwiceIsFoundHoweverItIsWritten) {
  const std::string end = " is there twice; remove one [some-duplicate-key]";
  EXPECT_EQ(error_of("{\"a\":{\"b\":1,\n\"b\":2}}"), "a.json:2: error: the key /a/b" + end);
  EXPECT_EQ(error_of("{\"name\":1,\"n\\u0061me\":2}"), "a.json:1: error: the key /name" + end);
  EXPECT_EQ(error_of("{\"a\":{\"b\":1},\"a/b\":2}"), "");
  EXPECT_EQ(error_of("[{\"a\":1},{\"a\":1}]"), "");
}

TEST(JsonFile, EveryValueHasItsLine) {
  const auto json = parse_json("a.json", "\xEF\xBB\xBF{\n\"a\":[1,\n{\"b/c\":\n2}],\"d\":\n3}",
                               {"some-syntax", "some-duplicate-key", "a list"});
  ASSERT_TRUE(json);
  EXPECT_EQ(json->lines.at(""), 1U);
  EXPECT_EQ(json->lines.at("/a"), 2U);
  EXPECT_EQ(json->lines.at("/a/1"), 3U);
  EXPECT_EQ(json->lines.at("/a/1/b/c"), 4U);
  EXPECT_EQ(json->lines.at("/a/1/none"), 3U) << "the nearest thing around it";
  EXPECT_EQ(json->lines.at("/d"), 5U);
}

// With all names that such a key might be made of tried, 1 MB took half a minute.
TEST(JsonFile, TheLineOfAKeyOfSlashesIsThatOfWhatIsAroundIt) {
  const std::string key = repeated("/", 900'000), short_key = repeated("a/", 20) + "b";
  const auto json = parse_json("a.json", "{\n\"" + key + "\": 1,\n\"" + short_key + "\": 2}", {"", "", ""});
  ASSERT_TRUE(json);
  EXPECT_EQ(json->lines.at("/" + key), 1U);
  EXPECT_EQ(json->lines.at("/" + short_key), 3U);
}

TEST(JsonFile, NamesTheKindOfAFileThatIsNoJson) {
  EXPECT_EQ(error_of("<?xml version='1.0'?><a/>"), "a.json: error: is XML; expected a list (JSON) [some-syntax]");
  EXPECT_EQ(error_of("solid a\nfacet normal 0 0 1\n"),
            "a.json: error: is an STL mesh; expected a list (JSON) [some-syntax]");
  EXPECT_EQ(error_of("PARTNO A\nUNITS/MM\nGOTO/1,2,3\n"),
            "a.json: error: is a toolpath (CL data); expected a list (JSON) [some-syntax]");
  EXPECT_NE(error_of("some words").find("this is not JSON: there is a mistake"), std::string::npos);
}

TEST(JsonFile, StatesHowToGetAFileThatAnotherStandsInFor) {
  EXPECT_EQ(
      error_of("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 9\n"),
      "a.json: error: is a pointer of Git LFS, not the file itself; get the file with 'git lfs pull' [some-syntax]");
  EXPECT_EQ(error_of("\x1f\x8b\x08 \"" + std::string(20'000'000, 'x')),
            "a.json: error: is a compressed file (gzip); unpack it first [some-syntax]");
}

TEST(JsonFile, NamesTheUsualMistakes) {
  const auto error_of = [](const std::string& text) {
    const Result<JsonFile> parsed = parse_json("a.json", text, {"syntax", "twice", "a list"});
    return parsed ? std::string() : parsed.error().message;
  };
  EXPECT_NE(error_of("{\"a\": [1, 2,\n]}").find("a comma before a bracket: remove it"), std::string::npos);
  EXPECT_NE(error_of("{\"a\": 0,5}").find("a decimal comma: write a point"), std::string::npos)
      << error_of("{\"a\": 0,5}");
  EXPECT_NE(error_of("{\"a\": \"C:\\parts\"}").find("a backslash in a text"), std::string::npos)
      << error_of("{\"a\": \"C:\\parts\"}");
  EXPECT_NE(error_of(std::string("\xff\xfe{\0}\0", 6)).find("save the file as UTF-8"), std::string::npos);
  EXPECT_EQ(error_of("{\"a\": x}").find("("), std::string::npos);
}

}  // namespace
}  // namespace gouge::json_file_test
