#define GOUGE_KERNEL kernel_avx512
#define GOUGE_KERNEL_NAME "avx512"
#include "lib/check/sweep_kernel_body.h"
