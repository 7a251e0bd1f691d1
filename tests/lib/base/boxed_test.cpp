#include "lib/base/boxed.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace gouge::boxed_test {
namespace {

TEST(Boxed, IsEmptyAtFirstAndTakesOnePointer) {
  const Boxed<std::string> box;
  EXPECT_FALSE(box);
  EXPECT_FALSE(box.has_value());
  EXPECT_EQ(sizeof box, sizeof(void*));
}

TEST(Boxed, CopiesHaveValuesOfTheirOwn) {
  Boxed<std::string> box(std::string("a"));
  Boxed<std::string> copy = box;
  *copy += "b";
  EXPECT_EQ(*box, "a");
  box = copy;
  copy.reset();
  EXPECT_EQ(*box, "ab");
  EXPECT_FALSE(copy);
  box = std::nullopt;
  EXPECT_FALSE(box);
}

TEST(Boxed, MovesWithoutACopy) {
  Boxed<std::string> box(std::string("a"));
  const std::string* const place = &*box;
  const Boxed<std::string> taken = std::move(box);
  EXPECT_EQ(&*taken, place);
}

TEST(Boxed, ConvertsFromAndToAnOptional) {
  const Boxed<double> none = std::optional<double>(), two = std::optional<double>(2);
  EXPECT_FALSE(none.has_value());
  EXPECT_EQ(none.optional(), std::nullopt);
  EXPECT_EQ(none.value_or(3), 3);
  EXPECT_EQ(two.optional(), 2);
  EXPECT_EQ(two.value_or(3), 2);
}

}  // namespace
}  // namespace gouge::boxed_test
