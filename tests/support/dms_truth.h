// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_truth.h: random simplex-spline solids whose verdict is known by construction: for tests and soak
// experiments.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_make.h"
#include "tests/support/random_dms.h"

namespace veritope::dms_truth {

enum class Truth {
  kValid,
  kInvalid,
  kNotInvalid,  ///< no defect, but a determinant that vanishes: no certificate says that it is valid
};
struct Case {
  DmsModel model;
  Truth truth = Truth::kValid;
  std::string text;  ///< what was made, with the seed
  std::string code;  ///< of the first defect; empty: any
};

inline Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

/// The control point of each multiset of vertices is value(its first knots): the polar form of a map of the degree.
template <typename Value>
void set_control_by_knots(DmsModel& model, Value value) {
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  const auto n = static_cast<std::size_t>(model.degree);
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    std::vector<DmsPoint> knots;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t v = model.control.at[c * n + i];
      int k = 0;
      while (static_cast<std::size_t>(k) < i &&
             model.control.at[c * n + i - 1 - static_cast<std::size_t>(k)] == v)
        ++k;
      knots.push_back(model.knot(v, k));
    }
    const DmsPoint at = value(knots);
    std::copy(at.begin(), at.end(),
              model.control.values.begin() + static_cast<std::ptrdiff_t>(3 * c));
  }
}
/// Moves each control point, placed by the Greville rule, by a map.
template <typename Map>
void warp_control(DmsModel& model, Map map) {
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    const auto at = model.control.values.begin() + static_cast<std::ptrdiff_t>(3 * c);
    const DmsPoint to = map(DmsPoint{at[0], at[1], at[2]});
    std::copy(to.begin(), to.end(), at);
  }
}

/// A box of cubes, with drawn clouds or without; all conditions hold.
inline DmsModel drawn_box(Random& random, std::array<int, 3> size, int degree, bool has_clouds) {
  DmsModel domain = kuhn_domain(size);
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  DmsMakeOptions options;
  options.degree = degree;
  if (has_clouds) options.clouds = DmsCloudDraw{ratio(1, 10), random.next()};
  return make_dms(domain, options).value();
}
/// An exact affine map of space, which keeps orientation.
inline void map_space(Random& random, DmsModel& model) {
  const DmsAffine affine = draw_affine(random);
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    const auto at = model.control.values.begin() + static_cast<std::ptrdiff_t>(3 * c);
    const DmsPoint to = affine(DmsPoint{at[0], at[1], at[2]});
    std::copy(to.begin(), to.end(), at);
  }
}

/// A tetrahedron cut into four, with a cloud at its inner vertex.
inline DmsModel four_tetrahedra(Random& random, int degree) {
  DmsModel m;
  m.degree = degree;
  m.clouds = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {}};
  for (int i = 0; i < degree; ++i) {
    DmsPoint knot;
    for (Rational& c : knot) c = ratio(1, 4) + ratio(random.between(-16, 16), i == 0 ? 256 : 320);
    m.clouds[4].push_back(std::move(knot));
  }
  m.tetrahedra = {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}};
  set_control_by_rule(m, DmsControlRule::kGreville, {});
  return m;
}
/// With clouds inside in half of the cases, and outward ones in few.
inline DmsModel drawn_domain(Random& random, int degree) {
  if (random.below(2) == 0) return four_tetrahedra(random, degree);
  return drawn_box(random, {1, 1, 1}, degree, random.below(8) == 0);
}

/// (i) Displacements of the identity on a convex domain by less than a proved margin: all |G_γ - 1| < 1, so
/// (u - v).(s(u) - s(v)) > 0.
inline Case displaced(std::uint64_t seed) {
  Random random(seed);
  const int degree = static_cast<int>(random.between(1, 3));
  Case out{drawn_domain(random, degree), Truth::kValid, "displaced, seed " + std::to_string(seed),
           ""};
  const DmsModel still = out.model;
  std::vector<Rational> moves;
  for (std::size_t i = 0; i < still.control.values.size(); ++i)
    moves.push_back(ratio(random.between(-1000, 1000), 4000));
  for (Rational scale(1);; scale *= ratio(2, 3)) {
    for (std::size_t i = 0; i < moves.size(); ++i)
      out.model.control.values[i] = still.control.values[i] + scale * moves[i];
    const DmsKnotTable knots(out.model);
    Rational most;
    for (std::uint32_t t = 0; t < out.model.tetrahedra.size(); ++t)
      for (const TetrahedralIndex& gamma : knots.gammas()) {
        const DmsMatrix g = knots.derivative({t, gamma});
        Rational sum;
        for (std::size_t i = 0; i < 9; ++i) {
          const Rational off = i % 4 == 0 ? g[i] - Rational(1) : g[i];
          sum += off * off;
        }
        most = std::max(most, sum);
      }
    if (most < ratio(81, 100)) break;
  }
  map_space(random, out.model);
  return out;
}

