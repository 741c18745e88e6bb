// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/contact_forces.hpp>
#include <hexagait/math/quadratic_program.hpp>

namespace hexagait {
namespace {

constexpr double kNoShare = 1e-9;  // of a leg in the air

/// A vector across the unit vector n, of length 1.
Vector3 tangent(const Vector3& n) {
  const Vector3 other = std::abs(n.x()) < 0.8 ? Vector3::UnitX() : Vector3::UnitY();
  return (other - other.dot(n) * n).normalized();
}

struct Carriers {
  std::array<LegId, kMaxLegs> leg{};
  int size = 0;
};

Carriers carriers_of(const LegArray<double>& share) {
  Carriers carriers;
  for (LegId i = 0; i < share.size(); ++i)
    if (share[i] > kNoShare) carriers.leg[static_cast<std::size_t>(carriers.size++)] = i;
  return carriers;
}

using Block = Eigen::Matrix<double, 6, 3>;

// The wrench of a unit force at p, moments over the arm.
Block wrench_of_force(const Vector3& p, double arm) {
  Block G;
  G.topRows<3>().setIdentity();
  G.bottomRows<3>() << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  G.bottomRows<3>() /= arm;
  return G;
}

// (force 1)
void set_objective(ForceProgram& program, const ContactForceProblem& problem,
                   const ContactForceParams& params, const Carriers& carriers) {
  std::array<Block, kMaxLegs> G;
  Eigen::Vector<double, 6> wrench;
  wrench << problem.wrench.force, problem.wrench.moment / params.moment_arm;
  program.H.resize(3 * carriers.size, 3 * carriers.size);
  program.g.resize(3 * carriers.size);
  for (int k = 0; k < carriers.size; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const LegId leg = carriers.leg[row];
    G[row] = wrench_of_force(problem.p_BF[leg], params.moment_arm);
    program.g.segment<3>(3 * k) = -G[row].transpose() * wrench;
    for (int j = 0; j <= k; ++j)
      program.H.block<3, 3>(3 * k, 3 * j) = G[row].transpose() * G[static_cast<std::size_t>(j)];
    program.H.diagonal().segment<3>(3 * k).array() += params.price / problem.share[leg];
  }
}

// Limits along the normal, and (force 2).
void add_limits(ForceProgram& program, const ContactForceProblem& problem,
                const ContactForceParams& params, const Carriers& carriers) {
  for (int k = 0; k < carriers.size; ++k) {
    const LegId leg = carriers.leg[static_cast<std::size_t>(k)];
    const auto add = [&](const Vector3& normal, double bound) {
      ForceProgram::Vector row = ForceProgram::Vector::Zero(3 * carriers.size);
      row.segment<3>(3 * k) = normal;
      program.add(row, bound);
    };
    const Vector3& n = problem.normal_B[leg];
    const Vector3 t = tangent(n), s = n.cross(t);
    const Vector3 edge = params.friction / std::numbers::sqrt2 * n;
    add(-n, -problem.share[leg] * params.min_normal);
    add(n, problem.share[leg] * params.max_normal);
    for (const Vector3& across : {t, s}) {
      add(across - edge, 0.0);
      add(-across - edge, 0.0);
    }
  }
}

}  // namespace

LegArray<Vector3> contact_forces(const ContactForceProblem& problem,
                                 const ContactForceParams& params) noexcept {
  LegArray<Vector3> force(problem.p_BF.size(), Vector3::Zero());
  const Carriers carriers = carriers_of(problem.share);
  if (carriers.size == 0) return force;

  ForceProgram program;
  set_objective(program, problem, params, carriers);
  add_limits(program, problem, params, carriers);
  const auto solution = solve(program);
  for (int k = 0; k < carriers.size; ++k)
    force[carriers.leg[static_cast<std::size_t>(k)]] = solution.x.segment<3>(3 * k);
  return force;
}

}  // namespace hexagait
