// The entry point around the user's function: its inputs and outputs by their semantics.
#include "HlslEmitterImpl.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr uint32_t ModeOriginUpperLeft = 7;
constexpr uint32_t ModeEarlyTests = 9;
constexpr uint32_t ModeDepthReplacing = 12;

struct FEmitBuiltIn
{
	std::string_view Semantic; // without its index
	EStage Stage;
	bool bOutput;
	uint32_t BuiltIn;
	EScalar Scalar;
	uint32_t Count;
};

constexpr FEmitBuiltIn EmitBuiltIns[] = {
	{"SV_DISPATCHTHREADID", EStage::Compute, false, BuiltInGlobalInvocationId, EScalar::Uint, 3},
	{"SV_GROUPID", EStage::Compute, false, BuiltInWorkgroupId, EScalar::Uint, 3},
	{"SV_GROUPTHREADID", EStage::Compute, false, BuiltInLocalInvocationId, EScalar::Uint, 3},
	{"SV_GROUPINDEX", EStage::Compute, false, BuiltInLocalInvocationIndex, EScalar::Uint, 1},
	{"SV_VERTEXID", EStage::Vertex, false, BuiltInVertexIndex, EScalar::Uint, 1},
	{"SV_INSTANCEID", EStage::Vertex, false, BuiltInInstanceIndex, EScalar::Uint, 1},
	{"SV_POSITION", EStage::Vertex, true, BuiltInPosition, EScalar::Float, 4},
	{"SV_POSITION", EStage::Pixel, false, BuiltInFragCoord, EScalar::Float, 4},
	{"SV_ISFRONTFACE", EStage::Pixel, false, BuiltInFrontFacing, EScalar::Bool, 1},
	{"SV_DEPTH", EStage::Pixel, true, BuiltInFragDepth, EScalar::Float, 1},
	{"SV_DEPTHGREATEREQUAL", EStage::Pixel, true, BuiltInFragDepth, EScalar::Float, 1},
	{"SV_DEPTHLESSEQUAL", EStage::Pixel, true, BuiltInFragDepth, EScalar::Float, 1},
};

struct FEmitStill
{
	std::string_view Semantic;
	uint32_t Value;
};

/** Inputs of pixel shaders that are the same everywhere: no vertex shader here chooses a layer or a viewport, and no
 * target has more than one sample. */
constexpr FEmitStill EmitStillInputs[] = {
	{"SV_RENDERTARGETARRAYINDEX", 0}, {"SV_VIEWPORTARRAYINDEX", 0}, {"SV_SAMPLEINDEX", 0}, {"SV_COVERAGE", 1}};

std::string_view GetEmitSemantic(std::string_view Semantic)
{
	return Semantic.substr(0, Semantic.find_last_not_of("0123456789") + 1);
}

uint32_t GetEmitIndex(std::string_view Semantic)
{
	return uint32_t(std::atoi(std::string(Semantic.substr(GetEmitSemantic(Semantic).size())).c_str()));
}

} // namespace

uint32_t FEmitter::StageVariable(const FType* Type, const FStageValue& Value, const FType*& Declared)
{
	const std::string_view Name = GetEmitSemantic(Value.Semantic);
	const auto Found = std::ranges::find_if(EmitBuiltIns, [&](const FEmitBuiltIn& Row)
		{ return Row.Semantic == Name && Row.Stage == Program.Stage && Row.bOutput == Value.bOutput; });
	const bool bBuiltIn = Found != std::end(EmitBuiltIns);
	const bool bNarrow = IsReal(Type->Scalar) && Bits(Type->Scalar) == 16;
	Declared = bBuiltIn                        ? Types.Vector(Found->Scalar, Found->Count)
			   : Type->Scalar == EScalar::Bool ? Types.WithScalar(Type, EScalar::Uint)
			   : bNarrow                       ? Types.WithScalar(Type, EScalar::Float)
											   : Type;
	const uint32_t Storage = Value.bOutput ? StorageOutput : StorageInput;
	const uint32_t Id = Module.Global(TypeOf(Declared), Storage, Value.Name);
	Interface.push_back(Id);
	if (bBuiltIn)
	{
		Module.Decorate(Id, DecorationBuiltIn, {Found->BuiltIn});
		if (Found->BuiltIn == BuiltInFragDepth)
		{
			Modes.push_back({ModeDepthReplacing});
		}
	}
	else
	{
		const bool bTarget = Value.bOutput && Program.Stage == EStage::Pixel;
		uint32_t& Next = NextLocation[Value.bOutput ? 1 : 0];
		Module.Decorate(Id, DecorationLocation, {bTarget ? GetEmitIndex(Value.Semantic) + Value.Index : Next++});
		const bool bFlat = !IsReal(Declared->Scalar) || (Value.Modifiers & ModifierNoInterpolation);
		if (bFlat && Program.Stage == EStage::Pixel && !Value.bOutput)
		{
			Module.Decorate(Id, DecorationFlat);
		}
	}
	if (!Value.Semantic.empty())
	{
		const bool bPlain = bBuiltIn || (Name.starts_with("SV_") && Name != "SV_TARGET");
		Module.DecorateSemantic(Id, bPlain && GetEmitIndex(Value.Semantic) == 0 ? Name : Value.Semantic);
	}
	return Id;
}

/** The part of a struct, of an array or of a matrix. Elements have the semantic of the whole, by which the tier counts.
 */
