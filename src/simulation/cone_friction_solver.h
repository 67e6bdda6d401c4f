// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

namespace smore {

/// Bullet's solver with Coulomb's friction cone. Bullet itself limits the friction along each of
/// two directions of the contact plane, a square pyramid that lets friction reach sqrt(2) times the
/// coefficient on its diagonals; here both directions are solved together and their impulse is
/// projected onto the disc of radius friction x normal impulse. Contacts are swept one after the
/// other, normal before friction. There must be no joints in the world.
class ConeFrictionSolver : public btSequentialImpulseConstraintSolver {
 protected:
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int body_count,
                                btPersistentManifold** manifolds, int manifold_count,
                                btTypedConstraint** constraints, int constraint_count,
                                const btContactSolverInfo& info,
                                btIDebugDraw* debug_drawer) override;

 private:
  btScalar solveNormal(int contact);
  btScalar solveFriction(int contact);
  btScalar velocityAlong(const btSolverConstraint& row) const;
  void applyImpulse(const btSolverConstraint& row, btScalar impulse);
};

}  // namespace smore
