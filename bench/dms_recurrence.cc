// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/dms_recurrence.h"

#include <algorithm>
#include <cmath>

#include "solids/dms/dms_region.h"

namespace veritope::bench {
namespace {

double at_point(const std::array<double, 4>& plane, const std::array<double, 3>& u) {
  return plane[0] + plane[1] * u[0] + plane[2] * u[1] + plane[3] * u[2];
}

}  // namespace

DmsRecurrence::DmsRecurrence(const DmsModel& model, const DmsKnotTable& knots,
                             std::uint32_t tetrahedron)
    : knots_(knots), components_(model.num_components()), nodes_(1) {
  const auto corners = knots.corners(tetrahedron);
  DmsRegion region(knots, {corners.begin(), corners.end()}, face_planes(corners));
  for (const DmsSupport& s : region.supports()) {
    const TetrahedronCorners& t = model.tetrahedra[s.tetrahedron];
    std::array<std::uint32_t, 4> w{};
    Set set;
    for (std::size_t m = 0; m < 4; ++m) {
      w[m] = knots.number(t[m], s.gamma[m]);
      for (int i = 0; i <= s.gamma[m]; ++i) set.insert(knots.number(t[m], i));
    }
    Term term;
    term.set = set;
    const double volume = frame(w, term.lambda);
    term.node = node(set, &w);
    for (std::size_t m = 0; m < 4; ++m)
      for (const Rational& c : model.value(control_of(model, s.tetrahedron, raised(s.gamma, m))))
        term.value.push_back(volume * nearest_double(c));
    terms_.push_back(std::move(term));
  }
  values_.resize(nodes_.size());
}

std::array<double, 3> DmsRecurrence::at(std::uint32_t knot) const {
  const DmsPoint& p = knots_.point(knot);
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

// The volume; 0 if it is nearly that.
double DmsRecurrence::frame(const std::array<std::uint32_t, 4>& knots,
                            std::array<Plane, 4>& lambda) const {
  std::array<std::array<double, 3>, 4> p;
  for (std::size_t m = 0; m < 4; ++m) p[m] = at(knots[m]);
  double e[3][3];
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t c = 0; c < 3; ++c) e[m][c] = p[m + 1][c] - p[0][c];
  const auto cross = [](const double* a, const double* b) {
    return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                 a[0] * b[1] - a[1] * b[0]};
  };
  const std::array<std::array<double, 3>, 3> normal{cross(e[1], e[2]), cross(e[2], e[0]),
                                                    cross(e[0], e[1])};
  const double volume = e[0][0] * normal[0][0] + e[0][1] * normal[0][1] + e[0][2] * normal[0][2];
  if (std::abs(volume) < 1e-12) return 0;
  lambda[0] = {1, 0, 0, 0};
  for (std::size_t m = 0; m < 3; ++m) {
    for (std::size_t c = 0; c < 3; ++c) lambda[m + 1][c + 1] = normal[m][c] / volume;
    lambda[m + 1][0] = 0;
    lambda[m + 1][0] = -at_point(lambda[m + 1], p[0]);
    for (std::size_t c = 0; c < 4; ++c) lambda[0][c] -= lambda[m + 1][c];
  }
  return volume;
}

void DmsRecurrence::Set::insert(std::uint32_t knot) {
  std::size_t i = size++;
  for (; i > 0 && knots[i - 1] > knot; --i) knots[i] = knots[i - 1];
  knots[i] = knot;
}
DmsRecurrence::Set DmsRecurrence::Set::without(std::uint32_t knot) const {
  Set rest = *this;
  std::size_t i = 0;
  while (rest.knots[i] != knot) ++i;
  for (; i + 1 < size; ++i) rest.knots[i] = rest.knots[i + 1];
  rest.knots[--rest.size] = 0xffffffffu;
  return rest;
}
std::size_t DmsRecurrence::SetHash::operator()(const Set& set) const {
  std::uint64_t hash = set.size;
  for (std::size_t i = 0; i < set.size; ++i)
    hash = (hash ^ set.knots[i]) * 0x9e3779b97f4a7c15u, hash ^= hash >> 32;
  return static_cast<std::size_t>(hash);
}

