// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_reader.cc: files of docs/formats/micro-files.md.
#include "micro_reader.h"

namespace {

const size_t kMostVolumes = 65536, kMostGrids = 65536, kMostGridsOfVolume = 4096;
const size_t kMostTiles = 15, kMostPatches = 1024;
const int64_t kMostMicroDegree = 7, kMostCoordinateBits = 128;

struct MicroReader : MicroParts {
  MicroReader(const std::string& text, size_t* begin) : MicroParts(text, begin) {}

  uint32_t number_of_wall() {  // a file has millions
    uint32_t v = 0;
    size_t end = at;
    while (end < text.size() && end < at + 8 && text[end] >= '0' && text[end] <= '9')
      v = 10 * v + uint32_t(text[end++] - '0');
    const bool is_plain = end > at && end < at + 8 && (text[at] != '0' || end == at + 1) &&
                          end < text.size() && (text[end] == ',' || text[end] == ']');
    if (!is_plain) return uint32_t(integer_in(0, kWholeNumber));
    at = end;
    expect(v <= kWholeNumber, "the number of a wall is over 2^20");
    return v;
  }

  void model() {
    if (take_null()) return;
    object({"name", "sha256"}, [&](size_t key) {
      const std::string s = string();
      expect(key == 0 || (s.size() == 64 && s.find_first_not_of("0123456789abcdef") == s.npos),
             "sha256 has not 64 lower-case hexadecimal digits");
    });
  }

  void breaks(MicroGrid* g) {
    short_list(3, "a grid has three axes", [&](size_t axis) {
      std::vector<Ratio>& b = g->breaks[axis];
      list([&] {
        b.push_back(read_number(string()));
        expect(std::max(b.back().n.bits(), b.back().d.bits()) <= kMostKnotBits,
               "a break has numbers of more than 2048 bits");
        expect(b.size() < 2 || compare(b[b.size() - 2], b.back()) < 0, "breaks do not rise");
      });
    });
    for (const std::vector<Ratio>& b : g->breaks)
      expect(b.size() >= 2, "an axis has no two breaks");
  }
  void check_knots_of(const MicroGrid& g, size_t axis) const {
    const std::vector<Ratio>&b = g.breaks[axis], &t = out.cage[g.volume].knots[axis];
    expect(compare(t[0], b[0]) <= 0 && compare(b.back(), t.back()) <= 0,
           "a break is not in the domain");
    size_t k = 0;
    for (const Ratio& knot : t) {
      if (compare(knot, b[0]) <= 0 || compare(knot, b.back()) >= 0) continue;
      while (compare(b[k], knot) < 0) ++k;
      expect(compare(b[k], knot) == 0, "a knot inside of a grid is no break");
    }
  }
  void grid() {
    MicroGrid g;
    object({"volume", "breaks"}, [&](size_t key) {
      if (key == 0) g.volume = uint64_t(integer_in(0, int64_t(out.cage.size()) - 1));
      if (key == 1) breaks(&g);
    });
    expect(out.grids.empty() || out.grids.back().volume <= g.volume,
           "the volumes of the grids are not in ascending order");
    uint64_t cells = 1;
    for (size_t a = 0; a < 3; ++a) {
      check_knots_of(g, a);
      g.n[a] = g.breaks[a].size() - 1;
      expect(g.n[a] <= kMostMicroCells / cells, "more than 2^27 cells");
      cells *= g.n[a];
    }
    g.first_cell = out.cells;
    out.cells += cells;
    expect(out.cells <= kMostMicroCells, "more than 2^27 cells");
    out.grids.push_back(std::move(g));
  }
  void rank(size_t first, size_t last, size_t axis) {  // grids of one volume
    std::vector<std::pair<const Ratio*, size_t*>> ends;
    for (size_t g = first; g < last; ++g)
      for (size_t e = 0; e < 2; ++e) {
        const std::vector<Ratio>& b = out.grids[g].breaks[axis];
        ends.push_back(std::make_pair(e == 0 ? &b[0] : &b.back(), &out.grids[g].ends[axis][e]));
      }
    typedef const std::pair<const Ratio*, size_t*>& End;
    std::sort(ends.begin(), ends.end(),
              [](End a, End b) { return compare(*a.first, *b.first) < 0; });
    size_t rank = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
      rank += i > 0 && compare(*ends[i - 1].first, *ends[i].first) != 0;
      *ends[i].second = rank;
    }
  }
  void check_disjoint() {
    for (size_t first = 0, last = 0; first < out.grids.size(); first = last) {
      while (last < out.grids.size() && out.grids[last].volume == out.grids[first].volume) ++last;
      expect(last - first <= kMostGridsOfVolume, "more than 4096 grids of one volume");
      for (size_t axis = 0; axis < 3; ++axis) rank(first, last, axis);
      for (size_t b = first; b < last; ++b)
        for (size_t a = first; a < b; ++a)
          expect(!out.grids[a].overlaps(out.grids[b], 3), "two grids have a common inner point");
    }
  }

