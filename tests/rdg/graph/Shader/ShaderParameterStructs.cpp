// The uniform buffers of the test structs. One macro has a semicolon and the other none: both are in use.
#include "ShaderParameterStructs.h"

IMPLEMENT_UNIFORM_BUFFER_STRUCT(FTestViewUniforms, "TestView");

IMPLEMENT_STATIC_UNIFORM_BUFFER_SLOT(TestScene)
IMPLEMENT_STATIC_UNIFORM_BUFFER_STRUCT(FTestSceneUniforms, "TestSceneStruct", TestScene)
