// Tells operations whose result comes from their operands alone, and those that work scalar by scalar.
#include "SpirvFlow.h"

namespace Drydock
{

using namespace Spirv;

bool HasFlow(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpPhi:
	case OpLoad:
	case OpStore:
	case OpSampledImage:
	case OpImage:
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageSampleDrefImplicitLod:
	case OpImageSampleDrefExplicitLod:
	case OpImageDrefGather:
	case OpImageGather:
	case OpImageFetch:
	case OpImageRead:
	case OpImageWrite:
	case OpImageQueryLod:
	case OpImageQueryLevels:
	case OpImageTexelPointer:
	case OpArrayLength:
	case OpFunctionCall:
	case OpBranch:
	case OpBranchConditional:
	case OpSwitch:
	case OpKill:
	case OpReturn:
	case OpUnreachable:
		return false;
	default:
		return I.Result && !IsSpirvAtomic(I.Op) && !IsSpirvWave(I.Op) && !IsSpirvDerivative(I.Op);
	}
}

bool IsComponentwise(const FSpirvModule& Module, const FSpirvInstruction& I)
{
	const bool bExtended = I.Op == OpExtInst;
	if (bExtended)
	{
		switch (I.Operands[1])
		{
		case ExtDeterminant:
		case ExtModf:
		case ExtPackHalf2x16:
		case ExtUnpackHalf2x16:
		case ExtLength:
		case ExtDistance:
		case ExtCross:
		case ExtNormalize:
		case ExtFaceForward:
		case ExtReflect:
		case ExtRefract:
			return false;
		default:
			break;
		}
	}
	// Matrices of one size have products of that size.
	if (I.Op >= OpVectorTimesScalar && I.Op <= OpDot)
	{
		return false;
	}
	const uint32_t Size = std::max(1u, Module.GetType(I.Type).NumScalars);
	return I.Op != OpTranspose &&
		   std::all_of(I.Operands.begin() + (bExtended ? 2 : 0), I.Operands.end(),
			   [&Module, Size](uint32_t Id)
			   { return Module.ValueTypes.count(Id) && std::max(1u, Module.GetValueType(Id).NumScalars) == Size; });
}

} // namespace Drydock
