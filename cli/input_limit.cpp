#include "cli/input_limit.h"

#include <CLI/CLI.hpp>

#include "lib/base/byte_size.h"

namespace gouge {

void add_input_limit(CLI::App& command, InputLimit& limit) {
  command
      .add_option_function<std::string>(
          "--max-input",
          [&limit](const std::string& size) { limit.most_bytes = parse_byte_size(size).value_or(kMaxInputBytes); },
          "Most that a file or pipe may hold that is read (B, kB, MB, GB, TB, KiB, MiB, GiB, TiB)")
      ->type_name("SIZE")
      ->default_str("8GB")
      ->check([](const std::string& size) {
        return parse_byte_size(size) ? std::string() : "expected a size above 0 with a unit or in bytes, such as 8GB";
      });
}

}  // namespace gouge
