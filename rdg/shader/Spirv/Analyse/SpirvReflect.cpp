// Reads a shader's parameters from its SPIR-V.
#include "SpirvReflect.h"

#include "SpirvDeclaration.h"
#include "SpirvGroups.h"
#include "SpirvImageOperands.h"
#include "SpirvPlace.h"
#include "SpirvQuads.h"
#include "SpirvRefusals.h"
#include "VertexProgram.h"

#include <algorithm>
#include <set>

namespace Drydock
{

namespace
{

using namespace Spirv;

EShaderScalar ToShaderScalar(ESpirvType Kind)
{
	constexpr EShaderScalar Scalars[] = {EShaderScalar::Bool, EShaderScalar::Int, EShaderScalar::Uint,
		EShaderScalar::Float, EShaderScalar::Half, EShaderScalar::Short, EShaderScalar::Ushort, EShaderScalar::Double,
		EShaderScalar::Long, EShaderScalar::Ulong};
	return IsSpirvScalar(Kind) ? Scalars[size_t(Kind) - size_t(ESpirvType::Bool)] : EShaderScalar::Float;
}

/** Components of a storage format; 4 where the texture does not say. */
int32_t GetFormatComponents(uint32_t Format)
{
	// SPIR-V image formats, section 3.11.
	static const std::set<uint32_t> One = {3, 9, 14, 15, 19, 20, 24, 25, 28, 29, 33, 34, 38, 39};
	static const std::set<uint32_t> Two = {6, 7, 11, 12, 13, 16, 17, 18, 26, 27, 30, 31, 35, 36, 37};
	return One.count(Format) ? 1 : Two.count(Format) ? 2 : Format == 8 ? 3 : 4;
}

class FReflector
{
public:
	FReflector(const FSpirvModule& InModule, const FSpirvStructure& InStructure, const std::string& InSource)
		: Module(InModule)
		, Structure(InStructure)
		, Source(InSource)
	{
	}

	FSpirvReflection Run();

private:
	void FindUses();
	void AddInput(const FSpirvVariable& Variable);
	void AddOutput(const FSpirvVariable& Variable);
	void AddVertexInput(const FSpirvVariable& Variable);
	void AddVertexOutput(const FSpirvVariable& Variable);
	void AddName(int32_t Interpolant, const std::string& Semantic);
	void AddConstantBuffer(const FSpirvVariable& Variable);
	void AddConstant(const FSpirvVariable& Variable, uint32_t Buffer, const FSpirvMember& Member,
		const std::string& Name, uint32_t Offset, const std::string& Where, bool bUsed);
	void AddStorageBuffer(const FSpirvVariable& Variable);
	void AddHandle(const FSpirvVariable& Variable);
	void Add(std::vector<FShaderResource>& List, const FSpirvVariable& Variable, FShaderResource Resource)
	{
		Result.Slots[Variable.Id] = uint32_t(List.size());
		Resource.Where = Where(Uses[Variable.Id]);
		List.push_back(std::move(Resource));
	}
	std::string Where(const FSpirvInstruction* I) const
	{
		return I && I->Line ? Module.Files[I->File] + ":" + std::to_string(I->Line) : std::string();
	}
	/** Refuses at the place where the text gives the variable its semantic, else at its first use. */
	[[noreturn]] void Refuse(const FSpirvVariable& Variable, const std::string& Message)
	{
		const std::string Member = Variable.Name.substr(Variable.Name.rfind('.') + 1); // of a struct
		const FTextLine Declared = FindSemantic(Source, Member, Variable.Semantic);
		if (!Variable.Semantic.empty() && Declared.Line > 0)
		{
			throw FSpirvError(Message, Declared.File, Declared.Line);
		}
		Module.Fail(Message, Uses[Variable.Id]);
	}
	EShaderCounter FindCounter(const std::string& Buffer) const;

