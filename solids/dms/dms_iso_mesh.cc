// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "interval/upward.h"
#include "solids/dms/dms_iso_mesh_internal.h"

namespace veritope::internal {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr int kMostSteps = 60, kMostValues = 14, kFirstBits = 8;

// Where a polynomial with unlike signs at 0 and 1 is 0: halves while its sign is decided.
double root_of(const std::vector<Interval>& b, int sign_at_0) {
  const ScopedUpward upward;
  double low = 0, high = 1;
  for (int step = 0; step < kMostSteps; ++step) {
    const double t = low / 2 + high / 2;
    std::vector<Interval> x = b;
    const Interval far(t), near = Interval(1.0) - far;
    for (std::size_t left = x.size() - 1; left > 0; --left)
      for (std::size_t k = 0; k < left; ++k)
        x[k] = Interval::nonnegative_multiple(x[k], near) +
               Interval::nonnegative_multiple(x[k + 1], far);
    const Sign3 sign = x[0].sign();
    if (sign != Sign3::kPositive && sign != Sign3::kNegative) return t;
    ((sign == Sign3::kPositive) == (sign_at_0 > 0) ? low : high) = t;
  }
  return low / 2 + high / 2;
}

class IsoDrawing {
 public:
  IsoDrawing(IsoCells& cells, DmsEvaluator* map, bool keeps_places, DmsIso& out)
      : cells_(cells), map_(map), keeps_places_(keeps_places), out_(out) {}

  Status run() {
    for (const IsoCell& cell : cells_.cells)
      if (cell.is_alive && cell.off == 0) add(cell);
    std::tie(out_.components, out_.euler) = numbers_of(out_.mesh.faces, welded_.size());
    if (!first_at_.empty()) weld();
    if (!beyond_) return ok_status();
    Error error{Code::kNotFinite, {}, "a vertex of the surface is beyond binary64"};
    error.place.entity = *beyond_;
    return error;
  }

 private:
  bool is_above(const IsoCell& cell, std::size_t m) const {
    return cells_.vertices[cell.corners[m]].sign >= 0;
  }

