// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/write_splines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>

#include "io/base/exact_number.h"
#include "io/splines/read_splines.h"

namespace veritope {
namespace {

// Whether the models are equal up to names, attributes and groups.
bool same_shapes(const SplineModel& a, const SplineModel& b) {
  if (a.entities.size() != b.entities.size()) return false;
  for (std::size_t i = 0; i < a.entities.size(); ++i)
    if (a.entities[i].shape != b.entities[i].shape) return false;
  return true;
}

// The number of entities that are missing or differ afterwards; compared by position, as writers keep the order.
std::size_t num_changed(const SplineModel& model, const SplineModel& back) {
  std::size_t changed = 0, j = 0;
  for (const SplineEntity& entity : model.entities) {
    if (j < back.entities.size() && entity.shape == back.entities[j].shape) {
      ++j;
      continue;
    }
    ++changed;
    // A rounded entity has the same kind and the same place.
    if (j < back.entities.size() && entity.shape.index() == back.entities[j].shape.index()) ++j;
  }
  return changed;
}

// Which entity has more coordinates than .itd holds.
std::optional<std::string> beyond_itd(const SplineModel& model) {
  constexpr int kMostCoordinatesOfItd = 9;
  for (std::size_t i = 0; i < model.entities.size(); ++i) {
    int most = 0;
    for_each_spline(model.entities[i], [&](const auto& s) { most = std::max(most, s.dimension()); });
    if (most > kMostCoordinatesOfItd)
      return "entity " + std::to_string(i) + " has " + std::to_string(most) +
             " coordinates, and .itd holds at most " + std::to_string(kMostCoordinatesOfItd);
  }
  return std::nullopt;
}

// At least 17 significant digits, truncated, of a magnitude that binary64 does not have. REQUIRES value != 0.
std::string seventeen_digits(const Rational& value, const ReadLimits& limits) {
  const auto bits = static_cast<std::int64_t>(value.numerator().bit_length()) -
                    static_cast<std::int64_t>(value.denominator().bit_length());
  const std::int64_t exponent = bits * 30103 / 100000 - 19;  // log10(2) = 0.30103
  const Rational scale(power(Integer(10), static_cast<std::uint64_t>(std::abs(exponent))));
  const Rational scaled = exponent < 0 ? abs(value) * scale : abs(value) / scale;
  std::string digits = floor_divide(scaled.numerator(), scaled.denominator()).to_string();
  std::int64_t zeros = 0;
  for (; digits.back() == '0'; ++zeros) digits.pop_back();
  const auto spelled = spell_decimal(digits, exponent + zeros, limits);
  return (value.sign() == Sign::kNegative ? "-" : "") +
         spelled.value_or(digits + "e" + std::to_string(exponent + zeros));
}

}  // namespace

bool can_write(SplineFormat format) {
  return format == SplineFormat::kItd || format == SplineFormat::kG2 ||
         format == SplineFormat::kJson;
}

std::string spline_bytes(const SplineModel& model, SplineFormat format, const ReadLimits& limits) {
  VT_CHECK(can_write(format), "spline_bytes needs a format that is written");
  if (format == SplineFormat::kItd) return itd_bytes(model, limits);
  return format == SplineFormat::kG2 ? g2_bytes(model, limits) : spline_json_bytes(model);
}

SplineLoss spline_loss(const SplineModel& model, SplineFormat format, const std::string& bytes,
                       const ReadLimits& limits) {
  SplineLoss loss;
  const auto too_many = format == SplineFormat::kItd ? beyond_itd(model) : std::nullopt;
  if (bytes.empty()) {
    loss.unreadable = Error{
        Code::kEmpty, {}, "no spline is left for it to hold" + (too_many ? ": " + *too_many : "")};
    return loss;
  }
  if (too_many) loss.shapes.push_back(*too_many);
  const ByteBuffer buffer =
      copy_to_buffer({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
  const std::string name = "output";
  const auto file = read_splines(format, source_of(buffer, name), limits);
  if (!file) {
    loss.unreadable = file.error();
    return loss;
  }
  const SplineModel& back = file->model;
  if (model == back) return loss;
  if (!same_shapes(model, back))
    loss.shapes.push_back(std::to_string(num_changed(model, back)) + " of " +
                          std::to_string(model.entities.size()) +
                          " entities are rounded or left out");
  bool has_text = false;
  for (const SplineEntity& e : model.entities)
    has_text = has_text || !e.attributes.empty() || e.group;
  if (has_text || !model.groups.empty())
    loss.dropped.push_back("names, attributes or the order of groups");
  return loss;
}

std::string decimal_or_nearest(const Rational& value, const ReadLimits& limits) {
  if (auto text = exact_decimal(value, limits)) return std::move(*text);
  char digits[32];
  const double nearest = nearest_double(value);
  if (nearest == 0 || !std::isfinite(nearest)) return seventeen_digits(value, limits);
  const auto end = std::to_chars(digits, digits + sizeof digits, nearest);
  return {digits, static_cast<std::size_t>(end.ptr - digits)};
}

}  // namespace veritope
