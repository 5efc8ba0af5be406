// The functions of HLSL and the methods of its resources: which arguments they take, and what they give.
#pragma once

#include "HlslProgram.h"

namespace Drydock::Hlsl
{

/** The meaning of a call of an intrinsic or a method. */
struct FIntrinsicCall
{
	std::string_view Name; // of static storage; the emitter's key: a method's is "Sample", a function's "lerp"
	const FType* Result = nullptr;
	std::vector<const FType*> Parameters; // as many as there are arguments; the analysis converts to these
	std::vector<bool> bOut;               // arguments that are written: places of just this type
	std::string Error;                    // not empty: there is no such call; what was expected, in words
};

/** Whether HLSL has a function of this name. */
DRYDOCK_API bool IsIntrinsic(std::string_view Name);

/** Names like it, for "did you mean". */
DRYDOCK_API std::vector<std::string> ListIntrinsics();

/** The overload for these arguments by HLSL's rules: the shape is that of the largest argument where a function goes by
 * components (scalars are splat, longer ones are cut with a warning), the scalar the one that all meet in, literals as
 * what stands beside them; functions of reals make floats of integers. Template arguments: of `Load<T>`, types. */
DRYDOCK_API FIntrinsicCall FindIntrinsicCall(
	FTypes& Types, std::string_view Name, const std::vector<const FType*>& Arguments);

/** The same for a method of an object type, with the types between its < and >. Vectors of positions and offsets have
 * the size that the resource has dimensions. */
DRYDOCK_API FIntrinsicCall FindMethodCall(FTypes& Types, const FType* Object, std::string_view Name,
	const std::vector<const FType*>& TemplateArguments, const std::vector<const FType*>& Arguments);

/** Its methods, for "did you mean". */
DRYDOCK_API std::vector<std::string> ListMethods(const FType* Object);

/** The number of components of a position in the resource: 2 for a Texture2D (its index), 1 for a buffer. */
DRYDOCK_API uint32_t GetDimensions(EObject Object);

/** Whether the call may run at compile time with constants alone (not: waves, atomics, derivatives, clip). */
DRYDOCK_API bool IsPure(std::string_view Name);

} // namespace Drydock::Hlsl
