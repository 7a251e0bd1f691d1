#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "lib/base/file_search.h"
#include "lib/base/result.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Receives the name and the text of a file that was found, or the error if it cannot be read. The path may then not be
/// used: the control may run that file.
using FileReceiver = std::function<void(const std::string& file, const Result<std::string>& bytes)>;

/// Returns the set-up of a program with the programs beside its file (SearchRule::program_beside). Each search for one is
/// added to `searches`, which must outlive the set-up.
[[nodiscard]] std::shared_ptr<const ProgramSetup> with_files_beside(const std::shared_ptr<const ProgramSetup>& setup,
                                                                    const std::string& path_file,
                                                                    std::uint64_t max_bytes, SearchLog& searches,
                                                                    FileReceiver on_read);

}  // namespace gouge
