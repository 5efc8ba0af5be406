// Calls of what HLSL itself has: intrinsics, methods of resources, constructors.
#include "HlslAnalysisImpl.h"

#include <algorithm>
#include <array>

namespace Drydock::Hlsl
{

namespace
{

template<size_t N>
bool IsOneOf(std::string_view Name, const std::array<std::string_view, N>& Names)
{
	return std::ranges::find(Names, Name) != Names.end();
}

constexpr std::array<std::string_view, 7> Derivatives = {
	"ddx", "ddy", "ddx_coarse", "ddy_coarse", "ddx_fine", "ddy_fine", "fwidth"};
constexpr std::array<std::string_view, 5> GroupBarriers = {"GroupMemoryBarrier", "GroupMemoryBarrierWithGroupSync",
	"AllMemoryBarrier", "AllMemoryBarrierWithGroupSync", "DeviceMemoryBarrierWithGroupSync"};
constexpr std::array<std::string_view, 5> ImplicitLevels = {
	"Sample", "SampleBias", "SampleCmp", "CalculateLevelOfDetail", "CalculateLevelOfDetailUnclamped"};

} // namespace

/** Calls that a stage does not have. */
bool FAnalyser::CheckStage(std::string_view Name, bool bMethod, const FPlace& Place)
{
	const std::string Quoted = (bMethod ? "." : "") + std::string(Name);
	const std::string Stage = Options.Stage == EStage::Compute  ? "a compute shader"
							  : Options.Stage == EStage::Vertex ? "a vertex shader"
																: "a pixel shader";
	if (Options.Stage != EStage::Pixel && bMethod && IsOneOf(Name, ImplicitLevels))
	{
		const std::string Instead = Name == "SampleCmp"          ? "SampleCmpLevelZero(Sampler, UV, Value)"
									: Name.starts_with("Sample") ? "SampleLevel(Sampler, UV, 0)"
																 : "";
		Error(Place, "X4532: " + Quoted + " in " + Stage +
						 " is an error: only pixel shaders have the derivatives that choose the mip" +
						 (Instead.empty() ? "" : "; write " + Instead));
		return false;
	}
	if (Options.Stage != EStage::Pixel && !bMethod && (IsOneOf(Name, Derivatives) || Name == "clip"))
	{
		Error(Place,
			"X4532: " + Quoted + " in " + Stage + " is an error: only pixel shaders have " +
				(Name == "clip" ? "pixels to discard; write return"
								: "neighbours to take a difference from; compute the step from the size of a texel"));
		return false;
	}
	if (Options.Stage != EStage::Compute && !bMethod && IsOneOf(Name, GroupBarriers))
	{
		Error(Place, "X4532: " + Quoted + " in " + Stage + " is an error: only compute shaders have groups of threads" +
						 (Options.Stage == EStage::Pixel ? "; write DeviceMemoryBarrier()" : ""));
		return false;
	}
	return true;
}

FValue* FAnalyser::CallIntrinsic(std::string_view Name, FArguments& Arguments, const FPlace& Place)
{
	std::vector<const FType*> Given;
	for (FValue*& Each : Arguments.Values)
	{
		if (!Each)
		{
			return Fail(Place, "X3000: '" + std::string(Name) + "' takes no list in braces; write float4(...)");
		}
		Each = ToPlain(OpenConstantBuffer(Each));
		const bool bAtomic =
			Name.starts_with("Interlocked") && Given.empty() && Name != "InterlockedMin" && Name != "InterlockedMax";
		FValue* const Target = bAtomic ? Uncast(Each) : Each; // `(uint)X` of an int
		const bool bSign = Target != Each && IsInteger(Target->Type->Scalar) &&
						   Types->GetBits(Target->Type->Scalar) == Types->GetBits(Each->Type->Scalar);
		Each = bSign ? Target : Each;
		Given.push_back(Each->Type);
	}
	const bool bWhole = Name == "select" && Given.size() == 3 && (Given[1]->IsStruct() || Given[1]->IsArray());
	if (bWhole && IsSame(Given[1], Given[2]))
	{
		return SelectWhole(Arguments.Values, Place);
	}
	const FIntrinsicCall Call = FindIntrinsicCall(*Types, Name, Given);
	if (!Call.Error.empty())
	{
		return Fail(Place, Call.Error);
	}
	return CheckStage(Name, false, Place)
			   ? FinishBuiltIn(EValue::Intrinsic, Call, Arguments.Values, nullptr, Name, Place)
			   : MakeError(Place);
}

/** select() of structs and arrays: both are computed, and one is taken. */
FValue* FAnalyser::SelectWhole(const std::vector<FValue*>& Values, const FPlace& Place)
{
	FValue* const Condition = MakeCondition(Values[0], "select of structs", "choose its members one by one");
	if (IsError(Condition))
	{
		return Condition;
	}
	std::vector<FValue*> Before;
	FValue* const First = MakeOnce(Values[1], Before);
	FValue* const Second = MakeOnce(Values[2], Before);
	Before.push_back(Make(EValue::Choose, First->Type, Place, {Condition, First, Second}));
	return MakeCommas(std::move(Before));
}

FValue* FAnalyser::CallResource(const FExpression& Tree, FValue* Object)
{
	const FExpression& Member = *Tree.Operands[0];
	const FNamePart& Part = Member.Name.Parts.back();
	FArguments Arguments = AnalyseArguments(Tree, 1);
	std::vector<const FType*> TemplateTypes;
	for (const FTemplateArgument& Argument : Part.Arguments)
	{
		FTemplateParameter Any;
		Any.Place = Part.Place;
		const std::optional<FTemplateValue> Value = ReadArgument(Argument, Any);
		if (!Value)
		{
			return MakeError(Member.Place);
		}
		TemplateTypes.push_back(Value->Type);
	}
	if (Arguments.bBad)
	{
		return MakeError(Member.Place);
	}
	std::vector<const FType*> Given;
	for (FValue*& Each : Arguments.Values)
	{
		if (!Each)
		{
			return Fail(
				Member.Place, "X3000: '" + std::string(Part.Text) + "' takes no list in braces; write float4(...)");
		}
		const bool bElement = Object->Type->Element && IsSame(Each->Type, Object->Type->Element);
		Each = bElement ? Each : ToPlain(OpenConstantBuffer(Each));
		Given.push_back(Each->Type);
	}
	const FIntrinsicCall Call = FindMethodCall(*Types, Object->Type, Part.Text, TemplateTypes, Given);
	if (!Call.Error.empty())
	{
		return Fail(Member.Place, Call.Error);
	}
	if (!CheckStage(Part.Text, true, Member.Place))
	{
		return MakeError(Member.Place);
	}
	if (Part.Text.starts_with("Sample") && Object->Type->Element && !IsReal(Object->Type->Element->Scalar))
	{
		return Fail(Member.Place, "X4582: cannot sample from non-floating point texture formats: '" +
									  GetName(Object->Type) + "'; write Load(int3(Position, 0))");
	}
	if (IsWritable(Object->Type->Object))
	{
		MarkWritten(Object);
	}
	return FinishBuiltIn(EValue::Method, Call, Arguments.Values, Object, Part.Text, Member.Place);
}

/** Offsets of samples and loads go from -8 to 7. Those of gathers may be more, and what is not constant is not judged.
 */
bool FAnalyser::CheckOffset(const FIntrinsicCall& Call, const std::vector<FValue*>& Values, FValue* Object)
{
	const EObject Kind = Object->Type->Object;
	const bool bOffset =
		IsTexture(Kind) && !IsWritable(Kind) && (Call.Name.starts_with("Sample") || Call.Name.starts_with("Load"));
	for (size_t i = 1; i < Values.size() && bOffset; ++i)
	{
		const FType* const Type = Call.Parameters[i];
		if (!Type->IsNumeric() || Type->Scalar != EScalar::Int || Call.bOut[i] || !IsKnown(*Values[i]))
		{
			continue;
		}
		const std::optional<FConstant> Constant = Fold(*Types, *Values[i]);
		for (const uint64_t Bits : Constant.value_or(FConstant()))
		{
			const int32_t Number = int32_t(uint32_t(Bits));
			if (Number < -8 || Number > 7)
			{
				Error(Values[i]->Place, "X4577: offsets of " + std::string(Call.Name) + " go from -8 to 7, not " +
											std::to_string(Number) + "; add it to the position instead");
				return false;
			}
		}
	}
	return true;
}

FValue* FAnalyser::FinishBuiltIn(EValue Kind, const FIntrinsicCall& Call, std::vector<FValue*> Values, FValue* Object,
	std::string_view Name, const FPlace& Place)
{
	std::vector<FValue*> After; // what is written through a variable of the function's own type
	for (size_t i = 0; i < Values.size(); ++i)
	{
		const FType* const Type = Call.Parameters[i];
		if (!Call.bOut[i])
		{
			Values[i] = Convert(Values[i], Type);
			if (IsError(Values[i]))
			{
				return MakeError(Place);
			}
			continue;
		}
		if (!RequirePlace(Values[i], "argument " + std::to_string(i + 1) + " of '" + std::string(Name) + "'"))
		{
			return MakeError(Place);
		}
		if (IsSame(Values[i]->Type, Type))
		{
			continue;
		}
		const bool bAtomic = Name.starts_with("Interlocked") && i == 0 && !Object;
		if (bAtomic || !FindConversion(*Types, Type, Values[i]->Type).bPossible)
		{
			return Fail(Values[i]->Place, "X3013: argument " + std::to_string(i + 1) + " of '" + std::string(Name) +
											  "' is '" + GetName(Type) + "', not '" + GetName(Values[i]->Type) + "'");
		}
		FVariable* const Temporary = MakeTemporary(Type, Place);
		FValue* const Result = Convert(MakeVariable(*Temporary, Place), Values[i]->Type);
		After.push_back(Make(EValue::Assign, Values[i]->Type, Place, {Values[i], Result}));
		Values[i] = MakeVariable(*Temporary, Place);
	}
	if (Object && !CheckOffset(Call, Values, Object))
	{
		return MakeError(Place);
	}
	if (Object)
	{
		Values.insert(Values.begin(), Object);
	}
	FValue* const Value = Make(Kind, Call.Result, Place, std::move(Values));
	Value->Name = Call.Name;
	return !After.empty() ? MakeSequence({}, Value, After) : Kind == EValue::Intrinsic ? Simplify(Value) : Value;
}

/** float4(A, B): as many numbers as the type has. Anything else with one argument is a cast. */
FValue* FAnalyser::MakeConstructor(const FType* Type, FArguments& Arguments, const FPlace& Place)
{
	const bool bList = std::ranges::any_of(Arguments.Values, [](const FValue* Each) { return !Each; });
	if (Type->Kind == EType::Error || Arguments.bBad)
	{
		return MakeError(Place);
	}
	if (bList)
	{
		return Fail(
			Place, "X3000: a constructor takes no list in braces; write " + GetName(Type) + "(...) without them");
	}
	const size_t Count = Arguments.Values.size();
	if (!Type->IsNumeric() || (Type->IsScalar() && Count == 1))
	{
		return Count == 1 ? Convert(Arguments.Values[0], Type, true)
						  : Fail(Place, "X3037: constructors only defined for numeric base types; write " +
											GetName(Type) + " X = { ... }");
	}
	uint32_t Given = 0;
	std::vector<FValue*> Parts;
	for (FValue* Each : Arguments.Values)
	{
		Each = OpenConstantBuffer(Each);
		if ((Each->Type->IsStruct() || Each->Type->IsArray()) && !HasObject(Each->Type))
		{
			return MakeFlat(Type, Arguments.Values, Place);
		}
		if (!Each->Type->IsNumeric() || Each->Type->bScoped)
		{
			return Fail(
				Each->Place, "X3037: '" + GetName(Type) + "' is made of numbers, not of '" + GetName(Each->Type) + "'");
		}
		Given += Each->Type->NumComponents();
		FValue* const Part = Convert(Each, Types->WithScalar(Each->Type, Type->Scalar), true);
		if (IsError(Part))
		{
			return MakeError(Place);
		}
		Parts.push_back(Part);
	}
	if (Given != Type->NumComponents())
	{
		const std::string Advice =
			Count == 1 ? "; write (" + GetName(Type) + ")X to " + (Given == 1 ? "repeat it" : "cut it") : "";
		return Fail(Place, "X3014: incorrect number of arguments to numeric-type constructor: '" + GetName(Type) +
							   "' takes " + std::to_string(Type->NumComponents()) + " numbers, not " +
							   std::to_string(Given) + Advice);
	}
	if (Parts.size() == 1 && IsSame(Parts[0]->Type, Type))
	{
		return Parts[0]->bPlace ? Make(EValue::Convert, Type, Place, {Parts[0]}) : Parts[0];
	}
	return Simplify(Make(EValue::Compose, Type, Place, std::move(Parts)));
}

} // namespace Drydock::Hlsl
