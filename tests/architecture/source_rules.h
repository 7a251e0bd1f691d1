#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_text.h"

// The rules of the house as functions: files in, complaints out ("path:line: what is wrong"); no complaints,
// no violation. docs/develop/layout.md states the rules in prose.

namespace gouge::architecture {

using Complaints = std::vector<std::string>;

/// Adds a complaint about a line of a file.
void complain(Complaints& complaints, const SourceFile& file, std::size_t line, const std::string& what);

/// Rooms import one way: no circles; lib imports only lib; toolmodels and postproc do not know each other;
/// nobody imports cli or samples, but what lies in folders of cli is for cli; every import is a module.
[[nodiscard]] Complaints check_modules(const std::vector<Module>& modules);

/// Every quoted #include of a file in a module names a file of that module or of one it imports.
[[nodiscard]] Complaints check_includes(const std::vector<SourceFile>& files, const std::vector<Module>& modules);

/// A header that its module keeps closed is included by that module, by those it names, and by their tests alone. The
/// benchmarks, which time single parts, may.
[[nodiscard]] Complaints check_closed_headers(const std::vector<SourceFile>& files, const std::vector<Module>& modules);

/// CGAL stays in two sources of lib/validate (its intervals in lib/verify/bounds.h), OpenCV in one source of postproc/image.
[[nodiscard]] Complaints check_heavy_libraries(const std::vector<SourceFile>& files);

/// Below cli: no printing, no ending of the program, no throwing, no number functions that depend on locale
/// or libm.
[[nodiscard]] Complaints check_banned_words(const std::vector<SourceFile>& files);

/// Tests draw random numbers from tests/support/scatter.h alone: what a standard library draws is not what another
/// does.
[[nodiscard]] Complaints check_random_numbers(const std::vector<SourceFile>& files);

/// Tests make their files in folders of tests/support/temporary_folder.h alone: tests run beside each other. Benchmarks and
/// fuzz targets, which run alone, may use others.
[[nodiscard]] Complaints check_temporary_folders(const std::vector<SourceFile>& files);

/// Only lib/motion makes motions from poses. Only the contact table names both kinds of obstacles. lib/verify shares
/// nothing with the check and is left out.
[[nodiscard]] Complaints check_seams(const std::vector<SourceFile>& files);
/// Formats of toolpath files (binary, pairs of lines) are known to their own folder and to the table of formats.
[[nodiscard]] Complaints check_formats(const std::vector<SourceFile>& files);

/// Tolerances have their names and derivations in lib/base/tolerance.h; other small numbers are named constants. Free are
/// single precision, tests, and lib/verify, which shares nothing with the check.
[[nodiscard]] Complaints check_tolerances(const std::vector<SourceFile>& files);

/// Readers of inputs look for files by lib/base/file_search.h alone, which notes every search: a stored result depends on
/// a file that is absent too. Other files that examine folders state their reason in the list of this rule.
[[nodiscard]] Complaints check_file_searches(const std::vector<SourceFile>& files);

/// Headers begin with #pragma once; no file is longer than 500 lines; the median is at most 150.
[[nodiscard]] Complaints check_shape(const std::vector<SourceFile>& files);

/// No two headers of the product define a type of the same name in namespace gouge: linked together, one would be
/// destroyed as the other.
[[nodiscard]] Complaints check_type_names(const std::vector<SourceFile>& files);

/// No notes to self, and no paths of the machine the project was written on.
[[nodiscard]] Complaints check_stray_text(const std::vector<SourceFile>& files);

}  // namespace gouge::architecture
