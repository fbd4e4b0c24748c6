// HIMALAYA_API marks what the library exports.
#pragma once

#define HIMALAYA_API __attribute__((visibility("default")))
