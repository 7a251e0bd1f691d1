#include "cli/build_facts.h"

#include <CLI/Version.hpp>
#include <array>

#include "lib/base/instruction_sets.h"

// CMakeLists.txt defines GOUGE_VERSIONS, GOUGE_BUILD_TYPE, GOUGE_MPI and the other facts of a build.

namespace gouge {
namespace {

std::string compiler() {
#if defined(__clang__)
  return std::string("clang ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

std::string kernels() {
  static constexpr std::array<const char*, 3> kNames = {"plain", "AVX2", "AVX-512"};
  std::string text;
  for (std::size_t k = 0; k < kNames.size() && k < instruction_sets(); ++k)
    text += (k > 0 ? ", " : "") + std::string(kNames[k]);
  return text;
}

}  // namespace

std::string build_facts_text() {
  std::string text = "built with: " + compiler() + ", " + GOUGE_BUILD_TYPE + "\n";
  text += std::string("libraries: ") + GOUGE_VERSIONS + ", CLI11 " + CLI11_VERSION + "\n";
  text += "kernels here: " + kernels() + "\n";
#if defined(GOUGE_MPI)
  return text + "MPI: yes";
#else
  return text + "MPI: no";
#endif
}

}  // namespace gouge
