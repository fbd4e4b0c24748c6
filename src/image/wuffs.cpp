// Compiles Wuffs' code.
#define WUFFS_IMPLEMENTATION
#include "image/wuffs.h"
