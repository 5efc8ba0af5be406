// Inverse rotation matrices under their engine header. Source: engine Math/InverseRotationMatrix.h.
#pragma once

#include "Math/Matrix.h"
