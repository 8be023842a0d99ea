// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_change.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_knots.h"
#include "splines/simplex_spline.h"

namespace veritope {
namespace {

using Face = std::array<std::uint32_t, 3>;
using Last = std::array<std::size_t, 3>;  // numbers of last knots
using Numbers = std::vector<Rational>;    // one for each component

Rational volume6(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c, const DmsPoint& e) {
  return dot_product(difference(b, a), cross_product(difference(c, a), difference(e, a)));
}
DmsPoint mean_of(const std::vector<DmsPoint>& points) {
  DmsPoint out;
  for (const DmsPoint& p : points)
    for (std::size_t c = 0; c < 3; ++c) out[c] += p[c];
  for (Rational& c : out) c /= Rational(static_cast<std::int64_t>(points.size()));
  return out;
}
void raise_to(Rational& most, const Rational& x) { most = std::max(most, abs(x)); }

// visit(multiset) for all multisets of so many of the points.
template <typename Visit>
void for_each_multiset(const std::vector<DmsPoint>& points, std::size_t size, Visit visit) {
  std::vector<std::size_t> at(size, 0);
  for (;;) {
    visit(at);
    std::size_t i = size;
    while (i > 0 && at[i - 1] + 1 == points.size()) --i;
    if (i == 0) return;
    std::fill(at.begin() + static_cast<std::ptrdiff_t>(i) - 1, at.end(), at[i - 1] + 1);
  }
}

// d(u, ends) M(u|V) (f_i - f_j)(K, u, ..., u), one of the terms that are left where polynomials differ (DMS-3).
struct FaceTerm {
  std::vector<DmsPoint> before;  // K
  std::vector<DmsPoint> knots;   // V
  std::array<DmsPoint, 3> ends;
  Rational weight = Rational(1);
};

class ChangeBound {
 public:
  ChangeBound(const DmsModel& before, const DmsModel& after, const DmsCut& cut)
      : before_(before),
        after_(after),
        cut_(cut),
        vertex_(static_cast<std::uint32_t>(after.clouds.size() - 1)),
        degree_(static_cast<std::size_t>(before.degree)) {
    for (const std::uint32_t t : cut.tetrahedra)
      patches_.push_back(patch_of_tetrahedron(before, t));
  }

  std::vector<DmsChange> run() {
    const std::size_t size = before_.num_components();
    Numbers hi(size);
    for (std::size_t i = 0; i < patches_.size(); ++i) bound_refit(i);
    for (std::size_t c = 0; c < size && !refit_.empty(); ++c)
      hi[c] = std::max(abs(refit_[c][0]), abs(refit_[c][1]));
    add_faces(hi);
    std::vector<DmsChange> out(size);
    for (std::size_t c = 0; c < size; ++c) out[c].hi = std::move(hi[c]);
    if (std::any_of(out.begin(), out.end(), [](const DmsChange& c) { return !is_zero(c.hi); }))
      sample(out);
    return out;
  }

 private:
  static bool is_zero(const Rational& x) { return x.sign() == Sign::kZero; }

  // ---- control points at the new vertex that are not what the blossom of each part says

