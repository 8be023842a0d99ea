// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_valid.cc: the claims mesh-valid-1 and mesh-reversed-1; V1 to V11 of docs/certificates/mesh.md, and R1 of
// docs/certificates/mesh-reversed.md.
#include <array>

#include "mesh_body.h"
#include "mesh_claims.h"

namespace {

const int kStars[13][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},  {1, -1, 0},
                           {1, 0, 1},  {1, 0, -1}, {0, 1, 1},  {0, 1, -1}, {1, 1, 1},
                           {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};

struct Ids {  // a set of vertices; four mean that there may be more
  uint32_t id[4];
  size_t n;
  void add(uint32_t v) {
    if (n < 4 && std::find(id, id + n, v) == id + n) id[n++] = v;
  }
};

enum Outcome { kFails, kHolds, kOpen };

template <int C>
class ValidCheck {
 public:
  ValidCheck(const MeshKind& kind, const Model& model, const ValidBody& body, const Work& allowed)
      : kind_(kind),
        model_(model),
        body_(body),
        surface_(model),
        allowed_(allowed),
        work_(allowed) {}

  SolidMesh result() {
    check_nesting_codes(body_.nesting, surface_.shells);
    require(body_.reversed.empty() || body_.num_reversed() > 0, "R1", "no triangle is reversed");
    std::vector<bool> seen(model_.faces());
    for (uint32_t f : body_.order) {
      require(f < seen.size() && !seen[f], "V1", "out of range or twice in the order: triangle", f);
      seen[f] = true;
    }
    check_positions();
    for (size_t c = 0; c < model_.tri.size(); c += 3) {
      const uint32_t* const t = &model_.tri[c];
      require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && !is_zero(normal(t)), "V3",
              "degenerate: triangle", c / 3);
    }
    const char* const ids[] = {"V4", "V5", "V6"};
    for (int i = 0; i < 3; ++i)
      require(surface_.bad[i] == kNone, ids[i], "fails at vertex", surface_.bad[i]);
    check_stars();
    const Tree tree(model_, body_.order, body_.star);
    tree_ = &tree;
    check_pairs();
    return quantities(check_nesting(model_, surface_, tree, body_.nesting, allowed_));
  }

 private:
  void check_positions() {  // V2; merged vertices differ
    const int low = Lattice(model_).low;
    point_.resize(model_.vertices());
    std::vector<std::array<int64_t, 4>> places;
    for (uint32_t v : model_.tri) {
      const int64_t* const k = &model_.key[3 * size_t(v)];
      point_[v] = lattice_point<C>(k, low);
      if (kind_.as_indexed) places.push_back({{k[0], k[1], k[2], v}});
    }
    std::sort(places.begin(), places.end());
    for (size_t i = 1; i < places.size(); ++i)
      require(places[i][3] == places[i - 1][3] ||
                  !std::equal(&places[i][0], &places[i][3], &places[i - 1][0]),
              "V2", "another vertex has the position of vertex", uint64_t(places[i][3]));
  }

  Vec<C> edge(const uint32_t* t, int i) const { return point_[t[(i + 1) % 3]] - point_[t[i]]; }
  Vec<2 * C> normal(const uint32_t* t) const { return cross(edge(t, 0), edge(t, 1)); }

  void check_stars() const {  // V7
    size_t used = 0;
    for (uint32_t v = 0; v < body_.star.size(); ++v) {
      if (body_.star[v] == 0) continue;
      const int* const d = kStars[(body_.star[v] - 1) % 13];
      require(
          star_holds(v, body_.star[v] == 14 ? body_.vector[used++] : direction(d[0], d[1], d[2])),
          "V7", "the star code does not hold at vertex", v);
    }
  }
  bool star_holds(uint32_t v, const Vec<1>& d) const {
    const Fixed<1> zero = fixed<1>(0);
    const bool along_x = sign(d.x[1]) == 0 && sign(d.x[2]) == 0;
    const Vec<1> g = along_x ? direction(0, 0, 1) : Vec<1>{{zero, d.x[2], zero - d.x[1]}};
    int side = 0, turns = 0;
    uint32_t e = surface_.first[v];
    if (e == kNone) return false;
    do {  // edge e is v p, the next one of its triangle p q
      const uint32_t* const t = &model_.tri[e - e % 3];
      const Vec<C> p = point_[t[(e + 1) % 3]] - point_[v], q = point_[t[(e + 2) % 3]] - point_[v];
      const int s = sign(dot(cross(p, q), d));  // p x q is the normal
      if (s == 0 || s == -side) return false;
      side = s;
      const int gp = sign(dot(p, g)), gq = sign(dot(q, g));
      turns += s > 0 ? gp >= 0 && gq < 0 : gq >= 0 && gp < 0;
      e = surface_.around(e);
    } while (e != surface_.first[v]);
    return turns == 1;
  }

