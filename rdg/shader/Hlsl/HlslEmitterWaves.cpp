// Emits the work that threads do together: waves, quads, barriers, atomics.
#include "HlslEmitterImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr uint32_t ScopeDevice = 1;
constexpr uint32_t ScopeWorkgroup = 2;
constexpr uint32_t ScopeSubgroup = 3;
constexpr uint32_t MemoryGroup = 0x108;  // acquire and release, of groupshared memory
constexpr uint32_t MemoryDevice = 0x848; // of buffers and textures
constexpr uint32_t MemoryAll = 0xD48;
constexpr uint32_t GroupReduce = 0;
constexpr uint32_t GroupExclusive = 2;

struct FEmitWave
{
	std::string_view Name;
	uint16_t Signed;
	uint16_t Unsigned;
	uint16_t Real;
	uint32_t Group;
};

constexpr FEmitWave EmitWaves[] = {
	{"WaveActiveSum", OpGroupNonUniformIAdd, OpGroupNonUniformIAdd, OpGroupNonUniformFAdd, GroupReduce},
	{"WaveActiveProduct", OpGroupNonUniformIMul, OpGroupNonUniformIMul, OpGroupNonUniformFMul, GroupReduce},
	{"WavePrefixSum", OpGroupNonUniformIAdd, OpGroupNonUniformIAdd, OpGroupNonUniformFAdd, GroupExclusive},
	{"WavePrefixProduct", OpGroupNonUniformIMul, OpGroupNonUniformIMul, OpGroupNonUniformFMul, GroupExclusive},
	{"WaveActiveMin", OpGroupNonUniformSMin, OpGroupNonUniformUMin, OpGroupNonUniformFMin, GroupReduce},
	{"WaveActiveMax", OpGroupNonUniformSMax, OpGroupNonUniformUMax, OpGroupNonUniformFMax, GroupReduce},
	{"WaveActiveBitAnd", OpGroupNonUniformBitwiseAnd, OpGroupNonUniformBitwiseAnd, 0, GroupReduce},
	{"WaveActiveBitOr", OpGroupNonUniformBitwiseOr, OpGroupNonUniformBitwiseOr, 0, GroupReduce},
	{"WaveActiveBitXor", OpGroupNonUniformBitwiseXor, OpGroupNonUniformBitwiseXor, 0, GroupReduce},
};

struct FEmitAtomic
{
	std::string_view Name;
	uint16_t Signed;
	uint16_t Unsigned;
};

constexpr FEmitAtomic EmitAtomics[] = {
	{"InterlockedAdd", OpAtomicIAdd, OpAtomicIAdd},
	{"InterlockedAnd", OpAtomicAnd, OpAtomicAnd},
	{"InterlockedOr", OpAtomicOr, OpAtomicOr},
	{"InterlockedXor", OpAtomicXor, OpAtomicXor},
	{"InterlockedMin", OpAtomicSMin, OpAtomicUMin},
	{"InterlockedMax", OpAtomicSMax, OpAtomicUMax},
	{"InterlockedExchange", OpAtomicExchange, OpAtomicExchange},
	{"InterlockedCompareExchange", OpAtomicCompareExchange, OpAtomicCompareExchange},
	{"InterlockedCompareStore", OpAtomicCompareExchange, OpAtomicCompareExchange},
};

} // namespace

uint32_t FEmitter::Barrier(const FValue& Node, const FArguments&)
{
	const std::string_view Name = Node.Name;
	if (Program.Stage != EStage::Compute && !Name.starts_with("Device"))
	{
		Fail(Node.Place, "'" + std::string(Name) + "': only the threads of a compute shader have groups");
	}
	const bool bGroup = Name.starts_with("Group");
	const uint32_t Memory = bGroup ? MemoryGroup : Name.starts_with("All") ? MemoryAll : MemoryDevice;
	const uint32_t Scope = Module.Uint(bGroup ? ScopeWorkgroup : ScopeDevice);
	Name.ends_with("Sync") ? Do(OpControlBarrier, {Module.Uint(ScopeWorkgroup), Scope, Module.Uint(Memory)})
						   : Do(OpMemoryBarrier, {Scope, Module.Uint(Memory)});
	return 0;
}

uint32_t FEmitter::WaveInput(uint32_t BuiltIn, const char* Name)
{
	uint32_t& Id = BuiltIns[BuiltIn];
	if (!Id)
	{
		Id = Module.Global(Module.Uint(), StorageInput, Name);
		Module.Decorate(Id, DecorationBuiltIn, {BuiltIn});
		Interface.push_back(Id);
	}
	return Op(OpLoad, Module.Uint(), {Id});
}

