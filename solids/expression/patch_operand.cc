// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/operand.h"
#include "solids/expression/patch_cone.h"

namespace veritope {
namespace {

class PatchOperand : public Operand {
 public:
  explicit PatchOperand(std::unique_ptr<const PatchComplex> patches)
      : patches_(std::move(patches)),
        classifier_(PatchClassifier::of_valid_model(*patches_)),
        cones_(*patches_) {}

  OperandPlace place(const Vec3d& point) const override { return ask(point); }
  OperandPlace place(const ExactPoint& point) const override { return ask(point); }
  Value3 value(const Vec3d& point) const override { return value_of(classifier_.classify(point)); }
  Value3 value(const ExactPoint& point) const override {
    return value_of(classifier_.classify(point));
  }
  Value3 value(const Box3d& box) const override { return classifier_.value(box); }
  std::optional<TangentCone> tangent_cone(const ExactPoint&,
                                          const OperandPlace& place) const override {
    if (!place.on_patch) return std::nullopt;
    std::optional<TangentCone> cone = cones_.at(*place.on_patch);
    if (cone)
      cone->place_of = [this](const Patch& patch, const ExactPoint& p) {
        return place_of(patch, p);
      };
    return cone;
  }
  ExactBox<3> box() const override {
    const Box3d box = classifier_.box();
    ExactBox<3> out;
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = {Rational::from_double(box.lo[k]), Rational::from_double(box.hi[k])};
    return out;
  }
  LookupSize lookup() const override { return classifier_.lookup(); }
  OperandParts parts() const override { return {nullptr, nullptr, patches_.get(), &classifier_}; }

 private:
  template <typename Point>
  OperandPlace ask(const Point& point) const {
    OperandPlace out;
    const PointAnswer answer = classifier_.classify(point, &out.on_patch);
    out.value = value_of(answer);
    out.is_open = !answer.is_decided;
    return out;
  }
  std::optional<std::array<Rational, 2>> place_of(const Patch& patch, const ExactPoint& p) const {
    std::optional<OnPatch> where;
    classifier_.classify(p, &where);
    if (!where || &patches_->patch(where->patch) != &patch) return std::nullopt;
    return domain_place(patch, where->parameters);
  }
  static Value3 value_of(const PointAnswer& a) {
    return !a.is_decided || a.is_on() ? Value3::kMixed : to_value(a.winding != 0);
  }

  const std::unique_ptr<const PatchComplex> patches_;
  const PatchClassifier classifier_;
  const PatchCones cones_;
};

}  // namespace

std::unique_ptr<const Operand> patch_operand(std::unique_ptr<const PatchComplex> patches) {
  return std::make_unique<const PatchOperand>(std::move(patches));
}

}  // namespace veritope
