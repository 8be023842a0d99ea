// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/associated_function.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "robust/base/fp_guard.h"
#include "solids/chain/germ_sum_internal.h"

namespace veritope {
namespace {

// The values of cells at one point, each computed once.
template <std::size_t Dim>
class CellValues {
 public:
  explicit CellValues(const ChainPoint<Dim>& q) : q_(q) {}

  // The value of the intersection; nothing if the point is on a curved wall and no other factor is 0.
  std::optional<Integer> value(const std::vector<CellPointer<Dim>>& cells) {
    Integer out(1);
    bool is_open = false;
    for (const CellPointer<Dim>& cell : cells) {
      const std::optional<int> v = value(cell.get());
      if (v == 0) return Integer(0);
      is_open = is_open || !v;
      if (v) out *= Integer(*v);
    }
    if (is_open) return std::nullopt;
    return out;
  }

 private:
  std::optional<int> value(const Cell<Dim>* cell) {
    for (const auto& [known, v] : known_)
      if (known == cell) return v;
    return known_.emplace_back(cell, cell->value(q_)).second;
  }

  const ChainPoint<Dim>& q_;
  std::vector<std::pair<const Cell<Dim>*, std::optional<int>>> known_;  // a few, near one point
};

}  // namespace

template <std::size_t Dim>
AssociatedFunction<Dim>::AssociatedFunction(Chain<Dim> chain) : chain_(std::move(chain)) {
  std::vector<Box3d> boxes;
  for (const ChainTerm<Dim>& t : chain_.terms()) boxes.push_back(t.box);
  boxes_ = BoxHierarchy(boxes);
}

template <std::size_t Dim>
template <typename Visit>
void AssociatedFunction<Dim>::visit_terms(const ChainPoint<Dim>& q, Visit visit) const {
  bool goes_on = true;
  boxes_.visit([&](const Box3d& box) { return goes_on && meets(box, q.box()); },
               [&](std::uint32_t i) { goes_on = goes_on && visit(chain_.terms()[i]); });
}

template <std::size_t Dim>
std::optional<Integer> AssociatedFunction<Dim>::value(const PointIn<Dim>& point) const {
  const ScopedDefaultFp nearest;
  const ChainPoint<Dim> q(point);
  CellValues<Dim> values(q);
  std::optional<Integer> out(Integer(0));
  visit_terms(q, [&](const ChainTerm<Dim>& term) {
    const std::optional<Integer> v = values.value(term.cells);
    if (v)
      *out += term.coefficient * *v;
    else
      out.reset();
    return out.has_value();
  });
  return out;
}

template <std::size_t Dim>
std::optional<bool> AssociatedFunction<Dim>::holds(const PointIn<Dim>& q) const {
  const std::optional<Integer> f = value(q);
  if (!f) return std::nullopt;
  return f->sign() != 0;
}

template <std::size_t Dim>
bool AssociatedFunction<Dim>::add_germs(const ChainPoint<Dim>& q,
                                        internal::GermSum<Dim>& sum) const {
  bool is_known = true;
  visit_terms(q, [&](const ChainTerm<Dim>& t) { return is_known = sum.add(t, q); });
  return is_known;
}

template <std::size_t Dim>
std::optional<bool> AssociatedFunction<Dim>::is_off_walls(const PointIn<Dim>& point) const {
  const ScopedDefaultFp nearest;
  const ChainPoint<Dim> q(point);
  internal::GermSum<Dim> sum;
  const bool is_known = add_germs(q, sum);
  if (!is_known) return std::nullopt;
  return sum.is_constant();
}

template <std::size_t Dim>
std::optional<Integer> AssociatedFunction<Dim>::regular_value(const PointIn<Dim>& point) const {
  const ScopedDefaultFp nearest;
  const ChainPoint<Dim> q(point);
  internal::GermSum<Dim> sum;
  const bool is_known = add_germs(q, sum);
  if (!is_known || sum.hyperplanes().size() > kMostWalls) return std::nullopt;
  bool is_in_closure = false;
  std::optional<Integer> greatest, least;
  std::set<std::vector<Sign>> seen;
  internal::LocalFaces<Dim>(sum.hyperplanes()).visit([&](const internal::LocalFace<Dim>& face) {
    if (!seen.insert(face.sides).second) return true;
    const Integer v = sum.at(face.sides);
    is_in_closure = is_in_closure || (face.is_open && v.sign() != 0);
    if (!greatest || *greatest < v) greatest = v;
    if (!least || v < *least) least = v;
    return true;
  });
  if (!is_in_closure) return Integer(0);
  return greatest->sign() > 0 ? greatest : least;
}

template <std::size_t Dim>
std::optional<Integer> AssociatedFunction<Dim>::value_beside(const PointIn<Dim>& point) const {
  const ScopedDefaultFp nearest;
  const ChainPoint<Dim> q(point);
  internal::GermSum<Dim> sum;
  const bool is_known = add_germs(q, sum);
  if (!is_known) return std::nullopt;
  // Along (1, s, s^2), which is in a hyperplane for at most Dim - 1 values of s.
  std::vector<Sign> sides;
  for (std::int64_t s = 1; sides.size() < sum.hyperplanes().size(); ++s) {
    NormalIn<Dim> along;
    Rational power(1);
    for (Rational& x : along) x = power, power *= Rational(s);
    sides.clear();
    for (const NormalIn<Dim>& h : sum.hyperplanes()) {
      const Sign side = internal::dot_product<Dim>(h, along).sign();
      if (side == 0) break;
      sides.push_back(side);
    }
  }
  return sum.at(sides);
}

template class AssociatedFunction<1>;
template class AssociatedFunction<2>;
template class AssociatedFunction<3>;

}  // namespace veritope
