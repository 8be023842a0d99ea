// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/nef_solid.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include <algorithm>
#include <string>
#include <vector>

namespace veritope::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// Nine decimal digits at a time.
Kernel::FT number_of(const std::string& digits) {
  const bool is_negative = digits[0] == '-';
  Kernel::FT out(0);
  for (std::size_t i = is_negative ? 1 : 0; i < digits.size(); i += 9) {
    const std::string part = digits.substr(i, 9);
    out = out * Kernel::FT(std::stod("1e" + std::to_string(part.size()))) +
          Kernel::FT(std::stod(part));
  }
  return is_negative ? Kernel::FT(-out) : out;
}

Kernel::FT number_of(const Rational& x) {
  return number_of(x.numerator().to_string()) / number_of(x.denominator().to_string());
}

class MeshBuilder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  MeshBuilder(const std::vector<Kernel::Point_3>& points,
              const std::vector<std::array<std::uint32_t, 3>>& faces)
      : points_(points), faces_(faces) {}
  void operator()(Polyhedron::HalfedgeDS& out) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(out, true);
    builder.begin_surface(points_.size(), faces_.size());
    for (const auto& p : points_) builder.add_vertex(p);
    for (const auto& f : faces_) builder.add_facet(f.begin(), f.end());
    builder.end_surface();
  }

 private:
  const std::vector<Kernel::Point_3>& points_;
  const std::vector<std::array<std::uint32_t, 3>>& faces_;
};

Nef nef_of(const std::vector<Kernel::Point_3>& points,
           const std::vector<std::array<std::uint32_t, 3>>& faces) {
  Polyhedron polyhedron;
  MeshBuilder builder(points, faces);
  polyhedron.delegate(builder);
  return Nef(polyhedron);
}

Nef nef_of(const ExactBox<3>& box) {
  std::vector<Kernel::Point_3> points;
  for (unsigned i = 0; i < 8; ++i) {
    const auto at = [&](unsigned k) {
      return number_of((i >> k & 1u) != 0 ? box[k].hi : box[k].lo);
    };
    points.emplace_back(at(0), at(1), at(2));
  }
  return nef_of(points, {{0, 2, 3},
                         {0, 3, 1},
                         {4, 5, 7},
                         {4, 7, 6},
                         {0, 1, 5},
                         {0, 5, 4},
                         {1, 3, 7},
                         {1, 7, 5},
                         {3, 2, 6},
                         {3, 6, 7},
                         {2, 0, 4},
                         {2, 4, 6}});
}

Nef nef_of(const TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3d& p : mesh.positions) points.emplace_back(p.x, p.y, p.z);
  return nef_of(points, mesh.faces);
}

}  // namespace

struct NefSolid::Impl {
  Nef nef;
};

NefSolid::NefSolid(const TriangleMesh& mesh)
    : impl_(std::make_shared<const Impl>(Impl{nef_of(mesh)})) {}
NefSolid::NefSolid(const ExactBox<3>& box)
    : impl_(std::make_shared<const Impl>(Impl{nef_of(box)})) {}

NefSolid NefSolid::united(const NefSolid& other) const {
  return NefSolid(std::make_shared<const Impl>(Impl{impl_->nef + other.impl_->nef}));
}
NefSolid NefSolid::intersected(const NefSolid& other) const {
  return NefSolid(std::make_shared<const Impl>(Impl{impl_->nef * other.impl_->nef}));
}
NefSolid NefSolid::without(const NefSolid& other) const {
  return NefSolid(std::make_shared<const Impl>(Impl{impl_->nef - other.impl_->nef}));
}
NefSolid NefSolid::regularized() const {
  return NefSolid(std::make_shared<const Impl>(Impl{impl_->nef.regularization()}));
}

Side NefSolid::side(const ExactPoint& point) const {
  const Kernel::Point_3 p(number_of(point[0]), number_of(point[1]), number_of(point[2]));
  const Nef::Object_handle found = const_cast<Nef&>(impl_->nef).locate(p);
  Nef::Volume_const_handle volume;
  if (!CGAL::assign(volume, found)) return Side::kOn;
  return volume->mark() ? Side::kIn : Side::kOut;
}

}  // namespace veritope::bench
