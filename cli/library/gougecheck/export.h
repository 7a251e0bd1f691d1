#pragma once

/// Marks the exported symbols of libgougecheck; all others are hidden.
#define GOUGECHECK_EXPORT __attribute__((visibility("default")))
