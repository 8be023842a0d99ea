// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_tiles.cc: T1 to T3 of docs/certificates/dms-solid.md.
#include "dms_pieces.h"
#include "dms_polynomial.h"

namespace {

typedef std::pair<uint64_t, uint64_t>
    DmsStep;  // a directed edge of tiles, by the numbers of points

struct DmsTiles {
  const DmsModel& model;
  const DmsBody& body;
  Units* units;
  std::vector<DmsPoint> added;
  std::vector<DmsPlane> planes;                 // of the faces
  std::vector<std::pair<size_t, DmsTile>> all;  // with their faces, in order

  const DmsPoint& point(uint64_t number) const {
    return number < model.clouds.size() ? model.place(uint32_t(number))
                                        : added[size_t(number - model.clouds.size())];
  }
  void read() {
    for (size_t i = 0; i < body.added.size(); i += 3) added.push_back(DmsPoint::of(&body.added[i]));
    for (size_t f = 0; f < model.faces.size(); ++f) {
      const std::array<uint32_t, 3>& v = model.faces[f].vertex;
      planes.push_back(DmsPlane::of(model.place(v[0]), model.place(v[1]), model.place(v[2])));
      for (const DmsTile& tile : body.tiles[f]) all.push_back(std::make_pair(f, tile));
      if (body.tiles[f].empty()) all.push_back(std::make_pair(f, DmsTile{{v[0], v[1], v[2]}, {}}));
    }
  }

  // T1. The tiles of a face are those from `first` to `last`.
  void check_face(size_t f, size_t first, size_t last) const {
    std::vector<DmsStep> steps;
    for (size_t i = first; i < last; ++i) {
      const DmsPoint* p[3];
      for (size_t c = 0; c < 3; ++c) {
        p[c] = &point(all[i].second.corner[c]);
        require(planes[f].value(*p[c]).sign() == 0, "T1", "a tile is not in the plane of face", f);
        steps.push_back(DmsStep(all[i].second.corner[c], all[i].second.corner[(c + 1) % 3]));
      }
      require(dms_dot(DmsPlane::of(*p[0], *p[1], *p[2]), planes[f]).sign() > 0, "T1",
              "a tile is turned, or has no area, of face", f);
    }
    std::sort(steps.begin(), steps.end());
    require(std::adjacent_find(steps.begin(), steps.end()) == steps.end(), "T1",
            "an edge occurs twice in the tiles of face", f);
    std::map<uint64_t, uint64_t> rim;
    for (const DmsStep& s : steps)
      if (!std::binary_search(steps.begin(), steps.end(), DmsStep(s.second, s.first)))
        require(rim.insert(s).second, "T1", "the rim branches, of face", f);
    for (size_t c = 0; c < 3; ++c) {
      const uint64_t to = model.faces[f].vertex[(c + 1) % 3];
      for (uint64_t at = model.faces[f].vertex[c]; at != to;) {
        const auto next = rim.find(at);
        require(next != rim.end(), "T1", "the rim does not run around face", f);
        require(is_step(point(model.faces[f].vertex[c]), point(to), point(at), point(next->second)),
                "T1", "the rim leaves a side or turns back, of face", f);
        at = next->second;
        rim.erase(next);
      }
    }
    require(rim.empty(), "T1", "the rim has more parts, of face", f);
  }
  // Whether b lies on the segment from q to r, and farther than a, which lies on it.
  static bool is_step(const DmsPoint& q, const DmsPoint& r, const DmsPoint& a, const DmsPoint& b) {
    if (!DmsPlane::of(q, r, b).is_zero()) return false;
    for (int k = 0; k < 3; ++k) {
      const int way = dms_compare(r, q, k);
      if (way == 0) continue;
      return dms_compare(b, a, k) == way && dms_compare(b, r, k) != way;
    }
    return false;
  }

  // T2 and the coefficients for T3.
  std::vector<Ratio> check_tile(size_t number, const DmsNear& near,
                                const DmsPolynomials& polynomials) const {
    const DmsTile& tile = all[number].second;
    const std::vector<const DmsPoint*> corners = {&point(tile.corner[0]), &point(tile.corner[1]),
                                                  &point(tile.corner[2])};
    units->id = "T2";
    const std::vector<DmsTerm> terms = terms_on_triangle(near, corners, tile.planes, units, number);
    units->id = "T3";
    const DmsPoint inside = dms_middle(model, model.faces[all[number].first].tetrahedron);
    return polynomials.coefficients(model, corners, &inside, terms, units);
  }
};

}  // namespace

DmsNumbers check_dms_surface(const DmsModel& model, const DmsBody& body, uint64_t file_bytes,
                             Units* units) {
  DmsTiles tiles = {model, body, units, {}, {}, {}};
  tiles.read();
  for (size_t first = 0, last = 0; first < tiles.all.size(); first = last) {
    const size_t f = tiles.all[first].first;
    while (last < tiles.all.size() && tiles.all[last].first == f) ++last;
    tiles.check_face(f, first, last);
  }
  const DmsNear near(model);
  const DmsPolynomials polynomials(model.file.n, 3);
  std::vector<std::vector<Ratio>> triangles;
  for (size_t i = 0; i < tiles.all.size(); ++i)
    triangles.push_back(tiles.check_tile(i, near, polynomials));
  return check_dms_boxes(triangles, model.file.n, body.surface, file_bytes, "T3");
}
