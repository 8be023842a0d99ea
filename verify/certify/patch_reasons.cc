// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_reasons.h"

#include <algorithm>
#include <utility>

#include "robust/binary64.h"
#include "solids/patches/patch_degeneracies.h"
#include "solids/patches/side_overlaps.h"
#include "verify/certify/entity_parts.h"
#include "verify/certify/parameter_text.h"

namespace veritope {
namespace {

std::optional<Point3d> finite(const Point3d& p) {
  for (const double c : p)
    if (!veritope::is_finite(c)) return std::nullopt;
  return p;
}

class Reasons {
 public:
  Reasons(const FilePatches& patches, std::size_t most)
      : complex_(*patches.complex),
        torn_(patches.torn),
        outer_(outer_sides(patches.entities, complex_.patches().size())),
        parts_(complex_, patches.entities),
        most_(most) {}

  std::vector<Finding> run() {
    for (const PatchFinding& f : complex_.findings())
      if (f.defect == PatchDefect::kRepeatedPatch) add(repeated(f));
    for (const PatchDegeneracy& d : find_degeneracies(complex_.patches())) add(degenerate(d));
    put_inner_poles();
    for (const TornKnot& knot : torn_) add(torn_knot_finding(knot));
    if (complex_.count(PatchDefect::kOpenSide) != 0) put_sides();
    return std::move(out_);
  }

 private:
  void add(Finding finding) {
    if (out_.size() < most_) out_.push_back(std::move(finding));
  }
  EntityPart whole(std::uint32_t patch) const {
    const std::size_t n = complex_.patch(patch).is_triangle() ? 3 : 2;
    return parts_.of(PatchPart{patch, std::vector<std::array<double, 2>>(n, {0, 1})});
  }
  Finding about(std::uint32_t patch) const {
    Finding out;
    out.place.patch = patch;
    out.place.source.entity = parts_.number_in_file(parts_.entity_of(patch));
    return out;
  }

  Finding repeated(const PatchFinding& f) const {
    const std::uint32_t first = f.sides[0].patch, again = f.sides[1].patch;
    Finding out = about(again);
    out.code = "patch-repeated";
    out.place.parts = {whole(first), whole(again)};
    out.message = "a patch of " + parts_.name_of(again) + " is one of " + parts_.name_of(first) +
                  " again" + (f.has_other_normal ? ", with the other normal" : "") +
                  ": delete one of the two";
    return out;
  }

  Finding degenerate(const PatchDegeneracy& d) const {
    Finding out = about(d.patch);
    out.place.parts = {whole(d.patch)};
    out.place.near = finite(approx_point(complex_.patch(d.patch).corner(0)));
    const std::string name = parts_.name_of(d.patch);
    if (d.kind != PatchDegeneracy::Kind::kSingularLine) {
      out.code = "patch-degenerate";
      out.message =
          d.kind == PatchDegeneracy::Kind::kPoint
              ? "all control points of a patch of " + name + " are one point: delete it"
              : "a patch of " + name + " is a curve, its normal is zero everywhere: delete it";
      return out;
    }
    out.code = "singular-line";
    out.place.parts = {line(d)};
    out.message = "a line inside a patch of " + name + ", " + line_text(d, out.place.parts[0]) +
                  ", is mapped to one point: different places of the surface have one image";
    return out;
  }
  // Sides on breaks inside of a surface that are one point: each is a side of two patches, and named for the one of
  // which it is the end.
  void put_inner_poles() {
    for (std::uint32_t p = 0; p < complex_.patches().size(); ++p)
      for (const std::uint32_t s : {1u, 2u}) {
        const PatchSide side{p, s};
        if (complex_.patch(p).is_triangle() || is_outer(outer_, side) ||
            !complex_.is_collapsed(side))
          continue;
        Finding out = about(p);
        out.code = "singular-line";
        out.place.parts = {parts_.of(side, {Rational(0), Rational(1)})};
        out.place.near = finite(approx_point(complex_.patch(p).corner(s)));
        out.message =
            "a line inside of " + parts_.name_of(p) +
            ", where it is cut, is mapped to one point: different places of the surface have "
            "one image; make two surfaces of it there";
        add(std::move(out));
      }
  }
  EntityPart line(const PatchDegeneracy& d) const {
    PatchPart part{d.patch, {}};
    const bool is_triangle = complex_.patch(d.patch).is_triangle();
    part.parameters.assign(is_triangle ? 3 : 2, {0, 1});
    part.parameters[d.axis] = {round_down(d.at[0]), round_up(d.at[1])};
    return parts_.of(part);
  }
  std::string line_text(const PatchDegeneracy& d, const EntityPart& part) const {
    const bool is_triangle = complex_.patch(d.patch).is_triangle();
    std::size_t axis = d.axis;
    if (parts_.is_reversed(d.patch)) axis = is_triangle ? (3 - axis) % 3 : 1 - axis;
    const std::string name = parts_.parameter_name(d.patch, axis);
    const auto& [lo, hi] = part.parameters[parts_.parameter(d.patch, axis)];
    if (lo == hi) return name + " = " + number_text(Rational::from_double(lo));
    return name + " = approximately " + std::to_string(lo);
  }

