// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_overlap.cc: O1 to O4 of docs/certificates/vmodel-invalid.md.
#include "vmodel_invalid.h"

namespace {

Ratio parameter(const AxisPoint& x) {
  const Big low = x.t[x.p - 1], high = x.t[x.p];
  return Ratio(Big(x.d - x.n) * low + Big(x.n) * high, Big(x.d) * x.t.back());
}
bool are_different(const Finding& f, const Entity& e) {
  if (f.a.cell != (f.b_is_box ? f.box_cell : f.b.cell)) return true;
  for (size_t a = 0; a < 3; ++a) {
    const Ratio of_a = parameter(f.a.at.axis[a]);
    if (!f.b_is_box) {
      if (compare(of_a, parameter(f.b.at.axis[a])) != 0) return true;
      continue;
    }
    const std::vector<Ratio> ends = ends_of(e, a, f.box[a]);
    if (compare(of_a, ends[0]) < 0 || compare(ends[1], of_a) < 0) return true;
  }
  return false;
}
// Whether Y (q P - w Q) has this sign at all coefficients of a face of the piece.
bool has_sign(const Big* y, const Points& q, const VPiece& piece, size_t axis, int sign) {
  size_t i[3];
  for (i[0] = 0; i[0] < piece.n[0]; ++i[0])
    for (i[1] = 0; i[1] < piece.n[1]; ++i[1])
      for (i[2] = 0; i[2] < piece.n[2]; ++i[2]) {
        if (i[axis] != (sign < 0 ? 0 : piece.n[axis] - 1)) continue;
        const Big* const p = &piece.net[piece.at(i[0], i[1], i[2])];
        Big sum;
        for (size_t c = 0; c < 3; ++c) sum = sum + y[c] * (q[3] * p[c] - p[3] * q[c]);
        if (sum.sign() != sign) return false;
      }
  return true;
}

}  // namespace

void check_overlap(const Finding& f, const Points& box_of_a, const Points& box_of_b,
                   InvalidModel* model) {
  const Entity& e = model->volumes[f.a.cell];
  for (size_t a = 0; a < 3; ++a) {
    const Ratio at = parameter(f.a.at.axis[a]);
    const std::vector<Ratio>& knots = e.knots[a];
    require(compare(knots.front(), at) < 0 && compare(at, knots.back()) < 0, "O1",
            "A is not inside of its cell, on axis", a);
  }
  require(are_different(f, e), "O2", f.b_is_box ? "A is in B" : "A and B are the same point");
  const Points q = values_at(box_of_a, f.a.at)[0];
  if (!f.b_is_box) {
    const Points p = values_at(box_of_b, f.b.at)[0];
    for (size_t c = 0; c < 3; ++c)
      require(p[c] * q[3] == q[c] * p[3], "O3", "A and B have different images, on axis", c);
    return;
  }
  VCell cell = VCell();
  cell.volume = &model->volumes[f.box_cell];
  for (size_t a = 0; a < 3; ++a) cell.breaks[a] = ends_of(*cell.volume, a, f.box[a]);
  cut_pieces(cell, &model->units, [&](const VPiece& piece) {
    for (size_t a = 0; a < 3; ++a)
      for (int sign = -1; sign <= 1; sign += 2)
        require(has_sign(f.y[a], q, piece, a, sign), "O4",
                "the image of A is not between the faces of the box across axis", a);
  });
}
