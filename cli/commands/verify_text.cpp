#include "cli/commands/verify_text.h"

#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

constexpr std::size_t kMostLines = 50;

std::string moves(std::size_t count) { return count_text(count, "move"); }

std::string refutation(const Verification::Refuted& refuted, const ClaimedResult& result, const Toolpath* path) {
  std::string line = result.arguments.path;
  if (refuted.move && path != nullptr && *refuted.move < path->moves.size())
    line += ":" + std::to_string(std::size_t{path->moves[*refuted.move].line});
  line += ": refuted: " + refuted.what;
  if (refuted.move) line += ", move " + std::to_string(*refuted.move);
  if (refuted.t) line += " t=" + people_text(*refuted.t, 6);
  if (refuted.point) {
    const Vec3 p = *refuted.point / result.mm_per_unit;
    line += " at (" + people_text(p.x(), 6) + ", " + people_text(p.y(), 6) + ", " + people_text(p.z(), 6) + ")";
  }
  return line;
}

std::string verified_text(const Verification& v) {
  std::string text = "verified: the inputs are those of the result (SHA-256)\n";
  if (v.witnesses > 0)
    text += "verified: " + count_text(v.witnesses, "witness", "witnesses") +
            " (point on its triangle, pose, depth, side, way out)\n";
  const char* const except =
      v.has_heads ? ", of the tool without its heads" : ", at every instant and for every triangle";
  if (v.proved_clean > 0) text += "verified: " + moves(v.proved_clean) + " proved clean" + except + "\n";
  if (v.proved_gouges > 0)
    text += "verified: " + count_text(v.proved_gouges, "gouging move") + " proved to be no deeper than said" + except +
            "\n";
  if (v.outside.proved > 0)
    text +=
        "verified: " + moves(v.outside.proved) + " outside of all solids, as the tool leaves their box on the way\n";
  return text;
}

std::string sampled_text(const Verification& v) {
  std::string text;
  const auto add = [&](const std::string& what) { text += "only sampled: " + what + "\n"; };
  if (v.sampled_clean > 0)
    add(moves(v.sampled_clean) + " said to be clean" + (v.has_certificate ? "" : " (no certificate)"));
  if (v.sampled_gouges > 0) add("the bound of the depth of " + count_text(v.sampled_gouges, "gouging move"));
  if (v.outside.sampled > 0)
    add("that " + moves(v.outside.sampled) + " are outside of all solids, by a winding number");
  if (v.has_heads) add("the heads, in some instants");
  if (v.attack.samples > 0)
    text += "attacked: nothing deeper than said was found in " + count_text(v.attack.samples, "instant") + " of " +
            moves(v.attack.moves) + "\n";
  return text;
}

std::string uncovered_text(const Verification& v) {
  std::string text;
  const auto add = [&](const std::string& what) { text += "not covered: " + what + "\n"; };
  if (v.uncovered > 0) add(moves(v.uncovered) + " that the result itself calls not checked, not certified or buried");
  if (!v.without_proof.empty())
    add(moves(v.without_proof.size()) +
        " said to be clean, for which the certificate says no proof was found (first: move " +
        std::to_string(v.without_proof.front()) + ")");
  if (v.outside.unexamined > 0)
    add("whether " + moves(v.outside.unexamined) + " of tools with a thin body are outside of all solids");
  text +=
      "not part of a verification: overcut, that no move is nearer than said, how far thin features reach into a solid\n";
  return text;
}

}  // namespace

int exit_status(const Verification& v) {
  if (!v.refuted.empty()) return kExitGouges;
  return v.uncovered > 0 || !v.without_proof.empty() || v.outside.unexamined > 0 ? kExitNotChecked : kExitClean;
}

std::string verification_text(const Verification& v, const ClaimedResult& result, const Toolpath* path) {
  std::string text;
  for (std::size_t k = 0; k < v.refuted.size() && k < kMostLines; ++k)
    text += printable(refutation(v.refuted[k], result, path)) + "\n";
  if (v.refuted.size() > kMostLines) text += "and " + std::to_string(v.refuted.size() - kMostLines) + " more\n";
  if (!v.refuted.empty())
    return text + "result: refuted; it is not right, or its inputs are not those that were checked\n";
  text += verified_text(v) + sampled_text(v) + uncovered_text(v);
  if (exit_status(v) != kExitClean) return text + "result: not refuted, but not all of it is covered\n";
  const bool is_all_proved =
      v.has_certificate && !v.has_heads && v.sampled_clean + v.sampled_gouges + v.outside.sampled == 0;
  return text + (is_all_proved ? "result: verified\n"
                               : "result: not refuted; what is only sampled may be wrong all the same\n");
}

}  // namespace gouge
