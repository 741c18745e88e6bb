// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <hexagait/statistics/statistics.hpp>
#include <limits>
#include <vector>

namespace hexagait::statistics {

Estimate estimate(std::span<const double> values) {
  assert(!values.empty());
  const auto n = static_cast<double>(values.size());
  Estimate e{.count = static_cast<int>(values.size())};
  for (const double value : values) e.mean += value / n;
  e.half_width = std::numeric_limits<double>::infinity();
  if (values.size() == 1) return e;

  double squares = 0.0;
  for (const double value : values) squares += (value - e.mean) * (value - e.mean);
  e.sd = std::sqrt(squares / (n - 1.0));
  const double t = boost::math::quantile(boost::math::students_t(n - 1.0), 0.975);
  e.half_width = t * e.sd / std::sqrt(n);
  return e;
}

Estimate paired_difference(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  std::vector<double> differences(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) differences[k] = a[k] - b[k];
  return estimate(differences);
}

}  // namespace hexagait::statistics
