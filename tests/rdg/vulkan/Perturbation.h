// How far apart two right answers can be: a shader is run again with every operation's result moved by as much as
// Vulkan allows a driver to be off, up or down by chance.
#pragma once

#include "SpirvThread.h"

#include <random>

namespace Drydock::Test
{

/** Which way each operation of a run is moved. */
class FMoves
{
public:
	/** One that is moved alone is moved by so many of its bounds, lest rounding swallows what comes of it. */
	static constexpr double AloneBy = 16;

	/** Each up or down by its bound, by chance: one of the answers that a driver may give. */
	explicit FMoves(uint32_t Seed)
		: Random(Seed)
	{
	}

	/** Only the one of this number, in the order of execution; Sign: 1 or -1. */
	FMoves(uint64_t InOnly, double InSign)
		: Only(InOnly)
		, Sign(InSign)
	{
	}

	/** By how many bounds the next operation is moved. */
	double Next()
	{
		const uint64_t Number = Count++;
		return Sign == 0 ? (Random() & 1 ? 1.0 : -1.0) : Number == Only ? AloneBy * Sign : 0.0;
	}

	/** Whether the next operation gives the other of its two results. */
	bool NextChoice()
	{
		bChoice |= Sign != 0 && Count == Only;
		return Next() > 0;
	}

	/** Asked for so far. */
	uint64_t GetCount() const { return Count; }

	/** How many times too far the one goes that is moved alone. */
	double GetScale() const { return bChoice ? 1 : AloneBy; }

private:
	std::mt19937 Random;
	uint64_t Only = 0;
	double Sign = 0;
	uint64_t Count = 0;
	bool bChoice = false;
};

/** Moves results as it sees them. Source of the bounds: Vulkan specification, appendix "Precision and Operation of
 * SPIR-V Instructions", tables "Precision of core SPIR-V Instructions" and "Precision of GLSL.std.450 Instructions".
 *
 * SPIR-V leaves log2(0) undefined, and pow(0, y) inherits exp2(y * log2(0)): of both Vulkan takes any result. Here it
 * is that of a zero or of any number below the smallest normal one, which a driver may or may not flush to zero: -126
 * or less, and 0 to 2^(-126 y). SwiftShader's log2(0) is -127. */
class FPerturbation final : public ISpirvObserver
{
public:
	/** Sampled coordinates are moved by this part of a texel. Threads that work together share their moves. */
	FPerturbation(TSpirvThread<float>& InThread, const FSpirvProgram& InProgram, FMoves& InMoves, double InTexels);

	/** Makes the steps of a program seen that may be moved. */
	static void Prepare(FSpirvProgram& Program);

	void OnStep(const FSpirvThreadView& View, const FSpirvStep& Step) override;

private:
	float Read(const FSpirvStep& Step, size_t Operand, uint32_t Index) const;
	void Move(const FSpirvStep& Step, uint32_t Index, double Bound);
	void MoveExtended(const FSpirvStep& Step);
	void MoveProducts(const FSpirvStep& Step);
	void SampleBeside(const FSpirvStep& Step);
	void MoveFromZero(const FSpirvStep& Step, uint32_t Index, double Value);

	TSpirvThread<float>& Thread;
	const FSpirvProgram& Program;
	FMoves& Moves;
	double Texels;
	bool bInside = false; // a step that is made here
};

} // namespace Drydock::Test
