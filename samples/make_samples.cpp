#include <cstdio>
#include <string>
#include <vector>

#include "lib/base/files.h"
#include "samples/cases.h"
#include "samples/write_sample.h"

// make_samples FOLDER: writes every sample and index.txt into FOLDER. A program of its own, not part of the
// tool.

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_samples FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  const std::vector<gouge::samples::Sample> samples = gouge::samples::make_all();
  const auto failed = [](const gouge::Outcome& outcome) {
    if (!outcome) std::fprintf(stderr, "%s\n", gouge::to_text(outcome.error()).c_str());
    return !outcome;
  };
  for (const gouge::samples::Sample& sample : samples) {
    if (failed(gouge::samples::write_sample(sample, folder))) return 3;
  }
  return failed(gouge::write_file(folder + "/index.txt", gouge::samples::index_text(samples))) ? 3 : 0;
}
