// Methods of textures, and of structured buffers.
#include "HlslEmitterImpl.h"

#include "HlslIntrinsics.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

bool IsEmitCube(EObject Object)
{
	return Object == EObject::TextureCube || Object == EObject::TextureCubeArray;
}

bool IsEmitMultisampled(EObject Object)
{
	return Object == EObject::Texture2DMS || Object == EObject::Texture2DMSArray;
}

} // namespace

uint32_t FEmitter::Method(const FValue& Node)
{
	const EObject Object = Node.Operands[0]->Type->Object;
	const std::string_view Name = Node.Name;
	if (Name == "GetDimensions" || Name == "Length")
	{
		return GetSizes(Node);
	}
	if (Object == EObject::ByteAddressBuffer || Object == EObject::RWByteAddressBuffer)
	{
		return ByteMethod(Node);
	}
	if (Name.ends_with("Counter") || Name == "Append" || Name == "Consume")
	{
		return CountElements(Node);
	}
	if (Name.starts_with("Sample") || Name.starts_with("CalculateLevel"))
	{
		return Sample(Node);
	}
	if (Name.starts_with("Gather"))
	{
		return Gather(Node);
	}
	if (Name == "Load")
	{
		return IsStructured(Object) || IsWideBuffer(Node.Operands[0]->Type) ? Load(ElementPlace(Node)) : Fetch(Node);
	}
	Fail(Node.Place, "the method '" + std::string(Name) + "' does not run on the CPU tier");
}

/** The position of each argument of a Sample*. Source: Microsoft's reference of texture objects. */
FEmitter::FSampling FEmitter::ReadSampling(const FValue& Node)
{
	FSampling Result;
	const std::string_view Name = Node.Name;
	size_t Next = 3;
	const auto Take = [&](bool bWanted)
	{
		return bWanted && Next < Node.Operands.size() ? Value(*Node.Operands[Next++]) : 0u;
	};
	Result.At = Value(*Node.Operands.at(2));
	Result.Reference = Take(Name.find("Cmp") != std::string_view::npos);
	Result.Bias = Take(Name.ends_with("Bias"));
	const bool bGrad = Name.ends_with("Grad");
	Result.GradX = Take(bGrad);
	Result.GradY = Take(bGrad);
	Result.Lod = Name.ends_with("LevelZero") ? RealConstant(EScalar::Float, 0) : Take(Name.ends_with("Level"));
	const bool bGather = Name.starts_with("Gather");
	const bool bStatus = Next < Node.Operands.size() && Node.Operands.back()->bPlace &&
						 Next + 1 == Node.Operands.size() && Node.Operands.back()->Type->Scalar == EScalar::Uint;
	if (bGather)
	{
		return Result; // offsets are read there
	}
	Result.Offset = Take(!IsEmitCube(Node.Operands[0]->Type->Object) && !bStatus);
	const bool bClamps = !Result.Lod && Next < Node.Operands.size() && IsReal(Node.Operands[Next]->Type->Scalar);
	Result.Clamp = Take(bClamps);
	if (Next < Node.Operands.size())
	{
		Fail(Node.Place, "no texture is tiled here, so that a sample has no status; leave that argument out");
	}
	return Result;
}

/** Work with the texture and its sampler as one. */
uint32_t FEmitter::OnImage(const FValue& Node, uint32_t Type, const std::function<uint32_t(uint32_t Pair)>& Work)
{
	const FObjectSet Textures = Object(*Node.Operands[0]);
	const FObjectSet Samplers = Object(*Node.Operands[1]);
	const auto OnPair = [&](FLeaf& Texture, FLeaf& Sampler)
	{
		const uint32_t Image = ImageType(Texture.Type);
		const uint32_t A = Op(OpLoad, Image, {IdOf(Texture)});
		const uint32_t B = Op(OpLoad, Module.Intern(OpTypeSampler, {}), {IdOf(Sampler)});
		return Work(Op(OpSampledImage, Module.Intern(OpTypeSampledImage, {Image}), {A, B}));
	};
	return ForEach(Textures, Type,
		[&](FLeaf& Texture)
		{ return ForEach(Samplers, Type, [&](FLeaf& Sampler) { return OnPair(Texture, Sampler); }); });
}

