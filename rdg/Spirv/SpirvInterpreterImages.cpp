// Runs the instructions on textures in the model.
#include "SpirvInterpreterImpl.h"

#include <cstring>

namespace Drydock
{

using namespace Spirv;

const FSpirvVariable& FSpirvInterpreterImpl::HandleOf(uint32_t Id) const
{
	for (int Steps = 0; Steps < 8; ++Steps)
	{
		if (const FSpirvVariable* Variable = Module.FindVariable(Id))
		{
			return *Variable;
		}
		const auto Found = Definitions.find(Id);
		if (Found == Definitions.end() || Found->second->Operands.empty())
		{
			break;
		}
		Id = Found->second->Operands[0];
	}
	Module.Fail("SPIR-V: a texture or sampler that is not a variable");
}

bool FSpirvInterpreterImpl::ExecuteImage(const FSpirvInstruction& I, FScalars& Result)
{
	// Textures are read by the library's sampler of one lane, which goes texel by texel: the kernels' lane code is not
	// its own judge.
	constexpr int N = 1;
	using FSampling = Lanes::TSampling<float, N>;
	const auto Spread = [this](uint32_t Id, uint32_t Index, auto* Out)
	{
		const uint32_t Bits = Index < Get(Id).size() ? Get(Id)[Index] : 0;
		for (int Lane = 0; Lane < N; ++Lane)
		{
			std::memcpy(&Out[Lane], &Bits, 4);
		}
	};
	const auto Image = [this](uint32_t Id) -> const FSpirvType&
	{
		const FSpirvType& Type = Module.GetValueType(Id);
		return Type.Kind == ESpirvType::SampledImage ? Module.GetType(Type.Element) : Type;
	};
	const int32_t On[N] = {-1};
	alignas(64) float Out[4 * N] = {};
	alignas(64) uint32_t UintOut[4 * N] = {};
	const auto Texture = [this, &I]() -> const FKernelTexture&
	{
		const FSpirvVariable& Variable = HandleOf(I.Operands[0]);
		return (Module.GetType(Variable.Type).bStorageImage ? Args->RWTextures : Args->Textures)[SlotOf(I.Operands[0])];
	};
	const auto Buffer = [this, &I]() -> const FKernelBuffer&
	{
		const FSpirvVariable& Variable = HandleOf(I.Operands[0]);
		return (Module.GetType(Variable.Type).bStorageImage ? Args->RWBuffers : Args->Buffers)[SlotOf(I.Operands[0])];
	};
	switch (I.Op)
	{
	case OpSampledImage:
	case OpImage:
		return true;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageGather:
	{
		const FSpirvType& Type = Image(I.Operands[0]);
		const size_t MaskAt = I.Op == OpImageGather ? 3 : 2;
		const uint32_t Mask = I.Operands.size() > MaskAt ? I.Operands[MaskAt] : 0;
		if (Mask & ~uint32_t(ImageLod))
		{
			Module.Fail("the model does not know samples with an offset", &I);
		}
		const FSpirvInstruction& Pair = *Definitions.at(I.Operands[0]);
		const FKernelTexture& Sampled = Args->Textures[SlotOf(Pair.Operands[0])];
		const FKernelSampler& Sampler = Args->Samplers[SlotOf(Pair.Operands[1])];
		alignas(64) float U[N], V[N], W[N], Level[N] = {};
		Spread(I.Operands[1], 0, U);
		Spread(I.Operands[1], 1, V);
		Spread(I.Operands[1], 2, W);
		if (Mask & ImageLod)
		{
			Spread(I.Operands[3], 0, Level);
		}
		if (I.Op == OpImageGather)
		{
			FSampling::Gather2D(Sampled, Sampler, U, V, int32_t(Module.GetConstantScalar(I.Operands[2])), Out);
		}
		else if (Type.Dim == Dim3D)
		{
			FSampling::Sample3D(Sampled, Sampler, U, V, W, Level, true, Out);
		}
		else
		{
			FSampling::Sample2D(Sampled, Sampler, U, V, Type.bArrayed ? W : nullptr, Level, true, Out);
		}
		break;
	}
	case OpImageFetch:
	case OpImageRead:
	{
		const FSpirvType& Type = Image(I.Operands[0]);
		const bool bInteger = Module.GetType(Type.Element).Kind != ESpirvType::Float;
		const uint32_t Mask = I.Operands.size() > 2 ? I.Operands[2] : 0;
		if (Mask & ~uint32_t(ImageLod))
		{
			Module.Fail("the model does not know loads with an offset", &I);
		}
		alignas(64) int32_t X[N], Y[N], Z[N], Mip[N] = {};
		Spread(I.Operands[1], 0, X);
		Spread(I.Operands[1], 1, Y);
		Spread(I.Operands[1], 2, Z);
		if (Mask & ImageLod)
		{
			Spread(I.Operands[3], 0, Mip);
		}
		const int32_t* const Depth = Type.Dim == Dim3D || Type.bArrayed ? Z : nullptr;
		if (Type.Dim == DimBuffer)
		{
			const auto* const Index = reinterpret_cast<const uint32_t*>(X);
			bInteger ? FSampling::LoadTypedUint(Buffer(), Index, UintOut) : FSampling::LoadTyped(Buffer(), Index, Out);
		}
		else
		{
			bInteger ? FSampling::LoadUint(Texture(), X, Y, Depth, Mip, true, UintOut)
					 : FSampling::Load(Texture(), X, Y, Depth, Mip, true, Out);
		}
		if (bInteger)
		{
			std::memcpy(Out, UintOut, sizeof(Out));
		}
		break;
	}
	case OpImageWrite:
	{
		const FSpirvType& Type = Image(I.Operands[0]);
		const bool bInteger = Module.GetType(Type.Element).Kind != ESpirvType::Float;
		alignas(64) int32_t X[N], Y[N], Z[N];
		Spread(I.Operands[1], 0, X);
		Spread(I.Operands[1], 1, Y);
		Spread(I.Operands[1], 2, Z);
		for (uint32_t c = 0; c < 4; ++c)
		{
			Spread(I.Operands[2], c, Out + c * N);
			Spread(I.Operands[2], c, UintOut + c * N);
		}
		const int32_t* const Depth = Type.Dim == Dim3D || Type.bArrayed ? Z : nullptr;
		if (Type.Dim == DimBuffer)
		{
			const auto* const Index = reinterpret_cast<const uint32_t*>(X);
			bInteger ? FSampling::StoreTypedUint(Buffer(), On, Index, UintOut)
					 : FSampling::StoreTyped(Buffer(), On, Index, Out);
		}
		else
		{
			bInteger ? FSampling::StoreUint(Texture(), On, X, Y, Depth, UintOut)
					 : FSampling::Store(Texture(), On, X, Y, Depth, Out);
		}
		return true;
	}
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
	{
		if (Image(I.Operands[0]).Dim == DimBuffer)
		{
			Result = {Lanes::BufferElements(Buffer())};
			return true;
		}
		const auto Size =
			Lanes::TextureSize3D(Texture(), I.Op == OpImageQuerySizeLod ? int32_t(Get(I.Operands[1])[0]) : 0);
		for (uint32_t i = 0; i < Module.GetType(I.Type).NumScalars; ++i)
		{
			Result.push_back(uint32_t(Size[int(i)]));
		}
		return true;
	}
	case OpImageQueryLevels:
		Result = {uint32_t(Texture().NumMips)};
		return true;
	default:
		return false;
	}
	for (int c = 0; c < 4; ++c)
	{
		Result.push_back(ToBits(Out[c * N]));
	}
	return true;
}

} // namespace Drydock
