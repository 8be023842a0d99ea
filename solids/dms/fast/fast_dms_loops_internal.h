// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_dms_loops_internal.h: the kernels of fast_dms_internal.h over a vector V of four doubles. Proofs
// of the bounds: docs/bounds/fast_dms.md.
#pragma once
#include "solids/dms/fast/fast_dms_internal.h"

namespace veritope::internal {
namespace {

template <typename V>
struct FastDmsLoop {
  struct Point {
    V x, y, z;
  };
  struct Value {
    V value, error;
  };

  [[gnu::always_inline]] static V linear(const FastLinear& f, const Point& p) {
    return ((V::all(f.c[0]) + V::all(f.c[1]) * p.x) + V::all(f.c[2]) * p.y) + V::all(f.c[3]) * p.z;
  }
  [[gnu::always_inline]] static double error_of(const FastLinear& f, double rounded) {
    return f.error[0] + rounded * f.error[1];
  }

  template <bool Bounds>
  [[gnu::always_inline]] static Value leaf(const FastLeaf& f, const Point& p, double rounded,
                                           V& open) {
    const V zero = V::all(0.0);
    V up = V::all(__builtin_inf()), up_low = up, up_high = up;
    V low = zero, low_low = zero, low_high = zero;
    std::uint32_t i = 0;
    for (; i < f.upper; ++i) {
      const V g = linear(f.g[i], p);
      up = V::min(up, g);
      if constexpr (Bounds) {
        const V error = V::all(error_of(f.g[i], rounded));
        up_low = V::min(up_low, g - error), up_high = V::min(up_high, g + error);
      }
    }
    for (; i < f.upper + f.lower; ++i) {
      const V g = linear(f.g[i], p);
      low = V::max(low, g);
      if constexpr (Bounds) {
        const V error = V::all(error_of(f.g[i], rounded));
        low_low = V::max(low_low, g - error), low_high = V::max(low_high, g + error);
      }
    }
    V m = V::max(zero, up - low), high = m, error = zero;
    if constexpr (Bounds) {
      high = V::max(zero, up_high - low_low);
      const V least = V::max(zero, up_low - low_high);
      error = V::max(high - m, m - least) + V::all(0x1p-51) * high;
    }
    for (; i < f.upper + f.lower + f.flat; ++i) {
      const V g = linear(f.g[i], p), bound = V::all(error_of(f.g[i], rounded));
      const V is_in = V::less(bound, g), is_out = V::less(g, zero - bound);
      m = V::without(m, is_out), high = V::without(high, is_out);
      error = V::without(error, is_out);
      open = V::either(open, V::without(V::less(zero, high), V::either(is_in, is_out)));
    }
    return {m, error};
  }

  template <bool Bounds>
  [[gnu::always_inline]] static Value node(const FastNode& n, const FastFrame& frame,
                                           const double* lambda, const double* values,
                                           double rounded) {
    V sum = V::all(0.0), error = V::all(0.0);
    for (std::size_t m = 0; m < 4; ++m) {
      const V l = V::load(lambda + 4 * m), part = V::load(values + 8 * n.part[m]);
      sum = sum + l * part;
      if constexpr (Bounds) {
        const V e = V::load(values + 8 * n.part[m] + 4);
        const V off = V::all(error_of(frame.lambda[m], rounded));
        error = error + (V::abs(l) * (e + V::all(0x1p-50) * part) + off * (part + e));
      }
    }
    return {V::max(V::all(0.0), sum), error};
  }

