// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_faces.cc: which faces are equal, and which cells are near a point: docs/certificates/vmodel-invalid.md,
// section 4.
#include "vmodel_invalid.h"

namespace {

SpacePoint control_point(const Entity& e, uint64_t i) {
  SpacePoint r;
  for (size_t c = 0; c < 3; ++c) {
    r.x[c] = e.number(i, c);
    if (!e.is_rational) continue;
    const Ratio& w = e.number(i, 3);
    r.x[c] = Ratio(r.x[c].n * w.d, r.x[c].d * w.n);
  }
  return r;
}

// A number that may be long, between two short ones.
struct Bracket {
  const Ratio x;
  Ratio low, high;

  explicit Bracket(const Ratio& number) : x(number) {
    const int64_t up = 128 - (x.n.bits() - x.d.bits());
    const Big q = divide(shifted(x.n, std::max<int64_t>(up, 0)),
                         shifted(x.d, std::max<int64_t>(-up, 0)), nullptr);
    low = scaled(Ratio(q - Big(1)), -up), high = scaled(Ratio(q + Big(1)), -up);
  }
  int compared_with(const Ratio& y) const {
    return compare(y, low) < 0 ? 1 : compare(high, y) < 0 ? -1 : compare(x, y);
  }
};
bool is_near(const Entity& e, const std::vector<Bracket>& x) {
  bool above[3] = {}, below[3] = {};  // whether a control point is not lower, not higher
  for (uint64_t i = 0; i < e.places.size(); ++i) {
    const SpacePoint p = control_point(e, i);
    bool is_done = true;
    for (size_t c = 0; c < 3; ++c) {
      const int sign = above[c] && below[c] ? 0 : x[c].compared_with(p.x[c]);
      above[c] = above[c] || sign <= 0, below[c] = below[c] || sign >= 0;
      is_done = is_done && above[c] && below[c];
    }
    if (is_done) return true;
  }
  return false;
}

// Where an axis of f and one of g, brought to [0, 1], are cut by the knots of both.
struct CommonBreaks {
  std::vector<Ratio> of_f, of_g;  // both rise

  CommonBreaks(const std::vector<Ratio>& f, const std::vector<Ratio>& g, bool is_reversed) {
    const Ratio all_f = f.back() - f.front(), all_g = g.back() - g.front();
    size_t j = 0;
    for (size_t i = 0; i < f.size(); ++i) {  // in the direction of g
      const Ratio& t = f[is_reversed ? f.size() - 1 - i : i];
      const Ratio x = is_reversed ? f.back() - t : t - f.front();
      int sign = 1;
      for (;; ++j) {
        const Ratio y = g[j] - g.front();
        sign = compare(x.n * y.d * all_f.d * all_g.n, y.n * x.d * all_g.d * all_f.n);
        if (sign <= 0) break;  // at the last knots at the latest
        add(is_reversed ? moved_by(f.back(), y, all_f, all_g, -1)
                        : moved_by(f.front(), y, all_f, all_g, 1),
            g[j]);
      }
      add(t, sign == 0 ? g[j] : moved_by(g.front(), x, all_g, all_f, 1));
      j += sign == 0;
    }
    if (is_reversed) std::reverse(of_f.begin(), of_f.end());
  }

