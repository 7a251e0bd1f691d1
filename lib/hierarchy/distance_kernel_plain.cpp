#define GOUGE_KERNEL distance_plain
#define GOUGE_KERNEL_NAME "plain"
#include "lib/hierarchy/distance_kernel_body.h"