	const FSpirvModule& Module;
	const FSpirvStructure& Structure;
	const std::string& Source;
	FSpirvReflection Result;
	std::map<uint32_t, const FSpirvInstruction*> Uses;               // variable -> the first that uses it
	std::map<std::pair<uint32_t, uint32_t>, std::string> MemberUses; // variable, member
	std::set<uint32_t> ComparisonSamplers;                           // variables
	bool bWritesPosition = false;
};

void FReflector::FindUses()
{
	std::map<uint32_t, const FSpirvInstruction*> Handles; // what makes pairs of textures and samplers, and loads these
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Op == OpSampledImage || I.Op == OpLoad)
			{
				Handles[I.Result] = &I;
			}
			if (IsSpirvComparison(I.Op))
			{
				const FSpirvInstruction* const Pair = Handles[I.Operands[0]];
				const FSpirvInstruction* const Sampler = Pair ? Handles[Pair->Operands.back()] : nullptr;
				ComparisonSamplers.insert(Sampler ? Sampler->Operands[0] : 0);
			}
			for (const uint32_t Operand : I.Operands)
			{
				if (Module.FindVariable(Operand))
				{
					Uses.emplace(Operand, &I);
				}
			}
			const bool bChain = I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain;
			if (bChain && I.Operands.size() > 1 && Module.FindConstant(I.Operands[1]))
			{
				MemberUses.emplace(std::pair(I.Operands[0], Module.GetConstantScalar(I.Operands[1])), Where(&I));
			}
			const FSpirvVariable* Whole = I.Op == OpLoad ? Module.FindVariable(I.Operands[0]) : nullptr;
			if (Whole)
			{
				for (uint32_t i = 0; i < Module.GetType(Whole->Type).Members.size(); ++i)
				{
					MemberUses.emplace(std::pair(Whole->Id, i), Where(&I));
				}
			}
		}
	}
}

EShaderCounter FReflector::FindCounter(const std::string& Buffer) const
{
	const auto Named = std::ranges::find(Module.Variables, Buffer, &FSpirvVariable::Name);
	const std::string TypeName = Named == Module.Variables.end() ? std::string() : Module.GetType(Named->Type).Name;
	const auto Is = [&](const std::string& Type)
	{
		return TypeName.starts_with("type." + Type) /* DXC */ || IsDeclaredAs(Source, Type, Buffer);
	};
	const bool bAppends = Is("AppendStructuredBuffer") || Is("ConsumeStructuredBuffer");
	return bAppends ? EShaderCounter::Append : Is("RWStructuredBuffer") ? EShaderCounter::Atomic : EShaderCounter::Any;
}

void FReflector::AddName(int32_t Interpolant, const std::string& Semantic)
{
	std::vector<std::string>& Names = Result.Reflection.NamedInterpolants;
	if (Interpolant >= GFirstNamedInterpolant)
	{
		const size_t Index = size_t(Interpolant - GFirstNamedInterpolant);
		Names.resize(std::max(Names.size(), Index + 1));
		Names[Index] = Semantic;
	}
}

void FReflector::AddInput(const FSpirvVariable& Variable)
{
	switch (Variable.BuiltIn)
	{
	case BuiltInNone:
	{
		const int32_t Index = GetInterpolantIndex(Variable);
		if (Index < 0)
		{
			Refuse(
				Variable, "pixel input '" + Variable.Name + "' has the semantic " + Variable.Semantic +
							  ", which no pass fills; use SV_POSITION, TEXCOORDn or COLORn, or any name for the first "
							  "twelve inputs");
		}
		AddName(Index, NormaliseSemantic(Variable.Semantic, 0));
		Result.Reflection.NumInterpolants = std::max(Result.Reflection.NumInterpolants, Index + 1);
		const bool bInteger = Module.GetScalarKind(Variable.Type, 0) != ESpirvType::Float;
		Result.Reflection.IntegerInterpolants |= uint32_t(bInteger) << Index;
		return;
	}
	case BuiltInFragCoord:
	case BuiltInFrontFacing:
	case BuiltInWorkgroupId:
	case BuiltInLocalInvocationId:
	case BuiltInGlobalInvocationId:
	case BuiltInLocalInvocationIndex:
		return;
	case BuiltInSubgroupSize:
	case BuiltInSubgroupLocalInvocationId:
		if (Module.ExecutionModel == ExecutionModelCompute)
		{
			return;
		}
		Refuse(Variable, ExplainRefusedBuiltIn(Variable.BuiltIn));
	default:
		Refuse(Variable, "input '" + Variable.Name + "' (" + Variable.Semantic + ") is not supported on the CPU tier");
	}
}

