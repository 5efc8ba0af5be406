// Random numbers: directions, and the functions of FMath.
#include "Math/RandomStream.h"

namespace
{

thread_local FRandomStream GRandStream(1);   // of FMath::Rand; runs begin alike
thread_local FRandomStream GSeededStream(0); // of FMath::SRand

} // namespace

FVector FRandomStream::VRand() const
{
	FVector Point;
	do
	{
		for (int32 Axis = 0; Axis < 3; ++Axis)
		{
			Point[Axis] = static_cast<double>(GetFraction() * 2.0f - 1.0f);
		}
	} while (Point.SizeSquared() > 1.0 || Point.SizeSquared() < UE_KINDA_SMALL_NUMBER);
	return Point * (1.0 / Point.Size());
}

int32 FMath::Rand()
{
	return static_cast<int32>(GRandStream.GetUnsignedInt() >> 1);
}

void FMath::RandInit(int32 Seed)
{
	GRandStream.Initialize(Seed);
}

float FMath::FRand()
{
	return GRandStream.GetFraction();
}

void FMath::SRandInit(int32 Seed)
{
	GSeededStream.Initialize(Seed);
}

float FMath::SRand()
{
	return GSeededStream.GetFraction();
}

int32 FMath::RandHelper(int32 Count)
{
	return GRandStream.RandHelper(Count);
}

FVector FMath::VRand()
{
	return GRandStream.VRand();
}
