// Tells operations whose result comes from their operands alone, and those that work scalar by scalar.
#include "SpirvFlow.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace Drydock
{

using namespace Spirv;

bool HasFlow(const FSpirvInstruction& I)
{
	static const std::set<uint16_t> Without = {OpPhi, OpLoad, OpStore, OpSampledImage, OpImage,
		OpImageSampleImplicitLod, OpImageSampleExplicitLod, OpImageSampleDrefImplicitLod, OpImageSampleDrefExplicitLod,
		OpImageDrefGather, OpImageGather, OpImageFetch, OpImageRead, OpImageWrite, OpImageQueryLod, OpImageQueryLevels,
		OpImageTexelPointer, OpArrayLength, OpFunctionCall, OpBranch, OpBranchConditional, OpSwitch, OpKill, OpReturn,
		OpUnreachable};
	return I.Result && !Without.count(I.Op) && !IsSpirvAtomic(I.Op) && !IsSpirvWave(I.Op) && !IsSpirvDerivative(I.Op);
}

bool IsComponentwise(const FSpirvModule& Module, const FSpirvInstruction& I)
{
	static const std::set<uint32_t> Whole = {ExtDeterminant, ExtModf, ExtPackHalf2x16, ExtUnpackHalf2x16, ExtLength,
		ExtDistance, ExtCross, ExtNormalize, ExtFaceForward, ExtReflect, ExtRefract};
	const bool bExtended = I.Op == OpExtInst;
	// Matrices of one size have products of that size.
	if ((bExtended && Whole.count(I.Operands[1])) || (I.Op >= OpVectorTimesScalar && I.Op <= OpDot))
	{
		return false;
	}
	const uint32_t Size = std::max(1u, Module.GetType(I.Type).NumScalars);
	return I.Op != OpTranspose &&
		   std::all_of(I.Operands.begin() + (bExtended ? 2 : 0), I.Operands.end(),
			   [&Module, Size](uint32_t Id)
			   { return Module.ValueTypes.count(Id) && std::max(1u, Module.GetValueType(Id).NumScalars) == Size; });
}

const FSpirvNorms* FindSpirvNorms(uint32_t Ext)
{
	static constexpr FSpirvNorms Norms[] = {{ExtPackSnorm4x8, 4, true, true}, {ExtPackUnorm4x8, 4, false, true},
		{ExtPackSnorm2x16, 2, true, true}, {ExtPackUnorm2x16, 2, false, true}, {ExtUnpackSnorm2x16, 2, true, false},
		{ExtUnpackUnorm2x16, 2, false, false}, {ExtUnpackSnorm4x8, 4, true, false},
		{ExtUnpackUnorm4x8, 4, false, false}};
	const auto Found = std::ranges::find(Norms, Ext, &FSpirvNorms::Ext);
	return Found == std::end(Norms) ? nullptr : Found;
}

} // namespace Drydock
