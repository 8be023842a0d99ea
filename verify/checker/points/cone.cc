// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "cone.h"

namespace {

Big dot(const BigVec& a, const BigVec& b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
bool is_zero(const BigVec& a) { return a.x[0].m.empty() && a.x[1].m.empty() && a.x[2].m.empty(); }
int turn(const BigVec& n, const BigVec& a, const BigVec& b) { return side(n, cross(a, b)); }
bool are_parallel(const BigVec& a, const BigVec& b) { return is_zero(cross(a, b)); }

// Without the factor that all components have.
BigVec primitive(const BigVec& a) {
  const Big common = gcd(gcd(a.x[0], a.x[1]), a.x[2]);
  if (common.is_one() || common.m.empty()) return a;
  BigVec r;
  for (int k = 0; k < 3; ++k) r.x[k] = divide(a.x[k], common, nullptr);
  return r;
}

// The lesser of the turns from a and to b of a direction in the plane of the wedge. Positive inside, 0 on a rim.
int depth_in(const Wedge& w, const BigVec& d) {
  return std::min(turn(w.n, w.a, d), turn(w.n, d, w.b));
}

// How the segment from r to d passes the wedge: 1 from front to back, -1 from back to front, 0 not; kTouches if it lies
// in the plane or meets a rim.
enum { kTouches = 2 };
int passage(const Wedge& w, const BigVec& r, const BigVec& d) {
  const Big from = dot(w.n, r), to = dot(w.n, d);
  if (from.sign() == 0 && to.sign() == 0) return kTouches;
  if (from.sign() * to.sign() >= 0) return 0;  // at an end in the plane it is not in the wedge
  Big s = to, t = from;
  s.neg = t.neg = false;
  const int depth = depth_in(w, sum(s, r, t, d));
  return depth < 0 ? 0 : depth == 0 ? int(kTouches) : from.sign();
}

// Whether d, off the cone, is inside: along segments from directions beside a wedge. Each rim and each plane touches
// one of them at most. Null: the cone is not that of a solid.
const char* find_bit(const Cone& cone, const BigVec& d, bool* bit) {
  for (const Wedge& first : cone) {
    const int start = side(first.n, d);
    if (start == 0) continue;
    for (size_t k = 1; k <= 3 * cone.size() + 1; ++k) {
      const BigVec r = sum(1, first.a, Big(int64_t(k)), first.b);
      int winding = start < 0, p = 0;
      for (size_t i = 0; i < cone.size() && p != kTouches; ++i) {
        if (&cone[i] == &first) continue;
        p = passage(cone[i], r, d);
        winding += p;
      }
      if (p == kTouches) continue;
      *bit = winding == 1;
      return winding == 0 || winding == 1 ? nullptr : "the walls of a solid are not closed";
    }
  }
  return "the walls of a solid are not closed";
}

class Arcs {
 public:
  typedef std::function<bool(const std::vector<bool>& bits)> Function;
  Arcs(const std::vector<Cone>& cones, const Function& f)
      : cones_(cones),
        f_(f),
        front_(cones.size()),
        back_(cones.size()),
        found_{{false, false}, nullptr} {}

  ValuesNearby find() {
    for (size_t i = 0; i < cones_.size(); ++i)
      for (const Wedge& w : cones_[i])
        if (!is_done()) walk(i, w);
    if (!found_.has[0] && !found_.has[1] && found_.fault == nullptr)
      found_.fault = "no solid has walls there";
    return found_;
  }

 private:
  bool is_done() const { return found_.fault != nullptr || (found_.has[0] && found_.has[1]); }

  // Visits the parts of the wedge's arc between neighbouring directions that other cones have, too.
  void walk(size_t own, const Wedge& w) {
    std::vector<BigVec> stops;
    for (size_t j = 0; j < cones_.size(); ++j)
      if (j != own)
        for (const Wedge& other : cones_[j]) add_common(w, other, &stops);
    std::sort(stops.begin(), stops.end(),
              [&w](const BigVec& c, const BigVec& d) { return turn(w.n, c, d) > 0; });
    stops.push_back(w.b);
    BigVec last = w.a;
    for (const BigVec& stop : stops) {
      if (turn(w.n, last, stop) == 0) continue;
      visit(own, w, sum(1, last, 1, stop));
      if (is_done()) return;
      last = stop;
    }
  }
  static void add_common(const Wedge& w, const Wedge& other, std::vector<BigVec>* stops) {
    const auto add = [&](const BigVec& d) {
      if (depth_in(w, d) > 0) stops->push_back(d);
    };
    if (are_parallel(w.n, other.n)) {
      add(other.a);
      add(other.b);
      return;
    }
    BigVec line = primitive(cross(w.n, other.n));
    for (int sign = 1; sign >= -1; sign -= 2) {
      if (depth_in(w, line) > 0 && depth_in(other, line) >= 0) stops->push_back(line);
      for (Big& x : line.x) x = -x;
    }
  }

  // Both sides of the arc at a direction in which other cones lie along it, or not at all.
  void visit(size_t own, const Wedge& w, const BigVec& d) {
    for (size_t j = 0; j < cones_.size(); ++j) {
      const Wedge* along = j == own ? &w : nullptr;
      for (size_t i = 0; i < cones_[j].size() && along == nullptr; ++i) {
        const Wedge& other = cones_[j][i];
        if (side(other.n, d) == 0 && depth_in(other, d) > 0 && are_parallel(other.n, w.n))
          along = &other;
      }
      bool bit = false;
      if (along != nullptr) {
        bit = side(along->n, w.n) < 0;  // at the front of w; the solid is at the back of its wedge
      } else {
        found_.fault = find_bit(cones_[j], d, &bit);
        if (found_.fault != nullptr) return;
      }
      front_[j] = bit;
      back_[j] = (along != nullptr) != bit;
    }
    found_.has[f_(front_)] = true;
    found_.has[f_(back_)] = true;
  }

  const std::vector<Cone>& cones_;
  const Function& f_;
  std::vector<bool> front_, back_;
  ValuesNearby found_;
};

}  // namespace

BigVec cross(const BigVec& a, const BigVec& b) {
  return BigVec{{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
                 a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
BigVec sum(const Big& s, const BigVec& a, const Big& t, const BigVec& b) {
  return BigVec{{s * a.x[0] + t * b.x[0], s * a.x[1] + t * b.x[1], s * a.x[2] + t * b.x[2]}};
}
int side(const BigVec& n, const BigVec& d) { return dot(n, d).sign(); }

void add_polygon(const std::vector<BigVec>& corners, Cone* to) {
  for (size_t i = 0; i < corners.size(); ++i) {
    const BigVec &a = corners[i], &b = corners[i + 1 == corners.size() ? 0 : i + 1];
    const BigVec n = cross(a, b);
    if (!is_zero(n)) to->push_back(Wedge{primitive(a), primitive(b), primitive(n)});
  }
}

ValuesNearby values_nearby(const std::vector<Cone>& cones,
                           const std::function<bool(const std::vector<bool>& bits)>& f) {
  return Arcs(cones, f).find();
}
