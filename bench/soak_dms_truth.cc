// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_truth.cc: --count N --seed S [--only K] [--folder F]. What certify says of N random simplex-spline
// solids of each class of tests/support/dms_truth.h, whose verdict is known by construction: wrong and undecided
// answers, of class number K alone if it is given. With a folder each certificate and its model are written there. One
// JSON line a class.
#include <cstdio>
#include <fstream>
#include <string>

#include "bench/arguments.h"
#include "tests/support/dms_truth_judge.h"

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t count = 20, seed = 1, only = 0;
  std::string folder;
  bench::read_arguments(
      argc, argv,
      {{"--count", &count}, {"--seed", &seed}, {"--only", &only}, {"--folder", &folder}});
  bool is_good = true;
  std::uint64_t number = 0;
  for (const dms_truth::Class& kind : dms_truth::classes()) {
    if (++number != only && only != 0) continue;
    std::uint64_t wrong = 0, undecided = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const dms_truth::Case drawn = kind.draw(seed * 1'000'000 + i);
      const Certified said = dms_truth::certified(drawn.model);
      const dms_truth::Judgement judgement = dms_truth::judge(drawn, said);
      if (judgement != dms_truth::Judgement::kRight)
        std::fprintf(stderr, "%s: %s\n", drawn.text.c_str(), dms_truth::said_of(said).c_str());
      wrong += judgement == dms_truth::Judgement::kWrong;
      undecided += judgement == dms_truth::Judgement::kUndecided;
      if (folder.empty()) continue;
      const std::string path = folder + "/" + kind.name + "_" + std::to_string(i) + ".vdms";
      std::ofstream(path, std::ios::binary) << write_dms(drawn.model);
      std::ofstream(path + ".cert", std::ios::binary)
          .write(reinterpret_cast<const char*>(said.certificate.data()),
                 static_cast<std::streamsize>(said.certificate.size()));
    }
    is_good = is_good && wrong == 0 && 50 * undecided <= count;
    std::printf(
        "{\"name\":\"dms_truth\",\"class\":\"%s\",\"value\":%llu,\"goal\":\"0 wrong, at most 2 %% "
        "undecided\",\"undecided\":%llu,\"models\":%llu}\n",
        kind.name, static_cast<unsigned long long>(wrong),
        static_cast<unsigned long long>(undecided), static_cast<unsigned long long>(count));
    std::fflush(stdout);
  }
  return is_good ? 0 : 1;
}