uint32_t FEmitter::Wave(const FValue& Node, const FArguments& In)
{
	bWaves = true;
	const std::string_view Name = Node.Name;
	const uint32_t Scope = Module.Uint(ScopeSubgroup);
	const uint32_t Bool = Module.Bool();
	const uint32_t Uint = Module.Uint();
	if (Name == "WaveGetLaneCount")
	{
		return WaveInput(BuiltInSubgroupSize, "@WaveLaneCount");
	}
	if (Name == "WaveGetLaneIndex")
	{
		return WaveInput(BuiltInSubgroupLocalInvocationId, "@WaveLaneIndex");
	}
	if (Name == "WaveIsFirstLane")
	{
		return Op(OpGroupNonUniformElect, Bool, {Scope});
	}
	if (Name == "WaveActiveAllTrue" || Name == "WaveActiveAnyTrue")
	{
		Module.Capability(CapabilityGroupNonUniformVote);
		return Op(Name == "WaveActiveAllTrue" ? OpGroupNonUniformAll : OpGroupNonUniformAny, Bool, {Scope, In[0].Id});
	}
	if (Name == "WaveActiveBallot" || Name == "WaveActiveCountBits" || Name == "WavePrefixCountBits")
	{
		Module.Capability(CapabilityGroupNonUniformBallot);
		const uint32_t Ballot = Op(OpGroupNonUniformBallot, VectorOf(EScalar::Uint, 4), {Scope, In[0].Id});
		const uint32_t Group = Name == "WavePrefixCountBits" ? GroupExclusive : GroupReduce;
		return Name == "WaveActiveBallot" ? Ballot : Op(OpGroupNonUniformBallotBitCount, Uint, {Scope, Group, Ballot});
	}
	if (Name == "QuadAny" || Name == "QuadAll")
	{
		Module.Capability(CapabilityGroupNonUniformQuad);
		uint32_t Result = In[0].Id;
		for (uint32_t i = 0; i < 3; ++i)
		{
			const uint32_t Other = Op(OpGroupNonUniformQuadSwap, Bool, {Scope, In[0].Id, Module.Uint(i)});
			Result = Op(Name == "QuadAny" ? OpLogicalOr : OpLogicalAnd, Bool, {Result, Other});
		}
		return Result;
	}
	if (Name == "WaveActiveAllEqual")
	{
		return ByScalars(Node.Type, In, [&](const FType* Part, const FWords& Ids) { return WaveOf(Name, Part, Ids); });
	}
	return ByRows(Node.Type, In, [&](const FType* Part, const FWords& Ids) { return WaveOf(Name, Part, Ids); });
}

/** On a scalar or a vector. */
uint32_t FEmitter::WaveOf(std::string_view Name, const FType* Type, const FWords& Ids)
{
	const uint32_t Scope = Module.Uint(ScopeSubgroup);
	const uint32_t Id = TypeOf(Type);
	const auto Row = std::ranges::find(EmitWaves, Name, &FEmitWave::Name);
	if (Row != std::end(EmitWaves))
	{
		Module.Capability(CapabilityGroupNonUniformArithmetic);
		const ENumber Kind = KindOf(Type->Scalar);
		const uint16_t Opcode = Kind == ENumber::Real     ? Row->Real
								: Kind == ENumber::Signed ? Row->Signed
														  : Row->Unsigned;
		return Op(Opcode, Id, {Scope, Row->Group, Ids[0]});
	}
	if (Name == "WaveActiveAllEqual")
	{
		Module.Capability(CapabilityGroupNonUniformVote);
		return Op(OpGroupNonUniformAllEqual, Id, {Scope, Ids[0]});
	}
	if (Name == "WaveReadLaneAt")
	{
		Module.Capability(CapabilityGroupNonUniformShuffle);
		return Op(OpGroupNonUniformShuffle, Id, {Scope, Ids[0], Ids[1]});
	}
	if (Name == "WaveReadLaneFirst")
	{
		Module.Capability(CapabilityGroupNonUniformBallot);
		return Op(OpGroupNonUniformBroadcastFirst, Id, {Scope, Ids[0]});
	}
	if (Name.starts_with("Quad"))
	{
		Module.Capability(CapabilityGroupNonUniformQuad);
		const uint32_t Direction = Name == "QuadReadAcrossX" ? 0 : Name == "QuadReadAcrossY" ? 1 : 2;
		return Name == "QuadReadLaneAt" ? Op(OpGroupNonUniformQuadBroadcast, Id, {Scope, Ids[0], Ids[1]})
										: Op(OpGroupNonUniformQuadSwap, Id, {Scope, Ids[0], Module.Uint(Direction)});
	}
	Fail(Current, "'" + std::string(Name) + "' does not run on the CPU tier; use WaveReadLaneAt and WavePrefixSum");
}

