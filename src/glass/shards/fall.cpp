// Bullet, an engine of rigid bodies, moves the shards: prisms over the convex parts of their outlines. They are let go one
// after another, nearest to an impact first, a little in front of the pane, with some of the push that broke it.
//
// The same bytes on any processor: Bullet's build in double precision has one way through every processor and computes with
// + − × ÷ and square roots, but for these, which are left aside here:
// - a step's turn by sine and cosine, in moving bodies and in split impulses: `World` turns them by the quaternion's
// derivative,
//   and impulses are not split;
// - damping by a power: `World` damps;
// - contacts of planes and boxes, which turn them or cut them with angles: all is made of convex hulls.
// Pairs are sorted before they are solved, and one thread solves them.
#include "glass/shards/fall.h"

#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "core/functions.h"
#include "core/random.h"
#include "glass/shards/convex_parts.h"

namespace shatterpave::glass {

namespace {

// Bullet's tolerances are made for lengths of about 1, so its unit is the centimetre.
constexpr double unit_per_mm = 0.1;
constexpr double gravity_mm_s2 = 9810.0;
constexpr double density_kg_mm3 = 2.5e-6;  // soda-lime glass

// 3 mm a step at the 2.4 m/s of a fall from the middle of a window to its sill: the thickness of a pane.
constexpr double step_s = 1.0 / 800.0;
// Shards are let go so far apart in time.
constexpr double interval_s = 0.02;
// 950 took 31 s and 1,980 took 62 s on a busy machine, so these some two minutes.
constexpr std::ptrdiff_t most_falling = 4000;
// What still moves so long after the last one was let go is given up.
constexpr double longest_s = 5.0;
// A piece is at rest if none of its points moved farther than this between two checks. Splinters tremble in place by less.
constexpr double rest_mm = 0.15;
constexpr int steps_between_looks = 200;
// A piece that was at rest at so many checks in succession stays where it is, as sills do: else all of a heap would be solved
// anew for each piece that falls on it. By eye: three quarters of a second, in which what is about to topple has begun to.
constexpr int looks_at_rest = 3;
// No shard spins faster: a splinter that two others nip would be turned by more than a step can follow.
constexpr double most_spin_per_s = 60.0;

// Hulls are kept this far apart from one another, so that what lies on something does not enter it.
constexpr double skin_mm = 0.1;
// Let go so far in front of the pane, beyond both skins.
constexpr double clear_mm = 0.6;

constexpr double friction = 0.45;
constexpr double restitution = 0.12;
// Damping per second while all flies; grows after that, so that nothing trembles for ever.
constexpr double damping_per_s = 0.3;
constexpr double settling_per_s = 6.0;

// Turns are kept to this many parts, shifts to the lattice.
constexpr double turn_parts = 1e9;

// The parts of outlines that collide may be so much larger than they are.
constexpr double excess = 0.02;
constexpr double excess_mm2 = 1.0;

btVector3 to_units(vec3 mm) { return {unit_per_mm * mm.x, unit_per_mm * mm.y, unit_per_mm * mm.z}; }
vec3 to_mm(const btVector3& units) { return vec3{units.x(), units.y(), units.z()} / unit_per_mm; }

// ---- the world

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

class World : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  double damping = damping_per_s;

 protected:
  void predictUnconstraintMotion(btScalar step) override {
    each_moving([&](btRigidBody& body) { body.setInterpolationWorldTransform(stepped(body, step)); });
  }
  void createPredictiveContacts(btScalar /*step*/) override {}
  void integrateTransforms(btScalar step) override {
    each_moving([&](btRigidBody& body) {
      const double kept = std::max(0.0, 1.0 - damping * step);
      body.setLinearVelocity(kept * body.getLinearVelocity());
      const btVector3 spin = kept * body.getAngularVelocity();
      body.setAngularVelocity(std::min(1.0, most_spin_per_s / std::max(1e-9, spin.length())) * spin);
      body.proceedToTransform(stepped(body, step));
    });
  }

 private:
  template <typename Act>
  void each_moving(Act act) {
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      if (m_nonStaticRigidBodies[i]->isActive()) act(*m_nonStaticRigidBodies[i]);
    }
  }
};

