// Local exposure has no pass yet: this name gives what its users include with it. Source: engine file
// PostProcess/PostProcessLocalExposure.h.
#pragma once

#include <PostProcessEyeAdaptation.h>
