#define GOUGE_KERNEL bounds_plain
#define GOUGE_KERNEL_NAME "plain"
#include "lib/penetration/bound_kernel_body.h"
