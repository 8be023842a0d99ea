// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/work_share.h: how much of a long task is done, for another thread to show.
#pragma once
#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

namespace veritope {

/// A task goes through steps. A step has an amount that is known when it begins, and what is done of it never becomes
/// less; a search that starts anew is the next step. Between steps nothing is known. All calls may come from any
/// thread; one costs approximately 20 ns, so loops report blocks of their work.
class WorkShare {
 public:
  struct View {
    unsigned step = 0;           ///< from 1; 0: no step runs
    double done = 0, whole = 0;  ///< of the step that runs, or of the last one
    /// 0 to 99, rounded down: a step that still runs is never shown as complete.
    std::optional<int> percent() const {
      if (step == 0 || !(whole > 0)) return std::nullopt;
      return static_cast<int>(std::clamp(std::floor(100 * (done / whole)), 0.0, 99.0));
    }
  };

  /// Begins the next step. REQUIRES whole >= 0.
  void begin(double whole) {
    const std::lock_guard lock(mutex_);
    last_step_ += 1;
    now_ = {last_step_, 0, whole};
  }
  /// REQUIRES part >= 0, and that a step runs.
  void add(double part) {
    const std::lock_guard lock(mutex_);
    now_.done += part;
  }
  /// Ends the step: nothing is known until the next one begins. What was done of it stays in the view.
  void end() {
    const std::lock_guard lock(mutex_);
    now_.step = 0;
  }
  /// Forgets all steps: a new task begins.
  void reset() {
    const std::lock_guard lock(mutex_);
    now_ = {}, last_step_ = 0;
  }
  View view() const {
    const std::lock_guard lock(mutex_);
    return now_;
  }

 private:
  mutable std::mutex mutex_;
  View now_;
  unsigned last_step_ = 0;
};

/// A step of `work`, which may be null, while this object lives.
class WorkStep {
 public:
  WorkStep(WorkShare* work, double whole) : work_(work) {
    if (work_ != nullptr) work_->begin(whole);
  }
  ~WorkStep() {
    if (work_ != nullptr) work_->end();
  }
  WorkStep(const WorkStep&) = delete;
  WorkStep& operator=(const WorkStep&) = delete;
  void add(double part) {
    if (work_ != nullptr) work_->add(part);
  }

 private:
  WorkShare* work_;
};

}  // namespace veritope
