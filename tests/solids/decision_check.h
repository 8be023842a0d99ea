// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/decision_check.h: a report of decide_validity against brute force, and reports against each other.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solids/polyhedron/validity.h"
#include "tests/support/brute_force.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/report_text.h"
#include "tests/support/shapes.h"

namespace veritope {

inline ListedReport decide(const TriangleMesh& mesh, unsigned jobs = 1,
                           std::size_t max_defects = 20) {
  ValidityOptions options;
  options.jobs = jobs;
  options.max_defects = max_defects;
  return decide_and_list(mesh, options);
}

/// What summary() writes, from the definitions alone.
inline std::string summary(const TriangleMesh& mesh, const oracle::BruteDecision& b) {
  std::string out = b.is_valid ? "valid" : "invalid";
  for (std::uint64_t n : b.rules) out += " " + std::to_string(n);
  const auto& t = b.topology;
  const auto known = [](const auto& v) { return v ? std::to_string(*v) : std::string("unknown"); };
  const auto euler = static_cast<std::int64_t>(t.vertices.size()) - static_cast<std::int64_t>(t.edges.size()) +
                     static_cast<std::int64_t>(mesh.faces.size() - t.collapsed.size());
  std::optional<Rational> volume;
  if (b.volumes) {
    volume.emplace();
    for (const Rational& v : *b.volumes) *volume += v;
  }
  out += " F" + std::to_string(mesh.faces.size()) + " V" + std::to_string(t.vertices.size()) + " E" + std::to_string(t.edges.size()) + " euler " +
         std::to_string(euler) + " bodies " + known(b.bodies) + " genus " + known(b.genus) + " volume " + spelled(volume) + " shells";
  for (std::size_t s = 0; s < t.shells.size(); ++s) {
    std::set<std::uint32_t> vertices;
    std::set<oracle::Edge> edges;
    for (std::uint32_t f : t.shells[s])
      for (std::size_t i = 0; i < 3; ++i) {
        vertices.insert(mesh.faces[f][i]);
        edges.insert(std::minmax(mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]));
      }
    const auto shell_euler = static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(edges.size()) +
                             static_cast<std::int64_t>(t.shells[s].size());
    out += " (" + std::to_string(t.shells[s][0]) + ", " + std::to_string(shell_euler) + ", " +
           (b.genus ? std::to_string((2 - shell_euler) / 2) : "unknown") + ", " + (b.volumes ? spelled((*b.volumes)[s]) : "unknown") + ", " +
           (b.depths ? std::to_string((*b.depths)[s]) : "unknown") + ", " +
           (b.depths ? (oracle::sgn((*b.volumes)[s]) > 0 ? "out" : "in") : "unknown") + ")";
  }
  return out;
}

