#define GOUGE_KERNEL bounds_avx512
#define GOUGE_KERNEL_NAME "avx512"
#include "lib/penetration/bound_kernel_body.h"
