// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/refutation_finding.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "splines/de_casteljau.h"
#include "verify/certify/entity_parts.h"
#include "verify/certify/miranda_internal.h"
#include "verify/certify/parameter_text.h"

namespace veritope {
namespace {

// The arcs of a side that are listed: it may have millions. The message has their number, the certificate all of them.
constexpr std::size_t kMostParts = 20;

std::string shortest(double v) {
  std::array<char, 32> text;
  return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), v).ptr);
}
std::string point_text(const Point3d& p) {
  return "(" + shortest(p[0]) + ", " + shortest(p[1]) + ", " + shortest(p[2]) + ")";
}

// False if a coordinate lies beyond binary64.
bool is_finite(const Point3d& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

class FactFinder {
 public:
  FactFinder(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities)
      : complex_(complex), parts_(complex, entities) {}

  Finding operator()(const CrossingWitness& found) const {
    std::array<Patch, 2> patches{parts_.file_patch(found.sheets[0].patch),
                                 parts_.file_patch(found.sheets[1].patch)};
    const CrossingWitness w = with_reversed(
        complex_.patch(found.sheets[0].patch), complex_.patch(found.sheets[1].patch),
        {parts_.is_reversed(found.sheets[0].patch), parts_.is_reversed(found.sheets[1].patch)},
        found);
    Finding out;
    out.code = "patches-crossing";
    for (const PatchRectangle& sheet : w.sheets) out.place.parts.push_back(parts_.of(sheet));
    out.place.near = middle_of(patches[0], w.sheets[0]);
    out.place.box = common(hull_of(patches[0], w.sheets[0]), hull_of(patches[1], w.sheets[1]));
    const std::size_t a = parts_.entity_of(found.sheets[0].patch);
    const std::size_t b = parts_.entity_of(found.sheets[1].patch);
    const bool are_faces = out.place.parts[0].face.has_value();
    out.message =
        (parts_.name(a) == parts_.name(b) ? parts_.name(a) + " crosses itself"
         : are_faces                      ? parts_.name(a) + " and " + parts_.name(b) + " cross"
                     : "entities " + std::to_string(a) + " and " + std::to_string(b) + " cross") +
        " near " + point_text(*out.place.near);
    return out;
  }

  Finding operator()(const SideWitness& found) const {
    Finding out;
    const std::size_t n = found.arcs.size();
    for (std::size_t i = 0; i < std::min(n, kMostParts); ++i)
      out.place.parts.push_back(parts_.of(found.arcs[i]));
    const PatchPoint p = point_of(complex_, found);
    out.witness.point = RationalPoint{{p[0], p[1], p[2]}};
    out.place.near = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
    const std::string side = parts_.name_of(found.arcs.front().side);
    if (n == 1) {
      out.code = "side-open";
      out.message = side + " is an open border";
    } else if (n == 2) {
      out.code = "side-direction";
      out.message =
          side + " and " + parts_.name_of(found.arcs[1].side) + " run in the same direction";
    } else {
      out.code = "side-overused";
      out.message = side + " and " + std::to_string(n - 1) + " other sides are one curve";
    }
    if (is_finite(*out.place.near)) out.message += ", near " + point_text(*out.place.near);
    return out;
  }

  Finding operator()(const MeetingWitness& found) const {
    std::vector<bool> is_reversed(complex_.patches().size());
    for (const PatchPlace& place : found.places)
      is_reversed[place.patch] = parts_.is_reversed(place.patch);
    const MeetingWitness w = with_reversed(complex_, is_reversed, found);
    Finding out;
    out.code = code_of(w.cause);
    for (const PatchPlace& place : w.places) out.place.parts.push_back(parts_.of(place));
    const PatchPoint p = point_of(complex_, found);
    out.witness.point = RationalPoint{{p[0], p[1], p[2]}};
    out.place.near = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
    out.message =
        text_of(w.cause, parts_.name_of(w.places[0].patch), parts_.name_of(w.places[1].patch));
    if (is_finite(*out.place.near)) out.message += ", near " + point_text(*out.place.near);
    return out;
  }

  Finding operator()(const ReversedShell& reversed) const {
    Finding out;
    out.code = "shell-turned";
    out.place.shell = reversed.shell;
    out.witness.winding = reversed.winding;
    const std::uint32_t patch = complex_.shells()[reversed.shell].first_patch;
    out.place.parts.push_back(
        parts_.of(PatchRectangle{patch, {DyadicInterval::whole(), DyadicInterval::whole()}}));
    out.message =
        "the winding number is " + std::to_string(reversed.winding) +
        " on the inner side of shell " + std::to_string(reversed.shell) + " (" +
        parts_.name_of(patch) + ") and " + std::to_string(reversed.winding - 1) +
        " on its outer side, not 1 and 0: its normals point the wrong way, or it is wrongly "
        "nested";
    return out;
  }

 private:
  static const char* code_of(MeetingWitness::Cause cause) {
    switch (cause) {
      case MeetingWitness::Cause::kRepeatedPatch: return "patch-repeated";
      case MeetingWitness::Cause::kDegeneratePatch: return "patch-degenerate";
      case MeetingWitness::Cause::kContact: return "patches-touching";
      case MeetingWitness::Cause::kSingularLine: break;
    }
    return "singular-line";
  }
  static std::string text_of(MeetingWitness::Cause cause, const std::string& first,
                             const std::string& second) {
    switch (cause) {
      case MeetingWitness::Cause::kRepeatedPatch:
        return "a patch of " + second + " is one of " + first + " again";
      case MeetingWitness::Cause::kDegeneratePatch:
        return "a patch of " + first + " is a point or a curve";
      case MeetingWitness::Cause::kContact:
        return first == second ? first + " touches itself" : first + " and " + second + " touch";
      case MeetingWitness::Cause::kSingularLine: break;
    }
    return "a line inside a patch of " + first + " is mapped to one point";
  }
  static Point3d middle_of(const Patch& patch, const PatchRectangle& where) {
    std::array<Rational, 2> at;
    for (std::size_t axis = 0; axis < 2; ++axis)
      at[axis] = (where.at[axis].lower() + where.at[axis].upper()) / Rational(2);
    const std::vector<Rational> p = evaluate(tensor_form(patch), at);
    return approx_point(std::span<const Rational>(p));
  }
  static Box3d hull_of(const Patch& patch, const PatchRectangle& where) {
    BezierSurface<Rational> map = tensor_form(patch);
    for (std::size_t axis = 0; axis < 2; ++axis)
      map = internal::part_along(std::move(map), axis, where.at[axis].lower(),
                                 where.at[axis].upper());
    Box3d out;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Rational, 3> y{};
      y[k] = Rational(1);
      const auto range = internal::control_values(map, y, std::nullopt);
      out.lo[k] = round_down(range.least), out.hi[k] = round_up(range.greatest);
    }
    return out;
  }
  const PatchComplex& complex_;
  EntityParts parts_;
};

}  // namespace

Finding finding_of(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities,
                   const PatchRefutation& refutation) {
  return std::visit(FactFinder(complex, entities), refutation);
}

}  // namespace veritope
