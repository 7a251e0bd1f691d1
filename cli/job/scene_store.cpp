#include "cli/job/scene_store.h"

namespace gouge {

std::string SceneStore::group_of(const JobArguments& a) {
  // The unit is that of the option, or that of the toolpath.
  return a.stl_units + '\n' +
         SceneRequest{a.parts, a.fixtures, a.heads, LengthUnit::mm, {}, a.place, a.input.max_bytes, 0}.key();
}

void SceneStore::expect(const JobArguments& arguments) {
  const std::scoped_lock lock(guard_);
  ++groups_[group_of(arguments)].jobs;
}

void SceneStore::release(const JobArguments& arguments) {
  const std::scoped_lock lock(guard_);
  const auto group = groups_.find(group_of(arguments));
  if (group != groups_.end() && --group->second.jobs == 0) groups_.erase(group);
}

SceneSource SceneStore::source(const JobArguments& arguments) {
  return [this, group = group_of(arguments)](const SceneRequest& request, Progress& progress) {
    std::shared_ptr<Entry> entry;
    {
      const std::scoped_lock lock(guard_);
      std::shared_ptr<Entry>& place = groups_[group].entries[request.key()];
      if (!place) place = std::make_shared<Entry>();
      entry = place;
    }
    std::call_once(entry->once, [&] {
      SceneRequest its = request;
      its.copies = copies_;
      entry->files = load_scene(its, progress);
    });
    return entry->files;
  };
}

}  // namespace gouge
