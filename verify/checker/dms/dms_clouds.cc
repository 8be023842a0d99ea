// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_clouds.cc: E1 to E3 of docs/certificates/dms-solid.md.
#include "dms_boxes.h"

namespace {

void check_equal_values(const DmsFile& file) {  // E1
  if (!file.is_separate) return;
  std::map<std::vector<uint32_t>, const Ratio*> known;
  const std::vector<DmsIndex> all = dms_indices(file.n);
  for (size_t t = 0; t < file.tetrahedra.size(); ++t)
    for (const DmsIndex& beta : all) {
      std::vector<uint32_t> key;
      for (size_t c = 0; c < 4; ++c) key.insert(key.end(), size_t(beta[c]), file.tetrahedra[t][c]);
      std::sort(key.begin(), key.end());
      const Ratio* const value = file.value(t, beta);
      const Ratio* const other = known.emplace(std::move(key), value).first->second;
      for (size_t k = 0; k < 3; ++k)
        require(compare(value[k], other[k]) == 0, "E1",
                "a control point differs from that of a neighbour, of tetrahedron", t);
    }
}
void check_volumes(const DmsModel& model) {  // E2
  for (size_t t = 0; t < model.file.tetrahedra.size(); ++t)
    for (int sum = 0; sum <= model.file.sum(); ++sum)
      for (const DmsIndex& g : dms_indices(sum)) {
        const DmsPoint* w[4];
        for (size_t c = 0; c < 4; ++c) w[c] = &model.points[model.knot(t, c, g[c])];
        require(DmsPlane::of(*w[0], *w[1], *w[2]).side(*w[3]) > 0, "E2",
                "d is not positive, of a W of tetrahedron", t);
      }
}

struct DmsHulls {  // E3
  const DmsModel& model;
  const std::vector<std::vector<Ratio>>& planes;
  Units* units;
  std::vector<DmsBox> boxes;  // of the tetrahedra

  bool is_left_out(const DmsFace& face, const DmsIndex& g) const {
    for (size_t c = 0; c < 3; ++c)
      for (int i = 1; i <= g[c + 1]; ++i) {
        const uint32_t knot = model.clouds[face.vertex[c]][size_t(i)];
        bool is_corner = false;
        for (uint32_t v : face.vertex) is_corner = is_corner || model.clouds[v][0] == knot;
        if (!is_corner) return false;
      }
    return true;
  }
  void check(const DmsBoxes& tree, size_t f) {
    const DmsFace& face = model.faces[f];
    std::vector<DmsIndex> hulls;
    for (const DmsIndex& g : dms_indices(model.file.sum()))
      if (g[0] == 0 && !is_left_out(face, g)) hulls.push_back(g);
    if (hulls.empty()) return;
    DmsBox box;
    for (uint32_t v : face.vertex)
      for (int i = 0; i <= model.file.sum(); ++i) box.add(model.points[model.clouds[v][size_t(i)]]);
    std::vector<DmsPlane> listed;
    for (size_t i = 0; i < planes[f].size(); i += 4) listed.push_back(DmsPlane::of(&planes[f][i]));
    for (uint32_t t : tree.near(box)) check(face, hulls, listed, f, t);
  }
  void check(const DmsFace& face, const std::vector<DmsIndex>& hulls,
             const std::vector<DmsPlane>& listed, size_t f, size_t t) {
    std::vector<const DmsPoint*> corners;
    for (size_t c = 0; c < 4; ++c) corners.push_back(&model.corner(t, c));
    std::vector<DmsPlane> all = listed;
    add_dms_faces(corners.data(), &all);
    DmsSides sides(corners, all, false);
    for (const DmsIndex& g : hulls) {
      DmsMask mask = sides.all();
      for (size_t c = 0; c < 3; ++c)
        for (int i = 0; i <= g[c + 1]; ++i)
          mask &= sides.mask(model, model.clouds[face.vertex[c]][size_t(i)]);
      if ((mask.first & kDmsAxes) != 0) continue;
      units->add(1);
      require(mask.any(), "E3", "a hull is not kept away from the tetrahedra, of face", f);
    }
  }
};

}  // namespace

void check_dms_clouds(const DmsModel& model, const std::vector<std::vector<Ratio>>& planes,
                      Units* units) {
  check_equal_values(model.file);
  check_volumes(model);
  DmsHulls hulls = {model, planes, units, {}};
  hulls.boxes = dms_boxes_of_corners(model);
  const DmsBoxes tree(hulls.boxes);
  units->id = "E3";
  for (size_t f = 0; f < model.faces.size(); ++f) hulls.check(tree, f);
}
