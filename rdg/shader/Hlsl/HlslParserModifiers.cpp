// Refuses words before a declaration that do not fit each other, or do not fit their place.
#include "HlslParserImpl.h"

#include <string>

namespace Drydock::Hlsl
{

/** A function of its own, because it opens the enumeration. */
namespace ParserModifiers
{

constexpr uint32_t InterpolationModifiers = ModifierLinear | ModifierCentroid | ModifierNoPerspective | ModifierSample;

constexpr uint32_t MakeModifierPlaces(std::initializer_list<EDeclared> Places)
{
	uint32_t Mask = 0;
	for (const EDeclared Place : Places)
	{
		Mask |= 1u << uint32_t(Place);
	}
	return Mask;
}

struct FModifierRow
{
	uint32_t Modifiers;
	uint32_t Refused; // bits of EDeclared
	const char* Word;
	const char* Number;
};

using enum EDeclared;

constexpr FModifierRow ModifierRows[] = {
	{ModifierIn | ModifierOut, MakeModifierPlaces({Global, Field, Local, Function, Method, Typedef}),
		"in, out and inout", "X3047"},
	{ModifierConst, MakeModifierPlaces({Field}), "const", "X3035"},
	{ModifierUniform, MakeModifierPlaces({Field, Local, Function, Method, Typedef}), "uniform", "X3047"},
	{ModifierGroupshared, MakeModifierPlaces({Field, Local, Function, Method, Typedef}), "groupshared", "X3010"},
	{ModifierExtern, MakeModifierPlaces({Field, Local, Function, Method, Typedef, Parameter}), "extern", "X3006"},
	{ModifierStatic, MakeModifierPlaces({Typedef, Parameter}), "static", "X3006"},
	{InterpolationModifiers | ModifierNoInterpolation, MakeModifierPlaces({Global, Local, Method, Typedef}),
		"words of interpolation", "X3047"},
	{ModifierVolatile, MakeModifierPlaces({Global, Field, Local, Function, Method, Typedef, Parameter}), "volatile",
		"X3008"},
};

struct FModifierPair
{
	uint32_t First;
	uint32_t Second;
	const char* Message;
};

constexpr FModifierPair ModifierPairs[] = {
	{ModifierRowMajor, ModifierColumnMajor, "X3048: matrix types cannot be both column_major and row_major"},
	{ModifierUnorm, ModifierSnorm, "X3085: a type cannot be both unorm and snorm"},
	{ModifierNoInterpolation, InterpolationModifiers,
		"X3048: nointerpolation cannot stand with linear, centroid, noperspective or sample"},
	{ModifierStatic, ModifierUniform,
		"X3007: static and uniform cannot stand together: a static variable is not a parameter"},
	{ModifierStatic, ModifierExtern, "X3007: static and extern cannot stand together"},
	{ModifierExtern, ModifierGroupshared, "X3010: extern and groupshared cannot stand together"},
};

constexpr const char* ModifierPlaceNames[] = {"a global variable", "a member of a struct", "a local variable",
	"a function", "a method", "a typedef", "a parameter"};

} // namespace ParserModifiers

void FParser::CheckModifiers(uint32_t Modifiers, EDeclared Declared, const FPlace& Place)
{
	if (Modifiers == 0)
	{
		return;
	}
	for (const ParserModifiers::FModifierPair& Pair : ParserModifiers::ModifierPairs)
	{
		if ((Modifiers & Pair.First) && (Modifiers & Pair.Second))
		{
			Fail(Place, Pair.Message);
		}
	}
	for (const ParserModifiers::FModifierRow& Row : ParserModifiers::ModifierRows)
	{
		if ((Modifiers & Row.Modifiers) && (Row.Refused >> uint32_t(Declared) & 1))
		{
			Fail(Place, std::string(Row.Number) + ": " + ParserModifiers::ModifierPlaceNames[size_t(Declared)] +
							" cannot be declared with " + Row.Word + "; leave it out");
		}
	}
}

} // namespace Drydock::Hlsl
