#include "tests/postproc/gcode/heidenhain/klartext.h"
