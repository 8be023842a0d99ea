// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/read_model.h"

#include <unistd.h>

#include <algorithm>
#include <stop_token>
#include <system_error>
#include <thread>

#include "io/base/file_bytes.h"
#include "io/chains/chain_file.h"
#include "io/foreign_content.h"
#include "io/formats.h"
#include "robust/base/stopwatch.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

// Computes the hash beside the parser, if the options allow another thread and there are enough
// bytes.
class Hashing {
 public:
  Hashing(const ByteBuffer& bytes, int jobs) : bytes_(bytes) {
    constexpr std::size_t kWorthAThread = std::size_t{1} << 16;
    if (jobs < 2 || bytes.size() <= kWorthAThread) return;
    try {
      thread_ = std::jthread([this](const std::stop_token& stop) { hash(stop); });
    } catch (const std::system_error&) {
      // The system refuses another thread: finish() computes the hash.
    }
  }

  std::string finish() {
    thread_.joinable() ? thread_.join() : hash(std::stop_token());
    return to_hex(sha_.finish());
  }
  double seconds() const { return seconds_; }

 private:
  // Hashes in pieces, so that a refused file need not be hashed to its end.
  void hash(const std::stop_token& stop) {
    Stopwatch watch;
    std::span<const unsigned char> rest(bytes_.data(), bytes_.size());
    while (!rest.empty() && !stop.stop_requested()) {
      const std::size_t size = std::min<std::size_t>(rest.size(), std::size_t{1} << 20);
      sha_.update(rest.first(size));
      rest = rest.subspan(size);
    }
    seconds_ = watch.lap();
  }

  const ByteBuffer& bytes_;
  Sha256 sha_;
  double seconds_ = 0;
  std::jthread thread_;  // last: it uses the others
};

std::optional<Error> check_options(const std::string& name, const ModelReadOptions& options) {
  if (options.jobs >= 1) return std::nullopt;
  return error_in_file(name, Code::kBadArgument,
                       "jobs must be at least 1, not " + std::to_string(options.jobs));
}

// The error that says why no format was found.
Error unknown_format(const Source& source, const ModelReadOptions& options) {
  const std::string wanted = format_names("or", options.kind);
  if (const std::string other = unread_format(source); !other.empty())
    return error_at_byte(source, source.begin, Code::kForeignFormat,
                         "this is " + other + ": not read yet; the formats that are read are " +
                             format_names("and"));
  const ModelFormat* row = format_from_path(*source.name);
  if (row == nullptr) row = format_from_content(source);
  return error_in_file(
      *source.name, Code::kUnknownFormat,
      row == nullptr ? "neither the ending of the name nor the content says whether this is " +
                           wanted + " (--format)"
                     : "this is " + std::string(title_of(row->kind())) + " (" + row->name +
                           "); needed is " + title_of(options.kind.value()) + ": " + wanted);
}

Result<const ModelFormat*> choose(const Source& source, const ModelReadOptions& options) {
  if (std::optional<Error> foreign = refuse_foreign(source)) return std::move(*foreign);
  if (!options.format && looks_like_chain(source))
    return error_at_byte(
        source, source.begin, Code::kForeignFormat,
        "this is a chain file, an expression of solids, and no model: classify and "
        "boolean read it");
  if (options.format) {
    const ModelFormat& row = model_format(*options.format);
    if (!options.kind || row.kind() == *options.kind) return &row;
    return error_in_file(
        *source.name, Code::kBadArgument,
        "the format must be " + format_names("or", options.kind) + ", not " + row.name);
  }
  if (const ModelFormat* row = format_from_path(*source.name, options.kind)) return row;
  if (const ModelFormat* row = format_from_content(source, options.kind)) return row;
  return unknown_format(source, options);
}

// What the content looks like, for a refusal by the reader of `row`; empty if that says nothing new.
std::string other_looks(const Source& source, const ModelFormat& row,
                        const ModelReadOptions& options) {
  if (looks_like_utf16(source)) return "it looks like UTF-16 text";
  const ModelFormat* const other = format_from_content(source, options.kind);
  if (other != nullptr && other != &row)
    return std::string("it looks like ") + other->name + " (--format " + other->name + ")";
  if (const std::string unread = unread_format(source); other == nullptr && !unread.empty())
    return "it looks like " + unread + ", which is not read yet";
  return row.second_guess == nullptr ? "" : row.second_guess(source);
}

