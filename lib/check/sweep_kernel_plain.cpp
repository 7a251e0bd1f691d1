#define GOUGE_KERNEL kernel_plain
#define GOUGE_KERNEL_NAME "plain"
#include "lib/check/sweep_kernel_body.h"
