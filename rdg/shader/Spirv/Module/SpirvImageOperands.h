// Finds the operands of an instruction on a texture besides its coordinates. Source: SPIR-V specification, section 3.14
// (image operands).
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** Positions in FSpirvInstruction::Operands; 0: the instruction has none. */
struct FSpirvImageOperands
{
	uint32_t Mask = 0;    // Spirv::EImageOperand
	size_t Reference = 0; // what a comparison compares texels with
	size_t Component = 0; // of a gather
	size_t Bias = 0;
	size_t Lod = 0;
	size_t GradX = 0;
	size_t GradY = 0;
	size_t Offset = 0;  // texels, a vector
	size_t Offsets = 0; // texels, an array of four vectors
	size_t MinLod = 0;  // the level is not below it
	size_t End = 0;     // one past the last
};

constexpr bool IsSpirvComparison(uint16_t Op)
{
	return Op == Spirv::OpImageSampleDrefImplicitLod || Op == Spirv::OpImageSampleDrefExplicitLod ||
		   Op == Spirv::OpImageDrefGather;
}

constexpr bool IsSpirvGather(uint16_t Op)
{
	return Op == Spirv::OpImageGather || Op == Spirv::OpImageDrefGather;
}

/** Samples, comparisons and gathers: all that need a sampler. */
constexpr bool IsSpirvSample(uint16_t Op)
{
	return Op == Spirv::OpImageSampleImplicitLod || Op == Spirv::OpImageSampleExplicitLod || IsSpirvGather(Op) ||
		   IsSpirvComparison(Op);
}

/** The image operands of samples, gathers, fetches, reads and writes. */
inline FSpirvImageOperands GetImageOperands(const FSpirvInstruction& I)
{
	using namespace Spirv;
	FSpirvImageOperands Result;
	Result.Reference = IsSpirvComparison(I.Op) ? 2 : 0;
	Result.Component = I.Op == OpImageGather ? 2 : 0;
	const size_t MaskAt = Result.Reference || Result.Component || I.Op == OpImageWrite ? 3 : 2;
	Result.Mask = I.Operands.size() > MaskAt ? I.Operands[MaskAt] : 0;
	size_t Next = MaskAt + 1;
	const auto Take = [&Result, &Next](uint32_t Bits)
	{
		return Result.Mask & Bits ? Next++ : 0;
	};
	Result.Bias = Take(ImageBias);
	Result.Lod = Take(ImageLod);
	Result.GradX = Take(ImageGrad);
	Result.GradY = Take(ImageGrad);
	Result.Offset = Take(ImageConstOffset | ImageOffset);
	Result.Offsets = Take(ImageConstOffsets);
	Result.MinLod = Take(ImageMinLod);
	Result.End = Next;
	return Result;
}

} // namespace Drydock
