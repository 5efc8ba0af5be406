// Registers the uniform buffer of the height fog.
#include "FogRendering.h"

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FFogUniformParameters, "FogStruct");
