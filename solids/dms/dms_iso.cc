// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_iso.h"

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_hulls.h"
#include "solids/dms/dms_iso_cells_internal.h"
#include "solids/dms/dms_iso_mesh_internal.h"

namespace veritope {
namespace {

using internal::IsoCell;
using internal::IsoCells;

class IsoSearch {
 public:
  IsoSearch(IsoCells& cells, const DmsIsoOptions& options, bool extrema_first)
      : cells_(cells),
        options_(options),
        extrema_first_(extrema_first),
        max_cells_(options.max_cells) {}

  void run() {
    narrow();
    if (extrema_first_) max_cells_ = std::min(max_cells_, 2 * cells_.num_alive + kFirstCells);
    prove();
    prove_stars();
  }
  /// Why the cell is in doubt. REQUIRES run().
  std::optional<DmsIsoDoubt> doubt(std::uint32_t number) const {
    const IsoCell& cell = cells_.cells[number];
    if (!cell.is_alive || cell.off != 0) return std::nullopt;
    const bool is_proved = number < is_proved_.size() && is_proved_[number];
    if (cells_.zeros(cell) != 0 && (!is_proved || has_singular(cell))) return DmsIsoDoubt::kVertex;
    if (!is_proved) return DmsIsoDoubt::kOpen;
    return is_crossed(cell) && cells_.is_wide(cell) ? std::optional(DmsIsoDoubt::kWide)
                                                    : std::nullopt;
  }

 private:
  bool is_crossed(const IsoCell& cell) const {
    return std::any_of(cell.corners.begin(), cell.corners.end(), [&](std::uint32_t v) {
      return cells_.vertices[v].sign != cells_.vertices[cell.corners[0]].sign;
    });
  }
  static constexpr std::size_t kFirstCells = 4000;
  static constexpr int kKnotRounds = 6;  // one round of a cell in so many looks for a cut at knots
  static constexpr std::size_t kStarCuts = 40;  // on average at a vertex with g = c
  bool is_full() const { return cells_.num_alive >= max_cells_; }
  bool is_of_interest(std::uint32_t number) const {
    return cells_.cells[number].is_alive && cells_.cells[number].off == 0;
  }

  // Cuts the longest edges of cells that the surface may cross, until none is too long.
  void narrow() {
    struct Wide {
      std::uint32_t cell;
      internal::IsoEdge edge;
      bool operator<(const Wide& other) const {
        return std::tie(edge.squared_length, cell) <
               std::tie(other.edge.squared_length, other.cell);
      }
    };
    std::priority_queue<Wide> wide;
    std::uint32_t next = 0;
    const auto collect = [&] {
      for (; next < cells_.cells.size(); ++next) {
        if (!is_of_interest(next)) continue;
        internal::IsoEdge longest = cells_.longest_edge(cells_.cells[next]);
        if (cells_.is_long(longest.squared_length)) wide.push({next, std::move(longest)});
      }
    };
    for (collect(); !wide.empty() && !is_full(); collect()) {
      const std::uint32_t number = wide.top().cell;
      const std::size_t edge = wide.top().edge.number;
      wide.pop();
      if (is_of_interest(number)) cells_.cut(number, edge, Rational(1) / Rational(2));
    }
  }

