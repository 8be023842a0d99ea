// SPDX-License-Identifier: LGPL-3.0-or-later
#include "named_predicates/implicit_names.h"

#include <tuple>

#include "predicates/formulas.h"
#include "predicates/implicit_predicates.h"
#include "robust/rational.h"

namespace veritope {
namespace {

// ---- From a row of operands to points --------------------------------------------------------------

class Reader {
 public:
  explicit Reader(const Operands& v) : v_(v) {}
  double number() { return v_[next_++]; }
  Vec2d flat() {
    const double x = number(), y = number();
    return {x, y};
  }
  Vec3d solid() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  const Operands& v_;
  std::size_t next_ = 0;
};

template <char Kind>
auto point(Reader& r) {
  if constexpr (Kind == 'e') {
    return r.solid();
  } else if constexpr (Kind == 'E') {
    return r.flat();
  } else if constexpr (Kind == 's') {
    const Vec3d a = r.solid(), b = r.solid();
    const double n = r.number(), d = r.number();
    return SegmentPoint(a, b, n, d);
  } else if constexpr (Kind == 't') {
    const Vec3d a = r.solid(), b = r.solid(), c = r.solid();
    const double v = r.number(), w = r.number(), d = r.number();
    return TrianglePoint(a, b, c, v, w, d);
  } else if constexpr (Kind == 'l') {
    const Vec3d p = r.solid(), q = r.solid(), a = r.solid(), b = r.solid(), c = r.solid();
    return LinePlanePoint(p, q, a, b, c);
  } else if constexpr (Kind == 'p') {
    std::array<Vec3d, 9> p;
    for (Vec3d& v : p) v = r.solid();
    return ThreePlanePoint(p);
  } else if constexpr (Kind == 'S') {
    const Vec2d a = r.flat(), b = r.flat();
    const double n = r.number(), d = r.number();
    return SegmentPoint2d(a, b, n, d);
  } else {
    static_assert(Kind == 'X');
    const Vec2d a = r.flat(), b = r.flat(), c = r.flat(), d = r.flat();
    return SegmentSegmentPoint2d(a, b, c, d);
  }
}
constexpr std::size_t num_operands(char kind) {
  switch (kind) {
    case 'e': return 3;
    case 's': return 8;
    case 't': return 12;
    case 'l': return 15;
    case 'p': return 27;
    case 'E': return 2;
    case 'S': return 6;
    default: return 8;  // X
  }
}

// ---- The points in rationals: no filter, no tier -----------------------------------------------------

using Exact = std::array<Rational, 3>;  // in the plane the last one is 0

Exact exact(const Vec2d& p) { return {Rational::from_double(p.x), Rational::from_double(p.y), 0}; }
Exact exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
Exact minus(const Exact& a, const Exact& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// a + t u
Exact moved(const Exact& a, const Rational& t, const Exact& u) {
  return {a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]};
}
template <typename P>
Exact normal(const P* v) {
  return cross(minus(exact(v[1]), exact(v[0])), minus(exact(v[2]), exact(v[0])));
}

template <typename P>
requires requires(P p) { p.weights(); }
Exact exact(const P& p) {
  const auto& weights = p.weights();
  const Rational d = Rational::from_double(weights.back());
  const Exact a = exact(p.points()[0]);
  Exact at = a;
  for (std::size_t i = 1; i < p.points().size(); ++i)
    at = moved(at, Rational::from_double(weights[i - 1]) / d, minus(exact(p.points()[i]), a));
  return at;
}
Exact exact(const LinePlanePoint& p) {
  const auto& v = p.points();
  const Exact n = normal(&v[2]), a = exact(v[0]), u = minus(exact(v[1]), a);
  return moved(a, dot(n, minus(exact(v[2]), a)) / dot(n, u), u);
}
Exact exact(const ThreePlanePoint& p) {
  const auto& v = p.points();
  const std::array<Exact, 3> n{normal(&v[0]), normal(&v[3]), normal(&v[6])};
  const Exact a = cross(n[1], n[2]), b = cross(n[2], n[0]), c = cross(n[0], n[1]);
  const Rational d = dot(n[0], a);
  Exact at{0, 0, 0};
  at = moved(at, dot(n[0], exact(v[0])) / d, a);
  at = moved(at, dot(n[1], exact(v[3])) / d, b);
  return moved(at, dot(n[2], exact(v[6])) / d, c);
}
Exact exact(const SegmentSegmentPoint2d& p) {
  const auto& v = p.points();
  const Exact a = exact(v[0]), u = minus(exact(v[1]), a), c = exact(v[2]),
              w = minus(exact(v[3]), c);
  return moved(a, cross(minus(c, a), w)[2] / cross(u, w)[2], u);
}

// ---- The predicates ------------------------------------------------------------------------------------

struct Orient2d {
  static Sign decide(const AnyPoint2& a, const AnyPoint2& b, const AnyPoint2& c, TierCounts* t) {
    return orient2d(a, b, c, t);
  }
  static Sign by_formula(const Exact& a, const Exact& b, const Exact& c) {
    return formulas::Orient2d<Rational>(a[0], a[1], b[0], b[1], c[0], c[1]).det().sign();
  }
};
struct InCircle {
  static Sign decide(const AnyPoint2& a, const AnyPoint2& b, const AnyPoint2& c, const AnyPoint2& d,
                     TierCounts* t) {
    return in_circle(a, b, c, d, t);
  }
  static Sign by_formula(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return formulas::InCircle<Rational>(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1])
        .det()
        .sign();
  }
};
struct Orient3d {
  static Sign decide(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
                     TierCounts* t) {
    return orient3d(a, b, c, d, t);
  }
  static Sign by_formula(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return dot(cross(minus(b, a), minus(c, a)), minus(d, a)).sign();
  }
};
struct InSphere {
  static Sign decide(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
                     const AnyPoint3& e, TierCounts* t) {
    return in_sphere(a, b, c, d, e, t);
  }
  static Sign by_formula(const Exact& a, const Exact& b, const Exact& c, const Exact& d,
                         const Exact& e) {
    return formulas::InSphere<Rational>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0],
                                        d[1], d[2], e[0], e[1], e[2])
        .det()
        .sign();
  }
};
template <typename View>
struct CompareLexicographic {
  static Sign decide(const View& p, const View& q, TierCounts* t) {
    return compare_lexicographic(p, q, t);
  }
  static Sign by_formula(const Exact& p, const Exact& q) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] != q[i]) return (p[i] - q[i]).sign();
    }
    return Sign::kZero;
  }
};

