// SPDX-License-Identifier: Apache-2.0 OR MIT
// tests/format/sha256_test.cc: the vectors of [FIPS180] and NIST's SHA examples, and both compression functions.
#include "verify/format/sha256.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace veritope {
namespace {

std::span<const unsigned char> bytes(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

std::string hash(const std::string& text) { return to_hex(sha256(bytes(text))); }

TEST(Sha256, GivesThePublishedDigests) {
  EXPECT_EQ(hash(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hash("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hash("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopq"
                 "klmnopqrlmnopqrsmnopqrstnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(hash(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, GivesTheDigestsOfNistsAdditionalExamplesAroundTheBlockLength) {
  EXPECT_EQ(hash("\xbd"), "68325720aabd7c82f30f554b313d0570c95accbb7dc4b5aae11204c08ffe732b");
  EXPECT_EQ(hash("\xc9\x8c\x8e\x55"),
            "7abc22c0ae5af26ce93dbb94433a0e0b2e119d014f8e7f65bd56c61ccccd9504");
  EXPECT_EQ(hash(std::string(55, '\0')),
            "02779466cdec163811d078815c633f21901413081449002f24aa3e80f0b88ef7");
  EXPECT_EQ(hash(std::string(56, '\0')),
            "d4817aa5497628e7c77e6b606107042bbba3130888c5f47a375e6179be789fbb");
  EXPECT_EQ(hash(std::string(57, '\0')),
            "65a16cb7861335d5ace3c60718b5052e44660726da4cd13bb745381b235a1785");
  EXPECT_EQ(hash(std::string(64, '\0')),
            "f5a5fd42d16a20302798ef6ed309979b43003d2320d9f0e8ea9831a92759fb4b");
  EXPECT_EQ(hash(std::string(1000, 'A')),
            "c2e686823489ced2017f6059b8b239318b6364f6dcd835d0a519105a1eadd6e4");
}

TEST(Sha256, DoesNotDependOnHowTheBytesAreCut) {
  std::mt19937 random(1);
  std::string text(1000, 0);
  for (char& c : text) c = static_cast<char>(random());
  const Sha256Digest whole = sha256(bytes(text));
  for (int trial = 0; trial < 200; ++trial) {
    Sha256 pieces;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t size = std::min<std::size_t>(text.size() - at, random() % 150);
      pieces.update(bytes(text).subspan(at, size));
      at += size;
    }
    ASSERT_EQ(pieces.finish(), whole) << "trial " << trial;
  }
}

TEST(Sha256, TheProcessorsInstructionsAgreeWithThePortableFunction) {
  const internal::Sha256Blocks fast = internal::sha256_blocks_x86();
  if (fast == nullptr) GTEST_SKIP() << "this processor has no SHA instructions";
  std::mt19937 random(2);
  for (std::size_t num = 0; num < 40; ++num) {
    std::vector<unsigned char> blocks(64 * num + 1);  // one more: not aligned
    for (unsigned char& b : blocks) b = static_cast<unsigned char>(random());
    std::array<std::uint32_t, 8> a{}, b{};
    for (std::size_t i = 0; i < 8; ++i) a[i] = b[i] = static_cast<std::uint32_t>(random());
    fast(a.data(), blocks.data() + 1, num);
    internal::sha256_blocks_portable(b.data(), blocks.data() + 1, num);
    ASSERT_EQ(a, b) << num << " blocks";
  }
}

}  // namespace
}  // namespace veritope
