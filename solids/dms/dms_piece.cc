// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_piece.h"

#include <utility>

#include "predicates/exact_point.h"
#include "robust/base/check.h"
#include "robust/integer.h"
#include "solids/dms/dms_table.h"
#include "splines/dms_spline.h"

namespace veritope {
namespace {

// Frames of this many tetrahedra are kept.
constexpr std::size_t kMaxKeptTetrahedra = 1024;

using Exponents = std::array<int, 4>;

// A homogeneous polynomial in barycentric coordinates: the integers over the denominator are the factors of its
// monomials. Without integers it is 0.
struct Form {
  std::vector<Integer> numerators;
  Integer denominator{1};

  bool is_zero() const { return numerators.empty(); }
};
// Integers over a common denominator.
struct Fractions {
  std::vector<Integer> numerators;
  Integer denominator{1};
};
Fractions over_one_denominator(std::span<const Rational* const> numbers) {
  Fractions out;
  for (const Rational* const x : numbers)
    if (x->denominator() != out.denominator)
      out.denominator = lcm(out.denominator, x->denominator());
  for (const Rational* const x : numbers) {
    Integer& n = out.numerators.emplace_back(x->numerator());
    if (x->denominator() != out.denominator) n *= divide_exactly(out.denominator, x->denominator());
  }
  return out;
}

// Adds a polynomial, times a factor, to a sum of the same degree.
void add_scaled(const Form& form, const Integer& factor, std::vector<Integer>& sum) {
  if (sum.empty()) sum.resize(form.numerators.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i].add_product(form.numerators[i], factor);
}
void add(const Form& form, Form& sum) {
  if (form.is_zero()) return;
  if (sum.is_zero()) {
    sum = form;
    return;
  }
  const Integer common = lcm(form.denominator, sum.denominator);
  const Integer factor = divide_exactly(common, sum.denominator);
  if (factor != Integer(1))
    for (Integer& n : sum.numerators) n *= factor;
  add_scaled(form, divide_exactly(common, form.denominator), sum.numerators);
  sum.denominator = common;
}

}  // namespace

namespace internal {

// The monomials of some coordinates, for degrees from 0 on: the first exponent falls, then the second one, and so on.
class DmsMonomials {
 public:
  DmsMonomials(int degree, std::size_t num_coordinates) : size_(num_coordinates) {
    for (int d = 0; d <= degree; ++d) {
      exponents_.emplace_back();
      for_each_tetrahedral_index(d, [&](const TetrahedralIndex& index) {
        if (size_ == 4 || index[3] == 0) exponents_.back().push_back(index);
      });
    }
    for (std::size_t d = 0; d + 1 < exponents_.size(); ++d) {
      products_.emplace_back();
      for (const Exponents& e : exponents_[d])
        for (std::size_t i = 0; i < size_; ++i)
          products_.back().push_back(place_of(exponents_[d + 1], raised(e, i)));
    }
  }
  std::size_t num_coordinates() const { return size_; }
  const std::vector<Exponents>& of_degree(std::size_t d) const { return exponents_[d]; }
  // Adds the product of a polynomial of this degree and a linear one to a sum.
  void add_product(std::size_t degree, const std::vector<Integer>& form,
                   std::span<const Integer> linear, std::vector<Integer>& sum) const {
    if (sum.empty()) sum.resize(exponents_[degree + 1].size());
    const std::vector<std::size_t>& places = products_[degree];
    for (std::size_t k = 0; k < form.size(); ++k)
      for (std::size_t i = 0; i < size_; ++i)
        sum[places[k * size_ + i]].add_product(form[k], linear[i]);
  }

 private:
  static std::size_t place_of(const std::vector<Exponents>& all, const Exponents& e) {
    std::size_t i = 0;
    while (all[i] != e) ++i;
    return i;
  }

  std::size_t size_;
  std::vector<std::vector<Exponents>> exponents_;  // of each degree
  std::vector<std::vector<std::size_t>>
      products_;  // of each degree: of each monomial with each coordinate
};

// The frames of a tetrahedron, with the barycentric coordinates as integers over one denominator.
class DmsFrames {
 public:
  explicit DmsFrames(DmsTable table) : table_(std::move(table)) {}

  DmsTable& table() { return table_; }
  // Four numbers for each coordinate: the factors of 1, x, y and z.
  const Fractions& of(const SimplexFrame<Rational>& frame) {
    const auto [found, is_new] = integers_.try_emplace(&frame);
    if (is_new) {
      std::vector<const Rational*> numbers;
      for (const auto& row : frame.lambda)
        for (const Rational& x : row) numbers.push_back(&x);
      found->second = over_one_denominator(numbers);
    }
    return found->second;
  }

