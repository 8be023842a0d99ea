// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/boolean_sum.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace veritope {
namespace {

// The place of axis b among the two axes of a face across a.
std::size_t place_in(std::size_t a, std::size_t b) { return b < a ? b : b - 1; }

std::string short_number(const Rational& x) {
  if (std::string exact = x.to_string(); exact.size() <= 24) return exact;
  char text[40];
  std::snprintf(text, sizeof text, "about %.6g", nearest_double(x));
  return text;
}

// The largest difference of a coordinate of two control points.
Rational largest_difference(const CellCurve& a, const CellCurve& b) {
  Rational most;
  for (int c = 0; c < a.dimension(); ++c)
    for (std::size_t i = 0; i < a.grid().count(); ++i) {
      Rational x = a.component(c)[i], y = b.component(c)[i];
      if (a.is_rational()) {
        x /= a.component(a.dimension())[i];
        y /= b.component(b.dimension())[i];
      }
      most = std::max(most, abs(x - y));
    }
  return most;
}

class Sum {
 public:
  explicit Sum(SixFaces faces) : faces_(std::move(faces)) {}

  Result<CellVolume> compute() {
    for (const CellSurface& face : faces_)
      if (const Status in = check_cell_surface(face); !in) return in.error();
    if (const Status done = to_one_space(); !done) return done.error();
    if (const Status done = to_equal_edges(); !done) return done.error();
    return with_positive_weights(sum());
  }

 private:
  const CellSurface& face(std::size_t axis, std::size_t end) const {
    return faces_[2 * axis + end];
  }

  Status to_one_space() {
    bool is_rational = false;
    for (std::size_t f = 0; f < 6; ++f) {
      is_rational |= faces_[f].is_rational();
      if (faces_[f].dimension() != faces_[0].dimension())
        return bad_argument("faces u0 and " + std::string(face_name(f)) +
                            " have different numbers of coordinates");
    }
    for (std::size_t a = 0; a < 3; ++a) {
      std::vector<KnotAxis<Rational>> all;
      for (std::size_t b = 0; b < 3; ++b)
        for (std::size_t end = 0; end < 2; ++end)
          if (b != a) all.push_back(face(b, end).axis(place_in(b, a)));
      axes_[a] = internal::common_axis(all);
      if (const Status fits = internal::check_degree(axes_[a].degree); !fits) return fits;
      grid_.size[a] = axes_[a].num_control();
    }
    const auto components = static_cast<std::size_t>(faces_[0].dimension()) + (is_rational ? 1 : 0);
    if (!grid_.count_up_to(kMaxCellNumbers / components))
      return Error{Code::kOverLimit,
                   {},
                   "the common knots of the faces need more than " +
                       std::to_string(kMaxCellNumbers) + " coefficients"};
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t end = 0; end < 2; ++end) {
        CellSurface& f = faces_[2 * b + end];
        if (is_rational) f = homogeneous(f);
        for (std::size_t a = 0; a < 3; ++a)
          if (a != b) f = internal::brought_to(std::move(f), place_in(b, a), axes_[a]);
      }
    return ok_status();
  }

  CellCurve edge(std::size_t a, std::size_t i, std::size_t b, std::size_t j) const {
    return side_of(face(a, i), place_in(a, b), j);
  }

  // Scales the faces to u0, and u1, which meets u0 in no edge, to v0. The quotient of two faces along their edge is a
  // constant, which is that of their weights at both of its ends. So the quotients around a corner multiply to 1, and
  // around every other cycle of faces, too, since those of corners generate them all: every edge is equal then.
  Status to_equal_edges() {
    for (std::size_t f = 0; f < 6; ++f)
      for (std::size_t g = f - f % 2 + 2; g < 6; ++g)
        if (!factor_along(f, g)) return refuse(f, g);
    for (const std::size_t g : {2, 3, 4, 5, 1}) {
      const Rational factor = *factor_along(g == 1 ? 2 : 0, g);
      for (Rational& x : faces_[g].coefficients()) x *= factor;
    }
    return ok_status();
  }

  CellCurve edge_of(std::size_t f, std::size_t g) const { return edge(f / 2, f % 2, g / 2, g % 2); }
  std::optional<Rational> factor_along(std::size_t f, std::size_t g) const {
    return internal::factor_between(edge_of(f, g), edge_of(g, f));
  }

