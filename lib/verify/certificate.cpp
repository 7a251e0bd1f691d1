#include "lib/verify/certificate.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lib/verify/certificate_text.h"
#include "lib/verify/claimed_pieces.h"
#include "lib/verify/surface_proof.h"
#include "lib/verify/zstd_stream.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerBlock = 256, kMovesPerGroup = 32, kBlocksAtOnce = 64, kBytesPerBlock = 1U << 24U;
constexpr std::string_view kNoProof = "\x09";  // the only step of a move without a proof
constexpr std::uint64_t kTriesPerMove = 3'000, kTriesAlone = 300'000;

/// The claims to prove for a move: pairs of a form of its tool and a surface, with the allowed depth.
class Questions {
 public:
  Questions(const ClaimedScene& scene, const SceneOrders& orders) : scene_(scene), orders_(orders) {
    for (const ToolVariants* tool : scene.tools) {
      forms_.push_back(tool == nullptr ? nullptr : std::make_unique<Forms>(*tool));
    }
  }

  /// Returns whether a proof for this move is possible. The lemma of a certificate is about depths, not distances.
  [[nodiscard]] bool is_askable(std::size_t move, const MoveClaim& claim) const {
    const auto has_clearance = [](const ClaimedLimit& limit) { return limit.clearance_mm > 0; };
    if (std::ranges::any_of(scene_.limits, has_clearance)) return false;
    const std::size_t tool = scene_.path.moves[move].tool;
    if (tool >= forms_.size() || !forms_[tool] || !forms_[tool]->is_closed) return false;
    return claims_clean(claim) || (claim.state == ClaimedState::gouge && claim.depth_upper_mm);
  }
  /// Returns whether one proof can cover both moves.
  [[nodiscard]] bool is_alike(std::size_t a, const MoveClaim& of_a, std::size_t b, const MoveClaim& of_b) const {
    return claims_clean(of_a) && claims_clean(of_b) && scene_.path.moves[a].tool == scene_.path.moves[b].tool;
  }
  [[nodiscard]] std::vector<ProofQuestion> of(std::size_t move, const MoveClaim& claim) const {
    const Forms& forms = *forms_[scene_.path.moves[move].tool];
    const double depth = claims_clean(claim) ? scene_.largest_clean_mm() : *claim.depth_upper_mm;
    std::vector<ProofQuestion> all{{forms.part, orders_.parts, depth}, {forms.fixture, orders_.fixtures, depth}};
    if (claims_clean(claim)) {
      all.push_back({forms.clearance, orders_.parts, scene_.resolution_mm});
      all.push_back({forms.clearance, orders_.fixtures, scene_.resolution_mm});
      for (std::size_t k = 0; k < scene_.limits.size(); ++k) {
        const ClaimedLimit& limit = scene_.limits[k];
        const double allowed_mm = limit.tolerance_mm + scene_.resolution_mm;
        all.push_back({limit.is_fixture ? forms.fixture : forms.part, orders_.limited[k], allowed_mm});
      }
    }
    return all;
  }
  /// Returns the pieces of motion of a group of moves; `of_piece` is the move of each piece. Returns nothing if a
  /// motion is not defined.
  [[nodiscard]] std::optional<std::vector<MotionPiece>> pieces(std::size_t first, std::size_t count,
                                                               std::vector<std::size_t>& of_piece) const {
    std::vector<MotionPiece> all;
    for (std::size_t i = first; i < first + count; ++i) {
      const auto own = claimed_pieces(scene_, i);
      if (!own) return std::nullopt;
      all.insert(all.end(), own->begin(), own->end());
      of_piece.resize(all.size(), i);
    }
    return all;
  }
  [[nodiscard]] CertificateHeader header(std::string_view inputs) const {
    return {std::string(inputs),
            scene_.path.moves.size(),
            orders_.parts.root().size(),
            orders_.fixtures.root().size(),
            scene_.tolerance_mm,
            scene_.resolution_mm,
            law()};
  }

 private:
  [[nodiscard]] std::string law() const {
    return (scene_.axis_law + (scene_.is_dogleg ? " dogleg" : " straight")).substr(0, kLawBytes);
  }

  struct Forms {
    explicit Forms(const ToolVariants& tool)
        : part(tool.against_part), fixture(tool.against_fixture), clearance(tool.with_clearance) {
      constexpr double kJoined_mm = 1e-9;
      is_closed = std::max({part.largest_gap_mm(), fixture.largest_gap_mm(), clearance.largest_gap_mm()}) <= kJoined_mm;
    }
    ToolContour part, fixture, clearance;
    bool is_closed = false;
  };

  const ClaimedScene& scene_;
  const SceneOrders& orders_;
  std::vector<std::unique_ptr<Forms>> forms_;
};

class BlockMaker {
 public:
  BlockMaker(const Questions& questions, const std::vector<MoveClaim>& claims)
      : questions_(questions), claims_(claims) {}