template <typename Predicate, char... Kinds>
Sign decide(const Operands& v, TierCounts* tally) {
  Reader r(v);
  const std::tuple points{point<Kinds>(r)...};  // braces evaluate in order
  return std::apply([&](const auto&... p) { return Predicate::decide(p..., tally); }, points);
}
template <typename Predicate, char... Kinds>
Sign by_formula(const Operands& v) {
  Reader r(v);
  const std::array<Exact, sizeof...(Kinds)> points{exact(point<Kinds>(r))...};
  return std::apply([&](const auto&... p) { return Predicate::by_formula(p...); }, points);
}
template <char... Kinds>
bool is_defined(const Operands& v) {
  Reader r(v);
  const std::tuple points{point<Kinds>(r)...};
  const auto one = [](const auto& p) {
    if constexpr (requires { p.is_defined(); }) {
      return p.is_defined();
    } else {
      return true;
    }
  };
  return std::apply([&](const auto&... p) { return (one(p) && ...); }, points);
}

template <typename Predicate, char... Kinds>
constexpr NamedPredicate row(std::string_view name, std::string_view arguments,
                             std::string_view kinds) {
  return {name,
          arguments,
          kinds[0] == 'E' || kinds[0] == 'S' || kinds[0] == 'X' ? 2 : 3,
          (num_operands(Kinds) + ...),
          decide<Predicate, Kinds...>,
          by_formula<Predicate, Kinds...>,
          kinds,
          is_defined<Kinds...>};
}
constexpr NamedPredicate kImplicitPredicates[] = {
    row<Orient2d, 'E', 'E', 'X'>("orient2d_ssi", "a b SSI", "EEX"),
    row<Orient2d, 'S', 'S', 'S'>("orient2d_segment", "SEG2 SEG2 SEG2", "SSS"),
    row<InCircle, 'E', 'E', 'E', 'X'>("in_circle_ssi", "a b c SSI", "EEEX"),
    row<InCircle, 'S', 'S', 'S', 'S'>("in_circle_segment", "SEG2 SEG2 SEG2 SEG2", "SSSS"),
    row<CompareLexicographic<AnyPoint2>, 'X', 'X'>("compare_lexicographic_ssi", "SSI SSI", "XX"),
    row<Orient3d, 'e', 'e', 'e', 'l'>("orient3d_lpi", "a b c LPI", "eeel"),
    row<Orient3d, 'e', 'e', 'e', 'p'>("orient3d_tpi", "a b c TPI", "eeep"),
    row<Orient3d, 'l', 'l', 'l', 'l'>("orient3d_lpi4", "LPI LPI LPI LPI", "llll"),
    row<Orient3d, 's', 't', 'l', 'p'>("orient3d_mixed", "SEG TRI LPI TPI", "stlp"),
    row<InSphere, 'e', 'e', 'e', 'e', 'l'>("in_sphere_lpi", "a b c d LPI", "eeeel"),
    row<InSphere, 'e', 's', 't', 'l', 's'>("in_sphere_mixed", "a SEG TRI LPI SEG", "estls"),
    row<CompareLexicographic<AnyPoint3>, 'l', 'l'>("compare_lexicographic_lpi", "LPI LPI", "ll"),
    row<CompareLexicographic<AnyPoint3>, 'p', 'p'>("compare_lexicographic_tpi", "TPI TPI", "pp"),
};
static_assert(num_operands('s') + num_operands('t') + num_operands('l') + num_operands('p') ==
              kMostOperands);

}  // namespace

std::span<const NamedPredicate> implicit_predicates() { return kImplicitPredicates; }

}  // namespace veritope
