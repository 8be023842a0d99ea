// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/field_fit_internal.h: the search for a net whose w lines follow directions, in doubles; only nets
// whose determinant is proved positive are taken.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/micro/cage/field_system_internal.h"
#include "solids/micro/cage/fit_cage.h"

namespace veritope::internal {

/// Vectors and other points that have to be inside, in units in which their box is of size 1 or so.
struct FieldData {
  std::vector<Point3d> points, directions;  ///< directions of unit length
  std::vector<Point3d> corners;
  double margin = 0;
};

class FieldFit {
 public:
  FieldFit(const FieldData& data, const CageGrid& grid, unsigned jobs);

  void run();
  /// Doubles the margin.
  void widen();

  const FieldNet& net() const { return state_.net; }
  const std::vector<Parameters3>& places() const { return state_.at; }
  const Smoothness& smoothness() const { return smoothness_; }
  double smooth() const { return smooth_; }
  std::uint64_t steps() const { return steps_; }
  std::uint64_t shortened() const { return shortened_; }
  /// The last span in which a trial of the last steps had no proved determinant.
  const std::optional<FitStop>& stop() const { return blocked_; }

 private:
  struct State {
    FieldNet net;
    std::vector<Parameters3> at;  // of the vectors
  };
  enum class Inside { kNearly, kYes };

  void begin();
  /// Smoothness and moments of the net as it is.
  void take_measure();
  Point3d lengths(const FieldNet& net) const;
  /// Moves all points along. False if one is lost.
  bool relocate(State& state, const std::vector<Parameters3>& from, Inside inside) const;
  double energy(const State& state) const;
  double held_out_error() const;
  /// A span in which the determinant nearly vanishes.
  std::optional<std::array<std::size_t, 3>> low_span(const FieldNet& net,
                                                     const CellVolume& cell) const;
  static FitStop stop_in(const FieldNet& net, const std::array<std::size_t, 3>& span);
  bool is_proved(const FieldNet& net, std::optional<FitStop>* stop) const;
  /// False if there is nothing to gain.
  bool step(Inside inside);
  void brake(const std::array<std::size_t, 3>& span);
  void descend(int most, Inside inside);
  void coarse();
  void fine();
  /// Whether a vector is near to the border.
  bool is_tight() const;
  /// Cuts the net to what the points need, the margin, and at least this part of the parameters on both sides.
  bool cut(double least);

  const FieldData& data_;
  CageGrid grid_;
  unsigned jobs_;
  State state_;
  std::vector<Parameters3> corner_at_;
  std::vector<double> weights_;
  Smoothness smoothness_;
  std::optional<ParameterMoments> moments_;
  double smooth_ = 1, damping_ = 0x1p-14;
  std::vector<double> brakes_;  // of control points: damping that they have alone
  double margin_part_ = 1;
  std::uint64_t steps_ = 0, shortened_ = 0;
  std::optional<FitStop> stop_;     // of a step that was given up
  std::optional<FitStop> blocked_;  // of a trial
};

}  // namespace veritope::internal
