// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_invalid.cc: the claim mesh-invalid-1; B1 and I1 to I10 of docs/certificates/mesh.md.
#include "geometry.h"
#include "mesh_claims.h"

namespace {

struct Witness {
  int rule;        // 1 to 9
  uint32_t id[2];  // the triangles or vertices of the rule
  int axis;        // rules 8 and 9
  Nat weight[6];   // rule 7: w0 w1 w2, x0 x1 x2
};

Nat sum(const Nat& a, const Nat& b) {
  Nat r;
  uint64_t carry = 0;
  for (size_t i = 0; i < a.size() || i < b.size() || carry != 0; ++i, carry >>= 32) {
    carry += uint64_t(i < a.size() ? a[i] : 0) + (i < b.size() ? b[i] : 0);
    r.push_back(uint32_t(carry));
  }
  return r;
}

template <int C>
class InvalidCheck {
 public:
  InvalidCheck(const Statement& statement, const Model& model, const Body& body)
      : statement_(statement),
        model_(model),
        body_(body),
        work_(model, body),
        low_(Lattice(model).low) {}

  std::string result() {
    read_body();
    sort_incidence();
    static const char* const ids[] = {"", "I1", "I2", "I3", "I4", "I5", "I6", "I7", "I8", "I9"};
    std::string rules;
    for (size_t i = 0; i < witness_.size(); ++i) {
      const Witness& w = witness_[i];
      require(holds(w), ids[w.rule], "does not hold: witness", i);
      const std::string name = "M" + std::to_string(w.rule);
      if (i == 0 || witness_[i - 1].rule != w.rule) rules += (i == 0 ? "" : " ") + name;
    }
    if (statement_.text.at("rules") != rules)
      throw Rejected{"I10", "the witnesses are of " + rules};
    return std::to_string(witness_.size()) + " witnesses, rules " + rules;
  }

 private:
  void read_body() {
    require(body_.begins_with(statement_.claim->magic), "B1", "the body does not start with VTMI");
    require(body_.natural(4) == model_.faces(), "B1", "the model's number of triangles is",
            model_.faces());
    require(body_.natural(4) == model_.vertices(), "B1", "the model's number of vertices is",
            model_.vertices());
    const uint64_t count = body_.count(5);  // u8, and one u32 at least
    require(count > 0, "B1", "no witness");
    for (uint64_t i = 0; i < count; ++i) {
      Witness w;
      w.rule = int(body_.natural(1));
      require(w.rule >= (i == 0 ? 1 : witness_.back().rule) && w.rule <= 9, "B1", "rule of witness",
              i);
      const bool vertices = w.rule >= 3 && w.rule <= 6;
      const int ids = w.rule == 1 || w.rule == 6 || w.rule >= 8 ? 1 : 2;
      for (int k = 0; k < 2; ++k) {
        w.id[k] = k < ids ? uint32_t(body_.natural(4)) : 0;
        require(w.id[k] < (vertices ? model_.vertices() : model_.faces()), "B1", "index of witness",
                i);
      }
      w.axis = w.rule >= 8 ? int(body_.natural(1)) : 0;
      require(w.axis <= 2, "B1", "axis of witness", i);
      for (int k = 0; k < 6 && w.rule == 7; ++k) w.weight[k] = read_natural();
      witness_.push_back(w);
    }
    require(body_.left() == 0, "B1", "bytes behind the last witness:", body_.left());
  }
  Nat read_natural() {
    const uint64_t size = body_.count(1);
    require(size <= 4096, "B1", "a natural number of more than 4096 bytes:", size);
    require(size == 0 || body_.p[size - 1] != 0, "B1", "the last byte of a natural number is 0");
    Nat r((size + 3) / 4, 0);
    for (uint64_t i = 0; i < size; ++i) r[i / 4] |= uint32_t(*body_.p++) << 8 * (i % 4);
    return r;
  }

