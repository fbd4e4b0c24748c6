#define WUFFS_IMPLEMENTATION
#include "image/wuffs.h"