  void add(const IsoCell& cell) {
    // Even permutations of the corners, those above first.
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t m) { return is_above(cell, m); });
    const auto above =
        std::count_if(order.begin(), order.end(), [&](std::size_t m) { return is_above(cell, m); });
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) inversions += order[i] > order[j] ? 1 : 0;
    if (inversions % 2 != 0) {
      if (above == 3)
        std::swap(order[0], order[1]);
      else
        std::swap(order[2], order[3]);
    }
    const auto at = [&](std::size_t i, std::size_t j) { return vertex(cell, order[i], order[j]); };
    if (above == 1) {
      add_face(at(0, 1), at(0, 2), at(0, 3));
    } else if (above == 2) {
      const std::array<std::uint32_t, 4> q{at(0, 2), at(0, 3), at(1, 3), at(1, 2)};
      add_face(q[0], q[1], q[2]);
      add_face(q[0], q[2], q[3]);
    } else if (above == 3) {
      add_face(at(0, 3), at(1, 3), at(2, 3));
    }
  }
  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    out_.mesh.faces.push_back({a, b, c});
  }

  std::uint32_t vertex(const IsoCell& cell, std::size_t i, std::size_t j) {
    if (cell.corners[i] > cell.corners[j]) std::swap(i, j);
    const std::uint32_t a = cell.corners[i], b = cell.corners[j];
    const auto [found, is_new] =
        numbers_.try_emplace({a, b}, static_cast<std::uint32_t>(out_.mesh.positions.size()));
    if (!is_new) return found->second;
    const std::uint32_t zero = cells_.vertices[a].sign == 0 ? a : b;
    const bool is_at_vertex = cells_.vertices[zero].sign == 0;
    welded_.push_back(is_at_vertex ? first_at_.try_emplace(zero, found->second).first->second
                                   : found->second);
    DmsPoint at = is_at_vertex ? cells_.vertices[zero].at
                               : cells_.between(a, b, Rational::from_double(root(cell, i, j)));
    if (keeps_places_) out_.places.push_back(at);
    if (map_ != nullptr) {
      const auto place = map_->locate(at);
      VT_CHECK(place.has_value(), "points of cells are in the domain");
      const DmsValue value = map_->evaluate(*place);
      std::copy_n(value.value.begin(), 3, at.begin());
    }
    const Vec3d p{nearest_double(at[0]), nearest_double(at[1]), nearest_double(at[2])};
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) && !beyond_)
      beyond_ = cell.tetrahedron;
    out_.mesh.positions.push_back(p);
    return found->second;
  }

  // From corner i to corner j.
  double root(const IsoCell& cell, std::size_t i, std::size_t j) {
    const std::uint32_t a = cell.corners[i], b = cell.corners[j];
    const int sign = is_above(cell, i) ? 1 : -1;
    // All cells at an edge are to say the same: the one with the lowest number that has a polynomial.
    for (const std::uint32_t c : cells_.around(a, b)) {
      const IsoCell& other = cells_.cells[c];
      if (other.off != 0 || !other.form.is_polynomial()) continue;
      for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
        const auto [k, l] = kDmsEdges[e];
        std::vector<Interval> along = cells_.rule().along_edge(other.form, e);
        if (other.corners[k] == a && other.corners[l] == b) return root_of(along, sign);
        if (other.corners[k] != b || other.corners[l] != a) continue;
        std::reverse(along.begin(), along.end());
        return root_of(along, sign);
      }
    }
    return root_by_values(a, b, sign);
  }

  // Regula falsi of exact values (Illinois), on an edge that planes of knots cross.
  double root_by_values(std::uint32_t a, std::uint32_t b, int sign) {
    double low = 0, high = 1;
    double at_low = nearest_double(cells_.value_at(cells_.vertices[a].at));
    double at_high = nearest_double(cells_.value_at(cells_.vertices[b].at));
    double before = -1;
    int last = 0;
    for (int k = 0; k < kMostValues && high - low > 0x1p-52; ++k) {
      double t = low + (high - low) * (at_low / (at_low - at_high));
      // Few bits first: points with short coordinates take a third of the time.
      if (k < 3) t = std::ldexp(std::round(std::ldexp(t, kFirstBits << k)), -(kFirstBits << k));
      if (!(t > low && t < high)) t = low / 2 + high / 2;
      if (std::abs(t - before) <= 0x1p-52) return t;
      before = t;
      const Rational value = cells_.value_at(cells_.between(a, b, Rational::from_double(t)));
      if (value.sign() == Sign::kZero) return t;
      const bool is_low = (value.sign() == Sign::kPositive) == (sign > 0);
      (is_low ? low : high) = t;
      (is_low ? at_low : at_high) = nearest_double(value);
      const int side = is_low ? 1 : -1;
      if (side == last) (is_low ? at_high : at_low) /= 2;
      last = side;
    }
    return std::abs(at_low) < std::abs(at_high) ? low : high;
  }

  // Points on edges at one vertex with g = c become one, and some faces vanish, if that keeps the topology, which
  // DMS-4 does not say.
  void weld() {
    std::vector<Triangle> faces;
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    bool is_manifold = true;
    for (const auto& f : out_.mesh.faces) {
      const Triangle g{welded_[f[0]], welded_[f[1]], welded_[f[2]]};
      if (g[0] == g[1] || g[1] == g[2] || g[2] == g[0]) continue;
      for (std::size_t k = 0; k < 3; ++k)
        is_manifold = directed.emplace(g[k], g[(k + 1) % 3]).second && is_manifold;
      faces.push_back(g);
    }
    if (!is_manifold ||
        numbers_of(faces, welded_.size()) != numbers_of(out_.mesh.faces, welded_.size()))
      return;
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> place(welded_.size(), kNone);
    std::vector<Vec3d> positions;
    std::vector<DmsPoint> places;
    for (auto& f : faces)
      for (std::uint32_t& v : f) {
        if (place[v] == kNone) {
          place[v] = static_cast<std::uint32_t>(positions.size());
          positions.push_back(out_.mesh.positions[v]);
          if (keeps_places_) places.push_back(std::move(out_.places[v]));
        }
        v = place[v];
      }
    out_.mesh.faces = std::move(faces);
    out_.mesh.positions = std::move(positions);
    out_.places = std::move(places);
  }

  // Components, and the Euler characteristic.
  static std::pair<std::uint64_t, std::int64_t> numbers_of(const std::vector<Triangle>& faces,
                                                           std::size_t num_vertices) {
    constexpr std::uint32_t kUnused = 0xffffffffu;
    std::vector<std::uint32_t> parent(num_vertices, kUnused);
    const auto root_of_set = [&](std::uint32_t v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& f : faces)
      for (const std::uint32_t v : f) parent[v] = v;
    for (const auto& f : faces)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = f[k], b = f[(k + 1) % 3];
        edges.emplace(std::min(a, b), std::max(a, b));
        parent[root_of_set(a)] = root_of_set(b);
      }
    std::uint64_t components = 0;
    std::int64_t vertices = 0;
    for (std::uint32_t v = 0; v < parent.size(); ++v) {
      components += parent[v] == v ? 1 : 0;
      vertices += parent[v] != kUnused ? 1 : 0;
    }
    return {components, vertices - static_cast<std::int64_t>(edges.size()) +
                            static_cast<std::int64_t>(faces.size())};
  }

  IsoCells& cells_;
  DmsEvaluator* map_;
  bool keeps_places_;
  DmsIso& out_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
  std::vector<std::uint32_t> welded_;  // of each vertex: itself, or
  std::map<std::uint32_t, std::uint32_t>
      first_at_;                         // the first one at a vertex of cells with g = c
  std::optional<std::uint32_t> beyond_;  // the first tetrahedron with a vertex beyond binary64
};

}  // namespace

Status draw_iso(IsoCells& cells, DmsEvaluator* map, bool keeps_places, DmsIso& out) {
  return IsoDrawing(cells, map, keeps_places, out).run();
}

}  // namespace veritope::internal
