// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/checker_call.h: the C++ checker as a function: what its main does with its files.
#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "verify/checker/claims.h"

namespace veritope {

/// "ACCEPT ...", "REJECT <condition>: ...", "REFUSE ..." (exit 4) or "BUG ..." (exit 5).
/// @param read_file  reads a file that the model names; it may throw ::Refused
/// @param solid      the file of --model
inline std::string check_in_process(
    const std::string& model_file, const std::string& certificate, const std::string& answers = "",
    const std::function<std::string(const std::string&)>& read_file = nullptr,
    const std::string& solid = "") {
  try {
    ::Body body = {nullptr, nullptr};
    ::Statement s = ::read_statement(::all_claims(), certificate, model_file, &body);
    s.answers = answers;
    s.read_file = read_file;
    s.solid = solid;
    return std::string("ACCEPT ") + s.claim->name + ": " + s.claim->check(s, model_file, body);
  } catch (const ::Rejected& r) {
    return "REJECT " + r.id + ": " + r.why;
  } catch (const ::Refused& r) {
    return "REFUSE " + r.why;
  } catch (const std::exception& e) {
    return std::string("BUG ") + e.what();
  }
}

}  // namespace veritope