 private:
  DmsTable table_;
  std::unordered_map<const SimplexFrame<Rational>*, Fractions> integers_;
};

}  // namespace internal

namespace {

using internal::DmsFrames;
using internal::DmsMonomials;

// A simplex with corners (x, y, z) / w: polynomials on it are in the barycentric coordinates over the weights w.
struct Simplex {
  std::vector<std::array<Integer, 4>> corners;  // w, x, y, z
};
Simplex simplex_of(std::span<const DmsPoint> corners) {
  Simplex out;
  for (const DmsPoint& p : corners) {
    Fractions at = over_one_denominator(std::array<const Rational*, 3>{&p[0], &p[1], &p[2]});
    out.corners.push_back({std::move(at.denominator), std::move(at.numerators[0]),
                           std::move(at.numerators[1]), std::move(at.numerators[2])});
  }
  return out;
}

// The terms of one tetrahedron on a simplex.
class TetrahedronTerms {
 public:
  TetrahedronTerms(const DmsModel& model, std::uint32_t tetrahedron, DmsFrames& frames,
                   const DmsMonomials& monomials, const Simplex& simplex, const EntryPath& path)
      : model_(model),
        tetrahedron_(tetrahedron),
        frames_(frames),
        monomials_(monomials),
        simplex_(simplex),
        path_(path) {}

  // To the first components' sums, one for each.
  void add_to(std::span<Form> sums) {
    const int sum = model_.degree - (model_.control.is_separate ? 0 : 1);
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& index) {
      const internal::DmsTable& table = frames_.table();
      const Form& spline = form(table.knots().up_to(index));
      if (spline.is_zero()) return;
      const auto w = table.knots().tetrahedron(index);
      const SimplexFrame<Rational>* const frame =
          frames_.table().frame(KnotSet{w[0], w[1], w[2], w[3]});
      VT_CHECK(frame != nullptr, "the four last knots of a basis function are independent");
      if (model_.control.is_separate)
        add_value(index, spline, *frame, sums);
      else
        add_affine(index, spline, *frame, sums);
    });
  }

 private:
  std::span<const Rational> control(const TetrahedralIndex& beta) const {
    return model_.value(control_of(model_, tetrahedron_, beta));
  }
  // N_β c(β)
  void add_value(const TetrahedralIndex& beta, const Form& spline,
                 const SimplexFrame<Rational>& frame, std::span<Form> sums) const {
    for (std::size_t c = 0; c < sums.size(); ++c) {
      const Rational factor = frame.volume * control(beta)[c];
      if (factor.sign() == Sign::kZero) continue;
      Form term{{}, spline.denominator * factor.denominator()};
      add_scaled(spline, factor.numerator(), term.numerators);
      add(term, sums[c]);
    }
  }
  // N_γ times the sum of λ_m c(γ + e_m)
  void add_affine(const TetrahedralIndex& gamma, const Form& spline,
                  const SimplexFrame<Rational>& frame, std::span<Form> sums) {
    const std::vector<Integer>& lambda = at_corners(frame);
    const std::size_t n = simplex_.corners.size();
    for (std::size_t c = 0; c < sums.size(); ++c) {
      std::array<const Rational*, 4> values{};
      for (std::size_t m = 0; m < 4; ++m) values[m] = &control(raised(gamma, m))[c];
      const Fractions four = over_one_denominator(values);
      std::vector<Integer> linear(n);
      for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t i = 0; i < n; ++i)
          linear[i].add_product(lambda[m * n + i], four.numerators[m]);
      for (Integer& x : linear) x *= frame.volume.numerator();
      Form term{{},
                spline.denominator * frames_.of(frame).denominator * four.denominator *
                    frame.volume.denominator()};
      monomials_.add_product(static_cast<std::size_t>(model_.degree - 1), spline.numerators, linear,
                             term.numerators);
      add(term, sums[c]);
    }
  }

  // The numerators of a frame's coordinates at the corners.
  const std::vector<Integer>& at_corners(const SimplexFrame<Rational>& frame) {
    const auto [found, is_new] = at_corners_.try_emplace(&frame);
    std::vector<Integer>& out = found->second;
    if (!is_new) return out;
    const Fractions& lambda = frames_.of(frame);
    for (std::size_t m = 0; m < 4; ++m)
      for (const auto& corner : simplex_.corners) {
        Integer& sum = out.emplace_back();
        for (std::size_t c = 0; c < 4; ++c)
          sum.add_product(lambda.numerators[4 * m + c], corner[c]);
      }
    return out;
  }
  const Form& form(const KnotSet& knots) {
    const auto found = forms_.find(knots);
    if (found != forms_.end()) return found->second;
    Form made = make_form(knots);
    return forms_.emplace(knots, std::move(made)).first->second;
  }
  Form make_form(const KnotSet& knots) {
    const SimplexFrame<Rational>* const frame = frames_.table().frame(knots);
    if (frame == nullptr) return {};
    if (knots.size() == 4) {
      if (!is_entered(frames_.table().corners(*frame), path_)) return {};
      return {{frame->height.numerator()}, frame->height.denominator()};
    }
    std::array<const Form*, 4> parts{};
    Integer common(1);
    bool is_zero = true;
    for (std::size_t m = 0; m < 4; ++m) {
      parts[m] = &form(knots.without(frame->knots[m]));
      if (parts[m]->is_zero()) continue;
      common = is_zero ? parts[m]->denominator : lcm(common, parts[m]->denominator);
      is_zero = false;
    }
    Form out;
    if (is_zero) return out;
    const std::vector<Integer>& lambda = at_corners(*frame);
    const std::size_t n = simplex_.corners.size();
    for (std::size_t m = 0; m < 4; ++m) {
      if (parts[m]->is_zero()) continue;
      const Integer factor = divide_exactly(common, parts[m]->denominator);
      std::vector<Integer> linear;
      for (std::size_t i = 0; i < n; ++i) linear.push_back(lambda[m * n + i] * factor);
      monomials_.add_product(knots.size() - 5, parts[m]->numerators, linear, out.numerators);
    }
    out.denominator = common * frames_.of(*frame).denominator;
    return out;
  }

  const DmsModel& model_;
  const std::uint32_t tetrahedron_;
  DmsFrames& frames_;
  const DmsMonomials& monomials_;
  const Simplex& simplex_;
  const EntryPath& path_;
  std::unordered_map<KnotSet, Form, KnotSetHash> forms_;
  std::unordered_map<const SimplexFrame<Rational>*, std::vector<Integer>> at_corners_;
};

