#pragma once

namespace gouge {

/// To be called once, first of all. An exception that nothing can catch any more (out of memory in a destructor of the
/// JSON library, or in the static initialiser of another one) then ends the program with its message and
/// kExitInternal, not with SIGABRT. Broken assertions still abort: their core is the evidence of a bug.
void end_orderly_on_terminate() noexcept;

/// To be called once. SIGINT (ctrl-C), SIGTERM and SIGHUP then remove the temporary names of outputs before they end
/// the program, as these signals do; one that is ignored (nohup) stays so.
void tidy_up_on_signals();

}  // namespace gouge
