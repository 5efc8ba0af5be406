// UMaterialInstanceDynamic under its engine header. Source: engine file Materials/MaterialInstanceDynamic.h.
#pragma once

#include "Materials/MaterialInterface.h"