  // Cuts cells on which the rule is not proved, in the order in which they came; with `extrema_first` those last whose
  // edges have no extremum. Goes on where it ended.
  void prove() {
    std::deque<std::uint32_t> later;
    while (next_ < cells_.cells.size() || !later.empty()) {
      if (next_ < cells_.cells.size()) {
        is_proved_.push_back(false);
        if (!look_at(next_, extrema_first_)) later.push_back(next_);
        ++next_;
      } else {
        look_at(later.front(), false);
        later.pop_front();
      }
    }
  }
  // Cuts cells at vertices with g = c until g grows in one direction around each. What is proved of a vertex stays so
  // when cells are cut.
  void prove_stars() {
    std::deque<std::uint32_t> left;
    std::uint32_t next = 0;
    const auto collect = [&] {
      for (; next < cells_.vertices.size(); ++next)
        if (cells_.has_star(next)) left.push_back(next);
    };
    collect();
    std::size_t cuts = kStarCuts * left.size();
    for (; !left.empty(); collect()) {
      const std::uint32_t v = left.front();
      left.pop_front();
      if (is_at_corner(v)) continue;
      if (cells_.grows_around(v)) {
        singular_.erase(v);
        continue;
      }
      singular_.insert(v);
      if (is_full() || cuts == 0) continue;
      --cuts;
      cells_.cut_star(v);
      prove();
      left.push_back(v);
    }
  }
  // Whether no vector is parallel to all faces of the domain at a vertex with g = c.
  bool is_at_corner(std::uint32_t vertex) {
    const auto [found, is_new] = at_corner_.try_emplace(vertex);
    if (is_new) found->second = cells_.parallel_at(vertex).empty();
    if (found->second) singular_.insert(vertex);
    return found->second;
  }
  bool has_singular(const IsoCell& cell) const {
    return std::any_of(cell.corners.begin(), cell.corners.end(),
                       [&](std::uint32_t v) { return singular_.contains(v); });
  }
  std::optional<DmsCorners> find_open(std::uint32_t number) const {
    const IsoCell& cell = cells_.cells[number];
    return cells_.rule().find_open(cell.form, cells_.zeros(cell));
  }
  // What is open after all has been used that is known without a cut.
  std::optional<DmsCorners> find_open_with_shares(std::uint32_t number) {
    auto open = find_open(number);
    if (!open || cells_.cells[number].form.is_polynomial()) return open;
    cells_.drop_far_supports(number);
    open = find_open(number);
    if (!open || cells_.cells[number].form.is_polynomial()) return open;
    cells_.add_shares(number);
    return find_open(number);
  }
  // False if the cell waits for a cut that is not at an extremum.
  bool look_at(std::uint32_t number, bool only_extrema) {
    if (!is_of_interest(number)) return true;
    for (const std::uint32_t v : cells_.cells[number].corners)
      if (cells_.vertices[v].sign == 0 && is_at_corner(v)) return true;
    auto open = find_open_with_shares(number);
    is_proved_[number] = !open;
    if (!open || is_full() || cells_.cells[number].rounds >= options_.max_rounds) return true;
    const auto choose = [&] {
      return cells_.rule().choose_cut(cells_.cells[number].form, *open, extrema_first_);
    };
    if (only_extrema && !choose().is_extremum) return false;
    const int round = ++cells_.cells[number].rounds;
    if (cut_at_knots(number, round, open) || !open) return true;
    const DmsIsoCut cut = choose();
    cells_.cut(number, cut.edge, cut.place, cut.touches);
    return true;
  }
  // Whether the cell was cut there. If it is found to have one polynomial, `open` is what is open then.
  bool cut_at_knots(std::uint32_t number, int round, std::optional<DmsCorners>& open) {
    if (cells_.cells[number].form.is_polynomial() || round % kKnotRounds != kKnotRounds - 1)
      return false;
    if (!cells_.cut_at_knots(number)) return false;
    if (!cells_.cells[number].is_alive) return true;
    open = find_open(number);
    if (!open) is_proved_[number] = true;
    return false;
  }

  IsoCells& cells_;
  const DmsIsoOptions& options_;
  bool extrema_first_;
  std::size_t max_cells_;
  std::uint32_t next_ = 0;
  std::vector<bool> is_proved_;
  std::map<std::uint32_t, bool> at_corner_;
  std::set<std::uint32_t> singular_;  // around these no direction of growth was found
};

void list_doubts(const IsoCells& cells, const IsoSearch& search, std::size_t max_listed,
                 DmsIso& out) {
  out.num_undecided = 0;
  out.undecided.clear();
  for (std::uint32_t c = 0; c < cells.cells.size(); ++c) {
    const auto why = search.doubt(c);
    if (!why || ++out.num_undecided > max_listed) continue;
    DmsIsoCell& cell = out.undecided.emplace_back();
    cell.tetrahedron = cells.cells[c].tetrahedron;
    cell.why = *why;
    for (std::size_t m = 0; m < 4; ++m)
      cell.corners[m] = cells.vertices[cells.cells[c].corners[m]].at;
  }
}

}  // namespace

const char* doubt_name(DmsIsoDoubt doubt) {
  switch (doubt) {
    case DmsIsoDoubt::kVertex: return "vertex";
    case DmsIsoDoubt::kOpen: return "open";
    case DmsIsoDoubt::kWide: return "wide";
  }
  return "";
}

Result<DmsIso> find_dms_iso(const DmsModel& model, const DmsIsoOptions& options,
                            std::size_t max_listed) {
  DmsIso out;
  if (model.control.is_separate &&
      find_disagreeing_control(model, model.num_coordinates + options.attribute, 1))
    out.obstacle = "control-disagrees";
  // The first search is short and separates sheets; the second one is for all else.
  std::unique_ptr<IsoCells> cells;
  for (const bool extrema_first : {true, false}) {
    cells = std::make_unique<IsoCells>(model, options);
    IsoSearch search(*cells, options, extrema_first);
    search.run();
    list_doubts(*cells, search, max_listed, out);
    if (out.num_undecided == 0) break;
  }
  out.certified = !out.obstacle && out.num_undecided == 0;
  out.cells = cells->num_alive;
  std::optional<DmsEvaluator> map;
  if (options.in_solid) map.emplace(options.map != nullptr ? *options.map : model);
  if (const Status status =
          internal::draw_iso(*cells, map ? &*map : nullptr, options.keeps_places, out);
      !status)
    return status.error();
  return out;
}

}  // namespace veritope
