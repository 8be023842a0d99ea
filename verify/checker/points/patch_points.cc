// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_points.cc: the conditions of docs/certificates/points.md, section 6, in their order.
#include "patch_points.h"

namespace {

const uint64_t kBytesOfPatch = 3;  // of the model and the body

Big big_of(const Nat& digits) {
  Big r;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i % 2 == 0) r.m.push_back(0);
    r.m.back() |= uint64_t(digits[i]) << 32 * (i % 2);
  }
  return r.trim();
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
}  // namespace

bool is_about_patches(const Statement& s) {
  const std::string& format = s.text.at("subject_format");
  return format != "stl" && format != "obj" && format != "ply" && format != "off";
}

RationalPoint rational_point(const Coordinate* coordinates) {
  Ratio x[3];
  for (int k = 0; k < 3; ++k) {
    const Coordinate& c = coordinates[k];
    x[k] = Ratio(big_of(c.n.m), big_of(c.d));
    x[k].n.neg = c.n.neg;
    x[k] = scaled(lowest(x[k]), c.twos);
  }
  return RationalPoint(x);
}

PatchSurface::PatchSurface(std::vector<Entity> entities, uint64_t bytes)
    : entities_(std::move(entities)), bytes_(bytes) {
  cuts_.entities = &entities_;
}

void PatchSurface::read_counts(Bytes* r) {
  num_patches_ = r->body.natural(4);
  require(r->body.natural(4) == entities_.size() && !entities_.empty(), "B1",
          "the model's number of entities is", entities_.size());
}

void PatchSurface::read_breaks(uint64_t body_size, Bytes* r) {
  ::read_breaks(false, r, &cuts_);
  require(num_patches_ == cuts_.patches(), "B1", "the number of patches is", cuts_.patches());
  require(num_patches_ <= (bytes_ + body_size) / kBytesOfPatch, "B1",
          "too few bytes for the patches", num_patches_);
}

PlaceOnPatch PatchSurface::read_place(Bytes* r) const {
  PlaceOnPatch place;
  place.patch = r->varint();
  require(place.patch < num_patches_, "B1", "there is no patch", place.patch);
  if (r->at_most(r->body.natural(1), 1, "there is no kind of place") == 1) {
    place.algebraic = std::make_shared<Algebraic>(Algebraic::read(r));
  } else {
    for (Ratio& t : place.at) t = r->rational();
  }
  return place;
}

void PatchSurface::glue() {
  check_kinds(entities_);
  std::vector<Place> places;
  for (size_t i = 0; i < entities_.size(); ++i)
    for (uint64_t k = cuts_.first[i]; k < cuts_.first[i + 1]; ++k)
      places.push_back(cuts_.place(i, k));
  cut_patches(places, 0, cuts_.breaks, [this](Patch&& p) { patches_.push_back(std::move(p)); });
  const Gluing x(&patches_);
  for (const Patch& p : patches_) grids_.emplace_back(p);
  boxes_.reset(new PatchBoxes(grids_));
  for (uint32_t i = 0; i < patches_.size(); ++i)
    for (uint32_t k = 0; k < uint32_t(patches_[i].shape.sides()); ++k) {
      corners_[patches_[i].vertex[k]].push_back(4 * i + k);
      sides_[patches_[i].pair[k]].push_back(4 * i + k);
    }
}

int64_t PatchSurface::winding(const RationalPoint& q, int direction, const std::string& where,
                              PointUnits* units) const {
  return winding_number(grids_, *boxes_, q, direction, where, units);
}

uint64_t PatchSurface::units_at(uint32_t patch, const RationalPoint& q,
                                const PlaceOnPatch& place) const {
  const Grid& grid = grids_[patch];
  uint64_t g = 0;
  for (const Ratio& t : place.at) g = std::max(g, uint64_t(std::max(t.n.bits(), t.d.bits())));
  return 16 + (grid.count() * grid.degrees() * (uint64_t(grid.bits + q.bits) + grid.degrees() * g) *
                   (64 + g) >>
               18);
}

void PatchSurface::check_on(const RationalPoint& q, const PlaceOnPatch& code,
                            const std::string& where, PointUnits* units) const {
  const Grid& grid = grids_[code.patch];
  if (code.algebraic != nullptr) {
    units->add(code.algebraic->units(grid, q));
    const char* const why = code.algebraic->why_not_on(grid, q);
    if (why != nullptr) throw Rejected{"P2", why + where};
    return;
  }
  units->add(units_at(uint32_t(code.patch), q, code));
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

void check_points_of_patches(const Statement& s, const std::string& file, const Body& body,
                             const std::vector<Answer>& answers) {
  PatchSurface surface(read_spline_model(file, s.text.at("subject_format")), file.size());
  const uint64_t body_size = body.left();
  Bytes r(body);
  require(r.body.begins_with("VTPT"), "B1", "the body does not start with VTPT");
  surface.read_counts(&r);
  require(r.body.natural(8) == answers.size(), "B1", "the number of points is", answers.size());
  surface.read_breaks(body_size, &r);
  std::vector<int> directions(answers.size());
  std::vector<PlaceOnPatch> places(answers.size());
  for (size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].word == Answer::kOn) places[i] = surface.read_place(&r);
    if (answers[i].word == Answer::kOff)
      directions[i] = int(r.at_most(r.body.natural(1), 5, "there is no direction"));
  }
  r.end();

  surface.glue();
  PointUnits units(file.size() + body_size, answers.size());
  for (size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].word == Answer::kUndecided) continue;
    units.begin_point();
    Coordinate c[3];
    read_point(answers[i], s.text.at("decimals") == "nearest", c);
    const RationalPoint q = rational_point(c);
    const std::string where = " in line " + std::to_string(i + 1);
    if (answers[i].word == Answer::kOn) {
      surface.check_on(q, places[i], where, &units);
      continue;
    }
    const int64_t found = surface.winding(q, directions[i], where, &units);
    if (found != answers[i].f)
      throw Rejected{"P4", "the winding number is not f, but " + std::to_string(found) + where};
  }
}
