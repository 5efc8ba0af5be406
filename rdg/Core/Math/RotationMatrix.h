// Rotation matrices under their engine header. Source: engine Math/RotationMatrix.h.
#pragma once

#include "Math/Matrix.h"
