// Rewrites a module's decorations, and writes the vertex shader of draws that cover a rectangle. Source: Khronos,
// SPIR-V specification, section 3.32.
#include "VulkanModule.h"

#include "SpirvReflect.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <set>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint32_t DecorationDescriptorSet = 34;
constexpr uint32_t GeneratorGlslang = 8; // Khronos' register of generators
constexpr uint32_t InclusiveScan = 1;
constexpr uint32_t ExclusiveScan = 2;

void Put(std::vector<uint32_t>& Out, uint16_t Op, std::initializer_list<uint32_t> Operands)
{
	Out.push_back(uint32_t(Operands.size() + 1) << 16 | Op);
	Out.insert(Out.end(), Operands);
}

/** Lines, names and what drydock's own reader wants of them: a driver need not know the extensions behind these. */
bool IsForReaders(uint16_t Op)
{
	static const std::set<uint16_t> Ops = {OpSourceContinued, OpSource, OpSourceExtension, OpName, OpMemberName,
		OpString, OpLine, OpNoLine, OpModuleProcessed, OpExtension, OpDecorateId, OpDecorateString,
		OpMemberDecorateString};
	return Ops.count(Op) > 0;
}

bool IsResource(const FSpirvVariable& Variable)
{
	return Variable.Storage == StorageUniformConstant || Variable.Storage == StorageUniform ||
		   Variable.Storage == StorageStorageBuffer;
}

bool IsTexCoord(const FSpirvModule& Module, const FSpirvVariable& Variable)
{
	return Module.ExecutionModel == ExecutionModelFragment && Variable.Storage == StorageInput &&
		   Variable.BuiltIn == BuiltInNone && GetInterpolantIndex(Variable) >= 0;
}

/** Extensions that are more than names for readers. */
bool IsNeeded(const std::string& Extension)
{
	return !Extension.starts_with("SPV_GOOGLE_");
}

/** The value by which the module replaces a word of the layout: Direct3D's (SpirvLayout.h). Null: none. */
const uint32_t* FindLayout(const FSpirvModule& Module, uint16_t Op, const uint32_t* Operands)
{
	const auto Type = Op == OpDecorate || Op == OpMemberDecorate ? Module.Types.find(Operands[0]) : Module.Types.end();
	if (Type == Module.Types.end())
	{
		return nullptr;
	}
	if (Op == OpDecorate)
	{
		return Operands[1] == DecorationArrayStride ? &Type->second.ArrayStride : nullptr;
	}
	const FSpirvMember& Member = Type->second.Members.at(Operands[1]);
	return Operands[2] == DecorationOffset         ? &Member.Offset
		   : Operands[2] == DecorationMatrixStride ? &Member.MatrixStride
												   : nullptr;
}

std::string ReadText(const uint32_t* Words, uint32_t Count)
{
	const char* const Text = reinterpret_cast<const char*>(Words);
	return std::string(Text, strnlen(Text, size_t(Count) * 4));
}

} // namespace

FVulkanModule MakeVulkanModule(const std::vector<uint32_t>& Words, const FSpirvModule& Module)
{
	std::set<uint32_t> Placed; // ids whose places are given anew
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (IsResource(Variable) || IsTexCoord(Module, Variable))
		{
			Placed.insert(Variable.Id);
		}
	}
	FVulkanModule Result;
	std::vector<uint32_t>& Out = Result.Words;
	Out.assign(Words.begin(), Words.begin() + HeaderWords);
	const bool bGlslang = Words[2] >> 16 == GeneratorGlslang;
	bool bDecorated = false;
	for (size_t At = HeaderWords; At < Words.size();)
	{
		const uint16_t Op = uint16_t(Words[At] & 0xffff);
		const uint32_t Count = Words[At] >> 16;
		const uint32_t* const Operands = Words.data() + At + 1;
		bool bKeep = !IsForReaders(Op);
		if (Op == OpCapability)
		{
			Result.Capabilities.push_back(Operands[0]);
		}
		if (Op == OpExtension)
		{
			bKeep = IsNeeded(ReadText(Operands, Count - 1));
		}
		if (Op == OpEntryPoint)
		{
			Result.EntryPoint = ReadText(Operands + 2, Count - 3);
		}
		if (Op == OpDecorate && Placed.count(Operands[0]))
		{
			bKeep = Operands[1] != DecorationBinding && Operands[1] != DecorationDescriptorSet &&
					Operands[1] != DecorationLocation;
		}
		if (!bDecorated && Op >= OpTypeVoid && Op <= OpFunction) // annotations end where types begin
		{
			bDecorated = true;
			for (size_t i = 0; i < Module.Variables.size(); ++i)
			{
				const FSpirvVariable& Variable = Module.Variables[i];
				if (IsResource(Variable))
				{
					Put(Out, OpDecorate, {Variable.Id, DecorationDescriptorSet, 0});
					Put(Out, OpDecorate, {Variable.Id, DecorationBinding, uint32_t(i)});
				}
				else if (IsTexCoord(Module, Variable))
				{
					Put(Out, OpDecorate, {Variable.Id, DecorationLocation, uint32_t(GetInterpolantIndex(Variable))});
				}
			}
		}
		if (bKeep)
		{
			Out.insert(Out.end(), Words.begin() + std::ptrdiff_t(At), Words.begin() + std::ptrdiff_t(At + Count));
			constexpr size_t GroupOperation = 4; // behind type, result and scope
			uint32_t* const Copied = Out.data() + (Out.size() - Count);
			if (bGlslang && HasGroupOperation(Op) && Copied[GroupOperation] == InclusiveScan)
			{
				Copied[GroupOperation] = ExclusiveScan; // glslang takes WavePrefix* for the other kind of prefix
			}
			if (const uint32_t* const Place = FindLayout(Module, Op, Operands))
			{
				Copied[Count - 1] = *Place;
			}
		}
		At += Count;
	}
	return Result;
}

