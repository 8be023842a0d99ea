// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_pairs.cc: U1 to U7 of docs/certificates/dms-solid-2.md.
#include <iterator>

#include "dms_pieces.h"
#include "dms_reach.h"

namespace {

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

struct DmsPairs {
  const DmsModel& model;
  const DmsBody& body;
  Units* units;
  DmsReach reach;
  std::vector<DmsFaceValues> faces;
  std::map<size_t, std::vector<size_t>> blocks_of;  // a tetrahedron

  DmsPairs(const DmsModel& m, const DmsBody& b, Units* u)
      : model(m), body(b), units(u), reach(m, u) {}

  // U1, U2
  void check_block(size_t number, const DmsBoxes& face_boxes) {
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
    for (uint32_t f : face_boxes.near(DmsBox(corners))) {
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
    for (const DmsTerm& term : reach.near.not_excluded(DmsBox(corners), &sides, units))
      require(dms_is_positive(r, reach.matrices.of(term)), "U2", "R G is not positive, in block",
              number);
  }

  void check_blocks() {
    std::vector<DmsBox> boxes;
    for (const DmsFace& face : model.faces) {
      boxes.push_back(DmsBox());
      for (uint32_t v : face.vertex) boxes.back().add(model.place(v));
    }
    const DmsBoxes face_boxes(boxes);
    for (size_t b = 0; b < body.blocks.size(); ++b) check_block(b, face_boxes);
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
    require(reach.grows(t, w, along), units->id, "a direction is not that of growth, of face",
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
      must_grow(
          t, w,
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
    units->id = "U6";
    std::vector<DmsBox> boxes;
    for (const DmsFace& face : model.faces) {
      faces.push_back(reach.values(face));
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

  // The least number of a vertex that is connected with each vertex of the boundary.
  std::vector<uint32_t> shells_of_vertices() const {
    std::vector<uint32_t> least(model.clouds.size());
    for (uint32_t v = 0; v < least.size(); ++v) least[v] = v;
    for (const DmsFace& face : model.faces) {
      uint32_t root[3];
      for (size_t c = 0; c < 3; ++c) {
        root[c] = face.vertex[c];
        while (least[root[c]] != root[c]) root[c] = least[root[c]] = least[least[root[c]]];
      }
      const uint32_t first = std::min(root[0], std::min(root[1], root[2]));
      for (uint32_t r : root) least[r] = first;
    }
    for (uint32_t& v : least) v = least[v];  // ascending: that of the lesser one is known
    return least;
  }
  void check_shells(const DmsNumbers& of_domain) {
    units->id = "U7";
    require(of_domain.shells == of_domain.bodies, "U7", "the shells of the domain are",
            of_domain.shells);
    if (of_domain.shells == 1) return;
    const std::vector<uint32_t> shells = shells_of_vertices();
    typedef std::array<const DmsPoint*, 6> Ends;  // least and greatest, along three axes
    std::map<uint32_t, Ends> boxes;
    for (size_t f = 0; f < faces.size(); ++f)
      for (const DmsPoint& p : faces[f].values) {
        Ends& ends = boxes.insert({shells[model.faces[f].vertex[0]], {{&p, &p, &p, &p, &p, &p}}})
                         .first->second;
        for (int k = 0; k < 3; ++k) {
          if (dms_compare(p, *ends[size_t(2 * k)], k) < 0) ends[size_t(2 * k)] = &p;
          if (dms_compare(p, *ends[size_t(2 * k + 1)], k) > 0) ends[size_t(2 * k + 1)] = &p;
        }
      }
    for (auto a = boxes.begin(); a != boxes.end(); ++a)
      for (auto b = std::next(a); b != boxes.end(); ++b) {
        units->add(1);
        bool are_apart = false;
        for (int k = 0; k < 3; ++k)
          are_apart =
              are_apart ||
              dms_compare(*a->second[size_t(2 * k + 1)], *b->second[size_t(2 * k)], k) < 0 ||
              dms_compare(*b->second[size_t(2 * k + 1)], *a->second[size_t(2 * k)], k) < 0;
        require(are_apart, "U7", "values of two shells are not apart, of that with vertex",
                a->first);
      }
  }
};

}  // namespace

void check_dms_pairs(const DmsModel& model, const DmsBody& body, const DmsNumbers& of_domain,
                     Units* units) {
  DmsPairs check(model, body, units);
  check.check_blocks();
  check.check_faces();
  check.check_pairs();
  check.check_shells(of_domain);
}
