// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/cage_content.h"

#include <algorithm>
#include <map>
#include <utility>

#include "robust/base/check.h"
#include "solids/micro/cage/short_numbers_internal.h"
#include "solids/volumes/half_angle.h"
#include "splines/bezier_triangle_algebra.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

constexpr int kRoundsOfWholeTriangles = 2;

// The content, point after point.
class ContentBuilder {
 public:
  void add_corner(const CellPoint& p) {
    const auto [at, is_new] =
        numbers_.try_emplace(p, static_cast<std::uint32_t>(content_.points.size()));
    if (is_new) content_.points.push_back(p);
    content_.corners.push_back(at->second);
  }
  void end_part() { content_.ends.push_back(content_.corners.size()); }
  CageContent take() { return std::move(content_); }

 private:
  CageContent content_;
  std::map<CellPoint, std::uint32_t> numbers_;
};

// Control points of a map, by its components.
template <typename Map>
void add_hull(const Map& map, bool is_rational, ContentBuilder& to) {
  for (std::size_t i = 0; i < map.component(0).size(); ++i) {
    CellPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = map.component(static_cast<int>(k))[i];
      if (is_rational) p[k] /= map.component(3)[i];
    }
    to.add_corner(p);
  }
  to.end_part();
}

void add_cut(const Patch::Tensor& map, int rounds, ContentBuilder& to) {
  std::vector<Patch::Tensor> parts{map};
  for (int i = 0; i < 2 * rounds; ++i) {
    const std::size_t axis = i % 2 == 0 ? 0 : 1;
    std::vector<Patch::Tensor> halves;
    for (const Patch::Tensor& part : parts) {
      auto [first, second] = split(part, axis, Rational(1) / Rational(2));
      halves.push_back(std::move(first));
      halves.push_back(std::move(second));
    }
    parts = std::move(halves);
  }
  for (const Patch::Tensor& part : parts) add_hull(part, part.is_rational(), to);
}

}  // namespace

CageContent content_of(const TriangleMesh& mesh) {
  ContentBuilder out;
  for (const auto& face : mesh.faces) {
    for (const std::uint32_t v : face) {
      const Vec3d& p = mesh.positions[v];
      out.add_corner(
          {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)});
    }
    out.end_part();
  }
  return out.take();
}

CageContent content_of(std::span<const Patch> patches, int rounds) {
  ContentBuilder out;
  for (const Patch& patch : patches) {
    if (!patch.is_triangle())
      add_cut(patch.tensor(), rounds, out);
    else if (rounds <= kRoundsOfWholeTriangles)
      add_hull(patch, patch.is_rational(), out);
    else
      add_cut(as_tensor_product(patch.triangle()), rounds, out);
  }
  return out.take();
}

std::size_t num_content_parts(const Patch& patch, int rounds) {
  if (patch.is_triangle() && rounds <= kRoundsOfWholeTriangles) return 1;
  return std::size_t{1} << 2 * rounds;
}

CageBox box_of(const CageContent& content) {
  VT_CHECK(!content.points.empty(), "a box needs a point");
  CageBox box{content.points.front(), content.points.front()};
  for (const CellPoint& p : content.points)
    for (std::size_t k = 0; k < 3; ++k) {
      box.min[k] = std::min(box.min[k], p[k]);
      box.max[k] = std::max(box.max[k], p[k]);
    }
  return box;
}

Rational margin_length(const CageBox& box, const Rational& part) {
  Rational square;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational side = box.max[k] - box.min[k];
    square += side * side;
  }
  if (square.sign() == Sign::kZero) return {};
  return internal::short_above(internal::square_root_range(square).hi * part);
}

CageBox grown(const CageBox& box, const Rational& length) {
  CageBox out = box;
  for (std::size_t k = 0; k < 3; ++k) {
    out.min[k] -= length;
    out.max[k] += length;
  }
  return out;
}

}  // namespace veritope
