// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/volume_fold.h"

#include <algorithm>
#include <concepts>
#include <span>
#include <utility>
#include <vector>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/common_bits.h"
#include "splines/binomial.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

using Piece = BezierVolume<Rational>;
using Pieces = BezierPieces<Rational, 3>;
using Index = std::array<std::size_t, 3>;

constexpr int kMostDegree = 15;  // of certificates
constexpr std::uint64_t kMostBits = 8192, kMostKnotBits = 256, kMostBoxBits = 1 << 22;
constexpr std::uint64_t kMostExactBits = 1 << 17;  // of coefficients: more than kMostBits and kMostKnotBits make

// ---- the determinant at a point of a piece

template <Ring R>
R number_in(const Rational& x) {
  if constexpr (std::same_as<R, Rational>)
    return x;
  else
    return RingNumbers<R>::of_knot(x);
}

Sign3 sign3_of(const Rational& x) { return to_sign3(x.sign()); }
Sign3 sign3_of(const Interval& x) { return x.sign(); }

// Factors of the coefficients along an axis, those that are 0 left out.
template <Ring R>
using Factors = std::vector<std::pair<std::size_t, R>>;
template <Ring R>
struct AxisFactors {
  Factors<R> value, slope;  // of the map, and of its derivative over the degree
};

template <Ring R>
Factors<R> nonzero(const std::vector<Rational>& all) {
  Factors<R> out;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].sign() != Sign::kZero) out.emplace_back(i, number_in<R>(all[i]));
  return out;
}

// The values of the Bernstein polynomials of a degree.
std::vector<Rational> bernstein(int degree, const Rational& t) {
  const std::vector<Integer> row = binomial_row(degree);
  std::vector<Rational> up{Rational(1)}, down{Rational(1)}, out;
  for (int i = 0; i < degree; ++i) {
    up.push_back(up.back() * t);
    down.push_back(down.back() * (Rational(1) - t));
  }
  for (std::size_t i = 0; i < row.size(); ++i)
    out.push_back(Rational(row[i]) * up[i] * down[row.size() - 1 - i]);
  return out;
}

template <Ring R>
AxisFactors<R> axis_factors(int degree, const Rational& t) {
  std::vector<Rational> slope(static_cast<std::size_t>(degree) + 1);
  const std::vector<Rational> lower = bernstein(degree - 1, t);
  for (std::size_t i = 0; i < lower.size(); ++i) slope[i] -= lower[i], slope[i + 1] += lower[i];
  return {nonzero<R>(bernstein(degree, t)), nonzero<R>(slope)};
}

// Coefficients of which the first axis is summed up; their components come last.
template <Ring R>
std::vector<R> along_first(const std::vector<R>& net, std::size_t stride, const Factors<R>& by) {
  std::vector<R> out(stride);
  for (std::size_t i = 0; i < stride; ++i)
    for (const auto& [k, factor] : by) internal::accumulate(out[i], factor * net[k * stride + i]);
  return out;
}

template <Ring R>
std::vector<R> net_of(const Piece& piece) {
  const std::size_t count = piece.grid().count();
  std::vector<R> out;
  out.reserve(count * static_cast<std::size_t>(piece.num_components()));
  for (std::size_t i = 0; i < count; ++i)
    for (int c = 0; c < piece.num_components(); ++c)
      out.push_back(number_in<R>(piece.component(c)[i]));
  return out;
}

// Rows of three or four numbers.
template <Ring R>
R determinant(std::span<const std::vector<R>> rows) {
  const auto minor = [&](std::size_t r, std::size_t s, std::size_t i, std::size_t j) {
    return rows[r][i] * rows[s][j] - rows[r][j] * rows[s][i];
  };
  if (rows.size() == 3)
    return rows[0][0] * minor(1, 2, 1, 2) - rows[0][1] * minor(1, 2, 0, 2) +
           rows[0][2] * minor(1, 2, 0, 1);
  return minor(0, 1, 0, 1) * minor(2, 3, 2, 3) - minor(0, 1, 0, 2) * minor(2, 3, 1, 3) +
         minor(0, 1, 0, 3) * minor(2, 3, 1, 2) + minor(0, 1, 1, 2) * minor(2, 3, 0, 3) -
         minor(0, 1, 1, 3) * minor(2, 3, 0, 2) + minor(0, 1, 2, 3) * minor(2, 3, 0, 1);
}

// The sign of det J at points of a grid of a piece. With the homogeneous map F = W (x, 1) it is that of -det(F, F_u,
// F_v, F_w); of a polynomial map that of the three derivatives. Degrees are left out: they are positive factors.
template <Ring R>
class PieceSigns {
 public:
  PieceSigns(const Piece& piece, const std::array<std::vector<AxisFactors<R>>, 3>& factors)
      : factors_(factors), components_(static_cast<std::size_t>(piece.num_components())) {
    std::size_t stride = components_;
    for (std::size_t a = 3; a-- > 0;) {
      stride_[a] = stride;
      stride *= static_cast<std::size_t>(piece.degree(a)) + 1;
    }
    net_ = net_of<R>(piece);
  }

