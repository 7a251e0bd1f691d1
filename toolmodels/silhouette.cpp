#include "toolmodels/silhouette.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "lib/base/tolerance.h"
#include "toolmodels/box_tree.h"

namespace gouge {
namespace {

constexpr int kSteps = 256;

/// A straight piece of an outline.
struct Piece {
  Vec2 a, b;
};

void add_outline(const Profile& profile, std::vector<Piece>& pieces) {
  std::optional<Vec2> last;
  for (const ProfileElement& element : profile.elements) {
    for (const Vec2& point : sample(element, element.is_arc ? kSteps : 1)) {
      if (last) pieces.push_back({*last, point});
      last = point;
    }
  }
}

// Returns the largest radius of the piece from `a` to `b` between the heights `low` and `high`; negative if the piece
// does not reach them.
double widest_within(const Vec2& a, const Vec2& b, double low, double high) {
  const Vec2& bottom = a.y() < b.y() ? a : b;
  const Vec2& top = a.y() < b.y() ? b : a;
  if (bottom.y() > high || top.y() < low) return -1;
  const double rise = top.y() - bottom.y();
  if (!(rise > 0)) return std::max(a.x(), b.x());
  const auto at = [&](double z) {
    const double t = std::clamp((z - bottom.y()) / rise, 0.0, 1.0);
    return bottom.x() + t * (top.x() - bottom.x());
  };
  return std::max(at(low), at(high));
}

// The largest radius of an outline within a range of heights; negative where the outline does not reach them.
class Widths {
 public:
  explicit Widths(const std::vector<Piece>& pieces) : pieces_(pieces), tree_(boxes_of(pieces)) {}

  [[nodiscard]] double within(double low, double high) const {
    double widest = -1;
    tree_.for_each_meeting({Vec2(-1e300, low), Vec2(1e300, high)}, [&](std::size_t i) {
      widest = std::max(widest, widest_within(pieces_[i].a, pieces_[i].b, low, high));
    });
    return widest;
  }

 private:
  static std::vector<Eigen::AlignedBox2d> boxes_of(const std::vector<Piece>& pieces) {
    std::vector<Eigen::AlignedBox2d> boxes;
    boxes.reserve(pieces.size());
    for (const Piece& piece : pieces) boxes.push_back(Eigen::AlignedBox2d(piece.a).extend(piece.b));
    return boxes;
  }

  const std::vector<Piece>& pieces_;
  detail::BoxTree tree_;
};

// Between neighbouring heights of corners of both outlines the difference is linear, so its maximum is next to a corner.
// A step of the other outline counts as wide within the tolerance of its height, so the heights beside it count too.
double reach_mm(const std::vector<Piece>& pieces, const std::vector<Piece>& others, double from_mm, double to_mm) {
  constexpr double kSame_mm = Tolerance::kFilePoint_mm;
  std::vector<double> heights = {from_mm, to_mm};
  for (const std::vector<Piece>* outline : {&pieces, &others}) {
    for (const Piece& piece : *outline) {
      for (const double z : {piece.b.y() - 2 * kSame_mm, piece.b.y(), piece.b.y() + 2 * kSame_mm})
        if (z >= from_mm && z <= to_mm) heights.push_back(z);
    }
  }
  double reach = 0;
  const Widths own(pieces), other_widths(others);
  for (const double z : heights) {
    const double beside = std::max(0.0, other_widths.within(z - kSame_mm, z + kSame_mm));
    reach = std::max(reach, std::max(0.0, own.within(z, z)) - beside);
  }
  return reach;
}

}  // namespace

double reach_beyond_mm(const Cutter& cutter, const Cutter& other) {
  const Result<Profile> mine = make_cutter_profile(cutter), theirs = make_cutter_profile(other);
  if (!mine || !theirs) return 0;
  std::vector<Piece> pieces, others;
  add_outline(*mine, pieces);
  add_outline(*theirs, others);
  return reach_mm(pieces, others, 0, std::min(length_mm(cutter), length_mm(other)));
}

double reach_beyond_mm(const ToolAssembly& tool, const ToolAssembly& other, double from_mm, double to_mm) {
  const Result<BodyProfiles> mine = make_body_profiles(tool), theirs = make_body_profiles(other);
  if (!mine || !theirs || !(from_mm < to_mm)) return 0;
  std::vector<Piece> pieces, others;
  for (const Profile& body : *mine) add_outline(body, pieces);
  for (const Profile& body : *theirs) add_outline(body, others);
  return reach_mm(pieces, others, from_mm, to_mm);
}

}  // namespace gouge