/// The point lies in the face.
inline bool is_in_face(const TriangleMesh& mesh, std::uint32_t f, const RationalPoint& point) {
  const oracle::RTriangle t = oracle::rational_triangle(mesh, f);
  const oracle::RVec n = oracle::normal_of(t);
  const oracle::RVec p{point.at[0], point.at[1], point.at[2]};
  using oracle::operator-;
  if (oracle::sgn(oracle::dot(n, p - t[0])) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (oracle::sgn(oracle::dot(n, oracle::cross(t[(i + 1) % 3] - t[i], p - t[i]))) < 0) return false;
  return true;
}

/// The size of a face or an edge, to within a few roundings.
inline double approx_size(const TriangleMesh& mesh, const std::vector<std::uint32_t>& ids) {
  double out = 0;
  for (const std::uint32_t i : ids)
    for (const std::uint32_t j : ids) {
      const Vec3d &a = mesh.positions[i], &b = mesh.positions[j];
      out = std::max(out, std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
    }
  return out;
}

/// What a rule forbids, as the oracle lists it, against the listed defects: those of greatest size, largest first.
template <typename Id>
class LargestOf {
 public:
  void add(Id id, double size) { sizes_[std::move(id)] = size; }
  void take(const Id& id, double size) {
    const auto found = sizes_.find(id);
    ASSERT_NE(found, sizes_.end()) << "no such defect, or listed twice";
    EXPECT_NEAR(found->second, size, 1e-12 * size);
    EXPECT_LE(size, last_) << "the largest come first";
    last_ = size;
    sizes_.erase(found);
  }
  /// REQUIRES that all listed ones were taken.
  void expect_smaller_rest() const {
    for (const auto& [id, size] : sizes_) EXPECT_LE(size, last_ * (1 + 1e-12));
  }

 private:
  std::map<Id, double> sizes_;
  double last_ = std::numeric_limits<double>::infinity();
};

/// The listed defects are the largest of their rules, or for M6 the first, and point at what is wrong. The sizes of M7 are compared
/// elsewhere (approx_overlap_test.cc): their order is approximate.
inline void expect_right_defects(const TriangleMesh& mesh, const ListedReport& r,
                                 const oracle::BruteDecision& b, std::size_t max_defects) {
  std::array<std::size_t, kNumMeshRules> listed{};
  std::size_t last_rule = 0;
  std::set<std::vector<std::uint32_t>> pairs;                    // of M7
  std::array<LargestOf<std::vector<std::uint32_t>>, 5> largest;  // M1 to M5
  const auto corners = [&](std::uint32_t f) { return std::vector(mesh.faces[f].begin(), mesh.faces[f].end()); };
  const auto add_edge = [&](MeshRule rule, const oracle::Edge& e) {
    largest[rule_index(rule)].add({e.first, e.second}, approx_size(mesh, {e.first, e.second}));
  };
  for (const std::uint32_t f : b.degenerate) largest[0].add({f}, approx_size(mesh, corners(f)));
  for (const auto& [f, g] : b.topology.duplicate_pairs) largest[1].add({f, g}, approx_size(mesh, corners(g)));
  for (const oracle::Edge& e : b.topology.boundary) add_edge(MeshRule::kM3, e);
  for (const oracle::Edge& e : b.topology.nonmanifold) add_edge(MeshRule::kM4, e);
  for (const auto& m : b.topology.misoriented) add_edge(MeshRule::kM5, m.second);
  for (const Finding& d : r.defects) {
    const std::size_t rule = rule_index(rule_of(d));
    EXPECT_GE(rule, last_rule) << "defects are ordered by rule";
    last_rule = rule;
    const std::size_t i = listed[rule]++;
    EXPECT_FALSE(d.message.empty());
    EXPECT_GE(d.place.size, 0);
    const auto& t = b.topology;
    switch (rule_of(d)) {
      case MeshRule::kM1:
      case MeshRule::kM2: largest[rule].take(d.place.faces, d.place.size); break;
      case MeshRule::kM3:
      case MeshRule::kM4:
      case MeshRule::kM5: {
        const auto& [v, w] = d.place.edges.at(0);
        largest[rule].take({v, w}, d.place.size);
        EXPECT_EQ(d.witness.ends->at(0).at[0], Rational::from_double(mesh.positions[v].x));
        EXPECT_EQ(d.witness.ends->at(1).at[2], Rational::from_double(mesh.positions[w].z));
        break;
      }
      case MeshRule::kM6: EXPECT_EQ(d.place.vertices, (std::vector<std::uint32_t>{t.pinched[i]})); break;
      case MeshRule::kM7:
        EXPECT_TRUE(std::binary_search(b.improper.begin(), b.improper.end(),
                                       FacetPair{d.place.faces.at(0), d.place.faces.at(1)}));
        EXPECT_TRUE(pairs.insert(d.place.faces).second) << "a pair is listed once";
        for (std::uint32_t f : d.place.faces) EXPECT_TRUE(is_in_face(mesh, f, *d.witness.point)) << f;
        break;
      case MeshRule::kM8:
      case MeshRule::kM9: EXPECT_TRUE(is_in_face(mesh, d.place.faces[0], *d.witness.point)); break;
    }
  }
  if (max_defects > 0)
    for (const auto& rest : largest) rest.expect_smaller_rest();
  for (std::size_t k = 0; k < kNumMeshRules; ++k) EXPECT_EQ(listed[k], std::min<std::uint64_t>(max_defects, r.rule_counts[k])) << "M" << k + 1;
}

/// Everything that decide_validity says about the model, by brute force.
inline ListedReport expect_as_brute_force(const TriangleMesh& mesh, unsigned jobs = 1,
                                          std::size_t max_defects = 20) {
  const bool failed_before = ::testing::Test::HasFailure();
  const ListedReport r = decide(mesh, jobs, max_defects);
  const oracle::BruteDecision b = oracle::brute_decide(mesh);
  const std::string got = summary(r), want = summary(mesh, b);
  EXPECT_EQ(got, want) << shapes::to_text(mesh);
  if (got != want) return r;
  EXPECT_EQ(r.nesting_decided, b.depths.has_value());
  expect_right_defects(mesh, r, b, max_defects);
  if (!failed_before && ::testing::Test::HasFailure()) ADD_FAILURE() << "model: " << shapes::to_text(mesh);
  return r;
}

/// A second report says the same, defects and certificate hints included.
inline void expect_same_report(const ListedReport& a, const ListedReport& b) {
  EXPECT_EQ(summary(a), summary(b));
  EXPECT_EQ(full_text(a) == full_text(b), true);
}

}  // namespace veritope
