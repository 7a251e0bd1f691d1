#pragma once

#include "lib/base/text_writer.h"
#include "samples/sample.h"

// The samples, one function for each. docs/develop/testing.md states the purpose of each.

namespace gouge::samples {

[[nodiscard]] Sample make_freeform();     ///< ball cutter, 5-axis, on a wavy surface beside a wall
[[nodiscard]] Sample make_pocket();       ///< bull-nose in a filleted pocket, a clamp beside it
[[nodiscard]] Sample make_blade();        ///< tapered ball around a twisted blade, NX CLSF with MSYS
[[nodiscard]] Sample make_between_rib();  ///< both positions are clean, but a rib is between them
/// clean on the great circle, a gouge if two rotary joints run at constant rates
[[nodiscard]] Sample make_pole_crossing();
[[nodiscard]] Sample make_rapid_joints();  ///< a rapid dips into a post if all joints run at constant rates
/// a rapid dips into a post if each joint runs at its own rate
[[nodiscard]] Sample make_rapid_independent();
[[nodiscard]] Sample make_axis_limit();      ///< a joint would be beyond its limit
[[nodiscard]] Sample make_smoothing_tube();  ///< clean, a gouge if the control may lean the tool axis
[[nodiscard]] Sample make_axis_flip();       ///< a joint turns far while the tool axis hardly turns
[[nodiscard]] Sample make_between_swing();   ///< the tip rests while the holder swings through a post
[[nodiscard]] Sample make_between_head();    ///< the tip rests while the machine head dips into a post
[[nodiscard]] Sample make_thin_post();       ///< a post 0.04 mm thick and one long rapid move
[[nodiscard]] Sample make_arcs_nx();         ///< arcs of both senses about a post, in three dialects
[[nodiscard]] Sample make_arcs_creo();
[[nodiscard]] Sample make_arcs_catia();
[[nodiscard]] Sample make_buried();         ///< the tool inside a block, no surface inside the tool
[[nodiscard]] Sample make_inch();           ///< inch toolpath, inch part
[[nodiscard]] Sample make_needles();        ///< flat end mill exactly on a plane of needle triangles
[[nodiscard]] Sample make_big_triangles();  ///< ball on an inclined plane of two triangles 2 m wide
[[nodiscard]] Sample make_rapid_stock();    ///< a rapid through material that is not yet removed
[[nodiscard]] Sample make_holder_stock();   ///< a holder in the walls of a deep slot
[[nodiscard]] Sample make_excess_corner();  ///< material that stays in a square corner
[[nodiscard]] Sample make_sunk_jaw();       ///< a clean path, with a vise jaw 2 mm deep in the block

/// Makes the surface and the passes of make_freeform() with about 100,000 triangles and 10,000 moves, for measurements.
[[nodiscard]] Sample make_freeform_large();

/// Writes the toolpath of a long check in parts, as it may be longer than memory. The ball cutter of make_freeform()
/// runs on its surface, pass after pass, in `moves` moves; one pass in 2,300 dives.
void put_long_path(std::size_t moves, const PutText& put);

[[nodiscard]] std::vector<Sample> make_all();

}  // namespace gouge::samples
