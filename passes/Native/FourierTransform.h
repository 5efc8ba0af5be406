// The discrete Fourier transform of one line. KissFFT (BSD-3-Clause) does the work and stays behind this header.
#pragma once

#include "CoreMinimal.h"

#include <complex>
#include <memory>

namespace Drydock
{

using FComplex = std::complex<double>;

enum class EFourierDirection : uint8
{
	Forward, // exponent -2 pi i j k / Size
	Inverse, // exponent +2 pi i j k / Size, not divided by Size
};

/** A transform of one size, in double arithmetic. Any number of threads may Run one object. */
class DRYDOCK_API FFourierTransform : private FNoncopyable
{
public:
	/** Size: a power of two, checked; KissFFT's other sizes share scratch memory between threads. */
	FFourierTransform(int32 InSize, EFourierDirection Direction);
	~FFourierTransform();

	int32 GetSize() const { return Size; }

	/** Size numbers from Source to Target, which are not the same memory. */
	void Run(const FComplex* Source, FComplex* Target) const;

private:
	struct FPlan;

	int32 Size;
	std::unique_ptr<FPlan> Plan;
};

} // namespace Drydock
