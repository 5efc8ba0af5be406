// Instructions on textures and typed buffers. Textures are read by the library's sampler of one lane, which goes texel
// by texel: the kernels' lane code is not its own judge.
#pragma once

#include "SpirvThread.h"

#include "Lanes.h"

namespace Drydock
{

using namespace Spirv;

template<typename Real>
const FKernelTexture& TSpirvThread<Real>::TextureOf(const FSpirvStep& Step, size_t Operand) const
{
	const uint32_t Variable = Bits(Step, Operand);
	const bool bStorage = Program.Module.GetType(Resource(Step, Operand).Type).bStorageImage;
	return ViewOf(bStorage ? Args->RWTextures : Args->Textures, Variable);
}

template<typename Real>
const FKernelBuffer& TSpirvThread<Real>::BufferOf(const FSpirvStep& Step, size_t Operand) const
{
	const uint32_t Variable = Bits(Step, Operand);
	const bool bStorage = Program.Module.GetType(Resource(Step, Operand).Type).bStorageImage;
	return ViewOf(bStorage ? Args->RWBuffers : Args->Buffers, Variable);
}

/** What a texture's instruction is told besides its coordinates: where the mask of it stands, or past the end. */
inline size_t GetImageOperands(uint16_t Op)
{
	return Op == OpImageGather || Op == OpImageWrite ? 3 : 2;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteSample(const FSpirvStep& Step)
{
	using FSampling = Lanes::TSampling<Real, 1>;
	const FSpirvInstruction& I = *Step.I;
	const FSpirvType& Pair = Program.Module.GetValueType(I.Operands[0]);
	const FSpirvType& Image = Program.Module.GetType(Pair.Element);
	const size_t MaskAt = GetImageOperands(I.Op);
	const uint32_t Mask = I.Operands.size() > MaskAt ? I.Operands[MaskAt] : 0;
	const size_t Offset = Mask & (ImageConstOffset | ImageOffset) ? MaskAt + (Mask & ImageLod ? 2 : 1) : 0;
	const FKernelTexture& Texture = ViewOf(Args->Textures, Bits(Step, 0, 0));
	const FKernelSampler& Sampler = ViewOf(Args->Samplers, Bits(Step, 0, 1));
	const auto Coordinate = [&](uint32_t Index)
	{
		const Real Value = Index < SizeOf(Step, 1) ? GetValue(Step, 1, Index) : Real(0);
		const bool bMoved = Offset && Index < SizeOf(Step, Offset);
		const FKernelMip& Mip = Texture.Mips[0]; // the only one that kernels sample with an offset
		const int32_t Size = Index == 0 ? Mip.SizeX : Index == 1 ? Mip.SizeY : Mip.SizeZ;
		return bMoved ? Value + Real(int32_t(Bits(Step, Offset, Index))) / Real(Size) : Value;
	};
	const Real U = Coordinate(0);
	const Real V = Coordinate(1);
	const Real W = Coordinate(2);
	const Real Level = Mask & ImageLod ? GetValue(Step, MaskAt + 1, 0) : Real(0);
	Real Out[4] = {};
	if (I.Op == OpImageGather)
	{
		FSampling::Gather2D(Texture, Sampler, &U, &V, int32_t(Bits(Step, 2)), Out);
	}
	else if (Image.Dim == Dim3D)
	{
		FSampling::Sample3D(Texture, Sampler, &U, &V, &W, &Level, true, Out);
	}
	else
	{
		FSampling::Sample2D(Texture, Sampler, &U, &V, Image.bArrayed ? &W : nullptr, &Level, true, Out);
	}
	for (uint32_t c = 0; c < 4 && c < Step.Size; ++c)
	{
		Result(Step)[c] = ToSpirvWord<Real>(Out[c]);
	}
	if (Observer && Level > Real(Texture.NumMips - 1))
	{
		const int64_t Asked = Level < Real(1000) ? int64_t(std::ceil(double(Level))) : 1000;
		Fault(Step, {ESpirvFault::Level, Resource(Step, 0).Name, {0, 0, 0, Asked}, {Texture.NumMips}, false, false});
	}
	++Taps;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteImageLoad(const FSpirvStep& Step)
{
	using FSampling = Lanes::TSampling<Real, 1>;
	const FSpirvInstruction& I = *Step.I;
	const FSpirvType& Image = Program.Module.GetValueType(I.Operands[0]);
	const bool bInteger = Program.Module.GetType(Image.Element).Kind != ESpirvType::Float;
	const uint32_t Mask = I.Operands.size() > 2 ? I.Operands[2] : 0;
	const size_t Offset = Mask & (ImageConstOffset | ImageOffset) ? (Mask & ImageLod ? 4 : 3) : 0;
	Real Out[4] = {};
	uint32_t UintOut[4] = {};
	int32_t At[4] = {};
	for (uint32_t i = 0; i < 3 && i < SizeOf(Step, 1); ++i)
	{
		const uint32_t Moved = Offset && i < SizeOf(Step, Offset) ? Bits(Step, Offset, i) : 0;
		At[i] = int32_t(Bits(Step, 1, i) + Moved);
	}
	At[3] = Mask & ImageLod ? int32_t(Bits(Step, 3)) : 0;
	if (Image.Dim == DimBuffer)
	{
		const uint32_t Index = uint32_t(At[0]);
		const FKernelBuffer& Buffer = BufferOf(Step, 0);
		bInteger ? FSampling::LoadTypedUint(Buffer, &Index, UintOut) : FSampling::LoadTyped(Buffer, &Index, Out);
		if (Observer)
		{
			CheckElement(Step, Buffer, Index, false);
		}
	}
	else
	{
		const int32_t* const Depth = Image.Dim == Dim3D || Image.bArrayed ? &At[2] : nullptr;
		const FKernelTexture& Texture = TextureOf(Step, 0);
		bInteger ? FSampling::LoadUint(Texture, &At[0], &At[1], Depth, &At[3], true, UintOut)
				 : FSampling::Load(Texture, &At[0], &At[1], Depth, &At[3], true, Out);
		if (Observer)
		{
			At[2] = Depth ? At[2] : 0;
			CheckTexel(Step, Texture, At, false);
		}
	}
	for (uint32_t c = 0; c < 4 && c < Step.Size; ++c)
	{
		Result(Step)[c] = bInteger ? FWord(UintOut[c]) : ToSpirvWord<Real>(Out[c]);
	}
	++Taps;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteImageWrite(const FSpirvStep& Step)
{
	using FSampling = Lanes::TSampling<Real, 1>;
	const FSpirvType& Image = Program.Module.GetValueType(Step.I->Operands[0]);
	const bool bInteger = Program.Module.GetType(Image.Element).Kind != ESpirvType::Float;
	const int32_t On = bReplay ? 0 : -1;
	Real Values[4] = {};
	uint32_t UintValues[4] = {};
	int32_t At[4] = {};
	for (uint32_t i = 0; i < 3 && i < SizeOf(Step, 1); ++i)
	{
		At[i] = int32_t(Bits(Step, 1, i));
	}
	for (uint32_t c = 0; c < 4 && c < SizeOf(Step, 2); ++c)
	{
		Values[c] = bInteger ? Real(0) : GetValue(Step, 2, c);
		UintValues[c] = Bits(Step, 2, c);
	}
	if (Image.Dim == DimBuffer)
	{
		const uint32_t Index = uint32_t(At[0]);
		const FKernelBuffer& Buffer = BufferOf(Step, 0);
		bInteger ? FSampling::StoreTypedUint(Buffer, &On, &Index, UintValues)
				 : FSampling::StoreTyped(Buffer, &On, &Index, Values);
		if (Observer)
		{
			CheckElement(Step, Buffer, Index, true);
		}
		return;
	}
	const int32_t* const Depth = Image.Dim == Dim3D || Image.bArrayed ? &At[2] : nullptr;
	const FKernelTexture& Texture = TextureOf(Step, 0);
	bInteger ? FSampling::StoreUint(Texture, &On, &At[0], &At[1], Depth, UintValues)
			 : FSampling::Store(Texture, &On, &At[0], &At[1], Depth, Values);
	if (Observer)
	{
		At[2] = Depth ? At[2] : 0;
		CheckTexel(Step, Texture, At, true);
	}
}

template<typename Real>
bool TSpirvThread<Real>::ExecuteImage(const FSpirvStep& Step)
{
	const FSpirvInstruction& I = *Step.I;
	switch (I.Op)
	{
	case OpSampledImage:
		Result(Step)[0] = Value(Step, 0)[0];
		Result(Step)[1] = Value(Step, 1)[0];
		return true;
	case OpImage:
		Result(Step)[0] = Value(Step, 0)[0];
		return true;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageGather:
		ExecuteSample(Step);
		return true;
	case OpImageFetch:
	case OpImageRead:
		ExecuteImageLoad(Step);
		return true;
	case OpImageWrite:
		ExecuteImageWrite(Step);
		return true;
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
	{
		if (Program.Module.GetValueType(I.Operands[0]).Dim == DimBuffer)
		{
			Result(Step)[0] = Lanes::BufferElements(BufferOf(Step, 0));
			return true;
		}
		const auto Size =
			Lanes::TextureSize3D(TextureOf(Step, 0), I.Op == OpImageQuerySizeLod ? int32_t(Bits(Step, 1)) : 0);
		for (uint32_t i = 0; i < Step.Size && i < 3; ++i)
		{
			Result(Step)[i] = uint32_t(Size[int(i)]);
		}
		return true;
	}
	case OpImageQueryLevels:
		Result(Step)[0] = uint32_t(TextureOf(Step, 0).NumMips);
		return true;
	default:
		return false;
	}
}

} // namespace Drydock
