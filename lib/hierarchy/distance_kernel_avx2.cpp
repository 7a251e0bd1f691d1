#define GOUGE_KERNEL distance_avx2
#define GOUGE_KERNEL_NAME "avx2"
#include "lib/hierarchy/distance_kernel_body.h"
