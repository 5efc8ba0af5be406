// Finds the counters that front ends declare, and makes them buffers. Source: Khronos, SPV_GOOGLE_hlsl_functionality1;
// DirectXShaderCompiler, docs/SPIR-V.rst, "Append/Consume Structured Buffers".
#include "SpirvCounters.h"

#include <algorithm>
#include <set>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint32_t CounterBytes = 4;

/** The buffer's name; empty: Variable is not a counter. */
std::string FindCounted(const FSpirvModule& Module, const FSpirvVariable& Variable)
{
	const std::string Suffix = "@count";
	const std::string Prefix = "counter.var.";
	const auto Owner = std::ranges::find(Module.Variables, Variable.Id, &FSpirvVariable::Counter);
	const std::string& Name = Variable.Name;
	return Owner != Module.Variables.end() ? Owner->Name
		   : Name.ends_with(Suffix)        ? Name.substr(0, Name.size() - Suffix.size())
		   : Name.starts_with(Prefix)      ? Name.substr(Prefix.size())
										   : std::string();
}

/** A block of one integer of 32 bits, which is not part of another type. */
bool IsCounterBlock(const FSpirvModule& Module, uint32_t Id)
{
	const FSpirvType& Type = Module.GetType(Id);
	const ESpirvType Kind = Type.Members.size() == 1 ? Module.GetType(Type.Members[0].Type).Kind : ESpirvType::None;
	const bool bPart = std::ranges::any_of(Module.Types,
		[Id](const auto& Other)
		{
			const std::vector<FSpirvMember>& Members = Other.second.Members;
			return (Other.second.Element == Id && Other.second.Kind != ESpirvType::Pointer) ||
				   std::ranges::any_of(Members, [Id](const FSpirvMember& Member) { return Member.Type == Id; });
		});
	return Type.bBufferBlock && (Kind == ESpirvType::Uint || Kind == ESpirvType::Int) && !bPart;
}

} // namespace

void MakeCountersBuffers(FSpirvModule& Module)
{
	std::set<uint32_t> Blocks; // types
	for (FSpirvVariable& Variable : Module.Variables)
	{
		const bool bBlock = Variable.Storage == StorageUniform && IsCounterBlock(Module, Variable.Type);
		Variable.CounterOf = bBlock ? FindCounted(Module, Variable) : std::string();
		if (!Variable.CounterOf.empty())
		{
			Blocks.insert(Variable.Type);
		}
	}
	for (const uint32_t Id : Blocks)
	{
		FSpirvType Elements;
		Elements.Kind = ESpirvType::RuntimeArray;
		Elements.Element = Module.GetType(Id).Members[0].Type;
		Elements.ArrayStride = CounterBytes;
		FSpirvType& Block = Module.Types.at(Id);
		Block.Members[0].Type = Module.Bound;
		Block.NumScalars = 0;
		Module.Types.emplace(Module.Bound++, std::move(Elements));
	}
	const auto PointsAtBlock = [&Module, &Blocks](uint32_t Id) // a variable, or a parameter of a function
	{
		const auto Type = Module.ValueTypes.find(Id);
		return Type != Module.ValueTypes.end() && Blocks.count(Module.GetType(Type->second).Element) > 0;
	};
	for (FSpirvBlock& Block : Module.Blocks)
	{
		for (FSpirvInstruction& I : Block.Instructions)
		{
			const bool bChain = I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain;
			if (bChain && I.Operands.size() == 2 && PointsAtBlock(I.Operands[0]))
			{
				I.Operands.push_back(I.Operands[1]); // member 0, element 0
			}
		}
	}
}

} // namespace Drydock
