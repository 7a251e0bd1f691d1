#pragma once

#include <string>
#include <utility>

#include "samples/cl_text.h"
#include "samples/sample.h"

// Parts of small samples.

namespace gouge::samples {

/// A case without bodies, toolpath and findings.
inline Sample small_case(std::string name, std::string about, std::string tools, int check_exit) {
  Sample sample;
  sample.about = std::move(about);
  sample.toolpath_file = name + ".apt";
  sample.name = std::move(name);
  sample.tools = std::move(tools);
  sample.check_exit = check_exit;
  return sample;
}

/// The head of its toolpath: multi-axis, in mm, tool 1.
inline ClText start_text(const Sample& sample) {
  ClText cl(ClText::Form::apt);
  cl.line("PARTNO/" + sample.name);
  cl.line("UNITS/MM");
  cl.line("MULTAX/ON");
  cl.line("LOADTL/1");
  cl.line("FEDRAT/1000.0000, MMPM");
  return cl;
}

/// Ends the toolpath and puts it into the sample.
inline void finish_sweep(Sample& sample, ClText& cl) {
  cl.line("FINI");
  sample.toolpath = cl.text();
  sample.moves = cl.positions();
}

}  // namespace gouge::samples
