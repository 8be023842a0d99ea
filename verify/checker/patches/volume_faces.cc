// SPDX-License-Identifier: Apache-2.0 OR MIT
// volume_faces.cc: docs/certificates/reading-rule-faces.md: volumes, their hands and faces, faces without area.
#include "volume_faces.h"

namespace {

const uint64_t kMostPlaces = 1000;  // of the second list of section 2

void check_axis(const Entity& e, size_t axis) {
  const std::vector<Ratio>& t = e.knots[axis];
  const size_t p = size_t(e.degrees[axis]), n = t.size() - p - 1;
  for (const Ratio& x : t)
    expect(std::max(x.n.bits(), x.d.bits()) <= kMostKnotBits,
           "a knot has numbers of more than 2048 bits");
  expect(compare(t[0], t[p]) == 0 && compare(t[n], t.back()) == 0,
         "the knots of an axis do not begin and end with degree + 1 equal ones");
  for (size_t i = p + 1; i + p < n; ++i)
    expect(compare(t[i], t[i + p]) != 0, "an inner knot occurs more often than the degree");
}

// The homogeneous control point in integers, up to a positive factor.
std::vector<Big> integers(const Entity& e, uint64_t point) {
  Big common = 1;
  for (size_t c = 0; c < size_t(e.components); ++c) {
    const Big& d = e.number(point, c).d;
    common = common * divide(d, gcd(common, d), nullptr);
  }
  std::vector<Big> r(4, common);
  for (size_t c = 0; c < size_t(e.components); ++c)
    r[c] = e.number(point, c).n * divide(common, e.number(point, c).d, nullptr);
  for (const Big& x : r)
    expect(std::max(x.bits(), common.bits()) <= kMostBits,
           "a control point has numbers of more than 8192 bits");
  return r;
}

struct Volume {
  const Entity& e;
  uint64_t n[3];

  explicit Volume(const Entity& entity) : e(entity) {
    for (size_t a = 0; a < 3; ++a) n[a] = e.points_along(a);
  }
  uint64_t at(const uint64_t* i) const { return (i[0] * n[1] + i[1]) * n[2] + i[2]; }

  // The sign of the determinant of the vectors from a control point to its neighbours, step[a] away along each axis.
  int sign(const uint64_t* i, const int* step) const {
    const std::vector<Big> origin = integers(e, at(i));
    Big v[3][3];
    for (int a = 0; a < 3; ++a) {
      uint64_t j[3] = {i[0], i[1], i[2]};
      j[a] += uint64_t(int64_t(step[a]));
      const std::vector<Big> to = integers(e, at(j));
      for (size_t c = 0; c < 3; ++c) v[a][c] = to[c] * origin[3] - origin[c] * to[3];
    }
    Big det;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, f = (c + 2) % 3;
      det = det + v[0][c] * (v[1][d] * v[2][f] - v[1][f] * v[2][d]);
    }
    return det.sign();
  }
  int hand() const {
    int found = 0;
    for (int corner = 0; corner < 8; ++corner) {
      uint64_t i[3];
      int step[3], turns = 1;
      for (int a = 0; a < 3; ++a) {
        const bool is_end = (corner >> a & 1) != 0;
        i[a] = is_end ? n[a] - 1 : 0;
        step[a] = is_end ? -1 : 1;
        turns *= step[a];
      }
      const int s = sign(i, step) * turns;
      expect(s * found >= 0, "the volume is folded: its corners have different hands");
      if (s != 0) found = s;
    }
    if (found != 0) return found;
    const uint64_t u = n[0] - 1, v = n[1] - 1, w = n[2] - 1;
    const int step[3] = {1, 1, 1};
    for (uint64_t k = 0; k < std::min(kMostPlaces, u * v * w); ++k) {
      const uint64_t i[3] = {k % u, k / u % v, k / u / v};
      if (const int s = sign(i, step)) return s;
    }
    return 1;
  }
};

// Leaves out the coordinates from the fourth on.
void leave_out_attributes(Entity* e) {
  const size_t weight = size_t(e->components) - e->is_rational;
  for (uint64_t i = 0; i < e->places.size(); ++i)
    for (size_t c = 3; c < weight; ++c)
      expect(std::max(e->number(i, c).n.bits(), e->number(i, c).d.bits()) <= kMostBits,
             "an attribute has a number of more than 8192 bits");
  e->left_out = weight - 3;
  e->components -= int64_t(e->left_out);
}