uint32_t FEmitter::Atomic(std::string_view Name, ENumber Kind, uint32_t Type, uint32_t Pointer, const FWords& Values)
{
	const auto Row = std::ranges::find(EmitAtomics, Name, &FEmitAtomic::Name);
	if (Row == std::end(EmitAtomics))
	{
		Fail(Current, "'" + std::string(Name) + "' works on int, uint, int64_t and uint64_t here, without a suffix");
	}
	const uint32_t Scope = Module.Uint(ScopeDevice);
	const uint32_t Relaxed = Module.Uint(0);
	const uint16_t Opcode = Kind == ENumber::Signed ? Row->Signed : Row->Unsigned;
	// A comparison has the new value before the one that it compares with.
	return Values.size() > 1 ? Op(Opcode, Type, {Pointer, Scope, Relaxed, Relaxed, Values[1], Values[0]})
							 : Op(Opcode, Type, {Pointer, Scope, Relaxed, Values[0]});
}

/** A float in a buffer of words keeps its bits. */
uint32_t FEmitter::Bitwise(uint32_t Id, EScalar From, EScalar To)
{
	const bool bBits = IsReal(From) != IsReal(To) && Bits(From) == Bits(To);
	return bBits ? Op(OpBitcast, ScalarType(To), {Id}) : ConvertScalars(Id, From, To, 1);
}

void FEmitter::AtomicOn(const FTarget& Target, std::string_view Name, ENumber Kind, const FValue& Node, size_t First)
{
	const EScalar Scalar = Target.Type->Scalar;
	const uint32_t Type = ScalarType(Scalar);
	if (Bits(Scalar) == 64)
	{
		Module.Capability(CapabilityInt64Atomics);
	}
	const size_t Count = Name.find("Compare") != std::string_view::npos ? 2 : 1;
	FWords Values;
	for (size_t i = First; i < First + Count; ++i)
	{
		const FValue& Operand = *Node.Operands.at(i);
		Values.push_back(Bitwise(Value(Operand), Operand.Type->Scalar, Scalar));
	}
	const auto On = [&](uint32_t Pointer)
	{
		return Atomic(Name, Kind, Type, Pointer, Values);
	};
	uint32_t Old = 0;
	if (Target.Kind == FTarget::EKind::Texel)
	{
		const auto OnTexel = [&](FLeaf& Leaf)
		{
			const uint32_t Pointer = Module.Pointer(StorageImage, Type);
			return On(Op(OpImageTexelPointer, Pointer, {IdOf(Leaf), Target.At, Module.Uint(0)}));
		};
		Old = ForEach(Target.Objects, Type, OnTexel);
	}
	else
	{
		Old = Target.Base ? On(PointerTo(Target, Target.Base, Target.Storage))
						  : ForEach(Target.Objects, Type,
								[&](FLeaf& Leaf) { return On(PointerTo(Target, IdOf(Leaf), Target.Storage)); });
	}
	if (Node.Operands.size() > First + Count)
	{
		const FValue& Argument = *Node.Operands[First + Count];
		Store(Place(Argument), Bitwise(Old, Scalar, Argument.Type->Scalar));
	}
}

uint32_t FEmitter::Interlocked(const FValue& Node)
{
	const FTarget Target = Place(*Node.Operands[0]);
	const bool bWhole = Target.Parts.empty() && !Target.Component && Target.Bits.Count == 0 &&
						Target.Type->IsNumeric() && !Target.Type->IsMatrix() && Target.Type->Columns == 1 &&
						Target.Kind != FTarget::EKind::Scalars;
	const bool bShared =
		Target.Kind == FTarget::EKind::Texel || Target.Storage == StorageUniform || Target.Storage == StorageWorkgroup;
	if (!bWhole || !bShared)
	{
		Fail(Node.Place,
			"'" + std::string(Node.Name) +
				"' works on a single number of a groupshared variable, a buffer or a texture that can be written");
	}
	AtomicOn(Target, Node.Name, KindOf(Target.Type->Scalar), Node, 1);
	return 0;
}

} // namespace Drydock::Hlsl
