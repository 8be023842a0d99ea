// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/interval_predicates.h: the formulas of predicates/formulas.h over a library's intervals, as filters.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "bench/predicate_peers.h"
#include "predicates/formulas.h"

namespace veritope::bench {

/// Traits: Type, with operators; point(x), the interval {x}; sign(x) in {-1, 0, 1, 2}; Scope, alive
/// during one decision.
template <typename Traits>
class IntervalFilter : public PredicatePeer {
 public:
  using PredicatePeer::PredicatePeer;
  void decide(Predicate predicate, std::size_t n, signed char* out) override {
    switch (predicate) {
      case Predicate::kOrient2d:
        for (std::size_t i = 0; i < n; ++i) out[i] = orient2d(p2_ + 3 * i);
        break;
      case Predicate::kOrient3d:
        for (std::size_t i = 0; i < n; ++i) out[i] = orient3d(p3_ + 4 * i);
        break;
      case Predicate::kInCircle:
        for (std::size_t i = 0; i < n; ++i) out[i] = in_circle(p2_ + 4 * i);
        break;
      case Predicate::kInSphere:
        for (std::size_t i = 0; i < n; ++i) out[i] = in_sphere(p3_ + 5 * i);
        break;
    }
  }

 private:
  using T = typename Traits::Type;
  static T at(double v) { return Traits::point(v); }
  static signed char orient2d(const Vec2d* p) {
    const typename Traits::Scope scope;
    return Traits::sign(formulas::Orient2d<T>(at(p[0].x), at(p[0].y), at(p[1].x), at(p[1].y),
                                              at(p[2].x), at(p[2].y))
                            .det());
  }
  static signed char orient3d(const Vec3d* p) {
    const typename Traits::Scope scope;
    const formulas::Plane3<T> plane(at(p[0].x), at(p[0].y), at(p[0].z), at(p[1].x), at(p[1].y),
                                    at(p[1].z), at(p[2].x), at(p[2].y), at(p[2].z));
    return Traits::sign(
        plane.det(at(p[3].x) - plane.ax, at(p[3].y) - plane.ay, at(p[3].z) - plane.az));
  }
  static signed char in_circle(const Vec2d* p) {
    const typename Traits::Scope scope;
    return Traits::sign(formulas::InCircle<T>(at(p[0].x), at(p[0].y), at(p[1].x), at(p[1].y),
                                              at(p[2].x), at(p[2].y), at(p[3].x), at(p[3].y))
                            .det());
  }
  static signed char in_sphere(const Vec3d* p) {
    const typename Traits::Scope scope;
    return Traits::sign(formulas::InSphere<T>(at(p[0].x), at(p[0].y), at(p[0].z), at(p[1].x),
                                              at(p[1].y), at(p[1].z), at(p[2].x), at(p[2].y),
                                              at(p[2].z), at(p[3].x), at(p[3].y), at(p[3].z),
                                              at(p[4].x), at(p[4].y), at(p[4].z))
                            .det());
  }
};

/// Variables of a C library wrapped in operators, without an allocation for each operation: they come from a pool that
/// starts anew with the Scope of a decision. V as in bench/interval_c_loops.h, and V::sign(x).
template <typename V>
struct PooledTraits {
  static V* next() {
    static std::vector<V> pool(512);
    return &pool[used()++];
  }
  static std::size_t& used() {
    static std::size_t n = 0;
    return n;
  }
  struct Scope {
    Scope() { used() = 0; }
  };
  struct Type {
    V* v = nullptr;
    friend Type operator+(const Type& a, const Type& b) { return made(V::add, a, b); }
    friend Type operator-(const Type& a, const Type& b) { return made(V::sub, a, b); }
    friend Type operator*(const Type& a, const Type& b) { return made(V::mul, a, b); }
    template <typename Operation>
    static Type made(Operation operation, const Type& a, const Type& b) {
      Type out{next()};
      operation(*out.v, *a.v, *b.v);
      return out;
    }
  };
  static Type point(double x) {
    Type out{next()};
    out.v->set(x, x);
    return out;
  }
  static signed char sign(const Type& x) { return V::sign(*x.v); }
};

}  // namespace veritope::bench
