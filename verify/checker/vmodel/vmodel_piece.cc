// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_piece.cc: the Bernstein coefficients of pieces, and V1 of docs/certificates/vmodel.md.
#include "../patches/star_extraction.h"
#include "vmodel.h"

namespace {

const int64_t kMostPieceSize = 1 << 24;

struct Window {  // the control points of a box of knots, and what makes them coefficients
  const AxisInterval* axis[3];
};

uint64_t longest(const std::vector<Big>& v) {
  int64_t bits = 0;
  for (const Big& x : v) bits = std::max(bits, x.bits());
  return uint64_t(bits);
}

bool is_identity(const std::vector<std::vector<Big>>& matrix) {
  for (size_t i = 0; i < matrix.size(); ++i)
    for (size_t j = 0; j < matrix.size(); ++j)
      if (!(matrix[i][j] == Big(i == j))) return false;
  return true;
}
// The matrix times each line of the net along the axis.
void apply(const std::vector<std::vector<Big>>& matrix, size_t axis, const size_t* n,
           std::vector<Big>* net) {
  size_t stride = 4;
  for (size_t a = axis + 1; a < 3; ++a) stride *= n[a];
  std::vector<Big> line(n[axis]);
  for (size_t block = 0; block < net->size(); block += stride * n[axis])
    for (size_t start = block; start < block + stride; ++start) {
      for (size_t k = 0; k < n[axis]; ++k) line[k] = (*net)[start + k * stride];
      for (size_t k = 0; k < n[axis]; ++k) {
        Big sum;
        for (size_t j = 0; j < n[axis]; ++j)
          if (matrix[k][j].sign() != 0) sum = sum + matrix[k][j] * line[j];
        (*net)[start + k * stride] = sum;
      }
    }
}
std::vector<Big> control_points(const Entity& e, const Window& w, const size_t* n) {
  std::vector<Ratio> r;
  r.reserve(4 * n[0] * n[1] * n[2]);
  for (size_t i = 0; i < n[0]; ++i)
    for (size_t j = 0; j < n[1]; ++j)
      for (size_t k = 0; k < n[2]; ++k) {
        const uint64_t at =
            ((w.axis[0]->made.first + i) * e.points_along(1) + w.axis[1]->made.first + j) *
                e.points_along(2) +
            w.axis[2]->made.first + k;
        for (size_t c = 0; c < 4; ++c)
          r.push_back(c < 3 || e.is_rational ? e.number(at, c) : Ratio(Big(1)));
      }
  return integers_of(r, kMostBits);
}
void divide_by_common(std::vector<Big>* v) {
  Big common;
  for (size_t i = v->size(); i-- > 0 && !common.is_one();) common = gcd(common, (*v)[i]);
  if (common.is_one()) return;
  for (Big& x : *v) x = divide(x, common, nullptr);
}

// B2.
AxisInterval interval_of(const Entity& e, size_t axis, const Ratio& a, const Ratio& b,
                         Units* units) {
  const uint64_t p = uint64_t(e.degrees[axis]);
  const KnotWindow window = knot_window(e.knots[axis], size_t(p), a, b);
  const uint64_t t = longest(window.from_begin);
  units->id = "B2";
  units->add(1 + p * p * p * (64 + p * p * p * t * t / 8192) / 32);
  AxisInterval r = {extraction(window), false, false, t};
  r.is_unit = is_identity(r.made.matrix);
  return r;
}
// An axis across a face: its first or its last control points, with the degree 0.
AxisInterval fixed_axis(const Entity& e, size_t axis, bool at_end) {
  AxisInterval r = {{at_end ? size_t(e.points_along(axis)) - 1 : 0, {}}, true, true, 0};
  r.made.matrix.assign(1, std::vector<Big>(1, Big(1)));
  return r;
}
// The units of the products that make the control points coefficients; bits: of the longest of them.
uint64_t of_products(const Window& w, const VPiece& piece, uint64_t bits) {
  uint64_t sum = 0;
  for (size_t a = 0; a < 3; ++a) {
    if (w.axis[a]->is_fixed) continue;
    const uint64_t n = uint64_t(piece.n[a]), longer = n * (n - 1) * w.axis[a]->bits;  // p (p + 1) t
    sum += uint64_t(piece.count()) * n * (32 + (1 + longer / 128) * (1 + bits / 64)) / 32;
    bits += longer / 2;
  }
  return sum;
}

// Whether the homogeneous points are equal as points.
template <class Point>  // point(i) is the i-th one's first coordinate
bool are_one_point(size_t count, Point point) {
  const Big* const first = point(0);
  for (size_t i = 1; i < count; ++i) {
    const Big* const p = point(i);
    for (size_t c = 0; c < 3; ++c)
      if (!(p[c] * first[3] == first[c] * p[3])) return false;
  }
  return true;
}

// The control points of a cell, each in integers up to a positive factor of its own.
class ControlPoints {
 public:
  explicit ControlPoints(const Entity& e) : e_(e) {}
  // Q_a w_b = Q_c w_d.
  bool are_equal(uint64_t a, uint64_t b, uint64_t c, uint64_t d) const {
    for (size_t k = 0; k < 4; ++k) {
      const Ratio &p = number(a, k), &q = number(b, 3), &r = number(c, k), &s = number(d, 3);
      if (&p == &r && &q == &s) continue;
      if (!(p.n * q.n * r.d * s.d == r.n * s.n * p.d * q.d)) return false;
    }
    return true;
  }

