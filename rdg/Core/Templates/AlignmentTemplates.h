// Align and its siblings under their engine header. Source: engine Templates/AlignmentTemplates.h.
#pragma once

#include "Math/UnrealMathUtility.h"
