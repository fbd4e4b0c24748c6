// Compiles the implementation of Wuffs.
#define WUFFS_IMPLEMENTATION
#include "image/wuffs.h"