  std::vector<ProofGroup> make(std::size_t first, std::size_t last) {
    const RoundsUpward upward;
    for (std::size_t i = first; i < last;) {
      if (!questions_.is_askable(i, claims_[i])) {
        ++i;
        continue;
      }
      std::size_t end = i + 1;
      while (end < last && end - i < kMovesPerGroup && questions_.is_askable(end, claims_[end]) &&
             questions_.is_alike(i, claims_[i], end, claims_[end]))
        ++end;
      prove(i, end - i);
      i = end;
    }
    return std::move(groups_);
  }

 private:
  // Proves a group of moves. If that fails, proves its halves, down to single moves.
  void prove(std::size_t first, std::size_t count) {
    const std::uint64_t tries = count > 1 ? kTriesPerMove * count : kTriesAlone;
    std::vector<std::size_t> of_piece;
    const auto pieces = questions_.pieces(first, count, of_piece);
    ProofGroup group{first, count, {}};
    bool is_proved = pieces.has_value();
    if (pieces) {
      for (const ProofQuestion& question : questions_.of(first, claims_[first]))
        is_proved = is_proved && find_proof(question, *pieces, tries, group.steps);
    }
    if (is_proved) return groups_.push_back(std::move(group));
    if (count == 1) return groups_.push_back({first, 1, std::string(kNoProof)});
    prove(first, count / 2);
    prove(first + count / 2, count - count / 2);
  }

  const Questions& questions_;
  const std::vector<MoveClaim>& claims_;
  std::vector<ProofGroup> groups_;
};

/// Writes groups in blocks. Blocks are small, so that reading needs little memory even if the proofs are long.
void add_blocks(const std::vector<ProofGroup>& groups, ZstdWriter& writer) {
  std::vector<ProofGroup> block;
  std::size_t bytes = 0;
  for (const ProofGroup& group : groups) {
    block.push_back(group);
    bytes += group.steps.size();
    if (bytes < kBytesPerBlock && &group != &groups.back()) continue;
    writer.add(block_bytes(block));
    block.clear();
    bytes = 0;
  }
}

Diagnostic invalid(const std::string& name, const std::string& what) {
  return make_error("certificate-invalid", what, name);
}

class CertificateReader {
 public:
  CertificateReader(const std::string& name, std::string_view bytes, std::size_t moves)
      : name_(name), stream_(bytes), moves_(moves) {}

  [[nodiscard]] Outcome read_header(const CertificateHeader& expected) {
    const std::string bytes = stream_.take(kHeaderBytes);
    if (bytes.size() != kHeaderBytes) return cut_short();
    const CertificateHeader found = header_of(bytes);
    if (found.inputs != expected.inputs)
      return invalid(name_,
                     "it proves something about other inputs; expected the certificate that was written with this "
                     "result");
    if (found.law != expected.law)
      return invalid(name_, "it proves the motion by the law '" + found.law + "'; expected the law of this result, '" +
                                expected.law + "'");
    const auto is_alike = [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); };
    if (found.moves == expected.moves && found.part_triangles == expected.part_triangles &&
        found.fixture_triangles == expected.fixture_triangles && is_alike(found.tolerance_mm, expected.tolerance_mm) &&
        is_alike(found.resolution_mm, expected.resolution_mm))
      return Done{};
    return invalid(name_,
                   "it has other moves, triangles or tolerances than the result; expected the certificate that "
                   "was written with this result");
  }

  /// Returns the groups of the next block; no groups at the end.
  [[nodiscard]] Result<std::vector<ProofGroup>> next() {
    const std::string length = stream_.take(4);
    if (length.size() != 4) return cut_short();
    const std::uint32_t size = block_length(length);
    if (size > kMaxBlockBytes) return invalid(name_, "a block of it is said to have more bytes than any has");
    if (size == 0) {
      if (!stream_.is_at_end()) return invalid(name_, "it goes on after its end, or its check sum is wrong");
      return std::vector<ProofGroup>{};
    }
    const std::string block = stream_.take(size);
    if (block.size() != size) return cut_short();
    auto groups = groups_of(block, min_move_, moves_);
    if (!groups) return invalid(name_, "a block of it names moves that are not there, or not in order");
    min_move_ = groups->back().first + groups->back().count;
    return std::move(*groups);
  }

 private:
  [[nodiscard]] Diagnostic cut_short() const {
    return invalid(name_, stream_.is_broken() ? "its compressed bytes are broken; expected the file as it was written"
                                              : "it ends too early; expected the file as it was written");
  }

  const std::string& name_;
  ZstdReader stream_;
  std::size_t moves_, min_move_ = 0;
};

