// SPDX-License-Identifier: Apache-2.0 OR MIT
// volume_walls.cc: section 4 of docs/certificates/reading-rule-faces.md: pairs of equal faces. Control points and axes
// are replaced by their ranks among all of their kind; then a face is a list of integers for each symmetry, and two
// faces are equal iff their least lists are.
#include "volume_faces.h"

#include <numeric>

namespace {

// For each of n values, its number among the different ones, by their order. compare(i, j) is < 0, 0 or > 0.
template <class Compare>
std::vector<size_t> ranks(size_t n, Compare compare) {
  std::vector<size_t> order(n), r(n);
  std::iota(order.begin(), order.end(), size_t(0));
  std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return compare(i, j) < 0; });
  for (size_t k = 1; k < n; ++k)
    r[order[k]] = r[order[k - 1]] + (compare(order[k - 1], order[k]) != 0);
  return r;
}

struct Quotient {
  const Ratio *n, *d;  // d > 0
};
int compare(const Quotient& a, const Quotient& b) {
  if (a.n == b.n && a.d == b.d) return 0;
  const int side = a.n->n.sign() - b.n->n.sign();
  if (side != 0) return side;
  const Big* const l[4] = {&a.n->n, &a.d->d, &b.n->d, &b.d->n};
  const Big* const r[4] = {&b.n->n, &b.d->d, &a.n->d, &a.d->n};
  int64_t longer = 0;  // products of four numbers are at most 4 bits shorter than these together
  for (int i = 0; i < 4; ++i) longer += l[i]->bits() - r[i]->bits();
  if (longer >= 4 || longer <= -4) return longer > 0 ? a.n->n.sign() : -a.n->n.sign();
  return compare(*l[0] * *l[1] * (*l[2] * *l[3]), *r[0] * *r[1] * (*r[2] * *r[3]));
}

// The knots of an axis after the affine map that takes the first to 0 and the last to 1, as fractions that may not
// be in lowest terms.
struct Axis {
  int64_t degree;
  std::vector<Ratio> knots;

  Axis(int64_t d, const std::vector<Ratio>& t, bool is_reversed) : degree(d) {
    const Ratio &t0 = t.front(), &t1 = t.back();
    const Big length = t1.n * t0.d - t0.n * t1.d;
    for (const Ratio& x : t) {
      const Big whole = length * x.d, part = (x.n * t0.d - t0.n * x.d) * t1.d;
      knots.push_back(Ratio(is_reversed ? whole - part : part, whole));
    }
    if (is_reversed) std::reverse(knots.begin(), knots.end());
  }
};
int compare(const Axis& a, const Axis& b) {
  if (a.degree != b.degree) return a.degree < b.degree ? -1 : 1;
  if (a.knots.size() != b.knots.size()) return a.knots.size() < b.knots.size() ? -1 : 1;
  for (size_t i = 0; i < a.knots.size(); ++i)
    if (const int side = compare(a.knots[i], b.knots[i])) return side;
  return 0;
}

struct WallFace {                 // with ranks instead of numbers
  size_t axis[2][2];          // for each parameter, as it is and reversed
  uint64_t n[2];              // control points along each parameter
  std::vector<size_t> point;  // the second parameter fastest

  std::vector<size_t> list(bool exchange, bool reverse_first, bool reverse_second) const {
    const bool reverse[2] = {reverse_first, reverse_second};
    const uint64_t size[2] = {n[exchange ? 1 : 0], n[exchange ? 0 : 1]};
    std::vector<size_t> r;
    for (int a = 0; a < 2; ++a) r.push_back(axis[exchange ? 1 - a : a][reverse[a] ? 1 : 0]);
    for (uint64_t i = 0; i < size[0]; ++i)
      for (uint64_t j = 0; j < size[1]; ++j) {
        const uint64_t s = reverse[0] ? size[0] - 1 - i : i, t = reverse[1] ? size[1] - 1 - j : j;
        r.push_back(point[exchange ? t * n[1] + s : s * n[1] + t]);
      }
    return r;
  }
};

class Faces {
 public:
  explicit Faces(const std::vector<Entity>& entities) {
    for (const Entity& e : entities) lowered_.push_back(lowered(e));
    faces_.resize(lowered_.size());
    rank_axes();
    rank_points();
  }
  const std::vector<WallFace>& ranked() const { return faces_; }

