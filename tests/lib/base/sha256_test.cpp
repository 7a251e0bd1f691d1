#include "lib/base/sha256.h"

#include <gtest/gtest.h>

namespace gouge::sha256_test {
namespace {

// The examples of FIPS 180-4 and of NIST's page on them; the others are of coreutils' sha256sum.
TEST(Sha256, ItIsTheOneOfTheStandard) {
  EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesMakeTheHashOfTheWhole) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += static_cast<char>(i);
  for (std::size_t length = 0; length <= text.size(); ++length) {
    Sha256 pieces;
    for (std::size_t at = 0; at < length; at += 7)
      pieces.add(std::string_view(text).substr(at, std::min<std::size_t>(7, length - at)));
    EXPECT_EQ(pieces.finish(), sha256_of(text.substr(0, length))) << length;
  }
}

}  // namespace
}  // namespace gouge::sha256_test