  void check_pairs() {  // V8 and V9
    steps_left_ = body_.separator.empty() ? 0 : body_.separator[0].gap;
    self(tree_->root());
    require(used_separators_ == body_.separator.size(), "V8", "not used: separator",
            used_separators_);
    require(bad_leaf_ == kNone, "V9", "the codes do not hold for a pair with triangle", bad_leaf_);
    require(used_codes_ == body_.code.size(), "V9", "not used: code", used_codes_);
  }
  void self(const Range& r) {
    if (r.size() == 1) return;
    self(r.left());
    self(r.right());
    cross_nodes(r.left(), r.right());
  }
  void cross_nodes(const Range& a, const Range& b) {
    work_.add(1);
    const TreeNode &m = tree_->nodes[a.node], &n = tree_->nodes[b.node];
    for (int k = 0; k < 3; ++k)
      if (m.max[k] < n.min[k] || n.max[k] < m.min[k]) return;
    if (n.has(m.common[0]) || n.has(m.common[1]) || n.has(m.common[2])) return;
    const uint32_t* const p = &tree_->corners[3 * size_t(a.lo)];
    const uint32_t* const q = &tree_->corners[3 * size_t(b.lo)];
    if (used_separators_ < body_.separator.size() && steps_left_-- == 0) {
      work_.add(uint64_t(a.size()) + b.size());
      Ids unused[2];
      const Vec<1>& d = body_.separator[used_separators_].d;
      require(test(d, 1, p, 3 * size_t(a.size()), q, 3 * size_t(b.size()), unused) == kHolds, "V8",
              "does not hold: separator", used_separators_);
      if (++used_separators_ < body_.separator.size())
        steps_left_ = body_.separator[used_separators_].gap;
    } else if (a.size() == 1 && b.size() == 1) {
      // A later failure of V8 is named before this failure of V9, so the search for one goes on.
      if (bad_leaf_ == kNone && !leaves_apart(p, q)) bad_leaf_ = body_.order[a.lo];
    } else if (a.size() >= b.size()) {
      cross_nodes(a.left(), b);
      cross_nodes(a.right(), b);
    } else {
      cross_nodes(a, b.left());
      cross_nodes(a, b.right());
    }
  }

  // The vertices, among n, where d.x is greatest (sense 1) or least (-1).
  template <int D>
  Fixed<D + C> extreme(const Vec<D>& d, int sense, const uint32_t* v, size_t n, Ids* where) const {
    Fixed<D + C> best = dot(d, point_[v[0]]);
    where->n = 0;
    for (size_t i = 0; i < n; ++i) {
      const Fixed<D + C> x = dot(d, point_[v[i]]);
      const int s = sense * sign(x - best);
      if (s > 0) best = x, where->n = 0;
      if (s >= 0) where->add(v[i]);
    }
    return best;
  }
  // The test of d (sense 1) or -d (sense -1). `where` must not be p or q and becomes P', Q'.
  template <int D>
  Outcome test(const Vec<D>& d, int sense, const uint32_t* p, size_t np, const uint32_t* q,
               size_t nq, Ids* where) const {
    const Fixed<D + C> most = extreme(d, sense, p, np, &where[0]);
    const int s = sense * sign(most - extreme(d, -sense, q, nq, &where[1]));
    if (s != 0) return s < 0 ? kHolds : kFails;
    Ids k = where[0];
    for (size_t i = 0; i < where[1].n; ++i) k.add(where[1].id[i]);
    return k.n <= 2 || (k.n == 3 && !is_zero(normal(k.id))) ? kHolds : kOpen;
  }
  template <int D>
  Outcome narrow(const Vec<D>& d, int sense, Ids* pq) const {
    const Ids p = pq[0], q = pq[1];
    return test(d, sense, p.id, p.n, q.id, q.n, pq);
  }
  bool leaves_apart(const uint32_t* a, const uint32_t* b) {
    Ids pq[2] = {{{a[0], a[1], a[2], 0}, 3}, {{b[0], b[1], b[2], 0}, 3}};
    for (int byte = 0; byte < 4 && used_codes_ < body_.code.size(); ++byte) {
      const int code = body_.code[used_codes_++], axis = code & 31,
                sense = (code & 32) != 0 ? -1 : 1;
      if (code >= 128 || axis > 16) return false;
      const uint32_t* const t = axis == 0 || (axis >= 11 && axis <= 13) ? a : b;
      const Vec<2 * C> d = axis < 2 || axis > 10
                               ? normal(t)
                               : cross(edge(a, (axis - 2) / 3), edge(b, (axis - 2) % 3));
      const Outcome is =
          axis <= 10 ? narrow(d, sense, pq) : narrow(cross(d, edge(t, (axis - 11) % 3)), sense, pq);
      const bool more = (code & 64) != 0;
      if (is != kOpen || !more) return is == kHolds && !more;
    }
    return false;
  }