// Calls use(entity) for each entity after section 1 was tested for it, and its attributes were left out.
template <class Use>
void each_volume(std::vector<Entity>* volumes, Use use) {
  for (size_t v = 0; v < volumes->size(); ++v) try {
      Entity& e = (*volumes)[v];
      expect(e.is_volume() && e.components - e.is_rational >= 3,
             "not a volume with at least three coordinates");
      leave_out_attributes(&e);
      for (size_t a = 0; a < 3; ++a) check_axis(e, a);
      for (uint64_t i = 0; i < e.places.size(); ++i) integers(e, i);
      use(e);
    } catch (const Refused& refused) {
      throw Refused{"entity " + std::to_string(v) + ": " + refused.why};
    }
}

// Q_a w_b = Q_c w_d, for control points of a face.
bool are_equal(const Entity& e, uint64_t a, uint64_t b, uint64_t c, uint64_t d) {
  const Ratio one = Ratio(Big(1));
  const auto number = [&](uint64_t point, size_t component) -> const Ratio& {
    return component < size_t(e.components) ? e.number(point, component) : one;
  };
  for (size_t k = 0; k < 4; ++k) {
    const Ratio &p = number(a, k), &q = number(b, 3), &r = number(c, k), &s = number(d, 3);
    if (&p == &r && &q == &s) continue;
    if (!(p.n * q.n * r.d * s.d == r.n * s.n * p.d * q.d)) return false;
  }
  return true;
}
bool has_area(const Entity& e) {
  const uint64_t row = e.points_along(1);
  bool is_point = true, is_row = true, is_column = true;
  for (uint64_t k = 0; k < e.places.size() && (is_point || is_row || is_column); ++k) {
    const uint64_t first = k - k % row;  // (i, 0)
    is_point = is_point && are_equal(e, k, 0, 0, k);
    is_row = is_row && are_equal(e, k, 0, k % row, first);
    is_column = is_column && are_equal(e, k, 0, first, k % row);
  }
  return !is_point && !is_row && !is_column;
}

}  // namespace

const size_t kParametersOfFaces[6][2] = {{2, 1}, {1, 2}, {0, 2}, {2, 0}, {1, 0}, {0, 1}};

Entity face_of_volume(const Entity& e, size_t number, bool is_right_handed) {
  const size_t across = number / 2, *const p = kParametersOfFaces[number];
  const size_t first = p[!is_right_handed], second = p[is_right_handed];
  Entity r;
  r.kind = Entity::kSurface;
  r.is_rational = e.is_rational;
  r.components = e.components;
  r.left_out = e.left_out;
  r.degrees = {e.degrees[first], e.degrees[second]};
  r.knots = {e.knots[first], e.knots[second]};
  r.numbers = e.numbers;
  uint64_t i[3], n[3];
  for (size_t a = 0; a < 3; ++a) n[a] = e.points_along(a);
  i[across] = number % 2 == 0 ? 0 : n[across] - 1;
  for (i[first] = 0; i[first] < n[first]; ++i[first])
    for (i[second] = 0; i[second] < n[second]; ++i[second])
      r.places.push_back(e.places[(i[0] * n[1] + i[1]) * n[2] + i[2]]);
  return r;
}

std::vector<Entity> volumes_in_space(std::vector<Entity> volumes) {
  each_volume(&volumes, [](const Entity&) {});
  return volumes;
}

std::vector<Entity> boundary_faces(std::vector<Entity> volumes) {
  std::vector<Entity> faces, r;
  each_volume(&volumes, [&](const Entity& e) {
    const Volume volume(e);
    const int hand = volume.hand();
    for (size_t number = 0; number < 6; ++number) {
      faces.push_back(face_of_volume(e, number, hand > 0));
      if (!has_area(faces.back())) faces.pop_back();
    }
  });
  const std::vector<bool> is_wall = are_walls(faces);
  for (size_t f = 0; f < faces.size(); ++f)
    if (!is_wall[f]) r.push_back(std::move(faces[f]));
  if (r.empty()) throw Refused{"no boundary face is left: all are walls, or without area"};
  return r;
}
