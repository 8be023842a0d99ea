// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/brute_force.h: the rules M1-M9 and all counts, computed directly from their definitions: maps of edges,
// breadth-first searches, all pairs, rational rays. For models of at most a few hundred facets.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "robust/rational.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::oracle {

using Faces = std::vector<std::array<std::uint32_t, 3>>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // lesser id first

struct BruteEdge {
  std::vector<std::uint32_t> up, down;  // faces that run from the lesser to the greater id, and the other way
};

struct BruteTopology {
  std::set<std::uint32_t> vertices;  // vertices of faces whose three ids differ
  std::map<Edge, BruteEdge> edges;
  std::vector<std::uint32_t> collapsed;
  std::vector<Edge> boundary, nonmanifold;
  std::vector<std::pair<Edge, Edge>> misoriented;  // undirected, and the direction that is used twice
  std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> fans;  // of each vertex: faces by fan, by least face
  std::vector<std::uint32_t> pinched;                                     // vertices of more than one fan
  std::vector<std::uint32_t> irregular;                                   // vertices that are not one closed, oriented fan
  std::vector<std::vector<std::uint32_t>> shells;                         // ascending faces, by least face
  bool is_cycle = true;
  std::size_t duplicates = 0;                                             // faces with the same ids as an earlier one
  std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicate_pairs;   // (first, later)
};
BruteTopology brute_topology(const Faces& faces);

struct BruteDecision {
  BruteTopology topology;
  std::vector<std::uint32_t> degenerate;                              // repeated ids or collinear corners
  std::vector<std::pair<std::uint32_t, std::uint32_t>> improper;      // ascending pairs
  std::optional<std::vector<Rational>> volumes;                       // the shells', if the model is a cycle
  std::optional<std::vector<std::uint32_t>> depths;                   // if M1-M7 hold
  std::array<std::uint64_t, 9> rules{};                               // counts of M1..M9
  std::optional<std::int64_t> genus;                                  // if M1-M6 hold
  std::optional<std::uint64_t> bodies;
  bool is_valid = false;
};
BruteDecision brute_decide(const TriangleMesh& mesh, std::uint64_t seed = 1);

/// All pairs of non-degenerate facets that meet outside their common simplex, ascending.
std::vector<std::pair<std::uint32_t, std::uint32_t>> brute_improper(const TriangleMesh& mesh);
std::vector<std::uint32_t> brute_degenerate(const TriangleMesh& mesh);

}  // namespace veritope::oracle
