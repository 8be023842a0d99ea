// SPDX-License-Identifier: LGPL-3.0-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>

#include "bench/patch_side_peers.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope::bench {
namespace {

constexpr double kTolerance = 1e-7;  // Open CASCADE's own

Handle(Geom_BezierSurface) converted(const Patch& patch) {
  const Patch::Tensor map =
      patch.is_triangle() ? as_tensor_product(patch.triangle()) : patch.tensor();
  const int p = map.degree(0), q = map.degree(1);
  TColgp_Array2OfPnt poles(1, p + 1, 1, q + 1);
  TColStd_Array2OfReal weights(1, p + 1, 1, q + 1);
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j) {
      const auto k = static_cast<std::size_t>(i * (q + 1) + j);
      const Rational w = map.is_rational() ? map.component(3)[k] : Rational(1);
      const auto at = [&](int c) { return nearest_double(map.component(c)[k] / w); };
      poles.SetValue(i + 1, j + 1, gp_Pnt(at(0), at(1), at(2)));
      weights.SetValue(i + 1, j + 1, nearest_double(w));
    }
  return new Geom_BezierSurface(poles, weights);
}

}  // namespace

struct OcctSides::Impl {
  TopoDS_Solid solid;
  bool is_closed = false;
  BRepClass3d_SolidClassifier classifier;
};

OcctSides::OcctSides(std::span<const Patch> patches) : impl_(new Impl) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const Patch& p : patches)
    sewing.Add(BRepBuilderAPI_MakeFace(converted(p), kTolerance).Face());
  sewing.Perform();
  BRepBuilderAPI_MakeSolid solid;
  for (TopExp_Explorer e(sewing.SewedShape(), TopAbs_SHELL); e.More(); e.Next()) {
    solid.Add(TopoDS::Shell(e.Current()));
    impl_->is_closed = e.Current().Closed();
  }
  if (!solid.IsDone()) return;
  impl_->solid = solid.Solid();
  impl_->classifier.Load(impl_->solid);
}
OcctSides::~OcctSides() = default;

bool OcctSides::is_closed() const { return impl_->is_closed; }

Side OcctSides::operator()(const Vec3d& p) const {
  impl_->classifier.Perform(gp_Pnt(p.x, p.y, p.z), kTolerance);
  switch (impl_->classifier.State()) {
    case TopAbs_IN: return Side::kIn;
    case TopAbs_ON: return Side::kOn;
    default: return Side::kOut;
  }
}

}  // namespace veritope::bench