  void bound_refit(std::size_t cut) {
    const TetrahedronCorners& corners = before_.tetrahedra[cut_.tetrahedra[cut]];
    for (std::size_t m = 0; m < 4; ++m) {
      if (!cut_.has(corners[m])) continue;
      TetrahedronCorners part = corners;
      part[m] = vertex_;
      bound_part(part, m, patches_[cut]);
    }
  }
  void bound_part(const TetrahedronCorners& part, std::size_t m, const BPatch<Rational>& patch) {
    const std::size_t size = before_.num_components();
    Numbers off;  // by index, component by component
    for_each_tetrahedral_index(before_.degree, [&](const TetrahedralIndex& beta) {
      const auto begin = off.insert(off.end(), size, Rational());
      if (beta[m] == 0) return;
      const Numbers exact = patch.blossom(first_knots(part, beta));
      const auto now = after_.value(*find_control(after_, control_vertices(part, beta)));
      for (std::size_t c = 0; c < size; ++c)
        begin[static_cast<std::ptrdiff_t>(c)] = now[c] - exact[c];
    });
    if (std::all_of(off.begin(), off.end(), is_zero)) return;
    refit_.resize(size);
    for_each_tetrahedral_index(
        before_.degree - 1, [&](const TetrahedralIndex& gamma) { add_affine(part, gamma, off); });
  }
  // The affine function of W_γ and the values `off`, at the knots V_γ.
  void add_affine(const TetrahedronCorners& part, const TetrahedralIndex& gamma,
                  const Numbers& off) {
    const std::size_t size = refit_.size();
    std::array<DmsPoint, 4> w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = after_.knot(part[i], gamma[i]);
    const auto frame = simplex_frame<Rational>({0, 1, 2, 3}, w, Sign::kPositive);
    for (std::size_t i = 0; i < 4; ++i)
      for (int k = 0; k <= gamma[i]; ++k) {
        const auto lambda = frame.barycentric(after_.knot(part[i], k));
        for (std::size_t c = 0; c < size; ++c) {
          Rational sum;
          for (std::size_t j = 0; j < 4; ++j)
            sum += lambda[j] * off[tetrahedral_index(raised(gamma, j)) * size + c];
          refit_[c][0] = std::min(refit_[c][0], sum);
          refit_[c][1] = std::max(refit_[c][1], sum);
        }
      }
  }
  std::vector<DmsPoint> first_knots(const TetrahedronCorners& corners,
                                    const TetrahedralIndex& beta) const {
    std::vector<DmsPoint> out;
    for (std::size_t i = 0; i < 4; ++i)
      for (int k = 0; k < beta[i]; ++k) out.push_back(after_.knot(corners[i], k));
    return out;
  }

  // ---- faces that are cut, between tetrahedra with different polynomials

  void add_faces(Numbers& hi) {
    set_shares();
    for (std::size_t i = 0; i < patches_.size(); ++i)
      for (std::size_t j = i + 1; j < patches_.size(); ++j) {
        const auto face = common_face(cut_.tetrahedra[i], cut_.tetrahedra[j]);
        if (!face) continue;
        const auto add = [&](const FaceTerm& term) { add_term(term, i, j, hi); };
        for_each_last([&](const Last& last) {
          add_difference(*face, last, add);
          for (std::size_t m = 0; m < 3; ++m) {
            if (last[m] == 0 || !cut_.has((*face)[m])) continue;
            Face part = *face;
            part[m] = vertex_;
            add(term_of(part, last));
          }
        });
      }
  }
  std::optional<Face> common_face(std::uint32_t a, std::uint32_t b) const {
    const TetrahedronCorners& other = before_.tetrahedra[b];
    Face face{};
    std::size_t count = 0;
    for (const std::uint32_t v : before_.tetrahedra[a])
      if (std::ranges::find(other, v) != other.end() && count++ < 3) face[count - 1] = v;
    return count == 3 ? std::optional(face) : std::nullopt;
  }
  // The barycentric coordinates of the new vertex in its simplex.
  void set_shares() {
    const TetrahedronCorners& corners = before_.tetrahedra[cut_.tetrahedra[0]];
    std::array<DmsPoint, 4> at;
    for (std::size_t m = 0; m < 4; ++m) at[m] = before_.knot(corners[m], 0);
    const auto lambda = simplex_frame<Rational>({0, 1, 2, 3}, at, Sign::kPositive)
                            .barycentric(after_.knot(vertex_, 0));
    for (std::size_t m = 0; m < 4; ++m) share_[corners[m]] = lambda[m];
  }
  template <typename Visit>
  void for_each_last(Visit visit) const {
    for (std::size_t sum = 1; sum < degree_; ++sum)
      for (std::size_t a = 0; a <= sum; ++a)
        for (std::size_t b = 0; a + b <= sum; ++b) visit(Last{a, b, sum - a - b});
  }
  // The term of a face whose corners have these last knots.
  FaceTerm term_of(const Face& face, const Last& last) const {
    FaceTerm out;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k <= last[i]; ++k) {
        out.knots.push_back(after_.knot(face[i], static_cast<int>(k)));
        if (k < last[i]) out.before.push_back(out.knots.back());
      }
      out.ends[i] = after_.knot(face[i], static_cast<int>(last[i]));
    }
    return out;
  }
  // The term of a face minus those of its parts that have the new vertex in the place of a corner with the last knot 0.
  // As the new vertex is a mean of corners, what is left is a sum over the corners b with later knots.
  template <typename Add>
  void add_difference(const Face& face, const Last& last, Add add) const {
    const FaceTerm whole = term_of(face, last);
    const auto is_replaced = [&](std::size_t m) { return last[m] == 0 && cut_.has(face[m]); };
    if (!is_replaced(0) && !is_replaced(1) && !is_replaced(2)) return add(whole);
    for (std::size_t b = 0; b < 3; ++b) {
      if (last[b] == 0 || !cut_.has(face[b])) continue;
      const DmsPoint& first = after_.knot(face[b], 0);
      const auto add_without = [&](const DmsPoint& removed, const std::array<DmsPoint, 3>& ends) {
        FaceTerm term = whole;
        term.weight = share_.at(face[b]);
        term.ends = ends;
        term.knots.erase(std::ranges::find(term.knots, removed));
        term.knots.push_back(after_.knot(vertex_, 0));
        add(term);
      };
      add_without(first, whole.ends);
      for (std::size_t z = 0; z < 3; ++z) {
        if (!is_replaced(z)) continue;
        std::array<DmsPoint, 3> ends = whole.ends;
        ends[z] = first;
        add_without(after_.knot(face[z], 0), ends);
      }
    }
  }