  // The triangles at v, ascending, are of_[start_[v]] to of_[start_[v + 1]].
  void sort_incidence() {
    start_.assign(model_.vertices() + size_t(2), 0);
    for (uint32_t f = 0; f < model_.faces(); ++f)
      for (int i = 0; i < 3 && !collapsed(f); ++i) ++start_[corners(f)[i] + size_t(2)];
    for (size_t v = 2; v < start_.size(); ++v) start_[v] += start_[v - 1];
    of_.resize(start_.back());
    for (uint32_t f = 0; f < model_.faces(); ++f)
      for (int i = 0; i < 3 && !collapsed(f); ++i) of_[start_[corners(f)[i] + size_t(1)]++] = f;
  }
  size_t degree(uint32_t v) const { return start_[v + size_t(1)] - start_[v]; }

  bool holds(const Witness& w) {
    const uint32_t f = w.id[0], g = w.id[1];
    int64_t forth = 0;
    switch (w.rule) {
      case 1: return degenerate(f);
      case 2: return f != g && !collapsed(f) && within(f, g);
      case 3: return uses(f, g, &forth) == 1;
      case 4: return uses(f, g, &forth) >= 3;
      case 5: return uses(f, g, &forth) == 2 && forth == 2;
      case 6: return fans(f) >= 2;
      case 7: return f != g && !degenerate(f) && !degenerate(g) && meet(f, g, w.weight);
      default: return winding(f, w.axis) != 0;
    }
  }
  const uint32_t* corners(uint32_t f) const { return &model_.tri[3 * size_t(f)]; }
  Vec<C> point(uint32_t f, int corner, int low) const {
    return lattice_point<C>(&model_.key[3 * size_t(corners(f)[corner])], low);
  }
  Vec<2 * C> normal(uint32_t f) const {
    const Vec<C> a = point(f, 0, low_);
    return cross(point(f, 1, low_) - a, point(f, 2, low_) - a);
  }
  bool collapsed(uint32_t f) const {
    const uint32_t* const t = corners(f);
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }
  bool degenerate(uint32_t f) const { return collapsed(f) || is_zero(normal(f)); }
  bool has(uint32_t f, uint32_t v) const {
    return std::find(corners(f), corners(f) + 3, v) != corners(f) + 3;
  }
  bool within(uint32_t f, uint32_t g) const {
    return has(g, corners(f)[0]) && has(g, corners(f)[1]) && has(g, corners(f)[2]);
  }

