// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/arguments.h: the arguments "--name value" of experiments.
#pragma once
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <string>
#include <variant>

namespace veritope::bench {

struct Argument {
  const char* name;
  std::variant<int*, double*, std::uint64_t*, std::string*> value;

  /// Returns false if the text is not a number of the value's type.
  bool set(const char* text) const {
    if (std::string* const* const s = std::get_if<std::string*>(&value)) return **s = text, true;
    const char* const end = text + std::strlen(text);
    const auto is_read = [&](auto* number) {
      const auto [at, error] = std::from_chars(text, end, *number);
      return error == std::errc() && at == end;
    };
    if (int* const* const i = std::get_if<int*>(&value)) return is_read(*i);
    if (double* const* const d = std::get_if<double*>(&value)) return is_read(*d);
    return is_read(std::get<std::uint64_t*>(value));
  }
};

/// Sets the values of the arguments that are there. --help prints the names and ends the program; so does, with exit 2,
/// an argument that is not known, has no value or a wrong one: a misspelt one must not start an experiment of hours.
inline void read_arguments(int argc, char** argv, std::initializer_list<Argument> known) {
  const auto end_with_usage = [&](int exit) {
    std::fprintf(exit == 0 ? stdout : stderr, "usage: %s", argv[0]);
    for (const Argument& a : known)
      std::fprintf(exit == 0 ? stdout : stderr, " [%s VALUE]", a.name);
    std::fprintf(exit == 0 ? stdout : stderr, "\n");
    std::exit(exit);
  };
  for (int i = 1; i < argc; i += 2) {
    if (std::strcmp(argv[i], "--help") == 0) end_with_usage(0);
    bool is_set = false;
    for (const Argument& a : known)
      if (std::strcmp(argv[i], a.name) == 0) is_set = i + 1 < argc && a.set(argv[i + 1]);
    if (is_set) continue;
    std::fprintf(stderr, "not known, or without a value of its kind: %s\n", argv[i]);
    end_with_usage(2);
  }
}

}  // namespace veritope::bench
