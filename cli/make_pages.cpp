#include <filesystem>
#include <fstream>
#include <iostream>

#include "cli/pages/write_completion.h"
#include "cli/pages/write_man.h"
#include "cli/program.h"

// make_pages FOLDER writes the files that `cmake --install` adds: man1/*.1 and the completions of three shells.

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_pages FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const gouge::Program program;
  const gouge::CommandDoc doc = gouge::document(program.app);
  bool is_written = true;
  const auto write = [&](const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories((folder / file).parent_path());
    std::ofstream out(folder / file, std::ios::binary);
    out << text;
    out.close();
    is_written = is_written && out.good();
  };
  std::filesystem::remove_all(folder / "man1");
  for (const gouge::CommandDoc* command : gouge::flattened(doc))
    write("man1/" + gouge::man_name(*command) + ".1", gouge::write_man(*command));
  write("gougecheck", gouge::bash_completion(doc));
  write("_gougecheck", gouge::zsh_completion(doc));
  write("gougecheck.fish", gouge::fish_completion(doc));
  return is_written ? 0 : 1;
}
