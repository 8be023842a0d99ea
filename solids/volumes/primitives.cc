// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/primitives.h"

#include <string>
#include <utility>

#include "solids/volumes/axis_turn.h"
#include "solids/volumes/disc_sections.h"
#include "solids/volumes/ruled.h"
#include "splines/bspline_domain.h"

namespace veritope {
namespace {

Status check_positive(const char* what, const Rational& value) {
  if (value.sign() == Sign::kPositive) return ok_status();
  return bad_argument(std::string(what) + " must be positive, not " + value.to_string());
}

const TurnAxis& z_axis() {
  static const TurnAxis axis{{}, {Rational(0), Rational(0), Rational(1)}};
  return axis;
}

// The surface at the height z, scaled by a factor.
CellSurface at_height(const CellSurface& section, const Rational& scale, const Rational& z) {
  Placement placement = translation({Rational(0), Rational(0), z});
  for (std::size_t i = 0; i < 3; ++i) placement.linear[i][i] = scale;
  return placed(section, placement);
}

CellSurface polynomial_surface(KnotAxis<Rational> u, KnotAxis<Rational> v,
                               std::vector<Rational> xyz) {
  return CellSurface({std::move(u), std::move(v)}, 3, false, std::move(xyz));
}

Result<Cells> one_cell(Result<CellVolume> cell) {
  if (!cell) return cell.error();
  return Cells{std::move(*cell)};
}

Result<CellVolume> fully_revolved(const CellSurface& surface) {
  return revolved(surface, z_axis(), make_turn(z_axis().direction, Rational(360)).value());
}

}  // namespace

Result<Cells> box_cells(const CellPoint& min, const CellPoint& max) {
  std::vector<Rational> all;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(min[k] < max[k]))
      return bad_argument(std::string("min must be less than max, and in ") + "xyz"[k] +
                          " they are " + min[k].to_string() + " and " + max[k].to_string());
    for (std::size_t corner = 0; corner < 8; ++corner)
      all.push_back((corner >> (2 - k) & 1) == 0 ? min[k] : max[k]);
  }
  const KnotAxis<Rational> axis = unit_axis(1);
  return Cells{CellVolume({axis, axis, axis}, 3, false, std::move(all))};
}

Result<Cells> cylinder_cells(const Rational& radius, const Rational& height) {
  if (const Status ok = check_positive("radius", radius); !ok) return ok.error();
  return cone_cells(radius, radius, height);
}

Result<Cells> cone_cells(const Rational& bottom, const Rational& top, const Rational& height) {
  if (const Status ok = check_positive("bottom", bottom); !ok) return ok.error();
  if (top.sign() == Sign::kNegative)
    return bad_argument("top must not be negative, and it is " + top.to_string());
  if (const Status ok = check_positive("height", height); !ok) return ok.error();
  Cells cells;
  for (const CellSurface& section : internal::disc_sections())
    cells.push_back(
        ruled(at_height(section, bottom, Rational(0)), at_height(section, top, height)).value());
  return cells;
}

Result<Cells> torus_cells(const Rational& major, const Rational& minor) {
  if (const Status ok = check_positive("minor", minor); !ok) return ok.error();
  if (!(minor < major))
    return bad_argument("minor must be less than major, and they are " + minor.to_string() +
                        " and " + major.to_string());
  // (x, y) -> (major + minor x, 0, minor y). Its axes change places, since (x, z, around) is left-handed.
  Placement upright;
  const Rational zero;
  upright.linear = {CellPoint{minor, zero, zero}, CellPoint{zero, zero, Rational(1)},
                    CellPoint{zero, minor, zero}};
  upright.shift[0] = major;
  Cells cells;
  for (const CellSurface& section : internal::disc_sections())
    cells.push_back(fully_revolved(swapped(placed(section, upright), 0, 1)).value());
  return cells;
}

Result<Cells> sphere_cells(const Rational& radius) {
  if (const Status ok = check_positive("radius", radius); !ok) return ok.error();
  Cells cells = box_cells({-radius / Rational(2), -radius / Rational(2), -radius / Rational(2)},
                          {radius / Rational(2), radius / Rational(2), radius / Rational(2)})
                    .value();
  for (const internal::SphereSide& side : internal::sphere_sides())
    cells.push_back(ruled(at_height(side.cube, radius / Rational(2), Rational(0)),
                          at_height(side.sphere, radius, Rational(0)))
                        .value());
  return cells;
}

Result<Cells> one_cell_cylinder(const Rational& radius, const Rational& height) {
  if (const Status ok = check_positive("radius", radius); !ok) return ok.error();
  if (const Status ok = check_positive("height", height); !ok) return ok.error();
  const Rational zero;
  return one_cell(fully_revolved(polynomial_surface(
      unit_axis(1), unit_axis(1),
      {zero, radius, zero, radius, zero, zero, zero, zero, zero, zero, height, height})));
}

Result<Cells> one_cell_sphere(const Rational& radius) {
  if (const Status ok = check_positive("radius", radius); !ok) return ok.error();
  return one_cell(fully_revolved(at_height(internal::half_disc(), radius, Rational(0))));
}

}  // namespace veritope
