// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "micro_net.h"

namespace {

// Rows of `inner` numbers, `count` of them from v on: the coefficients of [0, t], or those of [t, 1].
//
// A step makes s x + t y of two numbers, with s for 1 - t. That is right but for 2^-51 (3 s abs(x) + 2 t abs(y)), so
// that with the greatest absolute value M of the net its error grows by less than 2^-49 M at each of count - 1 steps.
void cut_rows(double* v, size_t count, size_t inner, double t, bool is_lower) {
  const double s = 1 - t;
  for (size_t step = 1; step < count; ++step)
    for (size_t k = 0; k + step < count; ++k) {
      double* const to = v + (is_lower ? count - 1 - k : k) * inner;
      const double *const x = is_lower ? to - inner : to, *const y = x + inner;
      for (size_t i = 0; i < inner; ++i) to[i] = s * x[i] + t * y[i];
    }
}
void cut_net(DoubleNet* net, size_t axis, double t, bool is_lower) {
  size_t inner = net->stride;
  for (size_t a = axis + 1; a < 3; ++a) inner *= net->n[a];
  const size_t block = inner * net->n[axis];
  for (size_t at = 0; at < net->v.size(); at += block)
    cut_rows(&net->v[at], net->n[axis], inner, t, is_lower);
}

bool is_finite(double x) { return std::abs(x) <= 1e300; }  // and not too large to compute with

}  // namespace

void restrict_net(DoubleNet* net, size_t axis, double a, double b) {
  if (net->n[axis] == 1 || (a <= 0 && b >= 1)) return;
  const double size = net->size();
  if (b < 1) cut_net(net, axis, b, true);
  // Keeps the part from t on, in the parameters where [0, b] is [0, 1]; t <= a / b.
  const double t = a <= 0 ? 0 : std::max(0.0, a / b * (1 - std::ldexp(1.0, -49)) - kTiny);
  if (t > 0) cut_net(net, axis, std::min(t, 1.0), false);
  net->error += std::ldexp(double(net->n[axis]) * size, -46) + kTiny;  // more than twice the bound
}

void halve_net(const DoubleNet& net, size_t axis, DoubleNet* lower, DoubleNet* upper) {
  *lower = net, *upper = net;
  restrict_net(lower, axis, 0, 0.5);
  restrict_net(upper, axis, 0.5, 1);
}

DoubleBox box_of(const DoubleNet& net) {
  DoubleBox r;
  for (size_t k = 0; k < 3; ++k) r.lo[k] = r.hi[k] = net.v[k];
  for (size_t i = 0; i < net.v.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) {
      r.lo[k] = std::min(r.lo[k], net.v[i + k]);
      r.hi[k] = std::max(r.hi[k], net.v[i + k]);
    }
  for (size_t k = 0; k < 3; ++k) {
    const double more =
        net.error + std::ldexp(std::abs(r.lo[k]) + std::abs(r.hi[k]) + net.error, -49) + kTiny;
    r.lo[k] -= more, r.hi[k] += more;
  }
  return r;
}

// A quotient x / w of numbers that differ by at most e from the exact X and W, e < w: X / W = x / w + (X - x) / W - (x
// / w) (W - w) / W, where W >= w - e.
void set_hull(const DoubleNet& net, PointHull* hull) {
  hull->p.clear();
  if (net.stride == 3) {
    hull->p = net.v;
    hull->error = net.error;
    hull->is_known = true;
  } else {
    double least = net.v[3], most = 0;
    for (size_t i = 0; i < net.v.size(); i += 4) {
      least = std::min(least, net.v[i + 3]);
      for (size_t k = 0; k < 3; ++k) {
        hull->p.push_back(net.v[i + k] / net.v[i + 3]);
        most = std::max(most, std::abs(hull->p.back()));
      }
    }
    hull->is_known = least > 4 * net.error && least > 1e-200;
    hull->error = 2 * (net.error * (1 + most) / least) + std::ldexp(most, -49) + kTiny;
  }
  DoubleNet points;  // in the place of the hull's
  points.v.swap(hull->p);
  points.error = hull->error;
  hull->is_known = hull->is_known && is_finite(points.error);
  for (double x : points.v) hull->is_known = hull->is_known && is_finite(x);
  if (hull->is_known) hull->box = box_of(points);
  points.v.swap(hull->p);
}
