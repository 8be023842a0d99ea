// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/parsed_mesh.h"

#include <numeric>

namespace veritope {

void IgnoredCounts::add(std::string_view name, std::uint64_t count) {
  if (count == 0) return;
  for (auto& [known, sum] : counts_) {
    if (known == name) {
      sum += count;
      return;
    }
  }
  if (counts_.size() < kMost) {
    counts_.emplace_back(name, count);
  } else {
    if (counts_.size() == kMost) counts_.emplace_back("other", 0);
    counts_.back().second += count;
  }
}

std::vector<std::pair<std::string, std::uint64_t>> IgnoredCounts::take(std::string_view suffix) {
  for (auto& [name, count] : counts_) name = escaped(name).append(suffix);
  return std::move(counts_);
}

bool FaceSink::add_polygon(std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) return add_triangle(corners[0], corners[1], corners[2]);
  if (faces.size() + (corners.size() - 2) > max_faces_) return false;
  if (polygons_split++ == 0) {
    num_polygons_ = static_cast<std::uint32_t>(faces.size());
    polygon_of_face.resize(faces.size());
    std::iota(polygon_of_face.begin(), polygon_of_face.end(), 0u);
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    faces.push_back({corners[0], corners[i], corners[i + 1]});
    polygon_of_face.push_back(num_polygons_);
  }
  ++num_polygons_;
  return true;
}

void notice_rest(std::uint64_t bytes, const std::string& what, ReadReport& report) {
  if (bytes == 0) return;
  report.notices.push_back(
      {"data-after-end", std::to_string(bytes) +
                             (bytes == 1 ? " more byte follows " : " more bytes follow ") + what +
                             ": the count may be wrong"});
}

void take_faces(FaceSink& sink, ParsedMesh& parsed) {
  parsed.mesh.faces = std::move(sink.faces);
  parsed.polygon_of_face = std::move(sink.polygon_of_face);
  parsed.report.polygons_split = sink.polygons_split;
}

}  // namespace veritope
