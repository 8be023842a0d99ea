// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_reader.h: parts of files of docs/formats/micro-files.md.
#pragma once
#include <tuple>

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
  void sweeps();
  void materials();

 private:
  void bridge();
  void sweep();
  // Reads member `key` of "grid", "cell" and "wall", of a bridge or sweep.
  template <class Begun>
  void begin_of(size_t key, Begun* b) {
    if (key == 0) b->grid = size_t(integer_in(0, int64_t(out.grids.size()) - 1));
    if (key == 1) b->cell = uint64_t(integer_in(0, int64_t(kMostMicroCells) - 1));
    if (key == 2) b->wall = size_t(integer_in(0, 5));
  }
  // That the cell holds a tile, and the place follows that of the last one before it.
  template <class Begun>
  void check_begin_of(const Begun& b, const std::vector<Begun>& before) const {
    const MicroGrid& g = out.grids[b.grid];
    expect(b.cell < g.cells() && g.tile[b.cell] != 0,
           "the cell of a bridge or sweep holds no tile");
    expect(before.empty() || place_of(before.back()) < place_of(b),
           "the bridges or sweeps are not in ascending order of grid, cell and wall");
  }
  template <class Begun>
  static std::tuple<size_t, uint64_t, size_t> place_of(const Begun& b) {
    return std::make_tuple(b.grid, b.cell, b.wall);
  }
  void values(const MicroGrid& grid);
};
