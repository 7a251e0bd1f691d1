#define GOUGE_KERNEL bounds_avx2
#define GOUGE_KERNEL_NAME "avx2"
#include "lib/penetration/bound_kernel_body.h"
