#include "postproc/viewer/viewer_page.h"

#include "postproc/viewer/viewer_sources.h"

namespace gouge {

std::string viewer_page(const std::string& scene) {
  std::string page = "<style>\n";
  page += kViewerStyle;
  page += "</style>\n";
  page += kViewerMarkup;
  page += "<script type=\"text/plain\" id=\"desk-data\">";
  page += scene;
  // The table of findings is behind it in the page, and is asked for the first one.
  page += "</script>\n<script>\n\"use strict\";\ndocument.addEventListener(\"DOMContentLoaded\", () => {\n";
  page += kViewerScript;
  return page + "});\n</script>\n";
}

}  // namespace gouge
