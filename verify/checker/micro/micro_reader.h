// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_reader.h: parts of files of docs/formats/micro-files.md.
#pragma once
#include "../patches/json_reader.h"
#include "micro.h"

struct MicroParts : JsonReader {
  MicroParts(const std::string& text, size_t* begin) : JsonReader(text, begin) {}
  MicroFile out;

  template <class Item>
  void short_list(size_t most, const char* why, Item item) {  // item(its number)
    size_t i = 0;
    list([&] {
      expect(i < most, why);
      item(i++);
    });
  }
  int64_t integer_in(int64_t least, int64_t most) {  // REQUIRES least >= 0
    expect(next() != '-', "an integer has a sign");
    const int64_t v = integer();
    expect(v >= least && v <= most, "an integer is out of range");
    return v;
  }
  bool take_null() {
    if (next() != 'n') return false;
    expect(word() == "null", "expected null");
    return true;
  }
  // Appends the coordinates of the points; the result is the number of points.
  size_t points(size_t most, int64_t bits, std::vector<Ratio>* to);
  void bridges();
  void materials();

 private:
  void bridge();
  void values(const MicroGrid& grid);
};
