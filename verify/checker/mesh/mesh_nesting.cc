// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_nesting.cc: condition V10 and the volume; docs/certificates/mesh.md, section 6.
#include "geometry.h"

namespace {

template <int L>
Nat nat(const Fixed<L>& a) {  // REQUIRES a >= 0
  Nat r;
  for (int i = 0; i < 2 * L; ++i) r.push_back(uint32_t(a.d[i / 2] >> 32 * (i % 2)));
  while (!r.empty() && r.back() == 0) r.pop_back();  // NOT COVERED: no volume is 0 here
  return r;
}

std::string decimal(Nat a) {
  std::string r;
  do {
    uint32_t nine = divide(&a, 1000000000);
    for (int i = 0; i < 9; ++i, nine /= 10) r += char('0' + nine % 10);
  } while (!a.empty());
  while (r.size() > 1 && r.back() == '0') r.pop_back();
  return std::string(r.rbegin(), r.rend());
}

template <int C>
class NestingCheck {
 public:
  NestingCheck(const Model& model, const Surface& surface, const Tree& tree,
               const std::vector<uint8_t>& codes, const Work& work)
      : model_(model),
        surface_(surface),
        tree_(tree),
        codes_(codes),
        work_(work),
        low_(Lattice(model).low),
        odd_(surface.shells) {}

  Nesting result() {
    std::vector<Fixed<4 * C>> volumes(surface_.shells, fixed<4 * C>(0));  // 6 vol(s)
    std::vector<uint32_t> tips(surface_.shells, kNone);
    for (size_t c = 0; c < model_.tri.size(); ++c) {
      const uint32_t v = model_.tri[c], s = surface_.shell[c / 3];
      const uint32_t* const t = &model_.tri[c];
      if (c % 3 == 0)  // multiplied by 1 for the width of the result
        volumes[s] = volumes[s] + dot(cross(point(v), point(t[1])), point(t[2])) * fixed<C>(1);
      if (tips[s] == kNone || (!codes_.empty() && is_beyond(v, tips[s], codes_[s]))) tips[s] = v;
    }
    Nesting r = {0, std::string(), {}};
    Fixed<4 * C> total = fixed<4 * C>(0);
    for (uint32_t s = 0; s < surface_.shells; ++s) {
      const uint64_t depth = codes_.empty() ? 0 : depth_of(s, tips[s]);
      r.depth.push_back(depth);
      require(sign(volumes[s]) == (depth % 2 == 0 ? 1 : -1), "V10", "wrong side out: shell", s);
      r.bodies += depth % 2 == 0;
      total = total + volumes[s];
    }
    require(sign(total) > 0, "V10", "the volume is not positive");
    r.volume = volume(total);
    return r;
  }

 private:
  const int64_t* key(uint32_t v) const { return &model_.key[3 * size_t(v)]; }
  Vec<C> point(uint32_t v) const { return lattice_point<C>(key(v), low_); }

  bool is_beyond(uint32_t v, uint32_t w, int code) const {
    const int64_t a = key(v)[code / 2], b = key(w)[code / 2];
    return a == b ? v < w : (a > b) == (code % 2 == 0);
  }
  uint64_t depth_of(uint32_t s, uint32_t v) {
    stabbed_.clear();
    shoot(tree_.root(), s, v);
    uint64_t depth = 0;
    for (uint32_t other : stabbed_) {
      depth += odd_[other];
      odd_[other] = false;
    }
    return depth;
  }
  // Records the triangles of other shells that the ray of shell s from v stabs. Skips boxes in
  // which the stab rule cannot count: by q or p no edge counts, or by p every edge counts that q
  // admits (an even number), or every point of the box is behind v along u.
  void shoot(const Range& r, uint32_t s, uint32_t v) {
    work_.add(1);
    const int u = codes_[s] / 2, p = (u + 1) % 3, q = (u + 2) % 3;
    const bool upwards = codes_[s] % 2 == 0;
    const int64_t* const k = key(v);
    const TreeNode& n = tree_.nodes[r.node];
    if (k[q] < n.min[q] || k[q] >= n.max[q] || k[p] < n.min[p] || k[p] >= n.max[p] ||
        (upwards ? n.max[u] < k[u] : n.min[u] > k[u]))
      return;
    if (r.size() > 1) {
      shoot(r.left(), s, v);
      shoot(r.right(), s, v);
      return;
    }
    const uint32_t other = surface_.shell[tree_.order[r.lo]];
    if (other == s) return;
    const uint32_t* const t = &tree_.corners[3 * size_t(r.lo)];
    const Vec<C> triangle[3] = {point(t[0]), point(t[1]), point(t[2])};
    int nu = 0;
    const int stabs = stab(point(v), triangle, u, upwards, &nu);
    require(stabs >= 0, "V10", "the ray starts in the plane of triangle", tree_.order[r.lo]);
    if (stabs == 0) return;
    odd_[other] = !odd_[other];
    stabbed_.push_back(other);
  }

  std::string volume(const Fixed<4 * C>& volume6) const {  // in lowest terms
    Nat p = nat(volume6), q(1, 1), third = p;
    if (divide(&third, 3) == 0) {
      p = third;
    } else {
      q[0] = 3;
    }
    int twos = 3 * (low_ - 1075) - 1;
    for (; twos < 0 && p[0] % 2 == 0; ++twos) divide(&p, 2);
    for (; twos < 0; ++twos) multiply_add(&q, 2, 0);
    for (; twos > 0; --twos) multiply_add(&p, 2, 0);
    return decimal(p) + '/' + decimal(q);
  }

  const Model& model_;
  const Surface& surface_;
  const Tree& tree_;
  const std::vector<uint8_t>& codes_;
  Work work_;
  const int low_;
  std::vector<bool> odd_;          // the shells that the ray has stabbed an odd number of times
  std::vector<uint32_t> stabbed_;  // the shell of each stab
};

}  // namespace

Nesting check_nesting(const Model& model, const Surface& surface, const Tree& tree,
                      const std::vector<uint8_t>& codes, Work work) {
  return with_limbs<NestingCheck, Nesting>(Lattice(model).bits, model, surface, tree, codes, work);
}
