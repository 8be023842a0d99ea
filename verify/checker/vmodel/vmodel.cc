// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel.cc: the conditions of docs/certificates/vmodel.md in their order.
#include "vmodel.h"

#include "../patches/star_box.h"
#include "../patches/volume_faces.h"
#include "vmodel_claim.h"

namespace {

void check_codes(const VBody& body) {
  for (uint64_t f = 0; f < body.faces.size(); ++f) {
    const bool is_collapsed = body.cells[f / 6].faces[f % 6] != Collapse::kNone;
    require((body.faces[f].code == 1) == is_collapsed, "V1",
            is_collapsed ? "this face is collapsed:" : "this face is not collapsed:", f);
  }
}

void check_cell(const VBody& body, size_t c, uint64_t number, Pairs* pairs, Units* units) {
  const VCell& cell = body.cells[c];
  const VEntry plain = {0, std::vector<uint8_t>(1, 0)};
  cut_pieces(cell, units, [&](const VPiece& piece) {
    check_edges(cell, piece);
    bool may_vanish[6];
    for (size_t f = 0; f < 6; ++f)
      may_vanish[f] = piece.index[f / 2] == f % 2 * (cell.intervals(f / 2) - 1) &&
                      body.faces[6 * c + f].code < 2;
    const auto entry = body.entries.find(number++);
    check_determinant(piece, entry == body.entries.end() ? plain : entry->second, cell.is_reversed,
                      may_vanish, units);
    pairs->see(c, piece);
  });
}

struct Boundary {  // X
  std::vector<Entity> faces;
  std::vector<std::vector<Ratio>> breaks;  // two for each
};
void add_face(const VCell& cell, size_t number, Boundary* to) {
  const size_t* const p = kParametersOfFaces[number];
  to->faces.push_back(face_of_volume(*cell.volume, number, !cell.is_reversed));
  to->breaks.push_back(cell.breaks[p[cell.is_reversed]]);
  to->breaks.push_back(cell.breaks[p[!cell.is_reversed]]);
}

std::map<std::string, uint64_t> numbers_of(const VBody& body, const Pairs& pairs) {
  uint64_t halves = 0, reversed = 0, singular = 0, points, curves;
  for (const FaceCode& f : body.faces) halves += f.code != 1;
  for (const VCell& c : body.cells) reversed += c.is_reversed;
  for (const auto& e : body.entries) singular += uint64_t(__builtin_popcount(e.second.zeros));
  pairs.count_classes(&points, &curves);
  const uint64_t surfaces = halves - pairs.count();
  const int64_t euler =
      int64_t(points) - int64_t(curves) + int64_t(surfaces) - int64_t(body.cells.size());
  return {{"cells", body.cells.size()},
          {"pieces", body.pieces},
          {"half_v_surfaces", halves},
          {"v_surfaces", surfaces},
          {"v_curves", curves},
          {"v_points", points},
          {"euler", 2 * magnitude(euler) - (euler < 0)},
          {"reversed", reversed},
          {"singular", singular}};
}

}  // namespace

CheckedCells check_cells(const std::vector<Entity>& volumes, uint64_t model_bytes,
                         const Body& bytes) {
  VBody body = read_vbody(volumes, bytes);
  for (VCell& cell : body.cells) find_collapses(&cell);
  check_codes(body);
  Units units = Units::of_bytes(model_bytes + bytes.left());
  Pairs pairs(body);
  uint64_t number = 0;
  for (size_t c = 0; c < body.cells.size(); ++c) {
    check_cell(body, c, number, &pairs, &units);
    number += body.cells[c].pieces();
  }
  pairs.check();

  Boundary x;
  for (uint64_t f = 0; f < body.faces.size(); ++f)
    if (body.faces[f].code == 0) add_face(body.cells[f / 6], size_t(f % 6), &x);
  StarBody star = read_star_body("VTS2", x.faces, body.rest, [](StarBytes*) {});
  require(star.num_reversed == 0, "V4", "flags of faces:", star.num_reversed);
  require(star.breaks == x.breaks, "V4", "a face has other breaks than its cell");
  const StarCheck check(&star, model_bytes + body.rest.left(), false);
  CheckedCells r;
  r.numbers = numbers_of(body, pairs);
  r.faces = body.faces;
  const std::map<std::string, uint64_t> of_x = check.numbers();
  r.numbers.insert(of_x.begin(), of_x.end());
  return r;
}

std::string check_vmodel(const Statement& s, std::string model, const Body& bytes) {
  std::map<std::string, uint64_t> numbers =
      check_cells(read_volumes(model, s.text.at("subject_format")), s.number.at("subject_bytes"),
                  bytes)
          .numbers;
  for (const char* not_stated : {"edges", "vertices", "flipped"}) numbers.erase(not_stated);
  return compared(s, numbers);
}