/// A cubic map with det Ds(u) = |u - p|^2 - δ: its first coordinate is the polar form of x^3/3 - c x^2 + (c^2 - δ) x +
/// x ((y - d)^2 + (z - e)^2), p = (c, d, e).
inline DmsPoint polar_form_of_fold(const std::vector<DmsPoint>& k, const DmsPoint& p,
                                   const Rational& delta) {
  const auto sum = [&](std::size_t a) { return k[0][a] + k[1][a] + k[2][a]; };
  const auto mean = [&](std::size_t a) { return sum(a) / Rational(3); };
  Rational squares, value = k[0][0] * k[1][0] * k[2][0] / Rational(3);
  const Rational x_pairs = k[0][0] * k[1][0] + k[0][0] * k[2][0] + k[1][0] * k[2][0];
  value -= p[0] * x_pairs / Rational(3);
  for (std::size_t a = 0; a < 3; ++a) squares += p[a] * p[a];
  value += (squares - delta) * mean(0);
  for (std::size_t a = 1; a < 3; ++a) {
    value +=
        (k[0][0] * k[1][a] * k[2][a] + k[1][0] * k[0][a] * k[2][a] + k[2][0] * k[0][a] * k[1][a]) /
        Rational(3);
    Rational mixed;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (i != j) mixed += k[i][0] * k[j][a];
    value -= Rational(2) * p[a] * mixed / Rational(6);
  }
  return {value, mean(1), mean(2)};
}
/// (ii) A fold of a radius of 2^-30 around a planted point, or its twin, whose determinant is 0 at that point alone.
inline Case folded(std::uint64_t seed, bool is_twin) {
  Random random(seed);
  Case out;
  out.text =
      std::string(is_twin ? "twin of a fold" : "fold of 2^-30") + ", seed " + std::to_string(seed);
  out.truth = is_twin ? Truth::kNotInvalid : Truth::kInvalid;
  out.code = is_twin ? "" : "jacobian";
  out.model = drawn_domain(random, 3);
  const DmsKnotTable knots(out.model);
  const auto corners =
      knots.corners(static_cast<std::uint32_t>(random.below(out.model.tetrahedra.size())));
  DmsPoint p;
  Rational total;
  for (const DmsPoint& corner : corners) {
    const Rational weight(random.between(1, 40));
    for (std::size_t c = 0; c < 3; ++c) p[c] += weight * corner[c];
    total += weight;
  }
  for (Rational& c : p) c /= total;
  const Rational delta = is_twin ? Rational(0) : Rational::power_of_two(-60);
  set_control_by_knots(
      out.model, [&](const std::vector<DmsPoint>& k) { return polar_form_of_fold(k, p, delta); });
  map_space(random, out.model);
  return out;
}
/// (ii) A control point is dragged until the determinant is below 0 at a drawn point.
inline Case dragged(std::uint64_t seed) {
  Random random(seed);
  const int degree = static_cast<int>(random.between(1, 4));
  Case out{drawn_domain(random, degree), Truth::kInvalid, "dragged, seed " + std::to_string(seed),
           "jacobian"};
  for (;;) {
    const std::size_t c = random.below(out.model.num_control());
    for (std::size_t i = 0; i < 3; ++i)
      out.model.control.values[3 * c + i] += ratio(random.between(-64, 64), 128);
    DmsEvaluator evaluator(out.model);
    const auto place = evaluator.locate(draw_dms_point(random, out.model));
    const auto g = evaluator.evaluate(*place).gradient;
    if (dot_product(g[0], cross_product(g[1], g[2])).sign() == Sign::kNegative) break;
  }
  map_space(random, out.model);
  return out;
}

