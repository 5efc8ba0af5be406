// Runs units and moves their operations.
#include "MovedModel.h"

#include "SpirvGroup.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace Drydock::Test
{

namespace
{

constexpr uint64_t MaxSteps = 100'000'000;
constexpr double Texels = 1.0 / 256; // sub-texel precision is 8 bits, as VkPhysicalDeviceLimits has it

std::vector<bool> FindWritten(const FSpirvModule& Module, const FShaderReflection& Reflection, size_t Count)
{
	std::vector<bool> Written(Count, true);
	std::vector<uint32_t> Components(size_t(Reflection.NumTargets), 0);
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (Variable.Storage == Spirv::StorageOutput && Reflection.Stage == EShaderStage::Pixel)
		{
			Components.at(Variable.Location) = Module.GetType(Variable.Type).NumScalars;
		}
	}
	constexpr size_t PerTarget = size_t(GMadeSizeX) * size_t(GMadeSizeY) * 4;
	for (size_t i = 0; i < PerTarget * Components.size(); ++i)
	{
		Written[i] = i % 4 < Components[i / PerTarget];
	}
	return Written;
}

} // namespace

FMovedModel::FMovedModel(FInspectedShader& InShader, const FShaderReflection& InReflection, EMadePictures InPictures)
	: Shader(InShader)
	, Reflection(InReflection)
	, Pictures(InPictures)
	, Whole(FMadeArguments(InReflection, InPictures, 1).GetWhole())
{
	FPerturbation::Prepare(Shader.GetProgram());
	Numbers = Run(nullptr, 0, GetNumUnits());
	Written = FindWritten(Shader.GetModule(), Reflection, Numbers.size());
}

std::vector<double> FMovedModel::Walk(uint32_t Seed) const
{
	FMoves Moves(Seed);
	return Run(&Moves, 0, GetNumUnits());
}

double FMovedModel::FindFarthest(size_t Number) const
{
	const int32_t Unit = FindUnit(Number);
	return Unit < 0 ? 0 : MeasureUnit(Unit)[Number];
}

int32_t FMovedModel::GetNumUnits() const
{
	const uint32_t* const Size = Shader.GetModule().LocalSize;
	return Shader.HasGroups() ? Whole.MaxX / int32_t(Size[0]) * (Whole.MaxY / int32_t(Size[1]))
							  : Whole.MaxX * Whole.MaxY * Whole.MaxZ;
}

std::vector<double> FMovedModel::Run(FMoves* Moves, int32_t FirstUnit, int32_t LastUnit) const
{
	FMadeArguments Made(Reflection, Pictures, 1);
	if (Moves)
	{
		MoveInputs(Made, *Moves);
	}
	const FScopedDenormals Denormals(EDenormals::Flush);
	Shader.HasGroups() ? RunGroups(Made, Moves, FirstUnit, LastUnit) : RunThreads(Made, Moves, FirstUnit, LastUnit);
	return Made.ReadResults();
}

/** TEXCOORDs come from the vertices' values in float. */
void FMovedModel::MoveInputs(FMadeArguments& Made, FMoves& Moves) const
{
	for (FKernelInterpolant& Input : Made.Interpolants)
	{
		for (double& Base : Input.Base)
		{
			Base += Moves.Next() * 4 * 0x1p-23;
		}
	}
}

void FMovedModel::RunThreads(FMadeArguments& Made, FMoves* Moves, int32_t FirstUnit, int32_t LastUnit) const
{
	TSpirvThread<float> Thread(Shader.GetProgram(), Shader.GetSlots());
	std::unique_ptr<FPerturbation> Perturbation;
	if (Moves)
	{
		Perturbation = std::make_unique<FPerturbation>(Thread, Shader.GetProgram(), *Moves, Texels);
		Thread.SetObserver(Perturbation.get(), false);
	}
	for (int32_t Unit = FirstUnit; Unit < LastUnit; ++Unit)
	{
		const int32_t At[3] = {Unit % Whole.MaxX, Unit / Whole.MaxX % Whole.MaxY, Unit / Whole.MaxX / Whole.MaxY};
		Thread.Run(Made.GetArgs(), At, nullptr, MaxSteps);
		StoreTargets(Made, Thread);
	}
}

void FMovedModel::RunGroups(FMadeArguments& Made, FMoves* Moves, int32_t FirstUnit, int32_t LastUnit) const
{
	TSpirvGroup<float> Group(Shader.GetProgram(), Shader.GetOrder(), Shader.GetSlots(), Shader.GetWaveSize());
	std::vector<std::unique_ptr<FPerturbation>> Perturbations;
	for (uint32_t Thread = 0; Moves && Thread < Group.GetNumThreads(); ++Thread)
	{
		Perturbations.push_back(
			std::make_unique<FPerturbation>(Group.GetThread(Thread), Shader.GetProgram(), *Moves, Texels));
		Group.GetThread(Thread).SetObserver(Perturbations.back().get(), false);
	}
	const int32_t Columns = Whole.MaxX / int32_t(Shader.GetModule().LocalSize[0]);
	for (int32_t Unit = FirstUnit; Unit < LastUnit; ++Unit)
	{
		Group.Run(Made.GetArgs(), {Unit % Columns, Unit / Columns, 0}, MaxSteps);
		for (uint32_t Thread = 0; Thread < Group.GetNumThreads(); ++Thread)
		{
			StoreTargets(Made, Group.GetThread(Thread));
		}
	}
}

void FMovedModel::StoreTargets(FMadeArguments& Made, const TSpirvThread<float>& Thread) const
{
	const int32_t* const At = Thread.GetPosition();
	for (size_t v = 0; v < Shader.GetModule().Variables.size() && !Thread.WasDiscarded(); ++v)
	{
		const FSpirvVariable& Variable = Shader.GetModule().Variables[v];
		const FSpirvMemory& Memory = Shader.GetProgram().Memory[v];
		for (uint32_t c = 0; Variable.Storage == Spirv::StorageOutput && c < std::min(Memory.Size, 4u); ++c)
		{
			Made.GetTarget(Variable.Location, At[0], At[1])[c] = float(Thread.GetReal(Memory.First + c));
		}
	}
}

/** The last unit that writes a number; -1: none does. */
int32_t FMovedModel::FindUnit(size_t Number) const
{
	const double Before = FMadeArguments(Reflection, Pictures, 1).ReadResults()[Number];
	for (int32_t Unit = GetNumUnits() - 1; Unit >= 0; --Unit)
	{
		if (Run(nullptr, Unit, Unit + 1)[Number] != Before)
		{
			return Unit;
		}
	}
	return -1;
}

const std::vector<double>& FMovedModel::MeasureUnit(int32_t Unit) const
{
	const auto [Found, bNew] = Measured.try_emplace(Unit);
	std::vector<double>& Sums = Found->second;
	if (!bNew)
	{
		return Sums;
	}
	FMoves None(~uint64_t(0), 1); // counts
	const std::vector<double> Plain = Run(&None, Unit, Unit + 1);
	Sums.assign(Plain.size(), 0);
	for (uint64_t Move = 0; Move < None.GetCount(); ++Move)
	{
		FMoves Up(Move, 1);
		FMoves Down(Move, -1);
		const std::vector<double> Above = Run(&Up, Unit, Unit + 1);
		const std::vector<double> Below = Run(&Down, Unit, Unit + 1);
		for (size_t i = 0; i < Plain.size(); ++i)
		{
			Sums[i] += std::max(std::fabs(Above[i] - Plain[i]), std::fabs(Below[i] - Plain[i])) / Up.GetScale();
		}
	}
	return Sums;
}

} // namespace Drydock::Test
