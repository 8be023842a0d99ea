// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/tetrahedral_flips.h"

#include <algorithm>
#include <cstddef>

namespace veritope {
namespace {

constexpr TetrahedronFace kOutside = LinkedTetrahedra::kNoFace;

bool has_corner(const LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t v) {
  const TetrahedronCorners& c = complex.corners(t);
  return std::find(c.begin(), c.end(), v) != c.end();
}

std::uint32_t place_of(const LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t v) {
  const TetrahedronCorners& c = complex.corners(t);
  return static_cast<std::uint32_t>(std::find(c.begin(), c.end(), v) - c.begin());
}

// Is there a tetrahedron at v, found from t, with all of the others as corners, too?
bool are_joined(const LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t v,
                std::span<const std::uint32_t> others) {
  for (const std::uint32_t s : tetrahedra_around(complex, t, v))
    if (std::all_of(others.begin(), others.end(),
                    [&](std::uint32_t w) { return has_corner(complex, s, w); }))
      return true;
  return false;
}

bool is_closed_ring(const LinkedTetrahedra& complex, std::span<const std::uint32_t> ring,
                    std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t t : ring)
    for (std::uint32_t m = 0; m < 4; ++m) {
      const std::uint32_t corner = complex.corners(t)[m];
      if (corner != a && corner != b && complex.across(4 * t + m) == kOutside) return false;
    }
  return true;
}

}  // namespace

std::vector<TetrahedronFace> shell_of(const LinkedTetrahedra& complex,
                                      std::span<const std::uint32_t> ball) {
  std::vector<TetrahedronFace> out;
  for (const std::uint32_t t : ball)
    for (std::uint32_t m = 0; m < 4; ++m) {
      const TetrahedronFace across = complex.across(4 * t + m);
      if (across == kOutside ||
          std::find(ball.begin(), ball.end(), face_tetrahedron(across)) == ball.end())
        out.push_back(4 * t + m);
    }
  return out;
}

std::vector<std::uint32_t> tetrahedra_around(const LinkedTetrahedra& complex, std::uint32_t t,
                                             std::uint32_t a, std::uint32_t b) {
  const auto walk = [&](std::uint32_t leave) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t s = t;;) {
      out.push_back(s);
      const TetrahedronFace next = complex.across(4 * s + leave);
      if (next == kOutside) return out;
      s = face_tetrahedron(next);
      if (s == t) return out;
      leave = 6 - place_of(complex, s, a) - place_of(complex, s, b) - face_corner(next);
    }
  };
  std::array<std::uint32_t, 2> ways{};
  std::size_t count = 0;
  for (std::uint32_t m = 0; m < 4; ++m)
    if (complex.corners(t)[m] != a && complex.corners(t)[m] != b) ways[count++] = m;
  std::vector<std::uint32_t> out = walk(ways[0]);
  if (is_closed_ring(complex, out, a, b)) return out;
  const std::vector<std::uint32_t> back = walk(ways[1]);
  std::reverse(out.begin(), out.end());
  out.insert(out.end(), back.begin() + 1, back.end());
  return out;
}

std::vector<std::uint32_t> tetrahedra_around(const LinkedTetrahedra& complex, std::uint32_t t,
                                             std::uint32_t v) {
  std::vector<std::uint32_t> out{t};
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::uint32_t m = 0; m < 4; ++m) {
      if (complex.corners(out[i])[m] == v) continue;
      const TetrahedronFace across = complex.across(4 * out[i] + m);
      if (across == kOutside) continue;
      if (std::find(out.begin(), out.end(), face_tetrahedron(across)) == out.end())
        out.push_back(face_tetrahedron(across));
    }
  return out;
}

void insert_in_tetrahedron(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t vertex) {
  const std::array<std::uint32_t, 1> ball{t};
  complex.cone(ball, shell_of(complex, ball), vertex);
}

void insert_in_face(LinkedTetrahedra& complex, TetrahedronFace f, std::uint32_t vertex) {
  std::vector<std::uint32_t> ball{face_tetrahedron(f)};
  const TetrahedronFace across = complex.across(f);
  if (across != kOutside) ball.push_back(face_tetrahedron(across));
  std::vector<TetrahedronFace> shell = shell_of(complex, ball);
  if (across == kOutside) std::erase(shell, f);
  complex.replace_by_cone(ball, shell, vertex);
}