/// Returns the reason why a group does not prove the claims of the result; nothing if it proves them.
std::optional<ProofRefutation> refute(const Questions& questions, const std::vector<MoveClaim>& claims,
                                      const ProofGroup& group) {
  for (std::size_t i = group.first; i < group.first + group.count; ++i) {
    if (questions.is_askable(i, claims[i]) &&
        (group.count == 1 || questions.is_alike(group.first, claims[group.first], i, claims[i])))
      continue;
    return ProofRefutation{i, Vec3::Zero(), "the certificate proves a bound that the result does not claim"};
  }
  std::vector<std::size_t> of_piece;
  const auto pieces = questions.pieces(group.first, group.count, of_piece);
  if (!pieces) return ProofRefutation{group.first, Vec3::Zero(), "its motion is not defined"};
  std::string_view steps = group.steps;
  for (const ProofQuestion& question : questions.of(group.first, claims[group.first])) {
    ProofFault fault;
    if (!follow_proof(question, *pieces, steps, fault))
      return ProofRefutation{of_piece[fault.piece], fault.point, fault.what};
  }
  if (!steps.empty()) return ProofRefutation{group.first, Vec3::Zero(), "its proof goes on after its end"};
  return std::nullopt;
}

}  // namespace

MadeCertificate make_certificate(const ClaimedScene& scene, const std::vector<MoveClaim>& claims,
                                 std::string_view inputs, const ProgressCall& progress) {
  const SceneOrders orders(scene);
  const Questions questions(scene, orders);
  const std::size_t moves = claims.size();
  MadeCertificate made;
  ZstdWriter writer;
  writer.add(to_bytes(questions.header(inputs)));
  const std::size_t blocks = (moves + kMovesPerBlock - 1) / kMovesPerBlock;
  for (std::size_t done = 0; done < blocks; done += kBlocksAtOnce) {
    const std::size_t now = std::min(kBlocksAtOnce, blocks - done);
    std::vector<std::vector<ProofGroup>> found(now);
    if (progress) progress("proving moves", done * kMovesPerBlock, moves);
    for_each_chunk(now, 1, scene.threads, [&](std::size_t k, std::size_t) {
      const std::size_t first = (done + k) * kMovesPerBlock;
      found[k] = BlockMaker(questions, claims).make(first, std::min(moves, first + kMovesPerBlock));
    });
    for (const std::vector<ProofGroup>& groups : found) {
      add_blocks(groups, writer);
      for (const ProofGroup& group : groups) {
        if (group.steps == kNoProof) made.not_proved.push_back(group.first);
        made.proved += group.steps == kNoProof ? 0 : group.count;
      }
    }
  }
  writer.add(block_bytes({}));
  made.bytes = std::string(kCertificateMagic) + writer.finish();
  return made;
}

Result<CertificateReading> verify_certificate(const ClaimedScene& scene, const SceneOrders& orders,
                                              const std::vector<MoveClaim>& claims, std::string_view inputs,
                                              const std::string& name, std::string_view bytes,
                                              const ProgressCall& progress) {
  if (bytes.substr(0, kCertificateMagic.size()) != kCertificateMagic)
    return invalid(name, "it is no certificate of this version; expected a file of 'gougecheck check --certificate'");
  const Questions questions(scene, orders);
  CertificateReader reader(name, bytes.substr(kCertificateMagic.size()), claims.size());
  if (const Outcome header = reader.read_header(questions.header(inputs)); !header) return header.error();
  CertificateReading reading;
  reading.of_move.resize(claims.size(), ProofState::missing);
  for (bool is_ended = false; !is_ended;) {
    std::vector<ProofGroup> groups;
    std::size_t held = 0;
    for (std::size_t k = 0; k < kBlocksAtOnce && held < kBytesPerBlock && !is_ended; ++k) {
      Result<std::vector<ProofGroup>> block = reader.next();
      if (!block) return block.error();
      is_ended = block->empty();
      for (ProofGroup& group : *block) {
        held += group.steps.size();
        groups.push_back(std::move(group));
      }
    }
    if (progress && !groups.empty()) progress("verifying proofs", groups.front().first, claims.size());
    std::vector<std::optional<ProofRefutation>> refuted(groups.size());
    for_each_chunk(groups.size(), 1, scene.threads, [&](std::size_t k, std::size_t) {
      const RoundsUpward upward;
      if (groups[k].steps != kNoProof || groups[k].count > 1) refuted[k] = refute(questions, claims, groups[k]);
    });
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (refuted[k]) reading.refuted.push_back(*refuted[k]);
      const ProofState state = refuted[k]                    ? ProofState::refuted
                               : groups[k].steps == kNoProof ? ProofState::open
                                                             : ProofState::proved;
      for (std::size_t i = groups[k].first; i < groups[k].first + groups[k].count; ++i) reading.of_move[i] = state;
    }
  }
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (reading.of_move[i] == ProofState::missing && questions.is_askable(i, claims[i]))
      reading.refuted.push_back({i, Vec3::Zero(), "the certificate leaves it out"});
  }
  return reading;
}

}  // namespace gouge
