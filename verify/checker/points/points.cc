// SPDX-License-Identifier: Apache-2.0 OR MIT
// points.cc: the claim points-1; conditions B1 and P1 to P4 of docs/certificates/points.md.
#include <array>

#include "answers.h"
#include "patch_points.h"
#include "points_claim.h"
#include "relation.h"

namespace {

// Sets the codes of the answers: B1, except the work.
void read_body(const Model& model, Body body, std::vector<Answer>* answers) {
  require(body.begins_with("VTPT"), "B1", "the body does not start with VTPT");
  require(body.natural(4) == model.faces(), "B1", "the model's number of triangles is",
          model.faces());
  require(body.natural(4) == model.vertices(), "B1", "the model's number of vertices is",
          model.vertices());
  require(body.natural(8) == answers->size(), "B1", "the number of points is", answers->size());
  for (Answer& a : *answers) {
    const uint64_t line = uint64_t(&a - answers->data()) + 1;
    if (a.word == Answer::kUndecided) continue;
    const uint64_t code = a.word == Answer::kOn ? body.varint() : body.natural(1);
    require(code < (a.word == Answer::kOn ? model.faces() : 6), "B1", "unknown code of line", line);
    a.code = uint32_t(code);
  }
  require(body.left() == 0, "B1", "bytes follow the codes:", body.left());
}

// P1: the directed edges between different ids, each as (lesser id, greater id), are the same for both directions.
bool is_closed(const Model& model) {
  std::vector<uint64_t> rising, falling;
  for (size_t e = 0; e < model.tri.size(); ++e) {
    const uint64_t a = model.tri[e], b = model.tri[e % 3 == 2 ? e - 2 : e + 1];
    if (a < b) rising.push_back(a << 32 | b);
    if (a > b) falling.push_back(b << 32 | a);
  }
  std::sort(rising.begin(), rising.end());
  std::sort(falling.begin(), falling.end());
  return rising == falling;
}

// An order of the triangles for the box tree: halves by the median of the middles of the triangles, along the axis in
// which these lie farthest apart. Every order is right; this one makes searches short. The middles are sums of
// coordinates, cut to 53 bits below the greatest one.
class Order {
 public:
  explicit Order(const Model& model) : middles_(model.faces()), order_(model.faces()) {
    int top = 0;
    for (uint32_t v : model.tri)
      for (int k = 0; k < 3; ++k) top = std::max(top, key_exponent(model.key[3 * size_t(v) + k]));
    for (size_t c = 0; c < model.tri.size(); ++c)
      for (int k = 0; k < 3; ++k) {
        const int64_t key = model.key[3 * size_t(model.tri[c]) + k];
        const int64_t m = int64_t(key_mantissa(key) >> std::min(63, top - key_exponent(key)));
        middles_[c / 3][k] += key < 0 ? -m : m;
      }
    for (uint32_t f = 0; f < order_.size(); ++f) order_[f] = f;
    split(0, order_.size());
  }
  const std::vector<uint32_t>& result() const { return order_; }

 private:
  void split(size_t lo, size_t hi) {
    if (hi - lo < 2) return;
    int axis = 0;
    int64_t widest = -1;
    for (int k = 0; k < 3; ++k) {
      int64_t least = middles_[order_[lo]][k], most = least;
      for (size_t i = lo; i < hi; ++i) {
        least = std::min(least, middles_[order_[i]][k]);
        most = std::max(most, middles_[order_[i]][k]);
      }
      if (most - least > widest) widest = most - least, axis = k;
    }
    const size_t half = lo + (hi - lo) / 2;  // as Range has it
    std::nth_element(
        order_.begin() + long(lo), order_.begin() + long(half), order_.begin() + long(hi),
        [this, axis](uint32_t f, uint32_t g) { return middles_[f][axis] < middles_[g][axis]; });
    split(lo, half);
    split(half, hi);
  }
  std::vector<std::array<int64_t, 3>> middles_;
  std::vector<uint32_t> order_;
};

struct Point {
  int64_t below[3], above[3];  // as Coordinate has them
  bool is_binary64 = true;
  Lattice lattice;  // has the model's coordinates, and the point's if it is binary64
  Integer x[3], w;  // if it is not binary64: x / w, w > 0, in units of the lattice

