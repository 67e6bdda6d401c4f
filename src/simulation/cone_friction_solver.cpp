// SPDX-License-Identifier: BSD-3-Clause
#include "cone_friction_solver.h"

#include <algorithm>
#include <cmath>

namespace smore {

// Returns the greatest square of a row's velocity error, by which Bullet ends its iterations.
btScalar ConeFrictionSolver::solveSingleIteration(
    int /*iteration*/, btCollisionObject** /*bodies*/, int /*body_count*/,
    btPersistentManifold** /*manifolds*/, int /*manifold_count*/,
    btTypedConstraint** /*constraints*/, int /*constraint_count*/,
    const btContactSolverInfo& /*info*/, btIDebugDraw* /*debug_drawer*/) {
  btScalar error = 0.0;
  for (int contact = 0; contact < m_tmpSolverContactConstraintPool.size(); ++contact) {
    const btScalar normal_error = solveNormal(contact);
    const btScalar friction_error = solveFriction(contact);
    error = std::max({error, normal_error * normal_error, friction_error * friction_error});
  }
  return error;
}

btScalar ConeFrictionSolver::solveNormal(int contact) {
  btSolverConstraint& row = m_tmpSolverContactConstraintPool[contact];
  return resolveSingleConstraintRowLowerLimit(m_tmpSolverBodyPool[row.m_solverBodyIdA],
                                              m_tmpSolverBodyPool[row.m_solverBodyIdB], row);
}

btScalar ConeFrictionSolver::solveFriction(int contact) {
  const btSolverConstraint& normal = m_tmpSolverContactConstraintPool[contact];
  btSolverConstraint& first = m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex];
  btSolverConstraint& second = m_tmpSolverContactFrictionConstraintPool[normal.m_frictionIndex + 1];
  const btScalar wanted_first =
      first.m_appliedImpulse + first.m_rhs - velocityAlong(first) * first.m_jacDiagABInv;
  const btScalar wanted_second =
      second.m_appliedImpulse + second.m_rhs - velocityAlong(second) * second.m_jacDiagABInv;
  const btScalar limit = first.m_friction * normal.m_appliedImpulse;
  const btScalar wanted = std::sqrt(wanted_first * wanted_first + wanted_second * wanted_second);
  const btScalar scale = wanted > limit ? limit / wanted : 1.0;
  const btScalar change_first = scale * wanted_first - first.m_appliedImpulse;
  const btScalar change_second = scale * wanted_second - second.m_appliedImpulse;
  applyImpulse(first, change_first);
  applyImpulse(second, change_second);
  first.m_appliedImpulse += change_first;
  second.m_appliedImpulse += change_second;
  return std::max(std::abs(change_first / first.m_jacDiagABInv),
                  std::abs(change_second / second.m_jacDiagABInv));
}

btScalar ConeFrictionSolver::velocityAlong(const btSolverConstraint& row) const {
  const btSolverBody& a = m_tmpSolverBodyPool[row.m_solverBodyIdA];
  const btSolverBody& b = m_tmpSolverBodyPool[row.m_solverBodyIdB];
  return row.m_contactNormal1.dot(a.getDeltaLinearVelocity()) +
         row.m_relpos1CrossNormal.dot(a.getDeltaAngularVelocity()) +
         row.m_contactNormal2.dot(b.getDeltaLinearVelocity()) +
         row.m_relpos2CrossNormal.dot(b.getDeltaAngularVelocity());
}

void ConeFrictionSolver::applyImpulse(const btSolverConstraint& row, btScalar impulse) {
  btSolverBody& a = m_tmpSolverBodyPool[row.m_solverBodyIdA];
  btSolverBody& b = m_tmpSolverBodyPool[row.m_solverBodyIdB];
  a.internalApplyImpulse(row.m_contactNormal1 * a.internalGetInvMass(), row.m_angularComponentA,
                         impulse);
  b.internalApplyImpulse(row.m_contactNormal2 * b.internalGetInvMass(), row.m_angularComponentB,
                         impulse);
}

}  // namespace smore
