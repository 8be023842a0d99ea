// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_control.cc: the control points of a file in their order, and which are missing
// (solids/dms/dms_validity.h).
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_simplices_internal.h"
#include "solids/dms/dms_validity.h"

namespace veritope {
namespace {

std::string key_text(std::span<const std::uint32_t> numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += (i > 0 ? "," : "") + std::to_string(numbers[i]);
  return text + "]";
}

// The name of an entry's key.
std::string entry_name(std::span<const std::uint32_t> key, bool is_separate) {
  if (!is_separate) return "the vertices " + key_text(key);
  return "tetrahedron " + std::to_string(key[0]) + ", beta " + key_text(key.subspan(1));
}

class DmsControlOrder {
 public:
  DmsControlOrder(DmsModel& model, DmsEntries entries)
      : model_(model), entries_(std::move(entries)), size_(entries_.key_size(model.degree)) {}

  Status set() {
    VT_CHECK(model_.control.values.empty(), "control points are set once");
    VT_CHECK(entries_.keys.size() / size_ * model_.num_components() == entries_.values.size(),
             "each entry has a value");
    order_.resize(entries_.keys.size() / size_);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [this](std::size_t a, std::size_t b) { return is_before(a, b); });
    for (std::size_t i = 1; i < order_.size(); ++i)
      if (std::ranges::equal(key(order_[i - 1]), key(order_[i])))
        return error_at(order_[i], "there are two control points of ");
    if (const Status status = entries_.are_separate ? check_separate() : check_shared(); !status)
      return status;
    store();
    return ok_status();
  }

 private:
  std::span<const std::uint32_t> key(std::size_t entry) const {
    return std::span(entries_.keys).subspan(entry * size_, size_);
  }
  // Tetrahedra ascend, and the numbers of β descend; vertices ascend. Equal keys keep the order of the file.
  bool is_before(std::size_t a, std::size_t b) const {
    const auto p = key(a), q = key(b);
    const auto [i, j] = std::mismatch(p.begin(), p.end(), q.begin());
    if (i == p.end()) return a < b;
    return entries_.are_separate && i != p.begin() ? *i > *j : *i < *j;
  }
  Error error_at(std::size_t entry, const std::string& what) const {
    Error error = bad_argument(what + entry_name(key(entry), entries_.are_separate));
    error.place.entity = entry;
    return error;
  }

  Status check_shared() const {
    const internal::DmsSimplices simplices(model_.tetrahedra);
    for (std::size_t e = 0; e < order_.size(); ++e)
      if (!simplices.contains(key(e)))
        return error_at(e, "no tetrahedron has the control point of ");
    if (order_.size() == simplices.num_multisets(model_.degree)) return ok_status();
    return missing();
  }
  Status check_separate() const {
    const std::uint64_t needed =
        std::uint64_t{model_.tetrahedra.size()} * num_tetrahedral_indices(model_.degree);
    return order_.size() == needed ? ok_status() : missing();
  }
  // The first control point, by tetrahedra, that no entry has. REQUIRES that there is one.
  Status missing() const {
    std::string found;
    for (std::uint32_t t = 0; found.empty() && t < model_.tetrahedra.size(); ++t)
      for_each_tetrahedral_index(model_.degree, [&](const TetrahedralIndex& beta) {
        std::vector<std::uint32_t> wanted = control_vertices(model_.tetrahedra[t], beta);
        if (entries_.are_separate)
          wanted.assign({t}), wanted.insert(wanted.end(), beta.begin(), beta.end());
        if (found.empty() && !has_key(wanted)) found = entry_name(wanted, entries_.are_separate);
      });
    VT_CHECK(!found.empty(), "a control point is missing");
    return bad_argument("there is no control point of " + found);
  }
  bool has_key(const std::vector<std::uint32_t>& wanted) const {
    const auto at = std::partition_point(order_.begin(), order_.end(), [&](std::size_t e) {
      const auto p = key(e);
      const auto [i, j] = std::mismatch(p.begin(), p.end(), wanted.begin());
      if (i == p.end()) return false;
      return entries_.are_separate && i != p.begin() ? *i > *j : *i < *j;
    });
    return at != order_.end() && std::ranges::equal(key(*at), wanted);
  }

  void store() {
    DmsControl& control = model_.control;
    control.is_separate = entries_.are_separate;
    const std::size_t components = model_.num_components();
    control.values.reserve(entries_.values.size());
    for (const std::size_t e : order_) {
      if (!control.is_separate) control.at.insert(control.at.end(), key(e).begin(), key(e).end());
      for (std::size_t c = 0; c < components; ++c)
        control.values.push_back(std::move(entries_.values[e * components + c]));
    }
  }

  DmsModel& model_;
  DmsEntries entries_;
  std::size_t size_;
  std::vector<std::size_t> order_;
};

}  // namespace

Status set_dms_control(DmsModel& model, DmsEntries entries) {
  return DmsControlOrder(model, std::move(entries)).set();
}

}  // namespace veritope
