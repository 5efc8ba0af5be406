// Scale matrices under their engine header. Source: engine Math/ScaleMatrix.h.
#pragma once

#include "Math/Matrix.h"
