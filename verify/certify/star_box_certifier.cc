// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/star_box_certifier.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>

#include "robust/base/check.h"
#include "verify/certify/file_order.h"

namespace veritope {
namespace {

using certificate::StarBoxBody;
using certificate::StarBoxItem;
using Id = PieceForest::Id;

// A box is a multiple of its unit in the frame. In the model's coordinates, times 2^(the frame's finest scale), it is a
// multiple of 2^(the result).
int grid_exponent(const PieceForest& forest, const CoverBox& box) {
  if (box.framed)  // the frame is plain
    return std::min(std::ilogb(box.framed->unit), std::ilogb(box.framed->centre_unit));
  const PieceForest::Frame& frame = forest.frame();
  const int finest = *std::max_element(frame.scale.begin(), frame.scale.end());
  int out = std::ilogb(box.unit);
  for (const Rational& shift : frame.shift) {
    if (shift.sign() == Sign::kZero) continue;
    const auto below = static_cast<int>(shift.denominator().bit_length()) - 1;  // a power of two
    const int bits = below > 0 ? -below : static_cast<int>(shift.numerator().trailing_zeros());
    out = std::min(out, bits + finest);
  }
  return out;
}

// The greatest coordinate of a box, or of the plain box around one in a frame, on the axis.
double farthest(const CoverBox& b, std::size_t k) {
  return std::max(std::abs(b.star.box.lo[k]), std::abs(b.star.box.hi[k]));
}

constexpr int kMostGridBits = 60;  // the C++ checker's 61, minus one for the sum of corner and size
constexpr int kMostShift = 120;    // the C++ checker's limit for boxes in frames

// Whether the C++ checker reads the box, which it holds in the box's own unit. 2^least is the certificate's unit.
bool fits_checker(const FramedBox& b, int least) {
  if (std::ilogb(b.unit) - least > kMostShift) return false;
  const Box3d& box = b.sheets.box;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::max(std::abs(box.lo[k]), std::abs(box.hi[k])) > std::ldexp(b.unit, kMostGridBits))
      return false;
  return true;
}

class StarBoxBodyWriter {
 public:
  StarBoxBodyWriter(const PieceForest& forest, const StarCover& cover,
                    const std::vector<StarBoxEntity>& entities, int most_exponent)
      : forest_(forest), cover_(cover), entities_(entities), most_exponent_(most_exponent) {}

  StarBoxBody write(const ShellWalks& walks) {
    body_.entities = to_certificate(entities_);
    write_trees();
    write_boxes();
    for (const ShellWalk& w : walks.walks)
      body_.walks.push_back(
          {w.box, w.starts_outside, {{}, w.direction, w.end_box, w.ends_outside}});
    return std::move(body_);
  }

 private:
  // In the file's order: of a reversed patch the axes (of a triangle corners 1 and 2) are exchanged.
  void write_trees() {
    const std::vector<bool> is_reversed = reversed_patches(entities_, forest_.num_patches());
    for (std::uint32_t p = 0; p < forest_.num_patches(); ++p)
      FileOrder(forest_).for_each_root(
          p, is_reversed[p], [&](const auto& bits) { body_.roots.push_back(bits); },
          [&](Id root) { write_node(root, is_reversed[p]); });
  }
  void write_node(Id id, bool is_reversed) {
    const std::uint32_t box = cover_.box_of_node[id];
    if (box != StarCover::kNone) {
      body_.trees.push_back(box);
      return;
    }
    body_.trees.push_back(certificate::kSplit);
    FileOrder(forest_).for_each_child(id, is_reversed,
                                      [&](Id child) { write_node(child, is_reversed); });
  }

