// The whole library: load or build a scene, render it, use the picture. docs/library.md shows how.
#pragma once

#include <himalaya/error.h>
#include <himalaya/picture.h>
#include <himalaya/render.h>
#include <himalaya/scene.h>
#include <himalaya/settings.h>
#include <himalaya/version.h>
