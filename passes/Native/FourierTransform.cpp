// The plan of a line's transform, made and run by KissFFT.
#include <kissfft/kissfft.hh>

#include "Native/FourierTransform.h"

#include <bit>

namespace Drydock
{

struct FFourierTransform::FPlan
{
	kissfft<double> Transform;
};

FFourierTransform::FFourierTransform(int32 InSize, EFourierDirection Direction)
	: Size(InSize)
	, Plan(new FPlan{kissfft<double>(static_cast<size_t>(InSize), Direction == EFourierDirection::Inverse)})
{
	check(InSize > 0 && std::has_single_bit(static_cast<uint32>(InSize)));
}

FFourierTransform::~FFourierTransform() = default;

void FFourierTransform::Run(const FComplex* Source, FComplex* Target) const
{
	Plan->Transform.transform(Source, Target);
}

} // namespace Drydock
