#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/hierarchy/blocks.h"

// The bound of docs/method/wide_sweep.md for sixteen nodes or triangles at once, in single precision. The same source
// is compiled for several instruction sets. IEEE 754 rounds each of its operations correctly, and none is fused or
// reordered, so all instruction sets give the same bytes.

namespace gouge {

struct CoverPiece;

/// A motion to first order, in the frame of a tree (mm, part coordinates minus its origin). In tool coordinates the
/// surface point p is at u - s (displacement + turn x u) + e, where u = p - tip. Here s lies in [-1/2, 1/2] and |e| <=
/// rest + rest_per_mm |u|. The tool axis at s = 0 is `axis`.
struct SweepFrame {
  std::array<float, 3> tip{}, axis{}, displacement{}, turn{};
  float displacement_mm = 0;  ///< at least |displacement|
  float half_turn = 0;        ///< at least |turn| / 2
  float rest_mm = 0, rest_per_mm = 0;
  float beside_mm = 0;  ///< maximum distance of the tip from its position on the straight path
};

/// A piece of the tool's cover, in single precision.
struct KernelPiece {
  static constexpr std::size_t kMaxLines = 11;
  struct Line {
    float r = 0, z = 0;        ///< a point of the line
    float dr = 0, dz = 1;      ///< its unit direction
    float in_r = 0, in_z = 0;  ///< vector from the line's first corner to the point that is 1 mm inside both lines of
                               ///< that corner
  };
  std::array<Line, kMaxLines> lines;  ///< line k + 1 starts at the corner where line k ends
  std::uint32_t count = 0;
  bool is_sharp = false;  ///< its corners are not rounded
  float radius_mm = 0;
  float z_lo_mm = 0, z_hi_mm = 0, foot_lo_mm = 0, foot_hi_mm = 0, r_below_mm = 0, r_above_mm = 0, r_closed_mm = 0;
  bool is_pin = false;     ///< the core is a stretch of the axis, without an upper end
  bool is_disc = false;    ///< the core begins with a flat face around the axis
  bool is_steady = false;  ///< the corners determine how far the core reaches in any direction
  float core_r_mm = 0;     ///< largest r of a corner of the chain, or of its only line
  float core_mm = 0;       ///< largest |r| + |z| of a corner of the core
  bool is_level_below = false, is_level_above = false;  ///< the core ends in a flat face
  float rounding_mm = 0;                                ///< effect of single precision on distances from the piece
};

[[nodiscard]] KernelPiece kernel_piece(const CoverPiece& piece);

struct alignas(64) KernelResult {
  Lanes bound;                 ///< if >= need, it is proved: signed distance >= bound, everywhere in the lane
  Lanes distance;              ///< signed distance of the last examined point
  std::array<Lanes, 3> point;  ///< the deepest examined point minus the frame's tip, mm; only for triangles
  std::uint32_t open = 0;      ///< bit i: lane i is not pruned, because bound < need
  float min_pruned = 0;        ///< smallest bound among the pruned lanes; infinite if there are none
};

/// Functions that bound sixteen nodes, or triangles, against one piece during one motion. The value `need` is the
/// signed distance to prove: minus the permitted depth, or plus the distance to keep.
struct SweepKernel {
  const char* name;
  void (*nodes)(const NodeBlock&, const SweepFrame&, const KernelPiece&, float need, KernelResult&);
  void (*triangles)(const TriangleBlock&, const SweepFrame&, const KernelPiece&, float need, KernelResult&);
};

/// Returns all kernels that this processor can run, the fastest last.
[[nodiscard]] std::span<const SweepKernel* const> sweep_kernels();
[[nodiscard]] const SweepKernel& fastest_sweep_kernel();

}  // namespace gouge
