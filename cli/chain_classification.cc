// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/chain_classification.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "robust/base/parallel.h"
#include "robust/base/stopwatch.h"
#include "solids/chain/normal_chain.h"

namespace veritope::cli {

Status classify_by_chain(const PatchComplex& complex, const ExactPoint& origin, PointSource& source,
                         unsigned jobs, const WriteAnswers& write, report::ClassifyReport& report) {
  Stopwatch watch;
  const NormalChain chain(complex);
  report.seconds_build = watch.lap();
  PointBatch batch;
  std::vector<ExactPoint> points;
  std::vector<std::optional<int>> values;
  std::string lines;
  for (;;) {
    if (const Status status = source.next(batch); !status) return status.error();
    if (batch.size() == 0) break;
    points.assign(batch.size(), {});
    for (std::size_t i = 0; i < batch.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        points[i][k] = Rational::from_double(batch.points[i][static_cast<int>(k)]);
    for (const auto& [at, point] : batch.exact) points[at] = point;
    values.assign(batch.size(), std::nullopt);
    parallel_for(batch.size(), 16, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) values[i] = chain.value(points[i], origin);
    });
    lines.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      lines += batch.text(i);
      lines += " - " + (values[i] ? std::to_string(*values[i]) : std::string("wall")) + " -\n";
    }
    report.points += batch.size();
    if (const Status status = write(lines); !status) return status.error();
  }
  report.seconds_classify = watch.lap();
  return ok_status();
}

}  // namespace veritope::cli
