// How far apart two right answers can be: a shader is run again with every operation's result moved by as much as
// Vulkan allows a driver to be off, up or down by chance.
#pragma once

#include "SpirvThread.h"

#include <random>

namespace Drydock::Test
{

/** Moves results as it sees them. Source of the bounds: Vulkan specification, appendix "Precision and Operation of
 * SPIR-V Instructions", tables "Precision of core SPIR-V Instructions" and "Precision of GLSL.std.450 Instructions". */
class FPerturbation final : public ISpirvObserver
{
public:
	/** Sampled coordinates are moved by this part of a texel. */
	FPerturbation(TSpirvThread<float>& InThread, const FSpirvProgram& InProgram, uint32_t Seed, double InTexels);

	/** Makes all steps of a program seen. */
	static void Prepare(FSpirvProgram& Program);

	void OnStep(const FSpirvThreadView& View, const FSpirvStep& Step) override;

private:
	bool IsReal(const FSpirvStep& Step) const;
	float Read(const FSpirvStep& Step, size_t Operand, uint32_t Index) const;
	void Move(const FSpirvStep& Step, uint32_t Index, double Bound);
	void MoveExtended(const FSpirvStep& Step);
	void MoveProducts(const FSpirvStep& Step);
	void SampleBeside(const FSpirvStep& Step);
	double Sign() { return Random() & 1 ? 1.0 : -1.0; }

	TSpirvThread<float>& Thread;
	const FSpirvProgram& Program;
	std::mt19937 Random;
	double Texels;
	bool bInside = false; // a step that is made here
};

} // namespace Drydock::Test
