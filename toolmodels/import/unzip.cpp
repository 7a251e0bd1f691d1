#include "toolmodels/import/unzip.h"

#include <zip.h>

#include <array>
#include <memory>

namespace gouge {
namespace {

constexpr std::size_t kLargest = std::size_t{256} << 20;

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

using Archive = std::unique_ptr<zip_t, CloseArchive>;

Diagnostic zip_error(const std::string& file, const std::string& what) { return make_error("import-zip", what, file); }

Archive open_archive(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr && source != nullptr) zip_source_free(source);
  zip_error_fini(&error);
  return Archive(archive);
}

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06"); }

Result<std::string> unzip_first(const std::string& file, std::string_view bytes, std::string_view ending) {
  const Archive archive = open_archive(bytes);
  if (!archive) return zip_error(file, "this zip archive is damaged; expected a tool library in it");
  const zip_int64_t entries = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < entries; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const char* name = zip_get_name(archive.get(), index, ZIP_FL_ENC_RAW);
    if (name == nullptr || !std::string_view(name).ends_with(ending)) continue;
    const std::unique_ptr<zip_file_t, CloseFile> entry(zip_fopen_index(archive.get(), index, 0));
    if (!entry) return zip_error(file, "the library in this zip archive cannot be opened; it may be encrypted");
    std::string content;
    std::array<char, 65536> block{};
    zip_int64_t got = 0;
    while ((got = zip_fread(entry.get(), block.data(), block.size())) > 0) {
      content.append(block.data(), static_cast<std::size_t>(got));
      if (content.size() > kLargest)
        return zip_error(file, "the library in this zip archive is larger than 256 MB; expected a tool library");
    }
    if (got < 0) return zip_error(file, "the library in this zip archive is damaged");
    return content;
  }
  return zip_error(file, "this zip archive holds no file whose name ends in " + std::string(ending) +
                             "; expected a tool library in it");
}

}  // namespace gouge
