// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>

#include "robust/base/check.h"
#include "solids/patches/patch_complex_internal.h"

namespace veritope {
namespace {

constexpr std::array<const char*, kNumPatchDefects> kNames = {
    "open-side",      "near-miss", "overused-side", "direction",  "one-sided",
    "repeated-patch", "weight",    "degree",        "not-finite", "adjacent-poles"};

std::string shortest(double v) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), v).ptr;
  return std::string(text.data(), end);
}
std::string point_text(const Point3d& p) {
  return "(" + shortest(p[0]) + ", " + shortest(p[1]) + ", " + shortest(p[2]) + ")";
}
std::string patch_text(const PatchComplex& complex, std::uint32_t patch) {
  return to_string(complex.patch(patch).origin());
}
std::string side_text(const PatchComplex& complex, PatchSide s) {
  const Patch& patch = complex.patch(s.patch);
  return patch_text(complex, s.patch) + ", side " + std::to_string(s.side) + ", from " +
         point_text(approx_point(patch.corner(s.side))) + " to " +
         point_text(approx_point(patch.corner((s.side + 1) % patch.num_sides())));
}
std::string weight_text(const PatchComplex& complex, const PatchFinding& f) {
  const Rational& w = complex.patch(f.sides[0].patch).component(3)[f.control];
  return patch_text(complex, f.sides[0].patch) + ": the weight of control point " +
         std::to_string(f.control) + " is " + w.to_string() + ", not positive";
}
std::string distance_text(const PatchFinding& f) {
  if (f.is_one_ulp) return "differ by one ulp: " + shortest(f.distance);
  return "differ by " + shortest(f.distance);
}

std::string sentence(const PatchComplex& complex, const PatchFinding& f) {
  const auto side = [&](std::size_t i) { return side_text(complex, f.sides[i]); };
  const auto patch = [&](std::size_t i) { return patch_text(complex, f.sides[i].patch); };
  switch (f.defect) {
    case PatchDefect::kOpenSide: return side(0) + ": occurs once";
    case PatchDefect::kNearMiss: return side(0) + ", and " + side(1) + ": " + distance_text(f);
    case PatchDefect::kOverusedSide:
      return side(0) + ": occurs " + std::to_string(f.sides.size()) + " times, again in " +
             patch(1) + " and " + patch(2);
    case PatchDefect::kDirection:
      return side(0) + ": runs in the same direction as side " + std::to_string(f.sides[1].side) +
             " of " + patch(1);
    case PatchDefect::kOneSided:
      return side(0) + ", and side " + std::to_string(f.sides[1].side) + " of " + patch(1) +
             ": whichever patches are reversed, some sides of this shell run in the same direction";
    case PatchDefect::kRepeatedPatch:
      return patch(1) + ": is " + patch(0) + " again" +
             (f.has_other_normal ? " with the other normal" : "");
    case PatchDefect::kWeight: return weight_text(complex, f);
    case PatchDefect::kDegree:
      return patch(0) + ": degree " + std::to_string(complex.patch(f.sides[0].patch).max_degree()) +
             "; at most " + std::to_string(kMaxPatchDegree) + " can be certified";
    case PatchDefect::kNotFinite:
      return "facet " + std::to_string(f.facet) + ": a coordinate is not finite";
    case PatchDefect::kAdjacentPoles:
      return side(0) + ": collapsed, and so is the next side; no star box covers their corner";
  }
  return "";
}

}  // namespace

const char* defect_name(PatchDefect defect) { return kNames[static_cast<std::size_t>(defect)]; }

std::string describe(const PatchComplex& complex, const PatchFinding& finding) {
  return std::string(defect_name(finding.defect)) + ": " + sentence(complex, finding);
}

void internal::find_bad_patches(std::span<const Patch> patches, const MatchedSides& matched,
                                std::vector<PatchFinding>& out) {
  const auto add = [&](PatchDefect defect, std::vector<PatchSide> sides, std::size_t control = 0) {
    PatchFinding& f = out.emplace_back();
    f.defect = defect;
    f.sides = std::move(sides);
    f.control = control;
  };
  for (std::uint32_t p = 0; p < patches.size(); ++p) {
    const Patch& patch = patches[p];
    if (patch.max_degree() > kMaxPatchDegree) add(PatchDefect::kDegree, {{p, 0}});
    if (patch.is_rational()) {
      const auto weights = patch.component(3);
      const auto bad = std::find_if(weights.begin(), weights.end(),
                                    [](const Rational& w) { return w.sign() != Sign::kPositive; });
      if (bad != weights.end())
        add(PatchDefect::kWeight, {{p, 0}}, static_cast<std::size_t>(bad - weights.begin()));
    }
    const std::uint32_t n = patch.num_sides();
    const auto collapsed = [&](std::uint32_t s) {
      return matched.edge_of_side[4 * std::size_t{p} + s % n] == PatchComplex::kNone;
    };
    for (std::uint32_t s = 0; s < n; ++s)
      if (collapsed(s) && collapsed(s + 1))
        add(PatchDefect::kAdjacentPoles, {{p, s}, {p, (s + 1) % n}});
  }
}

}  // namespace veritope