 private:
  void rank_axes() {
    std::map<std::pair<const Ratio*, int64_t>, size_t> known;  // each list of knots once
    std::vector<Axis> axes;                                    // two for each
    for (const Entity& e : lowered_)
      for (size_t a = 0; a < 2; ++a)
        if (known.emplace(std::make_pair(&e.knots[a][0], e.degrees[a]), axes.size()).second)
          for (int reversed = 0; reversed < 2; ++reversed)
            axes.push_back(Axis(e.degrees[a], e.knots[a], reversed == 1));
    const std::vector<size_t> rank =
        ranks(axes.size(), [&](size_t i, size_t j) { return compare(axes[i], axes[j]); });
    for (size_t f = 0; f < faces_.size(); ++f)
      for (size_t a = 0; a < 2; ++a) {
        const Entity& e = lowered_[f];
        const size_t at = known.at(std::make_pair(&e.knots[a][0], e.degrees[a]));
        for (size_t reversed = 0; reversed < 2; ++reversed)
          faces_[f].axis[a][reversed] = rank[at + reversed];
        faces_[f].n[a] = e.points_along(a);
      }
  }
  const Ratio& component(const Entity& e, uint64_t i, size_t k) const {
    return k < size_t(e.components) ? e.number(i, k) : one_;
  }
  // It is > 0: lower degrees may have weights that are not, but those of corners stay as they are.
  const Ratio& greatest_weight(const Entity& e) const {
    const Ratio* most = &component(e, 0, 3);
    for (uint64_t i = 1; i < e.places.size(); ++i) {
      const Ratio& w = component(e, i, 3);
      if (&w != most && compare(w, *most) > 0) most = &w;
    }
    return *most;
  }
  // All components are divided by the greatest weight of their face, which symmetries do not change.
  void rank_points() {
    std::vector<Quotient> all;  // four for each point
    for (const Entity& e : lowered_) {
      const Ratio& most = greatest_weight(e);
      for (uint64_t i = 0; i < e.places.size(); ++i)
        for (size_t k = 0; k < 4; ++k) all.push_back(Quotient{&component(e, i, k), &most});
    }
    const std::vector<size_t> rank = ranks_of(all);
    const std::vector<size_t> point = ranks(rank.size() / 4, [&](size_t i, size_t j) {
      for (size_t k = 0; k < 4; ++k)
        if (rank[4 * i + k] != rank[4 * j + k]) return rank[4 * i + k] < rank[4 * j + k] ? -1 : 1;
      return 0;
    });
    auto at = point.begin();
    for (size_t f = 0; f < faces_.size(); ++f) {
      const auto end = at + int64_t(lowered_[f].places.size());
      faces_[f].point.assign(at, end);
      at = end;
    }
  }
  // Equal numbers are compared once, however many points share them.
  static std::vector<size_t> ranks_of(const std::vector<Quotient>& all) {
    std::vector<const Ratio*> numbers;
    for (const Quotient& q : all) numbers.insert(numbers.end(), {q.n, q.d});
    const std::less<const Ratio*> before = std::less<const Ratio*>();
    std::sort(numbers.begin(), numbers.end(), before);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    const std::vector<size_t> value = ranks(numbers.size(), [&](size_t i, size_t j) {
      const Ratio &a = *numbers[i], &b = *numbers[j];
      return a.n == b.n && a.d == b.d ? 0 : compare(a, b);
    });
    const auto value_of = [&](const Ratio* x) {
      const auto at = std::lower_bound(numbers.begin(), numbers.end(), x, before);
      return value[size_t(at - numbers.begin())];
    };
    std::map<std::pair<size_t, size_t>, size_t> known;  // each pair of values once
    std::vector<Quotient> different;
    std::vector<size_t> r;
    for (const Quotient& q : all) {
      const auto values = std::make_pair(value_of(q.n), value_of(q.d));
      const auto at = known.emplace(values, different.size());
      if (at.second) different.push_back(q);
      r.push_back(at.first->second);
    }
    const std::vector<size_t> rank = ranks(
        different.size(), [&](size_t i, size_t j) { return compare(different[i], different[j]); });
    for (size_t& x : r) x = rank[x];
    return r;
  }

  const Ratio one_ = Ratio(Big(1));
  std::vector<Entity> lowered_;
  std::vector<WallFace> faces_;
};

struct Form {  // the least list of a face, and the symmetries that lead to it
  std::vector<size_t> list;
  bool by_even, by_odd;

  explicit Form(const WallFace& face)
      : list(face.list(false, false, false)), by_even(true), by_odd(false) {
    for (int s = 1; s < 8; ++s) {
      const bool exchange = (s & 1) != 0, first = (s & 2) != 0, second = (s & 4) != 0;
      std::vector<size_t> other = face.list(exchange, first, second);
      if (other > list) continue;
      if (other < list) list.swap(other), by_even = by_odd = false;
      (exchange != (first != second) ? by_odd : by_even) = true;
    }
  }
};

}  // namespace

std::vector<bool> are_walls(const std::vector<Entity>& entities) {
  std::vector<Form> forms;
  {
    const Faces faces(entities);
    for (const WallFace& face : faces.ranked()) forms.push_back(Form(face));
  }
  std::vector<size_t> order(forms.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::sort(order.begin(), order.end(),
            [&](size_t i, size_t j) { return forms[i].list < forms[j].list; });
  std::vector<bool> r(forms.size());
  for (size_t i = 0, end = 0; i < order.size(); i = end) {
    for (end = i; end < order.size() && forms[order[end]].list == forms[order[i]].list;) ++end;
    if (end - i != 2) continue;
    const Form &a = forms[order[i]], &b = forms[order[i + 1]];
    // An odd symmetry takes the one to the form of both, and on to the other.
    const bool is_odd = (a.by_even && b.by_odd) || (a.by_odd && b.by_even);
    r[order[i]] = r[order[i + 1]] = is_odd;
  }
  return r;
}
