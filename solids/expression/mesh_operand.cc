// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/operand.h"

namespace veritope {
namespace {

class MeshOperand : public Operand {
 public:
  explicit MeshOperand(TriangleMesh mesh)
      : mesh_(std::move(mesh)), classifier_(std::move(MeshClassifier::make(mesh_).value())) {}

  OperandPlace place(const Vec3d& point) const override { return OperandPlace::with(value(point)); }
  OperandPlace place(const ExactPoint& point) const override {
    return OperandPlace::with(value(point));
  }
  Value3 value(const Vec3d& point) const override { return value_of(classifier_.classify(point)); }
  Value3 value(const ExactPoint& point) const override {
    return value_of(classifier_.classify(point));
  }
  Value3 value(const Box3d& box) const override { return classifier_.value(box); }
  std::optional<TangentCone> tangent_cone(const ExactPoint& point,
                                          const OperandPlace&) const override {
    const std::vector<std::uint32_t> facets = classifier_.facets_at(point);
    TangentCone out = flat_tangent_cone(flat_cone(mesh_, facets, point));
    for (std::size_t i = 0; i < facets.size(); ++i) out.sheets[i].number = facets[i];
    return out;
  }
  ExactBox<3> box() const override {
    ExactBox<3> out;
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = {Rational::from_double(classifier_.box().lo[k]),
                Rational::from_double(classifier_.box().hi[k])};
    return out;
  }
  LookupSize lookup() const override { return classifier_.lookup(); }
  OperandParts parts() const override { return {&mesh_, &classifier_, nullptr, nullptr}; }

 private:
  static Value3 value_of(const PointAnswer& a) {
    return a.is_on() ? Value3::kMixed : to_value(a.winding != 0);
  }

  const TriangleMesh mesh_;
  const MeshClassifier classifier_;
};

}  // namespace

std::unique_ptr<const Operand> mesh_operand(TriangleMesh mesh) {
  return std::make_unique<const MeshOperand>(std::move(mesh));
}

}  // namespace veritope