 private:
  const Ratio& number(uint64_t point, size_t component) const {
    return component < size_t(e_.components) ? e_.number(point, component) : one_;
  }
  const Entity& e_;
  const Ratio one_ = Ratio(Big(1));
};

struct CellGrid {
  explicit CellGrid(const Entity& volume) : points(volume) {
    for (size_t a = 0; a < 3; ++a) n[a] = volume.points_along(a);
  }
  ControlPoints points;
  uint64_t n[3];
  uint64_t at(const uint64_t* i) const { return (i[0] * n[1] + i[1]) * n[2] + i[2]; }

  bool is_edge_collapsed(size_t axis, size_t e, size_t f) const {
    uint64_t i[3];
    i[axis] = 0;
    i[other_axis(axis, 0)] = e == 0 ? 0 : n[other_axis(axis, 0)] - 1;
    i[other_axis(axis, 1)] = f == 0 ? 0 : n[other_axis(axis, 1)] - 1;
    const uint64_t first = at(i);
    for (; i[axis] < n[axis]; ++i[axis])
      if (!points.are_equal(at(i), first, first, at(i))) return false;
    return true;
  }
  Collapse collapse(size_t axis, bool at_end) const {
    const size_t p = other_axis(axis, 0), q = other_axis(axis, 1);
    bool is_point = true, is_first = true, is_second = true;
    uint64_t i[3];
    i[axis] = at_end ? n[axis] - 1 : 0;
    i[p] = 0, i[q] = 0;
    const uint64_t corner = at(i);
    for (i[p] = 0; i[p] < n[p]; ++i[p])
      for (i[q] = 0; i[q] < n[q] && (is_point || is_first || is_second); ++i[q]) {
        uint64_t low_p[3] = {i[0], i[1], i[2]}, low_q[3] = {i[0], i[1], i[2]};
        low_p[p] = 0, low_q[q] = 0;
        const uint64_t here = at(i), at_p = at(low_p), at_q = at(low_q);
        is_point = is_point && points.are_equal(here, corner, corner, here);
        is_first = is_first && points.are_equal(here, corner, at_p, at_q);
        is_second = is_second && points.are_equal(here, corner, at_q, at_p);
      }
    return is_point    ? Collapse::kPoint
           : is_first  ? Collapse::kFirst
           : is_second ? Collapse::kSecond
                       : Collapse::kNone;
  }
};

}  // namespace

const Place3 kWholeCell = {{-1, -1, -1}};

