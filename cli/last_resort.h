#pragma once

namespace gouge {

/// To be called once, first of all. An exception that nothing can catch any more (out of memory in a destructor of the
/// JSON library, or in the static initialiser of another one) then ends the program with its message and
/// kExitInternal, not with SIGABRT. Broken assertions still abort: their core is the evidence of a bug.
void end_orderly_on_terminate() noexcept;

}  // namespace gouge