  void put_sides() {
    const SideOverlaps overlaps = find_side_overlaps(complex_);
    for (const TJunction& t : t_junctions_of(complex_, overlaps.found)) add(t_junction(t));
    for (const SideOverlap& o : overlaps.found)
      if (o.agreement != CurveAgreement::kAffine) add(other_parameters(o));
    for (const auto& [a, b] : overlaps.undecided) {
      Finding out = of_sides(a, b);
      out.message = two_sides(a, b) +
                    " meet where a corner has no rational parameter with a short denominator: "
                    "whether they run along one curve is not decided";
      add(std::move(out));
    }
  }

  Finding t_junction(const TJunction& t) const {
    Finding out = about(t.side.patch);
    out.code = "side-t-junction";
    out.place.parts = {parts_.of(t.side, {t.at, t.at}),
                       parts_.of(t.neighbour, {Rational(0), Rational(1)})};
    const auto corner = complex_.patch(t.corner.patch).corner(t.corner.corner);
    out.place.near = finite(approx_point(corner));
    out.message = "a corner of " + parts_.name_of(t.corner.patch) + " lies inside " +
                  parts_.name_of(t.side) + ", along which the two agree: insert a vertex at " +
                  parts_.point_text(t.side, t.at) + " (veritope convert " +
                  (out.place.parts[0].face ? "--faces " : "") + "--rejoin does)";
    return out;
  }

  std::string two_sides(PatchSide a, PatchSide b) const {
    return parts_.name_of(a) + " and " + parts_.name_of(b);
  }
  Finding of_sides(PatchSide a, PatchSide b) const {
    Finding out = about(a.patch);
    out.code = "side-parametrization";
    out.place.parts = {parts_.of(a, {Rational(0), Rational(1)}),
                       parts_.of(b, {Rational(0), Rational(1)})};
    return out;
  }
  Finding other_parameters(const SideOverlap& o) const {
    Finding out = of_sides(o.sides[0], o.sides[1]);
    const auto arc = [&](std::size_t i) {
      const auto& [from, to] = o.at[i];
      return parts_.of(o.sides[i], from < to ? o.at[i] : std::array<Rational, 2>{to, from});
    };
    out.place.parts = {arc(0), arc(1)};
    out.message = two_sides(o.sides[0], o.sides[1]) +
                  (o.agreement == CurveAgreement::kProjective
                       ? " are the same points, passed at other speeds: a projective change of "
                         "parameter leads from one to the other"
                       : " lie on one curve, with other parameters, which no affine or projective "
                         "change makes equal") +
                  ": give both the control points of one of them";
    return out;
  }

  const PatchComplex& complex_;
  const std::vector<TornKnot>& torn_;
  const OuterSides outer_;
  EntityParts parts_;
  std::size_t most_;
  std::vector<Finding> out_;
};

}  // namespace

std::vector<Finding> patch_reasons(const FilePatches& patches, std::size_t most) {
  return Reasons(patches, most).run();
}

Finding torn_knot_finding(const TornKnot& knot) {
  Finding out;
  out.code = "knot-multiplicity";
  out.place.source.entity = knot.entity;
  const double lo = round_down(knot.at), hi = round_up(knot.at);
  EntityPart part;
  part.entity = knot.entity;
  part.parameters = {knot.domain[0], knot.domain[1]};
  part.parameters[knot.axis] = {lo, hi};
  out.place.parts = {std::move(part)};
  out.message = "a surface has an inner knot of a multiplicity above its degree: " +
                std::string(knot.axis == 0 ? "u" : "v") + " = " + number_text(knot.at) + " of " +
                entity_text(knot.entity) +
                (knot.is_broken ? ", where the surface breaks"
                                : ", where the surface could break, though it does not") +
                ": remove knots, or make two surfaces of it";
  return out;
}

std::string repetition_text(const FilePatches& patches, const SideWitness& witness) {
  const auto is_of_witness = [&](std::uint32_t patch) {
    return std::any_of(witness.arcs.begin(), witness.arcs.end(),
                       [&](const SideArc& arc) { return arc.side.patch == patch; });
  };
  const EntityParts parts(*patches.complex, patches.entities);
  for (const PatchFinding& f : patches.complex->findings()) {
    if (f.defect != PatchDefect::kRepeatedPatch) continue;
    const std::uint32_t first = f.sides[0].patch, again = f.sides[1].patch;
    if (is_of_witness(first) && is_of_witness(again))
      return "; " + parts.name_of(again) + " is " + parts.name_of(first) + " again";
  }
  return "";
}

}  // namespace veritope
