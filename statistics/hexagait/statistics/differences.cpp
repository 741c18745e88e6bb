// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <hexagait/statistics/differences.hpp>
#include <limits>

namespace hexagait::statistics {

Difference unpaired_difference(std::span<const double> a, std::span<const double> b) {
  const Estimate ea = estimate(a), eb = estimate(b);
  const double value = ea.mean - eb.mean;
  double half_width = std::numeric_limits<double>::infinity();
  if (ea.count > 1 && eb.count > 1) {
    const double va = ea.sd * ea.sd / ea.count, vb = eb.sd * eb.sd / eb.count;
    const double spread = va * va / (ea.count - 1) + vb * vb / (eb.count - 1);
    half_width = 0.0;
    if (spread > 0.0) {
      const boost::math::students_t student((va + vb) * (va + vb) / spread);
      half_width = boost::math::quantile(student, 0.975) * std::sqrt(va + vb);
    }
  }
  return {value, value - half_width, value + half_width};
}

Difference difference(const Proportion& a, const Proportion& b) {
  const double value = a.share() - b.share();
  const auto distance = [](double x, double y) { return std::sqrt(x * x + y * y); };
  return {value, value - distance(a.share() - a.lower, b.upper - b.share()),
          value + distance(a.upper - a.share(), b.share() - b.lower)};
}

}  // namespace hexagait::statistics