void FReflector::AddOutput(const FSpirvVariable& Variable)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	if (Variable.BuiltIn == BuiltInFragDepth)
	{
		Result.Reflection.bWritesDepth = true;
		return;
	}
	const bool bTarget = Variable.Semantic.empty() || GetSemanticIndex(Variable.Semantic, "SV_TARGET") >= 0;
	const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
	const bool bInteger = Kind == ESpirvType::Int || Kind == ESpirvType::Uint;
	const bool bColor = bTarget && Variable.BuiltIn == BuiltInNone && Type.NumScalars <= 4 && Variable.Location < 8 &&
						(bInteger || Kind == ESpirvType::Float);
	if (!bColor)
	{
		Refuse(Variable,
			"pixel output '" + Variable.Name + "' (" + Variable.Semantic +
				") is not supported on the CPU tier; outputs are colours of float, int or uint to SV_Target0..7");
	}
	Result.Reflection.NumTargets = std::max(Result.Reflection.NumTargets, int32_t(Variable.Location) + 1);
	Result.Reflection.IntegerTargets |= uint32_t(bInteger) << Variable.Location;
}

void FReflector::AddVertexInput(const FSpirvVariable& Variable)
{
	if (Variable.BuiltIn == BuiltInVertexIndex || Variable.BuiltIn == BuiltInInstanceIndex)
	{
		return;
	}
	const int32_t Index = Variable.BuiltIn == BuiltInNone ? GetSemanticIndex(Variable.Semantic, "ATTRIBUTE") : -1;
	if (Index < 0)
	{
		Refuse(Variable, "vertex input '" + Variable.Name + "' has the semantic " + Variable.Semantic +
							 ", which no vertex declaration feeds; use ATTRIBUTEn, SV_VertexID or SV_InstanceID");
	}
	Result.AttributesRead |= 1u << Index;
}

void FReflector::AddVertexOutput(const FSpirvVariable& Variable)
{
	if (Variable.BuiltIn == BuiltInPosition)
	{
		bWritesPosition = true;
		return;
	}
	const FSpirvType& Type = Module.GetType(Variable.Type);
	const bool bArray = Type.Kind == ESpirvType::Array;
	const FSpirvType& Element = bArray ? Module.GetType(Type.Element) : Type;
	const int32_t Index = GetInterpolantIndex(Variable);
	const int32_t Count = bArray ? int32_t(std::min<uint32_t>(Type.Count, 1u + GMaxInterpolants)) : 1;
	const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
	const bool bInteger = Kind == ESpirvType::Int || Kind == ESpirvType::Uint;
	const int32_t End = Index < GMaxTexCoords            ? GMaxTexCoords
						: Index < GFirstNamedInterpolant ? GFirstNamedInterpolant
														 : GMaxInterpolants;
	const bool bFits =
		Index >= 0 && Index + Count <= End && Element.NumScalars <= 4 && (bInteger || Kind == ESpirvType::Float);
	if (!bFits)
	{
		Refuse(Variable,
			"vertex output '" + Variable.Name + "' (" + Variable.Semantic + ", " + GetHlslTypeName(Module, Type) +
				") is not supported on the CPU tier; outputs are SV_POSITION, TEXCOORD0..15, COLOR0..3, of up to "
				"four floats or integers. The first twelve may have any name");
	}
	for (int32_t i = 0; i < Count; ++i)
	{
		AddName(Index + i, NormaliseSemantic(Variable.Semantic, i));
	}
	const uint32_t Bits = ((1u << Count) - 1) << Index;
	Result.TexCoordsWritten |= Bits;
	Result.Reflection.IntegerInterpolants |= bInteger ? Bits : 0;
	Result.Reflection.NumInterpolants = std::max(Result.Reflection.NumInterpolants, Index + Count);
}