inline Rational short_number(double x) {
  return Rational::from_double(std::round(std::ldexp(x, 20)) * 0x1p-20);
}
/// (iii) A bar of cubes, bent about an axis by an angle in degrees.
inline Case bent(std::uint64_t seed, bool is_valid) {
  Random random(seed);
  const int length = static_cast<int>(random.between(14, 18));
  const double degrees = is_valid ? 200 + 120 * random.unit() : 370 + 130 * random.unit();
  const double step = degrees * std::numbers::pi / 180 / length, inner = 1.2 + random.unit();
  // Half of the bars rise by less than their height.
  const Rational drift = random.below(2) == 0 ? Rational(0) : ratio(random.between(1, 4), 400);
  Case out;
  out.truth = is_valid ? Truth::kValid : Truth::kInvalid;
  out.text = "bent by " + std::to_string(degrees) + " degrees, seed " + std::to_string(seed);
  out.model = drawn_box(random, {1, 1, length}, 2, random.below(32) == 0);
  warp_control(out.model, [&](const DmsPoint& p) {
    const double r = inner + nearest_double(p[0]), a = step * nearest_double(p[2]);
    return DmsPoint{short_number(r * std::cos(a)), p[1] + drift * p[2],
                    short_number(r * std::sin(a))};
  });
  return out;
}
/// (iii) Tetrahedra around an edge of the domain, wound about its image by a multiple of their angle.
inline Case wound(std::uint64_t seed, bool is_valid) {
  Random random(seed);
  const int count = static_cast<int>(random.between(9, 14));
  const bool is_closed = !is_valid && random.below(2) == 0;
  const double whole = is_closed ? 360 : 340;
  const double factor = is_valid ? 1.0 : is_closed ? 2.0 : 720.0 / 340;
  Case out;
  out.truth = is_valid ? Truth::kValid : Truth::kInvalid;
  out.text = std::string(is_closed ? "closed" : "open") + " wedge, seed " + std::to_string(seed);
  DmsModel& m = out.model;
  m.degree = 1;
  m.clouds = {{{Rational(0), Rational(0), Rational(-1)}},
              {{Rational(0), Rational(0), Rational(1)}}};
  std::vector<DmsPoint> images{m.clouds[0][0], m.clouds[1][0]};
  const int rim = is_closed ? count : count + 1;
  for (int i = 0; i < rim; ++i) {
    const double angle = whole * i / count * std::numbers::pi / 180;
    const auto at = [&](double a, double r) {
      return DmsPoint{short_number(r * std::cos(a)), short_number(r * std::sin(a)), Rational(0)};
    };
    m.clouds.push_back({at(angle, 1)});
    images.push_back(at(angle * factor, 1 + random.unit() / 4));
  }
  for (int i = 0; i < count; ++i)
    m.tetrahedra.push_back(
        {0, 1, static_cast<std::uint32_t>(2 + i), static_cast<std::uint32_t>(2 + (i + 1) % rim)});
  for (std::uint32_t v = 0; v < images.size(); ++v) {
    m.control.at.push_back(v);
    m.control.values.insert(m.control.values.end(), images[v].begin(), images[v].end());
  }
  map_space(random, m);
  return out;
}

/// (iii) Two cubes. The map moves points of the first one by less than 1/20; the image of the second one is a small
/// parallelepiped inside of the image of the first one, or beside it.
inline Case nested(std::uint64_t seed, bool is_valid) {
  Random random(seed);
  const int degree = static_cast<int>(random.between(1, 3));
  Case out;
  out.truth = is_valid ? Truth::kValid : Truth::kInvalid;
  out.text = std::string(is_valid ? "beside" : "inside of") + " another body, seed " +
             std::to_string(seed);
  const auto drawn_cube = [&] {
    return drawn_box(random, {1, 1, 1}, degree, random.below(4) == 0);
  };
  out.model = drawn_cube();
  DmsModel& m = out.model;
  const auto count = static_cast<std::uint32_t>(m.clouds.size());
  for (const DmsModel second = drawn_cube(); const DmsCloud& cloud : second.clouds) {
    m.clouds.push_back(cloud);
    for (DmsPoint& knot : m.clouds.back()) knot[0] += Rational(3);
  }
  for (std::size_t t = 0, size = m.tetrahedra.size(); t < size; ++t) {
    m.tetrahedra.push_back(m.tetrahedra[t]);
    for (std::uint32_t& v : m.tetrahedra.back()) v += count;
  }
  const Rational size = ratio(random.between(2, 4), 16), slant = ratio(random.between(-8, 8), 80);
  DmsPoint from;
  for (Rational& c : from) c = ratio(random.between(3, 7), 16);
  if (is_valid) from[random.below(3)] += Rational(2);
  warp_control(m, [&](DmsPoint p) {
    if (p[0] < Rational(2)) {
      for (Rational& c : p) c += ratio(random.between(-16, 16), 640);
      return p;
    }
    p[0] -= Rational(3);
    return DmsPoint{from[0] + size * (p[0] + slant * p[1]), from[1] + size * (p[1] + slant * p[2]),
                    from[2] + size * (p[2] - slant * p[0])};
  });
  map_space(random, m);
  return out;
}

