// Emits the things that are bound to a shader: constant buffers, and the variables of resources.
#include "HlslEmitterImpl.h"

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr size_t EmitMaxLeaves = 4096;

enum EEmitFormat : uint32_t // SPIR-V, section 3.11
{
	FormatRgba32f = 1,
	FormatR32f = 3,
	FormatRg32f = 6,
	FormatRgba32i = 21,
	FormatR32i = 24,
	FormatRg32i = 25,
	FormatRgba32ui = 30,
	FormatR32ui = 33,
	FormatRg32ui = 35,
};

struct FEmitImage
{
	uint32_t Dim;
	bool bArrayed;
	bool bMultisampled;
};

FEmitImage GetEmitImage(EObject Object)
{
	switch (Object)
	{
	case EObject::Texture1D:
	case EObject::RWTexture1D:
		return {Dim1D, false, false};
	case EObject::Texture1DArray:
	case EObject::RWTexture1DArray:
		return {Dim1D, true, false};
	case EObject::Texture2DArray:
	case EObject::RWTexture2DArray:
		return {Dim2D, true, false};
	case EObject::Texture2DMS:
		return {Dim2D, false, true};
	case EObject::Texture2DMSArray:
		return {Dim2D, true, true};
	case EObject::Texture3D:
	case EObject::RWTexture3D:
		return {Dim3D, false, false};
	case EObject::TextureCube:
		return {DimCube, false, false};
	case EObject::TextureCubeArray:
		return {DimCube, true, false};
	case EObject::Buffer:
	case EObject::RWBuffer:
		return {DimBuffer, false, false};
	default:
		return {Dim2D, false, false};
	}
}

uint32_t GetEmitFormat(EScalar Scalar, uint32_t Count)
{
	const size_t Size = Count > 2 ? 2 : Count - 1;
	constexpr uint32_t Reals[] = {FormatR32f, FormatRg32f, FormatRgba32f};
	constexpr uint32_t Ints[] = {FormatR32i, FormatRg32i, FormatRgba32i};
	constexpr uint32_t Uints[] = {FormatR32ui, FormatRg32ui, FormatRgba32ui};
	return Scalar == EScalar::Float ? Reals[Size] : Scalar == EScalar::Int ? Ints[Size] : Uints[Size];
}

} // namespace

void FEmitter::Bind(uint32_t Id)
{
	Module.Decorate(Id, DecorationDescriptorSet, {0});
	Module.Decorate(Id, DecorationBinding, {NextBinding++});
}

uint32_t FEmitter::BufferOf(const FBuffer& Buffer)
{
	const auto Known = Buffers.find(&Buffer);
	if (Known != Buffers.end())
	{
		return Known->second;
	}
	FWords Members;
	std::vector<size_t> Of;
	for (size_t i = 0; i < Buffer.Members.size(); ++i)
	{
		if (CountScalars(Buffer.Members[i]->Type) > 0)
		{
			Members.push_back(MemoryType(Buffer.Members[i]->Type, ELayout::Constants));
			Of.push_back(i);
		}
	}
	const uint32_t Struct = Module.MakeType(OpTypeStruct, Members);
	Module.Name(Struct, Buffer.Name);
	for (uint32_t i = 0; i < Of.size(); ++i)
	{
		const FVariable& Member = *Buffer.Members[Of[i]];
		Module.MemberName(Struct, i, Member.Name);
		DecorateMemory(Struct, i, Member.Type, Buffer.Offsets[Of[i]], ELayout::Constants);
	}
	Module.Decorate(Struct, Buffer.bTBuffer ? DecorationBufferBlock : DecorationBlock);
	const uint32_t Id = Module.Global(Struct, StorageUniform, "");
	Bind(Id);
	return Buffers[&Buffer] = Id;
}

