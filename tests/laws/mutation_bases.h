#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lib/path/toolpath.h"

// The files that the mutation law damages.

namespace gouge::laws {

struct MutationBase {
  std::string name, bytes, dialect;
  std::set<int> library_tools;  ///< without a cutter in the file
  bool is_tool_given = false;   ///< the file names none at all
};

/// tests/corpus/modal: every modal state that a dialect has, opened and closed, and wholly checked.
[[nodiscard]] std::vector<std::filesystem::path> modal_files();

/// The real files of ../shared/data that are text; empty where that folder is absent.
[[nodiscard]] std::vector<std::filesystem::path> real_files();

[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

/// Nothing where the product does not read it.
[[nodiscard]] std::optional<MutationBase> mutation_base(const std::string& name, const std::string& bytes);

/// Stretches of a file that represent themselves: what comes before its first position, some statements from
/// further down, and its last one.
[[nodiscard]] std::vector<std::string> segments(const std::string& bytes, std::size_t statements, std::size_t count);

/// Why the file must not be called clean, though the product checks every move; empty: it may be.
[[nodiscard]] std::string violation(const MutationBase& base, const Toolpath& path, const std::string& bytes);

[[nodiscard]] bool is_wholly_checked(const MutationBase& base, const Toolpath& path);

}  // namespace gouge::laws
