// SPDX-License-Identifier: Apache-2.0 OR MIT
// coordinate.h: the coordinates of an answers file; docs/certificates/points.md, section 2.
#pragma once
#include "integer.h"

// A rational number: n / d 2^twos, d > 0. The greatest binary64 number that is not above it and the least one that is
// not below it are held as keys (numbers.h); they are equal if it is a binary64 number, else neighbours, and beyond
// the finite numbers they are infinite.
struct Coordinate {
  int64_t below, above;
  Integer n;
  Nat d;
  int64_t twos;
};

bool is_coordinate(const std::string& word, bool nearest);
// REQUIRES is_coordinate(word, nearest).
Coordinate coordinate(const std::string& word, bool nearest);
// These numbers: of a finite binary64 number's key; n / d, d > 0.
Coordinate coordinate_of(int64_t key);
Coordinate coordinate_of(const Integer& n, const Nat& d);
