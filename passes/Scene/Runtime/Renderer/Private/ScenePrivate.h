// Forwards under the engine's whole path. Source: engine file ScenePrivate.h.
#pragma once

#include <ScenePrivate.h>