FEmitter::FStageValue FEmitter::StagePart(const FType* Type, const FStageValue& Value, uint32_t Index)
{
	FStageValue Part = Value;
	if (Type->IsStruct())
	{
		const FMember& Member = Type->Struct->Members[Index];
		Part.Name += "." + Member.Name;
		Part.Semantic = Member.Semantic.empty() ? Part.Semantic : Member.Semantic;
		Part.Modifiers |= Member.Modifiers;
		return Part;
	}
	Part.Name += "[" + std::to_string(Index) + "]";
	Part.Index = Index;
	return Part;
}

uint32_t FEmitter::ReadInput(const FType* Type, const FStageValue& Input)
{
	const auto Still = std::ranges::find(EmitStillInputs, GetEmitSemantic(Input.Semantic), &FEmitStill::Semantic);
	if (Program.Stage == EStage::Pixel && Still != std::end(EmitStillInputs) && Type->IsScalar())
	{
		return Convert(Module.Uint(Still->Value), Types.Scalar(EScalar::Uint), Type);
	}
	if (Type->IsNumeric() && !Type->IsMatrix())
	{
		const FType* Declared = nullptr;
		const uint32_t Variable = StageVariable(Type, Input, Declared);
		return Convert(Op(OpLoad, TypeOf(Declared), {Variable}), Declared, Type);
	}
	FWords Parts;
	const uint32_t Count = Type->IsStruct()  ? uint32_t(Type->Struct->Members.size())
						   : Type->IsArray() ? Type->Count
											 : Type->Rows;
	for (uint32_t i = 0; i < Count; ++i)
	{
		const FType* const Part = Type->IsStruct()  ? Type->Struct->Members[i].Type
								  : Type->IsArray() ? Type->Element
													: RowOf(Type);
		if (CountScalars(Part) > 0)
		{
			Parts.push_back(ReadInput(Part, StagePart(Type, Input, i)));
		}
	}
	return Construct(TypeOf(Type), Parts);
}

void FEmitter::WriteOutput(const FType* Type, const FStageValue& Output, uint32_t Id)
{
	if (Type->IsNumeric() && !Type->IsMatrix())
	{
		const FType* Declared = nullptr;
		FStageValue Mapped = Output;
		Mapped.Semantic = Program.MapOutput(Output.Semantic);
		const uint32_t Variable = StageVariable(Type, Mapped, Declared);
		Do(OpStore, {Variable, Convert(Id, Type, Declared)});
		return;
	}
	const uint32_t Count = Type->IsStruct()  ? uint32_t(Type->Struct->Members.size())
						   : Type->IsArray() ? Type->Count
											 : Type->Rows;
	for (uint32_t i = 0, Index = 0; i < Count; ++i)
	{
		const FType* const Part = Type->IsStruct()  ? Type->Struct->Members[i].Type
								  : Type->IsArray() ? Type->Element
													: RowOf(Type);
		if (CountScalars(Part) > 0)
		{
			WriteOutput(Part, StagePart(Type, Output, i), ExtractAt(Id, TypeOf(Part), {Index++}));
		}
	}
}

/** The function that the pipeline calls: reads inputs, calls the user's, writes outputs. */
uint32_t FEmitter::WriteEntry()
{
	const FFunction& Entry = *Program.Entry;
	FFrame New;
	const uint32_t Id = Module.NewId();
	const uint32_t Void = Module.Intern(OpTypeVoid, {});
	SetPlace(Entry.Place);
	Begin(New, Id, Void, {}, Entry.Name);
	Modes = Program.Stage == EStage::Pixel ? std::vector<FWords>{{ModeOriginUpperLeft}} : std::vector<FWords>();
	if (Program.Stage == EStage::Compute)
	{
		Modes.push_back({ExecutionModeLocalSize, Program.GroupSize[0], Program.GroupSize[1], Program.GroupSize[2]});
	}
	if (Program.bEarlyDepthStencil)
	{
		Modes.push_back({ModeEarlyTests});
	}
	WriteStatics();
	SetPlace(Entry.Place);
	FInstance& Instance = GetInstance(Entry, std::vector<FObjects>(Entry.Parameters.size()));
	FWords Ids = {Instance.Id};
	for (const FVariable* const Parameter : Entry.Parameters)
	{
		if (CountScalars(Parameter->Type) == 0)
		{
			continue; // a struct without members
		}
		Ids.push_back(Temporary(TypeOf(Parameter->Type), "param"));
		const bool bIn = !(Parameter->Modifiers & ModifierOut) || (Parameter->Modifiers & ModifierIn);
		if (bIn)
		{
			const uint32_t Input =
				ReadInput(Parameter->Type, {Parameter->Name, Parameter->Semantic, Parameter->Modifiers, 0, false});
			Do(OpStore, {Ids.back(), Input});
		}
	}
	const bool bValue = CountScalars(Entry.Result) > 0;
	const uint32_t Result = Op(OpFunctionCall, bValue ? TypeOf(Entry.Result) : Void, Ids);
	for (size_t i = 0, At = 0; i < Entry.Parameters.size(); ++i)
	{
		const FVariable& Parameter = *Entry.Parameters[i];
		At += CountScalars(Parameter.Type) > 0 ? 1 : 0;
		if (Parameter.Modifiers & ModifierOut && CountScalars(Parameter.Type) > 0)
		{
			WriteOutput(Parameter.Type, {Parameter.Name, Parameter.Semantic, Parameter.Modifiers, 0, true},
				Op(OpLoad, TypeOf(Parameter.Type), {Ids[At]}));
		}
	}
	if (bValue)
	{
		WriteOutput(Entry.Result, {"@entryPointOutput", Entry.Semantic, 0, 0, true}, Result);
	}
	End(OpReturn);
	Module.AddFunction(New.Body);
	return Id;
}

} // namespace Drydock::Hlsl
