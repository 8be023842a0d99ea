// SPDX-License-Identifier: LGPL-3.0-or-later
// The formulas of docs/bounds/gappa/*.formula, from which the proofs are made, and those of the code: the same doubles.
// Made by tools/generate_predicates.py from docs/bounds/gappa/*.formula: do not edit.
// clang-format off
#include "predicates/formulas.h"
#include "predicates/implicit_formulas.h"
#include "predicates/orient3d.h"
#include "solids/polyhedron/normal_along.h"
#include "solids/polyhedron/separator.h"
#include "tests/predicates/generated/same_formulas.h"

namespace veritope::page {
using formulas::sqr;

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto compare_along_det(
    const auto& rx, const auto& ry, const auto& rz, const auto& d_x, const auto& d_y,
    const auto& d_z) {
  return (d_x * rx + d_y * ry) + d_z * rz;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto compare_along_magnitude(
    [[maybe_unused]] Abs abs, const auto& rx, const auto& ry, const auto& rz, const auto& d_x,
    const auto& d_y, const auto& d_z) {
  return (abs(d_x * rx) + abs(d_y * ry)) + abs(d_z * rz);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T compare_along_of(const std::array<T, 9>& v) {
  return compare_along_det(v[3] - v[6], v[4] - v[7], v[5] - v[8], v[0], v[1], v[2]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto implicit_line_plane_det(
    const auto& ux, const auto& uy, const auto& uz, const auto& vx, const auto& vy, const auto& vz,
    const auto& wx, const auto& wy, const auto& wz, const auto& gx, const auto& gy, const auto& gz,
    const auto& ex, const auto& ey, const auto& ez, const auto& v1x, const auto& v1y,
    const auto& v1z, const auto& w1x, const auto& w1y, const auto& w1z) {
  const auto nx = vy * wz - vz * wy;
  const auto ny = vz * wx - vx * wz;
  const auto nz = vx * wy - vy * wx;
  const auto mx = v1y * w1z - v1z * w1y;
  const auto my = v1z * w1x - v1x * w1z;
  const auto mz = v1x * w1y - v1y * w1x;
  const auto ng = (nx * gx + ny * gy) + nz * gz;
  const auto xn = ng * ux;
  const auto yn = ng * uy;
  const auto zn = ng * uz;
  const auto den = (nx * ux + ny * uy) + nz * uz;
  return ((xn * mx + yn * my) + zn * mz) + den * ((ex * mx + ey * my) + ez * mz);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto implicit_line_plane_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& uz, const auto& vx,
    const auto& vy, const auto& vz, const auto& wx, const auto& wy, const auto& wz, const auto& gx,
    const auto& gy, const auto& gz, const auto& ex, const auto& ey, const auto& ez, const auto& v1x,
    const auto& v1y, const auto& v1z, const auto& w1x, const auto& w1y, const auto& w1z) {
  const auto nx_ = abs(vy * wz) + abs(vz * wy);
  const auto ny_ = abs(vz * wx) + abs(vx * wz);
  const auto nz_ = abs(vx * wy) + abs(vy * wx);
  const auto mx_ = abs(v1y * w1z) + abs(v1z * w1y);
  const auto my_ = abs(v1z * w1x) + abs(v1x * w1z);
  const auto mz_ = abs(v1x * w1y) + abs(v1y * w1x);
  const auto ng_ = (nx_ * abs(gx) + ny_ * abs(gy)) + nz_ * abs(gz);
  const auto xn_ = ng_ * abs(ux);
  const auto yn_ = ng_ * abs(uy);
  const auto zn_ = ng_ * abs(uz);
  const auto den_ = (nx_ * abs(ux) + ny_ * abs(uy)) + nz_ * abs(uz);
  return ((xn_ * mx_ + yn_ * my_) + zn_ * mz_) + den_ * ((abs(ex) * mx_ +
      abs(ey) * my_) + abs(ez) * mz_);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T implicit_line_plane_of(const std::array<T, 24>& v) {
  return implicit_line_plane_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[9] - v[6], v[10] - v[7], v[11] - v[8], v[12] - v[6],
      v[13] - v[7], v[14] - v[8], v[6] - v[0], v[7] - v[1], v[8] - v[2], v[0] - v[15], v[1] - v[16],
      v[2] - v[17], v[18] - v[15], v[19] - v[16], v[20] - v[17], v[21] - v[15], v[22] - v[16],
      v[23] - v[17]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto implicit_three_planes_det(
    const auto& v1x, const auto& v1y, const auto& v1z, const auto& w1x, const auto& w1y,
    const auto& w1z, const auto& v2x, const auto& v2y, const auto& v2z, const auto& w2x,
    const auto& w2y, const auto& w2z, const auto& g2x, const auto& g2y, const auto& g2z,
    const auto& v3x, const auto& v3y, const auto& v3z, const auto& w3x, const auto& w3y,
    const auto& w3z, const auto& g3x, const auto& g3y, const auto& g3z, const auto& ex,
    const auto& ey, const auto& ez, const auto& vx, const auto& vy, const auto& vz, const auto& wx,
    const auto& wy, const auto& wz) {
  const auto n1x = v1y * w1z - v1z * w1y;
  const auto n1y = v1z * w1x - v1x * w1z;
  const auto n1z = v1x * w1y - v1y * w1x;
  const auto n2x = v2y * w2z - v2z * w2y;
  const auto n2y = v2z * w2x - v2x * w2z;
  const auto n2z = v2x * w2y - v2y * w2x;
  const auto n3x = v3y * w3z - v3z * w3y;
  const auto n3y = v3z * w3x - v3x * w3z;
  const auto n3z = v3x * w3y - v3y * w3x;
  const auto c31x = n3y * n1z - n3z * n1y;
  const auto c31y = n3z * n1x - n3x * n1z;
  const auto c31z = n3x * n1y - n3y * n1x;
  const auto c12x = n1y * n2z - n1z * n2y;
  const auto c12y = n1z * n2x - n1x * n2z;
  const auto c12z = n1x * n2y - n1y * n2x;
  const auto h2 = (n2x * g2x + n2y * g2y) + n2z * g2z;
  const auto h3 = (n3x * g3x + n3y * g3y) + n3z * g3z;
  const auto xn = h2 * c31x + h3 * c12x;
  const auto yn = h2 * c31y + h3 * c12y;
  const auto zn = h2 * c31z + h3 * c12z;
  const auto den = (n2x * c31x + n2y * c31y) + n2z * c31z;
  const auto mx = vy * wz - vz * wy;
  const auto my = vz * wx - vx * wz;
  const auto mz = vx * wy - vy * wx;
  return ((xn * mx + yn * my) + zn * mz) + den * ((ex * mx + ey * my) + ez * mz);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto implicit_three_planes_magnitude(
    [[maybe_unused]] Abs abs, const auto& v1x, const auto& v1y, const auto& v1z, const auto& w1x,
    const auto& w1y, const auto& w1z, const auto& v2x, const auto& v2y, const auto& v2z,
    const auto& w2x, const auto& w2y, const auto& w2z, const auto& g2x, const auto& g2y,
    const auto& g2z, const auto& v3x, const auto& v3y, const auto& v3z, const auto& w3x,
    const auto& w3y, const auto& w3z, const auto& g3x, const auto& g3y, const auto& g3z,
    const auto& ex, const auto& ey, const auto& ez, const auto& vx, const auto& vy, const auto& vz,
    const auto& wx, const auto& wy, const auto& wz) {
  const auto n1x_ = abs(v1y * w1z) + abs(v1z * w1y);
  const auto n1y_ = abs(v1z * w1x) + abs(v1x * w1z);
  const auto n1z_ = abs(v1x * w1y) + abs(v1y * w1x);
  const auto n2x_ = abs(v2y * w2z) + abs(v2z * w2y);
  const auto n2y_ = abs(v2z * w2x) + abs(v2x * w2z);
  const auto n2z_ = abs(v2x * w2y) + abs(v2y * w2x);
  const auto n3x_ = abs(v3y * w3z) + abs(v3z * w3y);
  const auto n3y_ = abs(v3z * w3x) + abs(v3x * w3z);
  const auto n3z_ = abs(v3x * w3y) + abs(v3y * w3x);
  const auto c31x_ = n3y_ * n1z_ + n3z_ * n1y_;
  const auto c31y_ = n3z_ * n1x_ + n3x_ * n1z_;
  const auto c31z_ = n3x_ * n1y_ + n3y_ * n1x_;
  const auto c12x_ = n1y_ * n2z_ + n1z_ * n2y_;
  const auto c12y_ = n1z_ * n2x_ + n1x_ * n2z_;
  const auto c12z_ = n1x_ * n2y_ + n1y_ * n2x_;
  const auto h2_ = (n2x_ * abs(g2x) + n2y_ * abs(g2y)) + n2z_ * abs(g2z);
  const auto h3_ = (n3x_ * abs(g3x) + n3y_ * abs(g3y)) + n3z_ * abs(g3z);
  const auto xn_ = h2_ * c31x_ + h3_ * c12x_;
  const auto yn_ = h2_ * c31y_ + h3_ * c12y_;
  const auto zn_ = h2_ * c31z_ + h3_ * c12z_;
  const auto den_ = (n2x_ * c31x_ + n2y_ * c31y_) + n2z_ * c31z_;
  const auto mx_ = abs(vy * wz) + abs(vz * wy);
  const auto my_ = abs(vz * wx) + abs(vx * wz);
  const auto mz_ = abs(vx * wy) + abs(vy * wx);
  return ((xn_ * mx_ + yn_ * my_) + zn_ * mz_) + den_ * ((abs(ex) * mx_ +
      abs(ey) * my_) + abs(ez) * mz_);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T implicit_three_planes_of(const std::array<T, 36>& v) {
  return implicit_three_planes_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[6] - v[0], v[7] - v[1], v[8] - v[2], v[12] - v[9],
      v[13] - v[10], v[14] - v[11], v[15] - v[9], v[16] - v[10], v[17] - v[11], v[9] - v[0],
      v[10] - v[1], v[11] - v[2], v[21] - v[18], v[22] - v[19], v[23] - v[20], v[24] - v[18],
      v[25] - v[19], v[26] - v[20], v[18] - v[0], v[19] - v[1], v[20] - v[2], v[0] - v[27],
      v[1] - v[28], v[2] - v[29], v[30] - v[27], v[31] - v[28], v[32] - v[29], v[33] - v[27],
      v[34] - v[28], v[35] - v[29]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto in_circle_det(
    const auto& px, const auto& py, const auto& qx, const auto& qy, const auto& rx,
    const auto& ry) {
  return ((sqr(px) + sqr(py)) * (qx * ry - rx * qy) + (sqr(qx) + sqr(qy)) * (rx * py -
      px * ry)) + (sqr(rx) + sqr(ry)) * (px * qy - qx * py);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto in_circle_magnitude(
    [[maybe_unused]] Abs abs, const auto& px, const auto& py, const auto& qx, const auto& qy,
    const auto& rx, const auto& ry) {
  return ((sqr(px) + sqr(py)) * (abs(qx * ry) + abs(rx * qy)) + (sqr(qx) +
      sqr(qy)) * (abs(rx * py) + abs(px * ry))) + (sqr(rx) + sqr(ry)) * (abs(px * qy) +
      abs(qx * py));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T in_circle_of(const std::array<T, 8>& v) {
  return in_circle_det(
      v[0] - v[6], v[1] - v[7], v[2] - v[6], v[3] - v[7], v[4] - v[6], v[5] - v[7]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto in_sphere_det(
    const auto& px, const auto& py, const auto& pz, const auto& qx, const auto& qy, const auto& qz,
    const auto& rx, const auto& ry, const auto& rz, const auto& sx, const auto& sy,
    const auto& sz) {
  const auto pq = px * qy - qx * py;
  const auto qr = qx * ry - rx * qy;
  const auto rs = rx * sy - sx * ry;
  const auto sp = sx * py - px * sy;
  const auto pr = px * ry - rx * py;
  const auto qs = qx * sy - sx * qy;
  const auto pqr = (pz * qr - qz * pr) + rz * pq;
  const auto qrs = (qz * rs - rz * qs) + sz * qr;
  const auto rsp = (rz * sp + sz * pr) + pz * rs;
  const auto spq = (sz * pq + pz * qs) + qz * sp;
  const auto p_lift = (sqr(px) + sqr(py)) + sqr(pz);
  const auto q_lift = (sqr(qx) + sqr(qy)) + sqr(qz);
  const auto r_lift = (sqr(rx) + sqr(ry)) + sqr(rz);
  const auto s_lift = (sqr(sx) + sqr(sy)) + sqr(sz);
  return (p_lift * qrs - q_lift * rsp) + (r_lift * spq - s_lift * pqr);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto in_sphere_magnitude(
    [[maybe_unused]] Abs abs, const auto& px, const auto& py, const auto& pz, const auto& qx,
    const auto& qy, const auto& qz, const auto& rx, const auto& ry, const auto& rz, const auto& sx,
    const auto& sy, const auto& sz) {
  const auto pq_ = abs(px * qy) + abs(qx * py);
  const auto qr_ = abs(qx * ry) + abs(rx * qy);
  const auto rs_ = abs(rx * sy) + abs(sx * ry);
  const auto sp_ = abs(sx * py) + abs(px * sy);
  const auto pr_ = abs(px * ry) + abs(rx * py);
  const auto qs_ = abs(qx * sy) + abs(sx * qy);
  const auto pqr_ = (abs(pz) * qr_ + abs(qz) * pr_) + abs(rz) * pq_;
  const auto qrs_ = (abs(qz) * rs_ + abs(rz) * qs_) + abs(sz) * qr_;
  const auto rsp_ = (abs(rz) * sp_ + abs(sz) * pr_) + abs(pz) * rs_;
  const auto spq_ = (abs(sz) * pq_ + abs(pz) * qs_) + abs(qz) * sp_;
  const auto p_lift = (sqr(px) + sqr(py)) + sqr(pz);
  const auto q_lift = (sqr(qx) + sqr(qy)) + sqr(qz);
  const auto r_lift = (sqr(rx) + sqr(ry)) + sqr(rz);
  const auto s_lift = (sqr(sx) + sqr(sy)) + sqr(sz);
  return (p_lift * qrs_ + q_lift * rsp_) + (r_lift * spq_ + s_lift * pqr_);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T in_sphere_of(const std::array<T, 15>& v) {
  return in_sphere_det(
      v[0] - v[12], v[1] - v[13], v[2] - v[14], v[3] - v[12], v[4] - v[13], v[5] - v[14],
      v[6] - v[12], v[7] - v[13], v[8] - v[14], v[9] - v[12], v[10] - v[13], v[11] - v[14]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto normal_along_det(
    const auto& ux, const auto& uy, const auto& uz, const auto& vx, const auto& vy, const auto& vz,
    const auto& d_x, const auto& d_y, const auto& d_z) {
  const auto nx = uy * vz - uz * vy;
  const auto ny = uz * vx - ux * vz;
  const auto nz = ux * vy - uy * vx;
  return (d_x * nx + d_y * ny) + d_z * nz;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto normal_along_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& uz, const auto& vx,
    const auto& vy, const auto& vz, const auto& d_x, const auto& d_y, const auto& d_z) {
  const auto nx_ = abs(uy * vz) + abs(uz * vy);
  const auto ny_ = abs(uz * vx) + abs(ux * vz);
  const auto nz_ = abs(ux * vy) + abs(uy * vx);
  return (abs(d_x) * nx_ + abs(d_y) * ny_) + abs(d_z) * nz_;
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T normal_along_of(const std::array<T, 12>& v) {
  return normal_along_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[6] - v[0], v[7] - v[1], v[8] - v[2], v[9], v[10],
      v[11]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto orient2d_det(const auto& ux, const auto& uy, const auto& vx, const auto& vy) {
  return ux * vy - uy * vx;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto orient2d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& vx, const auto& vy) {
  return abs(ux * vy) + abs(uy * vx);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T orient2d_of(const std::array<T, 6>& v) {
  return orient2d_det(v[2] - v[0], v[3] - v[1], v[4] - v[0], v[5] - v[1]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto orient3d_det(
    const auto& ux, const auto& uy, const auto& uz, const auto& vx, const auto& vy, const auto& vz,
    const auto& wx, const auto& wy, const auto& wz) {
  return (wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz)) + wz * (ux * vy -
      uy * vx);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto orient3d_magnitude(
    [[maybe_unused]] Abs abs, const auto& ux, const auto& uy, const auto& uz, const auto& vx,
    const auto& vy, const auto& vz, const auto& wx, const auto& wy, const auto& wz) {
  return (abs(wx) * (abs(uy * vz) + abs(uz * vy)) + abs(wy) * (abs(uz * vx) +
      abs(ux * vz))) + abs(wz) * (abs(ux * vy) + abs(uy * vx));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T orient3d_of(const std::array<T, 12>& v) {
  return orient3d_det(
      v[3] - v[0], v[4] - v[1], v[5] - v[2], v[6] - v[0], v[7] - v[1], v[8] - v[2], v[9] - v[0],
      v[10] - v[1], v[11] - v[2]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto separator_det(
    const auto& d_x, const auto& q_x, const auto& d_y, const auto& q_y, const auto& d_z,
    const auto& q_z, const auto& p_x, const auto& p_y, const auto& p_z) {
  return ((d_x * q_x + d_y * q_y) + d_z * q_z) - ((d_x * p_x + d_y * p_y) + d_z * p_z);
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto separator_magnitude(
    [[maybe_unused]] Abs abs, const auto& d_x, const auto& q_x, const auto& d_y, const auto& q_y,
    const auto& d_z, const auto& q_z, const auto& p_x, const auto& p_y, const auto& p_z) {
  return ((abs(d_x * q_x) + abs(d_y * q_y)) + abs(d_z * q_z)) + ((abs(d_x * p_x) +
      abs(d_y * p_y)) + abs(d_z * p_z));
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T separator_of(const std::array<T, 9>& v) {
  return separator_det(v[0], v[6], v[1], v[7], v[2], v[8], v[3], v[4], v[5]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto separator_ray_det(
    const auto& rx, const auto& ry, const auto& rz, const auto& d_x, const auto& d_y,
    const auto& d_z) {
  return (d_x * rx + d_y * ry) + d_z * rz;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto separator_ray_magnitude(
    [[maybe_unused]] Abs abs, const auto& rx, const auto& ry, const auto& rz, const auto& d_x,
    const auto& d_y, const auto& d_z) {
  return (abs(d_x * rx) + abs(d_y * ry)) + abs(d_z * rz);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T separator_ray_of(const std::array<T, 9>& v) {
  return separator_ray_det(v[6] - v[3], v[7] - v[4], v[8] - v[5], v[0], v[1], v[2]);
}

/// The polynomial, of the differences of the inputs that it is made of.
constexpr auto side_of_plane_det(
    const auto& n_x, const auto& p_x, const auto& n_y, const auto& p_y, const auto& n_z,
    const auto& p_z, const auto& k) {
  return ((n_x * p_x + n_y * p_y) + n_z * p_z) + k;
}
/// The sum of its absolute terms; no term of det exceeds its term after rounding.
template <typename Abs>
constexpr auto side_of_plane_magnitude(
    [[maybe_unused]] Abs abs, const auto& n_x, const auto& p_x, const auto& n_y, const auto& p_y,
    const auto& n_z, const auto& p_z, const auto& k) {
  return ((abs(n_x * p_x) + abs(n_y * p_y)) + abs(n_z * p_z)) + abs(k);
}
/// The polynomial of the inputs, in the order of the arguments.
template <typename T>
constexpr T side_of_plane_of(const std::array<T, 7>& v) {
  return side_of_plane_det(v[0], v[4], v[1], v[5], v[2], v[6], v[3]);
}
}  // namespace veritope::page

namespace veritope {
namespace {

TEST(SameFormulas, CompareAlong) {
  on_random_operands<9>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::CompareAlong<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
    expect_same(f.det(), page::compare_along_of<double>(v));
    expect_same(f.magnitude(kAbs), page::compare_along_magnitude(kAbs, v[3] - v[6], v[4] - v[7], v[5] - v[8], v[0], v[1], v[2]));
  });
}

TEST(SameFormulas, ImplicitLinePlane) {
  on_random_operands<24>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::line_plane(from(3, 0), from(9, 6), from(12, 6), from(6, 0));
    expect_same(formulas::orientation(f, from(0, 15), from(18, 15), from(21, 15)), page::implicit_line_plane_of<double>(v));
  });
}

TEST(SameFormulas, ImplicitThreePlanes) {
  on_random_operands<36>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::three_planes<double>({from(3, 0), from(6, 0), {}}, {from(12, 9), from(15, 9), from(9, 0)}, {from(21, 18), from(24, 18), from(18, 0)});
    expect_same(formulas::orientation(f, from(0, 27), from(30, 27), from(33, 27)), page::implicit_three_planes_of<double>(v));
  });
}

TEST(SameFormulas, InCircle) {
  on_random_operands<8>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::InCircle<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
    expect_same(f.det(), page::in_circle_of<double>(v));
    expect_same(f.magnitude(kAbs), page::in_circle_magnitude(kAbs, v[0] - v[6], v[1] - v[7], v[2] - v[6], v[3] - v[7], v[4] - v[6], v[5] - v[7]));
  });
}

TEST(SameFormulas, InSphere) {
  on_random_operands<15>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::InSphere<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11], v[12], v[13], v[14]);
    expect_same(f.det(), page::in_sphere_of<double>(v));
    expect_same(f.magnitude(kAbs), page::in_sphere_magnitude(kAbs, v[0] - v[12], v[1] - v[13], v[2] - v[14], v[3] - v[12], v[4] - v[13], v[5] - v[14], v[6] - v[12], v[7] - v[13], v[8] - v[14], v[9] - v[12], v[10] - v[13], v[11] - v[14]));
  });
}

TEST(SameFormulas, NormalAlong) {
  on_random_operands<12>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::NormalAlong<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], kAbs);
    expect_same(f.det(v[9], v[10], v[11]), page::normal_along_of<double>(v));
    expect_same(f.magnitude(v[9], v[10], v[11], kAbs), page::normal_along_magnitude(kAbs, v[3] - v[0], v[4] - v[1], v[5] - v[2], v[6] - v[0], v[7] - v[1], v[8] - v[2], v[9], v[10], v[11]));
  });
}

TEST(SameFormulas, Orient2d) {
  on_random_operands<6>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::Orient2d<double>(v[0], v[1], v[2], v[3], v[4], v[5]);
    expect_same(f.det(), page::orient2d_of<double>(v));
    expect_same(f.magnitude(kAbs), page::orient2d_magnitude(kAbs, v[2] - v[0], v[3] - v[1], v[4] - v[0], v[5] - v[1]));
  });
}

TEST(SameFormulas, Orient3d) {
  on_random_operands<12>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::Plane3<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]);
    expect_same(f.det(v[9] - v[0], v[10] - v[1], v[11] - v[2]), page::orient3d_of<double>(v));
    expect_same(f.magnitude(v[9] - v[0], v[10] - v[1], v[11] - v[2], kAbs), page::orient3d_magnitude(kAbs, v[3] - v[0], v[4] - v[1], v[5] - v[2], v[6] - v[0], v[7] - v[1], v[8] - v[2], v[9] - v[0], v[10] - v[1], v[11] - v[2]));
  });
}

TEST(SameFormulas, Separator) {
  on_random_operands<9>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = 0;
    expect_same(formulas::dot3(v[0], v[1], v[2], v[6], v[7], v[8]) - formulas::dot3(v[0], v[1], v[2], v[3], v[4], v[5]), page::separator_of<double>(v));
  });
}

TEST(SameFormulas, SeparatorRay) {
  on_random_operands<9>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = 0;
    expect_same(formulas::dot3(v[0], v[1], v[2], v[6] - v[3], v[7] - v[4], v[8] - v[5]), page::separator_ray_of<double>(v));
  });
}

TEST(SameFormulas, SideOfPlane) {
  on_random_operands<7>([](const auto& v) {
    [[maybe_unused]] const auto from = [&](int to, int base) { return difference(v, to, base); };
    [[maybe_unused]] const auto f = formulas::SideOfPlane<double>(v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
    expect_same(f.det(), page::side_of_plane_of<double>(v));
    expect_same(f.magnitude(kAbs), page::side_of_plane_magnitude(kAbs, v[0], v[4], v[1], v[5], v[2], v[6], v[3]));
  });
}

}  // namespace
}  // namespace veritope
