#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/verify/certificate.h"
#include "lib/verify/certificate_text.h"
#include "lib/verify/zstd_stream.h"
#include "tests/fuzz/require.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

// Certificates of a small scene: five moves, two of which are stated to be clean and dive 1 mm deep. By its first byte an
// input is the steps of a proof for each move, the file itself, or what is packed in it behind a right header. It is
// refused as certificate-invalid, or read; whatever it holds, no false claim is proved.

namespace gouge {
namespace {

using fuzz::require;

const std::string kInputs(64, 'a');

struct Case {
  Toolpath path = paths::through({paths::upright(-5, 5, 12), paths::upright(5, 5, 12), paths::upright(5, 5, 9),
                                  paths::upright(15, 5, 9), paths::upright(15, 5, 12)});
  ToolVariants tool = tools::ball(4);
  std::vector<IndexedMesh> parts{shapes::cube()};
  ClaimedScene scene{path, {&tool}, parts, {}, {}};
  std::vector<MoveClaim> claims;

  Case() {
    claims.resize(path.moves.size());  // all clean: of moves 2 and 3 that is a lie
    scene.threads = 1;
  }
};

const Case& the_case() {
  static const Case made;
  return made;
}

std::string header() {
  const Case& of = the_case();
  return to_bytes({kInputs,
                   of.path.moves.size(),
                   of.parts[0].triangles.size(),
                   0,
                   of.scene.tolerance_mm,
                   of.scene.resolution_mm,
                   {}});
}

std::string packed(std::string_view content) {
  ZstdWriter writer;
  writer.add(header());
  writer.add(content);
  return std::string(kCertificateMagic) + writer.finish();
}

// The steps of one group, in a block of the right length.
std::string as_blocks(std::string_view bytes) {
  std::vector<ProofGroup> groups;
  std::size_t first = 0;
  for (; first < the_case().path.moves.size() && !bytes.empty(); ++first) {
    const std::size_t size = std::min<std::size_t>(static_cast<unsigned char>(bytes.front()), bytes.size() - 1);
    groups.push_back({first, 1, std::string(bytes.substr(1, size))});
    bytes.remove_prefix(size + 1);
  }
  return (groups.empty() ? std::string() : block_bytes(groups)) + block_bytes({});
}

void read(std::string_view bytes) {
  const Case& of = the_case();
  const Result<CertificateReading> reading =
      verify_certificate(of.scene, SceneOrders(of.scene), of.claims, kInputs, "proofs.gcp", bytes, {});
  if (!reading) return require(reading.error().code == "certificate-invalid" && !reading.error().message.empty());
  require(reading->of_move.size() == of.claims.size());
  for (const std::size_t dives : {2U, 3U}) require(reading->of_move[dives] != ProofState::proved);
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // The scene is what it is stated to be: the honest moves have proofs, which are read, and no others.
  const gouge::Case& of = gouge::the_case();
  const gouge::MadeCertificate made = gouge::make_certificate(of.scene, of.claims, gouge::kInputs, {});
  const auto read =
      gouge::verify_certificate(of.scene, gouge::SceneOrders(of.scene), of.claims, gouge::kInputs, "", made.bytes, {});
  gouge::fuzz::require(read && made.surfaces.proved == 3 && made.surfaces.not_proved.size() == 2 &&
                       read->refuted.empty());
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 3) {
    case 0:
      gouge::read(gouge::packed(gouge::as_blocks(bytes)));
      break;
    case 1:
      gouge::read(bytes);
      break;
    default:
      gouge::read(gouge::packed(bytes));
  }
  return 0;
}
