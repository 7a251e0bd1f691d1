#include <cstdio>
#include <string>
#include <vector>

#include "lib/base/files.h"
#include "samples/cases.h"
#include "samples/write_sample.h"

// make_samples FOLDER: writes every sample and index.txt into FOLDER; make_samples FOLDER large: the one to measure
// with. A program of its own, not part of the tool.

int main(int argc, char** argv) {
  const bool is_large = argc == 3 && std::string(argv[2]) == "large";
  if (argc != 2 && !is_large) {
    std::fputs("usage: make_samples FOLDER [large]\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  const std::vector<gouge::samples::Sample> samples =
      is_large ? std::vector{gouge::samples::make_freeform_large()} : gouge::samples::make_all();
  const auto failed = [](const gouge::Outcome& outcome) {
    if (!outcome) std::fprintf(stderr, "%s\n", gouge::to_text(outcome.error()).c_str());
    return !outcome;
  };
  for (const gouge::samples::Sample& sample : samples) {
    if (failed(gouge::samples::write_sample(sample, folder))) return 3;
  }
  return failed(gouge::write_file(folder + "/index.txt", gouge::samples::index_text(samples))) ? 3 : 0;
}
