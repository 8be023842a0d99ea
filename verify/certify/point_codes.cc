// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/point_codes.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/broad_phase.h"
#include "verify/certify/certificate_entities.h"

namespace veritope {
namespace {

constexpr std::size_t kFewBoxes = 16;  // a direction with no more boxes is taken at once

BoxGroups groups_of(const TriangleMesh& mesh, unsigned jobs) {
  std::vector<std::uint32_t> all(mesh.faces.size());
  std::iota(all.begin(), all.end(), 0u);
  const UnitScale scale(bounding_box_of_faces(mesh, jobs));
  const VertexStars no_stars{std::vector<std::uint8_t>(mesh.positions.size(), kNoStar), {}};
  return BoxGroups(mesh, morton_order(mesh, all, scale, jobs), no_stars, scale, jobs);
}

// Whether a checker has to look at the facet.
bool is_unit(const TriangleMesh& mesh, std::uint32_t facet, const Vec3d& q, std::uint8_t code) {
  Box3d box = empty_box();
  for (const std::uint32_t v : mesh.faces[facet]) add(to_point(mesh.positions[v]), &box);
  const Point3d at = to_point(q);
  if (is_inside({at, at}, box)) return true;
  const std::size_t u = code / 2u;
  for (const std::size_t k : {(u + 1) % 3, (u + 2) % 3})
    if (at[k] < box.lo[k] || at[k] >= box.hi[k]) return false;
  return code % 2 == 0 ? box.hi[u] >= at[u] : box.lo[u] <= at[u];
}

// Approximately.
Box3d box_of(const PatchComplex& complex) {
  Box3d out = empty_box();
  for (const Patch& patch : complex.patches())
    for (std::size_t i = 0; i < patch.num_control(); ++i) {
      Point3d at{};
      for (int k = 0; k < 3; ++k) {
        Rational x = patch.component(k)[i];
        if (patch.is_rational()) x /= patch.component(3)[i];
        at[static_cast<std::size_t>(k)] = nearest_double(x);
      }
      add(at, &out);
    }
  return out;
}

using Polynomial = std::vector<Rational>;  // the constant coefficient first

// Whether all Bernstein coefficients on [lo, hi] are positive.
bool is_positive_between(const Polynomial& p, const Rational& lo, const Rational& hi) {
  const std::size_t n = p.size() - 1;
  Polynomial moved(n + 1);  // p(lo + (hi - lo) x), by Horner's scheme
  for (std::size_t k = n + 1; k-- > 0;) {
    for (std::size_t i = n + 1; i-- > 0;)
      moved[i] = lo * moved[i] + (i > 0 ? (hi - lo) * moved[i - 1] : Rational(0));
    moved[0] += p[k];
  }
  // Coefficient i is the sum of C(i, k) / C(n, k) times that of x^k.
  for (std::size_t i = 0; i <= n; ++i) {
    Rational sum, factor(1);
    for (std::size_t k = 0; k <= i; ++k) {
      sum += factor * moved[k];
      if (k < i)
        factor *=
            Rational(static_cast<std::int64_t>(i - k)) / Rational(static_cast<std::int64_t>(n - k));
    }
    if (sum.sign() <= 0) return false;
  }
  return true;
}

Polynomial difference(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  return a;
}

// What the page calls U, V, and what else is positive in the interior of the domain.
bool is_inside_domain(const PrimitivePair& pair, bool is_triangle) {
  const Polynomial one{Rational(1)};
  std::vector<Polynomial> all{pair.numbers[0], pair.numbers[1], difference(one, pair.numbers[0])};
  if (is_triangle)
    all.back() = difference(all.back(), pair.numbers[1]);
  else
    all.push_back(difference(one, pair.numbers[1]));
  return std::ranges::all_of(
      all, [&](const Polynomial& p) { return is_positive_between(p, pair.lo, pair.hi); });
}

std::vector<certificate::Fraction> fractions(const std::vector<Rational>& polynomial) {
  std::vector<certificate::Fraction> out;
  for (const Rational& x : polynomial) out.push_back(to_fraction(x));
  return out;
}

}  // namespace

class MeshDirections::Boxes {
 public:
  Boxes(const TriangleMesh& mesh, unsigned jobs) : mesh_(mesh), boxes_(groups_of(mesh, jobs)) {}

  RayDirection from(const Vec3d& p) const {
    std::vector<std::uint32_t> met;
    for (std::size_t few = kFewBoxes;; few *= 8)
      for (std::uint8_t code = 0; code < 6; ++code) {
        met.clear();
        if (!boxes_.stabbed(p, code / 2, code % 2 == 0, few, met)) continue;
        const auto units = std::count_if(
            met.begin(), met.end(), [&](std::uint32_t f) { return is_unit(mesh_, f, p, code); });
        return {code, static_cast<std::uint64_t>(units)};
      }
  }

 private:
  const TriangleMesh& mesh_;
  const BoxGroups boxes_;
};

MeshDirections::MeshDirections(const TriangleMesh& mesh, unsigned jobs)
    : boxes_(std::make_unique<const Boxes>(mesh, jobs)) {}
MeshDirections::MeshDirections(MeshDirections&&) noexcept = default;
MeshDirections::~MeshDirections() = default;

RayDirection MeshDirections::from(const Vec3d& point) const { return boxes_->from(point); }

PatchDirections::PatchDirections(const PatchComplex& complex) : box_(box_of(complex)) {}

std::uint8_t PatchDirections::from(const Vec3d& p) const {
  const Point3d at = to_point(p);
  std::uint8_t out = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint8_t code = 0; code < 6; ++code) {
    const std::size_t k = code / 2u;
    const double length = code % 2 == 0 ? box_.hi[k] - at[k] : at[k] - box_.lo[k];
    if (length < least) least = length, out = code;
  }
  return out;
}

std::optional<CertifiedPlace> place_on_patch(const PatchComplex& complex, const OnPatch& where) {
  // The certificate has barycentric coordinates of triangles.
  const bool is_triangle = complex.patch(where.patch).is_triangle();
  if (where.parameters.is_rational()) {
    const Rational &u = where.parameters[0].lo, &v = where.parameters[1].lo;
    return CertifiedPlace{
        certificate::PointOnPatch{where.patch,
                                  {to_fraction(is_triangle ? u * (Rational(1) - v) : u),
                                   to_fraction(is_triangle ? u * v : v)}},
        true};
  }
  std::optional<PrimitivePair> pair = primitive_pair(where.parameters);
  if (!pair) return std::nullopt;
  if (is_triangle) {
    auto& [u, v] = pair->numbers;
    std::vector<Rational> rest = v;  // 1 - v
    for (Rational& x : rest) x.negate();
    rest.front() += Rational(1);
    std::vector<Rational> second = product_modulo(u, v, pair->modulus);
    u = product_modulo(u, rest, pair->modulus);
    v = std::move(second);
  }
  return CertifiedPlace{certificate::AlgebraicPointOnPatch{
                            where.patch,
                            fractions(pair->modulus),
                            {to_fraction(pair->lo), to_fraction(pair->hi)},
                            {fractions(pair->numbers[0]), fractions(pair->numbers[1])}},
                        is_inside_domain(*pair, is_triangle)};
}

}  // namespace veritope