  void patch(MicroTile* tile) {
    MicroPatch s;
    std::vector<size_t> lengths;  // of the lists
    object({"wall", "degrees", "points"}, [&](size_t key) {
      if (key == 0 && !take_null()) s.wall = int(integer_in(0, 5));
      if (key == 1)
        short_list(2, "a patch has two degrees",
                   [&](size_t i) { (i == 0 ? s.p : s.q) = int(integer_in(1, kMostMicroDegree)); });
      if (key != 2) return;
      short_list(4, "more than four lists of points",
                 [&](size_t) { lengths.push_back(points(64, kMostCoordinateBits, &s.points)); });
    });
    expect(s.q > 0, "a patch has two degrees");
    s.lists = lengths.size();
    expect(s.lists > 0 && (s.wall >= 0 || s.lists == 1),
           "a patch has no list of points, or several and no wall");
    for (size_t n : lengths) expect(n == size_t((s.p + 1) * (s.q + 1)), "another number of points");
    if (s.wall >= 0) tile->names_wall[s.wall] = true;
    tile->patches.push_back(std::move(s));
  }
  void tile() {
    MicroTile t;
    object({"name", "range", "patches"}, [&](size_t key) {
      if (key == 0) string();
      if (key == 1 && !take_null()) {
        size_t ends = 0;
        short_list(2, "a range has two ends", [&](size_t i) {
          (i == 0 ? t.lo : t.hi) = uint32_t(integer_in(0, kWholeNumber));
          ++ends;
        });
        expect(ends == 2 && t.lo <= t.hi, "a range has no two rising ends");
        t.has_range = true;
      }
      if (key == 2)
        short_list(kMostPatches, "a tile of more than 1024 patches", [&](size_t) { patch(&t); });
    });
    expect(!t.patches.empty(), "a tile without patches");
    expect(t.has_range == (std::count(t.names_wall, t.names_wall + 6, true) > 0),
           "a range must be null if and only if no patch names a wall");
    out.tiles.push_back(std::move(t));
  }