  template <bool Bounds>
  static void run(const FastUnit& u, const FastPoints& points, const std::uint32_t* list,
                  std::size_t n, const FastCall& call) {
    double* const values = call.scratch;
    double* const lambda = values + 8 * (1 + u.num_leaves + u.num_nodes);
    double* const sums = lambda + 16 * u.num_frames;
    const V zero = V::all(0.0);
    V::store(values, zero), V::store(values + 4, zero);
    for (std::size_t begin = 0; begin < n; begin += 4) {
      std::uint32_t id[4];
      for (std::size_t l = 0; l < 4; ++l) id[l] = list[begin + l < n ? begin + l : n - 1];
      const auto gather = [&](std::size_t axis) {
        const double* const at = points.at[axis];
        return (V::four(at[id[0]], at[id[1]], at[id[2]], at[id[3]]) - V::all(u.origin[axis])) *
               V::all(u.scale);
      };
      const Point p{gather(0), gather(1), gather(2)};
      V open = zero;
      double* to = values + 8;
      for (std::size_t i = 0; i < u.num_leaves; ++i, to += 8) {
        const Value v = leaf<Bounds>(u.leaves[u.leaf_ids[i]], p, call.rounded, open);
        V::store(to, v.value);
        if constexpr (Bounds) V::store(to + 4, v.error);
      }
      for (std::size_t i = 0; i < u.num_frames; ++i)
        for (std::size_t m = 0; m < 4; ++m)
          V::store(lambda + 16 * i + 4 * m, linear(u.frames[u.frame_ids[i]].lambda[m], p));
      for (std::size_t i = 0; i < u.num_nodes; ++i, to += 8) {
        const FastNode& at = u.nodes[i];
        const Value v = node<Bounds>(at, u.frames[u.frame_ids[at.frame]], lambda + 16 * at.frame,
                                     values, call.rounded);
        V::store(to, v.value);
        if constexpr (Bounds) V::store(to + 4, v.error);
      }
      const std::size_t count = n - begin < 4 ? n - begin : 4;
      if (V::any(open))
        for (std::size_t l = 0; l < count; ++l)
          if (V::lane(open, l)) points.is_open[id[l]] = 1;
      add_tops<Bounds>(u, points, call, values, lambda, sums, id, count);
    }
  }

  template <bool Bounds>
  [[gnu::always_inline]] static void add_tops(const FastUnit& u, const FastPoints& points,
                                              const FastCall& call, const double* values,
                                              const double* lambda, double* sums,
                                              const std::uint32_t* id, std::size_t count) {
    const V zero = V::all(0.0);
    const std::size_t components = u.components, slopes = 3 * components;
    const std::size_t parts = u.is_separate ? 4 : 1;
    double* const gradients = sums + 4 * components;
    const bool with_gradient = points.gradient != nullptr;
    for (std::size_t c = 0; c < components; ++c) V::store(sums + 4 * c, zero);
    for (std::size_t c = 0; with_gradient && c < slopes; ++c) V::store(gradients + 4 * c, zero);
    V error = zero, slope_error = zero;
    for (std::size_t i = 0; i < u.num_tops; ++i) {
      const FastTop& top = u.tops[i];
      const V m = V::load(values + 8 * top.at);
      const V e = Bounds ? V::load(values + 8 * top.at + 4) : zero;
      if (u.is_separate) {
        const double* const k = u.value + top.number * components;
        for (std::size_t c = 0; c < components; ++c)
          V::store(sums + 4 * c, V::load(sums + 4 * c) + m * V::all(k[c]));
        if constexpr (Bounds)
          error = error + V::all(u.value_weight[top.number]) * (e + V::all(call.slack) * m);
      } else {
        const double* const k = u.value + top.number * 4 * components;
        const double* const at = lambda + 16 * top.frame;
        const V l0 = V::load(at), l1 = V::load(at + 4), l2 = V::load(at + 8), l3 = V::load(at + 12);
        for (std::size_t c = 0; c < components; ++c) {
          const V l = ((l0 * V::all(k[c]) + l1 * V::all(k[components + c])) +
                       l2 * V::all(k[2 * components + c])) +
                      l3 * V::all(k[3 * components + c]);
          V::store(sums + 4 * c, V::load(sums + 4 * c) + m * l);
        }
        if constexpr (Bounds) {
          const FastFrame& frame = u.frames[u.frame_ids[top.frame]];
          const double off =
              ((error_of(frame.lambda[0], call.rounded) + error_of(frame.lambda[1], call.rounded)) +
               error_of(frame.lambda[2], call.rounded)) +
              error_of(frame.lambda[3], call.rounded);
          const V size = (V::abs(l0) + V::abs(l1)) + (V::abs(l2) + V::abs(l3));
          error = error + V::all(u.value_weight[top.number]) *
                              (size * (e + V::all(call.slack) * m) + V::all(off) * (m + e));
        }
      }
      for (std::size_t part = 0; with_gradient && part < parts; ++part) {
        const double* const from = values + 8 * top.part[part];
        const V g = V::load(from);
        const double* const k = u.gradient + (top.number * parts + part) * slopes;
        for (std::size_t c = 0; c < slopes; ++c)
          V::store(gradients + 4 * c, V::load(gradients + 4 * c) + g * V::all(k[c]));
        if constexpr (Bounds)
          slope_error = slope_error + V::all(u.gradient_weight[top.number * parts + part]) *
                                          (V::load(from + 4) + V::all(call.slack) * g);
      }
    }
    scatter<Bounds>(points, sums, gradients, components, error, slope_error, id, count);
  }

