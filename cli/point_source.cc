// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/point_source.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include "cli/line_reader.h"
#include "io/points/npy_header.h"

namespace veritope::cli {
namespace {

// Finite even beyond binary64: such a point lies far outside of every model.
double rounded(const Rational& x) {
  constexpr double kMost = std::numeric_limits<double>::max();
  return std::clamp(nearest_double(x), -kMost, kMost);
}

class TextPoints : public PointSource {
 public:
  /// @param waits  whether the points may come from a program that waits for their answers
  TextPoints(LineReader lines, std::string name, bool waits, Decimals decimals,
             const ReadLimits& limits, std::size_t dimension)
      : lines_(std::move(lines)),
        name_(std::move(name)),
        waits_(waits),
        reader_(decimals, limits, dimension) {}

  Status next(PointBatch& batch) override {
    batch.clear();
    while (batch.size() < kBatch) {
      if (waits_ && batch.size() > 0 && lines_.must_read()) break;
      const Result<std::optional<std::string_view>> line = lines_.next();
      if (!line) return line.error();
      if (!*line) break;
      if (lines_.line() == 1 &&
          looks_like_npy(
              {reinterpret_cast<const unsigned char*>((*line)->data()), (*line)->size()}))
        return error({1, "an .npy file is read from a regular file only, whose name is given"});
      std::optional<PointFault> fault;
      std::optional<ReadPoint> point = reader_.read(**line, fault);
      if (fault) return error(*fault);
      if (point) add(*std::move(point), batch);
    }
    return ok_status();
  }

 private:
  static void add(ReadPoint point, PointBatch& batch) {
    if (const auto* p = std::get_if<Vec3d>(&point.point)) return batch.add(point.tokens, *p);
    auto& exact = std::get<ExactPoint>(point.point);
    batch.add(point.tokens, {rounded(exact[0]), rounded(exact[1]), rounded(exact[2])});
    batch.exact.emplace_back(batch.size() - 1, std::move(exact));
  }
  Error error(const PointFault& fault) const {
    Error out{Code::kSyntax, {}, "column " + std::to_string(fault.column) + ": " + fault.message};
    out.place.file = name_ + ":" + std::to_string(lines_.line());
    return out;
  }

  LineReader lines_;
  std::string name_;
  bool waits_;
  PointLines reader_;
};

// The number of bytes that were read: fewer at the end of the file, or if it cannot be read.
std::size_t read_some(std::ifstream& file, std::span<unsigned char> out) {
  file.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
  return static_cast<std::size_t>(file.gcount());
}

bool is_regular(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

std::string hexadecimal(double x) {
  std::array<char, 40> out{};
  const int length = std::snprintf(out.data(), out.size(), "%a", x);
  return std::string(out.data(), static_cast<std::size_t>(length));
}

class NpyPoints : public PointSource {
 public:
  NpyPoints(std::ifstream bytes, std::string name, const NpyHeader& header)
      : bytes_(std::move(bytes)), name_(std::move(name)), header_(header) {}

  Status next(PointBatch& batch) override {
    batch.clear();
    for (; batch.size() < kBatch && row_ < header_.num_points; ++row_) {
      std::array<unsigned char, 24> row{};
      if (read_some(bytes_, std::span(row).first(header_.row_bytes())) != header_.row_bytes())
        return error(Code::kTruncated, "the file ends before row " + std::to_string(row_) + " of " +
                                           std::to_string(header_.num_points));
      const Vec3d p = npy_row(header_, row.data());
      for (int k = 0; k < static_cast<int>(header_.num_columns); ++k)
        if (!std::isfinite(p[k]))
          return error(Code::kNotFinite, "row " + std::to_string(row_) + ", column " +
                                             std::to_string(k) +
                                             " is not finite: " + hexadecimal(p[k]));
      const std::array<std::string, 3> text = {hexadecimal(p.x), hexadecimal(p.y),
                                               header_.num_columns == 3 ? hexadecimal(p.z) : ""};
      batch.add({text[0], text[1], text[2]}, p);
    }
    return batch.size() == 0 ? check_end() : ok_status();
  }

 private:
  Status check_end() {
    std::array<unsigned char, 1> more{};
    if (read_some(bytes_, more) == 0) return ok_status();
    return error(Code::kSyntax, "bytes follow the number of rows that the header announces, " +
                                    std::to_string(header_.num_points));
  }
  Error error(Code code, std::string message) const {
    Error out{code, {}, std::move(message)};
    out.place.file = name_;
    return out;
  }

  std::ifstream bytes_;
  std::string name_;
  NpyHeader header_;
  std::uint64_t row_ = 0;
};

Result<std::unique_ptr<PointSource>> npy_points(std::ifstream file, const std::string& name,
                                                std::span<const unsigned char> begin,
                                                std::size_t dimension) {
  const Result<NpyHeader> header = read_npy_header(begin, dimension);
  if (!header) {
    Error error = header.error();
    error.place.file = name;
    return error;
  }
  file.clear();
  file.seekg(static_cast<std::streamoff>(header->num_bytes));
  return std::unique_ptr<PointSource>(std::make_unique<NpyPoints>(std::move(file), name, *header));
}

}  // namespace

void PointBatch::clear() {
  points.clear();
  exact.clear();
  text_.clear();
  ends_.clear();
}

void PointBatch::add(const std::array<std::string_view, 3>& tokens, const Vec3d& point) {
  points.push_back(point);
  text_.append(tokens[0]).append(" ").append(tokens[1]);
  if (!tokens[2].empty()) text_.append(" ").append(tokens[2]);
  ends_.push_back(text_.size());
}

Result<std::unique_ptr<PointSource>> open_points(const std::string& path, Decimals decimals,
                                                 const ReadLimits& limits, std::size_t dimension) {
  const std::string name = path == "-" ? "standard input" : path;
  if (path != "-" && is_regular(path)) {
    std::ifstream file(path, std::ios::binary);
    std::vector<unsigned char> begin(kMostNpyHeader);
    begin.resize(read_some(file, begin));
    if (looks_like_npy(begin)) return npy_points(std::move(file), name, begin, dimension);
  }
  Result<LineReader> lines = LineReader::open(path);
  if (!lines) return lines.error();
  return std::unique_ptr<PointSource>(std::make_unique<TextPoints>(
      std::move(*lines), name, !is_regular(path), decimals, limits, dimension));
}

}  // namespace veritope::cli
