#pragma once

#include <gougecheck/export.h>

#define GOUGECHECK_VERSION_MAJOR 1
#define GOUGECHECK_VERSION_MINOR 0
#define GOUGECHECK_VERSION_PATCH 0
#define GOUGECHECK_VERSION_STRING "1.0.0"

namespace gougecheck {

/// Returns the version of the library that runs; the macros are those of the headers. Headers and library are compatible
/// if major and minor number are equal.
[[nodiscard]] GOUGECHECK_EXPORT const char* version();

}  // namespace gougecheck
