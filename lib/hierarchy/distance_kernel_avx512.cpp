#define GOUGE_KERNEL distance_avx512
#define GOUGE_KERNEL_NAME "avx512"
#include "lib/hierarchy/distance_kernel_body.h"
