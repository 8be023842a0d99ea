// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/expression_classifier.h: is a point in, on or out of a Boolean expression of solids? Exactly, also
// where the boundaries of several of them meet.  Theory: docs/THEORY.md, POINT-6 to POINT-8.  Design:
// docs/design/0057-expressions-of-meshes.md.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solids/expression/formula_cells.h"
#include "solids/expression/operand.h"

namespace veritope {

/// With respect to the closure of the interior of a set. Undecided: see OpenWord.
enum class PointWord : std::uint8_t { kIn, kOn, kOut, kUndecided };

/// Why a word is undecided.
struct OpenWord {
  enum class Reason : std::uint8_t {
    kPlace,  ///< it is not decided whether the point is on the boundary of a solid, or where
    kDirections,  ///< the tangents of a boundary at the point are not known, or none: an apex, an irrational place
    kContact,  ///< curved boundaries leave the point in one direction, and are neither equal nor abut in one curve
  };
  Reason reason = Reason::kPlace;
  std::vector<std::uint32_t> variables;  ///< one, or those in contact
  std::vector<std::uint32_t> faces;      ///< of a contact: the number of a patch or facet of each
};

/// Answers for points with respect to R = closure(int F), where F is a formula of solids: in the interior of R, off R,
/// or on the boundary of R. Immutable: threads may share it.
class ExpressionClassifier {
 public:
  /// @param operands  those that the variables of the formula name; equal solids should be one variable, so that A - A
  ///                  is known to be empty without a look at points
  ExpressionClassifier(Formula formula, std::vector<std::shared_ptr<const Operand>> operands);

  /// REQUIRES finite coordinates.
  PointWord classify(const Vec3d& point) const;
  /// @param why  set if the word is undecided
  PointWord classify(const ExactPoint& point, OpenWord* why = nullptr) const;
  /// All at once, by `jobs` threads; the answers do not depend on their number. REQUIRES equal sizes; `why` may be
  /// empty.
  void classify(std::span<const Vec3d> points, std::span<PointWord> words, unsigned jobs,
                std::span<OpenWord> why = {}) const;

  /// The value of R on a closed box. Mixed also where only the values of single operands are: x and not x.
  Value3 value(const Box3d& box) const;

  const Formula& formula() const { return formula_; }
  LookupSize lookup() const;

 private:
  class Values;
  template <typename Point>
  PointWord classify_at(const Point& point, Values& values, OpenWord* why = nullptr) const;
  PointWord on_walls(const ExactPoint& point, const Formula& rest, const Values& values,
                     OpenWord* why) const;

  Formula formula_;
  std::vector<std::shared_ptr<const Operand>> operands_;
  FormulaCells cells_;
};

}  // namespace veritope