void FReflector::AddConstant(const FSpirvVariable& Variable, uint32_t Buffer, const FSpirvMember& Member,
	const std::string& Name, uint32_t Offset, const std::string& Where, bool bUsed)
{
	const FSpirvType* Type = &Module.GetType(Member.Type);
	if (Type->Kind == ESpirvType::Struct)
	{
		for (const FSpirvMember& Inner : Type->Members)
		{
			AddConstant(Variable, Buffer, Inner, Name + "." + Inner.Name, Offset + Inner.Offset, Where, bUsed);
		}
		return;
	}
	FShaderConstant Constant;
	if (Type->Kind == ESpirvType::Array)
	{
		const FSpirvType& Element = Module.GetType(Type->Element);
		if (Element.Kind == ESpirvType::Struct || Element.Kind == ESpirvType::Array)
		{
			for (uint32_t i = 0; i < Type->Count; ++i)
			{
				FSpirvMember One = Member;
				One.Type = Type->Element;
				AddConstant(Variable, Buffer, One, Name + "[" + std::to_string(i) + "]", Offset + i * Type->ArrayStride,
					Where, bUsed);
			}
			return;
		}
		Constant.NumElements = int32_t(Type->Count);
		Constant.ArrayStride = Type->ArrayStride;
		Type = &Element;
	}
	if (Type->Kind == ESpirvType::Matrix)
	{
		// A row of HLSL is a column of SPIR-V, and so is "row major".
		Constant.Rows = int32_t(Type->Count);
		Constant.Columns = int32_t(Module.GetType(Type->Element).Count);
		Constant.MatrixStride = Member.MatrixStride;
		Constant.bRowMajor = !Member.bRowMajor;
	}
	else
	{
		Constant.Columns = Type->Kind == ESpirvType::Vector ? int32_t(Type->Count) : 1;
	}
	Constant.Name = Name;
	Constant.Scalar = ToShaderScalar(Module.GetScalarKind(Member.Type, 0));
	Constant.Buffer = Buffer;
	Constant.Offset = Offset;
	Constant.bUsed = bUsed;
	Constant.Where = Where;
	Result.Reflection.Constants.push_back(std::move(Constant));
}

void FReflector::AddConstantBuffer(const FSpirvVariable& Variable)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	FShaderReflection& Reflection = Result.Reflection;
	const uint32_t Buffer = uint32_t(Reflection.ConstantBuffers.size());
	uint32_t Size = 0;
	for (uint32_t i = 0; i < Type.Members.size(); ++i)
	{
		const FSpirvMember& Member = Type.Members[i];
		if (Module.GetType(Member.Type).NumScalars == 0)
		{
			Refuse(
				Variable, "constant buffer '" + Type.Name + "' has a member '" + Member.Name + "' that is not numeric");
		}
		for (const uint32_t Offset : GetScalarOffsets(Module, Member.Type, Member.MatrixStride, Member.bRowMajor))
		{
			Size = std::max(Size, Member.Offset + Offset + 4);
		}
		const auto Use = MemberUses.find({Variable.Id, i});
		AddConstant(Variable, Buffer, Member, Member.Name, Member.Offset,
			Use == MemberUses.end() ? std::string() : Use->second, Use != MemberUses.end());
	}
	Result.Slots[Variable.Id] = Buffer;
	Reflection.ConstantBuffers.push_back(
		{Type.Name == "$Global" || Type.Name == "$Globals" ? "$Global" : Type.Name, (Size + 15) / 16 * 16});
}

void FReflector::AddStorageBuffer(const FSpirvVariable& Variable)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	if (Type.Members.size() != 1 || Module.GetType(Type.Members[0].Type).Kind != ESpirvType::RuntimeArray)
	{
		Refuse(Variable, "buffer '" + (Variable.Name.empty() ? Type.Name : Variable.Name) +
							 "' is of a kind that the CPU tier does not know (tbuffer is not supported); use a "
							 "StructuredBuffer, a Buffer or a cbuffer");
	}
	const FSpirvType& Array = Module.GetType(Type.Members[0].Type);
	FShaderResource Resource;
	Resource.Name = Variable.Name;
	Resource.Stride = Array.ArrayStride;
	Resource.NumComponents = std::min<int32_t>(4, int32_t(Module.GetType(Array.Element).NumScalars));
	Resource.Scalar = ToShaderScalar(Module.GetScalarKind(Array.Element, 0));
	Resource.CounterOf = Variable.CounterOf;
	Resource.Counter = Variable.CounterOf.empty() ? EShaderCounter::Any : FindCounter(Variable.CounterOf);
	const bool bReadOnly = Type.Members[0].bNonWritable;
	const bool bBytes = (Type.Name.starts_with("type.") && Type.Name.ends_with("ByteAddressBuffer")) ||
						IsDeclaredAs(Source, bReadOnly ? "ByteAddressBuffer" : "RWByteAddressBuffer", Variable.Name);
	Resource.Dimension = bBytes ? EShaderDimension::ByteAddressBuffer : EShaderDimension::StructuredBuffer;
	Add(bReadOnly ? Result.Reflection.Buffers : Result.Reflection.RWBuffers, Variable, std::move(Resource));
}

