#include "cli/library/saved.h"

#include <gougecheck/version.h>

namespace gougecheck {

std::string pack(const char* kind, Fields fields) {
  fields["gougecheck"] = version();
  fields["kind"] = kind;
  std::string bytes;
  Fields::to_cbor(fields, bytes);
  return bytes;
}

void refuse_bytes(const char* kind) {
  raise(gouge::make_error("saved-bytes", "these bytes are no " + std::string(kind) + " of version " + version() +
                                             " of this library; make the object again from its files"));
}

Fields unpack(const char* kind, std::string_view bytes) {
  Fields fields = Fields::from_cbor(bytes.begin(), bytes.end(), true, false, Fields::cbor_tag_handler_t::error);
  const bool is_ours =
      fields.is_object() && fields.value("gougecheck", "") == version() && fields.value("kind", "") == kind;
  if (!is_ours) refuse_bytes(kind);
  return fields;
}

Fields packed_bytes(std::string_view bytes) {
  return Fields::binary(Fields::binary_t::container_type(bytes.begin(), bytes.end()));
}

std::string text_in(const Fields& field) {
  const Fields::binary_t& bytes = field.get_binary();
  return {bytes.begin(), bytes.end()};
}

Fields fields_of(const gouge::Diagnostics& diagnostics) {
  Fields all = Fields::array();
  for (const gouge::Diagnostic& d : diagnostics)
    all.push_back({static_cast<int>(d.severity), d.code, d.file, d.line, d.message});
  return all;
}

gouge::Diagnostics diagnostics_in(const Fields& fields) {
  gouge::Diagnostics all;
  for (const Fields& d : fields)
    all.push_back({static_cast<gouge::Severity>(d.at(0).get<int>()), d.at(1), d.at(2), d.at(3), d.at(4)});
  return all;
}

}  // namespace gougecheck