// How often a monomial of barycentric coordinates occurs in a power of their sum.
Integer multiplicity(const Exponents& exponents) {
  Integer out(1);
  int left = 0;
  for (const int e : exponents)
    for (int k = 1; k <= e; ++k) out = divide_exactly(out * Integer(++left), Integer(k));
  return out;
}

DmsPoint mean_of(std::span<const DmsPoint> points) {
  DmsPoint out;
  for (const DmsPoint& p : points)
    for (std::size_t c = 0; c < 3; ++c) out[c] += p[c];
  for (Rational& x : out) x /= Rational(static_cast<std::int64_t>(points.size()));
  return out;
}

}  // namespace

DmsPieces::DmsPieces(const DmsModel& model, const DmsEvaluator& evaluator)
    : model_(model), evaluator_(evaluator) {
  for (std::size_t i = 0; i < 2; ++i)
    monomials_[i] = std::make_unique<DmsMonomials>(model.degree, i + 3);
}
DmsPieces::~DmsPieces() = default;

internal::DmsFrames& DmsPieces::frames(std::uint32_t tetrahedron) {
  const auto found = frames_.find(tetrahedron);
  if (found != frames_.end()) return *found->second;
  auto made = std::make_unique<DmsFrames>(evaluator_.make_table(tetrahedron));
  return *frames_.emplace(tetrahedron, std::move(made)).first->second;
}

std::optional<std::vector<std::vector<Rational>>> DmsPieces::components(
    std::span<const DmsPoint> corners, std::size_t num_components) {
  const auto place = evaluator_.locate(mean_of(corners));
  if (!place) return std::nullopt;
  if (frames_.size() > kMaxKeptTetrahedra) frames_.clear();
  const Simplex simplex = simplex_of(corners);
  const DmsMonomials& monomials = *monomials_[corners.size() - 3];
  std::vector<Form> sums(num_components);
  for (const std::uint32_t t : evaluator_.near(place->path.start()))
    TetrahedronTerms(model_, t, frames(t), monomials, simplex, place->path).add_to(sums);
  std::vector<std::vector<Rational>> out(num_components);
  std::size_t k = 0;
  for (const Exponents& e : monomials.of_degree(static_cast<std::size_t>(model_.degree))) {
    Integer factor = multiplicity(e);
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (int times = 0; times < e[i]; ++times) factor *= simplex.corners[i][0];
    for (std::size_t c = 0; c < num_components; ++c)
      out[c].push_back(sums[c].is_zero()
                           ? Rational()
                           : Rational(sums[c].numerators[k], sums[c].denominator * factor));
    ++k;
  }
  return out;
}

std::optional<std::vector<DmsPoint>> DmsPieces::coefficients(std::span<const DmsPoint> corners) {
  auto parts = components(corners, 3);
  if (!parts) return std::nullopt;
  std::vector<DmsPoint> out(parts->front().size());
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < out.size(); ++i) out[i][c] = std::move((*parts)[c][i]);
  return out;
}

}  // namespace veritope
