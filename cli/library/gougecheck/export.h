#pragma once

/// What libgougecheck exports; everything else in it is hidden.
#define GOUGECHECK_EXPORT __attribute__((visibility("default")))
