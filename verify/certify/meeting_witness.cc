// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/meeting_witness.h"

#include <algorithm>
#include <utility>

#include "solids/patches/patch_degeneracies.h"
#include "splines/de_casteljau.h"
#include "verify/certify/crossing_witness.h"

namespace veritope {
namespace {

using Cause = MeetingWitness::Cause;
using Parameters = std::array<Rational, 2>;

constexpr std::size_t kMostNumberBits = 62;  // of the numbers of a certificate

Rational ratio(int n, int d) { return Rational(n) / Rational(d); }

bool is_in_domain(const PatchPlace& place) {
  return std::all_of(place.at.begin(), place.at.end(), [](const Rational& v) {
    return v.sign() != Sign::kNegative && !(Rational(1) < v);
  });
}

// Reason (a): no gluing need be known.
bool is_first_alone(const PatchComplex& complex, const MeetingWitness& w) {
  const auto& [a, b] = w.places;
  return is_in_open_domain(a) &&
         !(complex.patch(b.patch).is_triangle() && b.at[0].sign() == Sign::kZero) && !(a == b);
}
bool holds_m1(const PatchComplex& complex, const MeetingWitness& w) {
  const auto& [a, b] = w.places;
  if (!is_in_domain(a) || !is_in_domain(b)) return false;
  return is_first_alone(complex, w) || (is_glued(complex) && !are_one_point(complex, a, b));
}

// The barycentric coordinate `axis` of a triangle is fixed, and `part` of the rest belongs to the next corner.
Parameters on_line_of_triangle(std::size_t axis, const Rational& fixed, const Rational& part) {
  std::array<Rational, 3> b;
  b[axis] = fixed;
  b[(axis + 1) % 3] = (Rational(1) - fixed) * part;
  b[(axis + 2) % 3] = (Rational(1) - fixed) * (Rational(1) - part);
  return {Rational(1) - b[0], b[2] / (Rational(1) - b[0])};
}

class MeetingSearch {
 public:
  explicit MeetingSearch(const PatchComplex& complex) : complex_(complex) {}

  std::optional<MeetingWitness> run() const {
    if (complex_.count(PatchDefect::kWeight) != 0 || complex_.count(PatchDefect::kDegree) != 0)
      return std::nullopt;
    for (const PatchFinding& f : complex_.findings())
      if (f.defect == PatchDefect::kRepeatedPatch)
        if (auto found = in_middles(f.sides[0].patch, f.sides[1].patch)) return found;
    for (const PatchDegeneracy& d : find_degeneracies(complex_.patches()))
      if (auto found = within(d)) return found;
    return std::nullopt;
  }

 private:
  std::optional<MeetingWitness> proof(Cause cause, PatchPlace a, PatchPlace b) const {
    if (!has_short_numbers(a) || !has_short_numbers(b)) return std::nullopt;
    MeetingWitness out{cause, {std::move(a), std::move(b)}};
    if (broken_condition(complex_, out)) return std::nullopt;
    return out;
  }

  // No order of the control points that describes a patch again moves its middle.
  std::optional<MeetingWitness> in_middles(std::uint32_t first, std::uint32_t again) const {
    const auto middle = [&](std::uint32_t patch) {
      if (complex_.patch(patch).is_triangle())
        return PatchPlace{patch, on_line_of_triangle(0, ratio(1, 3), ratio(1, 2))};
      return PatchPlace{patch, {ratio(1, 2), ratio(1, 2)}};
    };
    return proof(Cause::kRepeatedPatch, middle(first), middle(again));
  }

  std::optional<MeetingWitness> within(const PatchDegeneracy& d) const {
    if (d.kind == PatchDegeneracy::Kind::kSingularLine) {
      if (d.at[0] != d.at[1]) return std::nullopt;
      return on_line(Cause::kSingularLine, d.patch, d.axis, d.at[0]);
    }
    const std::size_t num_axes = complex_.patch(d.patch).is_triangle() ? 3 : 2;
    for (std::size_t axis = 0; axis < num_axes; ++axis)
      if (auto found = on_line(Cause::kDegeneratePatch, d.patch, axis, ratio(1, 4))) return found;
    return std::nullopt;
  }
  std::optional<MeetingWitness> on_line(Cause cause, std::uint32_t patch, std::size_t axis,
                                        const Rational& fixed) const {
    const auto place = [&](const Rational& part) {
      if (complex_.patch(patch).is_triangle())
        return PatchPlace{patch, on_line_of_triangle(axis, fixed, part)};
      return PatchPlace{patch, axis == 0 ? Parameters{fixed, part} : Parameters{part, fixed}};
    };
    return proof(cause, place(ratio(1, 4)), place(ratio(3, 4)));
  }

  const PatchComplex& complex_;
};

}  // namespace

bool has_short_numbers(const PatchPlace& place) {
  return std::all_of(place.at.begin(), place.at.end(), [](const Rational& v) {
    return v.numerator().bit_length() <= kMostNumberBits &&
           v.denominator().bit_length() <= kMostNumberBits;
  });
}

std::optional<MeetingCondition> broken_condition(const PatchComplex& complex,
                                                 const MeetingWitness& witness) {
  if (!holds_m1(complex, witness)) return MeetingCondition::kM1;
  if (point_of(complex, witness.places[0]) != point_of(complex, witness.places[1]))
    return MeetingCondition::kM2;
  return std::nullopt;
}

PatchPoint point_of(const PatchComplex& complex, const PatchPlace& place) {
  const std::vector<Rational> p = evaluate(tensor_form(complex.patch(place.patch)), place.at);
  return point_of(std::span<const Rational>(p)).value();
}

PatchPoint point_of(const PatchComplex& complex, const MeetingWitness& witness) {
  return point_of(complex, witness.places[0]);
}

MeetingWitness with_reversed(const PatchComplex& complex, const std::vector<bool>& is_reversed,
                             MeetingWitness witness) {
  for (PatchPlace& place : witness.places) {
    if (!is_reversed[place.patch]) continue;
    if (complex.patch(place.patch).is_triangle())
      place.at[1] = Rational(1) - place.at[1];
    else
      std::swap(place.at[0], place.at[1]);
  }
  return witness;
}

std::optional<MeetingWitness> find_meeting(const PatchComplex& complex) {
  return MeetingSearch(complex).run();
}

}  // namespace veritope
