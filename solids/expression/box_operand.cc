// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/check.h"
#include "solids/expression/operand.h"

namespace veritope {
namespace {

class BoxOperand : public Operand {
 public:
  explicit BoxOperand(ExactBox<3> box) : box_(std::move(box)) {
    for (std::size_t k = 0; k < 3; ++k) {
      VT_CHECK(box_[k].lo < box_[k].hi, "a box without an interior");
      within_.lo[k] = round_up(box_[k].lo);
      within_.hi[k] = round_down(box_[k].hi);
      around_.lo[k] = round_down(box_[k].lo);
      around_.hi[k] = round_up(box_[k].hi);
    }
  }

  OperandPlace place(const Vec3d& point) const override { return OperandPlace::with(value(point)); }
  OperandPlace place(const ExactPoint& point) const override {
    return OperandPlace::with(value(point));
  }
  // Roundings are monotone: binary64 numbers compare with a bound as with its rounding to their side.
  Value3 value(const Vec3d& point) const override {
    const Point3d p = to_point(point);
    if (!is_inside({p, p}, within_)) return Value3::kZero;
    return value(ExactPoint{Rational::from_double(p[0]), Rational::from_double(p[1]),
                            Rational::from_double(p[2])});
  }
  Value3 value(const ExactPoint& point) const override {
    Value3 out = Value3::kOne;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!box_[k].contains(point[k])) return Value3::kZero;
      if (point[k] == box_[k].lo || point[k] == box_[k].hi) out = Value3::kMixed;
    }
    return out;
  }
  Value3 value(const Box3d& box) const override {
    if (!meets(box, within_)) return Value3::kZero;
    for (std::size_t k = 0; k < 3; ++k)
      if (Rational::from_double(box.lo[k]) <= box_[k].lo ||
          box_[k].hi <= Rational::from_double(box.hi[k]))
        return Value3::kMixed;
    return Value3::kOne;
  }
  std::optional<TangentCone> tangent_cone(const ExactPoint& point,
                                          const OperandPlace&) const override {
    return flat_tangent_cone(flat_cone(box_, point));
  }
  ExactBox<3> box() const override { return box_; }

 private:
  const ExactBox<3> box_;
  Box3d within_, around_;
};

}  // namespace

std::unique_ptr<const Operand> box_operand(const ExactBox<3>& box) {
  return std::make_unique<const BoxOperand>(box);
}

}  // namespace veritope
