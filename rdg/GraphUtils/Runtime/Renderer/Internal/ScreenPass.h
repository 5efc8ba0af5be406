// Forwards under the engine's whole path. Source: engine file ScreenPass.h.
#pragma once

#include <ScreenPass.h>
