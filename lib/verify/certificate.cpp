#include "lib/verify/certificate.h"

#include <algorithm>

#include "lib/base/file_kind.h"
#include "lib/verify/certificate_reader.h"
#include "lib/verify/surface_claims.h"
#include "lib/verify/zstd_stream.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerBlock = 256, kMovesPerGroup = 32, kBlocksAtOnce = 64, kBytesPerBlock = 1U << 24U;
constexpr std::string_view kNoProof = "\x09";  // the only step of a move without a proof

CertificateHeader header_for(const ClaimedScene& scene, const SceneOrders& orders, std::string_view inputs,
                             const StockClaims* stock) {
  CertificateHeader header{std::string(inputs),
                           scene.path.moves.size(),
                           orders.parts.root().size(),
                           orders.fixtures.root().size(),
                           scene.tolerance_mm,
                           scene.resolution_mm,
                           (scene.axis_law + (scene.is_dogleg ? " dogleg" : " straight")).substr(0, kLawBytes),
                           std::nullopt};
  if (stock != nullptr) header.stock = StockLengths{stock->tolerance_mm(), stock->resolution_mm()};
  return header;
}

std::string_view magic_for(const StockClaims* stock) {
  return stock != nullptr ? kStockCertificateMagic : kCertificateMagic;
}

std::string what_is_wrong_with(std::string_view bytes, const StockClaims* stock) {
  const std::string_view magic = bytes.substr(0, magic_for(stock).size());
  if (magic == kCertificateMagic)
    return "it has no proofs about stock; expected the certificate that was written with this result";
  if (magic == kStockCertificateMagic && stock == nullptr)
    return "it has proofs about stock, and the result has no stock; expected the certificate of this result";
  if (const std::string stand_in = describe_stand_in({}, bytes); !stand_in.empty()) return stand_in;
  return "it is no certificate of this version; expected a file of 'gougecheck check --certificate'";
}

/// Finds the proofs of consecutive moves.
class BlockMaker {
 public:
  explicit BlockMaker(const ProofSubject& subject) : subject_(subject), search_(subject.search()) {}

  std::vector<ProofGroup> make(std::size_t first, std::size_t last) {
    const RoundsUpward upward;
    for (std::size_t i = first; i < last;) {
      if (!subject_.is_askable(i)) {
        ++i;
        continue;
      }
      std::size_t end = i + 1;
      while (end < last && end - i < kMovesPerGroup && subject_.is_askable(end) && subject_.is_alike(i, end)) ++end;
      prove(i, end - i);
      i = end;
    }
    return std::move(groups_);
  }

 private:
  // Proves a group of moves. If that fails, proves its halves, down to single moves.
  void prove(std::size_t first, std::size_t count) {
    ProofGroup group{first, count, {}};
    if (search_->find(first, count, group.steps)) return groups_.push_back(std::move(group));
    if (count == 1) return groups_.push_back({first, 1, std::string(kNoProof)});
    prove(first, count / 2);
    prove(first + count / 2, count - count / 2);
  }

