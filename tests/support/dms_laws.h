// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/dms_laws.h: the laws of simplex-spline solids, exactly, on a random model at random points: for the unit
// tests and for the experiment soak_dms_laws.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "tests/support/random_dms.h"

namespace veritope {

struct DmsLawCounts {
  std::uint64_t models = 0, pairs = 0;
  std::uint64_t special =
      0;  ///< points that rule H had to decide: on a face of a tetrahedron of the domain
  std::uint64_t on_knots = 0;  ///< on a plane of three knots of the tetrahedron that contains them
  std::uint64_t basis = 0;     ///< values of basis functions
};

namespace internal {

/// The degree-n form of a model with shared control points: the same values, for each tetrahedron.
inline DmsModel separated(const DmsModel& model) {
  DmsModel out = model;
  out.control = {true, {}, {}};
  for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t)
    for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
      const auto value = model.value(control_of(model, t, beta));
      out.control.values.insert(out.control.values.end(), value.begin(), value.end());
    });
  return out;
}
/// The model with four attributes more: the coordinates of the identity by the Greville rule, and 1.
inline DmsModel with_identity(const DmsModel& model) {
  DmsModel out = model;
  out.control.values.clear();
  const auto n = static_cast<std::size_t>(model.degree);
  for (const char* name : {"x", "y", "z", "one"}) out.attributes.emplace_back(name);
  for (std::size_t c = 0; c < model.num_control(); ++c) {
    const auto value = model.value(c);
    out.control.values.insert(out.control.values.end(), value.begin(), value.end());
    for (Rational& x : control_place(model, std::span(model.control.at).subspan(c * n, n),
                                     DmsControlRule::kGreville))
      out.control.values.push_back(std::move(x));
    out.control.values.emplace_back(1);
  }
  return out;
}
/// The model after affine maps of its domain and of space.
inline DmsModel mapped(const DmsModel& model, const DmsAffine& domain, const DmsAffine& space) {
  DmsModel out = model;
  for (DmsCloud& cloud : out.clouds)
    for (DmsPoint& knot : cloud) knot = domain(knot);
  const std::size_t size = out.num_components();
  for (std::size_t c = 0; c < out.num_control(); ++c) {
    const DmsPoint at{out.control.values[c * size], out.control.values[c * size + 1],
                      out.control.values[c * size + 2]};
    const DmsPoint image = space(at);
    for (std::size_t i = 0; i < 3; ++i) out.control.values[c * size + i] = image[i];
  }
  return out;
}

/// Whether the last four components are the point and 1, with their gradients.
inline bool is_identity_at(const DmsPoint& u, const DmsValue& at) {
  const std::size_t first = at.value.size() - 4;
  for (std::size_t i = 0; i < 4; ++i) {
    if (at.value[first + i] != (i < 3 ? u[i] : Rational(1))) return false;
    for (std::size_t j = 0; j < 3; ++j)
      if (at.gradient[first + i][j] != Rational(i == j ? 1 : 0)) return false;
  }
  return true;
}

/// Whether the closed hull of the knots V_γ can contain u: no direction of some has u beyond all knots.
inline bool may_contain(const DmsModel& model, std::uint32_t t, const TetrahedralIndex& gamma,
                        const DmsPoint& u) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const auto along = [&](const DmsPoint& p) {
          return Rational(x) * p[0] + Rational(y) * p[1] + Rational(z) * p[2];
        };
        bool is_beyond = true;
        for (std::size_t m = 0; m < 4; ++m)
          for (int i = 0; i <= gamma[m]; ++i)
            is_beyond = is_beyond && along(model.knot(model.tetrahedra[t][m], i)) < along(u);
        if (is_beyond) return false;
      }
  return true;
}

/// Whether u is on a plane of three of the tetrahedron's knots up to the degree - 1.
inline bool is_on_knot_plane(const DmsModel& model, std::uint32_t t, const DmsPoint& u) {
  std::vector<DmsPoint> knots;
  for (const std::uint32_t v : model.tetrahedra[t])
    for (int i = 0; i < std::max(1, model.degree); ++i) {
      const DmsPoint& knot = model.knot(v, i);
      if (std::find(knots.begin(), knots.end(), knot) == knots.end()) knots.push_back(knot);
    }
  for (std::size_t i = 0; i < knots.size(); ++i)
    for (std::size_t j = i + 1; j < knots.size(); ++j)
      for (std::size_t k = j + 1; k < knots.size(); ++k)
        if (simplex_oracle::volume6(knots[i], knots[j], knots[k], u).sign() == Sign::kZero)
          return true;
  return false;
}

}  // namespace internal

