// Which type converts to which, how good that is, and which function of one name is called.
#pragma once

#include "HlslProgram.h"

namespace Drydock::Hlsl
{

/** How a value of one type becomes one of another. Smaller ranks are better: HLSL compares argument by argument.
 * Source: HLSL specification (working draft of microsoft/hlsl-specs), conversions and overload resolution; as DXC does
 * where it differs. */
struct FConversion
{
	bool bPossible = false;
	uint32_t Rank = 0;
	bool bTruncates = false; // a vector or matrix loses components: warning X3206
	bool bNarrows = false;   // a number may lose value
};

/** bExplicit: as a cast, which also goes between shapes of as many components, and from scalars to structs and arrays.
 */
DRYDOCK_API FConversion FindConversion(FTypes& Types, const FType* From, const FType* To, bool bExplicit = false);

/** The scalar in which both sides of an arithmetic operator meet; literals take the other's. */
EScalar MeetScalars(EScalar A, EScalar B);

/** The type in which both sides of an arithmetic or comparing operator meet: scalars are splat, of two vectors the
 * longer is cut (bTruncates). Null with Error where there is none ("float4 + float1x4"). */
DRYDOCK_API const FType* MeetTypes(FTypes& Types, const FType* A, const FType* B, bool& bTruncates, std::string& Error);

/** A parameter's type, in and out. */
struct FParameterType
{
	const FType* Type = nullptr;
	bool bIn = true;
	bool bOut = false;
	bool bDefault = false;
};

/** An argument: its type, and whether it can be written to. */
struct FArgumentType
{
	const FType* Type = nullptr;
	bool bPlace = false;
};

/** The best of the overloads; nothing where none fits. Ambiguous: those that are as good as the best, two or more. */
struct FOverloadChoice
{
	std::optional<size_t> Best;
	std::vector<size_t> Ambiguous;
	std::string Why; // none fits and there is one candidate: which argument does not, and why
};
DRYDOCK_API FOverloadChoice ChooseOverload(FTypes& Types, const std::vector<std::vector<FParameterType>>& Overloads,
	const std::vector<FArgumentType>& Arguments);

/** The value as one of type To: itself where it is that already, else a Convert, Compose, Cast or Zero around it
 * (through several where it takes so: float3x3 to int2x2). A constant stays one. Null where it cannot be. */
DRYDOCK_API FValue* MakeConversion(
	FProgram& Program, FTypes& Types, FValue* Value, const FType* To, bool bExplicit = false);

} // namespace Drydock::Hlsl
