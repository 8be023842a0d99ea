// SPDX-License-Identifier: LGPL-3.0-or-later
// The search for a SideWitness.
#include "verify/certify/side_witness.h"

namespace veritope {
namespace {

constexpr std::size_t kMostFindings = 16;
constexpr unsigned kPointBits = 4;     // points at k / 16
constexpr unsigned kMostShrinks = 16;  // halvings of an arc until a coordinate is monotone

class WitnessSearch {
 public:
  WitnessSearch(const PatchComplex& complex, const OuterSides& outer)
      : complex_(complex), outer_(outer) {}

  std::optional<SideWitness> run() {
    std::size_t tried = 0;
    for (const PatchFinding& finding : complex_.findings()) {
      if (!is_of_sides(finding.defect) || finding.sides.empty()) continue;
      const std::uint32_t edge = complex_.edge(finding.sides.front());
      if (edge == PatchComplex::kNone || edge == last_) continue;
      last_ = edge;
      if (tried++ == kMostFindings) break;
      if (auto witness = at_edge(edge)) return witness;
    }
    return std::nullopt;
  }

 private:
  static bool is_of_sides(PatchDefect defect) {
    return defect == PatchDefect::kOpenSide || defect == PatchDefect::kOverusedSide ||
           defect == PatchDefect::kDirection || defect == PatchDefect::kOneSided;
  }

  // Tries points at odd multiples of ever smaller powers of two.
  std::optional<SideWitness> at_edge(std::uint32_t edge) {
    for (unsigned bits = 1; bits <= kPointBits; ++bits)
      for (std::uint64_t k = 1; k < std::uint64_t{1} << bits; k += 2)
        if (auto witness = at_point(edge, bits, k)) return witness;
    return std::nullopt;
  }

  // The widest arc around the point along which a coordinate is monotone. D4 does not become easier for a narrower one.
  std::optional<SideWitness> at_point(std::uint32_t edge, unsigned bits, std::uint64_t k) {
    for (unsigned shrink = 0; shrink <= kMostShrinks; ++shrink) {
      DyadicInterval arc = DyadicInterval::whole();
      if (shrink > 0) {
        const std::uint64_t middle = k << shrink;
        arc = {bits + shrink, middle - 1, middle + 1};
      }
      for (std::uint8_t axis = 0; axis < 3; ++axis) {
        SideWitness w = of_edge(edge, arc);
        w.axis = axis, w.point_bits = bits, w.point = k;
        const auto broken = broken_condition(complex_, outer_, w);
        if (!broken) return w;
        if (*broken != SideCondition::kD3) return std::nullopt;
      }
    }
    return std::nullopt;
  }

  SideWitness of_edge(std::uint32_t edge, const DyadicInterval& arc) const {
    SideWitness w;
    const auto sides = complex_.sides(edge);
    for (const PatchSide& side : sides) {
      const bool is_same = complex_.travel(side) == complex_.travel(sides.front());
      w.arcs.push_back({side, is_same ? arc : arc.mirrored()});
      ++(is_same ? w.same : w.opposite);
    }
    return w;
  }

  const PatchComplex& complex_;
  const OuterSides& outer_;
  std::uint32_t last_ = PatchComplex::kNone;
};

}  // namespace

std::optional<SideWitness> find_side_witness(const PatchComplex& complex, const OuterSides& outer) {
  if (complex.count(PatchDefect::kWeight) != 0 || complex.count(PatchDefect::kDegree) != 0)
    return std::nullopt;
  return WitnessSearch(complex, outer).run();
}

}  // namespace veritope
