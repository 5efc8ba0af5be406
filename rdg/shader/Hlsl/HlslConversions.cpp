// Judges which type converts to which and how good that is, and writes conversions out. Sources: HLSL's specification
// (working draft of microsoft/hlsl-specs, chapters Conversions and Overloading) and public tests of DXC between shapes;
// the order of scalars in overloads as it was measured of D3D's compilers.
#include "HlslConversions.h"

#include "HlslConstants.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace Drydock::Hlsl
{

namespace
{

/** How the shape of a numeric value changes. */
enum class EReshape : uint8_t
{
	None, // it cannot be
	Same,
	Regroup, // as many components in another shape
	Splat,
	Cut,
};

EReshape FindReshape(const FType* From, const FType* To)
{
	const uint32_t Given = From->NumComponents();
	const uint32_t Wanted = To->NumComponents();
	if (From->Shape == To->Shape && From->Rows == To->Rows && From->Columns == To->Columns)
	{
		return EReshape::Same;
	}
	if (Given == 1 || Wanted == 1)
	{
		return Given == Wanted ? EReshape::Regroup : Given == 1 ? EReshape::Splat : EReshape::Cut;
	}
	if (From->IsMatrix() && To->IsMatrix())
	{
		return To->Rows <= From->Rows && To->Columns <= From->Columns ? EReshape::Cut : EReshape::None;
	}
	if (From->IsMatrix() != To->IsMatrix() && Given == Wanted)
	{
		return EReshape::Regroup;
	}
	// Vectors, and matrices that are one.
	const auto IsLine = [](const FType* Type)
	{
		return Type->Rows == 1 || Type->Columns == 1;
	};
	return IsLine(From) && IsLine(To) && Wanted < Given ? EReshape::Cut : EReshape::None;
}

/** How good a scalar is as another one: 0 itself, 1 a literal as its own kind, 2 a promotion (of an integer also its
 * other sign), 3 an integer as bool, 4 any other, 5 an integer as something small. */
uint32_t RankScalar(EScalar From, EScalar To)
{
	const bool bSmall = To < EScalar::Int && To != EScalar::Bool;
	if (From == To)
	{
		return 0;
	}
	if (From == EScalar::LiteralInt)
	{
		return To == EScalar::Int || To == EScalar::Uint ? 1 : IsInteger(To) ? 2 : To == EScalar::Bool ? 3 : 4;
	}
	if (From == EScalar::LiteralFloat)
	{
		return To == EScalar::Float || To == EScalar::Double ? 1 : IsReal(To) ? 2 : 4;
	}
	if (From == EScalar::Bool || !IsReal(From))
	{
		const bool bPromotes = IsInteger(From) && IsInteger(To) && (To >= EScalar::Int || From < EScalar::Int) &&
							   !(From >= EScalar::Long && To < EScalar::Long);
		return bPromotes                                                  ? 2
			   : To == EScalar::Bool                                      ? 3
			   : bSmall || To == EScalar::MinFloat || To == EScalar::Half ? 5
																		  : 4;
	}
	return IsReal(To) && To > From ? 2 : 4;
}

/** Whether a number may lose value (X3205). */
bool NarrowsScalar(EScalar From, EScalar To)
{
	const auto GetWidth = [](EScalar Scalar)
	{
		return Scalar == EScalar::Double || Scalar == EScalar::Long || Scalar == EScalar::Ulong ? 3
			   : Scalar == EScalar::Float || Scalar == EScalar::Int || Scalar == EScalar::Uint  ? 2
																								: 1;
	};
	if (From == EScalar::Bool || To == EScalar::Bool || From == EScalar::LiteralInt || IsLiteral(To))
	{
		return false;
	}
	if (From == EScalar::LiteralFloat)
	{
		return !IsReal(To);
	}
	return IsReal(From) != IsReal(To) ? IsReal(From) : GetWidth(To) < GetWidth(From);
}

// Ranks: what happens to the scalar counts more than a splat, and less than a cut.
constexpr uint32_t ConversionScalarStep = 4;
constexpr uint32_t ConversionSplat = 2;
constexpr uint32_t ConversionRegroup = 1;
constexpr uint32_t ConversionCut = 64;
constexpr uint32_t ConversionExplicit = 128;

FConversion FindNumericConversion(const FType* From, const FType* To)
{
	FConversion Result;
	const EReshape Reshape = FindReshape(From, To);
	Result.bPossible = Reshape != EReshape::None;
	Result.bTruncates = Reshape == EReshape::Cut;
	Result.bNarrows = NarrowsScalar(From->Scalar, To->Scalar);
	Result.Rank = ConversionScalarStep * (RankScalar(From->Scalar, To->Scalar) + (From->IsEnum() ? 1 : 0));
	Result.Rank += Reshape == EReshape::Splat     ? ConversionSplat
				   : Reshape == EReshape::Regroup ? ConversionRegroup
				   : Reshape == EReshape::Cut     ? ConversionCut
												  : 0;
	return Result;
}

/** How many derivations up a base is; 0: it is none. */
uint32_t FindBase(const FType* Derived, const FType* Base)
{
	std::vector<std::pair<const FType*, uint32_t>> Classes = {{Derived, 0}}; // each once
	for (size_t i = 0; i < Classes.size(); ++i)
	{
		const auto [Class, Steps] = Classes[i];
		if (Steps != 0 && IsSame(Class, Base))
		{
			return Steps;
		}
		for (const FType* const Direct : Class->Struct->Bases)
		{
			const bool bSeen = std::any_of(
				Classes.begin(), Classes.end(), [Direct](const auto& Known) { return Known.first == Direct; });
			if (!bSeen && Direct->IsStruct())
			{
				Classes.emplace_back(Direct, Steps + 1);
			}
		}
	}
	return 0;
}

/** By their scalars: a struct, an array or a numeric value as another one. */
FConversion FindFlatConversion(const FType* From, const FType* To)
{
	const auto IsFlat = [](const FType* Type)
	{
		return (Type->IsNumeric() || Type->IsArray() || Type->IsStruct()) && !HasObject(Type);
	};
	FConversion Result;
	const uint32_t Given = CountScalars(From);
	const uint32_t Wanted = CountScalars(To);
	const bool bSplat = From->IsNumeric() && Given == 1;
	Result.bPossible = IsFlat(From) && IsFlat(To) && (From->IsNumeric() ? !To->IsNumeric() : true) && Wanted > 0 &&
					   (bSplat || Given >= Wanted);
	Result.bTruncates = Given > Wanted;
	Result.Rank = ConversionExplicit;
	return Result;
}

} // namespace

FConversion FindConversion(FTypes& Types, const FType* From, const FType* To, bool bExplicit)
{
	(void)Types;
	const FConversion Perfect{true, 0, false, false};
	if (From->Kind == EType::Error || To->Kind == EType::Error)
	{
		return Perfect;
	}
	if (From->Kind == EType::Void || To->Kind == EType::Void)
	{
		return {};
	}
	if (IsSame(From, To))
	{
		return Perfect;
	}
	if (From->IsNumeric() && To->IsNumeric())
	{
		const bool bOnlyExplicit = To->IsEnum() || From->bScoped;
		return bOnlyExplicit && !bExplicit ? FConversion() : FindNumericConversion(From, To);
	}
	if (From->IsStruct() && To->IsStruct())
	{
		if (const uint32_t Steps = FindBase(From, To))
		{
			return {true, ConversionScalarStep + std::min(Steps, ConversionCut / 2), false, false};
		}
	}
	return bExplicit ? FindFlatConversion(From, To) : FConversion();
}

EScalar MeetScalars(EScalar A, EScalar B)
{
	if (A == EScalar::Bool || B == EScalar::Bool)
	{
		const EScalar Other = A == EScalar::Bool ? B : A;
		return Other == EScalar::Bool || Other == EScalar::LiteralInt ? EScalar::Int : Other;
	}
	if (IsLiteral(A) && IsLiteral(B))
	{
		return std::max(A, B); // 1 + 1.0 is a literal float
	}
	if (IsLiteral(A) || IsLiteral(B))
	{
		const EScalar Literal = IsLiteral(A) ? A : B;
		const EScalar Other = IsLiteral(A) ? B : A;
		return Literal == EScalar::LiteralFloat && !IsReal(Other) ? EScalar::Float : Other;
	}
	if (IsReal(A) || IsReal(B))
	{
		return std::max(A, B); // reals stand behind integers, in the order of their size
	}
	// The larger one, without a sign where one has none.
	const EScalar Larger = std::max(A, B);
	const bool bSigned = (uint32_t(Larger) - uint32_t(EScalar::MinInt)) % 2 == 0;
	return bSigned && (IsUnsigned(A) || IsUnsigned(B)) ? EScalar(uint32_t(Larger) + 1) : Larger;
}

const FType* MeetTypes(FTypes& Types, const FType* A, const FType* B, bool& bTruncates, std::string& Error)
{
	bTruncates = false;
	if (A->Kind == EType::Error || B->Kind == EType::Error)
	{
		return Types.Error();
	}
	const bool bSameScoped = A->bScoped && B->bScoped && IsSame(A, B);
	if (!A->IsNumeric() || !B->IsNumeric() || ((A->bScoped || B->bScoped) && !bSameScoped))
	{
		const FType* const Wrong = A->IsNumeric() && !A->bScoped ? B : A;
		Error = "X3020: a number, vector or matrix is expected beside the operator, not " + GetName(Wrong) +
				(Wrong->bScoped                             ? "; cast it: int(...)"
					: Wrong->IsArray() || Wrong->IsStruct() ? "; name one of its members or elements"
															: "");
		return nullptr;
	}
	const EScalar Scalar = MeetScalars(A->Scalar, B->Scalar);
	const EReshape Down = FindReshape(A, B); // A in B's shape
	const EReshape Up = FindReshape(B, A);
	if (Down == EReshape::Same || Up == EReshape::Splat)
	{
		return Types.WithScalar(A, Scalar);
	}
	if (Down == EReshape::Splat)
	{
		return Types.WithScalar(B, Scalar);
	}
	if (Down == EReshape::Regroup)
	{
		return Types.WithScalar(B->IsScalar() ? B : A, Scalar); // a scalar and a vector of one are a scalar
	}
	if (Down == EReshape::Cut || Up == EReshape::Cut)
	{
		bTruncates = true;
		return Types.WithScalar(Down == EReshape::Cut ? B : A, Scalar);
	}
	Error =
		"X3020: type mismatch: " + GetName(A) + " and " + GetName(B) +
		" have no shape in common; for a product of matrices write mul(...), else name the components that are meant";
	return nullptr;
}

namespace
{

/** Makes the steps of a conversion. */
class FConverter
{
public:
	FConverter(FProgram& InProgram, FTypes& InTypes)
		: Program(InProgram)
		, Types(InTypes)
	{
	}

	FValue* ConvertNumeric(FValue* Value, const FType* To)
	{
		const FType* const From = Value->Type;
		const EReshape Reshape = FindReshape(From, To);
		if (Reshape == EReshape::Splat || (From->NumComponents() == 1 && !From->IsScalar()))
		{
			// By way of a scalar, which is the cheapest to convert.
			Value = Make(EValue::Convert, Value, Types.Scalar(From->Scalar));
			Value = Make(EValue::Convert, Value, Types.Scalar(To->Scalar));
			return Enclose(Make(EValue::Convert, Value, Types.WithScalar(To, To->Scalar)), To);
		}
		if (Reshape == EReshape::Cut)
		{
			Value = Cut(Value, To);
		}
		Value = Make(EValue::Convert, Value, Types.WithScalar(Value->Type, To->Scalar));
		const bool bLine = Value->Type->Rows == 1 || Value->Type->Columns == 1;
		const bool bToLine = To->Rows == 1 || To->Columns == 1;
		const bool bConvert = FindReshape(Value->Type, To) != EReshape::Regroup || (bLine && bToLine);
		Value = Make(bConvert ? EValue::Convert : EValue::Compose, Value, Types.WithScalar(To, To->Scalar));
		return Enclose(Value, To);
	}

	/** Value itself where it has the type already. */
	FValue* Make(EValue Kind, FValue* Value, const FType* To)
	{
		if (IsSame(Value->Type, To))
		{
			return Value;
		}
		FValue* const Result = Program.Make<FValue>();
		Result->Kind = Kind;
		Result->Type = To;
		Result->Place = Value->Place;
		Result->bPrecise = Value->bPrecise;
		Result->Operands.push_back(Value);
		return Result;
	}

private:
	/** To as many components as To has; of a line, as a vector. */
	FValue* Cut(FValue* Value, const FType* To)
	{
		const FType* const From = Value->Type;
		if (From->IsMatrix() && To->IsMatrix())
		{
			return Make(EValue::Convert, Value, Types.Matrix(From->Scalar, To->Rows, To->Columns, From->Order));
		}
		const uint32_t Count = To->NumComponents();
		if (From->IsMatrix() && Count > 1)
		{
			Value = Make(EValue::Convert, Value, Types.Vector(From->Scalar, From->NumComponents()));
		}
		return Make(
			EValue::Convert, Value, Count == 1 ? Types.Scalar(From->Scalar) : Types.Vector(From->Scalar, Count));
	}

	/** A number as an enumeration. */
	FValue* Enclose(FValue* Value, const FType* To) { return Make(EValue::Convert, Value, To); }

	FProgram& Program;
	FTypes& Types;
};

/** The same constant in one node. */
FValue* FoldConversion(FProgram& Program, FTypes& Types, FValue* Made, const FValue* From)
{
	if (Made == From || From->Kind != EValue::Constant)
	{
		return Made;
	}
	const std::optional<FConstant> Constant = Fold(Types, *Made);
	if (!Constant)
	{
		return Made;
	}
	FValue* const Result = Program.Make<FValue>();
	Result->Kind = EValue::Constant;
	Result->Type = Made->Type;
	Result->Place = Made->Place;
	Result->Constant = *Constant;
	return Result;
}

} // namespace

FValue* MakeConversion(FProgram& Program, FTypes& Types, FValue* Value, const FType* To, bool bExplicit)
{
	if (Value->Type->Kind == EType::Error || To->Kind == EType::Error || IsSame(Value->Type, To))
	{
		return Value;
	}
	if (!FindConversion(Types, Value->Type, To, bExplicit).bPossible)
	{
		return nullptr;
	}
	FConverter Converter(Program, Types);
	if (Value->Type->IsNumeric() && To->IsNumeric())
	{
		return FoldConversion(Program, Types, Converter.ConvertNumeric(Value, To), Value);
	}
	const bool bZero = Value->Kind == EValue::Constant && Value->Type->IsScalar() && Value->Constant.size() == 1 &&
					   Value->Constant[0] == 0;
	FValue* const Cast = Converter.Make(bZero ? EValue::Zero : EValue::Cast, Value, To);
	if (bZero)
	{
		Cast->Operands.clear();
		return Cast;
	}
	return FoldConversion(Program, Types, Cast, Value);
}

} // namespace Drydock::Hlsl
