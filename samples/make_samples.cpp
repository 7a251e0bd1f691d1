#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/staged_file.h"
#include "samples/cases.h"
#include "samples/write_sample.h"

// A program that is not part of the tool. make_samples FOLDER writes every sample and index.txt into FOLDER.
// make_samples FOLDER large writes the sample for measurements. make_samples FOLDER long MOVES writes FOLDER/freeform
// with a file long.apt of MOVES moves.

namespace {

std::optional<std::size_t> moves_asked(int argc, char** argv) {
  if (argc != 4 || std::string(argv[2]) != "long") return std::nullopt;
  const auto moves = gouge::parse_integer(argv[3]);
  return moves && *moves > 0 ? std::optional(static_cast<std::size_t>(*moves)) : std::nullopt;
}

gouge::Outcome write_long(const std::string& folder, std::size_t moves) {
  const gouge::samples::Sample sample = gouge::samples::make_freeform();
  if (gouge::Outcome written = gouge::samples::write_sample(sample, folder); !written) return written;
  gouge::Result<gouge::StagedFile> path =
      gouge::StagedFile::make(folder + "/" + sample.name + "/long.apt",
                              [moves](const gouge::PutText& put) { gouge::samples::put_long_path(moves, put); });
  return path ? path->commit() : path.error();
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_large = argc == 3 && std::string(argv[2]) == "large";
  const std::optional<std::size_t> moves = moves_asked(argc, argv);
  if ((argc != 2 && !is_large && !moves) || argv[1][0] == '-') {
    std::fputs("usage: make_samples FOLDER [large | long MOVES]\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  const std::vector<gouge::samples::Sample> samples =
      is_large ? std::vector{gouge::samples::make_freeform_large()} : gouge::samples::make_all();
  const auto failed = [](const gouge::Outcome& outcome) {
    if (!outcome) std::fprintf(stderr, "%s\n", gouge::to_text(outcome.error()).c_str());
    return !outcome;
  };
  if (moves) return failed(write_long(folder, *moves)) ? 3 : 0;
  for (const gouge::samples::Sample& sample : samples) {
    if (failed(gouge::samples::write_sample(sample, folder))) return 3;
  }
  return failed(gouge::write_file(folder + "/index.txt", gouge::samples::index_text(samples))) ? 3 : 0;
}
