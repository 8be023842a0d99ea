// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_domain.cc: D1 to D3 of docs/certificates/dms-solid.md.
#include "../patches/star_box.h"
#include "dms_boxes.h"

const int kDmsFace[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

DmsModel::DmsModel(const DmsFile& model) : file(model), gammas(dms_indices(model.n - 1)) {
  std::vector<DmsPoint> all;
  for (size_t i = 0; i < file.knots.size(); i += 3) all.push_back(DmsPoint::of(&file.knots[i]));
  std::vector<uint32_t> order(all.size()), number(all.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    for (int k = 0; k < 3; ++k) {
      const int c = dms_compare(all[a], all[b], k);
      if (c != 0) return c < 0;
    }
    return a < b;
  });
  for (size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || !dms_equal(all[order[i - 1]], all[order[i]])) points.push_back(all[order[i]]);
    number[order[i]] = uint32_t(points.size() - 1);
  }
  for (std::vector<uint32_t> cloud : file.clouds) {
    for (uint32_t& knot : cloud) knot = number[knot];
    clouds.push_back(std::move(cloud));
  }
}

namespace {

typedef std::array<uint32_t, 3> DmsOrder;  // a cyclic order of vertices, the least one first
// All faces, sorted; with 4 tetrahedron + number.
std::vector<std::pair<DmsOrder, size_t>> sorted_faces(const DmsFile& file) {
  std::vector<std::pair<DmsOrder, size_t>> faces;
  for (size_t t = 0; t < file.tetrahedra.size(); ++t)
    for (size_t f = 0; f < 4; ++f) {
      DmsOrder face;
      for (size_t i = 0; i < 3; ++i) face[i] = file.tetrahedra[t][size_t(kDmsFace[f][i])];
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      faces.push_back(std::make_pair(face, 4 * t + f));
    }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

void find_dms_boundary(DmsModel* model) {
  const std::vector<std::pair<DmsOrder, size_t>> faces = sorted_faces(model->file);
  std::vector<size_t> boundary;
  for (const std::pair<DmsOrder, size_t>& face : faces) {
    const DmsOrder& f = face.first;
    const std::pair<DmsOrder, size_t> opposite(DmsOrder{{f[0], f[2], f[1]}}, 0);
    const auto at = std::lower_bound(faces.begin(), faces.end(), opposite);
    if (at == faces.end() || at->first != opposite.first) boundary.push_back(face.second);
  }
  std::sort(boundary.begin(), boundary.end());
  for (size_t code : boundary) {
    DmsFace face = {{{0, 0, 0}}, code / 4, int(code % 4)};
    for (size_t i = 0; i < 3; ++i)
      face.vertex[i] = model->file.tetrahedra[code / 4][size_t(kDmsFace[code % 4][i])];
    model->faces.push_back(face);
  }
}
void check_dms_domain(const DmsModel& model) {
  for (size_t t = 0; t < model.file.tetrahedra.size(); ++t) {
    const DmsPlane plane = DmsPlane::of(model.corner(t, 0), model.corner(t, 1), model.corner(t, 2));
    require(plane.side(model.corner(t, 3)) > 0, "D1", "d is not positive, of tetrahedron", t);
  }
  const std::vector<std::pair<DmsOrder, size_t>> faces = sorted_faces(model.file);
  for (size_t i = 1; i < faces.size(); ++i)
    require(faces[i - 1].first != faces[i].first, "D2", "a face occurs twice, of tetrahedron",
            faces[i].second / 4);
  require(!model.faces.empty(), "D2", "there is no boundary");
}

DmsNumbers check_dms_boxes(const std::vector<std::vector<Ratio>>& triangles, int degree,
                           const Body& part, uint64_t file_bytes, const char* id) {
  std::vector<Entity> entities;
  for (const std::vector<Ratio>& numbers : triangles) {
    Entity e;
    e.kind = Entity::kTriangle;
    e.components = 3;
    e.degrees = {degree};
    for (uint64_t i = 0; 3 * i < numbers.size(); ++i) e.places.push_back(i);
    e.numbers = Numbers(numbers);
    entities.push_back(std::move(e));
  }
  StarBody star = read_star_body("VTS2", entities, part, [](StarBytes*) {});
  require(star.num_reversed == 0, id, "flags of triangles:", star.num_reversed);
  uint64_t bytes = file_bytes + part.left();
  for (const Patch& patch : star.patches) bytes += patch.words();
  const StarCheck check(&star, bytes, false);
  require(check.walks.bodies > 0, "W3", "there is no body");
  return DmsNumbers{check.x.components, check.walks.bodies, check.x.genus};
}
DmsNumbers check_dms_boundary(const DmsModel& model, const Body& part, uint64_t file_bytes) {
  std::vector<std::vector<Ratio>> triangles;
  for (const DmsFace& face : model.faces) {
    std::vector<Ratio> numbers;
    for (uint32_t vertex : face.vertex) {
      const Ratio* const knot = &model.file.knots[3 * model.file.clouds[vertex][0]];
      numbers.insert(numbers.end(), knot, knot + 3);
    }
    triangles.push_back(std::move(numbers));
  }
  return check_dms_boxes(triangles, 1, part, file_bytes, "D3");
}
