// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "mesh_points.h"

#include <array>

#include "relation.h"

namespace {

// An order of the triangles for the box tree: halves by the median of the middles of the triangles, along the axis in
// which these lie farthest apart. Every order is right; this one makes searches short. The middles are sums of
// coordinates, cut to 53 bits below the greatest one.
class Order {
 public:
  explicit Order(const Model& model) : middles_(model.faces()), order_(model.faces()) {
    int top = 0;
    for (uint32_t v : model.tri)
      for (int k = 0; k < 3; ++k) top = std::max(top, key_exponent(model.key[3 * size_t(v) + k]));
    for (size_t c = 0; c < model.tri.size(); ++c)
      for (int k = 0; k < 3; ++k) {
        const int64_t key = model.key[3 * size_t(model.tri[c]) + k];
        const int64_t m = int64_t(key_mantissa(key) >> std::min(63, top - key_exponent(key)));
        middles_[c / 3][k] += key < 0 ? -m : m;
      }
    for (uint32_t f = 0; f < order_.size(); ++f) order_[f] = f;
    split(0, order_.size());
  }
  const std::vector<uint32_t>& result() const { return order_; }

 private:
  void split(size_t lo, size_t hi) {
    if (hi - lo < 2) return;
    int axis = 0;
    int64_t widest = -1;
    for (int k = 0; k < 3; ++k) {
      int64_t least = middles_[order_[lo]][k], most = least;
      for (size_t i = lo; i < hi; ++i) {
        least = std::min(least, middles_[order_[i]][k]);
        most = std::max(most, middles_[order_[i]][k]);
      }
      if (most - least > widest) widest = most - least, axis = k;
    }
    const size_t half = lo + (hi - lo) / 2;  // as Range has it
    std::nth_element(
        order_.begin() + long(lo), order_.begin() + long(half), order_.begin() + long(hi),
        [this, axis](uint32_t f, uint32_t g) { return middles_[f][axis] < middles_[g][axis]; });
    split(lo, half);
    split(half, hi);
  }
  std::vector<std::array<int64_t, 3>> middles_;
  std::vector<uint32_t> order_;
};

// A triangle may contain a point, or its ray may stab it, or both. The answer is kOn or what it adds to the sum.
enum { kOn = 2 };
struct Question {
  const Point& q;
  const int64_t* corner[3];  // as keys
  bool may_contain, may_be_stabbed;
  int u;
  bool upward;

  template <class V>
  int answer(const V* edge, const V* to) const {
    if (may_contain && lies_on(edge, to)) return kOn;
    if (!may_be_stabbed) return 0;
    const int second = (u + 2) % 3;
    bool has_reached[3];
    for (int i = 0; i < 3; ++i) has_reached[i] = corner[i][second] <= q.below[second];
    return crossing(edge, to, has_reached, u, upward);
  }
};

template <int C>
class FixedQuestion {  // about a binary64 point
 public:
  explicit FixedQuestion(const Question& question) : question_(question) {}
  int result() const {
    const int low = question_.q.lattice.low;
    const Vec<C> q = lattice_point<C>(question_.q.below, low);
    Vec<C> corner[3], edge[3], to[3];
    for (int i = 0; i < 3; ++i) corner[i] = lattice_point<C>(question_.corner[i], low);
    for (int i = 0; i < 3; ++i) {
      edge[i] = corner[(i + 1) % 3] - corner[i];
      to[i] = q - corner[i];
    }
    return question_.answer(edge, to);
  }

 private:
  const Question& question_;
};

int answer_about_rational(const Question& question) {
  IntegerVec corner[3], edge[3], to[3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const int64_t key = question.corner[i][k];
      if (key == 0) continue;
      const int zeros = __builtin_ctzll(key_mantissa(key));
      const uint64_t m = key_mantissa(key) >> zeros;
      Integer* const x = &corner[i].x[k];
      x->m = {uint32_t(m), uint32_t(m >> 32)};
      drop_zeros(&x->m);
      x->m = shifted(x->m, key_exponent(key) + zeros - question.q.lattice.low);
      x->neg = key < 0;
    }
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      edge[i].x[k] = corner[(i + 1) % 3].x[k] - corner[i].x[k];
      to[i].x[k] = question.q.x[k] - question.q.w * corner[i].x[k];
    }
  return question.answer(edge, to);
}

int ask(const Question& question) {
  if (!question.q.is_binary64) return answer_about_rational(question);
  return with_limbs<FixedQuestion, int>(question.q.lattice.bits, question);
}

}  // namespace

Point::Point(const Coordinate* coordinates, const Lattice& model) : lattice(model) {
  Coordinate c[3];
  for (int k = 0; k < 3; ++k) {
    c[k] = coordinates[k];
    below[k] = c[k].below;
    above[k] = c[k].above;
    is_binary64 = is_binary64 && below[k] == above[k];
  }
  for (int k = 0; k < 3; ++k) {
    const int64_t up = c[k].twos + 1075 - lattice.low;
    if (is_binary64) {
      lattice.add(below[k]);
    } else if (up >= 0) {
      c[k].n.m = shifted(c[k].n.m, up);
    } else {
      c[k].d = shifted(c[k].d, -up);
    }
  }
  if (is_binary64) return;
  w.m = c[0].d * c[1].d * c[2].d;
  for (int k = 0; k < 3; ++k) {
    x[k].m = c[k].n.m * c[(k + 1) % 3].d * c[(k + 2) % 3].d;
    x[k].neg = c[k].n.neg;
  }
}

