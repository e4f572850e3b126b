// Bullet, an engine of rigid bodies, as far as falling shards need it: prisms over convex polygons, and blocks that stand.
//
// The same bytes on any processor: Bullet's build in double precision has one way through every processor and computes with
// + − × ÷ and square roots, but for these, which are left aside here:
// - a step's turn by sine and cosine, in moving bodies and in split impulses: `RigidWorld` turns them by the derivative of the
//   quaternion, and impulses are not split;
// - damping by a power: `RigidWorld` damps;
// - contacts of planes and boxes, which turn them or cut them with angles: all is made of convex hulls.
// Pairs are sorted before they are solved, and one thread solves them.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <memory>
#include <vector>

#include "core/vec.h"
#include "geometry/polygon.h"

namespace shatterpave::glass {

// Bullet's tolerances are made for lengths of about 1, so its unit is the centimetre.
inline constexpr double unit_per_mm = 0.1;

inline btVector3 to_units(vec3 mm) { return {unit_per_mm * mm.x, unit_per_mm * mm.y, unit_per_mm * mm.z}; }
inline vec3 to_mm(const btVector3& units) { return vec3{units.x(), units.y(), units.z()} / unit_per_mm; }

class RigidWorld : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  double damping = 0.0;  // per second

  // Where all will be after such a step, as their boxes' ends.
  void predict(double step) { predictUnconstraintMotion(step); }

 protected:
  void predictUnconstraintMotion(btScalar step) override;
  void createPredictiveContacts(btScalar /*step*/) override {}
  void integrateTransforms(btScalar step) override;

 private:
  template <typename Act>
  void each_moving(Act act) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      if (m_nonStaticRigidBodies[i]->isActive()) act(*m_nonStaticRigidBodies[i]);
    }
  }
};

// Where a point of the upright, flat pane is.
using Warp = std::function<vec3(vec3)>;

// Owns what Bullet only points to.
class RigidScene {
 public:
  RigidScene();
  ~RigidScene();
  RigidScene(const RigidScene&) = delete;
  RigidScene& operator=(const RigidScene&) = delete;

  // A prism over convex polygons, z from −half to half, its points where `place` puts them, relative to `pivot`.
  btCollisionShape* prisms(const std::vector<geometry::Polygon>& parts, const Warp& place, vec3 pivot, double half_mm);
  void add_fixed(btCollisionShape* shape, vec3 at_mm);
  void add_block(vec3 low_mm, vec3 high_mm);
  // Not in the world yet: `let_go` puts it there.
  btRigidBody* add_shard(btCollisionShape* shape, double kg, vec3 at_mm);
  void let_go(btRigidBody* body) { world_.addRigidBody(body); }
  // It moves no more.
  void fix(btRigidBody* body);
  // Calls act(body) of each that moves and that the next step may bring to another, by the boxes that they sweep.
  template <typename Act>
  void each_that_may_meet(double step_s, Act act) {
    world_.predict(step_s);
    world_.computeOverlappingPairs();
    const btBroadphasePairArray& pairs = world_.getPairCache()->getOverlappingPairArray();
    for (int i = 0; i < pairs.size(); ++i) {
      for (const btBroadphaseProxy* proxy : {pairs[i].m_pProxy0, pairs[i].m_pProxy1}) {
        const auto* body = static_cast<const btRigidBody*>(proxy->m_clientObject);
        if (!body->isStaticObject()) act(*body);
      }
    }
  }
  // A step, in parts. Motion dies away by `damping` a second.
  void step(double step_s, double damping, int parts) {
    world_.damping = damping;
    for (int part = 0; part < parts; ++part) world_.stepSimulation(step_s / parts, 0, step_s / parts);
    let_standing_sleep();
  }

 private:
  void add_standing(btRigidBody* body);
  void let_standing_sleep();

  // Before anything else of Bullet is made: where no memory is left, Bullet would go on with null.
  struct ThrowingMemory {
    ThrowingMemory();
  };
  ThrowingMemory memory_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<btRigidBody*> awake_standing_;  // put into the world since the last step
  RigidWorld world_;
};

}  // namespace shatterpave::glass
