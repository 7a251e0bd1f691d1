#include <btBulletCollisionCommon.h>

#include <cmath>
#include <memory>
#include <vector>

#include "tests/bench/peer_support.h"

// Bullet: the tool as exact convex shapes (a capsule, a cylinder whose margin rounds its edge, the hull of
// two balls), the part as a quantised triangle tree. Swept queries move, but do not turn, the shape; they are
// queried in the pose of the start. At single poses contactPairTest.

namespace gouge::bench {
namespace {

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// Stops at the first contact with penetration.
struct FirstContact : btCollisionWorld::ContactResultCallback {
  bool is_hit = false;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    is_hit = is_hit || point.getDistance() < 0;
    return 0;
  }
};

/// A convex shape that lies along Bullet's y axis, and where its middle is on the tool's axis.
struct AxialShape {
  std::unique_ptr<btConvexShape> shape;
  double middle_mm = 0;
};

AxialShape lower_shape(const ConvexPiece& piece) {
  const double rounding = piece.rounding_mm, z0 = piece.contour.front().y(), z1 = piece.contour.back().y();
  AxialShape out;
  out.middle_mm = 0.5 * (z0 + z1);
  const auto half = static_cast<btScalar>(0.5 * (z1 - z0));
  if (piece.contour.size() == 2) {
    out.shape = std::make_unique<btCapsuleShape>(static_cast<btScalar>(rounding), 2 * half);
  } else if (piece.contour.size() == 3) {
    // The cone is the hull of two balls: that of the tip, and one that touches its side at the top.
    const Vec2 along = (piece.contour[1] - piece.contour[0]).normalized();
    const double wide = rounding + (z1 - z0) * along.x();
    const btVector3 centers[] = {{0, -half, 0}, {0, half, 0}};
    const btScalar radii[] = {static_cast<btScalar>(rounding), static_cast<btScalar>(wide)};
    out.shape = std::make_unique<btMultiSphereShape>(centers, radii, 2);
  } else {
    const auto wide = static_cast<btScalar>(piece.contour[1].x() + rounding);
    const auto margin = static_cast<btScalar>(rounding);
    auto cylinder = std::make_unique<btCylinderShape>(btVector3(wide, half + margin, wide));
    cylinder->setMargin(margin);
    out.shape = std::move(cylinder);
  }
  return out;
}

AxialShape holder_shape(const ConvexPiece& piece) {
  const double z0 = piece.contour[1].y(), z1 = piece.contour[2].y();
  const auto wide = static_cast<btScalar>(piece.contour[1].x());
  auto cylinder = std::make_unique<btCylinderShape>(btVector3(wide, static_cast<btScalar>(0.5 * (z1 - z0)), wide));
  cylinder->setMargin(static_cast<btScalar>(0.001));
  return {std::move(cylinder), 0.5 * (z0 + z1)};
}

class BulletScene {
 public:
  BulletScene(const IndexedMesh& mesh, const BenchTool& tool) : dispatcher_(&configuration_) {
    for (const Vec3& v : mesh.vertices) {
      for (int k = 0; k < 3; ++k) corners_.push_back(static_cast<btScalar>(v[k]));
    }
    for (const TriangleCorners& t : mesh.triangles) {
      for (const Corner c : t) indices_.push_back(static_cast<int>(c));
    }
    array_ = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh.triangles.size()), indices_.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(mesh.vertices.size()), corners_.data(), static_cast<int>(3 * sizeof(btScalar)));
    part_shape_ = std::make_unique<btBvhTriangleMeshShape>(array_.get(), true);
    part_shape_->setMargin(0);
    part_.setCollisionShape(part_shape_.get());
    part_.setWorldTransform(btTransform::getIdentity());
    world_ = std::make_unique<btCollisionWorld>(&dispatcher_, &broadphase_, &configuration_);
    world_->addCollisionObject(&part_);
    shapes_.push_back(lower_shape(tool.lower));
    shapes_.push_back(holder_shape(tool.holder));
  }
  BulletScene(const BulletScene&) = delete;
  BulletScene& operator=(const BulletScene&) = delete;
  ~BulletScene() { world_->removeCollisionObject(&part_); }

  bool is_hit(const Pose& pose) {
    for (const AxialShape& s : shapes_) {
      btCollisionObject object;
      object.setCollisionShape(s.shape.get());
      object.setWorldTransform(transform(pose, s.middle_mm));
      FirstContact contact;
      world_->contactPairTest(&object, &part_, contact);
      if (contact.is_hit) return true;
    }
    return false;
  }

  bool is_hit(const Motion& motion) {
    for (const AxialShape& s : shapes_) {
      const btTransform from = transform(motion.start(), s.middle_mm);
      const btTransform to = transform(motion.end(), s.middle_mm);
      btCollisionWorld::ClosestConvexResultCallback nearest(from.getOrigin(), to.getOrigin());
      world_->convexSweepTest(s.shape.get(), from, to, nearest);
      if (nearest.hasHit()) return true;
    }
    return false;
  }

 private:
  static btTransform transform(const Pose& pose, double middle_mm) {
    const Eigen::Matrix3d m = rotation_of(pose.axis);  // Bullet's y is the tool's axis: columns y, z, x
    btMatrix3x3 basis;
    for (int row = 0; row < 3; ++row) {
      basis[row].setValue(static_cast<btScalar>(m(row, 1)), static_cast<btScalar>(m(row, 2)),
                          static_cast<btScalar>(m(row, 0)));
    }
    return btTransform(basis, to_bullet(pose.tip + middle_mm * pose.axis));
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::vector<btScalar> corners_;
  std::vector<int> indices_;
  std::unique_ptr<btTriangleIndexVertexArray> array_;
  std::unique_ptr<btBvhTriangleMeshShape> part_shape_;
  btCollisionObject part_;
  std::unique_ptr<btCollisionWorld> world_;
  std::vector<AxialShape> shapes_;
};

/// Fewer questions where each takes milliseconds.
std::size_t sample_size(const PeerCase& c) {
  return scaled(c.triangles <= 2400 ? 2000 : c.triangles <= 20000 ? 800 : c.triangles <= 200000 ? 200 : 60);
}

std::function<void(benchmark::State&)> prepare_poses(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = std::make_shared<BulletScene>(c->work.scene.parts[0], c->work.tool);
  const auto sample = sample_poses(*c, sample_size(*c));
  return [=](benchmark::State& state) {
    time_poses(
        state, *c, sample, [&](const Pose& pose) { return scene->is_hit(pose) ? 1.0 : 0.0; }, true);
  };
}

std::function<void(benchmark::State&)> prepare_moves(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = std::make_shared<BulletScene>(c->work.scene.parts[0], c->work.tool);
  const auto sample = sample_moves(*c, sample_size(*c));
  return [=](benchmark::State& state) {
    time_moves(state, sample, [&](const Motion& motion) { return scene->is_hit(motion); });
  };
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  register_measurements({{"bullet.sweep", prepare_moves}, {"bullet.pose", prepare_poses}});
  return run_measurements(count, words);
}
