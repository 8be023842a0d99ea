// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/streamed_output.h"

#include <utility>

namespace veritope::cli {

Result<StreamedOutput> StreamedOutput::open(const std::string& path) {
  StreamedOutput out(path);
  if (is_stream(path)) return out;
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  out.file_.emplace(std::move(*file));
  return out;
}

Status StreamedOutput::write(std::string_view bytes) {
  digest_.update({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
  num_bytes_ += bytes.size();
  if (file_) return file_->write(bytes);
  kept_ += bytes;
  return ok_status();
}

Status StreamedOutput::commit(StandardOutput& out) {
  return file_ ? file_->commit() : write_output(path_, kept_, out);
}

}  // namespace veritope::cli