void FReflector::AddHandle(const FSpirvVariable& Variable)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	FShaderResource Resource;
	Resource.Name = Variable.Name;
	if (Type.Kind == ESpirvType::Sampler)
	{
		Resource.bCompares = ComparisonSamplers.count(Variable.Id) != 0;
		Add(Result.Reflection.Samplers, Variable, std::move(Resource));
		return;
	}
	if (Type.Kind != ESpirvType::Image)
	{
		Refuse(Variable,
			"'" + Variable.Name +
				"' is an array of textures or samplers, which the CPU tier does not support; declare them one by one");
	}
	Resource.Scalar = ToShaderScalar(Module.GetType(Type.Element).Kind);
	Resource.NumComponents = GetFormatComponents(Type.Format);
	Resource.Dimension = Type.Dim == DimBuffer ? EShaderDimension::TypedBuffer
						 : Type.Dim == Dim3D   ? EShaderDimension::Texture3D
						 : Type.Dim == DimCube ? EShaderDimension::TextureCube
						 : Type.bArrayed       ? EShaderDimension::Texture2DArray
											   : EShaderDimension::Texture2D;
	FShaderReflection& R = Result.Reflection;
	const bool bBuffer = Type.Dim == DimBuffer;
	Add(bBuffer              ? (Type.bStorageImage ? R.RWBuffers : R.Buffers)
		: Type.bStorageImage ? R.RWTextures
							 : R.Textures,
		Variable, std::move(Resource));
}

FSpirvReflection FReflector::Run()
{
	FShaderReflection& Reflection = Result.Reflection;
	Reflection.Stage = Module.ExecutionModel == ExecutionModelFragment ? EShaderStage::Pixel
					   : Module.ExecutionModel == ExecutionModelVertex ? EShaderStage::Vertex
																	   : EShaderStage::Compute;
	const bool bVertex = Reflection.Stage == EShaderStage::Vertex;
	for (int i = 0; i < 3; ++i)
	{
		Reflection.GroupSize[i] = int32_t(Module.LocalSize[i]);
	}
	FindUses();
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (!Uses.count(Variable.Id))
		{
			continue;
		}
		switch (Variable.Storage)
		{
		case StorageInput:
			bVertex ? AddVertexInput(Variable) : AddInput(Variable);
			break;
		case StorageOutput:
			bVertex ? AddVertexOutput(Variable) : AddOutput(Variable);
			break;
		case StorageUniform:
		case StorageStorageBuffer:
			Module.GetType(Variable.Type).bBufferBlock ? AddStorageBuffer(Variable) : AddConstantBuffer(Variable);
			break;
		case StorageUniformConstant:
			AddHandle(Variable);
			break;
		default:
			break;
		}
	}
	if (bVertex && !bWritesPosition)
	{
		Module.Fail("the vertex shader writes no SV_POSITION");
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			Reflection.bUsesDiscard =
				Reflection.bUsesDiscard || I.Op == OpKill || I.Op == OpDemote || I.Op == OpFunctionCall;
			Reflection.bLoadsStored =
				Reflection.bLoadsStored || I.Op == OpImageRead || I.Op == OpImageTexelPointer || I.Op == OpFunctionCall;
		}
	}
	const FSpirvGroupUse Groups = FindGroupUse(Module);
	Reflection.bGroups = Groups.bGroups;
	Reflection.bGroupsInOrder = Groups.bInOrder;
	Reflection.bQuads = Module.bQuads;
	for (const uint32_t Texture : FindImplicitSamples(Module))
	{
		const auto Slot = Result.Slots.find(Texture);
		if (Slot != Result.Slots.end())
		{
			Reflection.Textures.at(Slot->second).bImplicitLevel = true;
		}
	}
	Reflection.StaticSamples = CountStaticSamples(Module, Structure);
	return std::move(Result);
}

} // namespace

FSpirvReflection ReflectSpirv(const FSpirvModule& Module, const FSpirvStructure& Structure, const std::string& Source)
{
	return FReflector(Module, Structure, Source).Run();
}

} // namespace Drydock
