// UE_VERSION_OLDER_THAN and UE_VERSION_NEWER_THAN_OR_EQUAL under their engine header.
// Source: engine Misc/EngineVersionComparison.h.
#pragma once

#include "Runtime/Launch/Resources/Version.h"
