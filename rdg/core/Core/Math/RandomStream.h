// FRandomStream: a sequence of random numbers that is the same on every machine. Source: engine Math/RandomStream.h.
#pragma once

#include "Math/Vector.h"
#include "UObject/NameTypes.h"

/** Each call goes one step on: seed * 196314165 + 907633515, modulo 2^32. Const calls go on too, as in the engine. */
struct FRandomStream
{
	/** Seed 0. */
	FRandomStream() = default;
	FRandomStream(int32 Seed) { Initialize(Seed); }
	/** The seed is the name's hash, which holds within one process. */
	FRandomStream(FName Name) { Initialize(static_cast<int32>(GetTypeHash(Name))); }

	void Initialize(int32 InSeed)
	{
		InitialSeed = InSeed;
		Seed = static_cast<uint32>(InSeed);
	}
	/** Back to the first number. */
	void Reset() const { Seed = static_cast<uint32>(InitialSeed); }
	int32 GetInitialSeed() const { return InitialSeed; }
	int32 GetCurrentSeed() const { return static_cast<int32>(Seed); }
	/** Starts with a seed from FMath::Rand. */
	void GenerateNewSeed() { Initialize(FMath::Rand()); }

	uint32 GetUnsignedInt() const { return Seed = Seed * 196314165u + 907633515u; }
	/** From 0 to below 1: the upper 23 bits as the fraction of a number from 1 to 2. */
	float GetFraction() const { return std::bit_cast<float>(0x3F800000u | (GetUnsignedInt() >> 9)) - 1.0f; }
	float FRand() const { return GetFraction(); }
	/** From 0 to below Count; 0, and no number is taken, if Count is not above 0. */
	int32 RandHelper(int32 Count) const
	{
		return Count > 0 ? FMath::TruncToInt(GetFraction() * static_cast<float>(Count)) : 0;
	}
	/** From Min to Max, both possible. */
	int32 RandRange(int32 Min, int32 Max) const { return Min + RandHelper(Max - Min + 1); }
	float RandRange(float Min, float Max) const { return FRandRange(Min, Max); }
	double RandRange(double Min, double Max) const { return FRandRange(Min, Max); }
	float FRandRange(float Min, float Max) const { return Min + (Max - Min) * GetFraction(); }
	double FRandRange(double Min, double Max) const { return Min + (Max - Min) * static_cast<double>(GetFraction()); }
	/** A direction of length 1, all equally likely; takes three numbers, or more. */
	DRYDOCK_API FVector VRand() const;
	FVector GetUnitVector() const { return VRand(); }

private:
	int32 InitialSeed = 0;
	mutable uint32 Seed = 0;
};