void insert_in_edge(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t a, std::uint32_t b,
                    std::uint32_t vertex) {
  const std::vector<std::uint32_t> ball = tetrahedra_around(complex, t, a, b);
  std::vector<TetrahedronFace> shell = shell_of(complex, ball);
  std::erase_if(shell, [&](TetrahedronFace f) {  // faces of the boundary that the vertex lies in
    const auto v = complex.vertices(f);
    return std::find(v.begin(), v.end(), a) != v.end() &&
           std::find(v.begin(), v.end(), b) != v.end();
  });
  complex.replace_by_cone(ball, shell, vertex);
}

std::optional<FlipFault> flip_2_3(LinkedTetrahedra& complex, TetrahedronFace f) {
  const TetrahedronFace across = complex.across(f);
  if (across == kOutside) return FlipFault::kBoundary;
  const std::array<std::uint32_t, 2> ball{face_tetrahedron(f), face_tetrahedron(across)};
  const std::uint32_t d = complex.corners(ball[0])[face_corner(f)];
  const std::array<std::uint32_t, 1> e{complex.corners(ball[1])[face_corner(across)]};
  if (d == e[0] || are_joined(complex, ball[0], d, e)) return FlipFault::kEdgeExists;
  complex.replace_by_cone(ball, shell_of(complex, ball), d);
  return std::nullopt;
}

std::optional<FlipFault> flip_3_2(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t a,
                                  std::uint32_t b) {
  const std::vector<std::uint32_t> ball = tetrahedra_around(complex, t, a, b);
  if (!is_closed_ring(complex, ball, a, b)) return FlipFault::kBoundary;
  if (ball.size() != 3) return FlipFault::kWrongCount;
  std::vector<std::uint32_t> link;
  for (const std::uint32_t s : ball)
    for (const std::uint32_t v : complex.corners(s))
      if (v != a && v != b && std::find(link.begin(), link.end(), v) == link.end())
        link.push_back(v);
  const std::array<std::uint32_t, 2> others{link[1], link[2]};
  std::uint32_t at = ball[0];
  for (const std::uint32_t s : ball)
    if (has_corner(complex, s, link[0])) at = s;
  if (are_joined(complex, at, link[0], others)) return FlipFault::kEdgeExists;
  complex.replace_by_cone(ball, shell_of(complex, ball), link[0]);
  return std::nullopt;
}

std::optional<FlipFault> flip_4_4(LinkedTetrahedra& complex, std::uint32_t t, std::uint32_t a,
                                  std::uint32_t b, std::uint32_t c) {
  const std::vector<std::uint32_t> ball = tetrahedra_around(complex, t, a, b);
  if (!is_closed_ring(complex, ball, a, b)) return FlipFault::kBoundary;
  if (ball.size() != 4) return FlipFault::kWrongCount;
  // The opposite corner of the link shares no tetrahedron of the ring with c.
  std::array<std::uint32_t, 1> opposite{c};
  for (const std::uint32_t s : ball)
    for (const std::uint32_t v : complex.corners(s)) {
      if (v == a || v == b) continue;
      const bool is_beside = std::any_of(ball.begin(), ball.end(), [&](std::uint32_t r) {
        return has_corner(complex, r, v) && has_corner(complex, r, c);
      });
      if (!is_beside) opposite[0] = v;
    }
  if (opposite[0] == c || are_joined(complex, t, c, opposite)) return FlipFault::kEdgeExists;
  complex.replace_by_cone(ball, shell_of(complex, ball), c);
  return std::nullopt;
}

std::optional<FlipFault> flip_4_1(LinkedTetrahedra& complex, std::uint32_t t,
                                  std::uint32_t vertex) {
  const std::vector<std::uint32_t> ball = tetrahedra_around(complex, t, vertex);
  if (ball.size() != 4) return FlipFault::kWrongCount;
  const std::vector<TetrahedronFace> shell = shell_of(complex, ball);
  for (const TetrahedronFace f : shell) {
    const auto v = complex.vertices(f);
    if (std::find(v.begin(), v.end(), vertex) != v.end()) return FlipFault::kBoundary;
  }
  // A tetrahedron on the other side with the same four corners.
  const auto first = complex.vertices(shell[0]);
  std::vector<std::uint32_t> link(first.begin(), first.end());
  for (const TetrahedronFace f : shell)
    for (const std::uint32_t v : complex.vertices(f))
      if (std::find(link.begin(), link.end(), v) == link.end()) link.push_back(v);
  const TetrahedronFace across = complex.across(shell[0]);
  if (across != kOutside && std::all_of(link.begin(), link.end(), [&](std::uint32_t v) {
        return has_corner(complex, face_tetrahedron(across), v);
      }))
    return FlipFault::kEdgeExists;
  complex.replace_by_cone(ball, shell, link[0]);
  return std::nullopt;
}

}  // namespace veritope
