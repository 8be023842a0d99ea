// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_invalid_certifier.h"

#include "robust/base/check.h"

namespace veritope {
namespace {

certificate::UnitInterval interval_of(const DyadicInterval& t) { return {t.bits, t.lo, t.hi}; }

// Certificates number the sides of a triangle by the opposite corner.
std::uint8_t side_number(const Patch& patch, std::uint32_t side) {
  return static_cast<std::uint8_t>(patch.is_triangle() ? (side + 2) % 3 : side);
}

certificate::CrossingFinding finding_of(const PatchComplex& complex, const CrossingWitness& found,
                                        const std::vector<bool>& is_reversed) {
  const Patch &a = complex.patch(found.sheets[0].patch), &b = complex.patch(found.sheets[1].patch);
  const std::array<bool, 2> flags{is_reversed[found.sheets[0].patch],
                                  is_reversed[found.sheets[1].patch]};
  const CrossingWitness w = with_reversed(a, b, flags, found);
  VT_CHECK(!broken_condition(flags[0] ? reversed(a) : a, flags[1] ? reversed(b) : b, w),
           "a witness of a crossing is a proof");
  certificate::CrossingFinding out;
  for (std::size_t s = 0; s < 2; ++s)
    out.sheets[s] = {w.sheets[s].patch,
                     {interval_of(w.sheets[s].at[0]), interval_of(w.sheets[s].at[1])}};
  out.rows = w.rows;
  return out;
}

certificate::SideFinding finding_of(const PatchComplex& complex, const SideWitness& found,
                                    const std::vector<bool>& is_reversed) {
  const SideWitness w = with_reversed(complex, is_reversed, found);
  certificate::SideFinding out;
  for (const SideArc& arc : w.arcs)
    out.arcs.push_back({arc.side.patch, side_number(complex.patch(arc.side.patch), arc.side.side),
                        interval_of(arc.at)});
  out.axis = w.axis;
  out.point_bits = w.point_bits, out.point = w.point;
  out.same = w.same, out.opposite = w.opposite;
  return out;
}

std::uint64_t short_number(const Integer& n) {
  VT_CHECK(n.bit_length() <= 62, "parameters of meetings are short");
  return n.low_bits();
}

certificate::PatchMeetingBody body_of(const PatchComplex& complex, const MeetingWitness& found,
                                      const std::vector<bool>& is_reversed) {
  VT_CHECK(!broken_condition(complex, found), "a witness of a meeting is a proof");
  const MeetingWitness w = with_reversed(complex, is_reversed, found);
  certificate::PatchMeetingBody out;
  for (std::size_t i = 0; i < 2; ++i) {
    out.places[i].patch = w.places[i].patch;
    for (std::size_t k = 0; k < 2; ++k)
      out.places[i].at[k] = {short_number(w.places[i].at[k].numerator()),
                             short_number(w.places[i].at[k].denominator())};
  }
  return out;
}

}  // namespace

certificate::Bytes make_patch_invalid_certificate(const PatchComplex& complex,
                                                  const PatchInvalidWitness& witness,
                                                  const std::vector<StarBoxEntity>& entities,
                                                  const certificate::Subject& subject) {
  const std::size_t n = complex.patches().size();
  const std::vector<bool> is_reversed = reversed_patches(entities, n);
  if (const auto* const meeting = std::get_if<MeetingWitness>(&witness)) {
    certificate::PatchMeetingBody body = body_of(complex, *meeting, is_reversed);
    body.entities = to_certificate(entities);
    return certificate::encode(subject, n, body);
  }
  certificate::PatchInvalidBody body;
  body.entities = to_certificate(entities);
  if (const auto* const sides = std::get_if<SideWitness>(&witness)) {
    VT_CHECK(!broken_condition(complex, outer_sides(entities, n), *sides),
             "a witness of sides is a proof");
    body.finding = finding_of(complex, *sides, is_reversed);
  } else {
    body.finding = finding_of(complex, std::get<CrossingWitness>(witness), is_reversed);
  }
  return certificate::encode(subject, n, body);
}

}  // namespace veritope