// Owns what Bullet only points to.
class Scene {
 public:
  Scene() : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity(to_units({0.0, -gravity_mm_s2, 0.0}));
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    world_.setForceUpdateAllAabbs(false);  // most shards stand
    world_.getSolverInfo().m_splitImpulse = 0;
    world_.getSolverInfo().m_numIterations = 20;
  }
  ~Scene() {
    for (const auto& body : bodies_) {
      if (body->isInWorld()) world_.removeRigidBody(body.get());
    }
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // A prism over convex polygons, its points relative to `centre`; z from −half to half.
  btCollisionShape* prisms(const std::vector<geometry::Polygon>& parts, vec2 centre, double half_mm);
  void add_fixed(btCollisionShape* shape, vec3 at_mm);
  void add_block(vec3 low_mm, vec3 high_mm);
  // Not in the world yet: `let_go` puts it there.
  btRigidBody* add_shard(btCollisionShape* shape, double kg, vec3 at_mm);
  void let_go(btRigidBody* body) { world_.addRigidBody(body); }
  // It moves no more.
  void fix(btRigidBody* body);
  void step(double damping) {
    world_.damping = damping;
    world_.stepSimulation(step_s, 0, step_s);
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  World world_;
};

btCollisionShape* Scene::prisms(const std::vector<geometry::Polygon>& parts, vec2 centre, double half_mm) {
  auto compound = std::make_unique<btCompoundShape>();
  for (const geometry::Polygon& part : parts) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const vec2 p : part) {
      for (const double z : {-half_mm, half_mm}) hull->addPoint(to_units({p - centre, z}), false);
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

void Scene::add_fixed(btCollisionShape* shape, vec3 at_mm) {
  btRigidBody* body = add_shard(shape, 0.0, at_mm);
  world_.addRigidBody(body);
}

void Scene::add_block(vec3 low_mm, vec3 high_mm) {
  const geometry::Polygon face = {{low_mm.x, low_mm.y}, {high_mm.x, low_mm.y}, {high_mm.x, high_mm.y}, {low_mm.x, high_mm.y}};
  const vec3 middle = 0.5 * (low_mm + high_mm);
  add_fixed(prisms({face}, {middle.x, middle.y}, 0.5 * (high_mm.z - low_mm.z)), middle);
}

void Scene::fix(btRigidBody* body) {
  world_.removeRigidBody(body);
  const btVector3 none(0.0, 0.0, 0.0);
  body->setMassProps(0.0, none);
  body->updateInertiaTensor();
  body->setLinearVelocity(none);
  body->setAngularVelocity(none);
  body->setInterpolationWorldTransform(body->getWorldTransform());
  world_.addRigidBody(body);
}

btRigidBody* Scene::add_shard(btCollisionShape* shape, double kg, vec3 at_mm) {
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

// ---- what shards fall from, and onto

// The frame's lower part, sill, floor, wall and reveal; and a screen in the plane of the pane, so that all fall to one side.
void add_surroundings(Scene& scene, const Pane& pane) {
  const ShardRules& rules = *pane.shards;
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  constexpr double thick_mm = 200.0;
  constexpr double far_mm = 5000.0;
  const double left = box.low.x - rules.reveal_mm;
  const double right = box.high.x + rules.reveal_mm;
  const double sill = box.low.y - rules.sill_drop_mm;
  const double floor = box.low.y - rules.floor_drop_mm;
  const double top = box.high.y + far_mm;
  scene.add_block({left - far_mm, floor - thick_mm, -far_mm}, {right + far_mm, floor, far_mm});
  scene.add_block({left, sill - 0.25 * thick_mm, -thick_mm}, {right, sill, rules.sill_depth_mm});
  scene.add_block({left, sill - thick_mm, -thick_mm}, {right, box.low.y, rules.frame_mm});
  scene.add_block({left - far_mm, floor - thick_mm, -thick_mm}, {right + far_mm, sill, rules.frame_mm});
  scene.add_block({left - thick_mm, sill - thick_mm, -thick_mm}, {left, top, rules.sill_depth_mm});
  scene.add_block({right, sill - thick_mm, -thick_mm}, {right + thick_mm, top, rules.sill_depth_mm});
  scene.add_block({left, sill, -thick_mm}, {right, top, -0.5 * pane.thickness_mm});
}

struct Falling {
  Shard* shard = nullptr;
  vec3 centre_mm{0.0, 0.0, 0.0};  // where it was in the pane
  double away_mm = 0.0;           // from the nearest impact
  double reach_mm = 0.0;          // from its centre to its farthest point
  btRigidBody* body = nullptr;
  btTransform seen = btTransform::getIdentity();  // when it was last looked at
  int looks_at_rest = 0;                          // up to then, one after another

  bool is_at_rest() const { return looks_at_rest > 0; }
  bool is_fixed() const { return body->isStaticObject(); }
};

void throw_out(const Pane& pane, const Falling& falling, vec2 from_impact, std::uint64_t seed) {
  const ShardRules& rules = *pane.shards;
  Address address{Stream::shard_throw, Id(pane.name).child("shard").child(falling.shard->id)};
  const auto draw = [&] {
    const double value = 2.0 * uniform(seed, address) - 1.0;
    ++address.draw;
    return value;
  };
  const double x = falling.away_mm / rules.missing_mm;
  const double push_mm_s = 1000.0 * rules.throw_m_s * (0.25 + 0.75 * exponential(-x * x)) * (1.0 + 0.4 * draw());
  const vec2 aside = falling.away_mm > 0.0 ? from_impact / falling.away_mm : vec2{0.0, 0.0};
  vec3 velocity{0.25 * push_mm_s * (aside + vec2{0.5 * draw(), 0.5 * draw()}), push_mm_s};
  falling.body->setLinearVelocity(to_units(velocity));
  falling.body->setAngularVelocity(btVector3(3.0 * draw(), 2.0 * draw(), 2.0 * draw()));
}

// The shards that fall as bodies, in the order in which they are let go.
std::vector<Falling> fallings(const Pane& pane, std::vector<Shard>& shards, Scene& scene, std::uint64_t seed) {
  const double half_mm = 0.5 * pane.thickness_mm;
  std::vector<Falling> result;
  for (Shard& shard : shards) {
    if (shard.state == ShardState::missing) continue;
    const vec2 centre = geometry::centroid(shard.face.outline);
    btCollisionShape* shape = scene.prisms(convex_parts(shard.face, excess, excess_mm2), centre, half_mm);
    if (shard.state == ShardState::standing) {
      scene.add_fixed(shape, {centre, 0.0});
      continue;
    }
    Falling falling;
    falling.shard = &shard;
    falling.centre_mm = {centre, 0.0};
    for (const vec2 p : shard.face.outline) falling.reach_mm = std::max(falling.reach_mm, glm::length(p - centre));
    vec2 from_impact{0.0, 0.0};
    for (std::size_t i = 0; i < pane.impacts.size(); ++i) {
      const vec2 way = centre - pane.impacts[i].at_mm;
      if (i == 0 || glm::length(way) < falling.away_mm) from_impact = way;
      falling.away_mm = glm::length(from_impact);
    }
    const double kg = density_kg_mm3 * geometry::area(shard.face) * pane.thickness_mm;
    falling.body = scene.add_shard(shape, kg, {centre, pane.thickness_mm + clear_mm});
    throw_out(pane, falling, from_impact, seed);
    result.push_back(falling);
  }
  std::ranges::stable_sort(result, {}, &Falling::away_mm);
  return result;
}

// The farthest that a point of it has moved since it was last looked at: at most by its shift and by twice the half turn.
void look_at(Falling& falling, Scene& scene) {
  if (falling.is_fixed()) return;
  const btTransform& now = falling.body->getWorldTransform();
  const double shift_mm = (now.getOrigin() - falling.seen.getOrigin()).length() / unit_per_mm;
  const btQuaternion turn = now.getRotation() * falling.seen.getRotation().inverse();
  const double half_turn = btVector3(turn.x(), turn.y(), turn.z()).length();
  const bool is_at_rest = falling.body->isInWorld() && shift_mm + 2.0 * half_turn * falling.reach_mm < rest_mm;
  falling.looks_at_rest = is_at_rest ? falling.looks_at_rest + 1 : 0;
  falling.seen = now;
  if (falling.looks_at_rest == looks_at_rest) scene.fix(falling.body);
}

// Lets all go and follows them until they have come to rest, or for the longest time.
void follow(Scene& scene, std::vector<Falling>& fallings) {
  const double last_s = interval_s * static_cast<double>(fallings.size());
  const int most_steps = static_cast<int>((last_s + longest_s) / step_s);
  std::size_t gone = 0;
  for (int step = 0; step < most_steps; ++step) {
    const double now_s = step_s * step;
    if (gone < fallings.size() && now_s >= interval_s * static_cast<double>(gone)) scene.let_go(fallings[gone++].body);
    scene.step(damping_per_s + settling_per_s * std::max(0.0, now_s - last_s));
    if (step % steps_between_looks != 0) continue;
    for (Falling& falling : fallings) look_at(falling, scene);
    if (std::ranges::all_of(fallings, &Falling::is_at_rest)) return;
  }
}

Motion motion_of(const Falling& falling) {
  const btTransform& now = falling.body->getWorldTransform();
  const btMatrix3x3 turn(now.getRotation());
  Motion motion;
  for (int row = 0; row < 3; ++row) {
    const auto rounded = [&](int column) { return std::round(turn[row][column] * turn_parts) / turn_parts; };
    motion.rows[static_cast<std::size_t>(row)] = {rounded(0), rounded(1), rounded(2)};
  }
  const vec3 shift = to_mm(now.getOrigin()) - moved(motion, falling.centre_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) motion.shift_mm[axis] = geometry::to_mm(geometry::to_lattice(shift[axis]));
  return motion;
}

}  // namespace

void let_fall(const Pane& pane, std::vector<Shard>& shards, std::uint64_t seed) {
  const auto count = std::ranges::count(shards, ShardState::fallen, &Shard::state);
  if (count == 0) return;
  if (count > most_falling) {
    throw InputError(Place{"", 0, 0, pane.name + ".shards"},
                     fmt::format("expected at most {} pieces that fall to sill and floor, got {}", most_falling, count));
  }
  Scene scene;
  add_surroundings(scene, pane);
  std::vector<Falling> fallings = glass::fallings(pane, shards, scene, seed);
  follow(scene, fallings);
  for (const Falling& falling : fallings) {
    if (falling.is_at_rest()) {
      falling.shard->motion = motion_of(falling);
    } else {
      falling.shard->state = ShardState::missing;
    }
  }
}

}  // namespace shatterpave::glass