  void cells_of_tile(MicroGrid* g, size_t tile) {
    const std::string digits = string();
    const uint64_t n = g->cells();
    expect(digits.size() == (n + 3) / 4, "another number of digits for the cells of a grid");
    if (tile == 0) g->tile.assign(size_t(n), 0);
    for (size_t i = 0; i < digits.size(); ++i) {
      const char c = digits[i];
      expect((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'),
             "not a lower-case hexadecimal digit");
      const unsigned v = unsigned(c <= '9' ? c - '0' : c - 'a' + 10);
      for (unsigned k = 0; k < 4; ++k) {
        if ((v >> (3 - k) & 1) == 0) continue;
        expect(4 * i + k < n, "a bit of a cell that does not exist");
        expect(g->tile[4 * i + k] == 0, "a cell holds two tiles");
        g->tile[4 * i + k] = uint8_t(tile + 1);
        ++out.kept;
      }
    }
  }
  void cells() {
    size_t grids = 0;
    short_list(out.grids.size(), "more lists of cells than grids", [&](size_t g) {
      size_t tiles = 0;
      short_list(out.tiles.size(), "more strings of cells than tiles", [&](size_t t) {
        cells_of_tile(&out.grids[g], t);
        ++tiles;
      });
      expect(tiles == out.tiles.size(), "fewer strings of cells than tiles");
      ++grids;
    });
    expect(grids == out.grids.size(), "fewer lists of cells than grids");
  }

  void walls() {
    bool has_range = false;
    for (const MicroTile& t : out.tiles) has_range = has_range || t.has_range;
    size_t grids = 0;
    short_list(has_range ? out.grids.size() : 0, "more lists of walls than grids", [&](size_t g) {
      size_t axes = 0;
      short_list(3, "a grid has three lists of walls", [&](size_t a) {
        numbers_of_walls(&out.grids[g], a);
        ++axes;
      });
      expect(axes == 3, "a grid has three lists of walls");
      ++grids;
    });
    expect(!has_range || grids == out.grids.size(), "fewer lists of walls than grids");
  }
  void numbers_of_walls(MicroGrid* g, size_t axis) {
    std::vector<uint32_t>& v = g->of_walls[axis];
    const uint64_t n = g->cells() / g->n[axis] * (g->n[axis] + 1);
    list([&] {
      expect(v.size() < n, "more numbers than walls");
      v.push_back(number_of_wall());
    });
    expect(v.size() == n, "fewer numbers than walls");
    v.shrink_to_fit();
    size_t stride = 1;  // of cells and of walls, along the axis
    for (size_t a = axis + 1; a < 3; ++a) stride *= g->n[a];
    for (size_t w = 0; w < n; ++w) {
      if (v[w] == 0) continue;
      const size_t block = w / stride, layer = block % (g->n[axis] + 1);
      const size_t after = (block - block / (g->n[axis] + 1)) * stride + w % stride;
      const bool is_held = (layer < g->n[axis] && g->tile[after] != 0) ||
                           (layer > 0 && g->tile[after - stride] != 0);
      expect(is_held, "a wall between cells without tiles has a number that is not 0");
    }
  }

  void file() {
    size_t expected = 0;
    const auto member = [&](size_t key) {
      expect(key == expected || (key > expected && expected >= 7),
             "a key is missing, or the keys of the file are in another order");
      expected = key + 1;
      if (key == 0) expect(string() == "veritope-micro-1", "unknown format");
      if (key == 1) model();
      if (key == 2) {
        next();
        out.cage = volumes_in_space(read_json_part(text, true, &at));
        expect(out.cage.size() <= kMostVolumes, "more than 65536 volumes");
      }
      if (key == 3) {
        short_list(kMostGrids, "more than 65536 grids", [&](size_t) { grid(); });
        check_disjoint();
      }
      if (key == 4) {
        short_list(kMostTiles, "more than 15 tiles", [&](size_t) { tile(); });
        expect(!out.tiles.empty(), "no tile");
      }
      if (key == 5) cells();
      if (key == 6) walls();
      if (key == 7) bridges();
      if (key == 8) sweeps();
      if (key == 9) materials();
    };
    object({"format", "model", "cage", "grids", "tiles", "cells", "walls", "bridges", "sweeps",
            "materials"},
           member, 3);
    expect(next() == '\0' && at == text.size(), "something follows the file's object");
  }
};

}  // namespace

MicroFile read_micro(const std::string& text) {
  size_t at = begin_of_text(text);
  try {
    MicroReader reader(text, &at);
    reader.file();
    return std::move(reader.out);
  } catch (const Refused& r) {
    throw Refused{"byte " + std::to_string(at) + ": " + r.why};
  }
}
