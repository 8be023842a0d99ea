// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_near.h"

#include <set>

DmsNear::DmsNear(const DmsModel& m) : model(m) {
  for (size_t t = 0; t < model.file.tetrahedra.size(); ++t) {
    DmsBox box;
    for (size_t c = 0; c < 4; ++c)
      for (int i = 0; i < model.file.n; ++i) box.add(model.points[model.knot(t, c, i)]);
    boxes.push_back(box);
  }
  tree.reset(new DmsBoxes(boxes));
}
std::vector<uint32_t> DmsNear::knots_of(const DmsTerm& term) const {
  std::vector<uint32_t> r;
  for (size_t c = 0; c < 4; ++c)
    for (int i = 0; i <= term.gamma[c]; ++i) r.push_back(model.knot(term.tetrahedron, c, i));
  std::sort(r.begin(), r.end());
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}
std::vector<DmsTerm> DmsNear::not_excluded(const DmsBox& box, DmsSides* sides, Units* units) const {
  std::vector<DmsTerm> r;
  const size_t n = size_t(model.file.n);
  std::vector<DmsMask> first[4];  // of the first knots of the clouds
  for (uint32_t t : tree->near(box)) {
    for (size_t c = 0; c < 4; ++c) {
      first[c].assign(1, sides->mask(model, model.knot(t, c, 0)));
      for (size_t i = 1; i < n; ++i) {
        first[c].push_back(first[c].back());
        first[c].back() &= sides->mask(model, model.knot(t, c, int(i)));
      }
    }
    for (const DmsIndex& g : model.gammas) {
      DmsMask mask = first[0][size_t(g[0])];
      for (size_t c = 1; c < 4; ++c) mask &= first[c][size_t(g[c])];
      if ((mask.first & kDmsAxes) != 0) continue;
      units->add(1);
      if (!mask.any()) r.push_back(DmsTerm{t, g});
    }
  }
  return r;
}
std::vector<DmsTerm> DmsNear::filtered(
    const DmsBox& box, DmsSides* sides, Units* units,
    const std::function<bool(const std::vector<uint32_t>& knots)>& keeps) const {
  std::vector<DmsTerm> r;
  for (const DmsTerm& term : not_excluded(box, sides, units))
    if (keeps(knots_of(term))) r.push_back(term);
  return r;
}
void DmsNear::check_cuts(const std::vector<DmsTerm>& terms, DmsSides* sides, Units* units,
                         const char* why, size_t number) const {
  each_cut(terms, units, [&](const std::array<uint32_t, 3>& knots) {
    DmsMask mask = sides->all();
    for (uint32_t k : knots) mask &= sides->mask(model, k);
    if (mask.any()) return;
    const DmsPlane plane = plane_of(knots);
    require(plane.is_zero() || sides->is_beside(plane), units->id, why, number);
  });
}
void DmsNear::each_cut(const std::vector<DmsTerm>& terms, Units* units,
                       const std::function<void(const std::array<uint32_t, 3>& knots)>& use) const {
  std::set<std::array<uint32_t, 3>> seen;
  for (const DmsTerm& term : terms) {
    const std::vector<uint32_t> v = knots_of(term);
    for (size_t a = 0; a < v.size(); ++a)
      for (size_t b = a + 1; b < v.size(); ++b)
        for (size_t c = b + 1; c < v.size(); ++c) {
          const std::array<uint32_t, 3> knots = {{v[a], v[b], v[c]}};
          if (!seen.insert(knots).second) continue;
          units->add(1);
          use(knots);
        }
  }
}

void dms_corners(const DmsModel& model, const DmsTerm& term, const DmsPoint** w, const Ratio** c) {
  for (size_t m = 0; m < 4; ++m) {
    w[m] = &model.points[model.knot(term.tetrahedron, m, term.gamma[m])];
    c[m] = model.file.value(term.tetrahedron, dms_raised(term.gamma, m));
  }
}
const std::vector<Big>& DmsMatrices::of(const DmsTerm& term) {
  const size_t kMost = 1 << 15;
  const uint64_t key = uint64_t(term.tetrahedron) * 64 + dms_place(term.gamma, model.file.n - 1);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  if (known.size() >= kMost) known.clear();
  const DmsPoint* w[4];
  const Ratio* c[4];
  dms_corners(model, term, w, c);
  return known[key] = dms_linear_part(w, c);
}