PieceCutter::PieceCutter(const VCell& cell, const Place3& place, Units* units)
    : volume_(*cell.volume), units_(*units) {
  for (size_t a = 0; a < 3; ++a) {
    if (place.end[a] >= 0) axes_[a].push_back(fixed_axis(volume_, a, place.end[a] != 0));
    for (size_t i = 0; i < cell.intervals(a) && place.end[a] < 0; ++i)
      axes_[a].push_back(interval_of(volume_, a, cell.breaks[a][i], cell.breaks[a][i + 1], units));
  }
}
VPiece PieceCutter::cut(size_t i, size_t j, size_t k) {
  VPiece piece = {{i, j, k}, {}, {}, 0, volume_.is_rational};
  Window w;
  bool is_whole = true, is_changed = false;
  size_t of_n = 1;
  for (size_t a = 0; a < 3; ++a) {
    w.axis[a] = &axes_[a][piece.index[a]];
    piece.n[a] = w.axis[a]->made.matrix.size();
    is_whole = is_whole && !w.axis[a]->is_fixed;
    of_n *= (piece.is_rational ? 4 : 3) * (piece.n[a] - 1);
  }
  piece.net = control_points(volume_, w, piece.n);
  units_.id = "B2";
  units_.add(of_products(w, piece, longest(piece.net)));
  for (size_t a = 0; a < 3; ++a)
    if (!w.axis[a]->is_unit)
      apply(w.axis[a]->made.matrix, a, piece.n, &piece.net), is_changed = true;
  if (is_changed) divide_by_common(&piece.net);
  piece.bits = int64_t(longest(piece.net));
  require(!is_whole || int64_t(of_n) * piece.bits <= kMostPieceSize, "B2",
          "the coefficients of a piece are too long for its degrees, bits", uint64_t(piece.bits));
  units_.add(2 + uint64_t(piece.count() * piece.degrees()) * uint64_t(piece.bits) / 4096);
  return piece;
}

void cut_pieces(const VCell& cell, Units* units, const std::function<void(const VPiece&)>& use) {
  PieceCutter cutter(cell, kWholeCell, units);
  for (size_t i = 0; i < cutter.intervals(0); ++i)
    for (size_t j = 0; j < cutter.intervals(1); ++j)
      for (size_t k = 0; k < cutter.intervals(2); ++k) use(cutter.cut(i, j, k));
}

void find_collapses(VCell* cell) {
  const CellGrid grid(*cell->volume);
  for (size_t f = 0; f < 6; ++f) cell->faces[f] = grid.collapse(f / 2, f % 2 != 0);
  for (size_t edge = 0; edge < 12; ++edge)
    cell->edges[edge] = grid.is_edge_collapsed(edge / 4, edge % 2, edge / 2 % 2);
}

void check_edges(const VCell& cell, const VPiece& p) {
  for (size_t edge = 0; edge < 12; ++edge) {
    const size_t axis = edge / 4, ends[2] = {edge % 2, edge / 2 % 2};
    size_t i[3] = {0, 0, 0};
    bool is_allowed = false, is_in_edge = true;
    for (size_t which = 0; which < 2; ++which) {
      const size_t a = other_axis(axis, which);
      i[a] = ends[which] * (p.n[a] - 1);
      if (p.index[a] != ends[which] * (cell.intervals(a) - 1)) {
        is_in_edge = false;
        continue;
      }
      const Collapse c = cell.faces[2 * a + ends[which]];
      const bool is_first = other_axis(a, 0) == axis;
      is_allowed = is_allowed || c == Collapse::kPoint ||
                   c == (is_first ? Collapse::kFirst : Collapse::kSecond);
    }
    if (is_allowed || (is_in_edge && cell.edges[edge])) continue;
    require(!are_one_point(p.n[axis],
                           [&](size_t k) {
                             size_t at[3] = {i[0], i[1], i[2]};
                             at[axis] = k;
                             return &p.net[p.at(at[0], at[1], at[2])];
                           }),
            "V1", "an edge of a piece is collapsed, along axis", axis);
  }
}
