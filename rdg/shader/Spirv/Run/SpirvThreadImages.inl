// Instructions on textures and typed buffers. Textures are read by the library's sampler of one lane, which goes texel
// by texel: the kernels' lane code is not its own judge.
#pragma once

#include "SpirvThread.h"

#include "Lanes.h"
#include "LanesLod.h"

#include <cmath>

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

/** Not below the sample's own clamp, where it has one. */
template<typename Real>
Real TSpirvThread<Real>::ClampLevel(const FSpirvStep& Step, const FSpirvImageOperands& Told, Real Found) const
{
	const FKernelSampler& Sampler = ViewOf(Args->Samplers, Bits(Step, 0, 1));
	return Told.MinLod ? Lanes::ClampLevel(Sampler, Found, GetValue(Step, Told.MinLod, 0)) : Found;
}

/** The level of a sample's gradients. */
template<typename Real>
Real TSpirvThread<Real>::GetGradientLevel(
	const FSpirvStep& Step, const FSpirvImageOperands& Told, const FKernelTexture& Texture) const
{
	const auto Vector = [this, &Step](size_t Operand)
	{
		const auto Part = [this, &Step, Operand](uint32_t i)
		{
			return i < SizeOf(Step, Operand) ? GetValue(Step, Operand, i) : Real(0);
		};
		return Lanes::TVec<Real, 3>(Part(0), Part(1), Part(2));
	};
	const auto Flat = [&Vector](size_t Operand)
	{
		const Lanes::TVec<Real, 3> V = Vector(Operand);
		return Lanes::TVec<Real, 2>(V[0], V[1]);
	};
	const FSpirvType& Pair = Program.Module.GetValueType(Step.I->Operands[0]);
	switch (Program.Module.GetType(Pair.Element).Dim)
	{
	case DimCube:
		return Lanes::GradientLevelCube(Texture, Vector(1), Vector(Told.GradX), Vector(Told.GradY));
	case Dim3D:
		return Lanes::GradientLevel(Texture, Vector(Told.GradX), Vector(Told.GradY));
	default:
		return Lanes::GradientLevel(Texture, Flat(Told.GradX), Flat(Told.GradY));
	}
}

template<typename Real>
void TSpirvThread<Real>::ExecuteSample(const FSpirvStep& Step)
{
	using FSampling = Lanes::TSampling<Real, 1>;
	const FSpirvInstruction& I = *Step.I;
	const FSpirvType& Pair = Program.Module.GetValueType(I.Operands[0]);
	const FSpirvType& Image = Program.Module.GetType(Pair.Element);
	const FSpirvImageOperands Told = GetImageOperands(I);
	const FKernelTexture& Texture = ViewOf(Args->Textures, Bits(Step, 0, 0));
	const FKernelSampler& Sampler = ViewOf(Args->Samplers, Bits(Step, 0, 1));
	const bool bChooses = Program.Module.bQuads && ChoosesSpirvLevel(I.Op);
	const Real At = bChooses     ? Level
					: Told.Lod   ? GetValue(Step, Told.Lod, 0)
					: Told.GradX ? ClampLevel(Step, Told, GetGradientLevel(Step, Told, Texture))
								 : Real(0);
	const uint32_t Axes = Image.Dim == Dim2D ? 2 : 3;
	Real Coordinates[4] = {};
	int32_t Offsets[4][3] = {};
	Lanes::TSamplePlace<Real> Place;
	Place.bCube = Image.Dim == DimCube;
	for (uint32_t i = 0; i < Axes + Image.bArrayed; ++i)
	{
		Coordinates[i] = i < SizeOf(Step, 1) ? GetValue(Step, 1, i) : Real(0);
	}
	const size_t OffsetsAt = Told.Offsets ? Told.Offsets : Told.Offset;
	for (uint32_t i = 0; OffsetsAt && i < SizeOf(Step, OffsetsAt); ++i)
	{
		Offsets[Told.Offsets ? i / 2 : 0][Told.Offsets ? i % 2 : i] = int32_t(Bits(Step, OffsetsAt, i));
	}
	for (uint32_t Axis = 0; Axis < Axes; ++Axis)
	{
		Place.Coordinates[Axis] = &Coordinates[Axis];
		Place.Offsets[Axis] = OffsetsAt ? &Offsets[0][Axis] : nullptr;
	}
	Place.Layer = Image.bArrayed ? &Coordinates[Axes] : nullptr;
	const Real Reference = Told.Reference ? GetValue(Step, Told.Reference, 0) : Real(0);
	Place.Reference = Told.Reference ? &Reference : nullptr;
	Real Out[4] = {};
	if (IsSpirvGather(I.Op))
	{
		const int32_t Component = Told.Component ? int32_t(Bits(Step, Told.Component)) : 0;
		FSampling::Gather(Texture, Sampler, Place, Component, Out);
		for (int k = 0; k < 4 && Told.Offsets; ++k)
		{
			Real One[4];
			Place.Offsets[0] = &Offsets[k][0];
			Place.Offsets[1] = &Offsets[k][1];
			FSampling::Gather(Texture, Sampler, Place, Component, One);
			Out[k] = One[k];
		}
	}
	else
	{
		FSampling::Sample(Texture, Sampler, Place, &At, true, Out);
	}
	for (uint32_t c = 0; c < 4 && c < Step.Size; ++c)
	{
		Result(Step)[c] = ToSpirvWord<Real>(Out[c]);
	}
	if (Observer && Told.Lod && At > Real(Texture.NumMips - 1))
	{
		const int64_t Asked = At < Real(1000) ? int64_t(std::ceil(double(At))) : 1000;
		Fault(Step, {ESpirvFault::Level, Resource(Step, 0).Name, {0, 0, 0, Asked}, {Texture.NumMips}, false, false});
	}
	++Taps;
}

template<typename Real>
void TSpirvThread<Real>::ExecuteImageLoad(const FSpirvStep& Step)
{
	using FSampling = Lanes::TSampling<Real, 1>;
	const FSpirvType& Image = Program.Module.GetValueType(Step.I->Operands[0]);
	const bool bInteger = Program.Module.GetType(Image.Element).Kind != ESpirvType::Float;
	const FSpirvImageOperands Told = GetImageOperands(*Step.I);
	const size_t Offset = Told.Offset;
	Real Out[4] = {};
	uint32_t UintOut[4] = {};
	int32_t At[4] = {};
	for (uint32_t i = 0; i < 3 && i < SizeOf(Step, 1); ++i)
	{
		const uint32_t Moved = Offset && i < SizeOf(Step, Offset) ? Bits(Step, Offset, i) : 0;
		At[i] = int32_t(Bits(Step, 1, i) + Moved);
	}
	At[3] = Told.Lod ? int32_t(Bits(Step, Told.Lod)) : 0;
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
	const int32_t On = Stores() ? -1 : 0;
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
	case OpImageSampleDrefImplicitLod:
	case OpImageSampleDrefExplicitLod:
	case OpImageGather:
	case OpImageDrefGather:
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
		const int32_t Mip = I.Op == OpImageQuerySizeLod ? int32_t(Bits(Step, 1)) : 0;
		const auto Size = Program.Module.GetValueType(I.Operands[0]).Dim == DimCube
							  ? Lanes::TextureSizeCubes(TextureOf(Step, 0), Mip)
							  : Lanes::TextureSize3D(TextureOf(Step, 0), Mip);
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