MeshPoints::MeshPoints(const Model& model)
    : model_(model),
      lattice_(model),
      tree_(model, Order(model).result(), std::vector<uint8_t>(model.vertices())) {}

// The directed edges between different ids, each as (lesser id, greater id), are the same for both directions.
bool MeshPoints::is_closed() const {
  std::vector<uint64_t> rising, falling;
  for (size_t e = 0; e < model_.tri.size(); ++e) {
    const uint64_t a = model_.tri[e], b = model_.tri[e % 3 == 2 ? e - 2 : e + 1];
    if (a < b) rising.push_back(a << 32 | b);
    if (a > b) falling.push_back(b << 32 | a);
  }
  std::sort(rising.begin(), rising.end());
  std::sort(falling.begin(), falling.end());
  return rising == falling;
}

bool MeshPoints::is_on(const Point& q, uint32_t face) const {
  const uint32_t* const t = &model_.tri[3 * size_t(face)];
  int64_t min[3], max[3];
  for (int k = 0; k < 3; ++k) {
    min[k] = std::min(std::min(key(t[0])[k], key(t[1])[k]), key(t[2])[k]);
    max[k] = std::max(std::max(key(t[0])[k], key(t[1])[k]), key(t[2])[k]);
  }
  return q.is_in_box(min, max) &&
         ask({q, {key(t[0]), key(t[1]), key(t[2])}, true, false, 0, true}) == kOn;
}

// Finds the pairs of section 5. Their conditions on boxes hold for every box that contains one for which they hold.
template <class Visit>
void MeshPoints::search(const Range& r, const Point& q, int direction, const Visit& visit) const {
  const TreeNode& n = tree_.nodes[r.node];
  const int u = direction / 2, p = (u + 1) % 3, s = (u + 2) % 3;
  const bool may_contain = q.is_in_box(n.min, n.max);
  const bool may_be_stabbed =
      n.min[p] <= q.below[p] && q.below[p] < n.max[p] && n.min[s] <= q.below[s] &&
      q.below[s] < n.max[s] &&
      (direction % 2 == 0 ? q.above[u] <= n.max[u] : n.min[u] <= q.below[u]);
  if (!may_contain && !may_be_stabbed) return;
  if (r.size() == 1) return visit(r.lo, may_contain, may_be_stabbed);
  search(r.left(), q, direction, visit);
  search(r.right(), q, direction, visit);
}

MeshPoints::Winding MeshPoints::winding(const Point& q, int direction, bool units_matter_only,
                                        Work* work) const {
  Winding r = {false, 0};
  const auto visit = [&](uint32_t place, bool may_contain, bool may_be_stabbed) {
    work->add(1);
    if (units_matter_only || r.is_on) return;
    const int found = ask_of(place, q, direction, may_contain, may_be_stabbed);
    r.is_on = found == kOn;
    r.sum += found;
  };
  search(tree_.root(), q, direction, visit);
  return r;
}
std::map<uint32_t, int64_t> MeshPoints::windings(const Point& q, int direction,
                                                 const std::vector<uint32_t>& of_face, Work* work,
                                                 bool* is_on) const {
  std::map<uint32_t, int64_t> sums, r;
  *is_on = false;
  search(tree_.root(), q, direction, [&](uint32_t place, bool may_contain, bool may_be_stabbed) {
    work->add(1);
    const int found = ask_of(place, q, direction, may_contain, may_be_stabbed);
    *is_on = *is_on || found == kOn;
    if (found != 0) sums[of_face[tree_.order[place]]] += found;
  });
  for (const auto& sum : sums)
    if (sum.second != 0 && !*is_on) r.insert(sum);
  return r;
}
int MeshPoints::ask_of(uint32_t place, const Point& q, int direction, bool may_contain,
                       bool may_be_stabbed) const {
  const uint32_t* const t = &tree_.corners[3 * size_t(place)];
  return ask({q,
              {key(t[0]), key(t[1]), key(t[2])},
              may_contain,
              may_be_stabbed,
              direction / 2,
              direction % 2 == 0});
}

template <class Visit>
void MeshPoints::search_boxes(const Range& r, const Point& q, const Visit& visit) const {
  const TreeNode& n = tree_.nodes[r.node];
  if (!q.is_in_box(n.min, n.max)) return;
  if (r.size() == 1) return visit(tree_.order[r.lo]);
  search_boxes(r.left(), q, visit);
  search_boxes(r.right(), q, visit);
}

std::vector<uint32_t> MeshPoints::triangles_at(const Point& q, Work* work) const {
  std::vector<uint32_t> found;
  search_boxes(tree_.root(), q, [&](uint32_t face) {
    work->add(1);
    if (is_on(q, face)) found.push_back(face);
  });
  return found;
}