  void add_term(const FaceTerm& term, std::size_t i, std::size_t j, Numbers& hi) {
    std::vector<DmsPoint> points = term.knots;
    std::ranges::sort(points);
    const Rational height = height_bound(points) * term.weight;
    points.erase(std::unique(points.begin(), points.end()), points.end());
    Numbers reach;
    for (const DmsPoint& p : points)
      reach.push_back(volume6(p, term.ends[0], term.ends[1], term.ends[2]));
    if (is_zero(height) || std::all_of(reach.begin(), reach.end(), is_zero)) return;
    places_.push_back(mean_of(points));
    const Numbers most = greatest_product(term.before, points, reach, i, j);
    for (std::size_t c = 0; c < most.size(); ++c) hi[c] += height * most[c];
  }
  // Bounds |d(u, ends) (f_i - f_j)(K, u, ..., u)| for u in the hull of V: the blossom of this product at knots.
  Numbers greatest_product(const std::vector<DmsPoint>& before, const std::vector<DmsPoint>& points,
                           const Numbers& reach, std::size_t i, std::size_t j) const {
    const std::size_t count = degree_ - before.size();
    std::map<std::vector<std::size_t>, Numbers> known;
    for_each_multiset(points, count, [&](const std::vector<std::size_t>& rest) {
      std::vector<DmsPoint> knots = before;
      for (const std::size_t k : rest) knots.push_back(points[k]);
      Numbers& difference = known[rest] = patches_[i].blossom(knots);
      const Numbers other = patches_[j].blossom(knots);
      for (std::size_t c = 0; c < other.size(); ++c) difference[c] -= other[c];
    });
    Numbers most(before_.num_components());
    for_each_multiset(points, count + 1, [&](const std::vector<std::size_t>& all) {
      Numbers product(most.size());
      for (std::size_t k = 0; k < all.size(); ++k) {
        std::vector<std::size_t> rest = all;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
        const Numbers& difference = known.at(rest);
        for (std::size_t c = 0; c < most.size(); ++c) product[c] += reach[all[k]] * difference[c];
      }
      for (std::size_t c = 0; c < most.size(); ++c) raise_to(most[c], product[c]);
    });
    for (Rational& x : most) x /= Rational(static_cast<std::int64_t>(count + 1));
    return most;
  }
  // Bounds M(u|V). For four knots M is 1/|d| or 0. For five it is the length of a line's part in the simplex of shares,
  // in units of the knots' dependency, whose numbers are the d of four of them: at most 2 / (the sum of all |d|). For
  // more, some four knots contain u, and M is a mean of those without one of them: at most the greatest for five.
  static Rational height_bound(const std::vector<DmsPoint>& v) {
    if (v.size() == 4) {
      const Rational d = abs(volume6(v[0], v[1], v[2], v[3]));
      return is_zero(d) ? d : Rational(1) / d;
    }
    if (v.size() == 5) {
      Rational sum;
      for (std::size_t i = 0; i < 5; ++i) {
        std::array<const DmsPoint*, 4> w{};
        for (std::size_t k = 0; k < 4; ++k) w[k] = &v[k < i ? k : k + 1];
        sum += abs(volume6(*w[0], *w[1], *w[2], *w[3]));
      }
      return is_zero(sum) ? sum : Rational(2) / sum;
    }
    Rational most;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (i > 0 && v[i] == v[i - 1]) continue;
      std::vector<DmsPoint> rest = v;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      most = std::max(most, height_bound(rest));
    }
    return most;
  }

  // ---- what the change is at some points

  void sample(std::vector<DmsChange>& out) {
    places_.push_back(after_.knot(vertex_, 0));
    for (const TetrahedronCorners& t : after_.tetrahedra) {
      if (std::ranges::find(t, vertex_) == t.end()) continue;
      std::vector<DmsPoint> corners;
      for (const std::uint32_t v : t) corners.push_back(after_.knot(v, 0));
      places_.push_back(mean_of(corners));
      for (const DmsPoint& p : corners) places_.push_back(mean_of({p, after_.knot(vertex_, 0)}));
    }
    std::ranges::sort(places_);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    DmsEvaluator before(before_), after(after_);
    for (const DmsPoint& p : places_) {
      const auto from = before.locate(p), to = after.locate(p);
      if (!from || !to) continue;  // a knot's place outside of the domain
      const DmsValue old_value = before.evaluate(*from), new_value = after.evaluate(*to);
      for (std::size_t c = 0; c < out.size(); ++c)
        raise_to(out[c].lo, new_value.value[c] - old_value.value[c]);
    }
  }

  const DmsModel& before_;
  const DmsModel& after_;
  const DmsCut& cut_;
  const std::uint32_t vertex_;
  const std::size_t degree_;
  std::vector<BPatch<Rational>> patches_;       // of the tetrahedra that are cut
  std::vector<std::array<Rational, 2>> refit_;  // for each component; empty: all are 0
  std::map<std::uint32_t, Rational> share_;     // of the new vertex in corners of a tetrahedron
  std::vector<DmsPoint> places_;                // where values are compared
};

}  // namespace