/// Empty, or which law is broken where. `points` points of the model of the seed.
inline std::string check_dms_laws(std::uint64_t seed, int max_degree, int points,
                                  DmsLawCounts& counts) {
  const RandomDms drawn = draw_dms(seed, max_degree);
  const DmsModel model = internal::with_identity(drawn.model), high = internal::separated(model);
  Random random(seed + 1'000'003);
  const DmsAffine of_domain = draw_affine(random), of_space = draw_affine(random, true);
  const DmsModel image = internal::mapped(model, of_domain, of_space);
  DmsEvaluator low_form(model), high_form(high), image_form(image);
  ++counts.models;
  for (int i = 0; i < points; ++i) {
    const DmsPoint u = draw_dms_point(random, model);
    const auto broken = [&](const char* law) {
      return std::string(law) + " is broken, " + drawn.text + " at " + text_of(u);
    };
    const auto place = low_form.locate(u);
    if (!place) return broken("location");
    ++counts.pairs;
    std::array<simplex_oracle::Point, 4> corners;
    for (std::size_t m = 0; m < 4; ++m)
      corners[m] = model.clouds[model.tetrahedra[place->tetrahedron][m]][0];
    const bool is_inner = !place->path.target();
    if (is_inner && !simplex_oracle::contains(corners, simplex_oracle::axes_path(u)))
      return broken("rule H");
    for (std::size_t m = 0; m < 4; ++m) {
      auto moved = corners;
      moved[m] = u;
      const Sign s = simplex_oracle::volume6(moved[0], moved[1], moved[2], moved[3]).sign();
      if (s == Sign::kNegative) return broken("rule H");
      if (s == Sign::kZero) {
        ++counts.special;
        break;
      }
    }
    const bool is_on_knots = internal::is_on_knot_plane(model, place->tetrahedron, u);
    counts.on_knots += is_on_knots ? 1 : 0;

    // The basis functions of both forms add up to 1, are not negative, and vanish off their knots.
    for (const int degree : {model.degree - 1, model.degree}) {
      if (i % 3 != 0) break;
      Rational sum;
      bool is_positive = true, is_near = true;
      low_form.for_each_basis(
          *place, degree, [&](std::uint32_t t, const TetrahedralIndex& gamma, const Rational& n) {
            sum += n;
            ++counts.basis;
            is_positive = is_positive && n.sign() != Sign::kNegative;
            if (n.sign() != Sign::kZero)
              is_near = is_near && internal::may_contain(model, t, gamma, u);
          });
      if (sum != Rational(1)) return broken("partition of unity");
      if (!is_positive) return broken("sign of the basis");
      if (!is_near) return broken("support");
    }

    // The forms agree, where (a) and (c) hold to the degree; the one of degree n has its gradient by eq. 2. Both add up
    // to 1 and have linear precision.
    const DmsValue value = low_form.evaluate(*place), other = high_form.evaluate(*place);
    if (!internal::is_identity_at(u, value)) return broken("linear precision");
    if (!internal::is_identity_at(u, other)) return broken("linear precision of degree n");
    if (value.value != other.value) return broken("agreement of the forms");
    if (value.gradient != other.gradient) return broken("agreement of the gradients");

    // Values lie between the control points'.
    for (std::size_t c = 0; c < value.value.size(); ++c) {
      Rational low = model.value(0)[c], up = low;
      for (std::size_t k = 1; k < model.num_control(); ++k) {
        low = std::min(low, model.value(k)[c]);
        up = std::max(up, model.value(k)[c]);
      }
      if (value.value[c] < low || up < value.value[c]) return broken("hull");
    }

    // Affine maps of the domain and of space. Gradients of one path, so off the boundary and off creases only.
    const DmsPoint v = of_domain(u);
    const auto image_place = image_form.locate(v);
    if (!image_place) return broken("location after an affine map");
    const DmsValue there = image_form.evaluate(*image_place);
    DmsPoint expected = of_space({value.value[0], value.value[1], value.value[2]});
    for (std::size_t c = 0; c < 3; ++c)
      if (there.value[c] != expected[c]) return broken("affine invariance");
    for (std::size_t c = 3; c < value.value.size(); ++c)
      if (there.value[c] != value.value[c]) return broken("affine invariance of attributes");
    if (!is_on_knots && model.degree == 1) {
      // grad(s o A) = grad s A: attributes' gradients, pulled back
      for (std::size_t c = 3; c < value.value.size(); ++c)
        for (std::size_t j = 0; j < 3; ++j) {
          Rational sum;
          for (std::size_t k = 0; k < 3; ++k) sum += there.gradient[c][k] * of_domain.m[k][j];
          if (sum != value.gradient[c][j]) return broken("affine invariance of gradients");
        }
    }

    // s does not depend on the path: another one into the domain gives the same value.
    std::array<Rational, 3> middle;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t m = 0; m < 4; ++m) middle[c] += corners[m][c] / Rational(4);
    const DmsPlace inward{place->tetrahedron,
                          EntryPath::inward(ExactPoint3(u), ExactPoint3(middle))};
    if (is_on_knots && middle != u && low_form.evaluate(inward).value != value.value)
      return broken("continuity");
  }
  return "";
}

}  // namespace veritope