std::vector<uint32_t> GetTexCoordComponents(const FSpirvModule& Module)
{
	std::vector<uint32_t> Components;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (!IsTexCoord(Module, Variable))
		{
			continue;
		}
		const FSpirvType& Type = Module.GetType(Variable.Type);
		const bool bArray = Type.Kind == ESpirvType::Array;
		const FSpirvType& Element = bArray ? Module.GetType(Type.Element) : Type;
		const size_t First = size_t(GetInterpolantIndex(Variable));
		const size_t Last = First + (bArray ? Type.Count : 1);
		Components.resize(std::max(Components.size(), Last));
		std::fill(
			Components.begin() + std::ptrdiff_t(First), Components.begin() + std::ptrdiff_t(Last), Element.NumScalars);
	}
	return Components;
}

std::vector<uint32_t> MakePassingVertexShader(const std::vector<uint32_t>& Components)
{
	// Ids: 1 entry point, 2 void, 3 its function type, 4 float, 4 + n vectors of n, then pointers and variables.
	constexpr uint32_t Main = 1;
	constexpr uint32_t Void = 2;
	constexpr uint32_t FunctionType = 3;
	constexpr uint32_t Float = 4;
	constexpr uint32_t InputPointer = 10;  // + components
	constexpr uint32_t OutputPointer = 15; // + components
	constexpr uint32_t PositionIn = 20;
	constexpr uint32_t PositionOut = 21;
	constexpr uint32_t Label = 22;
	constexpr uint32_t FirstOther = 23;
	constexpr uint32_t Version10 = 0x00010000;

	uint32_t Next = FirstOther;
	struct FPassed
	{
		uint32_t In, Out, Loaded, Location, Components;
	};
	std::vector<FPassed> All = {{PositionIn, PositionOut, Next++, 0, 4}};
	for (uint32_t n = 0; n < Components.size(); ++n)
	{
		if (Components[n] > 0)
		{
			All.push_back({Next, Next + 1, Next + 2, n, Components[n]});
			Next += 3;
		}
	}
	std::vector<uint32_t> Out = {Magic, Version10, 0, Next, 0};
	Put(Out, OpCapability, {1});     // Shader
	Put(Out, OpMemoryModel, {0, 1}); // Logical, GLSL450
	uint32_t Name[2] = {};
	std::memcpy(Name, "main", 4);
	Out.push_back(uint32_t(5 + All.size() * 2) << 16 | OpEntryPoint);
	Out.insert(Out.end(), {ExecutionModelVertex, Main, Name[0], Name[1]});
	for (const FPassed& Passed : All)
	{
		Out.insert(Out.end(), {Passed.In, Passed.Out});
	}
	Put(Out, OpDecorate, {PositionIn, DecorationLocation, 0});
	Put(Out, OpDecorate, {PositionOut, DecorationBuiltIn, BuiltInPosition});
	for (size_t i = 1; i < All.size(); ++i)
	{
		Put(Out, OpDecorate, {All[i].In, DecorationLocation, All[i].Location + 1});
		Put(Out, OpDecorate, {All[i].Out, DecorationLocation, All[i].Location});
	}
	Put(Out, OpTypeVoid, {Void});
	Put(Out, OpTypeFunction, {FunctionType, Void});
	Put(Out, OpTypeFloat, {Float, 32});
	for (uint32_t n = 2; n <= 4; ++n)
	{
		Put(Out, OpTypeVector, {Float + n, Float, n});
	}
	const auto TypeOf = [](uint32_t Count)
	{
		return Count == 1 ? Float : Float + Count;
	};
	for (uint32_t n = 1; n <= 4; ++n)
	{
		Put(Out, OpTypePointer, {InputPointer + n, StorageInput, TypeOf(n)});
		Put(Out, OpTypePointer, {OutputPointer + n, StorageOutput, TypeOf(n)});
	}
	for (const FPassed& Passed : All)
	{
		Put(Out, OpVariable, {InputPointer + Passed.Components, Passed.In, StorageInput});
		Put(Out, OpVariable, {OutputPointer + Passed.Components, Passed.Out, StorageOutput});
	}
	Put(Out, OpFunction, {Void, Main, 0, FunctionType});
	Put(Out, OpLabel, {Label});
	for (const FPassed& Passed : All)
	{
		Put(Out, OpLoad, {TypeOf(Passed.Components), Passed.Loaded, Passed.In});
		Put(Out, OpStore, {Passed.Out, Passed.Loaded});
	}
	Put(Out, OpReturn, {});
	Put(Out, OpFunctionEnd, {});
	return Out;
}

} // namespace Drydock
