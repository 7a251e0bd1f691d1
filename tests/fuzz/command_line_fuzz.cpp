#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/run.h"
#include "tests/fuzz/require.h"

// Command lines, one argument a line, in a scratch folder that holds a small job. No argument reaches out of it:
// slashes and double dots become underscores. The exit status is one of the documented ones, a refusal states why,
// nothing that a terminal would take for a command is printed on standard error, and a file that was given as input is
// as it was.

namespace gouge {
namespace {

namespace fs = std::filesystem;
using fuzz::require;

struct InputFile {
  const char* name;
  std::string bytes;
};

constexpr std::size_t kMaxArguments = 40;

const std::vector<InputFile>& inputs() {
  static const std::string kTriangles =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 9 0 0\nvertex 9 9 1\nvertex 0 9 0\nendloop\nendfacet\nendsolid s\n";
  static const std::vector<InputFile> kFiles = {
      {"a.apt", "UNITS/MM\nMULTAX/ON\nLOADTL/1\nGOTO/0,0,5\nGOTO/2,2,-0.2,0,0,1\nRAPID\nGOTO/9,9,20\n"},
      {"b.txt", "GOTO/0 0 5 0 0 1\nGOTO/5 5 5 0 0.6 0.8\n"},
      {"p.stl", kTriangles},
      {"t.json",
       "{\"units\":\"mm\",\"tools\":[{\"number\":1,\"name\":\"ball\",\"cutter\":{\"shape\":\"ball\",\"diameter\":4,"
       "\"length\":9},\"holder\":[{\"lower_diameter\":20,\"upper_diameter\":20,\"length\":9}]}]}"},
      {"f.fctb",
       "{\"version\":2,\"name\":\"x\",\"shape\":\"ballend.fcstd\",\"parameter\":{\"CuttingEdgeHeight\":\"20 "
       "mm\",\"Diameter\":\"5 mm\",\"Length\":\"50 mm\",\"ShankDiameter\":\"3 mm\"},\"attribute\":{}}"}};
  return kFiles;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

fs::path& scratch() {
  static fs::path folder;
  return folder;
}

std::vector<std::string> arguments_of(std::string text) {
  std::replace(text.begin(), text.end(), '/', '_');
  for (std::size_t at = 0; (at = text.find("..", at)) != std::string::npos;) text.replace(at, 2, "__");
  std::vector<std::string> words;
  std::istringstream lines(text);
  for (std::string line; words.size() < kMaxArguments && std::getline(lines, line);) words.emplace_back(line.c_str());
  return words;
}

std::size_t times_named(const std::vector<std::string>& words, std::string_view name) {
  return static_cast<std::size_t>(std::count_if(
      words.begin(), words.end(), [&](const std::string& word) { return word.find(name) != std::string::npos; }));
}

// A file that is named once may have been an output; named twice it was an input too, and never otherwise.
void tidy_up(const std::vector<std::string>& words) {
  for (const InputFile& input : inputs()) {
    const fs::path file = scratch() / input.name;
    if (bytes_of(file) == input.bytes) continue;
    require(times_named(words, input.name) == 1);
    fs::remove_all(file);
    std::ofstream(file, std::ios::binary) << input.bytes;
  }
  for (const auto& entry : fs::directory_iterator(scratch())) {
    const std::string name = entry.path().filename().string();
    const bool is_input =
        std::any_of(inputs().begin(), inputs().end(), [&](const InputFile& input) { return name == input.name; });
    if (!is_input) fs::remove_all(entry.path());
  }
}

void run_words(const std::vector<std::string>& words) {
  std::vector<const char*> argv = {"gougecheck"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  argv.push_back(nullptr);
  std::ostringstream out, err;
  const int status = run(static_cast<int>(argv.size()) - 1, argv.data(), out, err);
  require(status >= 0 && status <= 5);
  const std::string reported = err.str();
  require((status != 2 && status != 3 && status != 5) || !reported.empty());
  if (times_named(words, "--progress") > 0) return;
  require(std::none_of(reported.begin(), reported.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n') || byte == 0x7f;
  }));
}

}  // namespace
}  // namespace gouge

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::string name = (std::filesystem::temp_directory_path() / "gouge_fuzz_XXXXXX").string();
  gouge::fuzz::require(::mkdtemp(name.data()) != nullptr);
  gouge::scratch() = name;
  std::atexit([] { std::filesystem::remove_all(gouge::scratch()); });
  gouge::tidy_up({"a.apt", "b.txt", "p.stl", "t.json", "f.fctb"});
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> words = gouge::arguments_of({reinterpret_cast<const char*>(data), size});
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(gouge::scratch());
  gouge::run_words(words);
  std::filesystem::current_path(before);
  gouge::tidy_up(words);
  return 0;
}