/** Names the resources of a value: "A_2", "S_Member". */
void FEmitter::AddLeaves(const FType* Type, const std::string& Name, std::vector<FLeaf*>& List, const FPlace& Place)
{
	if (Type->IsArray()) // of all dimensions together
	{
		uint64_t Count = Type->Count;
		for (Type = Type->Element; Type->IsArray(); Type = Type->Element)
		{
			Count *= Type->Count;
		}
		for (uint64_t i = 0; i < Count; ++i)
		{
			AddLeaves(Type, Name + "_" + std::to_string(i), List, Place);
		}
	}
	else if (Type->IsStruct())
	{
		for (const FMember& Member : Type->Struct->Members)
		{
			AddLeaves(Member.Type, Name + "_" + Member.Name, List, Place);
		}
	}
	else if (Type->IsObject())
	{
		if (Leaves.size() >= EmitMaxLeaves)
		{
			Fail(Place, "more than " + std::to_string(EmitMaxLeaves) + " resources; declare smaller arrays of them");
		}
		const bool bWide = Type->Element && Type->Element->IsNumeric() && Bits(Type->Element->Scalar) == 64;
		if (bWide && IsTexture(Type->Object))
		{
			Fail(Place,
				GetName(Type) + " is not supported on the CPU tier: texels have 32 bits; use float, int or uint");
		}
		FLeaf& Leaf = Leaves.emplace_back();
		Leaf.Name = Name;
		Leaf.Type = Type;
		Leaf.Number = uint32_t(Leaves.size() - 1);
		List.push_back(&Leaf);
	}
	else
	{
		Fail(Place,
			"the struct of '" + Name +
				"' has numbers beside its resources, which a parameter of the shader cannot; declare them apart");
	}
}

void FEmitter::MakeLeaves()
{
	for (const FVariable* const Variable : Program.Resources)
	{
		const bool bUnbounded = Variable->Type->IsArray() && Variable->Type->Count == 0;
		if (!bUnbounded)
		{
			AddLeaves(Variable->Type, Variable->Name, LeavesOf[Variable], Variable->Place);
		}
	}
}

/** An element of an array without a size: its resources in order. */
FObjects FEmitter::UnboundedLeaves(const FVariable& Variable, uint32_t Index, const FPlace& Place)
{
	const FType* const Element = Variable.Type->Element;
	std::vector<FLeaf*>& List = Unbounded[{&Variable, Index}];
	if (List.empty())
	{
		const FType* Innermost = Element;
		while (Innermost->IsArray())
		{
			Innermost = Innermost->Element;
		}
		const uint32_t Count = CountObjects(Element);
		for (uint32_t i = 0; i < Count && Innermost->IsObject(); ++i)
		{
			AddLeaves(Innermost, Variable.Name + "_" + std::to_string(Index * Count + i), List, Place);
		}
	}
	FObjects Result;
	for (FLeaf* const Leaf : List)
	{
		Result.push_back({{Leaf}, 0});
	}
	return Result;
}

/** Typed buffers of 64 bits lie in memory as structured ones. */
bool FEmitter::IsWideBuffer(const FType* Type) const
{
	const bool bTyped = Type->Object == EObject::Buffer || Type->Object == EObject::RWBuffer;
	return bTyped && Type->Element && Type->Element->IsNumeric() && Bits(Type->Element->Scalar) == 64;
}

/** Texels are read and written as 32 bits, whatever the format. */
EScalar FEmitter::TexelScalar(EScalar Scalar)
{
	const ENumber Kind = KindOf(Scalar);
	return Kind == ENumber::Real ? EScalar::Float : Kind == ENumber::Signed ? EScalar::Int : EScalar::Uint;
}

uint32_t FEmitter::ImageType(const FType* Type)
{
	const FEmitImage Image = GetEmitImage(Type->Object);
	const bool bStorage = IsWritable(Type->Object);
	const EScalar Scalar = Type->Element ? TexelScalar(Type->Element->Scalar) : EScalar::Float;
	const uint32_t Count = Type->Element ? Type->Element->Columns : 4;
	const uint32_t Format = bStorage || Image.Dim == DimBuffer ? GetEmitFormat(Scalar, Count) : 0;
	if (Format == FormatRg32f || Format == FormatRg32i || Format == FormatRg32ui)
	{
		Module.Capability(CapabilityStorageImageExtendedFormats);
	}
	if (Image.Dim == Dim1D)
	{
		Module.Capability(bStorage ? CapabilityImage1D : CapabilitySampled1D);
	}
	if (Image.Dim == DimBuffer)
	{
		Module.Capability(bStorage ? CapabilityImageBuffer : CapabilitySampledBuffer);
	}
	if (Image.Dim == DimCube && Image.bArrayed)
	{
		Module.Capability(CapabilitySampledCubeArray);
	}
	return Module.Intern(OpTypeImage, {ScalarType(Scalar), Image.Dim, 0, Image.bArrayed ? 1u : 0u,
										  Image.bMultisampled ? 1u : 0u, bStorage ? 2u : 1u, Format});
}