  /// Calls use(index, sign) for every point of the grid until it returns true.
  template <typename Use>
  void each(Use use) const {
    for (std::size_t i = 0; i < factors_[0].size(); ++i) {
      const AxisFactors<R>& u = factors_[0][i];
      const auto f = along_first(net_, stride_[0], u.value);
      const auto f_u = along_first(net_, stride_[0], u.slope);
      for (std::size_t j = 0; j < factors_[1].size(); ++j) {
        const AxisFactors<R>& v = factors_[1][j];
        const auto g = along_first(f, stride_[1], v.value);
        const auto g_u = along_first(f_u, stride_[1], v.value);
        const auto g_v = along_first(f, stride_[1], v.slope);
        for (std::size_t k = 0; k < factors_[2].size(); ++k) {
          const AxisFactors<R>& w = factors_[2][k];
          const auto last = [&](const std::vector<R>& net, const Factors<R>& by) {
            return along_first(net, stride_[2], by);
          };
          if (use(Index{i, j, k},
                  sign(last(g, w.value), last(g_u, w.value), last(g_v, w.value), last(g, w.slope))))
            return;
        }
      }
    }
  }

 private:
  Sign3 sign(std::vector<R> f, std::vector<R> f_u, std::vector<R> f_v, std::vector<R> f_w) const {
    const std::array<std::vector<R>, 4> rows{std::move(f), std::move(f_u), std::move(f_v),
                                             std::move(f_w)};
    const std::span<const std::vector<R>> all = rows;
    if (components_ == 3) return sign3_of(determinant<R>(all.subspan(1)));
    return sign3_of(-determinant<R>(all));
  }

  const std::array<std::vector<AxisFactors<R>>, 3>& factors_;
  std::size_t components_;
  std::array<std::size_t, 3> stride_{};
  std::vector<R> net_;
};

Sign exact_sign(const Piece& piece, const std::array<Rational, 3>& at) {
  std::array<std::vector<AxisFactors<Rational>>, 3> factors;
  for (std::size_t a = 0; a < 3; ++a) factors[a] = {axis_factors<Rational>(piece.degree(a), at[a])};
  Sign out = Sign::kZero;
  PieceSigns<Rational>(piece, factors).each([&](const Index&, Sign3 sign) {
    out = to_sign(sign);
    return true;
  });
  return out;
}

// ---- the search

const std::array<Rational, 3>& grid_parameters() {
  static const std::array<Rational, 3> all{Rational(0), Rational(Integer(1), Integer(2)),
                                           Rational(1)};
  return all;
}

class FoldSearch {
 public:
  explicit FoldSearch(const ExactVolume& volume)
      : pieces_(bezier_pieces(volume)), grid_(pieces_.grid()) {
    for (std::size_t a = 0; a < 3; ++a)
      for (const Rational& t : grid_parameters())
        factors_[a].push_back(axis_factors<Interval>(volume.axis(a).degree, t));
  }

  std::optional<std::array<FoldPlace, 2>> run() {
    look_at_corners();
    for (std::size_t i = 0; i < pieces_.pieces.size() && !is_done(); ++i) look_at(i);
    if (!is_done()) return std::nullopt;
    return std::array<FoldPlace, 2>{*found_[0], *found_[1]};
  }

 private:
  bool is_done() const { return found_[0] && found_[1]; }

  void note(const Index& piece, const std::array<Rational, 3>& at, Sign sign) {
    if (sign == Sign::kZero) return;
    std::optional<FoldPlace>& place = found_[sign == Sign::kPositive ? 0 : 1];
    if (!place) place = FoldPlace{{piece[0], piece[1], piece[2]}, at};
  }
  void note_exactly(const Index& piece, const std::array<Rational, 3>& at) {
    note(piece, at, exact_sign(pieces_.at(piece), at));
  }

  void look_at_corners() {
    for (std::size_t corner = 0; corner < 8 && !is_done(); ++corner) {
      Index piece{};
      std::array<Rational, 3> at;
      for (std::size_t a = 0; a < 3; ++a) {
        const bool is_end = (corner >> a & 1) != 0;
        piece[a] = is_end ? grid_.size[a] - 1 : 0;
        at[a] = Rational(is_end ? 1 : 0);
      }
      note_exactly(piece, at);
    }
  }

  // Whether the exact sign costs little. Other pieces are far beyond the limits of certificates.
  static bool is_short(const Piece& piece) {
    CommonBits bits(kMostExactBits);
    for (const Rational& x : piece.coefficients()) bits.add(x);
    return !bits.is_beyond();
  }