/// (iv) A cloud that breaks (a), (b) or (c) by 2^-40, or is legal by 2^-40.
inline Case clouded(std::uint64_t seed, bool is_valid) {
  Random random(seed);
  Case out;
  out.truth = is_valid ? Truth::kValid : Truth::kInvalid;
  const auto kind = random.below(3);
  out.code = is_valid ? "" : std::array{"cloud-degenerate", "cloud-no-core", "cloud-inside"}[kind];
  out.text = std::string(is_valid ? "legal twin of " : "") + std::to_string(kind) +
             " of clouds, seed " + std::to_string(seed);
  const Rational off = Rational::power_of_two(-40) * Rational(is_valid ? -1 : 1);
  DmsModel& m = out.model;
  m.degree = 2;
  // The middle of eight cubes, and its neighbour, are inside.
  DmsModel domain = kuhn_domain(kind == 2 ? std::array{1, 1, 1} : std::array{3, 2, 2});
  m.clouds = domain.clouds;
  m.tetrahedra = domain.tetrahedra;
  const auto moved = [&](std::uint32_t from, std::uint32_t to, const Rational& share) {
    DmsPoint p = m.clouds[from][0];
    for (std::size_t c = 0; c < 3; ++c) p[c] += share * (m.clouds[to][0][c] - p[c]);
    return p;
  };
  const std::uint32_t p = 13, q = 22;  // (1, 1, 1) and (2, 1, 1)
  if (kind == 0) {
    // q is as far as p's knot: W_(1,0,0,0) is flat at q. Beyond it is reversed.
    m.clouds[p].push_back(moved(p, q, Rational(1) + off));
  } else if (kind == 1) {
    const Rational middle = ratio(random.between(1, 9), 10);
    m.clouds[p].push_back(moved(p, q, middle + off));
    m.clouds[q].push_back(moved(q, p, Rational(1) - middle));
  } else {
    // A knot of a corner of the cube, outward along two axes, inward or outward along the third one, or in its plane.
    const std::uint32_t corner = static_cast<std::uint32_t>(random.below(8));
    const std::size_t axis = random.below(3);
    DmsPoint knot = m.clouds[corner][0];
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational inward(knot[c].sign() != Sign::kZero ? -1 : 1);
      if (c != axis)
        knot[c] -= inward * ratio(random.between(1, 4), 40);
      else if (!is_valid || random.below(2) == 0)
        knot[c] += inward * off;
    }
    m.clouds[corner].push_back(std::move(knot));
  }
  set_control_by_rule(m, DmsControlRule::kGreville, {});
  const DmsAffine affine = draw_affine(random);
  for (DmsCloud& cloud : m.clouds)
    for (DmsPoint& knot : cloud) knot = affine(knot);
  set_control_by_rule(m, DmsControlRule::kGreville, {});
  map_space(random, m);
  return out;
}

/// The classes, by name.
struct Class {
  const char* name;
  std::function<Case(std::uint64_t)> draw;
};
inline std::vector<Class> classes() {
  return {{"displaced", displaced},
          {"dragged", dragged},
          {"folded", [](std::uint64_t s) { return folded(s, false); }},
          {"fold_twins", [](std::uint64_t s) { return folded(s, true); }},
          {"bent", [](std::uint64_t s) { return bent(s, false); }},
          {"bent_twins", [](std::uint64_t s) { return bent(s, true); }},
          {"wound", [](std::uint64_t s) { return wound(s, false); }},
          {"wound_twins", [](std::uint64_t s) { return wound(s, true); }},
          {"nested", [](std::uint64_t s) { return nested(s, false); }},
          {"nested_twins", [](std::uint64_t s) { return nested(s, true); }},
          {"clouds", [](std::uint64_t s) { return clouded(s, false); }},
          {"cloud_twins", [](std::uint64_t s) { return clouded(s, true); }}};
}

}  // namespace veritope::dms_truth
