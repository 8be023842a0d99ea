// SPDX-License-Identifier: LGPL-3.0-or-later
// fuzz/read_mutator.h: changes to mesh files that know what a token, a count and a coordinate are.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <string_view>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace veritope::fuzz {

/// One change at a time to a file held in `text`.
class Mutator {
 public:
  Mutator(std::string text, unsigned seed, std::span<const std::string_view> words)
      : text_(std::move(text)), random_(seed), words_(words) {}

  std::string take() { return std::move(text_); }
  std::size_t pick(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  /// Replaces, doubles or removes a token of [0, end), or gives it a new neighbour.
  void change_token(std::size_t end) {
    const auto [first, last] = token(end);
    const std::string old = text_.substr(first, last - first);
    switch (pick(6)) {
      case 0: return replace(first, last, number());
      case 1: return replace(first, last, std::string(words_[pick(words_.size())]));
      case 2: return replace(first, last, nudged(old));
      case 3: return replace(first, last, old + separator() + old);
      case 4: return replace(first, last, "");
      default: return replace(first, last, separator() + old);
    }
  }

  /// Doubles, removes or moves a line of [0, end).
  void change_line(std::size_t end) {
    const std::size_t at = pick(end);
    const std::size_t before = at == 0 ? text_.npos : text_.find_last_of("\r\n", at - 1);
    const std::size_t first = before == text_.npos ? 0 : before + 1;
    const std::size_t eol = text_.find_first_of("\r\n", at);
    const std::size_t last = std::min(end, eol == text_.npos ? text_.size() : eol + 1);
    if (first >= last) return;
    const std::string line = text_.substr(first, last - first);
    if (pick(3) != 0) text_.erase(first, line.size());
    text_.insert(std::min(text_.size(), pick(end)), pick(4) == 0 ? "" : line);
  }

  /// Replaces the number of `size` bytes at `at` by an interesting one.
  void change_binary(std::size_t at, std::size_t size) {
    if (at + size > text_.size()) return;
    static constexpr std::uint64_t kFloats[] = {0,          0x80000000, 0x3F800000, 0x7F800000,
                                                0xFF800000, 0x7FC00000, 1,          0x7F7FFFFF,
                                                0x00800000, 0xFF7FFFFF, 0xBF800000};
    static constexpr std::uint64_t kDoubles[] = {
        0, 0x8000000000000000, 0x3FF0000000000000, 0x7FF0000000000000, 0x7FF8000000000000,
        1, 0x7FEFFFFFFFFFFFFF, 0xFFF0000000000000};
    std::uint64_t value = 0;
    std::memcpy(&value, text_.data() + at, size);
    switch (pick(5)) {
      case 0:
        value = size == 8 ? kDoubles[pick(std::size(kDoubles))] : kFloats[pick(std::size(kFloats))];
        break;
      case 1: value += pick(7) - 3; break;
      case 2: value = pick(8); break;
      case 3: value = ~std::uint64_t{0} - pick(3); break;
      default: std::memcpy(&value, text_.data() + pick(text_.size() - size + 1), size); break;
    }
    if (pick(4) == 0)
      std::reverse(reinterpret_cast<char*>(&value), reinterpret_cast<char*>(&value) + size);
    std::memcpy(text_.data() + at, &value, size);
  }

  /// Doubles or removes the bytes [at, at + size).
  void change_block(std::size_t at, std::size_t size) {
    if (at + size > text_.size()) return;
    pick(2) == 0 ? void(text_.erase(at, size)) : void(text_.insert(at, text_.substr(at, size)));
  }

  std::string& text() { return text_; }

 private:
  std::pair<std::size_t, std::size_t> token(std::size_t end) {
    constexpr std::string_view kSpace = " \t\r\n\v\f";
    std::size_t first = text_.find_first_not_of(kSpace, pick(end));
    if (first == text_.npos || first >= end) return {end, end};
    while (first > 0 && kSpace.find(text_[first - 1]) == kSpace.npos) --first;
    const std::size_t last = text_.find_first_of(kSpace, first);
    return {first, std::min(end, last == text_.npos ? text_.size() : last)};
  }

  void replace(std::size_t first, std::size_t last, const std::string& by) {
    text_.replace(first, last - first, by);
  }

  std::string separator() {
    static constexpr std::string_view kAll[] = {
        " ",    "\n",     "\r",  "\r\n", "\t",     "\v", "\f",           " # ",
        "\\\n", "\\\r\n", "#\n", "\n\n", " \\\n ", "/",  "\xEF\xBB\xBF", "\\\r"};
    return std::string(kAll[pick(std::size(kAll))]);
  }

  std::string number() {
    static constexpr std::string_view kAll[] = {"0",
                                                "1",
                                                "2",
                                                "3",
                                                "-1",
                                                "-2",
                                                "4",
                                                "-0",
                                                "+1",
                                                "1.",
                                                ".5",
                                                "-.5e-3",
                                                "1e308",
                                                "1.8e308",
                                                "1e-400",
                                                "5e-324",
                                                "2.4703282292062328e-324",
                                                "9007199254740993",
                                                "0.50000000000000000",
                                                "nan",
                                                "inf",
                                                "1e",
                                                "0x1p3",
                                                "1,5",
                                                "4294967295",
                                                "4294967296",
                                                "18446744073709551616",
                                                "-2147483648",
                                                "255",
                                                "1e4096",
                                                "1e-4097",
                                                "0.1",
                                                "1234567890123456789012345678901234567890",
                                                "0.000000000000000000000000000012345678901234567",
                                                "1e22",
                                                "1e23"};
    if (pick(8) != 0) return std::string(kAll[pick(std::size(kAll))]);
    std::string digits;
    for (std::size_t i = pick(30); i > 0; --i)
      digits += "0123456789.e-"[pick(pick(4) == 0 ? 13 : 10)];
    return digits;
  }

  // The number in a token, made a little larger or smaller.
  std::string nudged(const std::string& old) {
    std::string text = old;
    const std::size_t digit = text.find_last_of("0123456789");
    if (digit == text.npos) return number();
    text[digit] = static_cast<char>('0' + (text[digit] - '0' + (pick(2) == 0 ? 1 : 9)) % 10);
    return text;
  }

  std::string text_;
  std::mt19937 random_;
  std::span<const std::string_view> words_;
};

/// The frame of LLVMFuzzerCustomMutator: makes libFuzzer's own changes one time in three, otherwise one to three of
/// `change`.
template <typename Change>
std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                   std::span<const std::string_view> words, Change change) {
  Mutator mutator(std::string(reinterpret_cast<const char*>(data), size), seed, words);
  if (size == 0 || mutator.pick(3) == 0) return LLVMFuzzerMutate(data, size, max_size);
  for (std::size_t i = 1 + mutator.pick(3); i > 0 && !mutator.text().empty(); --i) change(mutator);
  const std::string text = mutator.take();
  if (text.empty()) return LLVMFuzzerMutate(data, size, max_size);
  const std::size_t length = std::min(text.size(), max_size);
  std::memcpy(data, text.data(), length);
  return length;
}

}  // namespace veritope::fuzz
