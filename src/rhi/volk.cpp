// volk's function pointers and their loading, compiled here.
#define VOLK_IMPLEMENTATION
#include <volk.h>
