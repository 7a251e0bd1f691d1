#define GOUGE_KERNEL kernel_avx2
#define GOUGE_KERNEL_NAME "avx2"
#include "lib/check/sweep_kernel_body.h"
