// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_meeting.cc: B1 to B3, M1 and M2 of docs/certificates/patch-invalid-2.md, and the claim as a whole.
#include "invalid.h"
#include "patch_claims.h"

namespace {

struct MeetingReader : InvalidBytes {
  MeetingReader(const std::vector<Entity>& entities, const char* magic, const Body& bytes)
      : InvalidBytes(entities, magic, true, bytes) {}
  Fraction number() {
    const uint64_t n = varint(), d = varint();
    require(d >= 1, "B1", "a parameter's denominator is 0");
    require(n <= d, "B1", "a parameter is greater than 1: its denominator is", d);
    return Fraction{int64_t(n), int64_t(d)};
  }
  PatchPoint place() {
    PatchPoint r;
    r.patch = patch();
    for (Fraction& t : r.t) t = number();
    return r;
  }
};

// Reason (a) of M1: A is in the open domain of its patch, and B is another point.
bool is_inside_and_another(const PatchPoint& a, const PatchPoint& b, bool b_is_triangle) {
  for (const Fraction& t : a.t)
    if (t.n == 0 || t.n == t.d) return false;
  if (b_is_triangle && b.t[0].n == 0) return false;
  return a.patch != b.patch || !are_equal(a.t[0], b.t[0]) || !are_equal(a.t[1], b.t[1]);
}

// The value at t of a row of this many coefficients, each of the same number of numbers, times a positive factor.
std::vector<Big> value(std::vector<Big> row, size_t points, const Fraction& t) {
  const size_t n = row.size() / points;
  const Big at = t.n, rest = t.d - t.n;
  for (size_t left = points - 1; left > 0; --left)
    for (size_t i = 0; i < n * left; ++i) row[i] = rest * row[i] + at * row[i + n];
  row.resize(n);
  return row;
}
std::vector<Big> image(const Patch& patch, const PatchPoint& at) {  // homogeneous
  const size_t rows = size_t(patch.shape.p) + 1, columns = size_t(patch.shape.q) + 1;
  return value(value(tensor_net(patch), rows, at.t[0]), columns, at.t[1]);
}

}  // namespace

void check_finding_2(const Statement& s) {
  require(s.text.at("finding") == "meeting", "S1", "unknown finding");
}

std::string check_patch_invalid_2(const Statement& s, std::string model, const Body& bytes) {
  const std::vector<Entity> entities = read_spline_model(model, s.text.at("subject_format"));
  MeetingReader r(entities, s.claim->magic, bytes);
  const PatchPoint a = r.place(), b = r.place();
  r.end();

  check_kinds_and_knots(entities);
  const Patch of_a = cut_patch(r.cuts, a.patch), of_b = cut_patch(r.cuts, b.patch);
  check_numbers_of_patches(s, r.cuts);
  if (!is_inside_and_another(a, b, of_b.shape.is_triangle))
    check_points_of_x(r.cuts, a, b, s.number.at("subject_bytes") + bytes.left());
  const std::vector<Big> x = image(of_a, a), y = image(of_b, b);
  for (size_t k = 0; k < 3; ++k)
    require(x[k] * y[3] == y[k] * x[3], "M2", "A and B have different images, on axis", k);
  return std::to_string(r.cuts.patches()) + " patches, one image of patches " +
         std::to_string(a.patch) + " and " + std::to_string(b.patch);
}
