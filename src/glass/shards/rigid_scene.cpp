#include "glass/shards/rigid_scene.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <new>

namespace shatterpave::glass {

namespace {

constexpr double gravity_mm_s2 = 9810.0;
// No shard spins faster: a splinter that two others nip would be turned by more than a step can follow.
constexpr double most_spin_per_s = 60.0;

// Hulls are kept this far apart from one another, so that what lies on something does not enter it.
constexpr double skin_mm = 0.1;

constexpr double friction = 0.45;
constexpr double restitution = 0.12;

// Where a body will be after a step, by its velocities alone.
btTransform stepped(const btRigidBody& body, double step) {
  const btTransform& now = body.getWorldTransform();
  const btQuaternion turn = now.getRotation();
  const btVector3 spin = 0.5 * step * body.getAngularVelocity();
  const btQuaternion change = btQuaternion(spin.x(), spin.y(), spin.z(), 0.0) * turn;
  btQuaternion after(turn.x() + change.x(), turn.y() + change.y(), turn.z() + change.z(), turn.w() + change.w());
  after.normalize();
  return btTransform(after, now.getOrigin() + step * body.getLinearVelocity());
}

void* memory_or_throw(std::size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void give_back(void* memory) { std::free(memory); }

}  // namespace

RigidScene::ThrowingMemory::ThrowingMemory() {
  static std::once_flag once;
  std::call_once(once, [] { btAlignedAllocSetCustom(&memory_or_throw, &give_back); });
}

void RigidWorld::predictUnconstraintMotion(btScalar step) {
  each_moving([&](btRigidBody& body) { body.setInterpolationWorldTransform(stepped(body, step)); });
}

void RigidWorld::integrateTransforms(btScalar step) {
  each_moving([&](btRigidBody& body) {
    const double kept = std::max(0.0, 1.0 - damping * step);
    body.setLinearVelocity(kept * body.getLinearVelocity());
    const btVector3 spin = kept * body.getAngularVelocity();
    body.setAngularVelocity(std::min(1.0, most_spin_per_s / std::max(1e-9, spin.length())) * spin);
    body.proceedToTransform(stepped(body, step));
  });
}

RigidScene::RigidScene() : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
  world_.setGravity(to_units({0.0, -gravity_mm_s2, 0.0}));
  world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
  world_.setForceUpdateAllAabbs(false);  // most shards stand
  world_.getSolverInfo().m_splitImpulse = 0;
  world_.getSolverInfo().m_numIterations = 20;
}

RigidScene::~RigidScene() {
  for (const auto& body : bodies_) {
    if (body->isInWorld()) world_.removeRigidBody(body.get());
  }
}

btCollisionShape* RigidScene::prisms(const std::vector<geometry::Polygon>& parts, const Warp& place, vec3 pivot,
                                     double half_mm) {
  auto compound = std::make_unique<btCompoundShape>();
  for (const geometry::Polygon& part : parts) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const vec2 p : part) {
      for (const double z : {-half_mm, half_mm}) hull->addPoint(to_units(place({p, z}) - pivot), false);
    }
    hull->recalcLocalAabb();
    hull->setMargin(unit_per_mm * skin_mm);
    compound->addChildShape(btTransform::getIdentity(), hull.get());
    shapes_.push_back(std::move(hull));
  }
  compound->setMargin(unit_per_mm * skin_mm);
  shapes_.push_back(std::move(compound));
  return shapes_.back().get();
}

void RigidScene::add_fixed(btCollisionShape* shape, vec3 at_mm) { add_standing(add_shard(shape, 0.0, at_mm)); }

// Awake, a body has its box made anew in each step, which is most of the work where thousands stand; so it sleeps once a step
// has made it.
void RigidScene::add_standing(btRigidBody* body) {
  world_.addRigidBody(body);
  awake_standing_.push_back(body);
}

void RigidScene::let_standing_sleep() {
  for (btRigidBody* body : awake_standing_) body->forceActivationState(ISLAND_SLEEPING);
  awake_standing_.clear();
}

void RigidScene::add_block(vec3 low_mm, vec3 high_mm) {
  const geometry::Polygon face = {{low_mm.x, low_mm.y}, {high_mm.x, low_mm.y}, {high_mm.x, high_mm.y}, {low_mm.x, high_mm.y}};
  const vec3 middle = 0.5 * (low_mm + high_mm);
  add_fixed(prisms(
                {face}, [](vec3 p) { return p; }, {middle.x, middle.y, 0.0}, 0.5 * (high_mm.z - low_mm.z)),
            middle);
}

void RigidScene::fix(btRigidBody* body) {
  world_.removeRigidBody(body);
  const btVector3 none(0.0, 0.0, 0.0);
  body->setMassProps(0.0, none);
  body->updateInertiaTensor();
  body->setLinearVelocity(none);
  body->setAngularVelocity(none);
  body->setInterpolationWorldTransform(body->getWorldTransform());
  add_standing(body);
}

btRigidBody* RigidScene::add_shard(btCollisionShape* shape, double kg, vec3 at_mm) {
  btVector3 inertia(0.0, 0.0, 0.0);
  if (kg > 0.0) shape->calculateLocalInertia(kg, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(kg, nullptr, shape, inertia);
  info.m_startWorldTransform.setOrigin(to_units(at_mm));
  info.m_friction = friction;
  info.m_restitution = restitution;
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
  return bodies_.back().get();
}

}  // namespace shatterpave::glass
