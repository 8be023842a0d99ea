// SPDX-License-Identifier: LGPL-3.0-or-later
// render/solid_probe.h: the two questions that pictures of solids ask: about a point, and about a box.
#pragma once
#include "solids/expression/expression_classifier.h"

namespace veritope {

/// A solid R, which is the closure of its interior. Immutable: threads may share it.
class SolidProbe {
 public:
  virtual ~SolidProbe() = default;

  /// REQUIRES finite coordinates.
  virtual PointWord word(const Vec3d& point) const = 0;
  virtual PointWord word(const ExactPoint& point) const = 0;
  /// 0 or 1 if all points of the closed box are off R, or all are in its interior; else mixed, also where that is not
  /// known. REQUIRES a finite box that is not empty.
  virtual Value3 value(const Box3d& box) const = 0;
  /// Whether smaller and smaller boxes are mixed at the boundary of R only. Not so for expressions: their walls are not
  /// all part of the boundary of the result.
  virtual bool has_own_walls() const { return false; }
};

/// The solid of an expression, or of one operand.
class ExpressionProbe : public SolidProbe {
 public:
  /// Keeps a reference.
  explicit ExpressionProbe(const ExpressionClassifier& classifier) : classifier_(classifier) {}
  PointWord word(const Vec3d& point) const override { return classifier_.classify(point); }
  PointWord word(const ExactPoint& point) const override { return classifier_.classify(point); }
  Value3 value(const Box3d& box) const override { return classifier_.value(box); }
  bool has_own_walls() const override { return classifier_.formula().num_literals() == 1; }

 private:
  const ExpressionClassifier& classifier_;
};

}  // namespace veritope