  // The number of triangles with the edge {a, b}; `forth` becomes the number of those that run from
  // a to b.
  int64_t uses(uint32_t a, uint32_t b, int64_t* forth) {
    const uint32_t v = degree(b) < degree(a) ? b : a;
    work_.add(degree(v));
    int64_t n = 0;
    for (size_t i = start_[v]; i < start_[v + size_t(1)]; ++i)
      for (int k = 0; k < 3; ++k) {
        const uint32_t p = corners(of_[i])[k], q = corners(of_[i])[(k + 1) % 3];
        *forth += p == a && q == b;
        n += (p == a && q == b) || (p == b && q == a);
      }
    return n;
  }
  // The number of classes of the triangles at v, connected by edges {v, w}.
  size_t fans(uint32_t v) {
    work_.add(degree(v));
    const std::vector<uint32_t> f(of_.begin() + start_[v], of_.begin() + start_[v + size_t(1)]);
    std::vector<std::pair<uint32_t, uint32_t>> ends;  // w, number of a triangle with {v, w}
    std::vector<uint32_t> link(f.size());
    for (uint32_t k = 0; k < f.size(); ++k) {
      link[k] = k;
      const uint32_t* const t = corners(f[k]);
      const int i = int(std::find(t, t + 3, v) - t);
      ends.emplace_back(t[(i + 1) % 3], k);
      ends.emplace_back(t[(i + 2) % 3], k);
    }
    std::sort(ends.begin(), ends.end());
    size_t classes = f.size();
    const auto root = [&](uint32_t k) {
      while (link[k] != k) k = link[k] = link[link[k]];
      return k;
    };
    for (size_t i = 1; i < ends.size(); ++i) {
      const uint32_t a = root(ends[i - 1].second), b = root(ends[i].second);
      if (ends[i - 1].first != ends[i].first || a == b) continue;
      link[std::max(a, b)] = std::min(a, b);
      --classes;
    }
    return classes;
  }
  Nat absolute(int64_t key) const {  // the coordinate's absolute value in lattice units
    if (key == 0) return Nat();
    const int zeros = __builtin_ctzll(key_mantissa(key)), up = key_exponent(key) + zeros - low_;
    Nat r(size_t(up / 32), 0);
    for (u128 rest = u128(key_mantissa(key) >> zeros) << up % 32; rest != 0; rest >>= 32)
      r.push_back(uint32_t(rest));
    return r;
  }
  // Whether the weights name a point of both triangles that does not lie in a common vertex or
  // edge.
  bool meet(uint32_t f, uint32_t g, const Nat* weight) const {
    const Nat total[2] = {sum(sum(weight[0], weight[1]), weight[2]),
                          sum(sum(weight[3], weight[4]), weight[5])};
    if (total[0].empty() || total[1].empty()) return false;
    bool apart = false;
    Nat scaled[6];
    for (int j = 0; j < 6; ++j) {
      scaled[j] = product(weight[j], total[j < 3 ? 1 : 0]);
      apart = apart || (j < 3 && !weight[j].empty() && !has(g, corners(f)[j]));
    }
    for (int i = 0; i < 3 && apart; ++i) {  // negative terms move to the other side of the equation
      Nat side[2];
      for (int j = 0; j < 6; ++j) {
        const int64_t c = model_.key[3 * size_t(corners(j < 3 ? f : g)[j % 3]) + i];
        Nat& to = side[(c < 0) != (j < 3) ? 0 : 1];
        to = sum(to, product(scaled[j], absolute(c)));
      }
      if (side[0] != side[1]) return false;
    }
    return apart;
  }
  // The signed stabs of rules M8 and M9; 0 also if the rule does not apply.
  int64_t winding(uint32_t f, int u) {
    work_.add(model_.faces());
    const int up = sign(normal(f).x[u]);
    const Vec<C> a = point(f, 0, low_), b = point(f, 1, low_), c = point(f, 2, low_);
    Vec<C> p;  // P, with 2^(low_ - 2 - 1075) as the unit, in which quarters are integers, too
    for (int i = 0; i < 3; ++i) p.x[i] = a.x[i] + a.x[i] + b.x[i] + c.x[i];
    int64_t w = 0;
    for (uint32_t g = 0; g < model_.faces(); ++g) {
      if (g == f || up == 0) continue;
      const Vec<C> t[3] = {point(g, 0, low_ - 2), point(g, 1, low_ - 2), point(g, 2, low_ - 2)};
      int nu = 0;
      const int stabs = stab(p, t, u, up > 0, &nu);
      if (stabs < 0) return 0;
      w += stabs * nu * up;
    }
    return w;
  }

  const Statement& statement_;
  const Model& model_;
  Body body_;
  Work work_;
  const int low_;
  std::vector<Witness> witness_;
  std::vector<size_t> start_;
  std::vector<uint32_t> of_;
};

}  // namespace

void check_rules(const Statement& statement) {
  std::string rules = statement.text.at("rules") + ' ';
  for (char c = '1'; c <= '9'; ++c)
    if (rules.compare(0, 3, std::string("M") + c + ' ') == 0) rules.erase(0, 3);
  require(rules.empty(), "S1", "rules is no ascending list of M1 to M9");
}

std::string check_mesh_invalid(const Statement& statement, std::string file, const Body& body) {
  const Model model = read_model(std::move(file), statement.text.at("subject_format"),
                                 statement.flag.at("as_indexed"));
  const int bits = Lattice(model).bits + 2;  // quarters in units of 2^(low - 2 - 1075)
  return with_limbs<InvalidCheck, std::string>(bits, statement, model, body);
}
