// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/simplex_cell.h"

#include <utility>

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"

namespace veritope {

template <std::size_t Dim>
Rational determinant_of(const std::array<NormalIn<Dim>, Dim>& m) {
  if constexpr (Dim == 1) {
    return m[0][0];
  } else if constexpr (Dim == 2) {
    return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  } else {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
}

template <std::size_t Dim>
Sign orientation_of(const std::array<PointIn<Dim>, Dim + 1>& corners) {
  std::array<NormalIn<Dim>, Dim> rows;
  for (std::size_t i = 0; i < Dim; ++i)
    for (std::size_t k = 0; k < Dim; ++k) rows[i][k] = corners[i + 1][k] - corners[0][k];
  return determinant_of<Dim>(rows).sign();
}

namespace {

template <std::size_t Dim>
using RoundedCorners = std::array<std::array<double, Dim>, Dim + 1>;

// The exact sign of orientation_of() from binary64 coordinates.
Sign orientation_of(const RoundedCorners<1>& p) {
  return p[0][0] < p[1][0] ? Sign::kPositive : p[1][0] < p[0][0] ? Sign::kNegative : Sign::kZero;
}
Sign orientation_of(const RoundedCorners<2>& p) {
  return orient2d({p[0][0], p[0][1]}, {p[1][0], p[1][1]}, {p[2][0], p[2][1]});
}
Sign orientation_of(const RoundedCorners<3>& p) {
  const auto at = [&](std::size_t i) { return Vec3d{p[i][0], p[i][1], p[i][2]}; };
  return orient3d(at(0), at(1), at(2), at(3));
}

template <std::size_t Dim>
Box3d box_of_corners(const std::array<PointIn<Dim>, Dim + 1>& corners) {
  Box3d out = box_around<Dim>(corners[0]);
  for (const PointIn<Dim>& p : corners) out = hull(out, box_around<Dim>(p));
  return out;
}

}  // namespace

template <std::size_t Dim>
Result<std::shared_ptr<const SimplexCell<Dim>>> SimplexCell<Dim>::make(const Corners& corners) {
  const Sign sign = veritope::orientation_of<Dim>(corners);
  if (sign == Sign::kZero) {
    std::string names;
    for (const PointIn<Dim>& p : corners) {
      names += names.empty() ? "(" : ", (";
      for (std::size_t k = 0; k < Dim; ++k) names += (k > 0 ? ", " : "") + p[k].to_string();
      names += ")";
    }
    return bad_argument("the simplex with the corners " + names + " has no interior");
  }
  return std::shared_ptr<const SimplexCell>(new SimplexCell(corners, sign));
}

template <std::size_t Dim>
SimplexCell<Dim>::SimplexCell(const Corners& corners, Sign sign)
    : Cell<Dim>(box_of_corners<Dim>(corners)), corners_(corners), sign_(sign) {
  doubles_.emplace();
  for (std::size_t i = 0; i <= Dim; ++i) {
    const ChainPoint<Dim> p(corners[i]);
    if (!p.doubles()) {
      doubles_.reset();
      return;
    }
    (*doubles_)[i] = *p.doubles();
  }
}

template <std::size_t Dim>
Sign SimplexCell<Dim>::side_of(const ChainPoint<Dim>& q, std::size_t facet) const {
  if (doubles_ && q.doubles()) {
    RoundedCorners<Dim> moved = *doubles_;
    moved[facet] = *q.doubles();
    return orientation_of(moved) * sign_;
  }
  Corners moved = corners_;
  moved[facet] = q.exact();
  return veritope::orientation_of<Dim>(moved) * sign_;
}

template <std::size_t Dim>
std::optional<int> SimplexCell<Dim>::value(const ChainPoint<Dim>& q) const {
  if (!meets(this->box(), q.box())) return 0;
  for (std::size_t i = 0; i <= Dim; ++i)
    if (side_of(q, i) < 0) return 0;
  return 1;
}

// The signed volume with q in the place of corner `facet` is linear in q; its gradient times the sign.
template <std::size_t Dim>
NormalIn<Dim> SimplexCell<Dim>::inward_normal(std::size_t facet) const {
  const PointIn<Dim>& from = corners_[facet == 0 ? 1 : 0];
  NormalIn<Dim> out;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    Corners moved = corners_;
    moved[facet] = from;
    moved[facet][axis] += Rational(1);
    std::array<NormalIn<Dim>, Dim> rows;
    for (std::size_t i = 0; i < Dim; ++i)
      for (std::size_t k = 0; k < Dim; ++k) rows[i][k] = moved[i + 1][k] - moved[0][k];
    out[axis] = determinant_of<Dim>(rows);
    if (sign_ < 0) out[axis].negate();
  }
  return out;
}

template <std::size_t Dim>
std::optional<CellGerm<Dim>> SimplexCell<Dim>::germ(const ChainPoint<Dim>& q) const {
  if (!meets(this->box(), q.box())) return CellGerm<Dim>::constant(0);
  CellGerm<Dim> out{{}, 1, 1, 0};
  std::array<Sign, Dim + 1> sides;
  for (std::size_t i = 0; i <= Dim; ++i) {
    sides[i] = side_of(q, i);
    if (sides[i] < 0) return CellGerm<Dim>::constant(0);
  }
  for (std::size_t i = 0; i <= Dim; ++i)
    if (sides[i] == 0) out.half_spaces.push_back(inward_normal(i));
  return out;
}

template <std::size_t Dim>
bool SimplexCell<Dim>::add_facets(std::vector<FacetIn<Dim>>& out) const {
  for (std::size_t facet = 0; facet <= Dim; ++facet) {
    FacetIn<Dim>& f = out.emplace_back();
    for (std::size_t i = 0, k = 0; i <= Dim; ++i)
      if (i != facet) f[k++] = corners_[i];
  }
  return true;
}

template class SimplexCell<1>;
template class SimplexCell<2>;
template class SimplexCell<3>;
template Rational determinant_of<1>(const std::array<NormalIn<1>, 1>&);
template Rational determinant_of<2>(const std::array<NormalIn<2>, 2>&);
template Rational determinant_of<3>(const std::array<NormalIn<3>, 3>&);
template Sign orientation_of<1>(const std::array<PointIn<1>, 2>&);
template Sign orientation_of<2>(const std::array<PointIn<2>, 3>&);
template Sign orientation_of<3>(const std::array<PointIn<3>, 4>&);

}  // namespace veritope
