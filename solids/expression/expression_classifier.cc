// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/expression_classifier.h"

#include <algorithm>
#include <utility>

#include "robust/base/parallel.h"
#include "solids/expression/contacts.h"
#include "solids/expression/decision_diagram.h"
#include "solids/expression/directions.h"
#include "solids/expression/enclosed_walls_internal.h"

namespace veritope {
namespace {

constexpr std::size_t kChunkOfExpressionPoints = 256;
// Beyond it, operands on which the formula does not depend are not dropped: that takes time only.
constexpr std::size_t kMostDiagramNodes = 100000;

PointWord word_of(bool value) { return value ? PointWord::kIn : PointWord::kOut; }

const ExactPoint& exact_point(const ExactPoint& p) { return p; }
ExactPoint exact_point(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

}  // namespace

// What operands say of one point, each asked for once.
class ExpressionClassifier::Values {
 public:
  explicit Values(std::size_t num_operands) : places_(num_operands), known_at_(num_operands) {}

  void next_point() { ++point_; }
  template <typename ValueOf>
  Value3 of(std::uint32_t variable, ValueOf&& ask) {
    if (known_at_[variable] != point_) {
      places_[variable] = ask(variable);
      known_at_[variable] = point_;
    }
    return places_[variable].value;
  }
  // REQUIRES that it was asked for.
  const OperandPlace& place(std::uint32_t variable) const { return places_[variable]; }

 private:
  std::vector<OperandPlace> places_;
  std::vector<std::uint64_t> known_at_;
  std::uint64_t point_ = 0;
};

ExpressionClassifier::ExpressionClassifier(Formula formula,
                                           std::vector<std::shared_ptr<const Operand>> operands)
    : formula_(std::move(formula)), operands_(std::move(operands)), cells_(formula_, operands_) {}

template <typename Point>
PointWord ExpressionClassifier::classify_at(const Point& point, Values& values,
                                            OpenWord* why) const {
  values.next_point();
  const auto value_of = [&](std::uint32_t variable) {
    return values.of(variable, [&](std::uint32_t v) { return operands_[v]->place(point); });
  };
  const Formula& formula = cells_.at(point);
  const Value3 value = formula.value(value_of);
  if (is_constant(value)) return word_of(value == Value3::kOne);
  const Formula rest = formula.folded(value_of);
  return on_walls(exact_point(point), rest, values, why);
}

// POINT-6 to POINT-8: the point is on the boundaries of all operands of `rest`, or some are open.
PointWord ExpressionClassifier::on_walls(const ExactPoint& point, const Formula& rest,
                                         const Values& values, OpenWord* why) const {
  const auto open = [&](OpenWord because) {
    if (why != nullptr) *why = std::move(because);
    return PointWord::kUndecided;
  };
  const auto diagram = DecisionDiagram::make(rest, kMostDiagramNodes);
  if (diagram && diagram->is_constant())
    return word_of(diagram->value([](std::uint32_t) { return false; }));
  const std::vector<std::uint32_t> variables = diagram ? diagram->support() : rest.variables();
  if (variables.size() == 1) {
    const std::uint32_t v = variables[0];
    return values.place(v).is_open ? open({OpenWord::Reason::kPlace, {v}, {}}) : PointWord::kOn;
  }
  std::vector<TangentCone> cones;
  bool are_flat = true;
  for (const std::uint32_t v : variables) {
    std::optional<TangentCone> cone = operands_[v]->tangent_cone(point, values.place(v));
    if (!cone)
      return open(
          {values.place(v).is_open ? OpenWord::Reason::kPlace : OpenWord::Reason::kDirections,
           {v},
           {}});
    are_flat = are_flat && cone->is_flat;
    cones.push_back(std::move(*cone));
  }
  const auto f = [&](const NearbyBits& bits) {
    const auto bit_of = [&](std::uint32_t v) {
      const auto at = std::lower_bound(variables.begin(), variables.end(), v);
      return bits[static_cast<std::size_t>(at - variables.begin())];
    };
    if (diagram) return diagram->value(bit_of);
    return rest.value([&](std::uint32_t v) { return to_value(bit_of(v)); }) == Value3::kOne;
  };
  if (const auto enclosed = std::find_if(cones.begin(), cones.end(),
                                         [](const TangentCone& c) { return c.is_enclosed(); });
      enclosed != cones.end()) {
    switch (internal::values_near(cones, f)) {
      case internal::ValuesNear::kOnlyZero: return PointWord::kOut;
      case internal::ValuesNear::kOnlyOne: return PointWord::kIn;
      case internal::ValuesNear::kBoth: return PointWord::kOn;
      case internal::ValuesNear::kUnknown: break;
    }
    return open({OpenWord::Reason::kDirections,
                 {variables[static_cast<std::size_t>(enclosed - cones.begin())]},
                 {}});
  }
  const std::optional<bool> value = common_value(cones, f);
  if (!value) return PointWord::kOn;
  if (are_flat) return word_of(*value);
  std::optional<Contact> contact = find_contact(cones, f, *value);
  if (!contact) return word_of(*value);
  OpenWord out{OpenWord::Reason::kContact, {}, std::move(contact->sheets)};
  for (const std::size_t i : contact->cones) out.variables.push_back(variables[i]);
  return open(std::move(out));
}

PointWord ExpressionClassifier::classify(const Vec3d& point) const {
  Values values(operands_.size());
  return classify_at(point, values);
}

PointWord ExpressionClassifier::classify(const ExactPoint& point, OpenWord* why) const {
  Values values(operands_.size());
  return classify_at(point, values, why);
}

void ExpressionClassifier::classify(std::span<const Vec3d> points, std::span<PointWord> words,
                                    unsigned jobs, std::span<OpenWord> why) const {
  parallel_for(points.size(), kChunkOfExpressionPoints, jobs,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 Values values(operands_.size());
                 for (std::size_t i = begin; i < end; ++i)
                   words[i] = classify_at(points[i], values, why.empty() ? nullptr : &why[i]);
               });
}

Value3 ExpressionClassifier::value(const Box3d& box) const {
  return formula_.value([&](std::uint32_t v) { return operands_[v]->value(box); });
}

LookupSize ExpressionClassifier::lookup() const {
  LookupSize out{cells_.num_cells(), 0};
  for (const auto& operand : operands_) {
    const LookupSize size = operand->lookup();
    out.cells += size.cells;
    out.bytes += size.bytes;
  }
  return out;
}

}  // namespace veritope
