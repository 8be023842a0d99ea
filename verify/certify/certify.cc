// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/certify.h"

#include <algorithm>
#include <cmath>

#include "verify/certify/certify_kinds_internal.h"

namespace veritope {
namespace {

// Statements hold no escapes, and both checkers refuse a longer name.
constexpr std::size_t kMostToolBytes = 200;

Status check(const CertifyOptions& options) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (options.tool.size() > kMostToolBytes)
    return bad_argument("the tool's name has " + std::to_string(options.tool.size()) +
                        " bytes, more than 200");
  if (!std::all_of(options.tool.begin(), options.tool.end(), is_plain))
    return bad_argument(
        "the tool's name holds a character other than printable ASCII without \" and \\");
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance)))
    return bad_argument("the tolerance " + std::to_string(*options.tolerance) +
                        " is not a positive number");
  if (options.max_cells && *options.max_cells == 0)
    return bad_argument("at most 0 cells: at least one is needed");
  if (options.max_memory && *options.max_memory == 0)
    return bad_argument("at most 0 bytes of memory: some are needed");
  return ok_status();
}

}  // namespace

std::string tool_name() { return "veritope " VERITOPE_VERSION; }

Result<Certified> certify(const ModelFile& file, const CertifyOptions& options) {
  if (const Status status = check(options); !status) return status.error();
  return std::visit([&](const auto& kind) { return internal::certify_kind(kind, options); }, file);
}

}  // namespace veritope