void FEmitter::AddOffset(FWords& Words, uint32_t& Mask, uint32_t Offset)
{
	if (Offset)
	{
		const bool bConstant = Module.IsConstant(Offset);
		if (!bConstant)
		{
			Module.Capability(CapabilityImageGatherExtended);
		}
		Mask |= bConstant ? ImageConstOffset : ImageOffset;
		Words.push_back(Offset);
	}
}

uint32_t FEmitter::Sample(const FValue& Node)
{
	const FType* const Texture = Node.Operands[0]->Type;
	FSampling In = ReadSampling(Node);
	if (Node.Name.starts_with("CalculateLevel"))
	{
		Module.Capability(CapabilityImageQuery);
		const uint32_t Type = VectorOf(EScalar::Float, 2);
		const uint32_t Levels = OnImage(Node, Type,
			[&](uint32_t Pair) {
				return Op(OpImageQueryLod, Type, {Pair, In.At});
			});
		return ExtractAt(Levels, ScalarType(EScalar::Float), {Node.Name.ends_with("Unclamped") ? 1u : 0u});
	}
	const bool bChooses = !In.Lod && !In.GradX;
	if (bChooses && Program.Stage != EStage::Pixel && !In.Bias && !In.Clamp)
	{
		In.Lod = RealConstant(EScalar::Float, 0); // the first mip: there are no derivatives
	}
	uint32_t Mask = 0;
	FWords More;
	const auto Add = [&](uint32_t Bit, uint32_t Id)
	{
		if (Id)
		{
			Mask |= Bit;
			More.push_back(Id);
		}
	};
	Add(ImageBias, In.Bias);
	Add(ImageLod, In.Lod);
	Add(ImageGrad, In.GradX);
	Add(ImageGrad, In.GradY);
	AddOffset(More, Mask, In.Offset);
	Add(ImageMinLod, In.Clamp);
	if (In.Clamp)
	{
		Module.Capability(CapabilityMinLod);
	}
	const EScalar Scalar = Texture->Element ? TexelScalar(Texture->Element->Scalar) : EScalar::Float;
	const uint32_t Type = In.Reference ? ScalarType(Scalar) : VectorOf(Scalar, 4);
	const bool bExplicit = In.Lod || In.GradX;
	const uint16_t Opcode = In.Reference ? (bExplicit ? OpImageSampleDrefExplicitLod : OpImageSampleDrefImplicitLod)
										 : (bExplicit ? OpImageSampleExplicitLod : OpImageSampleImplicitLod);
	const uint32_t Id = OnImage(Node, Type,
		[&](uint32_t Pair)
		{
			FWords Words = {Pair, In.At};
			if (In.Reference)
			{
				Words.push_back(In.Reference);
			}
			if (Mask)
			{
				Words.push_back(Mask);
				Words.insert(Words.end(), More.begin(), More.end());
			}
			return Op(Opcode, Type, Words);
		});
	return In.Reference ? ConvertScalars(Id, Scalar, Node.Type->Scalar, 1) : CutTexel(Id, Texture, Node.Type);
}