  // One unit for all axes, of which a frame may have three.
  void write_boxes() {
    const auto& scale = forest_.frame().scale;
    const int finest = *std::max_element(scale.begin(), scale.end());
    int least = most_exponent_;
    for (const CoverBox& b : cover_.boxes) least = std::min(least, grid_exponent(forest_, b));
    body_.exponent = least - finest;
    for (const CoverBox& b : cover_.boxes) {
      if (b.framed) {
        body_.version = 2;
        body_.boxes.push_back(framed_item(*b.framed, least));
        continue;
      }
      if (b.needs_version_2) body_.version = 2;
      StarBoxItem item;
      item.is_mesh = b.is_mesh;
      const int unit = grid_exponent(forest_, b), spare = std::ilogb(b.unit) - unit;
      item.shift = item.point_shift = static_cast<std::uint64_t>(unit - least);
      if (!b.is_mesh) item.sheets.resize(1);
      for (std::size_t k = 0; k < 3; ++k) {
        const double lo = b.star.box.lo[k];
        const Rational low = forest_.in_model(k, lo) * Rational::power_of_two(finest - unit);
        VT_CHECK(low.denominator() == Integer(1), "a box beside its grid");
        item.low[k] = low.numerator().to_int64();
        const auto steps = [&](double to) {  // multiples of the unit, less than 2^53 of them: exact
          return static_cast<std::uint64_t>((to - lo) / b.unit) << (finest - scale[k] + spare);
        };
        item.size[k] = steps(b.star.box.hi[k]);
        if (b.is_mesh) continue;
        const auto place = [&](double to) {
          return static_cast<std::int64_t>(static_cast<std::uint64_t>(item.low[k]) + steps(to));
        };
        item.sheets[0].inside[k] = place(b.star.inside[k]);
        item.sheets[0].outside[k] = place(b.star.outside[k]);
      }
      body_.boxes.push_back(item);
    }
  }

  // REQUIRES that the forest's own frame is plain: then the model's coordinates are the forest's times one power of
  // two. 2^least is the unit.
  StarBoxItem framed_item(const FramedBox& framed, int least) {
    const SheetBox& box = framed.sheets;
    StarBoxItem item;
    item.frame = frame_number(box.frame);
    item.shift = static_cast<std::uint64_t>(std::ilogb(framed.unit) - least);
    item.point_shift = static_cast<std::uint64_t>(std::ilogb(framed.centre_unit) - least);
    for (std::size_t k = 0; k < 3; ++k) {
      item.low[k] = multiple(box.box.lo[k], framed.unit);
      item.size[k] = static_cast<std::uint64_t>(multiple(box.box.hi[k], framed.unit) - item.low[k]);
    }
    for (const Sheet& sheet : box.sheets) {
      certificate::StarSheet& out = item.sheets.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        out.inside[k] = multiple(sheet.inside[k], framed.centre_unit);
        out.outside[k] = multiple(sheet.outside[k], framed.centre_unit);
      }
      for (const Sign s : sheet.signs)
        out.signs.push_back(s == Sign::kZero ? 0 : s == Sign::kPositive ? 1 : 2);
    }
    for (const SheetSeparator& q : box.separators) {
      VT_CHECK(q.origin == box.sheets.front().inside, "a separator with an origin of its own");
      item.separators.push_back({static_cast<std::uint8_t>(q.degree),
                                 std::ilogb(q.unit) - std::ilogb(framed.centre_unit),
                                 q.coefficients});
    }
    return item;
  }
  static std::int64_t multiple(double v, double unit) {
    const double out = v / unit;  // exact: unit is a power of two
    VT_CHECK(out == std::nearbyint(out) && std::abs(out) < 0x1p62, "a coordinate beside its grid");
    return static_cast<std::int64_t>(out);
  }
  // 0: the unit matrix.
  std::uint64_t frame_number(const BoxFrame& frame) {
    if (frame.is_plain()) return 0;
    const auto [at, is_new] = frame_numbers_.try_emplace(frame.rows(), body_.frames.size() + 1);
    if (is_new) body_.frames.push_back({frame.rows()});
    return at->second;
  }

  const PieceForest& forest_;
  const StarCover& cover_;
  const std::vector<StarBoxEntity>& entities_;
  int most_exponent_;
  std::map<BoxFrame::Rows, std::uint64_t> frame_numbers_;
  StarBoxBody body_;
};

}  // namespace

double least_unit_that_fits(const PieceForest& forest) {
  const auto& scale = forest.frame().scale;
  int most = std::numeric_limits<int>::min();  // 2^most exceeds the boxes' coordinates in the model
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational reach =
        abs(forest.frame().shift[k]) + Rational(4) * Rational::power_of_two(-scale[k]);
    most = std::max(most, static_cast<int>(reach.numerator().bit_length()) -
                              static_cast<int>(reach.denominator().bit_length()) + 1);
  }
  return std::ldexp(1.0, most - kMostGridBits + *std::max_element(scale.begin(), scale.end()));
}

