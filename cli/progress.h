// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/progress.h: one line on a terminal that says what the program does; nothing for work that ends soon.
#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "report/progress_line.h"
#include "report/report_text.h"
#include "robust/base/work_share.h"

namespace veritope::cli {

/// Shows "file: phase, 45 % of step 1, 1.2 s" on standard error while work takes longer than 0.3 s, if standard error
/// is a terminal and `is_wanted`. Otherwise it does nothing and starts no thread.
class Progress {
 public:
  explicit Progress(bool is_wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Lines begin with "3 of 58, " from now on, if there are several files.
  void file(std::size_t number, std::size_t num_files);
  /// Sets what is being done from now on.
  void phase(const std::string& file, const std::string& what);
  /// What the line shows of a step; each phase begins without one.
  WorkShare& work() { return work_; }
  /// Erases the line. Call it before anything is printed.
  void clear();

 private:
  void run();
  void draw(const std::string& line);
  void erase();

  std::mutex mutex_;
  std::condition_variable wake_;
  report::ProgressText text_;  ///< without a phase nothing is being done
  WorkShare work_;
  double since_ = 0,
         started_ = 0;  ///< steady seconds: of the phase, of the first phase after clear()
  bool is_shown_ = false, ends_ = false;
  std::thread thread_;
};

/// The result of work() while a line says what is done with the file. REQUIRES work that prints nothing.
template <typename Work>
auto with_progress(const std::string& file, const std::string& what, Work work) {
  Progress progress(true);
  progress.phase(report::shown_path(file), what);
  return work();
}

}  // namespace veritope::cli
