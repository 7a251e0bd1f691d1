#include <utility>

#include <gougecheck/check.h>

#include "cli/library/checked_path.h"
#include "lib/base/parallel.h"
#include "lib/certify/motion_checker.h"

namespace gougecheck {
namespace {

constexpr std::size_t kChunk = 16;  // positions; a fixed number, so that results do not depend on the number of threads

gouge::CheckOptions exact(const CheckOptions& options) {
  gouge::CheckOptions result = to_check_options(options);
  result.tolerance_mm = 0;
  result.near_miss_mm = 0;
  result.is_depth_alone = true;
  return result;
}

[[noreturn]] void refuse(std::size_t position) {
  raise(gouge::make_error("path-axis", "position " + std::to_string(position) +
                                           ": expected a tip within 100 m of the origin and an axis with a length"));
}

}  // namespace

struct DepthQuery::Content {
  Content(const Scene& of_scene, const Tool& tool, const CheckOptions& asked)
      : scene(of_scene),
        options(exact(asked)),
        variants(compile(tool.content().assembly, options)),
        checker({{&variants}, heads, scene.content().index->prepared(asked.threads), options}) {}
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;

  [[nodiscard]] Contact at(const gouge::Pose& pose) const {
    const gouge::MoveVerdict verdict = checker.check(options.law.at(pose), gouge::MoveKind::feed, variants, options);
    Contact contact;
    contact.state = static_cast<State>(verdict.state);
    contact.depth = verdict.depth_mm;
    contact.depth_upper = verdict.depth_upper_mm;
    if (!verdict.witness) return contact;
    contact.point = to_array(verdict.witness->point);
    contact.normal = to_array(verdict.witness->normal);
    contact.triangle = static_cast<std::int64_t>(verdict.witness->triangle);
    contact.body = static_cast<Body>(verdict.witness->body);
    return contact;
  }

  Scene scene;
  gouge::CheckOptions options;
  gouge::ToolVariants variants;
  std::vector<gouge::HeadBody> heads;
  gouge::MotionChecker checker;
};

DepthQuery::DepthQuery(const Scene& scene, const Tool& tool, const CheckOptions& options)
    : content_(std::make_shared<Content>(scene, tool, options)) {}

Contact DepthQuery::at(const Vec3& tip, const Vec3& axis) const {
  const auto pose = to_pose(tip, axis);
  if (!pose) refuse(0);
  return content_->at(*pose);
}

std::vector<Contact> DepthQuery::at(std::span<const Vec3> tips, std::span<const Vec3> axes, unsigned threads) const {
  if (axes.size() != tips.size() && axes.size() != 1) {
    raise(gouge::make_error("path-count", std::to_string(tips.size()) + " tips and " + std::to_string(axes.size()) +
                                              " axes; expected as many axes as tips, or one"));
  }
  std::vector<Contact> contacts(tips.size());
  gouge::for_each_chunk(tips.size(), kChunk, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto pose = to_pose(tips[i], axes[axes.size() == 1 ? 0 : i]);
      if (!pose) refuse(i);
      contacts[i] = content_->at(*pose);
    }
  });
  return contacts;
}

}  // namespace gougecheck
