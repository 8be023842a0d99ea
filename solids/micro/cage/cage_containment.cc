// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/cage_containment.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "solids/micro/cage/content_search_internal.h"
#include "solids/vmodel/v_faces.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

constexpr std::size_t kMostSamples = 4096, kMostSamplesAlong = 8;  // of all cells, along an axis
constexpr std::size_t kStarts = 3, kTriesOfGroup = 4;
constexpr int kNewtonSteps = 24;

// The groups of parts that are connected by common points.
class PartGroups {
 public:
  explicit PartGroups(const CageContent& content) : parent_(content.points.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::size_t i = 0; i < content.num_parts(); ++i)
      for (const std::uint32_t c : content.part(i)) join(content.part(i).front(), c);
  }
  std::uint32_t root(std::uint32_t p) {
    while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
    return p;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(b)] = root(a); }
  std::vector<std::uint32_t> parent_;
};

using Parameters = std::array<double, 3>;

Point3d approx_image(const VVolume& cell, const Parameters& at) {
  const auto p = point(cell, {Rational::from_double(at[0]), Rational::from_double(at[1]),
                              Rational::from_double(at[2])})
                     .value();
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

Point3d difference(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double approx_length(const Point3d& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

// The solution of the equations with these columns; NaN or infinite where the determinant vanishes.
Point3d solved(const std::array<Point3d, 3>& columns, const Point3d& right) {
  const auto det = [](const Point3d& a, const Point3d& b, const Point3d& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const double whole = det(columns[0], columns[1], columns[2]);
  return {det(right, columns[1], columns[2]) / whole, det(columns[0], right, columns[2]) / whole,
          det(columns[0], columns[1], right) / whole};
}

// Points of cells with images near a given point.
class PreimageSearch {
 public:
  explicit PreimageSearch(const VModel& cage) : cage_(cage) {
    for (std::uint32_t c = 0; c < cage.num_cells(); ++c) add_samples(c);
  }

  // The exact image of a point inside of a cell that is near p; nothing if none was found.
  std::optional<CellPoint> image_near(const CellPoint& p) const {
    const Point3d goal = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      order.emplace_back(approx_length(difference(samples_[i].image, goal)), i);
    const std::size_t n = std::min(kStarts, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end());
    for (std::size_t i = 0; i < n; ++i)
      if (auto image = from(samples_[order[i].second], goal)) return image;
    return std::nullopt;
  }

 private:
  struct Sample {
    std::uint32_t cell;
    Parameters at;
    Point3d image;
  };

  void add_samples(std::uint32_t c) {
    const VVolume& cell = cage_.cell(c);
    std::size_t side = 2;
    while (side < kMostSamplesAlong &&
           (side + 1) * (side + 1) * (side + 1) * cage_.num_cells() <= kMostSamples)
      ++side;
    const Grid<3> grid{{side, side, side}};
    for (std::size_t n = 0; n < grid.count(); ++n) {
      const auto index = grid.index_of(n);
      Sample sample{c, {}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [begin, end] = domain(cell, k);
        sample.at[k] = begin + (end - begin) * (static_cast<double>(index[k]) + 0.5) /
                                   static_cast<double>(side);
      }
      if (!is_inside_of(cell, sample.at)) continue;
      sample.image = approx_image(cell, sample.at);
      samples_.push_back(sample);
    }
  }

  static std::pair<double, double> domain(const VVolume& cell, std::size_t axis) {
    return {nearest_double(cell.axis(axis).domain_begin()),
            nearest_double(cell.axis(axis).domain_end())};
  }
  // Exactly.
  static bool is_inside_of(const VVolume& cell, const Parameters& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(at[k])) return false;
      const Rational x = Rational::from_double(at[k]);
      if (!(cell.axis(k).domain_begin() < x && x < cell.axis(k).domain_end())) return false;
    }
    return true;
  }

  std::optional<CellPoint> from(const Sample& start, const Point3d& goal) const {
    const VVolume& cell = cage_.cell(start.cell);
    Parameters at = start.at;
    Point3d off = difference(goal, start.image);
    for (int step = 0; step < kNewtonSteps; ++step) {
      std::array<Point3d, 3> columns;
      Parameters room;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [begin, end] = domain(cell, k);
        const double h = (end - begin) * 0x1p-20;
        Parameters to = at;
        to[k] += at[k] + h < end ? h : -h;
        room[k] = end - begin;
        if (!is_inside_of(cell, to)) return std::nullopt;
        columns[k] = difference(approx_image(cell, to), difference(goal, off));
        for (double& x : columns[k]) x /= to[k] - at[k];
      }
      const Point3d move = solved(columns, off);
      bool is_small = true;
      for (std::size_t k = 0; k < 3; ++k) {
        if (!std::isfinite(move[k])) return std::nullopt;
        const auto [begin, end] = domain(cell, k);
        // At most to halfway between here and the end of the domain.
        const double to = std::clamp(at[k] + move[k], 0.5 * (at[k] + begin), 0.5 * (at[k] + end));
        is_small = is_small && std::abs(to - at[k]) < 0x1p-40 * room[k];
        at[k] = to;
      }
      if (!is_inside_of(cell, at)) return std::nullopt;
      off = difference(goal, approx_image(cell, at));
      if (is_small) break;
    }
    const auto image = point(cell, {Rational::from_double(at[0]), Rational::from_double(at[1]),
                                    Rational::from_double(at[2])})
                           .value();
    return CellPoint{image[0], image[1], image[2]};
  }

  const VModel& cage_;
  std::vector<Sample> samples_;
};

// Adds a segment from a point of the cage to a corner of each group.
std::optional<CageGap> add_segments(const VModel& cage, CageContent& content) {
  const PreimageSearch search(cage);
  PartGroups groups(content);
  std::vector<std::vector<std::size_t>> parts_of(content.points.size());
  for (std::size_t i = 0; i < content.num_parts(); ++i)
    parts_of[groups.root(content.part(i).front())].push_back(i);
  for (const std::vector<std::size_t>& parts : parts_of) {
    if (parts.empty()) continue;
    std::optional<CellPoint> image;
    std::uint32_t corner = 0;
    const std::size_t stride = 1 + parts.size() / kTriesOfGroup;
    for (std::size_t i = 0; i < parts.size() && !image; i += stride) {
      corner = content.part(parts[i]).front();
      image = search.image_near(content.points[corner]);
    }
    if (!image) return CageGap{parts.front(), std::nullopt};
    content.corners.push_back(corner);
    content.corners.push_back(static_cast<std::uint32_t>(content.points.size()));
    content.points.push_back(std::move(*image));
    content.ends.push_back(content.corners.size());
  }
  return std::nullopt;
}

std::size_t part_with(const CageContent& content, std::uint32_t point) {
  std::size_t i = 0;
  while (std::ranges::find(content.part(i), point) == content.part(i).end()) ++i;
  return i;
}

}  // namespace

std::optional<CageGap> find_gap(const VModel& cage, const CageContent& content,
                                const ContainmentOptions& options) {
  CageContent all = content;
  if (auto gap = add_segments(cage, all)) return gap;
  const internal::ContentSearch search(all);
  const VFaces border = border_of(cage);
  for (std::size_t i = 0; i < border.surfaces.size(); ++i) {
    const auto pieces = bezier_pieces(border.surfaces[i]);
    for (const BezierSurface<Rational>& piece : pieces.pieces) {
      const auto part = search.met_by(internal::enclosed(piece), options.halvings);
      if (!part) continue;
      // A segment that meets the border shows that its image was not near enough.
      const std::size_t number = *part;
      if (number < content.num_parts()) return CageGap{number, border.faces[i]};
      return CageGap{part_with(content, all.part(number).front()), border.faces[i]};
    }
  }
  return std::nullopt;
}

}  // namespace veritope