  // The middle first: it is a better place to name.
  void look_at(std::size_t number) {
    const Index piece = grid_.index_of(number);
    std::array<Sign3, 27> signs{};
    PieceSigns<Interval>(pieces_.pieces[number], factors_).each([&](const Index& i, Sign3 sign) {
      signs[9 * i[0] + 3 * i[1] + i[2]] = sign;
      return false;
    });
    const auto at = [&](std::size_t i) {
      const std::array<Rational, 3>& t = grid_parameters();
      return std::array<Rational, 3>{t[i / 9], t[i / 3 % 3], t[i % 3]};
    };
    constexpr std::size_t kMiddle = 13;
    if (is_certain(signs[kMiddle]))
      note(piece, at(kMiddle), to_sign(signs[kMiddle]));
    else if (is_short(pieces_.pieces[number]))
      note_exactly(piece, at(kMiddle));
    for (std::size_t i = 0; i < signs.size() && !is_done(); ++i)
      if (is_certain(signs[i])) note(piece, at(i), to_sign(signs[i]));
  }

  const Pieces pieces_;
  const Grid<3> grid_;
  std::array<std::vector<AxisFactors<Interval>>, 3> factors_;
  std::array<std::optional<FoldPlace>, 2> found_;
};

// Whether a fold of the volume may be sought: see find_fold.
bool is_examined(const ExactVolume& volume) {
  if (volume.dimension() != 3) return false;
  for (const auto& axis : volume.axes()) {
    const auto p = static_cast<std::size_t>(axis.degree), n = axis.num_control();
    if (axis.degree > kMostDegree) return false;
    for (std::size_t i = p + 1; i < n && i + p < axis.knots.size(); ++i)
      if (axis.knots[p] < axis.knots[i] && axis.knots[i] < axis.knots[n] &&
          axis.knots[i] == axis.knots[i + p])
        return false;
  }
  return true;
}

// ---- limits of certificates

// Whether the numbers, brought to integers by their least common denominator, and that have at most this many bits.
bool are_short(const std::vector<Rational>& numbers, std::uint64_t most) {
  Integer common(1);
  for (const Rational& x : numbers) {
    common = lcm(common, x.denominator());
    if (common.bit_length() > most) return false;
  }
  return std::all_of(numbers.begin(), numbers.end(), [&](const Rational& x) {
    return (x.numerator() * divide_exactly(common, x.denominator())).bit_length() <= most;
  });
}

// The last knot at which the piece begins.
std::size_t span_of(const KnotAxis<Rational>& axis, std::uint64_t piece) {
  return internal::find_span(axis, internal::breaks_of(axis)[piece]);
}

}  // namespace

std::optional<VolumeFold> find_fold(const SplineModel& model) {
  const ScopedUpward upward;
  for (std::uint64_t e = 0; e < model.entities.size(); ++e) {
    const auto* const volume = std::get_if<ExactVolume>(&model.entities[e].shape);
    if (volume == nullptr || !is_examined(*volume)) continue;
    if (auto places = FoldSearch(*volume).run()) return VolumeFold{e, std::move(*places)};
  }
  return std::nullopt;
}

Sign jacobian_sign(const ExactVolume& volume, const FoldPlace& place) {
  const Pieces pieces = bezier_pieces(volume);
  return exact_sign(pieces.at({place.piece[0], place.piece[1], place.piece[2]}), place.at);
}

std::array<Rational, 3> parameters_at(const ExactVolume& volume, const FoldPlace& place) {
  std::array<Rational, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<Rational> breaks = internal::breaks_of(volume.axis(a));
    VT_CHECK(place.piece[a] + 1 < breaks.size(), "a place lies in a piece");
    const Rational &low = breaks[place.piece[a]], &high = breaks[place.piece[a] + 1];
    out[a] = low + (high - low) * place.at[a];
  }
  return out;
}

std::array<Rational, 3> point_at(const ExactVolume& volume, const FoldPlace& place) {
  const std::vector<Rational> p = point(volume, parameters_at(volume, place)).value();
  return {p[0], p[1], p[2]};
}

bool fits_certificate(const ExactVolume& volume, const FoldPlace& place) {
  Index first{};
  Grid<3> local;
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    const auto p = static_cast<std::size_t>(axis.degree);
    const std::size_t span = span_of(axis, place.piece[a]);
    if (axis.degree > kMostDegree) return false;
    const auto at = axis.knots.begin() + static_cast<std::ptrdiff_t>(span + 1);
    const auto half = static_cast<std::ptrdiff_t>(p);
    if (!are_short({at - half, at + half}, kMostKnotBits)) return false;
    first[a] = span - p;
    local.size[a] = p + 1;
  }
  std::vector<Rational> numbers;
  for (std::size_t i = 0; i < local.count(); ++i) {
    Index index = local.index_of(i);
    for (std::size_t a = 0; a < 3; ++a) index[a] += first[a];
    for (int c = 0; c < volume.num_components(); ++c)
      numbers.push_back(volume.component(c)[volume.grid().at(index)]);
  }
  return are_short(numbers, std::min(kMostBits, kMostBoxBits / local.count()));
}

}  // namespace veritope
