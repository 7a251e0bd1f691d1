#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

// Support for code that is compiled for several instruction sets from one source. The arithmetic must be the same in
// each, bit for bit. So no operations are fused (-ffp-contract=off) and no sum is reordered.

/// Compiles the function that follows once for each instruction set; one copy is selected when the program starts. Has
/// no effect if the compiler or a sanitizer does not support it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define GOUGE_WIDE [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define GOUGE_WIDE
#endif

namespace gouge {

/// Returns how many of the sets plain, AVX2 and AVX-512 (F, VL and DQ), in that order, this processor supports: at
/// least 1.
[[nodiscard]] inline std::size_t instruction_sets() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    return 3;
  if (__builtin_cpu_supports("avx2")) return 2;
#endif
  return 1;
}

/// Returns the kernels that this processor can run, the fastest last. `kernels` has one for each instruction set, in
/// the order of instruction_sets().
template <typename Kernel, std::size_t count>
[[nodiscard]] std::span<const Kernel* const> runnable(const std::array<const Kernel*, count>& kernels) {
  return std::span(kernels).first(std::min(count, instruction_sets()));
}

}  // namespace gouge