  uint64_t reversed_shells() const {  // those of which all triangles are reversed
    std::vector<bool> is_kept(surface_.shells);
    for (size_t f = 0; f < surface_.shell.size(); ++f)
      if (body_.reversed.empty() || !body_.reversed[f]) is_kept[surface_.shell[f]] = true;
    return uint64_t(std::count(is_kept.begin(), is_kept.end(), false));
  }

  SolidMesh quantities(const Nesting& nesting) const {
    const uint64_t v = surface_.vertices, e = surface_.edges, f = model_.faces(),
                   s = surface_.shells;
    SolidMesh r;
    r.numbers = {{"vertices", v},
                 {"edges", e},
                 {"faces", f},
                 {"shells", s},
                 {"bodies", nesting.bodies},
                 {"genus", (2 * s + e - v - f) / 2},
                 {"reversed", body_.num_reversed()},
                 {"reversed_shells", reversed_shells()}};
    r.volume = nesting.volume;
    r.shell = surface_.shell;
    r.depth = nesting.depth;
    return r;
  }

  const MeshKind& kind_;
  const Model& model_;
  const ValidBody& body_;
  const Surface surface_;
  const Work allowed_;
  Work work_;
  std::vector<Vec<C>> point_;  // the referenced vertices, as integers
  const Tree* tree_ = nullptr;
  size_t used_separators_ = 0, used_codes_ = 0;
  uint64_t steps_left_ = 0;    // steps 3 of section 5 before the next separator
  uint32_t bad_leaf_ = kNone;  // a triangle of the first leaf pair that fails
};

}  // namespace

void check_volume(const Statement& statement) {
  const std::string& volume = statement.text.at("volume");
  const size_t slash = std::min(volume.find('/'), volume.size());
  require(is_natural(volume.substr(0, slash)) && slash < volume.size() &&
              is_natural(volume.substr(slash + 1)) && volume[slash + 1] != '0',
          "S1", "volume is not p/q");
}

SolidMesh check_solid(const MeshKind& kind, Model* model, const Body& bytes) {
  const ValidBody body = read_valid_body(kind, bytes, model);
  const Model& read = *model;
  return with_limbs<ValidCheck, SolidMesh>(Lattice(read).bits, kind, read, body, Work(read, bytes));
}

std::string check_mesh_valid(const Statement& statement, std::string file, const Body& bytes) {
  const bool as_indexed = statement.flag.at("as_indexed");
  Model model = read_model(std::move(file), statement.text.at("subject_format"), as_indexed);
  const MeshKind kind = {statement.claim->magic, as_indexed,
                         statement.number.count("reversed") != 0};
  const SolidMesh solid = check_solid(kind, &model, bytes);
  std::string all;
  for (const auto& n : solid.numbers) {                  // V11
    if (statement.number.count(n.first) == 0) continue;  // reversed: in mesh-reversed-1 only
    require(statement.number.at(n.first) == n.second, "V11", n.first, n.second);
    all += std::to_string(n.second) + ' ' + n.first + ", ";
  }
  all += "volume " + solid.volume;
  require(statement.text.at("volume") == solid.volume, "V11", all.c_str());
  return all;
}
