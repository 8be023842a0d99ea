// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_pairs.cc: U1 to U6 of docs/certificates/dms-solid-2.md.
#include <map>

#include "dms_pieces.h"

namespace {

typedef std::vector<Big> DmsVector;  // three numbers

Big dms_product(const DmsVector& v, const Big* x) {
  return v[0] * x[0] + v[1] * x[1] + v[2] * x[2];
}
// b - a, times a positive number.
DmsVector dms_way(const DmsPoint& a, const DmsPoint& b) {
  DmsVector r;
  for (int k = 0; k < 3; ++k) r.push_back(b.x[k] * a.x[3] - a.x[k] * b.x[3]);
  return r;
}
DmsVector dms_opposite(DmsVector v) {
  for (Big& x : v) x = -x;
  return v;
}
DmsVector dms_direction(const std::vector<Ratio>& all, size_t number) {
  const auto first = all.begin() + std::ptrdiff_t(3 * number);
  return dms_integers(std::vector<Ratio>(first, first + 3), nullptr);
}

// The V_gamma that are not excluded from a tetrahedron or a block, with their G.
struct DmsReach {
  std::vector<DmsTerm> terms;
  std::vector<std::vector<Big>> matrices;  // times positive numbers

  // Whether all G, along this vector, grow in the direction w.
  bool grows(const DmsVector& w, const DmsVector& along, Units* units) const {
    for (const std::vector<Big>& g : matrices) {
      units->add(1);
      Big x;
      for (size_t k = 0; k < 3; ++k)
        x = x + (w[0] * g[k] + w[1] * g[3 + k] + w[2] * g[6 + k]) * along[k];
      if (x.sign() <= 0) return false;
    }
    return true;
  }
};
struct DmsFaceValues {  // L_gamma at the three corners, term after term
  std::vector<DmsPoint> values;
  DmsBox box;
};

struct DmsPairs {
  const DmsModel& model;
  const DmsBody& body;
  Units* units;
  const DmsNear near;
  std::map<size_t, DmsReach> tetrahedra;
  std::vector<DmsFaceValues> faces;
  std::map<size_t, std::vector<size_t>> blocks_of;  // a tetrahedron

  DmsPairs(const DmsModel& m, const DmsBody& b, Units* u) : model(m), body(b), units(u), near(m) {}

  const DmsPoint* const* corners_of(const DmsTerm& term, const DmsPoint** w, const Ratio** c) const {
    for (size_t m = 0; m < 4; ++m) {
      w[m] = &model.points[model.knot(term.tetrahedron, m, term.gamma[m])];
      c[m] = model.file.value(term.tetrahedron, dms_raised(term.gamma, m));
    }
    return w;
  }
  DmsReach reach_of(const std::vector<const DmsPoint*>& corners, DmsSides* sides) const {
    DmsReach r;
    r.terms = near.not_excluded(DmsBox(corners), sides, units);
    for (const DmsTerm& term : r.terms) {
      const DmsPoint* w[4];
      const Ratio* c[4];
      r.matrices.push_back(dms_linear_part(corners_of(term, w, c), c));
    }
    return r;
  }
  const DmsReach& reach(size_t t) {
    const auto found = tetrahedra.find(t);
    if (found != tetrahedra.end()) return found->second;
    std::vector<const DmsPoint*> corners;
    for (size_t c = 0; c < 4; ++c) corners.push_back(&model.corner(t, c));
    DmsSides sides = dms_sides_of_leaf(corners, {}, {});
    return tetrahedra[t] = reach_of(corners, &sides);
  }
  DmsFaceValues values_of(const DmsFace& face) {
    DmsFaceValues r;
    for (const DmsTerm& term : reach(face.tetrahedron).terms) {
      const DmsPoint* w[4];
      const Ratio* c[4];
      add_values(corners_of(term, w, c), c, face, &r);
    }
    return r;
  }
  // lambda_m(q|w) is, with homogeneous points, d with q in the place of the m-th times its denominator, divided by d of
  // all and the denominator of q.
  void add_values(const DmsPoint* const* w, const Ratio* const* c, const DmsFace& face,
                  DmsFaceValues* r) const {
    std::vector<Ratio> numbers;
    for (size_t m = 0; m < 4; ++m) numbers.insert(numbers.end(), c[m], c[m] + 3);
    Big factor;
    const std::vector<Big> images = dms_integers(numbers, &factor);
    DmsPlane opposite[4];
    for (size_t m = 0; m < 4; ++m)
      opposite[m] = DmsPlane::of(*w[m == 0 ? 1 : 0], *w[m < 2 ? 2 : 1], *w[m < 3 ? 3 : 2]);
    const Big all = opposite[3].value(*w[3]);
    for (uint32_t vertex : face.vertex) {
      const DmsPoint& q = model.place(vertex);
      Big x[4];
      for (size_t m = 0; m < 4; ++m) {
        const Big d = opposite[m].value(q) * w[m]->x[3];
        for (size_t k = 0; k < 3; ++k) {
          const Big part = d * images[3 * m + k];
          x[k] = m % 2 == 1 ? x[k] + part : x[k] - part;
        }
      }
      x[3] = all * q.x[3] * factor;
      r->values.push_back(DmsPoint::of(x));
      r->box.add(r->values.back());
    }
  }

