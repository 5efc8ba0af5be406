// UMaterial under its engine header. Source: engine file Materials/Material.h.
#pragma once

#include "Materials/MaterialInterface.h"
