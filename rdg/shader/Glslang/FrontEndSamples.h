// Samples of textures in forms that glslang's HLSL front end lacks.
#pragma once

#include "FrontEndTree.h"

namespace Drydock
{

enum class ESampleForm
{
	Known, // to glslang, or a mistake that it explains
	Clamp, // its last argument is the least level
	Status // its last argument tells whether a tiled texture is there
};

/** "Sample": without glslang's prefix of methods. */
const char* GetMethodName(const TFunction& Function);

/** The form of a call of a texture's method; Known for all other functions. */
ESampleForm FindSampleForm(const TFunction& Function, const FNodes& Nodes);

/** The same function without its last parameter. */
TFunction* MakeWithoutLast(TFunction& Function);

/** Gives the sample that glslang made a clamp. False: there is none in it. */
bool AddClamp(const FBuilder& Build, TIntermTyped* Sample, TIntermTyped* Clamp);

} // namespace Drydock
