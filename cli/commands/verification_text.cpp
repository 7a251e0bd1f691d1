#include "cli/commands/verification_text.h"

#include "cli/terminal/length_text.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {

namespace {

constexpr std::size_t kMaxLines = 50;

std::string moves(std::size_t count) { return count_text(count, "move"); }

std::string refutation(const Verification::Refuted& refuted, const ClaimedResult& result) {
  std::string line = result.arguments.path;
  if (refuted.line) line += ":" + std::to_string(*refuted.line);
  line += ": refuted: " + refuted.what;
  if (refuted.move) line += ", move " + std::to_string(*refuted.move);
  if (refuted.t) line += " t=" + display_text(*refuted.t, 6);
  if (refuted.point) {
    const Vec3 p = *refuted.point / result.mm_per_unit;
    line += " at (" + display_text(p.x(), 6) + ", " + display_text(p.y(), 6) + ", " + display_text(p.z(), 6) + ")";
  }
  return line;
}

std::string verified_text(const Verification& v) {
  std::string text =
      "verified: the inputs are those of the result (SHA-256)\n"
      "verified: its findings, acceptances, totals, tools, motions and facts are those of its moves and inputs\n";
  if (v.witnesses > 0)
    text += "verified: " + count_text(v.witnesses, "witness", "witnesses") +
            " (point on its triangle, pose, depth, side, way out)\n";
  if (v.stock_witnesses > 0)
    text += "verified: " + count_text(v.stock_witnesses, "witness", "witnesses") +
            " in the stock (point in the stock, pose, depth, no earlier cutter there)\n";
  const std::string except =
      std::string(v.stock ? " against parts and fixtures" : "") +
      (v.has_heads ? ", of the tool without its heads" : ", at every instant and for every triangle");
  if (v.proved_clean > 0) text += "verified: " + moves(v.proved_clean) + " proved clean" + except + "\n";
  if (v.proved_gouges > 0)
    text += "verified: " + count_text(v.proved_gouges, "gouging move") + " proved to be no deeper than said" + except +
            "\n";
  if (v.outside.proved > 0)
    text +=
        "verified: " + moves(v.outside.proved) + " outside of all solids, as the tool leaves their box on the way\n";
  if (v.proved_stock > 0)
    text += "verified: " + moves(v.proved_stock) +
            " proved to meet no remaining stock deeper than said, at every instant\n";
  return text;
}

std::string attack_text(const Verification& v) {
  std::string text;
  if (v.attack.samples > 0)
    text += "attacked: nothing deeper than said was found in " + count_text(v.attack.samples, "instant") + " of " +
            moves(v.attack.moves) + "\n";
  if (v.stock) text += "attacked: no stock was left at " + count_text(v.stock->samples, "place") + " of these moves\n";
  return text;
}

std::string prefixed(const char* word, const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += std::string(word) + ": " + part + "\n";
  return text;
}

}  // namespace

std::vector<std::string> refutation_lines(const Verification& v, const ClaimedResult& result) {
  std::vector<std::string> lines;
  for (const Verification::Refuted& one : v.refuted) lines.push_back(refutation(one, result));
  return lines;
}

std::vector<std::string> sampled_parts(const Verification& v) {
  std::vector<std::string> parts;
  if (v.sampled_clean > 0)
    parts.push_back(moves(v.sampled_clean) + " said to be clean" + (v.has_certificate ? "" : " (no certificate)"));
  if (v.sampled_gouges > 0)
    parts.push_back("the bound of the depth of " + count_text(v.sampled_gouges, "gouging move"));
  if (v.outside.sampled > 0)
    parts.push_back("that " + moves(v.outside.sampled) + " are outside of all solids, by a winding number");
  if (v.has_heads) parts.emplace_back("the heads, in some instants");
  if (v.stock && v.sampled_stock > 0)
    parts.push_back(moves(v.sampled_stock) + " said to be clear of the stock, or to meet it no deeper than said");
  return parts;
}

std::vector<std::string> uncovered_parts(const Verification& v) {
  std::vector<std::string> parts;
  const auto add = [&](std::string what) { parts.push_back(std::move(what)); };
  if (v.uncovered > 0) add(moves(v.uncovered) + " that the result itself calls not checked, not certified or buried");
  if (!v.without_proof.empty())
    add(moves(v.without_proof.size()) +
        " said to be clean, for which the certificate says no proof was found (first: move " +
        std::to_string(v.without_proof.front()) + ")");
  if (!v.without_stock_proof.empty())
    add(moves(v.without_stock_proof.size()) +
        " said to be clear of the stock, for which the certificate says no proof was found (first: move " +
        std::to_string(v.without_stock_proof.front()) + ")");
  if (v.outside.unexamined > 0)
    add("whether " + moves(v.outside.unexamined) + " of tools with a thin body are outside of all solids");
  if (v.is_placement_open) add("whether the path fits the part, which depends on depths of clean moves");
  if (v.has_excess) add("the material that the result states to be left on the parts");
  return parts;
}

const char* not_part_of_a_verification() {
  return "not part of a verification: overcut, that no move is nearer than said, how far thin features reach into a "
         "solid\n";
}

bool is_all_proved(const Verification& v) {
  return v.has_certificate && !v.has_heads &&
         v.sampled_clean + v.sampled_gouges + v.sampled_stock + v.outside.sampled == 0;
}

std::string verification_text(const Verification& v, const ClaimedResult& result) {
  std::string text;
  for (std::size_t k = 0; k < v.refuted.size() && k < kMaxLines; ++k)
    text += printable(refutation(v.refuted[k], result)) + "\n";
  if (v.refuted.size() > kMaxLines) text += "and " + std::to_string(v.refuted.size() - kMaxLines) + " more\n";
  if (!v.refuted.empty())
    return text + "result: refuted; it is not right, or its inputs are not those that were checked\n";
  text += verified_text(v) + prefixed("only sampled", sampled_parts(v)) + attack_text(v) +
          prefixed("not covered", uncovered_parts(v)) + not_part_of_a_verification();
  if (exit_status(v) != kExitClean) return text + "result: not refuted, but not all of it is covered\n";
  return text + (is_all_proved(v) ? "result: verified\n"
                                  : "result: not refuted; what is only sampled may be wrong all the same\n");
}

}  // namespace gouge
