#include "lib/base/shared_module.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace gouge::shared_module_test {
namespace {

TEST(SharedModule, GivesAFunctionOfALibraryOfTheSystem) {
  const Result<void*> cosine = find_function("libm.so.6", "cos");
  ASSERT_TRUE(cosine);
  EXPECT_EQ(reinterpret_cast<double (*)(double)>(*cosine)(0), 1);
}

TEST(SharedModule, MissingModulesAndFunctionsAreNamed) {
  const Result<void*> module = find_function("gougecheck_none.so", "function");
  ASSERT_FALSE(module);
  EXPECT_EQ(module.error().code, "module-missing");
  EXPECT_NE(module.error().message.find("gougecheck_none.so"), std::string::npos) << module.error().message;
  const Result<void*> function = find_function("libm.so.6", "gougecheck_none");
  ASSERT_FALSE(function);
  EXPECT_EQ(function.error().code, "module-missing");
}

#if !defined(GOUGE_SANITIZED)  // sanitizers map terabytes
TEST(SharedModule, NothingIsLoadedWhereItsLibrariesWouldNotFit) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  const rlimit little{400'000'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &little), 0);
  const Result<void*> fresh = find_function("libsqlite3.so.0", "sqlite3_libversion");
  const Result<void*> loaded = find_function("libm.so.6", "cos");
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &before), 0);
  ASSERT_FALSE(fresh);
  EXPECT_EQ(fresh.error().code, "out-of-memory");
  EXPECT_TRUE(loaded) << "what is loaded needs no more";
}
#endif

}  // namespace
}  // namespace gouge::shared_module_test
