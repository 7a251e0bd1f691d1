#include "lib/certify/check.h"

#include "lib/check/check_path.h"
#include "lib/check/summarise.h"
#include "lib/head/check_heads.h"
#include "lib/overcut/measure_overcut.h"

namespace gouge {

CheckResult check_moves(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress) {
  CheckResult result = check_path(path, setup.tools, setup.scene, setup.options, progress, setup.kept);
  check_heads(path, setup.heads, setup.scene, setup.options, result, progress, setup.kept);
  summarise(path, result);  // the overcut asks for the worst move of each event
  measure_overcuts(path, setup.tools, setup.scene, setup.options, result, setup.heads, progress, setup.kept);
  return result;
}

CheckResult check(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress) {
  CheckResult result = check_moves(path, setup, progress);
  assess(path, setup, result);
  return result;
}

}  // namespace gouge
