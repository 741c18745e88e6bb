// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <hexagait/statistics/statistics.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

namespace hexagait::statistics {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool has_gaps(std::span<const double> values) {
  return values.empty() || std::ranges::any_of(values, [](double v) { return std::isnan(v); });
}

}  // namespace

Estimate estimate(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("the mean of no values");
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
  if (a.size() != b.size()) throw std::invalid_argument("pairs of unequal numbers of trials");
  std::vector<double> differences(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) differences[k] = a[k] - b[k];
  return estimate(differences);
}

Proportion proportion(int count, int trials) {
  if (trials < 1 || count < 0 || count > trials)
    throw std::invalid_argument("a proportion of no trials, or of more than all");
  const double n = trials, p = count / n;
  const double z = boost::math::quantile(boost::math::normal(), 0.975);
  const double centre = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  // At the ends the limits are 0 and 1 exactly, which rounding misses.
  return {count, trials, count == 0 ? 0.0 : centre - half, count == trials ? 1.0 : centre + half};
}

double greatest(std::span<const double> values) {
  return has_gaps(values) ? kNaN : *std::ranges::max_element(values);
}

double least(std::span<const double> values) {
  return has_gaps(values) ? kNaN : *std::ranges::min_element(values);
}

}  // namespace hexagait::statistics