  // U1, U2
  void check_block(size_t number) {
    const DmsBlock& block = body.blocks[number];
    std::vector<const DmsPoint*> corners;
    std::vector<DmsPlane> planes;
    for (uint64_t t : block.tetrahedra) {
      const DmsPoint* own[4];
      for (size_t c = 0; c < 4; ++c) own[c] = &model.corner(size_t(t), c);
      corners.insert(corners.end(), own, own + 4);
      add_dms_faces(own, &planes);
      blocks_of[size_t(t)].push_back(number);
    }
    for (size_t i = 0; i < block.planes.size(); i += 4)
      planes.push_back(DmsPlane::of(&block.planes[i]));
    DmsSides sides(corners, planes, true);
    units->id = "U1";
    for (uint32_t f : face_boxes->near(DmsBox(corners))) {
      units->add(1);
      DmsMask mask = sides.all();
      const DmsPoint* q[3];
      for (size_t c = 0; c < 3; ++c) {
        const uint32_t vertex = model.faces[f].vertex[c];
        q[c] = &model.place(vertex);
        mask &= sides.mask(model, model.clouds[vertex][0]);
      }
      require(mask.any() || sides.is_beside(DmsPlane::of(*q[0], *q[1], *q[2])), "U1",
              "a face of the boundary may reach into block", number);
    }
    units->id = "U2";
    const std::vector<Big> r = dms_integers(block.r, nullptr);
    for (const std::vector<Big>& g : reach_of(corners, &sides).matrices)
      require(dms_is_positive(r, g), "U2", "R G is not positive, in block", number);
  }
  std::unique_ptr<DmsBoxes> face_boxes;
  std::vector<DmsBox> boxes_of_faces;

  void check_blocks() {
    for (const DmsFace& face : model.faces) {
      DmsBox box;
      for (uint32_t v : face.vertex) box.add(model.place(v));
      boxes_of_faces.push_back(box);
    }
    face_boxes.reset(new DmsBoxes(boxes_of_faces));
    for (size_t b = 0; b < body.blocks.size(); ++b) check_block(b);
  }
  void check_faces() {
    for (size_t f = 0; f < model.faces.size(); ++f) {
      const size_t t = model.faces[f].tetrahedron;
      const DmsTree& tree = body.trees[t];
      const bool is_one_leaf = tree.symbols.size() == 1 && !tree.leaves[0].is_polynomial;
      require(is_one_leaf || blocks_of.count(t) > 0, "U3", "nothing is known of face", f);
    }
  }
  bool are_in_block(size_t i, size_t j) const {
    const auto a = blocks_of.find(model.faces[i].tetrahedron),
               b = blocks_of.find(model.faces[j].tetrahedron);
    if (a == blocks_of.end() || b == blocks_of.end()) return false;
    for (size_t block : a->second)  // both lists ascend
      if (std::binary_search(b->second.begin(), b->second.end(), block)) return true;
    return false;
  }

