#include "lib/json/json_field.h"

#include <gtest/gtest.h>

namespace gouge::json_field_test {
namespace {

const char* const kText = "{\n\"name\": \"a\",\n\"list\": [1,\n-2.5],\n\"nothing\": null,\n\"yes\": true\n}\n";

/// The first error that reading gives, or "".
template <class Read>
std::string error_of(Read read) {
  const auto json = parse_json("a.json", kText, {"x-syntax", "x-duplicate", "a thing"});
  if (!json) return "not read";
  JsonErrors errors{"a.json", "x-field", &json->lines};
  read(JsonField(json->root, errors));
  return errors.first ? to_text(*errors.first) : "";
}

TEST(JsonField, GivesWhatIsThere) {
  EXPECT_EQ(error_of([](const JsonField& root) {
              EXPECT_EQ(root.at("name").text(), "a");
              EXPECT_EQ(root.at("list").list().at(0).count(), 1U);
              EXPECT_EQ(root.at("list").list().at(1).number(), -2.5);
              EXPECT_TRUE(root.at("nothing").is_null());
              EXPECT_FALSE(root.at("nothing").number_or_null());
              EXPECT_TRUE(root.at("yes").flag());
              EXPECT_FALSE(root.find("other"));
              EXPECT_EQ(root.at("name").word({"b", "a"}), 1U);
            }),
            "");
}

TEST(JsonField, NamesFieldLineAndWhatWasExpected) {
  EXPECT_EQ(error_of([](const JsonField& root) { (void)root.at("list").list().at(1).count(); }),
            "a.json:4: error: '/list/1' is -2.5; expected a whole number of 0 or more [x-field]");
  EXPECT_EQ(error_of([](const JsonField& root) { (void)root.at("name").number(); }),
            "a.json:2: error: '/name' is \"a\"; expected a number [x-field]");
  EXPECT_EQ(error_of([](const JsonField& root) {
              (void)root.at("name").word({"b", "c"});
            }),
            "a.json:2: error: '/name' is \"a\"; expected one of b, c [x-field]");
  EXPECT_EQ(error_of([](const JsonField& root) { (void)root.at("other").at("deeper").text(); }),
            "a.json:1: error: '/other' is nothing; expected it to be there [x-field]");
}

TEST(JsonField, TheFirstErrorStays) {
  EXPECT_EQ(error_of([](const JsonField& root) {
              (void)root.at("yes").text();
              (void)root.at("name").number();
            }),
            "a.json:6: error: '/yes' is true; expected a text [x-field]");
}

}  // namespace
}  // namespace gouge::json_field_test