  const ProofSubject& subject_;
  std::unique_ptr<ProofSearch> search_;
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

/// What a section of a certificate is made for.
struct Section {
  const ProofSubject& subject;
  std::size_t moves = 0;
  unsigned threads = 0;
  const ProgressCall& progress;
};

SectionProofs write_section(const Section& section, ZstdWriter& writer) {
  SectionProofs proofs;
  const std::size_t blocks = (section.moves + kMovesPerBlock - 1) / kMovesPerBlock;
  for (std::size_t done = 0; done < blocks; done += kBlocksAtOnce) {
    const std::size_t now = std::min(kBlocksAtOnce, blocks - done);
    std::vector<std::vector<ProofGroup>> found(now);
    if (section.progress) section.progress("proving moves", done * kMovesPerBlock, section.moves);
    for_each_chunk(now, 1, section.threads, [&](std::size_t k, std::size_t) {
      const std::size_t first = (done + k) * kMovesPerBlock;
      found[k] = BlockMaker(section.subject).make(first, std::min(section.moves, first + kMovesPerBlock));
    });
    for (const std::vector<ProofGroup>& groups : found) {
      add_blocks(groups, writer);
      for (const ProofGroup& group : groups) {
        if (group.steps == kNoProof) proofs.not_proved.push_back(group.first);
        proofs.proved += group.steps == kNoProof ? 0 : group.count;
      }
    }
  }
  writer.add(block_bytes({}));
  return proofs;
}

/// Returns the reason why a group does not prove the claims of the result; nothing if it proves them.
std::optional<ProofRefutation> refute(const ProofSubject& subject, const ProofGroup& group) {
  for (std::size_t i = group.first; i < group.first + group.count; ++i) {
    if (subject.is_askable(i) && (group.count == 1 || subject.is_alike(group.first, i))) continue;
    return ProofRefutation{i, Vec3::Zero(), "the certificate proves a bound that the result does not claim"};
  }
  if (group.steps == kNoProof && group.count == 1) return std::nullopt;
  return subject.refute(group);
}

/// Reads some blocks, up to the end of a section. `is_ended` becomes true there.
Result<std::vector<ProofGroup>> read_blocks(CertificateReader& reader, bool& is_ended) {
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
  return groups;
}

Outcome verify_section(const Section& section, CertificateReader& reader, std::vector<ProofState>& of_move,
                       std::vector<ProofRefutation>& all_refuted) {
  of_move.assign(section.moves, ProofState::missing);
  reader.begin_section();
  for (bool is_ended = false; !is_ended;) {
    const Result<std::vector<ProofGroup>> groups = read_blocks(reader, is_ended);
    if (!groups) return groups.error();
    if (section.progress && !groups->empty())
      section.progress("verifying proofs", groups->front().first, section.moves);
    std::vector<std::optional<ProofRefutation>> refuted(groups->size());
    for_each_chunk(groups->size(), 1, section.threads, [&](std::size_t k, std::size_t) {
      const RoundsUpward upward;
      refuted[k] = refute(section.subject, (*groups)[k]);
    });
    for (std::size_t k = 0; k < groups->size(); ++k) {
      const ProofGroup& group = (*groups)[k];
      if (refuted[k]) all_refuted.push_back(*refuted[k]);
      const ProofState state = refuted[k]                ? ProofState::refuted
                               : group.steps == kNoProof ? ProofState::open
                                                         : ProofState::proved;
      std::fill_n(of_move.begin() + static_cast<std::ptrdiff_t>(group.first), group.count, state);
    }
  }
  for (std::size_t i = 0; i < section.moves; ++i)
    if (of_move[i] == ProofState::missing && section.subject.is_askable(i))
      all_refuted.push_back({i, Vec3::Zero(), "the certificate leaves it out"});
  return Done{};
}

}  // namespace

MadeCertificate make_certificate(const ClaimedScene& scene, const std::vector<MoveClaim>& claims,
                                 std::string_view inputs, const ProgressCall& progress, const StockClaims* stock) {
  const SceneOrders orders(scene);
  MadeCertificate made;
  ZstdWriter writer;
  writer.add(to_bytes(header_for(scene, orders, inputs, stock)));
  const SurfaceClaims surfaces(scene, orders, claims);
  made.surfaces = write_section({surfaces, claims.size(), scene.threads, progress}, writer);
  if (stock != nullptr) made.stock = write_section({*stock, claims.size(), scene.threads, progress}, writer);
  made.bytes = std::string(magic_for(stock)) + writer.finish();
  return made;
}

Result<CertificateReading> verify_certificate(const ClaimedScene& scene, const SceneOrders& orders,
                                              const std::vector<MoveClaim>& claims, std::string_view inputs,
                                              const std::string& name, std::string_view bytes,
                                              const ProgressCall& progress, const StockClaims* stock) {
  const std::string_view magic = magic_for(stock);
  if (bytes.substr(0, magic.size()) != magic)
    return make_error("certificate-invalid", what_is_wrong_with(bytes, stock), name);
  CertificateReader reader(name, bytes.substr(magic.size()), claims.size());
  if (const Outcome header = reader.read_header(header_for(scene, orders, inputs, stock)); !header)
    return header.error();
  CertificateReading reading;
  const SurfaceClaims surfaces(scene, orders, claims);
  const auto verify = [&](const ProofSubject& subject, std::vector<ProofState>& of_move) {
    return verify_section({subject, claims.size(), scene.threads, progress}, reader, of_move, reading.refuted);
  };
  if (const Outcome read = verify(surfaces, reading.of_move); !read) return read.error();
  if (stock != nullptr)
    if (const Outcome read = verify(*stock, reading.of_move_in_stock); !read) return read.error();
  if (const Outcome end = reader.finish(); !end) return end.error();
  return reading;
}

}  // namespace gouge
