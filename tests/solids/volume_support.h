// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/volume_support.h: what the tests of volumes ask of cells: the numerator of the Jacobian determinant, how
// faces are glued, how many parts there are. Slow and direct; it shares no code with a search.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solids/volumes/cell_maps.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_components.h"
#include "splines/bezier_product.h"
#include "splines/bspline_domain.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope::volume_test {

using Cells = std::vector<CellVolume>;
using Form = BezierVolume<Rational>;  // one component

/// N = -det(F, F_u, F_v, F_w) of a rational piece, as a polynomial.
inline Form jacobian_numerator(const Form& piece) {
  const Form h = to_rational(piece);
  std::vector<std::array<Form, 4>> rows;
  const auto row_of = [](const Form& f) {
    return std::array<Form, 4>{components(f, 0, 1), components(f, 1, 1), components(f, 2, 1),
                               components(f, 3, 1)};
  };
  const Form all = components(h, 0, 4);
  rows.push_back(row_of(all));
  for (std::size_t a = 0; a < 3; ++a) rows.push_back(row_of(derivative(all, a)));
  const auto minor = [&](std::size_t r, std::size_t i, std::size_t j) {
    return difference(multiplied(rows[r][i], rows[r + 1][j]),
                      multiplied(rows[r][j], rows[r + 1][i]));
  };
  std::optional<Form> det;
  const std::array<std::array<std::size_t, 4>, 6> splits = {
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& s = splits[k];
    const Form term = multiplied(minor(0, s[0], s[1]), minor(2, s[2], s[3]));
    const bool is_plus = k == 0 || k == 2 || k == 3 || k == 5;
    const Form zero({0, 0, 0}, 1, false, {Rational(0)});
    const Form before = det ? *det : zero;
    det = is_plus ? difference(before, term) : sum(before, term);
  }
  return *det;
}

/// The signs of the Bernstein coefficients of N on all pieces: least and greatest.
inline std::array<int, 2> signs_of_jacobian(const CellVolume& cell) {
  std::array<int, 2> out = {1, -1};
  for (const Form& piece : bezier_pieces(cell).pieces)
    for (const Rational& x : jacobian_numerator(piece).coefficients()) {
      out[0] = std::min(out[0], to_int(x.sign()));
      out[1] = std::max(out[1], to_int(x.sign()));
    }
  return out;
}

/// Whether the surface's homogeneous control points are proportional along one axis: it is a curve or a point.
inline bool is_collapsed(const CellSurface& face) {
  const CellSurface h = homogeneous(face);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const CellSurface s = axis == 0 ? h : swapped(h, 0, 1);
    bool is = true;
    const std::size_t n = s.grid().size[0], m = s.grid().size[1];
    for (std::size_t i = 1; is && i < n; ++i) {
      const Rational f = s.component(s.dimension())[i * m] / s.component(s.dimension())[0];
      for (int c = 0; is && c < s.num_components(); ++c)
        for (std::size_t j = 0; is && j < m; ++j)
          is = s.component(c)[i * m + j] == f * s.component(c)[j];
    }
    if (is) return true;
  }
  std::set<std::string> points;
  for (std::size_t i = 0; i < h.grid().count(); ++i) {
    std::string point;
    for (int c = 0; c < 3; ++c)
      point += (h.component(c)[i] / h.component(h.dimension())[i]).to_string() + " ";
    points.insert(point);
  }
  return points.size() == 1;
}

template <std::size_t N>
bool are_equal(const BSpline<Rational, N>& a, const BSpline<Rational, N>& b) {
  if (a.is_rational() != b.is_rational()) return are_equal(homogeneous(a), homogeneous(b));
  const auto both = in_one_space<N>({a, b});
  return both && internal::factor_between((*both)[0], (*both)[1]).has_value();
}

/// Whether two faces are equal under one of 8 symmetries, of these parity: 0 or 1; nothing if they are not.
inline std::optional<int> symmetry_parity(const CellSurface& a, const CellSurface& b) {
  for (int s = 0; s < 8; ++s) {
    CellSurface turned = (s & 1) != 0 ? swapped(b, 0, 1) : b;
    if ((s & 2) != 0) turned = reversed(turned, 0);
    if ((s & 4) != 0) turned = reversed(turned, 1);
    if (are_equal(a, turned)) return ((s & 1) + (s >> 1 & 1) + (s >> 2 & 1)) % 2;
  }
  return std::nullopt;
}

struct Face {
  CellSurface surface;
  int orientation;  ///< 0 if (its u) x (its v) points out of a right-handed cell, else 1
};

inline std::vector<Face> faces_of(const CellVolume& cell) {
  std::vector<Face> out;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end)
      out.push_back({side_of(cell, axis, end), (axis == 1) == (end == 1) ? 1 : 0});
  return out;
}

/// V-points, V-curves, V-surfaces, internal ones, half-V-surfaces. Fails the test if glued faces have one orientation
/// or a face is glued twice.
inline std::array<std::size_t, 5> part_counts(const Cells& cells) {
  std::vector<Face> faces;
  std::vector<CellCurve> curves;
  std::set<std::string> points;
  for (const CellVolume& cell : cells) {
    const CellVolume h = homogeneous(cell);
    for (const Face& f : faces_of(h)) {
      if (!is_collapsed(f.surface)) faces.push_back(f);
      for (std::size_t k = 0; k < 4; ++k) {
        const CellCurve side = side_of(f.surface, k / 2, k % 2);
        for (const std::size_t end : {std::size_t{0}, side.grid().size[0] - 1}) {
          std::string point;
          for (int c = 0; c < 3; ++c)
            point +=
                (side.component(c)[end] / side.component(side.dimension())[end]).to_string() + " ";
          points.insert(point);
        }
        std::set<std::string> along;
        for (std::size_t i = 0; i < side.grid().size[0]; ++i) {
          std::string point;
          for (int c = 0; c < 3; ++c)
            point += (side.component(c)[i] / side.component(side.dimension())[i]).to_string() + " ";
          along.insert(point);
        }
        if (along.size() > 1) curves.push_back(side);
      }
    }
  }
  std::vector<int> mates(faces.size());
  std::size_t internal = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j)
      if (const auto parity = symmetry_parity(faces[i].surface, faces[j].surface)) {
        ++internal, ++mates[i], ++mates[j];
        EXPECT_EQ((faces[i].orientation + faces[j].orientation + *parity) % 2, 1) << i << " " << j;
      }
  for (const int m : mates) EXPECT_LE(m, 1);
  std::vector<CellCurve> different;
  for (const CellCurve& c : curves) {
    bool is_new = true;
    for (const CellCurve& d : different)
      is_new &= !are_equal(c, d) && !are_equal(c, reversed(d, 0));
    if (is_new) different.push_back(c);
  }
  return {points.size(), different.size(), faces.size() - internal, internal, faces.size()};
}

/// The components of the Bezier pieces of a surface, as polynomials of one component; the weight last.
inline std::vector<std::vector<BezierSurface<Rational>>> homogeneous_pieces(const CellSurface& s) {
  std::vector<std::vector<BezierSurface<Rational>>> out;
  for (const auto& piece : bezier_pieces(homogeneous(s)).pieces) {
    auto& all = out.emplace_back();
    for (int c = 0; c < 4; ++c) all.push_back(components(piece, c, 1));
  }
  return out;
}

inline bool is_zero(const BezierSurface<Rational>& polynomial) {
  for (const Rational& x : polynomial.coefficients())
    if (x.sign() != Sign::kZero) return false;
  return true;
}

}  // namespace veritope::volume_test