  template <bool Bounds>
  [[gnu::always_inline]] static void scatter(const FastPoints& points, const double* sums,
                                             const double* gradients, std::size_t components,
                                             V error, V slope_error, const std::uint32_t* id,
                                             std::size_t count) {
    alignas(32) double errors[8];
    V::store(errors, error), V::store(errors + 4, slope_error);
    for (std::size_t l = 0; l < count; ++l) {
      double* const value = points.value + id[l] * components;
      for (std::size_t c = 0; c < components; ++c) value[c] += sums[4 * c + l];
      if (points.gradient != nullptr) {
        double* const gradient = points.gradient + id[l] * 3 * components;
        for (std::size_t c = 0; c < 3 * components; ++c) gradient[c] += gradients[4 * c + l];
      }
      if constexpr (Bounds) {
        points.error[2 * id[l]] += errors[l];
        points.error[2 * id[l] + 1] += errors[4 + l];
      }
    }
  }

  static void barycentric(const FastFrame& frame, const double* origin, double scale,
                          const double* const* at, std::size_t n, double* const* lambda) {
    for (std::size_t i = 0; i < n; i += 4) {
      const auto local = [&](std::size_t axis) {
        return (V::load(at[axis] + i) - V::all(origin[axis])) * V::all(scale);
      };
      const Point p{local(0), local(1), local(2)};
      for (std::size_t m = 0; m < 4; ++m) V::store(lambda[m] + i, linear(frame.lambda[m], p));
    }
  }

  static std::uint32_t find(const std::uint32_t* list, std::size_t n, const FastSide* const* sides,
                            const double* at, double rounded, std::size_t* place) {
    const V u = V::load(at), zero = V::all(0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const FastSide* const s = sides[list[i]];
      *place = i;
      if (s == nullptr) return kFastUnmade;
      if (V::any(V::either(V::less(u, V::load(s->low)), V::less(V::load(s->high), u)))) continue;
      alignas(32) double local[4];
      V::store(local, (u - V::load(s->origin)) * V::all(s->scale));
      const V l = ((V::load(s->c[0]) + V::load(s->c[1]) * V::all(local[0])) +
                   V::load(s->c[2]) * V::all(local[1])) +
                  V::load(s->c[3]) * V::all(local[2]);
      const V error = V::load(s->error[0]) + V::all(rounded) * V::load(s->error[1]);
      if (V::any(V::less(l, zero - error))) continue;
      return V::bits(V::less(error, l)) == 15 ? list[i] : kFastUndecided;
    }
    return kFastNowhere;
  }

  static std::size_t select(const double* const* lambda, std::size_t n, const double* high,
                            std::uint32_t* list) {
    const V h0 = V::all(high[0]), h1 = V::all(high[1]), h2 = V::all(high[2]), h3 = V::all(high[3]);
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; i += 4) {
      const V out = V::either(
          V::either(V::less(h0, V::load(lambda[0] + i)), V::less(h1, V::load(lambda[1] + i))),
          V::either(V::less(h2, V::load(lambda[2] + i)), V::less(h3, V::load(lambda[3] + i))));
      const unsigned bits = V::bits(out);
      if (bits == 15) continue;
      for (std::size_t l = 0; l < 4 && i + l < n; ++l) {
        list[count] = static_cast<std::uint32_t>(i + l);
        count += 1 - ((bits >> l) & 1);
      }
    }
    return count;
  }
};

template <typename V>
constexpr FastDmsKernels fast_dms_kernels_of() {
  return {FastDmsLoop<V>::template run<true>, FastDmsLoop<V>::template run<false>,
          FastDmsLoop<V>::barycentric, FastDmsLoop<V>::select, FastDmsLoop<V>::find};
}

}  // namespace
}  // namespace veritope::internal