uint32_t FEmitter::Gather(const FValue& Node)
{
	const std::string_view Name = Node.Name;
	const FType* const Texture = Node.Operands[0]->Type;
	const FSampling In = ReadSampling(Node);
	const int32_t Channel = Name.ends_with("Green") ? 1 : Name.ends_with("Blue") ? 2 : Name.ends_with("Alpha") ? 3 : 0;
	if (In.Reference && Channel != 0)
	{
		Fail(Node.Place, "a comparison reads the first channel: use GatherCmp");
	}
	FWords Offsets;
	for (size_t i = In.Reference ? 4 : 3; i < Node.Operands.size(); ++i)
	{
		if (KindOf(Node.Operands[i]->Type->Scalar) != ENumber::Signed)
		{
			Fail(Node.Place, "no texture is tiled here, so that a gather has no status; leave that argument out");
		}
		Offsets.push_back(Value(*Node.Operands[i]));
	}
	const EScalar Scalar = Texture->Element ? TexelScalar(Texture->Element->Scalar) : EScalar::Float;
	const uint32_t Type = VectorOf(Scalar, 4);
	const auto Do1 = [&](uint32_t Mask, const FWords& More)
	{
		return OnImage(Node, Type,
			[&](uint32_t Pair)
			{
				FWords Words = {Pair, In.At, In.Reference ? In.Reference : Module.Int(Channel)};
				if (Mask)
				{
					Words.push_back(Mask);
					Words.insert(Words.end(), More.begin(), More.end());
				}
				return Op(In.Reference ? OpImageDrefGather : OpImageGather, Type, Words);
			});
	};
	uint32_t Id = 0;
	const bool bConstant = std::ranges::all_of(Offsets, [this](uint32_t Offset) { return Module.IsConstant(Offset); });
	if (Offsets.size() == 4 && bConstant)
	{
		Module.Capability(CapabilityImageGatherExtended);
		const uint32_t Array = Module.Intern(OpTypeArray, {VectorOf(EScalar::Int, 2), Module.Uint(4)});
		Id = Do1(ImageConstOffsets, {Construct(Array, Offsets)});
	}
	else if (Offsets.size() == 4) // each moves its own texel
	{
		FWords Parts;
		for (uint32_t i = 0; i < 4; ++i)
		{
			uint32_t Mask = 0;
			FWords More;
			AddOffset(More, Mask, Offsets[i]);
			Parts.push_back(ExtractAt(Do1(Mask, More), ScalarType(Scalar), {i}));
		}
		Id = Construct(Type, Parts);
	}
	else
	{
		uint32_t Mask = 0;
		FWords More;
		AddOffset(More, Mask, Offsets.empty() ? 0 : Offsets[0]);
		Id = Do1(Mask, More);
	}
	return Convert(Id, Types.Vector(Scalar, 4), Node.Type);
}

/** Load of a texture or a typed buffer. The position of a texture that is only read has the level behind it. */
uint32_t FEmitter::Fetch(const FValue& Node)
{
	const FType* const Of = Node.Operands[0]->Type;
	const bool bWritable = IsWritable(Of->Object);
	const bool bMultisampled = IsEmitMultisampled(Of->Object);
	const bool bLevel = IsTexture(Of->Object) && !bWritable && !bMultisampled;
	const FObjectSet Textures = Object(*Node.Operands[0]);
	const FType* const At = Node.Operands[1]->Type;
	const uint32_t Position = Value(*Node.Operands[1]);
	uint32_t Mask = 0;
	FWords More;
	uint32_t Coordinates = Position;
	if (bLevel)
	{
		const uint32_t Count = At->Columns - 1u;
		std::vector<uint8_t> Parts;
		for (uint32_t i = 0; i < Count; ++i)
		{
			Parts.push_back(uint8_t(i));
		}
		Coordinates = Shuffle(Position, At->Scalar, At->Columns, Parts);
		Mask = ImageLod;
		More.push_back(Extract(Position, At, Count));
	}
	const size_t OffsetAt = bMultisampled ? 3 : 2;
	if (OffsetAt < Node.Operands.size() && bLevel)
	{
		if (KindOf(Node.Operands[OffsetAt]->Type->Scalar) != ENumber::Signed || Node.Operands.size() > OffsetAt + 1)
		{
			Fail(Node.Place, "no texture is tiled here, so that a load has no status; leave that argument out");
		}
		AddOffset(More, Mask, Value(*Node.Operands[OffsetAt]));
	}
	else if (OffsetAt < Node.Operands.size() && !bMultisampled)
	{
		Fail(Node.Place, "no buffer is tiled here, so that a load has no status; leave that argument out");
	}
	if (bMultisampled)
	{
		Mask = ImageSample;
		More.push_back(Value(*Node.Operands[2]));
	}
	const EScalar Scalar = Of->Element ? TexelScalar(Of->Element->Scalar) : EScalar::Float;
	const uint32_t Id = ForEach(Textures, VectorOf(Scalar, 4),
		[&](FLeaf& Leaf)
		{
			FWords Words = {Op(OpLoad, ImageType(Leaf.Type), {IdOf(Leaf)}), Coordinates};
			if (Mask)
			{
				Words.push_back(Mask);
				Words.insert(Words.end(), More.begin(), More.end());
			}
			return Op(bWritable ? OpImageRead : OpImageFetch, VectorOf(Scalar, 4), Words);
		});
	return CutTexel(Id, Of, Node.Type);
}