std::uint32_t DmsRecurrence::node(const Set& set, const std::array<std::uint32_t, 4>* wanted) {
  const auto found = places_.find(set);
  if (found != places_.end()) return found->second.node;
  Node made;
  made.size = set.size;
  double volume = 0;
  if (wanted != nullptr) made.knots = *wanted, volume = frame(made.knots, made.lambda);
  const auto from_end = [&](std::size_t i) { return set.knots[set.size - 1 - i]; };
  for (std::size_t a = 0; a < set.size && volume == 0; ++a)
    for (std::size_t b = a + 1; b < set.size && volume == 0; ++b)
      for (std::size_t c = b + 1; c < set.size && volume == 0; ++c)
        for (std::size_t d = c + 1; d < set.size && volume == 0; ++d) {
          made.knots = {from_end(d), from_end(c), from_end(b), from_end(a)};
          volume = frame(made.knots, made.lambda);
        }
  std::uint32_t number = 0;
  if (volume != 0) {
    made.height = 1 / std::abs(volume);
    for (std::size_t m = 0; m < 4 && set.size > 4; ++m)
      made.part[m] = node(set.without(made.knots[m]), nullptr);
    number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(made);
  }
  places_[set].node = number;
  return number;
}

double DmsRecurrence::value_of(const Set& set, const std::array<double, 3>& u) {
  Place& place = places_.find(set)->second;
  if (place.node == 0 || place.point == point_) return place.value;
  const Node& n = nodes_[place.node];
  double sum = 0;
  if (set.size == 4) {
    bool is_in = true;
    for (std::size_t m = 0; m < 4; ++m) is_in = is_in && at_point(n.lambda[m], u) > 0;
    sum = is_in ? n.height : 0;
  } else {
    for (std::size_t m = 0; m < 4; ++m)
      sum += at_point(n.lambda[m], u) * value_of(set.without(n.knots[m]), u);
  }
  place.point = point_;
  return place.value = sum;
}

void DmsRecurrence::add(const Term& t, double m, const std::array<double, 3>& u,
                        double* value) const {
  if (m == 0) return;
  for (std::size_t i = 0; i < 4; ++i) {
    const double by = m * at_point(t.lambda[i], u);
    for (std::size_t c = 0; c < components_; ++c) value[c] += by * t.value[i * components_ + c];
  }
}

void DmsRecurrence::evaluate(const std::array<double, 3>& u, double* value) {
  ++point_;
  std::fill_n(value, components_, 0.0);
  for (const Term& t : terms_) add(t, value_of(t.set, u), u, value);
}

void DmsRecurrence::evaluate_program(const std::array<double, 3>& u, double* value) {
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const Node& n = nodes_[i];
    const double l[4] = {at_point(n.lambda[0], u), at_point(n.lambda[1], u),
                         at_point(n.lambda[2], u), at_point(n.lambda[3], u)};
    if (n.size == 4) {
      values_[i] = l[0] > 0 && l[1] > 0 && l[2] > 0 && l[3] > 0 ? n.height : 0;
    } else {
      values_[i] = l[0] * values_[n.part[0]] + l[1] * values_[n.part[1]] +
                   l[2] * values_[n.part[2]] + l[3] * values_[n.part[3]];
    }
  }
  std::fill_n(value, components_, 0.0);
  for (const Term& t : terms_) add(t, values_[t.node], u, value);
}

std::size_t DmsRecurrence::num_not_zero() const {
  return static_cast<std::size_t>(std::count_if(
      terms_.begin(), terms_.end(), [&](const Term& t) { return values_[t.node] != 0; }));
}

}  // namespace veritope::bench
