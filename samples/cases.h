#pragma once

#include "lib/base/text_writer.h"
#include "samples/sample.h"

// The samples, one function each. docs/develop/testing.md states what each is for.

namespace gouge::samples {

[[nodiscard]] Sample make_freeform();       ///< ball cutter, 5-axis, on a wavy surface beside a wall
[[nodiscard]] Sample make_pocket();         ///< bull-nose in a filleted pocket, a clamp beside it
[[nodiscard]] Sample make_blade();          ///< tapered ball around a twisted blade, NX CLSF with MSYS
[[nodiscard]] Sample make_between_rib();    ///< both positions clean, a rib between them
[[nodiscard]] Sample make_pole_crossing();  ///< clean on the great circle, a gouge where two rotary joints run evenly
[[nodiscard]] Sample make_rapid_joints();   ///< a rapid dips into a post where all joints run evenly
[[nodiscard]] Sample make_rapid_independent();  ///< a rapid dips into a post where each joint runs at its own rate
[[nodiscard]] Sample make_axis_limit();         ///< a joint would be beyond its limit
[[nodiscard]] Sample make_axis_flip();          ///< a joint turns far while the axis hardly turns
[[nodiscard]] Sample make_between_swing();      ///< the tip rests, the holder swings through a post
[[nodiscard]] Sample make_between_head();       ///< the tip rests, the machine head dips into a post
[[nodiscard]] Sample make_thin_post();          ///< a post 0.04 mm thick, one long rapid
[[nodiscard]] Sample make_arcs_nx();            ///< arcs of both senses about a post, in three dialects
[[nodiscard]] Sample make_arcs_creo();
[[nodiscard]] Sample make_arcs_catia();
[[nodiscard]] Sample make_buried();         ///< the tool inside a block, no surface inside the tool
[[nodiscard]] Sample make_inch();           ///< inch toolpath, inch part
[[nodiscard]] Sample make_needles();        ///< flat end mill exactly on a plane of needle triangles
[[nodiscard]] Sample make_big_triangles();  ///< ball on an inclined plane of two triangles 2 m wide
[[nodiscard]] Sample make_sunk_jaw();       ///< a clean path, a vise jaw 2 mm deep in the block

/// The same surface and passes with about 100,000 triangles and 10,000 moves, to measure with.
[[nodiscard]] Sample make_freeform_large();

/// The toolpath of a check that is long: the ball cutter of make_freeform() on its surface, pass after pass, in `moves`
/// moves; one pass in 2,300 dives. Written in parts, as it may be longer than memory.
void put_long_path(std::size_t moves, const PutText& put);

[[nodiscard]] std::vector<Sample> make_all();

}  // namespace gouge::samples
