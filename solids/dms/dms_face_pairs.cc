// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_face_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include "interval/interval.h"
#include "interval/numeric.h"
#include "interval/upward.h"
#include "robust/base/disjoint_sets.h"
#include "robust/base/parallel.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_monotone.h"
#include "solids/dms/dms_region.h"
#include "solids/dms/nearest_of_hull.h"
#include "solids/dms/plain_matrix.h"

namespace veritope {
namespace {

using internal::PlainMatrix;
using internal::PlainVector;
using IntervalVector = std::array<Interval, 3>;

constexpr std::size_t kItemsOfChunk = 8;
constexpr int kWordBits = 30;  // of the greatest entry of a direction
constexpr std::size_t kMostPairs = 20000, kMostPairsOfFace = 200;  // and so many for each face
constexpr double kInfinity = std::numeric_limits<double>::infinity();

PlainVector middle_of(const IntervalVector& v) { return {mid(v[0]), mid(v[1]), mid(v[2])}; }
PlainMatrix middle_of(const EnclosedMatrix& m) {
  PlainMatrix out;
  for (std::size_t i = 0; i < 9; ++i) out[i] = mid(m.bounds[i]);
  return out;
}
PlainVector image_of(const PlainMatrix& m, const PlainVector& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
          m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}
DmsPoint image_of(const DmsMatrix& m, const DmsPoint& v) {
  DmsPoint out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2];
  return out;
}
IntervalVector enclosed(const DmsPoint& p) { return {enclose(p[0]), enclose(p[1]), enclose(p[2])}; }
IntervalVector enclosed(const PlainVector& v) {
  return {Interval(v[0]), Interval(v[1]), Interval(v[2])};
}
DmsPoint exact(const PlainVector& w) {
  return {Rational::from_double(w[0]), Rational::from_double(w[1]), Rational::from_double(w[2])};
}
// REQUIRES a live ScopedUpward.
Interval product(const IntervalVector& w, const IntervalVector& v) {
  return w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
}

// The direction with few bits: all entries have as many as the greatest one, while their denominators stay below 2^31.
std::optional<PlainVector> shortened(PlainVector w) {
  double most = 0;
  for (const double x : w) most = std::max(most, std::abs(x));
  if (!(most > 0) || !std::isfinite(most)) return std::nullopt;
  int greatest = 0;
  std::frexp(most, &greatest);
  for (double& x : w) {
    x = std::ldexp(x, kWordBits - greatest);
    int own = 0;
    std::frexp(x, &own);
    const int unit = std::max(own - kWordBits, -kWordBits);
    x = std::ldexp(std::round(std::ldexp(x, -unit)), unit);
  }
  return w;
}

// What the map may be on a tetrahedron with a face of the boundary.
struct TetrahedronForm {
  std::vector<DmsSupport> supports;  // that reach into it
  std::vector<const EnclosedMatrix*> derivatives;
  PlainMatrix to_regular{};  // takes images of the tetrahedron to about a regular one
};
// Values of the L_γ of its tetrahedron at the corners of a face, less the origin of all.
struct FaceValues {
  std::vector<IntervalVector> values;
  Box3d box = empty_box();
};

// Derivatives on a tetrahedron along a vector.
struct Bundle {
  const TetrahedronForm* form = nullptr;
  DmsPoint along;
};

// A direction in which all derivatives of the bundles grow.
bool is_growing(std::span<const Bundle> bundles, const PlainVector& w) {
  const ScopedUpward upward;
  const IntervalVector bounds = enclosed(w);
  for (const Bundle& bundle : bundles) {
    const IntervalVector along = enclosed(bundle.along);
    for (const EnclosedMatrix* const g : bundle.form->derivatives) {
      const auto& m = g->bounds;
      const IntervalVector row = {product(bounds, {m[0], m[3], m[6]}),
                                  product(bounds, {m[1], m[4], m[7]}),
                                  product(bounds, {m[2], m[5], m[8]})};
      if (!(product(row, along).lo() > 0)) return false;
    }
  }
  return true;
}
std::optional<DmsPoint> find_direction(std::span<const Bundle> bundles,
                                       const PlainMatrix& to_regular) {
  std::vector<PlainVector> vectors;
  for (const Bundle& bundle : bundles) {
    const PlainVector along = middle_of(enclosed(bundle.along));
    for (const EnclosedMatrix* const g : bundle.form->derivatives) {
      PlainVector v = image_of(to_regular, image_of(middle_of(*g), along));
      const double length = std::sqrt(internal::dot_product(v, v));
      if (!(length > 0)) return std::nullopt;
      for (double& x : v) x /= length;
      vectors.push_back(v);
    }
  }
  const auto nearest = internal::nearest_of_hull([&](const PlainVector& w) {
    return *std::min_element(vectors.begin(), vectors.end(),
                             [&](const PlainVector& a, const PlainVector& b) {
                               return internal::dot_product(a, w) < internal::dot_product(b, w);
                             });
  });
  if (!nearest) return std::nullopt;
  const auto w = shortened(image_of(internal::transposed(to_regular), *nearest));
  if (!w || !is_growing(bundles, *w)) return std::nullopt;
  return exact(*w);
}

class FacePairProof {
 public:
  FacePairProof(const DmsModel& model, const TetrahedralComplex& complex,
                const std::vector<DmsLeafTree>& trees, const DmsFacePairOptions& options)
      : model_(model), complex_(complex), trees_(trees), options_(options), knots_(model) {
    const auto value = model.value(0);
    std::copy_n(value.begin(), 3, origin_.begin());
  }

