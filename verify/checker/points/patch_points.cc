// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_points.cc: the conditions of docs/certificates/points.md, section 6, in their order.
#include "patch_points.h"

#include "algebraic.h"
#include "patch_winding.h"

namespace {

const uint64_t kBytesOfPatch = 3;  // of the model and the body

struct PointCode {
  int direction;  // of a point off the patches
  uint64_t patch;
  Ratio at[2];                           // parameters
  std::shared_ptr<Algebraic> algebraic;  // instead of them, if not null
};

struct Reader : Bytes {
  explicit Reader(const Body& bytes) : Bytes(bytes) {}

  PointCode code(const Answer& answer, uint64_t patches) {
    PointCode r = {0, 0, {}, nullptr};
    if (answer.word == Answer::kUndecided) return r;
    if (answer.word == Answer::kOff) {
      r.direction = int(at_most(body.natural(1), 5, "there is no direction"));
      return r;
    }
    r.patch = varint();
    require(r.patch < patches, "B1", "there is no patch", r.patch);
    if (at_most(body.natural(1), 1, "there is no kind of place") == 1) {
      r.algebraic = std::make_shared<Algebraic>(Algebraic::read(this));
    } else {
      for (Ratio& t : r.at) t = rational();
    }
    return r;
  }
};

Big big_of(const Nat& digits) {
  Big r;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i % 2 == 0) r.m.push_back(0);
    r.m.back() |= uint64_t(digits[i]) << 32 * (i % 2);
  }
  return r.trim();
}
RationalPoint point_of(const Answer& answer, bool nearest) {
  const char* at = answer.line;
  Ratio x[3];
  for (Ratio& r : x) {
    const Coordinate c = coordinate(next_word(&at), nearest);
    r = Ratio(big_of(c.n.m), big_of(c.d));
    r.n.neg = c.n.neg;
    r = lowest(r);
    r = scaled(r, c.twos);
  }
  return RationalPoint(x);
}

bool is_in_domain(const Grid& grid, const Ratio* t) {
  for (int k = 0; k < 2; ++k)
    if (t[k].n.sign() < 0 || t[k].d < t[k].n) return false;
  return !grid.is_triangle || !(t[0].d * t[1].d < t[0].n * t[1].d + t[1].n * t[0].d);
}
// The parameters of the tensor patch.
void to_square(const Grid& grid, const Ratio* t, Ratio* uv) {
  uv[0] = t[0], uv[1] = t[1];
  if (!grid.is_triangle) return;
  const Big first = t[0].n * t[1].d, second = t[1].n * t[0].d, sum = first + second;
  uv[0] = lowest(Ratio(sum, t[0].d * t[1].d));
  uv[1] = sum.sign() == 0 ? Ratio() : lowest(Ratio(second, sum));
}
void check_on(const Grid& grid, const RationalPoint& q, const PointCode& code,
              const std::string& where, PointUnits* units) {
  if (code.algebraic != nullptr) {
    units->add(code.algebraic->units(grid, q));
    const char* const why = code.algebraic->why_not_on(grid, q);
    if (why != nullptr) throw Rejected{"P2", why + where};
    return;
  }
  uint64_t g = 0;
  for (const Ratio& t : code.at) g = std::max(g, uint64_t(std::max(t.n.bits(), t.d.bits())));
  units->add(16 + (grid.count() * grid.degrees() *
                       (uint64_t(grid.bits + q.bits) + grid.degrees() * g) * (64 + g) >>
                   18));
  if (!is_in_domain(grid, code.at))
    throw Rejected{"P2", "the parameters leave the domain of the patch" + where};
  Ratio uv[2];
  to_square(grid, code.at, uv);
  const std::vector<Big> net = grid.around(q);
  for (int k = 0; k < 3; ++k) {
    std::vector<Big> along_u;
    for (int i = 0; i <= grid.shape.p; ++i) {
      std::vector<Big> row;
      for (int j = 0; j <= grid.shape.q; ++j)
        row.push_back(net[size_t(3 * grid.shape.at(i, j) + k)]);
      along_u.push_back(value_at(std::move(row), uv[1].n, uv[1].d));
    }
    if (value_at(std::move(along_u), uv[0].n, uv[0].d).sign() != 0)
      throw Rejected{"P2", "the patch has another point at the parameters" + where};
  }
}

}  // namespace

bool is_about_patches(const Statement& s) {
  const std::string& format = s.text.at("subject_format");
  return format != "stl" && format != "obj" && format != "ply" && format != "off";
}

void check_points_of_patches(const Statement& s, const std::string& file, const Body& body,
                             const std::vector<Answer>& answers) {
  const std::vector<Entity> entities = read_spline_model(file, s.text.at("subject_format"));
  const uint64_t bytes = file.size() + body.left();
  Reader r(body);
  require(r.body.begins_with("VTPT"), "B1", "the body does not start with VTPT");
  const uint64_t num_patches = r.body.natural(4);
  require(r.body.natural(4) == entities.size() && !entities.empty(), "B1",
          "the model's number of entities is", entities.size());
  require(r.body.natural(8) == answers.size(), "B1", "the number of points is", answers.size());
  Cuts cuts;
  cuts.entities = &entities;
  read_breaks(false, &r, &cuts);
  require(num_patches == cuts.patches(), "B1", "the number of patches is", cuts.patches());
  require(num_patches <= bytes / kBytesOfPatch, "B1", "too few bytes for the patches", num_patches);
  std::vector<PointCode> codes;
  for (const Answer& a : answers) codes.push_back(r.code(a, num_patches));
  r.end();

  check_kinds(entities);
  std::vector<Place> places;
  for (size_t i = 0; i < entities.size(); ++i)
    for (uint64_t k = cuts.first[i]; k < cuts.first[i + 1]; ++k) places.push_back(cuts.place(i, k));
  std::vector<Patch> patches;
  cut_patches(places, 0, cuts.breaks, [&](Patch&& p) { patches.push_back(std::move(p)); });
  const Gluing x(&patches);
  const std::vector<Grid> grids(patches.begin(), patches.end());
  const PatchBoxes boxes(grids);
  PointUnits units(bytes, answers.size());
  const bool nearest = s.text.at("decimals") == "nearest";
  for (size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].word == Answer::kUndecided) continue;
    units.begin_point();
    const RationalPoint q = point_of(answers[i], nearest);
    const std::string where = " in line " + std::to_string(i + 1);
    if (answers[i].word == Answer::kOn) {
      check_on(grids[codes[i].patch], q, codes[i], where, &units);
      continue;
    }
    const int64_t found = winding_number(grids, boxes, q, codes[i].direction, where, &units);
    if (found != answers[i].f)
      throw Rejected{"P4", "the winding number is not f, but " + std::to_string(found) + where};
  }
}
