// Translation matrices under their engine header. Source: engine Math/TranslationMatrix.h.
#pragma once

#include "Math/Matrix.h"
