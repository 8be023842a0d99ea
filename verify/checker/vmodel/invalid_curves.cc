// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_curves.cc: C1 to C3 and V1 of docs/certificates/vmodel-invalid.md: three border faces at one arc.
#include "../patches/star_curve.h"
#include "vmodel_invalid.h"

namespace {

bool are_apart(const CellArc& a, const CellArc& b) {
  if (a.cell != b.cell || a.face != b.face || a.side != b.side || a.t.k != b.t.k) return true;
  return u128(a.t.b) << b.t.e <= u128(b.t.a) << a.t.e ||
         u128(b.t.b) << a.t.e <= u128(a.t.a) << b.t.e;  // below 2^125
}

Curve curve_of(const CellArc& arc, InvalidModel* model) {
  const uint64_t edge = side_of(arc.face, arc.side / 2, arc.side % 2);
  const size_t axis = size_t(edge / 4);
  Place3 place;
  place.end[axis] = -1;
  place.end[other_axis(axis, 0)] = int(edge % 2);
  place.end[other_axis(axis, 1)] = int(edge / 2 % 2);
  VCell cell = VCell();
  cell.volume = &model->volumes[arc.cell];
  cell.breaks[axis] = ends_of(*cell.volume, axis, arc.t);
  return PieceCutter(cell, place, &model->units).cut(0, 0, 0).net;
}
Curve check_arcs(const CellArc* arcs, InvalidModel* model) {  // C1, C2; the first arc's curve
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < i; ++k)
      require(are_apart(arcs[i], arcs[k]), "C1", "two arcs overlap on a side of cell",
              arcs[i].cell);
  const Curve first = curve_of(arcs[0], model);
  require(!is_point(first), "C2", "the first arc is a point");
  const std::string forward = text(canonical(first), false),
                    backward = text(canonical(first), true);
  for (size_t i = 1; i < 3; ++i) {
    const std::string other = text(canonical(curve_of(arcs[i], model)), false);
    require(other == forward || other == backward, "C2", "another curve than the first's: arc", i);
  }
  return first;
}

// C3.
void check_border(const CellArc* arcs, InvalidModel* model) {
  const std::vector<Entity>& volumes = model->volumes;
  std::vector<SpacePoint> points;
  VCell cells[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = cell_of(volumes[arcs[i].cell]);
    require(cells[i].faces[arcs[i].face] == Collapse::kNone, "C3", "a face is collapsed, of cell",
            arcs[i].cell);
    for (size_t corner = 0; corner < 4; ++corner)
      points.push_back(
          corner_point(volumes[arcs[i].cell], corner_of(arcs[i].face, corner % 2, corner / 2)));
  }
  const PointNumbers numbers(std::move(points));
  std::vector<size_t> corners;
  for (const Entity& e : volumes)
    for (size_t c = 0; c < 8; ++c) corners.push_back(numbers[corner_point(e, c)]);

  for (int i = 0; i < 3; ++i) {
    VCell cell = VCell();
    uint64_t known = volumes.size();  // the cell's number
    const uint64_t own = 6 * arcs[i].cell + arcs[i].face;
    const CellFace f = {&cells[i], arcs[i].face, &corners[8 * arcs[i].cell]};
    for (uint64_t number = 0; number < 6 * volumes.size(); ++number) {
      if (number == own) continue;
      const CellFace g = {&cell, size_t(number % 6), &corners[8 * (number / 6)]};
      model->units.add(1);
      if (!may_be_equal(f, g)) continue;
      if (known != number / 6) known = number / 6, cell = cell_of(volumes[known]);
      require(cell.faces[g.number] != Collapse::kNone || equal_under(f, g, &model->units) < 0, "C3",
              "two faces are equal; one of them is number", number);
    }
  }
}

}  // namespace

void check_curve(const Finding& f, InvalidModel* model) {
  const Curve first = check_arcs(f.arcs, model);
  check_border(f.arcs, model);
  Curve low, high;
  halve(first, &low, &high);
  SpacePoint middle;
  for (size_t c = 0; c < 3; ++c) middle.x[c] = lowest(Ratio(high[c], high[3]));
  check_cells_near(middle, model);
}
