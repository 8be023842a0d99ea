// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/result.h"

namespace veritope {

const char* code_name(Code code) {
  switch (code) {
    case Code::kCannotOpen: return "cannot-open";
    case Code::kEmpty: return "empty";
    case Code::kForeignFormat: return "foreign-format";
    case Code::kUnknownFormat: return "unknown-format";
    case Code::kSyntax: return "syntax";
    case Code::kTruncated: return "truncated";
    case Code::kNotFinite: return "not-finite";
    case Code::kIndexOutOfRange: return "index-out-of-range";
    case Code::kOverLimit: return "over-limit";
    case Code::kLossy: return "lossy";
    case Code::kCannotWrite: return "cannot-write";
    case Code::kInterrupted: return "interrupted";
    case Code::kBadArgument: return "bad-argument";
    case Code::kBadSpline: return "bad-spline";
    case Code::kBadEnvironment: return "bad-environment";
  }
  return "unknown";
}

std::string to_string(const Error& error) {
  std::string text;
  const Place& p = error.place;
  if (!p.file.empty()) text += p.file + ": ";
  if (p.line) text += "line " + std::to_string(*p.line) + ": ";
  if (p.byte) text += "byte " + std::to_string(*p.byte) + ": ";
  if (p.face) text += "face " + std::to_string(*p.face) + ": ";
  if (p.entity) text += "entity " + std::to_string(*p.entity) + ": ";
  if (p.vertex) text += "vertex " + std::to_string(*p.vertex) + ": ";
  return text + error.message;
}

}  // namespace veritope
