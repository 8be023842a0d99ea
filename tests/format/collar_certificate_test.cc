// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/format/collar_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace veritope::certificate {
namespace {

CollarBody example() {
  CollarBody body;
  body.shift = 300;
  body.corner = {-1, 0, 64};
  body.cells = {5, 200};
  body.sides = {0, 1};
  body.collapses = {3, 1};
  body.leaves = {0, 1, 1, 1, 1};
  body.shores = {{{}, 5, 0, false}, {{{2, {1, -1, 0}}}, 6, 7, true}};
  return body;
}

TEST(CollarCertificate, EncodesWhatThePageSaysBehindTheStarBoxes) {
  const CollarBody body = example();
  const Bytes star = encode(body.star), all = encode(body);
  ASSERT_GT(all.size(), star.size());
  EXPECT_TRUE(std::equal(star.begin(), star.end(), all.begin()));
  const Bytes want = {
      0xac, 0x02, 1, 0, 0x80, 0x01,        // root: 300 = 44 + 128 * 2; zigzag of -1, 0, 64
      2,    0,    0, 0, 5,    0xc3, 0x01,  // two cells: 5, then 195 more
      2,    0,    0, 0, 0,    1,           // sides
      6,    3,                             // faces 3, then two less
      0,    1,    1, 1, 1,                 // leaves
      0,    0,    0, 0, 5,                 // a shore without points, along -z
      1,    0,    0, 0, 2,    2,    1,    0, 6, 7, 1};
  EXPECT_EQ(Bytes(all.begin() + static_cast<std::ptrdiff_t>(star.size()), all.end()), want);
}

TEST(CollarCertificate, StatesTheKeysOfStarBoxesAndTheCells) {
  Subject subject;
  subject.sha256 = std::string(64, 'a'), subject.bytes = 17, subject.format = "vjson",
  subject.tool = "tests";
  StarBoxQuantities q;
  q.patches = 6, q.edges = 12, q.vertices = 8, q.shells = 1, q.bodies = 1;
  const Bytes bytes = encode(subject, q, example());
  const std::string line(bytes.begin(), std::find(bytes.begin(), bytes.end(), '\n'));
  EXPECT_NE(line.find("\"claim\":\"collar-1\""), std::string::npos) << line;
  EXPECT_NE(line.find("\"boxes\":0,\"flipped\":0,\"cells\":2}"), std::string::npos) << line;
}

}  // namespace
}  // namespace veritope::certificate