  static std::string edge_name(std::size_t f, std::size_t g) {
    return std::string(face_name(std::min(f, g))) + face_name(std::max(f, g));
  }
  static std::string faces_along(std::size_t f, std::size_t g) {
    return std::string("faces ") + face_name(std::min(f, g)) + " and " + face_name(std::max(f, g));
  }
  Error refuse(std::size_t f, std::size_t g) const {
    const Rational most = largest_difference(edge_of(f, g), edge_of(g, f));
    std::string text = faces_along(f, g) + " differ along the edge " + edge_name(f, g);
    text += most.sign() == Sign::kZero
                ? ": their control points are equal, their weights are not proportional"
                : ": their control points in one function space are up to " + short_number(most) +
                      " apart in a coordinate";
    return bad_argument(text);
  }
  CellVolume sum() const {
    std::array<std::vector<Rational>, 3> parts;  // of end 1; that of end 0 is what is left to 1
    for (std::size_t a = 0; a < 3; ++a) parts[a] = internal::rising(axes_[a]);
    const int components = faces_[0].num_components();
    std::vector<Rational> all;
    all.reserve(grid_.count() * static_cast<std::size_t>(components));
    for (int c = 0; c < components; ++c)
      for (std::size_t n = 0; n < grid_.count(); ++n) {
        const auto at = grid_.index_of(n);
        std::array<std::array<Rational, 2>, 3> share;
        for (std::size_t a = 0; a < 3; ++a)
          share[a] = {Rational(1) - parts[a][at[a]], parts[a][at[a]]};
        all.push_back(value(c, at, share));
      }
    return CellVolume(axes_, components, faces_[0].is_rational(), std::move(all));
  }

  // The coefficient of the face across `axis` at an index of the volume.
  const Rational& on_face(int c, std::size_t axis, std::size_t end,
                          const std::array<std::size_t, 3>& at) const {
    const CellSurface& f = face(axis, end);
    const std::size_t i = axis == 0 ? 1 : 0, j = axis == 2 ? 1 : 2;
    return f.component(c)[f.grid().at({at[i], at[j]})];
  }

  Rational value(int c, const std::array<std::size_t, 3>& at,
                 const std::array<std::array<Rational, 2>, 3>& share) const {
    Rational sum;
    const auto end_of = [&](std::size_t a, std::size_t end) {
      return end == 0 ? std::size_t{0} : grid_.size[a] - 1;
    };
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t i = 0; i < 2; ++i) {
        if (share[a][i].sign() == Sign::kZero) continue;
        Rational inner = on_face(c, a, i, at);  // minus the edges with later axes, plus corners
        for (std::size_t b = a + 1; b < 3; ++b)
          for (std::size_t j = 0; j < 2; ++j) {
            auto edge = at;
            edge[b] = end_of(b, j);
            inner -= share[b][j] * on_face(c, a, i, edge);
          }
        if (a == 0)
          for (std::size_t j = 0; j < 4; ++j)
            inner += share[1][j / 2] * share[2][j % 2] *
                     on_face(c, 0, i, {at[0], end_of(1, j / 2), end_of(2, j % 2)});
        sum += share[a][i] * inner;
      }
    return sum;
  }

  SixFaces faces_;
  std::array<KnotAxis<Rational>, 3> axes_;
  Grid<3> grid_;
};

}  // namespace

const char* face_name(std::size_t face) {
  constexpr std::array<const char*, 6> kNames = {"u0", "u1", "v0", "v1", "w0", "w1"};
  return kNames[face];
}

Result<CellVolume> boolean_sum(SixFaces faces) { return Sum(std::move(faces)).compute(); }

Result<CellSurface> boolean_sum(std::array<CellCurve, 4> sides) {
  auto along_u = in_one_space<1>({std::move(sides[0]), std::move(sides[1])}),
       along_v = in_one_space<1>({std::move(sides[2]), std::move(sides[3])});
  if (!along_u || !along_v) return (along_u ? along_v : along_u).error();
  for (auto* pair : {&*along_u, &*along_v})
    for (CellCurve& curve : *pair)
      if ((*along_u)[0].is_rational() || (*along_v)[0].is_rational()) curve = homogeneous(curve);
  const auto &u = *along_u, &v = *along_v;
  const KnotAxis<Rational>&axis_u = u[0].axis(0), &axis_v = v[0].axis(0);
  const std::size_t n = axis_u.num_control(), m = axis_v.num_control();
  const auto at_u = internal::rising(axis_u), at_v = internal::rising(axis_v);
  std::vector<Rational> all;
  for (int c = 0; c < u[0].num_components(); ++c) {
    const auto a = u[0].component(c), b = u[1].component(c), l = v[0].component(c),
               r = v[1].component(c);
    if (a[0] != l[0] || a[n - 1] != r[0] || b[0] != l[m - 1] || b[n - 1] != r[m - 1])
      return bad_argument("the four curves do not meet in four corners");
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        const Rational &s = at_u[i], &t = at_v[j];
        const Rational s0 = Rational(1) - s, t0 = Rational(1) - t;
        all.push_back(s0 * (l[j] - t0 * a[0] - t * b[0]) +
                      s * (r[j] - t0 * a[n - 1] - t * b[n - 1]) + t0 * a[i] + t * b[i]);
      }
  }
  return CellSurface({axis_u, axis_v}, u[0].num_components(), u[0].is_rational(), std::move(all));
}

}  // namespace veritope
