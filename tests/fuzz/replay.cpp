#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

// replay FOLDER...: gives a fuzz target an empty input and each file of the folders. With this main, each compiler builds
// the targets, and the suite runs them on their seeds. A target that finds something aborts.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* count, char*** words);

// Targets with a mutator of their own call this one of libFuzzer, which is not here.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* /*data*/, std::size_t size, std::size_t /*most*/) { return size; }

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void replay(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

void replay_all(const std::vector<std::string>& folders) {
  replay("");
  for (const std::string& folder : folders) {
    for (const fs::path& file : files_of(folder)) {
      std::ifstream in(file, std::ios::binary);
      std::printf("%s\n", file.c_str());
      std::fflush(stdout);
      replay(std::string(std::istreambuf_iterator<char>(in), {}));
    }
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    const std::vector<std::string> folders(words + 1, words + count);
    if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&count, &words);
    replay_all(folders);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
