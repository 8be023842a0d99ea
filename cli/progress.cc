// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/progress.h"

#include <unistd.h>

#include <chrono>
#include <system_error>

#include "cli/signals.h"

namespace veritope::cli {
namespace {

constexpr double kSilent = 0.3;  // seconds
constexpr auto kTick = std::chrono::milliseconds(100);

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void put(const std::string& text) {
  [[maybe_unused]] const ssize_t done = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress(bool is_wanted) {
  if (!is_wanted || ::isatty(STDERR_FILENO) == 0) return;
  const SignalsBlocked blocked;  // the thread inherits it: the handler never interrupts a drawing
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {
    // The system refuses another thread: no progress is shown.
  }
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    erase();
    text_.phase.clear();
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Progress::file(std::size_t number, std::size_t num_files) {
  const std::lock_guard lock(mutex_);
  text_.number = number, text_.num_files = num_files;
}

void Progress::phase(const std::string& file, const std::string& what) {
  work_.reset();
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  since_ = now();
  if (text_.phase.empty()) started_ = since_;
  text_.file = file, text_.phase = what;
}

void Progress::clear() {
  if (!thread_.joinable()) return;
  const std::lock_guard lock(mutex_);
  erase();
  text_.phase.clear();
}

void Progress::run() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    wake_.wait_for(lock, kTick);
    if (ends_ || text_.phase.empty()) continue;
    const double time = now();
    if (time - started_ < kSilent) continue;
    draw(report::progress_line(text_, work_.view(), time - since_));
  }
}

void Progress::draw(const std::string& line) {
  set_progress_shown(true);
  is_shown_ = true;
  put("\r\033[K" + line);
}

void Progress::erase() {
  if (is_shown_) put("\r\033[K");
  is_shown_ = false;
  set_progress_shown(false);
}

}  // namespace veritope::cli
