// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/star_box_certifier.h"

#include <algorithm>
#include <cmath>

#include "robust/base/check.h"
#include "verify/certify/natural.h"

namespace veritope {
namespace {

using certificate::Fraction;
using certificate::PatchEntity;
using certificate::StarBoxBody;
using certificate::StarBoxItem;
using Id = PieceForest::Id;

Fraction to_fraction(const Rational& v) {
  return {v.sign() == Sign::kNegative, to_natural(abs(v).numerator()), to_natural(v.denominator())};
}

class BodyWriter {
 public:
  BodyWriter(const PieceForest& forest, const StarCover& cover,
             const std::vector<StarBoxEntity>& entities)
      : forest_(forest), cover_(cover), entities_(entities) {}

  StarBoxBody write(const ShellWalks& walks) {
    for (const StarBoxEntity& e : entities_) {
      PatchEntity out;
      out.is_reversed = e.is_reversed, out.is_surface = e.is_surface;
      for (std::size_t axis = 0; axis < 2; ++axis)
        for (const Rational& b : e.breaks[axis]) out.breaks[axis].push_back(to_fraction(b));
      body_.entities.push_back(std::move(out));
    }
    write_trees();
    write_boxes();
    for (const ShellWalk& w : walks.walks)
      body_.walks.push_back({w.box, w.starts_outside, {}, w.direction, w.end_box, w.ends_outside});
    return std::move(body_);
  }

 private:
  // In the file's order: of a reversed patch the axes (of a triangle corners 1 and 2) are exchanged.
  void write_trees() {
    for (std::size_t e = 0; e < entities_.size(); ++e) {
      const std::uint32_t last = e + 1 < entities_.size()
                                     ? entities_[e + 1].first_patch
                                     : static_cast<std::uint32_t>(forest_.num_patches());
      for (std::uint32_t p = entities_[e].first_patch; p < last; ++p)
        write_patch(p, entities_[e].is_reversed);
    }
  }
  void write_patch(std::uint32_t patch, bool is_reversed) {
    const PieceForest::Form& form = forest_.form(patch);
    std::array<std::uint8_t, 2> bits{form.root_bits[0], form.root_bits[1]};
    const std::uint32_t columns = std::uint32_t{1} << bits[1];
    if (is_reversed) std::swap(bits[0], bits[1]);
    body_.roots.push_back(bits);
    for (std::uint32_t i = 0; i < std::uint32_t{1} << bits[0]; ++i)
      for (std::uint32_t j = 0; j < std::uint32_t{1} << bits[1]; ++j)
        write_node(form.first_root + (is_reversed ? j * columns + i : i * columns + j),
                   is_reversed);
  }
  void write_node(Id id, bool is_reversed) {
    const std::uint32_t box = cover_.box_of_node[id];
    if (box != StarCover::kNone) {
      body_.trees.push_back(box);
      return;
    }
    body_.trees.push_back(certificate::kSplit);
    const Id first = forest_.node(id).first_child;
    for (const Id k : {0u, 1u, 2u, 3u})
      write_node(first + (is_reversed && (k == 1 || k == 2) ? 3 - k : k), is_reversed);
  }

  // One unit for all axes, of which a frame may have three.
  void write_boxes() {
    const auto& scale = forest_.frame().scale;
    const int finest = *std::max_element(scale.begin(), scale.end());
    int least = 0;
    for (const CoverBox& b : cover_.boxes) least = std::min(least, std::ilogb(b.unit));
    body_.exponent = least - finest;
    for (const CoverBox& b : cover_.boxes) {
      StarBoxItem item;
      item.is_mesh = b.is_mesh;
      const int unit = std::ilogb(b.unit);
      item.shift = static_cast<std::uint64_t>(unit - least);
      for (std::size_t k = 0; k < 3; ++k) {
        const double lo = b.star.box.lo[k];
        const Rational low = forest_.in_model(k, lo) * Rational::power_of_two(finest - unit);
        VT_CHECK(low.denominator() == Integer(1), "a box beside its grid");
        item.low[k] = low.numerator().to_int64();
        const auto steps = [&](double to) {  // multiples of the unit, less than 2^53 of them: exact
          return static_cast<std::uint64_t>((to - lo) / b.unit) << (finest - scale[k]);
        };
        item.size[k] = steps(b.star.box.hi[k]);
        if (b.is_mesh) continue;
        item.inside[k] = steps(b.star.inside[k]);
        item.outside[k] = steps(b.star.outside[k]);
      }
      body_.boxes.push_back(item);
    }
  }

  const PieceForest& forest_;
  const StarCover& cover_;
  const std::vector<StarBoxEntity>& entities_;
  StarBoxBody body_;
};

}  // namespace

bool fits_certificate(const PieceForest& forest, const StarCover& cover) {
  constexpr std::int64_t kMostBits =
      60;  // the C++ checker's 61, less one for the sum of corner and size
  const auto& scale = forest.frame().scale;
  int least = 0;
  for (const CoverBox& b : cover.boxes) least = std::min(least, std::ilogb(b.unit));
  const Rational units =
      Rational::power_of_two(*std::max_element(scale.begin(), scale.end()) - least);
  for (std::size_t k = 0; k < 3; ++k) {
    // Boxes reach to 8 at most, in the frame: see BoxSearch.
    const Rational reach = abs(forest.frame().shift[k]) + Rational::power_of_two(3 - scale[k]);
    if (Rational::power_of_two(kMostBits) < reach * units) return false;
  }
  return true;
}

certificate::Bytes make_star_box_certificate(const PieceForest& forest, const StarCover& cover,
                                             const ShellWalks& walks,
                                             const std::vector<StarBoxEntity>& entities,
                                             const certificate::Subject& subject) {
  VT_CHECK(cover.is_complete() && walks.missing.empty(),
           "a certificate needs a whole cover and all walks");
  for (const ShellWalk& w : walks.walks)
    VT_CHECK(w.winding_inside == 1, "winding numbers of a solid are 0 and 1");
  certificate::StarBoxQuantities q;
  const PatchComplex& complex = forest.complex();
  q.patches = complex.patches().size();
  q.edges = complex.num_edges();
  q.vertices = complex.num_vertices();
  q.shells = complex.shells().size();
  for (const PatchShell& shell : complex.shells())
    q.genus += static_cast<std::uint64_t>(shell.genus().value());
  q.bodies = walks.num_bodies();
  return certificate::encode(subject, q, BodyWriter(forest, cover, entities).write(walks));
}

}  // namespace veritope