  void check_pair(const DmsPair& pair) {
    const size_t i = size_t(pair.face[0]), j = size_t(pair.face[1]);
    if (pair.kind == DmsPair::kApart) {
      units->id = "U6";
      require(is_apart(i, j, dms_direction(pair.directions, 0)), "U6",
              "the direction does not part another face from face", i);
    } else if (pair.kind == DmsPair::kChain) {
      units->id = "U5";
      check_chain(pair);
    } else {
      units->id = "U4";
      check_at_edge(pair);
    }
  }
  void must_grow(size_t t, const DmsVector& w, const DmsVector& along, size_t face) {
    require(reach(t).grows(w, along, units), units->id, "a direction is not that of growth, of face",
            face);
  }
  bool has_vertex(size_t tetrahedron, uint64_t vertex) const {
    const std::array<uint32_t, 4>& v = model.file.tetrahedra[tetrahedron];
    return std::find(v.begin(), v.end(), vertex) != v.end();
  }
  void check_chain(const DmsPair& pair) {
    const size_t i = size_t(pair.face[0]);
    const DmsVector w = dms_direction(pair.directions, 0);
    for (size_t side = 0; side < 2; ++side) {
      const DmsFace& face = model.faces[size_t(pair.face[side])];
      const uint64_t end = side == 0 ? pair.chain.front() : pair.chain.back();
      bool is_corner = false;
      for (uint32_t v : face.vertex) {
        is_corner = is_corner || v == end;
        if (v == end) continue;
        const DmsVector way = dms_way(model.place(v), model.place(uint32_t(end)));
        must_grow(face.tetrahedron, w, side == 0 ? way : dms_opposite(way), i);
      }
      require(is_corner, "U5", "a chain does not end at a corner, of face", i);
    }
    for (size_t k = 0; k < pair.tetrahedra.size(); ++k) {
      const size_t t = size_t(pair.tetrahedra[k]);
      require(has_vertex(t, pair.chain[k]) && has_vertex(t, pair.chain[k + 1]), "U5",
              "an edge of a chain is not in tetrahedron", t);
      must_grow(t, w,
                dms_way(model.place(uint32_t(pair.chain[k])), model.place(uint32_t(pair.chain[k + 1]))),
                i);
    }
  }
  // The third corner less the foot t on the edge from the first to the second one, times a positive number.
  static DmsVector from_foot(const DmsPoint& u, const DmsPoint& v, const DmsPoint& a,
                             const Ratio& t) {
    const Big f = (t.d - t.n) * v.x[3], g = t.n * u.x[3];
    Big x[4];
    for (int k = 0; k < 3; ++k) x[k] = f * u.x[k] + g * v.x[k];
    x[3] = t.d * u.x[3] * v.x[3];
    return dms_way(DmsPoint::of(x), a);
  }
  void check_at_edge(const DmsPair& pair) {
    const DmsFace &a = model.faces[size_t(pair.face[0])], &b = model.faces[size_t(pair.face[1])];
    size_t from = 3, third = 3;  // corners of a: where the edge begins, and off it
    for (size_t c = 0; c < 3; ++c) {
      const auto has = [&](size_t i) {
        return std::find(b.vertex.begin(), b.vertex.end(), a.vertex[i % 3]) != b.vertex.end();
      };
      if (has(c) && has(c + 1) && !has(c + 2)) from = c, third = (c + 2) % 3;
    }
    require(from < 3, "U4", "there is no common edge, of face", size_t(pair.face[0]));
    const uint32_t u = a.vertex[from], v = a.vertex[(from + 1) % 3];
    uint32_t other = 0;
    for (uint32_t x : b.vertex)
      if (x != u && x != v) other = x;
    const DmsPoint &begin = model.place(u), &end = model.place(v);
    const DmsVector edge = dms_way(begin, end),
                    to_edge = dms_opposite(
                        from_foot(begin, end, model.place(a.vertex[third]), pair.feet[0])),
                    from_edge = from_foot(begin, end, model.place(other), pair.feet[1]);
    for (size_t d = 0; d < 2; ++d) {
      const DmsVector w = dms_direction(pair.directions, d);
      must_grow(a.tetrahedron, w, to_edge, size_t(pair.face[0]));
      must_grow(a.tetrahedron, w, d == 0 ? edge : dms_opposite(edge), size_t(pair.face[0]));
      must_grow(b.tetrahedron, w, from_edge, size_t(pair.face[0]));
    }
  }
  // Whether all products with the values of i are below those of j.
  bool is_apart(size_t i, size_t j, const DmsVector& v) const {
    Ratio bound[2];
    for (size_t side = 0; side < 2; ++side) {
      bool is_first = true;
      for (const DmsPoint& p : faces[side == 0 ? i : j].values) {
        units->add(1);
        const Ratio x(dms_product(v, p.x), p.x[3]);
        const int order = is_first ? 0 : compare(x, bound[side]);
        if (is_first || order == (side == 0 ? 1 : -1)) bound[side] = x;
        is_first = false;
      }
    }
    return compare(bound[0], bound[1]) < 0;
  }
  bool has_apart_boxes(size_t i, size_t j) const {
    for (size_t k = 0; k < 3; ++k)
      for (int sign = -1; sign <= 1; sign += 2) {
        DmsVector axis(3);
        axis[k] = Big(sign);
        if (is_apart(i, j, axis)) return true;
      }
    return false;
  }

  void check_pairs() {
    std::vector<DmsBox> boxes;
    for (const DmsFace& face : model.faces) {
      faces.push_back(values_of(face));
      boxes.push_back(faces.back().box);
    }
    const DmsBoxes tree(boxes);
    size_t next = 0;  // of the list
    for (size_t i = 0; i < faces.size(); ++i) {
      size_t at = next;
      for (; next < body.pairs.size() && body.pairs[next].face[0] == i; ++next)
        check_pair(body.pairs[next]);
      units->id = "U6";
      for (uint32_t j : tree.near(boxes[i])) {
        if (j <= i) continue;
        units->add(1);
        while (at < next && body.pairs[at].face[1] < j) ++at;
        if (at < next && body.pairs[at].face[1] == j) continue;
        require(are_in_block(i, j) || has_apart_boxes(i, j), "U6", "a pair is missing, of face", i);
      }
    }
  }
};

}  // namespace

void check_dms_pairs(const DmsModel& model, const DmsBody& body, Units* units) {
  DmsPairs check(model, body, units);
  check.check_blocks();
  check.check_faces();
  check.check_pairs();
}
