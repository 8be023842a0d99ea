// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_bytes.h: what the bodies of certificates about simplex-spline solids
// share, and their limits (B1, B2).
#pragma once
#include "dms.h"

const int64_t kMostDmsBodyBits = 1024;

struct DmsBytes : Bytes {
  explicit DmsBytes(const Body& bytes) : Bytes(bytes) {}

  uint64_t number_of(uint64_t bytes_each);  // of elements that follow, a varint
  std::vector<Ratio> rationals(size_t n);
  std::vector<Ratio> planes();  // four numbers each
};
void check_short(const std::vector<Ratio>& v, int64_t most_bits);  // B2
void check_dms_file(const DmsFile& file);                          // B2, of its degree and numbers
