// A shader by the interpreter over made arguments: as it is, and how far its numbers go where operations are moved.
#pragma once

#include "InspectedShader.h"
#include "MadeArguments.h"
#include "Perturbation.h"

#include <map>
#include <vector>

namespace Drydock::Test
{

class FMovedModel
{
public:
	/** Both outlive it. Shader: as kernels have it; its steps get hooks. */
	FMovedModel(FInspectedShader& InShader, const FShaderReflection& InReflection, EMadePictures InPictures);

	/** What FMadeArguments::ReadResults gives, nothing moved. */
	const std::vector<double>& GetNumbers() const { return Numbers; }

	/** Those that the shader's outputs have; the others of a render target are nobody's. */
	const std::vector<bool>& GetWritten() const { return Written; }

	/** The same with every operation moved up or down by chance. */
	std::vector<double> Walk(uint32_t Seed) const;

	/** How far a number can be moved by all operations together, to first order: each is moved alone, up and down, and
	 * the larger distances are added. Of threads that work together: the operations of their group or quad. */
	double FindFarthest(size_t Number) const;

private:
	/** A thread, or a group or quad of them. */
	int32_t GetNumUnits() const;
	std::vector<double> Run(FMoves* Moves, int32_t FirstUnit, int32_t LastUnit) const;
	void MoveInputs(FMadeArguments& Made, FMoves& Moves) const;
	void RunThreads(FMadeArguments& Made, FMoves* Moves, int32_t FirstUnit, int32_t LastUnit) const;
	void RunGroups(FMadeArguments& Made, FMoves* Moves, int32_t FirstUnit, int32_t LastUnit) const;
	void StoreTargets(FMadeArguments& Made, const TSpirvThread<float>& Thread) const;
	int32_t FindUnit(size_t Number) const;
	const std::vector<double>& MeasureUnit(int32_t Unit) const;

	FInspectedShader& Shader;
	const FShaderReflection& Reflection;
	const EMadePictures Pictures;
	FKernelTile Whole = {};
	std::vector<double> Numbers;
	std::vector<bool> Written;
	mutable std::map<int32_t, std::vector<double>> Measured; // sums of distances, by unit
};

} // namespace Drydock::Test