 private:
  // from + sign x all / of
  static Ratio moved_by(const Ratio& from, const Ratio& x, const Ratio& all, const Ratio& of,
                        int sign) {
    const Ratio step(Big(-sign) * x.n * all.n * of.d, x.d * all.d * of.n);
    return from - step;
  }
  void add(const Ratio& f, const Ratio& g) { of_f.push_back(f), of_g.push_back(g); }
};

// Whether the homogeneous maps agree on all products between common breaks.
bool have_equal_maps(const CellFace& f, const CellFace& g, unsigned symmetry, Units* units) {
  VCell cells[2] = {VCell(), VCell()};
  const CellFace* const faces[2] = {&f, &g};
  Place3 place[2];
  for (int i = 0; i < 2; ++i) {
    cells[i].volume = faces[i]->cell->volume;
    for (int& end : place[i].end) end = -1;
    place[i].end[faces[i]->number / 2] = int(faces[i]->number % 2);
  }
  size_t of_f[2], of_g[2];  // axes, in the order of the parameters of g
  for (size_t k = 0; k < 2; ++k) {
    of_f[k] = other_axis(f.number / 2, (symmetry & 1) != 0 ? 1 - k : k);
    of_g[k] = other_axis(g.number / 2, k);
    CommonBreaks both(f.cell->breaks[of_f[k]], g.cell->breaks[of_g[k]],
                      (symmetry >> (k + 1) & 1) != 0);
    cells[0].breaks[of_f[k]] = std::move(both.of_f);
    cells[1].breaks[of_g[k]] = std::move(both.of_g);
  }
  PieceCutter cut_f(cells[0], place[0], units), cut_g(cells[1], place[1], units);
  size_t n[2], i[2];
  for (size_t k = 0; k < 2; ++k) n[k] = cut_g.intervals(of_g[k]);
  for (i[0] = 0; i[0] < n[0]; ++i[0])
    for (i[1] = 0; i[1] < n[1]; ++i[1]) {
      size_t at_f[3] = {0, 0, 0}, at_g[3] = {0, 0, 0};
      for (size_t k = 0; k < 2; ++k) {
        at_f[of_f[k]] = (symmetry >> (k + 1) & 1) != 0 ? n[k] - 1 - i[k] : i[k];
        at_g[of_g[k]] = i[k];
      }
      const VPiece p = cut_f.cut(at_f[0], at_f[1], at_f[2]),
                   q = cut_g.cut(at_g[0], at_g[1], at_g[2]);
      if (face_key(p, f.number / 2, false, symmetry) != face_key(q, g.number / 2, false, 0))
        return false;
    }
  return true;
}
bool have_equal_corners(const CellFace& f, const CellFace& g, unsigned symmetry) {
  for (size_t a = 0; a < 2; ++a)
    for (size_t b = 0; b < 2; ++b) {
      const std::pair<size_t, size_t> to = moved(a, b, 2, 2, symmetry);
      const size_t p = f.corners[corner_of(f.number, a, b)];
      if (p != g.corners[corner_of(g.number, to.first, to.second)]) return false;
    }
  return true;
}

}  // namespace

SpacePoint corner_point(const Entity& e, size_t corner) {
  uint64_t at = 0;
  for (size_t a = 0; a < 3; ++a)
    at = at * e.points_along(a) + (corner >> a & 1) * (e.points_along(a) - 1);
  return control_point(e, at);
}
int compare(const SpacePoint& a, const SpacePoint& b) {
  int sign = 0;
  for (size_t c = 0; c < 3 && sign == 0; ++c) sign = compare(a.x[c], b.x[c]);
  return sign;
}
void check_cells_near(const SpacePoint& x, InvalidModel* model) {
  std::vector<Bracket> brackets;
  for (const Ratio& c : x.x) brackets.push_back(Bracket(c));
  for (const Entity& e : model->volumes) {
    if (!is_near(e, brackets)) continue;
    const VCell cell = cell_of(e);
    cut_pieces(cell, &model->units, [&](const VPiece& piece) { check_edges(cell, piece); });
  }
}

const size_t PointNumbers::kNone;
PointNumbers::PointNumbers(std::vector<SpacePoint> points) : points_(std::move(points)) {
  std::sort(points_.begin(), points_.end(),
            [](const SpacePoint& a, const SpacePoint& b) { return compare(a, b) < 0; });
}
size_t PointNumbers::operator[](const SpacePoint& p) const {
  const auto at =
      std::lower_bound(points_.begin(), points_.end(), p,
                       [](const SpacePoint& a, const SpacePoint& b) { return compare(a, b) < 0; });
  return at != points_.end() && compare(*at, p) == 0 ? size_t(at - points_.begin()) : kNone;
}

bool may_be_equal(const CellFace& f, const CellFace& g) {
  for (unsigned s = 0; s < 8; ++s)
    if (have_equal_corners(f, g, s)) return true;
  return false;
}
int equal_under(const CellFace& f, const CellFace& g, Units* units) {
  for (unsigned s = 0; s < 8; ++s)
    if (have_equal_corners(f, g, s) && have_equal_maps(f, g, s, units)) return int(s);
  return -1;
}
