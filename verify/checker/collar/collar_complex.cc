// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar_complex.cc: the common subdivision of docs/certificates/collar.md, section 3, and K0.
#include "collar.h"

namespace {

const uint64_t kPlane = uint64_t(1) << (2 * kDepth + 1);  // codes of squares are less

// A face of a cell: plane, then the code of its square, made like those of cells.
struct Item {
  uint64_t code;
  uint32_t cell;
  bool is_below;  // the cell is below the plane
};
bool operator<(const Item& a, const Item& b) { return a.code < b.code; }

// Splits the squares of one plane into faces. items: the faces of cells in the plane, by code.
struct Squares {
  std::vector<Item> items;
  int axis;
  uint32_t plane;
  std::vector<Face>* faces;

  void emit(uint32_t b, uint32_t c, uint32_t size, const uint32_t* cover) const {
    require(faces->size() < kMostFaces, "K0", "over a limit of this checker: 2^26 faces");
    uint32_t x[3];
    x[axis] = plane, x[(axis + 1) % 3] = b, x[(axis + 2) % 3] = c;
    faces->push_back(
        Face{3 * point_key(x) + uint64_t(axis), {cover[0], cover[1]}, {size, 0, 0, 0}});
  }
  // The square with this code, size and least corner. Its faces are among the items lo, ..., hi - 1, all of which lie
  // in it; `cover` holds the cells above and below it.
  void split(size_t lo, size_t hi, uint64_t code, uint32_t size, uint32_t b, uint32_t c,
             const uint32_t* cover) const {
    uint32_t own[2] = {cover[0], cover[1]};
    const auto first = items.begin();
    const auto of = [&](uint64_t at) {
      return size_t(std::lower_bound(first + int64_t(lo), first + int64_t(hi), Item{at, 0, false}) -
                    first);
    };
    const size_t begin = of(code);
    size_t end = begin;
    for (; end < hi && items[end].code == code; ++end)
      own[items[end].is_below ? 0 : 1] = items[end].cell;
    if (hi - lo == end - begin) {
      if (own[0] != kNone || own[1] != kNone) emit(b, c, size, own);
      return;
    }
    const uint64_t half = uint64_t(size) * size;
    const size_t bounds[6] = {lo, of(code - half / 2), begin, end, of(code + half / 2), hi};
    for (uint32_t q = 0; q < 4; ++q)
      split(bounds[q + q / 2], bounds[q + q / 2 + 1], code + q * half / 2 - 3 * half / 4, size / 2,
            b + (q & 1) * (size / 2), c + (q >> 1) * (size / 2), own);
  }
};

}  // namespace

Cell cell_of(uint64_t code) {
  const int up = __builtin_ctzll(code) / 3;
  const uint64_t morton = code >> (3 * up + 1);
  Cell r = {{0, 0, 0}, uint32_t(1) << up};
  for (int bit = 0; bit < kDepth; ++bit)
    for (int k = 0; k < 3; ++k) r.low[k] |= uint32_t(morton >> (3 * bit + k) & 1) << bit;
  for (int k = 0; k < 3; ++k) r.low[k] <<= up;
  return r;
}

Complex::Complex(const CollarBody& body) {
  const uint64_t cells = body.differences.size();
  require(cells <= kMostCells, "K0", "over 2^24 cells:", cells);
  uint64_t code = 0, end = 0;  // end: of the codes inside the previous cell
  for (uint64_t i = 0; i < cells; ++i) {
    require(body.differences[i] < uint64_t(1) << 61, "K0", "no code of a cell, cell", i);
    code += body.differences[i];
    require(code < uint64_t(1) << 61 && __builtin_ctzll(code) % 3 == 0, "K0",
            "no code of a cell, cell", i);
    const uint64_t half = code & -code;
    require(code - half >= end, "K0", "cells lie inside one another, one is", i);
    end = code + half;
    codes.push_back(code);
  }
  for (int axis = 0; axis < 3; ++axis) add_faces(axis);
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.key < b.key; });
  add_vertices();
  add_edges();
}