bool DmsCut::has(std::uint32_t vertex) const {
  return std::ranges::find(simplex, vertex) != simplex.end();
}

BPatch<Rational> patch_of_tetrahedron(const DmsModel& model, std::uint32_t tetrahedron) {
  return patch_of_tetrahedron(model, tetrahedron, 0, model.num_components());
}

BPatch<Rational> patch_of_tetrahedron(const DmsModel& model, std::uint32_t tetrahedron,
                                      std::size_t first, std::size_t count) {
  const TetrahedronCorners& corners = model.tetrahedra[tetrahedron];
  std::vector<Rational> control;
  for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
    const auto value = model.value(control_of(model, tetrahedron, beta)).subspan(first, count);
    control.insert(control.end(), value.begin(), value.end());
  });
  return BPatch<Rational>(model.degree, count, std::move(control),
                          [&](const TetrahedralIndex& gamma) {
                            std::array<DmsPoint, 4> points;
                            for (std::size_t m = 0; m < 4; ++m)
                              points[m] = model.knot(corners[m], gamma[m]);
                            // No half-open rule asks this frame, so its orientation has no effect.
                            return simplex_frame<Rational>({0, 1, 2, 3}, points, Sign::kPositive);
                          });
}

std::vector<DmsChange> bound_dms_change(const DmsModel& before, const DmsModel& after,
                                        const DmsCut& cut) {
  VT_CHECK(!before.control.is_separate && after.clouds.size() == before.clouds.size() + 1,
           "one vertex was inserted");
  return ChangeBound(before, after, cut).run();
}

}  // namespace veritope