uint32_t FEmitter::GetSizes(const FValue& Node)
{
	const FType* const Of = Node.Operands[0]->Type;
	const EObject Kind = Of->Object;
	const FObjectSet Set = Object(*Node.Operands[0]);
	const uint32_t Uint = Module.Uint();
	size_t Next = 1;
	const auto Give = [&](uint32_t Id)
	{
		const FValue& Argument = *Node.Operands.at(Next++);
		Store(Place(Argument), Convert(Id, Types.Scalar(EScalar::Uint), Argument.Type));
	};
	const bool bBytes = Kind == EObject::ByteAddressBuffer || Kind == EObject::RWByteAddressBuffer;
	if (bBytes || IsStructured(Kind) || IsWideBuffer(Of))
	{
		const uint32_t Length = ForEach(Set, Uint,
			[&](FLeaf& Leaf) {
				return Op(OpArrayLength, Uint, {IdOf(Leaf), 0});
			});
		Give(bBytes ? Op(OpIMul, Uint, {Length, Module.Uint(4)}) : Length);
		if (Next < Node.Operands.size())
		{
			Give(Module.Uint(GetLayout(Types, Of->Element, ELayout::Structured).Size));
		}
		return 0;
	}
	Module.Capability(CapabilityImageQuery);
	const uint32_t Count =
		Hlsl::GetDimensions(Kind) - (Kind == EObject::TextureCube || Kind == EObject::TextureCubeArray ? 1 : 0);
	const bool bLevels = IsTexture(Kind) && !IsWritable(Kind) && !IsEmitMultisampled(Kind);
	const bool bAsked = bLevels && Node.Operands.size() == Count + 3;
	uint32_t Level = Module.Int(0);
	if (bAsked)
	{
		const FValue& Argument = *Node.Operands[Next++];
		Level = Value(Argument);
	}
	const uint32_t Type = VectorOf(EScalar::Uint, Count);
	const auto LoadImage = [&](FLeaf& Leaf)
	{
		return Op(OpLoad, ImageType(Leaf.Type), {IdOf(Leaf)});
	};
	const uint32_t Size = ForEach(Set, Type,
		[&](FLeaf& Leaf)
		{
			return bLevels ? Op(OpImageQuerySizeLod, Type, {LoadImage(Leaf), Level})
						   : Op(OpImageQuerySize, Type, {LoadImage(Leaf)});
		});
	if (Node.Name == "Length")
	{
		return Size;
	}
	for (uint32_t i = 0; i < Count; ++i)
	{
		Give(Count == 1 ? Size : ExtractAt(Size, Uint, {i}));
	}
	if (Next < Node.Operands.size())
	{
		const uint16_t Opcode = bLevels ? OpImageQueryLevels : OpImageQuerySamples;
		Give(ForEach(Set, Uint, [&](FLeaf& Leaf) { return Op(Opcode, Uint, {LoadImage(Leaf)}); }));
	}
	return 0;
}

uint32_t FEmitter::CountElements(const FValue& Node)
{
	const std::string_view Name = Node.Name;
	const FType* const Element = Node.Operands[0]->Type->Element;
	const FObjectSet Set = Object(*Node.Operands[0]);
	const uint32_t Uint = Module.Uint();
	const bool bUp = Name == "Append" || Name == "IncrementCounter";
	const uint32_t Appended = Name == "Append" ? Value(*Node.Operands[1]) : 0;
	const auto On = [&](FLeaf& Leaf)
	{
		const uint32_t Pointer =
			Op(OpAccessChain, Module.Pointer(StorageUniform, Uint), {CounterOf(Leaf), Module.Int(0)});
		const uint32_t By = Module.Uint(bUp ? 1u : ~0u);
		const uint32_t Old = Op(OpAtomicIAdd, Uint, {Pointer, Module.Uint(1), Module.Uint(0), By});
		const uint32_t At = bUp ? Old : Op(OpIAdd, Uint, {Old, By});
		if (Name.ends_with("Counter"))
		{
			return At;
		}
		FTarget Target;
		Target.Type = Element;
		Target.Objects = {{&Leaf}, 0};
		Target.Storage = StorageUniform;
		Target.Layout = ELayout::Structured;
		Target.Chain = {Module.Int(0), At};
		if (Name == "Consume")
		{
			return Load(Target);
		}
		Store(Target, Appended);
		return 0u;
	};
	return ForEach(Set, Name == "Append" ? 0 : TypeOf(Node.Type), On);
}

} // namespace Drydock::Hlsl