// The squares of a plane: a square is split iff smaller ones lie in it.
void Complex::add_faces(int axis) {
  Squares s = {{}, axis, 0, &faces};
  s.items.reserve(2 * codes.size());
  for (uint32_t i = 0; i < codes.size(); ++i) {
    const Cell cell = cell_of(codes[i]);
    uint64_t code = uint64_t(cell.size) * cell.size;
    for (int bit = 0; bit < kDepth; ++bit)
      for (int k = 0; k < 2; ++k)
        code |= uint64_t(cell.low[(axis + 1 + k) % 3] >> bit & 1) << (2 * bit + k + 1);
    for (int high = 0; high < 2; ++high)
      s.items.push_back(
          Item{(cell.low[axis] + uint32_t(high) * cell.size) * kPlane + code, i, high != 0});
  }
  std::sort(s.items.begin(), s.items.end());
  const uint32_t none[2] = {kNone, kNone};
  for (size_t lo = 0, hi; lo < s.items.size(); lo = hi) {
    s.plane = uint32_t(s.items[lo].code / kPlane);
    for (hi = lo; hi < s.items.size() && s.items[hi].code / kPlane == s.plane;) ++hi;
    s.split(lo, hi, s.plane * kPlane + kPlane / 2, uint32_t(kRootEdge), 0, 0, none);
  }
}

// The corners of the faces. Faces of one axis and size meet each of their four corners in the order
// of the vertices, so one pointer for each of these rows suffices to merge them.
void Complex::add_vertices() {
  const auto corner = [](const Face& f, uint32_t size, int c) {
    uint32_t x[3];
    point_of(f.key / 3, x);
    x[(f.axis() + 1) % 3] += (c & 1) != 0 ? size : 0;
    x[(f.axis() + 2) % 3] += (c & 2) != 0 ? size : 0;
    return point_key(x);
  };
  vertices.reserve(4 * faces.size());
  for (const Face& f : faces)
    for (int c = 0; c < 4; ++c) vertices.push_back(corner(f, f.corner[0], c));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  vertices.shrink_to_fit();
  std::vector<size_t> finger(3 * (kDepth + 1) * 4);
  for (Face& f : faces) {
    const uint32_t size = f.corner[0];
    for (int c = 0; c < 4; ++c) {
      const uint64_t key = corner(f, size, c);
      size_t& at = finger[size_t((f.axis() * (kDepth + 1) + __builtin_ctz(size)) * 4 + c)];
      size_t step = 1;
      for (; at + step < vertices.size() && vertices[at + step] <= key; step *= 2) at += step;
      for (; step > 0; step /= 2)
        if (at + step < vertices.size() && vertices[at + step] <= key) at += step;
      f.corner[c] = uint32_t(at);
    }
  }
}

void Complex::add_edges() {
  const uint32_t n = uint32_t(vertices.size());
  for (int d = 0; d < 3; ++d) {
    std::vector<std::pair<uint64_t, uint32_t>> by_line(n);
    for (uint32_t v = 0; v < n; ++v) {
      uint32_t x[3];
      point_of(vertices[v], x);
      std::swap(x[0], x[d]);  // the axis itself is the least significant
      by_line[v] = std::make_pair(point_key(x), v);
    }
    if (d > 0) std::sort(by_line.begin(), by_line.end());
    order[d].resize(n), place[d].resize(n);
    for (uint32_t i = 0; i < n; ++i) place[d][order[d][i] = by_line[i].second] = i;
    around[d].assign(n, Around{{kNone, kNone, kNone, kNone}});
  }
  for (uint32_t f = 0; f < faces.size(); ++f)
    each_edge(faces[f], [&](int d, uint32_t i, int slot) { around[d][i].face[slot] = f; });
}
