#include "lib/verify/certificate_text.h"

#include <gtest/gtest.h>

#include "lib/verify/zstd_stream.h"
#include "tests/support/scatter.h"

namespace gouge::certificate_text_test {
namespace {

const std::vector<ProofGroup> kGroups{{3, 2, "abc"}, {5, 1, ""}, {700, 40, std::string(300, '\2')}};

TEST(CertificateText, BlocksReadBackAsTheyWereWritten) {
  const std::string bytes = block_bytes(kGroups);
  ASSERT_EQ(block_length(bytes), bytes.size() - 4);
  const auto read = groups_of(std::string_view(bytes).substr(4), 0, 1000);
  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ((*read)[k].first, kGroups[k].first);
    EXPECT_EQ((*read)[k].count, kGroups[k].count);
    EXPECT_EQ((*read)[k].steps, kGroups[k].steps);
  }
}

TEST(CertificateText, GroupsThatOverlapGoBackOrReachBeyondThePathAreRefused) {
  const auto is_refused = [](const std::vector<ProofGroup>& groups, std::size_t least = 0, std::size_t moves = 1000) {
    return !groups_of(std::string_view(block_bytes(groups)).substr(4), least, moves).has_value();
  };
  EXPECT_FALSE(is_refused(kGroups));
  EXPECT_TRUE(is_refused({{3, 2, ""}, {4, 1, ""}}));
  EXPECT_TRUE(is_refused({{3, 2, ""}, {3, 2, ""}}));
  EXPECT_TRUE(is_refused({{3, 0, ""}}));
  EXPECT_TRUE(is_refused({{3, kMaxMovesOfGroup + 1, ""}}));
  EXPECT_TRUE(is_refused({{999, 2, ""}}));
  EXPECT_TRUE(is_refused({{~std::size_t{0} >> 1U, 2, ""}}));
  EXPECT_TRUE(is_refused(kGroups, 4));
}

TEST(CertificateText, NoBytesMakeItReadBeyondThem) {
  test::Scatter random(5);
  const std::string whole = block_bytes(kGroups).substr(4);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes = whole.substr(0, random.below(whole.size()));
    for (std::size_t k = random.below(4); k > 0 && !bytes.empty(); --k)
      bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    if (const auto groups = groups_of(bytes, 0, 1000)) {
      for (const ProofGroup& group : *groups) EXPECT_LE(group.first + group.count, 1000U);
    }
  }
}

TEST(ZstdStream, ReadsBackInAnyPiecesAndSaysWhatIsBroken) {
  std::string text;
  for (int k = 0; k < 30000; ++k) text += std::to_string(k * 7919 % 1000);
  ZstdWriter writer;
  for (std::size_t at = 0; at < text.size(); at += 777) writer.add(std::string_view(text).substr(at, 777));
  const std::string packed = writer.finish();
  ZstdReader reader(packed);
  std::string read;
  for (std::string piece = reader.take(1000); !piece.empty(); piece = reader.take(1000)) read += piece;
  EXPECT_EQ(read, text);
  EXPECT_TRUE(reader.is_at_end());
  for (std::size_t at = 0; at < packed.size(); at += 97) {
    std::string changed = packed;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    ZstdReader other(changed);
    EXPECT_FALSE(other.take(text.size()) == text && other.is_at_end()) << at;
    ZstdReader cut(std::string_view(packed).substr(0, at));
    EXPECT_FALSE(cut.take(text.size()) == text && cut.is_at_end()) << at;
  }
}

}  // namespace
}  // namespace gouge::certificate_text_test
