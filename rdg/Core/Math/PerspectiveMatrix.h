// Perspective matrices under their engine header. Source: engine Math/PerspectiveMatrix.h.
#pragma once

#include "Math/Matrix.h"
