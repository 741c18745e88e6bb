// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/balance/contact_forces.hpp>

namespace hexagait {
namespace {

constexpr double kUnloaded = 1e-9;  // legs with less load are left out

/// A unit vector perpendicular to the unit vector n.
Vector3 tangent(const Vector3& n) {
  const Vector3 other = std::abs(n.x()) < 0.8 ? Vector3::UnitX() : Vector3::UnitY();
  return (other - other.dot(n) * n).normalized();
}

struct LoadedLegs {
  std::array<LegId, kMaxLegs> leg{};
  int size = 0;
};

LoadedLegs loaded_legs(const LegArray<double>& load) {
  LoadedLegs loaded;
  for (LegId i = 0; i < load.size(); ++i)
    if (load[i] > kUnloaded) loaded.leg[static_cast<std::size_t>(loaded.size++)] = i;
  return loaded;
}

using Block = Eigen::Matrix<double, 6, 3>;

// The wrench of a force at p, as a matrix; moments divided by the arm.
Block wrench_of_force(const Vector3& p, double arm) {
  Block G;
  G.topRows<3>().setIdentity();
  G.bottomRows<3>() = cross_matrix(p) / arm;
  return G;
}

// (force 1)
void set_objective(ForceProgram& program, const ContactForceProblem& problem,
                   const ContactForceParams& params, const LoadedLegs& loaded) {
  std::array<Block, kMaxLegs> G;
  Eigen::Vector<double, 6> wrench;
  wrench << problem.wrench.force, problem.wrench.moment / params.moment_arm;
  program.H.resize(3 * loaded.size, 3 * loaded.size);
  program.g.resize(3 * loaded.size);
  for (int k = 0; k < loaded.size; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const LegId leg = loaded.leg[row];
    G[row] = wrench_of_force(problem.p_BF[leg], params.moment_arm);
    program.g.segment<3>(3 * k) = -G[row].transpose() * wrench;
    for (int j = 0; j <= k; ++j)
      program.H.block<3, 3>(3 * k, 3 * j) = G[row].transpose() * G[static_cast<std::size_t>(j)];
    program.H.diagonal().segment<3>(3 * k).array() += params.regularisation / problem.load[leg];
  }
}

// Limits along the normal, and (force 2).
void add_limits(ForceProgram& program, const ContactForceProblem& problem,
                const ContactForceParams& params, const LoadedLegs& loaded) {
  for (int k = 0; k < loaded.size; ++k) {
    const LegId leg = loaded.leg[static_cast<std::size_t>(k)];
    const auto add = [&](const Vector3& normal, double bound) {
      ForceProgram::Vector row = ForceProgram::Vector::Zero(3 * loaded.size);
      row.segment<3>(3 * k) = normal;
      program.add(row, bound);
    };
    const Vector3& n = problem.normal_B[leg];
    const Vector3 t = tangent(n), s = n.cross(t);
    const Vector3 edge = params.friction / std::numbers::sqrt2 * n;
    add(-n, -problem.load[leg] * params.min_normal);
    add(n, problem.load[leg] * params.max_normal);
    for (const Vector3& across : {t, s}) {
      add(across - edge, 0.0);
      add(-across - edge, 0.0);
    }
  }
}

}  // namespace

ContactForces contact_forces(const ContactForceProblem& problem,
                             const ContactForceParams& params) noexcept {
  ContactForces out{LegArray<Vector3>(problem.p_BF.size(), Vector3::Zero())};
  const LoadedLegs loaded = loaded_legs(problem.load);
  if (loaded.size == 0) return out;

  ForceProgram program;
  set_objective(program, problem, params, loaded);
  add_limits(program, problem, params, loaded);
  const auto solution = solve(program);
  out.status = solution.status;
  for (int k = 0; k < loaded.size; ++k)
    out.force[loaded.leg[static_cast<std::size_t>(k)]] = solution.x.segment<3>(3 * k);
  return out;
}

}  // namespace hexagait