double least_unit_of_any(const PieceForest& forest) {
  const PatchComplex& complex = forest.complex();
  std::optional<int> most;  // 2^most is at most the greatest coordinate of a corner, in the model
  for (const Patch& patch : complex.patches())
    for (std::uint32_t c = 0; c < patch.num_sides(); ++c) {
      const std::vector<Rational> x = patch.corner(c);
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational at = abs(patch.is_rational() ? x[k] / x[3] : x[k]);
        if (at.sign() == Sign::kZero) continue;
        const int below = static_cast<int>(at.numerator().bit_length()) -
                          static_cast<int>(at.denominator().bit_length()) - 1;
        most = most ? std::max(*most, below) : below;
      }
    }
  const auto& scale = forest.frame().scale;
  return most ? std::ldexp(1.0,
                           *most - kMostGridBits + *std::max_element(scale.begin(), scale.end()))
              : 0;
}

double least_unit_of_boxes(const PieceForest& forest, const StarCover& cover, double most) {
  int least = std::ilogb(most);
  for (const CoverBox& b : cover.boxes) least = std::min(least, grid_exponent(forest, b));
  return std::ldexp(1.0, least);
}

bool fits_certificate(const PieceForest& forest, const StarCover& cover) {
  const auto& scale = forest.frame().scale;
  constexpr int kMostExponent = 4096 - 64;  // a collar's unit may be less than that of all boxes
  int least = 0;
  for (const CoverBox& b : cover.boxes) least = std::min(least, grid_exponent(forest, b));
  for (const CoverBox& b : cover.boxes)
    if (b.framed && !fits_checker(*b.framed, least)) return false;
  const int steps = *std::max_element(scale.begin(), scale.end()) - least;
  if (std::abs(steps) > kMostExponent) return false;
  const Rational units = Rational::power_of_two(steps);
  for (std::size_t k = 0; k < 3; ++k) {
    double most = 0;  // the greatest of the boxes' coordinates in the frame
    for (const CoverBox& b : cover.boxes) most = std::max(most, farthest(b, k));
    const Rational reach = abs(forest.frame().shift[k]) +
                           Rational::from_double(most) * Rational::power_of_two(-scale[k]);
    if (Rational::power_of_two(kMostGridBits) < reach * units) return false;
  }
  return true;
}

certificate::StarBoxBody make_star_box_body(const PieceForest& forest, const StarCover& cover,
                                            const ShellWalks& walks,
                                            const std::vector<StarBoxEntity>& entities,
                                            int most_exponent) {
  VT_CHECK(cover.is_complete() && walks.missing.empty(),
           "a certificate needs a whole cover and all walks");
  const int last = walks.walks.back().winding_inside;
  for (const ShellWalk& w : walks.walks)
    VT_CHECK(last != 1 || w.winding_inside == 1, "winding numbers of a solid are 0 and 1");
  return StarBoxBodyWriter(forest, cover, entities, most_exponent).write(walks);
}

certificate::StarBoxBody make_star_box_2_body(const PieceForest& forest, const StarCover& cover,
                                              const ShellWalks& walks,
                                              const std::vector<StarBoxEntity>& entities) {
  certificate::StarBoxBody out = make_star_box_body(forest, cover, walks, entities, 0);
  out.version = 2;
  return out;
}

certificate::StarBoxQuantities star_box_quantities(const PatchComplex& complex,
                                                   const ShellWalks& walks) {
  certificate::StarBoxQuantities q;
  q.patches = complex.patches().size();
  q.edges = complex.num_edges();
  q.vertices = complex.num_vertices();
  q.shells = complex.shells().size();
  for (const PatchShell& shell : complex.shells())
    q.genus += static_cast<std::uint64_t>(shell.genus().value());
  if (walks.walks.back().winding_inside == 1) q.bodies = walks.num_bodies();
  return q;
}

certificate::Bytes make_star_box_certificate(const PieceForest& forest, const StarCover& cover,
                                             const ShellWalks& walks,
                                             const std::vector<StarBoxEntity>& entities,
                                             const certificate::Subject& subject) {
  const certificate::StarBoxQuantities q = star_box_quantities(forest.complex(), walks);
  const certificate::StarBoxBody body = make_star_box_body(forest, cover, walks, entities, 0);
  const int last = walks.walks.back().winding_inside;
  return last == 1 ? certificate::encode(subject, q, body)
                   : certificate::encode(subject, q, body, last);
}

}  // namespace veritope
