#include "lib/motion/axis_law.h"

namespace gouge {
namespace {

class Standing : public AxisPath {
 public:
  explicit Standing(const Eigen::Matrix3d& axes) : axes_(axes) {}

  [[nodiscard]] Eigen::Matrix3d axes_at(double /*t*/) const override { return axes_; }
  [[nodiscard]] double turn_rate_rad(double /*t0*/, double /*t1*/) const override { return 0; }
  [[nodiscard]] double turn_acceleration_rad(double /*t0*/, double /*t1*/) const override { return 0; }
  [[nodiscard]] std::optional<Eigen::Matrix3d> axes_at_shares(const TurnShares& /*shares*/) const override {
    return axes_;
  }

 private:
  Eigen::Matrix3d axes_;
};

}  // namespace

std::shared_ptr<const AxisPath> standing_with(const Eigen::Matrix3d& axes) { return std::make_shared<Standing>(axes); }

}  // namespace gouge