  std::variant<DmsFacePairs, DmsOpenPair> run() {
    make_forms();
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (!is_finite(faces_[i].box) || !is_proved_alone(i)) return DmsOpenPair{i, i};
    if (const auto open = find_meeting_shells()) return *open;
    if (const auto open = find_pairs()) return *open;
    std::vector<char> is_found(pairs_.size(), 0);
    for_all(pairs_.size(), [&](std::size_t i) { is_found[i] = prove_pair(pairs_[i]) ? 1 : 0; });
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (is_found[i] == 0 && is_in_block(pairs_[i])) continue;
      if (is_found[i] == 0 && add_block(pairs_[i])) continue;
      if (is_found[i] == 0 && !prove_by_chain(pairs_[i]))
        return DmsOpenPair{pairs_[i].first, pairs_[i].second};
      out_.pairs.push_back(std::move(pairs_[i]));
    }
    return std::move(out_);
  }

 private:
  template <typename Do>
  void for_all(std::size_t count, Do act) {
    WorkStep step(options_.work, static_cast<double>(count));
    parallel_for(count, kItemsOfChunk, options_.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) act(i);
                   step.add(static_cast<double>(end - begin));
                 });
  }

  const std::vector<TetrahedronFace>& boundary() const { return complex_.boundary(); }
  std::uint32_t tetrahedron(std::size_t face) const { return face_tetrahedron(boundary()[face]); }
  const TetrahedronForm& form(std::size_t face) const { return forms_.at(tetrahedron(face)); }
  const DmsPoint& place(std::uint32_t vertex) const { return model_.knot(vertex, 0); }

  void make_forms() {
    for (const TetrahedronFace f : boundary()) {
      make_form(face_tetrahedron(f));
      faces_.push_back(values_on(f));
    }
  }
  const TetrahedronForm& make_form(std::uint32_t tetrahedron) {
    TetrahedronForm& form = forms_[tetrahedron];
    if (!form.supports.empty()) return form;
    const auto corners = knots_.corners(tetrahedron);
    DmsRegion region(knots_, {corners.begin(), corners.end()}, face_planes(corners));
    form.supports = region.supports();
    form.derivatives = derivatives_of(form.supports);
    form.to_regular = to_regular(form.derivatives, corners);
    return form;
  }
  std::vector<const EnclosedMatrix*> derivatives_of(std::span<const DmsSupport> supports) {
    std::vector<const EnclosedMatrix*> out;
    for (const DmsSupport& s : supports) {
      const std::uint64_t key = knots_.key(s);
      auto found = derivatives_.find(key);
      if (found == derivatives_.end())
        found = derivatives_.emplace(key, EnclosedMatrix(knots_.derivative(s))).first;
      out.push_back(&found->second);
    }
    return out;
  }
  static PlainMatrix to_regular(std::span<const EnclosedMatrix* const> derivatives,
                                const std::array<DmsPoint, 4>& corners) {
    PlainMatrix mean{}, edges{};
    for (const EnclosedMatrix* const g : derivatives)
      for (std::size_t i = 0; i < 9; ++i) mean[i] += mid(g->bounds[i]);
    for (double& x : mean) x /= static_cast<double>(derivatives.size());
    for (std::size_t e = 0; e < 3; ++e) {
      const PlainVector edge = middle_of(enclosed(difference(corners[e + 1], corners[0])));
      for (std::size_t c = 0; c < 3; ++c) edges[3 * c + e] = edge[c];
    }
    const auto inverse =
        internal::inverse_of(internal::from_regular(internal::multiplied(mean, edges)));
    return inverse.value_or(PlainMatrix{});
  }
  FaceValues values_on(TetrahedronFace f) const {
    FaceValues out;
    const TetrahedronForm& form = forms_.at(face_tetrahedron(f));
    for (std::size_t i = 0; i < form.supports.size(); ++i) {
      const DmsSupport& support = form.supports[i];
      const DmsPoint& knot =
          model_.knot(model_.tetrahedra[support.tetrahedron][0], support.gamma[0]);
      const auto value =
          model_.value(control_of(model_, support.tetrahedron, raised(support.gamma, 0)));
      for (const std::uint32_t v : complex_.vertices(f)) {
        const DmsPoint step = image_of(form.derivatives[i]->exact, difference(place(v), knot));
        IntervalVector& p = out.values.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
          p[c] = enclose(value[c] - origin_[c] + step[c] / Rational(model_.degree));
          out.box.lo[c] = std::min(out.box.lo[c], p[c].lo());
          out.box.hi[c] = std::max(out.box.hi[c], p[c].hi());
        }
      }
    }
    return out;
  }

  // U3
  bool is_proved_alone(std::size_t face) {
    const std::uint32_t t = tetrahedron(face);
    const DmsLeafTree& tree = trees_[t];
    const auto* const leaf = std::get_if<DmsLeaf>(&tree[0]);
    if (leaf != nullptr && !leaf->is_polynomial) return true;
    const auto& blocks = blocks_of_[t];
    return !blocks.empty() || add_block_of({t});
  }

  // U7: first faces of two shells whose boxes meet.
  std::optional<DmsOpenPair> find_meeting_shells() const {
    DisjointSets<> connected(complex_.num_vertices());
    for (const TetrahedronFace f : boundary()) {
      const auto v = complex_.vertices(f);
      connected.join(v[0], v[1]);
      connected.join(v[0], v[2]);
    }
    std::map<std::uint32_t, std::size_t> number;
    std::vector<std::size_t> first;
    std::vector<Box3d> boxes;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::uint32_t root = connected.find(complex_.vertices(boundary()[i])[0]);
      const auto [at, is_new] = number.emplace(root, boxes.size());
      if (is_new) first.push_back(i), boxes.push_back(empty_box());
      Box3d& box = boxes[at->second];
      for (std::size_t c = 0; c < 3; ++c) {
        box.lo[c] = std::min(box.lo[c], faces_[i].box.lo[c]);
        box.hi[c] = std::max(box.hi[c], faces_[i].box.hi[c]);
      }
    }
    const BoxHierarchy tree(boxes);
    std::optional<DmsOpenPair> open;
    for (std::size_t i = 0; i < boxes.size() && !open; ++i)
      tree.visit([&](const Box3d& b) { return meets(b, boxes[i]); },
                 [&](std::uint32_t j) {
                   if (j != i)
                     open = DmsOpenPair{std::min(first[i], first[j]), std::max(first[i], first[j])};
                 });
    return open;
  }

  // Faces with a common vertex, and faces whose boxes meet; a face where there are too many.
  std::optional<DmsOpenPair> find_pairs() {
    std::vector<Box3d> boxes;
    for (const FaceValues& values : faces_) boxes.push_back(values.box);
    const BoxHierarchy tree(boxes);
    std::vector<std::vector<std::uint32_t>> at_vertex(complex_.num_vertices());
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
      for (const std::uint32_t v : complex_.vertices(boundary()[i])) at_vertex[v].push_back(i);
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      std::vector<std::uint32_t> others;
      tree.visit([&](const Box3d& b) { return meets(b, boxes[i]); },
                 [&](std::uint32_t j) { others.push_back(j); });
      for (const std::uint32_t v : complex_.vertices(boundary()[i]))
        others.insert(others.end(), at_vertex[v].begin(), at_vertex[v].end());
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
      for (const std::uint32_t j : others)
        if (j > i) pairs_.push_back({i, j});
      if (pairs_.size() > kMostPairsOfFace * faces_.size() + kMostPairs) return DmsOpenPair{i, i};
    }
    return std::nullopt;
  }
  bool have_common_vertex(const DmsFacePair& pair) const {
    const auto a = complex_.vertices(boundary()[pair.first]),
               b = complex_.vertices(boundary()[pair.second]);
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

  bool prove_pair(DmsFacePair& pair) const {
    const auto a = complex_.vertices(boundary()[pair.first]),
               b = complex_.vertices(boundary()[pair.second]);
    std::vector<std::uint32_t> common;  // in the order of the first face
    for (std::size_t i = 0; i < 3; ++i)
      if (std::find(b.begin(), b.end(), a[i]) != b.end()) common.push_back(a[i]);
    if (common.size() == 2 && a[0] == common[0] && a[2] == common[1])
      std::swap(common[0], common[1]);
    if (common.empty()) return prove_apart(pair);
    if (common.size() == 1) return prove_along(pair, common, {});
    return prove_at_edge(pair, common[0], common[1]);
  }

  // U6
  bool prove_apart(DmsFacePair& pair) const {
    pair.kind = DmsFacePair::Kind::kApart;
    const FaceValues &a = faces_[pair.first], &b = faces_[pair.second];
    const PlainMatrix forth = form(pair.first).to_regular, back = internal::transposed(forth);
    const auto extreme = [](const FaceValues& face, const PlainVector& w, double sign) {
      PlainVector out{};
      double most = -kInfinity;
      for (const IntervalVector& v : face.values) {
        const PlainVector p = middle_of(v);
        if (const double x = sign * internal::dot_product(w, p); x > most) most = x, out = p;
      }
      return out;
    };
    const auto nearest = internal::nearest_of_hull([&](const PlainVector& w) {
      const PlainVector in_space = image_of(back, w), high = extreme(a, in_space, 1),
                        low = extreme(b, in_space, -1);
      return image_of(forth, {low[0] - high[0], low[1] - high[1], low[2] - high[2]});
    });
    if (!nearest) return false;
    const auto w = shortened(image_of(back, *nearest));
    if (!w) return false;
    const ScopedUpward upward;
    const IntervalVector bounds = enclosed(*w);
    double most = -kInfinity, least = kInfinity;
    for (const IntervalVector& v : a.values) most = std::max(most, product(bounds, v).hi());
    for (const IntervalVector& v : b.values) least = std::min(least, product(bounds, v).lo());
    if (!(most < least)) return false;
    pair.directions.push_back(exact(*w));
    return true;
  }

  // U5
  bool prove_along(DmsFacePair& pair, std::vector<std::uint32_t> chain,
                   std::vector<std::uint32_t> tetrahedra) const {
    std::vector<Bundle> bundles;
    for (const std::uint32_t v : complex_.vertices(boundary()[pair.first]))
      if (v != chain.front())
        bundles.push_back({&form(pair.first), difference(place(chain.front()), place(v))});
    for (std::size_t i = 0; i < tetrahedra.size(); ++i)
      bundles.push_back(
          {&forms_.at(tetrahedra[i]), difference(place(chain[i + 1]), place(chain[i]))});
    for (const std::uint32_t v : complex_.vertices(boundary()[pair.second]))
      if (v != chain.back())
        bundles.push_back({&form(pair.second), difference(place(v), place(chain.back()))});
    auto found = find_direction(bundles, form(pair.first).to_regular);
    if (!found) return false;
    pair.kind = DmsFacePair::Kind::kChain;
    pair.directions.assign(1, std::move(*found));
    pair.chain = std::move(chain);
    pair.tetrahedra = std::move(tetrahedra);
    return true;
  }
  // Chains of one or two edges between faces without a common vertex.
  bool prove_by_chain(DmsFacePair& pair) {
    if (have_common_vertex(pair)) return false;
    for (const std::uint32_t a : complex_.vertices(boundary()[pair.first]))
      for (const std::uint32_t b : complex_.vertices(boundary()[pair.second])) {
        if (const auto t = tetrahedron_at(a, b); t && prove_along(pair, {a, b}, {*t})) return true;
        for (const std::uint32_t c : neighbours(a)) {
          if (c == b) continue;
          const auto first = tetrahedron_at(a, c), second = tetrahedron_at(c, b);
          if (first && second && prove_along(pair, {a, c, b}, {*first, *second})) return true;
        }
      }
    return false;
  }
  std::vector<std::uint32_t> neighbours(std::uint32_t vertex) const {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t t : complex_.tetrahedra_at(vertex))
      for (const std::uint32_t v : complex_.tetrahedra()[t])
        if (v != vertex) out.push_back(v);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }
  // The one at an edge that fewest V_γ reach, if the vertices are joined.
  std::optional<std::uint32_t> tetrahedron_at(std::uint32_t a, std::uint32_t b) {
    std::optional<std::uint32_t> out;
    std::size_t least = 0;
    for (const std::uint32_t t : complex_.tetrahedra_at(a, b)) {
      const std::size_t count = make_form(t).supports.size();
      if (!out || count < least) out = t, least = count;
    }
    return out;
  }

  // U4
  bool prove_at_edge(DmsFacePair& pair, std::uint32_t begin, std::uint32_t end) const {
    pair.kind = DmsFacePair::Kind::kAtEdge;
    const std::array<std::uint32_t, 2> edge = {begin, end};
    const std::array<double, 2> nearest = {foot(pair.first, edge), foot(pair.second, edge)};
    return prove_with_feet(pair, edge, nearest) ||
           (nearest != std::array{0.5, 0.5} && prove_with_feet(pair, edge, {0.5, 0.5}));
  }
  bool prove_with_feet(DmsFacePair& pair, const std::array<std::uint32_t, 2>& edge,
                       const std::array<double, 2>& feet) const {
    const DmsPoint along = difference(place(edge[1]), place(edge[0]));
    std::array<DmsPoint, 2> sides;  // from the feet to the apexes
    for (std::size_t i = 0; i < 2; ++i) {
      pair.feet[i] = Rational::from_double(feet[i]);
      sides[i] = difference(apex(i == 0 ? pair.first : pair.second, edge), place(edge[0]));
      for (std::size_t c = 0; c < 3; ++c) sides[i][c] -= pair.feet[i] * along[c];
    }
    const DmsPoint nothing{};
    pair.directions.clear();
    for (const DmsPoint& way : {along, difference(nothing, along)}) {
      const std::array<Bundle, 3> bundles = {
          Bundle{&form(pair.first), difference(nothing, sides[0])},
          Bundle{&form(pair.second), sides[1]}, Bundle{&form(pair.first), way}};
      auto found = find_direction(bundles, form(pair.first).to_regular);
      if (!found) return false;
      pair.directions.push_back(std::move(*found));
    }
    return true;
  }
  const DmsPoint& apex(std::size_t face, const std::array<std::uint32_t, 2>& edge) const {
    const auto v = complex_.vertices(boundary()[face]);
    return place(*std::find_if(v.begin(), v.end(),
                               [&](std::uint32_t x) { return x != edge[0] && x != edge[1]; }));
  }
  // Where the image of the apex is about nearest to that of the edge, in eighths.
  double foot(std::size_t face, const std::array<std::uint32_t, 2>& edge) const {
    const TetrahedronForm& f = form(face);
    const auto image = [&](const DmsPoint& v) {
      PlainVector sum{};
      const PlainVector along = middle_of(enclosed(v));
      for (const EnclosedMatrix* const g : f.derivatives) {
        const PlainVector x = image_of(middle_of(*g), along);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += x[c];
      }
      return image_of(f.to_regular, sum);
    };
    const PlainVector along = image(difference(place(edge[1]), place(edge[0]))),
                      side = image(difference(apex(face, edge), place(edge[0])));
    const double share = internal::dot_product(along, side) / internal::dot_product(along, along);
    return std::isfinite(share) ? std::round(8 * std::clamp(share, 0.0, 1.0)) / 8 : 0.5;
  }

  bool is_in_block(const DmsFacePair& pair) const {
    const auto a = blocks_of_.find(tetrahedron(pair.first)),
               b = blocks_of_.find(tetrahedron(pair.second));
    if (a == blocks_of_.end() || b == blocks_of_.end()) return false;
    return std::any_of(a->second.begin(), a->second.end(), [&](std::size_t block) {
      return std::find(b->second.begin(), b->second.end(), block) != b->second.end();
    });
  }
  bool add_block(const DmsFacePair& pair) {
    return add_block_of({tetrahedron(pair.first), tetrahedron(pair.second)});
  }
  bool add_block_of(std::vector<std::uint32_t> tetrahedra) {
    if (tetrahedra.size() == 2 && tetrahedra[0] == tetrahedra[1]) tetrahedra.pop_back();
    std::vector<DmsPoint> points;
    std::vector<DmsPlane> planes;
    for (const std::uint32_t t : tetrahedra) {
      const auto corners = knots_.corners(t);
      points.insert(points.end(), corners.begin(), corners.end());
      for (DmsPlane& plane : face_planes(corners)) planes.push_back(std::move(plane));
    }
    DmsRegion region(knots_, points, planes);
    if (!is_inside(region)) return false;
    const auto matrix =
        find_monotone_matrix(derivatives_of(region.supports()), knots_.corners(tetrahedra[0]));
    if (!matrix) return false;
    for (const std::uint32_t t : tetrahedra) blocks_of_[t].push_back(out_.blocks.size());
    out_.blocks.push_back({std::move(tetrahedra), *matrix});
    return true;
  }
  // Whether no face of the boundary reaches into the inside.
  bool is_inside(DmsRegion& region) {
    if (by_face_.order().empty()) {
      std::vector<Box3d> boxes;
      for (const TetrahedronFace f : boundary()) {
        std::vector<DmsPoint> corners;
        for (const std::uint32_t v : complex_.vertices(f)) corners.push_back(place(v));
        boxes.push_back(box_around(corners));
      }
      by_face_ = BoxHierarchy(boxes);
    }
    const Box3d box = box_around(region.corners());
    bool is_inside = true;
    by_face_.visit([&](const Box3d& b) { return is_inside && meets(b, box); },
                   [&](std::uint32_t i) {
                     const auto v = complex_.vertices(boundary()[i]);
                     is_inside = is_inside && region.misses_triangle({knots_.number(v[0], 0),
                                                                      knots_.number(v[1], 0),
                                                                      knots_.number(v[2], 0)});
                   });
    return is_inside;
  }

  const DmsModel& model_;
  const TetrahedralComplex& complex_;
  const std::vector<DmsLeafTree>& trees_;
  const DmsFacePairOptions& options_;
  DmsKnotTable knots_;
  DmsPoint origin_;
  std::unordered_map<std::uint64_t, EnclosedMatrix> derivatives_;
  std::map<std::uint32_t, TetrahedronForm> forms_;
  std::vector<FaceValues> faces_;
  std::vector<DmsFacePair> pairs_;
  std::map<std::uint32_t, std::vector<std::size_t>> blocks_of_;  // a tetrahedron
  BoxHierarchy by_face_;
  DmsFacePairs out_;
};

}  // namespace

std::variant<DmsFacePairs, DmsOpenPair> prove_face_pairs(const DmsModel& model,
                                                         const TetrahedralComplex& complex,
                                                         const std::vector<DmsLeafTree>& trees,
                                                         const DmsFacePairOptions& options) {
  return FacePairProof(model, complex, trees, options).run();
}

}  // namespace veritope
