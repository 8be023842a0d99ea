// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_invalid.cc: B1 to B3 of docs/certificates/vmodel-invalid.md, findings in one cell, and the claim as a whole.
#include "vmodel_invalid.h"

#include "vmodel_claim.h"

namespace {

enum { kFlat, kLeftHanded, kSingular, kOverlap, kCurve, kCorner };
const char* const kNames[] = {"flat",    "left-handed",       "singular",
                              "overlap", "curve-nonmanifold", "point-nonmanifold"};

struct InvalidReader : Bytes {
  InvalidReader(const std::vector<Entity>& entities, const char* magic, const Body& bytes)
      : Bytes(bytes), volumes(entities) {
    require(body.begins_with(magic), "B1", "another magic number");
    require(body.natural(4) == volumes.size(), "B1", "the file's entities are", volumes.size());
    f.kind = at_most(body.natural(1), kCorner, "there is no kind");
    if (f.kind == kFlat) {
      f.cell = cell();
      for (size_t a = 0; a < 3; ++a) f.spans[a] = span(f.cell, a);
    } else if (f.kind == kCurve) {
      for (CellArc& arc : f.arcs) arc = read_arc();
    } else if (f.kind == kCorner) {
      f.cell = cell();
      f.corner = at_most(body.natural(1), 7, "there is no corner");
    } else {
      f.a = point();
      if (f.kind == kOverlap) other_of_overlap();
    }
    end();
  }
  const std::vector<Entity>& volumes;
  Finding f = Finding();

 private:
  uint64_t cell() {
    const uint64_t c = varint();
    require(c < volumes.size(), "B1", "there is no cell", c);
    return c;
  }
  uint64_t span(uint64_t cell, size_t axis) {
    const uint64_t k = varint();
    require(k < different_knots(volumes[cell], axis).size() - 1, "B1", "there is no span", k);
    return k;
  }
  CellPoint point() {
    CellPoint r;
    r.cell = cell();
    r.at = read_point(volumes[r.cell], this);
    return r;
  }
  CellInterval interval(uint64_t cell, size_t axis) {
    CellInterval t;
    t.k = span(cell, axis);
    t.e = int(at_most(varint(), 62, "an interval counts 2^-e, e ="));
    t.a = varint();
    t.b = at_most(varint(), uint64_t(1) << t.e, "an interval leaves its span:");
    require(t.a < t.b, "B1", "an interval's ends do not rise");
    return t;
  }
  CellArc read_arc() {
    CellArc r;
    r.cell = cell();
    r.face = unsigned(at_most(body.natural(1), 5, "there is no face"));
    r.side = unsigned(at_most(body.natural(1), 3, "there is no side"));
    r.t = interval(r.cell, other_axis(r.face / 2, r.side / 2));
    return r;
  }
  void other_of_overlap() {
    f.b_is_box = at_most(body.natural(1), 1, "B is of no kind") == 1;
    if (!f.b_is_box) {
      f.b = point();
      return;
    }
    f.box_cell = cell();
    for (size_t a = 0; a < 3; ++a) f.box[a] = interval(f.box_cell, a);
    for (auto& row : f.y)
      for (Big& y : row) y = Big(zigzag());
  }
};

void check_flat(const Finding& f, InvalidModel* model) {
  VCell cell = VCell();
  cell.volume = &model->volumes[f.cell];
  for (size_t a = 0; a < 3; ++a)
    cell.breaks[a] = ends_of(*cell.volume, a, CellInterval{f.spans[a], 0, 1, 0});
  cut_pieces(cell, &model->units, [model](const VPiece& piece) {
    for (const Big& c : coefficients_of_n(piece, &model->units))
      require(c.sign() == 0, "F1", "the determinant is not 0 on the box");
  });
}

}  // namespace

std::vector<Ratio> different_knots(const Entity& e, size_t axis) {
  std::vector<Ratio> r;
  const std::vector<Ratio>& knots = e.knots[axis];
  for (const Ratio& t : knots)
    if (r.empty() || compare(r.back(), t) != 0) r.push_back(t);
  return r;
}
VCell cell_of(const Entity& e) {
  VCell r = VCell();
  r.volume = &e;
  for (size_t a = 0; a < 3; ++a) r.breaks[a] = different_knots(e, a);
  find_collapses(&r);
  return r;
}
std::vector<Ratio> ends_of(const Entity& e, size_t axis, const CellInterval& t) {
  const std::vector<Ratio> knots = different_knots(e, axis);
  const Ratio &low = knots[t.k], &high = knots[t.k + 1], length = high - low;
  const auto at = [&](uint64_t n) {
    return n == 0 ? low
           : n == uint64_t(1) << t.e
               ? high
               : low - Ratio(-(length.n * Big(int64_t(n))), shifted(length.d, t.e));
  };
  return {at(t.a), at(t.b)};
}

void check_vmodel_finding(const Statement& s) {
  const std::string& finding = s.text.at("finding");
  require(std::find(std::begin(kNames), std::end(kNames), finding) != std::end(kNames), "S1",
          "unknown finding");
}

std::string check_vmodel_invalid(const Statement& s, std::string model_text, const Body& bytes) {
  InvalidModel model = {read_volumes(model_text, s.text.at("subject_format")),
                        Units::of_bytes(s.number.at("subject_bytes") + bytes.left())};
  model.units.id = "B2";
  const std::vector<Entity>& volumes = model.volumes;
  InvalidReader reader(volumes, s.claim->magic, bytes);
  Finding& f = reader.f;

  require(volumes.size() <= kMostCells, "B2", "too many cells:", volumes.size());
  for (const Entity& e : volumes)
    for (int64_t p : e.degrees) require(p <= kMostDegree, "B2", "a degree is over 15");
  Points of_a, of_b;
  const bool has_point = f.kind >= kLeftHanded && f.kind <= kOverlap;
  if (has_point) of_a = box_of(volumes[f.a.cell], &f.a.at);
  if (f.kind == kOverlap && !f.b_is_box) of_b = box_of(volumes[f.b.cell], &f.b.at);
  require(s.text.at("finding") == kNames[f.kind], "B3", "the body has another finding");
  require(s.number.at("cells") == volumes.size(), "B3", "the number of cells is", volumes.size());

  if (f.kind == kFlat) check_flat(f, &model);
  if (f.kind == kLeftHanded)
    require(sign_of_jacobian(values_at(of_a, f.a.at)) < 0, "H1", "the determinant is not negative");
  if (f.kind == kSingular)
    require(sign_of_jacobian(values_at(of_a, f.a.at)) == 0, "Z1", "the determinant is not 0");
  if (f.kind == kOverlap) check_overlap(f, of_a, of_b, &model);
  if (f.kind == kCurve) check_curve(f, &model);
  if (f.kind == kCorner) check_corner(f, &model);
  const uint64_t cell = has_point ? f.a.cell : f.kind == kCurve ? f.arcs[0].cell : f.cell;
  return std::string(kNames[f.kind]) + " at cell " + std::to_string(cell) + " of " +
         std::to_string(volumes.size());
}