Error explained(Error error, const Source& source, const ModelFormat& row,
                const ModelReadOptions& options) {
  if (error.code != Code::kSyntax && error.code != Code::kTruncated && error.code != Code::kEmpty)
    return error;
  const std::string looks = other_looks(source, row, options);
  if (!looks.empty()) error.message += "; " + looks;
  return error;
}

ModelReadOptions only(ModelKind kind, ModelReadOptions options) {
  options.kind = kind;
  return options;
}

template <typename File>
Result<File> taken(Result<ModelFile> file) {
  if (!file) return file.error();
  return std::get<File>(std::move(*file));
}

}  // namespace

Result<ModelBytes> load_model(const std::string& path, const ModelReadOptions& options) {
  if (std::optional<Error> error = check_options(path, options)) return std::move(*error);
  if (path == "-" && !options.format)
    return error_in_file(path, Code::kBadArgument, "standard input needs a format (--format)");
  Stopwatch watch;
  const std::uint64_t max_bytes = options.limits.max_bytes;
  Result<ByteBuffer> bytes = path == "-" ? read_descriptor(STDIN_FILENO, path, 0, max_bytes)
                                         : read_file_bytes(path, max_bytes);
  if (!bytes) return bytes.error();
  return ModelBytes{path, std::move(*bytes), watch.lap()};
}

Result<FormatId> choose_format(const ModelBytes& file, const ModelReadOptions& options) {
  const Result<const ModelFormat*> row = choose(source_of(file.bytes, file.name), options);
  if (!row) return row.error();
  return (*row)->id;
}

Result<ModelFile> read_model(const ModelBytes& file, const ModelReadOptions& options) {
  if (std::optional<Error> error = check_options(file.name, options)) return std::move(*error);
  const Source source = source_of(file.bytes, file.name);
  const Result<const ModelFormat*> row = choose(source, options);
  if (!row) return row.error();
  Hashing hashing(file.bytes, options.jobs);
  Stopwatch watch;
  Result<ModelFile> model = (*row)->read(source, options);
  if (!model) return explained(model.error(), source, **row, options);
  const double seconds_parse = watch.lap();
  const std::string sha256 = hashing.finish();
  std::visit(
      [&](auto& m) {
        m.sha256 = sha256;
        m.seconds_read = file.seconds_read;
        m.seconds_parse = seconds_parse;
        m.seconds_hash = hashing.seconds();
      },
      *model);
  return model;
}

Result<ModelFile> read_model_file(const std::string& path, const ModelReadOptions& options) {
  const Result<ModelBytes> file = load_model(path, options);
  if (!file) return file.error();
  return read_model(*file, options);
}

Result<ModelFile> read_model_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                   const ModelReadOptions& options) {
  if (bytes.size() > options.limits.max_bytes)
    return error_in_file(name, Code::kOverLimit,
                         over_limit("bytes", "--max-bytes", options.limits.max_bytes));
  return read_model({name, copy_to_buffer(bytes), 0}, options);
}

Result<MeshFile> read_mesh_file(const std::string& path, const ModelReadOptions& options) {
  return taken<MeshFile>(read_model_file(path, only(ModelKind::kMesh, options)));
}

Result<MeshFile> read_mesh_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                 const ModelReadOptions& options) {
  return taken<MeshFile>(read_model_bytes(bytes, name, only(ModelKind::kMesh, options)));
}

Result<SplineFile> read_spline_file(const std::string& path, const ModelReadOptions& options) {
  return taken<SplineFile>(read_model_file(path, only(ModelKind::kSplines, options)));
}

Result<SplineFile> read_spline_bytes(std::span<const unsigned char> bytes, const std::string& name,
                                     const ModelReadOptions& options) {
  return taken<SplineFile>(read_model_bytes(bytes, name, only(ModelKind::kSplines, options)));
}

}  // namespace veritope