  Point(const Answer& answer, bool nearest, const Lattice& model) : lattice(model) {
    const char* at = answer.line;
    Coordinate c[3];
    for (int k = 0; k < 3; ++k) {
      c[k] = coordinate(next_word(&at), nearest);
      below[k] = c[k].below;
      above[k] = c[k].above;
      is_binary64 = is_binary64 && below[k] == above[k];
    }
    for (int k = 0; k < 3; ++k) {
      const int64_t up = c[k].twos + 1075 - lattice.low;
      if (is_binary64) {
        lattice.add(below[k]);
      } else if (up >= 0) {
        c[k].n.m = shifted(c[k].n.m, up);
      } else {
        c[k].d = shifted(c[k].d, -up);
      }
    }
    if (is_binary64) return;
    w.m = c[0].d * c[1].d * c[2].d;
    for (int k = 0; k < 3; ++k) {
      x[k].m = c[k].n.m * c[(k + 1) % 3].d * c[(k + 2) % 3].d;
      x[k].neg = c[k].n.neg;
    }
  }
  bool is_in_box(const int64_t* min, const int64_t* max) const {
    bool is_in = true;
    for (int k = 0; k < 3; ++k) is_in = is_in && min[k] <= below[k] && above[k] <= max[k];
    return is_in;
  }
};

// A triangle may contain a point, or its ray may stab it, or both. The answer is kOn or what it adds to the sum.
enum { kOn = 2 };
struct Question {
  const Point& q;
  const int64_t* corner[3];  // as keys
  bool may_contain, may_be_stabbed;
  int u;
  bool upward;

  template <class V>
  int answer(const V* edge, const V* to) const {
    if (may_contain && lies_on(edge, to)) return kOn;
    if (!may_be_stabbed) return 0;
    const int second = (u + 2) % 3;
    bool has_reached[3];
    for (int i = 0; i < 3; ++i) has_reached[i] = corner[i][second] <= q.below[second];
    return crossing(edge, to, has_reached, u, upward);
  }
};

template <int C>
class FixedQuestion {  // about a binary64 point
 public:
  explicit FixedQuestion(const Question& question) : question_(question) {}
  int result() const {
    const int low = question_.q.lattice.low;
    const Vec<C> q = lattice_point<C>(question_.q.below, low);
    Vec<C> corner[3], edge[3], to[3];
    for (int i = 0; i < 3; ++i) corner[i] = lattice_point<C>(question_.corner[i], low);
    for (int i = 0; i < 3; ++i) {
      edge[i] = corner[(i + 1) % 3] - corner[i];
      to[i] = q - corner[i];
    }
    return question_.answer(edge, to);
  }

 private:
  const Question& question_;
};

int answer_about_rational(const Question& question) {
  IntegerVec corner[3], edge[3], to[3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const int64_t key = question.corner[i][k];
      if (key == 0) continue;
      const int zeros = __builtin_ctzll(key_mantissa(key));
      const uint64_t m = key_mantissa(key) >> zeros;
      Integer* const x = &corner[i].x[k];
      x->m = {uint32_t(m), uint32_t(m >> 32)};
      drop_zeros(&x->m);
      x->m = shifted(x->m, key_exponent(key) + zeros - question.q.lattice.low);
      x->neg = key < 0;
    }
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      edge[i].x[k] = corner[(i + 1) % 3].x[k] - corner[i].x[k];
      to[i].x[k] = question.q.x[k] - question.q.w * corner[i].x[k];
    }
  return question.answer(edge, to);
}

class PointsCheck {
 public:
  PointsCheck(const Statement& statement, const Model& model, const Body& body)
      : model_(model),
        nearest_(statement.text.at("decimals") == "nearest"),
        lattice_(model),
        tree_(model, Order(model).result(), std::vector<uint8_t>(model.vertices())),
        work_(model, body) {}

