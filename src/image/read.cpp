#include "image/read.h"