/** A block with a row of elements. Type: as DXC names it, by which the tier knows the kind of a buffer. */
uint32_t FEmitter::MakeBuffer(const std::string& Name, const std::string& Type, const FType* Element, bool bReadOnly)
{
	const uint32_t Inner = MemoryType(Element, ELayout::Structured);
	const uint32_t Array =
		MemoryArray(Inner, 0, GetLayout(Types, Element, ELayout::Structured).Size, ELayout::Structured);
	const uint32_t Struct = Module.MakeType(OpTypeStruct, {Array});
	Module.Name(Struct, Type);
	Module.MemberName(Struct, 0, "@data");
	if (bReadOnly)
	{
		Module.DecorateMember(Struct, 0, DecorationNonWritable);
	}
	DecorateMemory(Struct, 0, Element, 0, ELayout::Structured);
	Module.Decorate(Struct, DecorationBufferBlock);
	const uint32_t Id = Module.Global(Struct, StorageUniform, Name);
	Bind(Id);
	return Id;
}

/** The members of a ConstantBuffer's struct, named after the variable. */
uint32_t FEmitter::MakeConstantBlock(const FLeaf& Leaf)
{
	const FStructType& Of = *Leaf.Type->Element->Struct;
	const std::vector<uint32_t> Offsets = GetOffsets(Types, Of, ELayout::Constants);
	FWords Members;
	std::vector<size_t> Kept;
	for (size_t i = 0; i < Of.Members.size(); ++i)
	{
		if (CountScalars(Of.Members[i].Type) > 0)
		{
			Members.push_back(MemoryType(Of.Members[i].Type, ELayout::Constants));
			Kept.push_back(i);
		}
	}
	const uint32_t Struct = Module.MakeType(OpTypeStruct, Members);
	Module.Name(Struct, Leaf.Name);
	for (uint32_t i = 0; i < Kept.size(); ++i)
	{
		const FMember& Member = Of.Members[Kept[i]];
		Module.MemberName(Struct, i, Member.Name);
		DecorateMemory(Struct, i, Member.Type, Offsets[Kept[i]], ELayout::Constants);
	}
	Module.Decorate(Struct, Leaf.Type->Object == EObject::TextureBuffer ? DecorationBufferBlock : DecorationBlock);
	const uint32_t Id = Module.Global(Struct, StorageUniform, Leaf.Name);
	Bind(Id);
	return Id;
}

uint32_t FEmitter::IdOf(FLeaf& Leaf)
{
	if (Leaf.Id)
	{
		return Leaf.Id;
	}
	const EObject Object = Leaf.Type->Object;
	const std::string Type = "type." + std::string(Leaf.Type->ObjectName);
	const bool bBytes = Object == EObject::ByteAddressBuffer || Object == EObject::RWByteAddressBuffer;
	const bool bSampler = Object == EObject::SamplerState || Object == EObject::SamplerComparisonState;
	if (bBytes || IsStructured(Object) || IsWideBuffer(Leaf.Type))
	{
		const FType* const Element = bBytes ? Types.Scalar(EScalar::Uint) : Leaf.Type->Element;
		return Leaf.Id = MakeBuffer(Leaf.Name, Type, Element, !IsWritable(Object));
	}
	if (Object == EObject::ConstantBuffer || Object == EObject::TextureBuffer)
	{
		return Leaf.Id = MakeConstantBlock(Leaf);
	}
	const uint32_t Of = bSampler ? Module.Intern(OpTypeSampler, {}) : ImageType(Leaf.Type);
	Leaf.Id = Module.Global(Of, StorageUniformConstant, Leaf.Name);
	Bind(Leaf.Id);
	return Leaf.Id;
}

uint32_t FEmitter::CounterOf(FLeaf& Leaf)
{
	if (!Leaf.Counter)
	{
		const uint32_t Struct = Module.MakeType(OpTypeStruct, {Module.Uint()});
		Module.Name(Struct, Leaf.Name + "@count");
		Module.MemberName(Struct, 0, "@count");
		Module.DecorateMember(Struct, 0, DecorationOffset, {0});
		Module.Decorate(Struct, DecorationBufferBlock);
		Leaf.Counter = Module.Global(Struct, StorageUniform, Leaf.Name + "@count");
		Bind(Leaf.Counter);
		Module.DecorateCounter(IdOf(Leaf), Leaf.Counter);
	}
	return Leaf.Counter;
}

/** The same memory as numbers of another width. Its name has the word Of. */
uint32_t FEmitter::ViewOf(FLeaf& Leaf, const std::string& Of, EScalar Scalar)
{
	uint32_t& Id = Leaf.Views[Of];
	if (!Id)
	{
		IdOf(Leaf);
		Id = MakeBuffer(Leaf.Name + GBufferViewMark + Of, "type.RWStructuredBuffer", Types.Scalar(Scalar), false);
	}
	return Id;
}

} // namespace Drydock::Hlsl