  // The first condition that fails is named, and the work comes first: after a failure it is only counted.
  void check(const std::vector<Answer>& answers) {
    work_.limit = 10 * uint64_t(model_.faces()) + 1000 * uint64_t(answers.size());
    if (!is_closed(model_)) fail("P1", "the triangles are no closed chain");
    for (size_t i = 0; i < answers.size(); ++i) {
      const Answer& a = answers[i];
      if (a.word == Answer::kUndecided) continue;
      const Point q(a, nearest_, lattice_);
      const std::string line = " in line " + std::to_string(i + 1);
      if (a.word == Answer::kOn) {
        check_on(q, a.code, line);
      } else {
        check_off(q, a, line);
      }
    }
    if (!failure_.id.empty()) throw failure_;
  }

 private:
  bool has_failed() const { return !failure_.id.empty(); }
  void fail(const char* id, const std::string& why) {
    if (!has_failed()) failure_ = Rejected{id, why};
  }

  int ask(const Question& question) const {
    if (!question.q.is_binary64) return answer_about_rational(question);
    return with_limbs<FixedQuestion, int>(question.q.lattice.bits, question);
  }
  const int64_t* key(uint32_t v) const { return &model_.key[3 * size_t(v)]; }

  void check_on(const Point& q, uint32_t face, const std::string& line) {  // P2
    work_.add(1);
    if (has_failed()) return;
    const uint32_t* const t = &model_.tri[3 * size_t(face)];
    int64_t min[3], max[3];
    for (int k = 0; k < 3; ++k) {
      min[k] = std::min(std::min(key(t[0])[k], key(t[1])[k]), key(t[2])[k]);
      max[k] = std::max(std::max(key(t[0])[k], key(t[1])[k]), key(t[2])[k]);
    }
    const Question question = {q, {key(t[0]), key(t[1]), key(t[2])}, true, false, 0, true};
    if (!q.is_in_box(min, max) || ask(question) != kOn)
      fail("P2", "the triangle of its code does not contain the point" + line);
  }

  void check_off(const Point& q, const Answer& a, const std::string& line) {  // P3 and P4
    sum_ = 0;
    is_on_ = false;
    search(tree_.root(), q, int(a.code) / 2, a.code % 2 == 0);
    if (is_on_) fail("P3", "a triangle contains the point" + line);
    if (sum_ != a.f) fail("P4", "the winding number is not f, but " + std::to_string(sum_) + line);
  }
  // Finds the pairs of section 5. Their conditions on boxes hold for every box that contains one for which they hold.
  void search(const Range& r, const Point& q, int u, bool upward) {
    const TreeNode& n = tree_.nodes[r.node];
    const int p = (u + 1) % 3, s = (u + 2) % 3;
    const bool may_contain = q.is_in_box(n.min, n.max);
    const bool may_be_stabbed = n.min[p] <= q.below[p] && q.below[p] < n.max[p] &&
                                n.min[s] <= q.below[s] && q.below[s] < n.max[s] &&
                                (upward ? q.above[u] <= n.max[u] : n.min[u] <= q.below[u]);
    if (!may_contain && !may_be_stabbed) return;
    if (r.size() > 1) {
      search(r.left(), q, u, upward);
      search(r.right(), q, u, upward);
      return;
    }
    work_.add(1);
    if (has_failed() || is_on_) return;
    const uint32_t* const t = &tree_.corners[3 * size_t(r.lo)];
    const int found =
        ask({q, {key(t[0]), key(t[1]), key(t[2])}, may_contain, may_be_stabbed, u, upward});
    is_on_ = found == kOn;
    sum_ += found;
  }

  const Model& model_;
  const bool nearest_;
  const Lattice lattice_;
  const Tree tree_;
  Work work_;
  Rejected failure_;
  int64_t sum_ = 0;     // of the triangles that the point's ray stabs
  bool is_on_ = false;  // whether the point lies on a triangle
};

}  // namespace

std::string check_points(const Statement& statement, std::string file, const Body& body) {
  std::vector<Answer> answers = read_answers(statement);
  const std::string counts =
      std::to_string(answers.size()) + " points, " + std::to_string(statement.number.at("on")) +
      " on, " + std::to_string(statement.number.at("undecided")) + " undecided";
  if (is_about_patches(statement)) {
    check_points_of_patches(statement, file, body, answers);
    return counts;
  }
  const Model model = read_model(std::move(file), statement.text.at("subject_format"),
                                 statement.flag.at("as_indexed"));
  read_body(model, body, &answers);
  PointsCheck(statement, model, body).check(answers);
  return counts;
}
