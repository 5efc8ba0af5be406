// Every shipped shader by three makers: drydock's interpreter, which kernels equal bit for bit, lavapipe and
// SwiftShader. Who stands alone is named. DRYDOCK_ORACLES=all takes every permutation, else the first and the last of
// each class are taken; docs/oracles.md says what was found.
#include <gtest/gtest.h>

#include "InspectedShader.h"
#include "MadeArguments.h"
#include "Perturbation.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "SpirvGroup.h"
#include "TileExecutor.h"
#include "VulkanDrivers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr uint64_t MaxSteps = 100'000'000;
constexpr int NumPerturbed = 6;
constexpr double Texels = 1.0 / 256; // sub-texel precision is 8 bits, as VkPhysicalDeviceLimits has it
/** A few random walks do not reach the farthest point. */
constexpr double Reach = 2;

/** Of a class. */
size_t GetMostPermutations()
{
	const char* const Asked = std::getenv("DRYDOCK_ORACLES");
	return size_t(std::max(Asked ? std::atoi(Asked) : 0, 2));
}

/** All, or the first, the last and others drawn by chance. */
std::vector<int32> ListPermutations(const FShaderType& Type)
{
	std::vector<int32> Ids;
	for (int32 Id = 0; Id < Type.GetPermutationCount(); ++Id)
	{
		if (Type.ShouldCompilePermutation(Id))
		{
			Ids.push_back(Id);
		}
	}
	const size_t Most = GetMostPermutations();
	if (Ids.size() > Most)
	{
		std::mt19937 Random(1);
		std::shuffle(Ids.begin() + 1, Ids.end() - 1, Random);
		Ids[Most - 1] = Ids.back();
		Ids.resize(Most);
	}
	return Ids;
}

/** Numbers of ReadResults that the shader's outputs have; the others of a render target are nobody's. */
std::vector<bool> FindWritten(const FInspectedShader& Shader, const FShaderReflection& Reflection, size_t Count)
{
	std::vector<bool> Written(Count, true);
	std::vector<uint32_t> Components(size_t(Reflection.NumTargets), 0);
	for (const FSpirvVariable& Variable : Shader.GetModule().Variables)
	{
		if (Variable.Storage == Spirv::StorageOutput && Reflection.Stage == EShaderStage::Pixel)
		{
			Components.at(Variable.Location) = Shader.GetModule().GetType(Variable.Type).NumScalars;
		}
	}
	constexpr size_t PerTarget = size_t(GMadeSizeX) * size_t(GMadeSizeY) * 4;
	for (size_t i = 0; i < PerTarget * Components.size(); ++i)
	{
		Written[i] = i % 4 < Components[i / PerTarget];
	}
	return Written;
}

/** Seed 0: as it is; else with every operation moved within Vulkan's bounds. */
std::vector<double> RunModel(
	FInspectedShader& Shader, const FShaderReflection& Reflection, EMadePictures Pictures, uint32_t Seed)
{
	FMadeArguments Made(Reflection, Pictures, 1);
	if (Seed != 0)
	{
		std::mt19937 Random(Seed);
		for (FKernelInterpolant& Input : Made.Interpolants)
		{
			for (double& Base : Input.Base) // from the vertices' values in float
			{
				Base += (Random() & 1 ? 1 : -1) * 4 * 0x1p-23;
			}
		}
	}
	const FScopedDenormals Denormals(EDenormals::Flush);
	const FKernelTile Whole = Made.GetWhole();
	const auto StoreTargets = [&](const TSpirvThread<float>& Thread)
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
	};
	if (Shader.HasGroups()) // or quads; these run as they are
	{
		TSpirvGroup<float> Group(Shader.GetProgram(), Shader.GetOrder(), Shader.GetSlots(), Shader.GetWaveSize());
		const uint32_t* const Size = Shader.GetModule().LocalSize;
		for (int32_t i = 0; i < Whole.MaxX / int32_t(Size[0]) * (Whole.MaxY / int32_t(Size[1])); ++i)
		{
			const int32_t Columns = Whole.MaxX / int32_t(Size[0]);
			Group.Run(Made.GetArgs(), {i % Columns, i / Columns, 0}, MaxSteps);
			for (uint32_t Thread = 0; Shader.GetModule().bQuads && Thread < Group.GetNumThreads(); ++Thread)
			{
				StoreTargets(Group.GetThread(Thread));
			}
		}
		return Made.ReadResults();
	}
	TSpirvThread<float> Thread(Shader.GetProgram(), Shader.GetSlots());
	FPerturbation Perturbation(Thread, Shader.GetProgram(), Seed, Texels);
	Thread.SetObserver(Seed != 0 ? &Perturbation : nullptr, false);
	for (int32_t i = 0; i < Whole.MaxX * Whole.MaxY * Whole.MaxZ; ++i)
	{
		const int32_t At[3] = {i % Whole.MaxX, i / Whole.MaxX % Whole.MaxY, i / Whole.MaxX / Whole.MaxY};
		Thread.Run(Made.GetArgs(), At, nullptr, MaxSteps);
		if (Reflection.Stage == EShaderStage::Pixel)
		{
			StoreTargets(Thread);
		}
	}
	return Made.ReadResults();
}

/** What came of a comparison of all numbers of one run. */
struct FTally
{
	uint64_t Numbers = 0;   // compared
	uint64_t NotFinite = 0; // NaN or infinity here, or within the bounds of it: Vulkan promises nothing of these
	uint64_t Loose = 0;     // compared, but within the bounds anything from a tenth of the value on is right
	std::map<std::string, uint64_t> Alone;
	std::map<std::string, std::string> First; // of those, the first number
	double LargestShare = 0;                  // of the tolerance
};

void AddTo(FTally& Sum, const FTally& One)
{
	Sum.Numbers += One.Numbers;
	Sum.NotFinite += One.NotFinite;
	Sum.Loose += One.Loose;
	Sum.LargestShare = std::max(Sum.LargestShare, One.LargestShare);
	for (const auto& [Name, Count] : One.Alone)
	{
		Sum.Alone[Name] += Count;
	}
}

FTally Compare(const std::vector<double>& Ours, const std::vector<std::vector<double>>& Perturbed,
	const std::map<std::string, std::vector<double>>& Theirs, const std::vector<bool>& Written)
{
	FTally Tally;
	for (size_t i = 0; i < Ours.size(); ++i)
	{
		if (!Written[i])
		{
			continue;
		}
		double Farthest = 0;
		for (const std::vector<double>& One : Perturbed)
		{
			Farthest = std::max(Farthest, std::fabs(One[i] - Ours[i]));
			Farthest = std::isfinite(One[i]) ? Farthest : INFINITY;
		}
		if (!std::isfinite(Ours[i]) || !std::isfinite(Farthest))
		{
			++Tally.NotFinite;
			continue;
		}
		const double Tolerance = Reach * Farthest + 0x1p-22 * std::fabs(Ours[i]) + 0x1p-126;
		++Tally.Numbers;
		Tally.Loose += Tolerance > 0.1 * std::max(std::fabs(Ours[i]), 0x1p-10);
		std::vector<std::string> Apart;
		for (const auto& [Name, Results] : Theirs)
		{
			const double Difference = std::fabs(Results[i] - Ours[i]);
			if (!(Difference <= Tolerance))
			{
				Apart.push_back(Name);
			}
			else
			{
				Tally.LargestShare = std::max(Tally.LargestShare, Difference / Tolerance);
			}
		}
		if (Apart.empty())
		{
			continue;
		}
		const bool bTheyAgree = Theirs.size() > 1 && Apart.size() == Theirs.size() &&
								std::fabs(Theirs.begin()->second[i] - Theirs.rbegin()->second[i]) <= 2 * Tolerance;
		const std::string Name = bTheyAgree ? "drydock" : Apart.size() > 1 ? "each" : Apart.front();
		if (++Tally.Alone[Name] == 1)
		{
			std::string Text =
				std::to_string(i) + ": drydock " + std::to_string(Ours[i]) + " +- " + std::to_string(Tolerance);
			for (const auto& [Other, Results] : Theirs)
			{
				Text += ", " + Other + " " + std::to_string(Results[i]);
			}
			Tally.First[Name] = Text;
		}
	}
	return Tally;
}

} // namespace

TEST(VulkanOracles, EveryShippedShaderByThreeMakers)
{
	std::vector<FVulkanDriver*> Drivers;
	for (FVulkanDriver& Driver : GetVulkanDrivers())
	{
		if (Driver.Backend)
		{
			Drivers.push_back(&Driver);
		}
		else
		{
			std::printf("%s\n", Driver.Fault.c_str());
		}
	}
	if (Drivers.empty())
	{
		GTEST_SKIP() << "no Vulkan driver of a CPU is here";
	}
	int NumShaders = 0;
	std::set<std::string> Refused;
	FTally Sum;
	const char* const Only = std::getenv("DRYDOCK_ORACLES_ONLY"); // part of a class's name
	const auto CompareShader = [&](const FShaderType& Type, int32 Id)
	{
		const FShaderRef Shader(Type.FindOrCreateShader(Id));
		const FShaderCompileRequest Request = MakeShaderCompileRequest(Shader, Type.GetRootParametersMetadata());
		if (!Request.VirtualPath.starts_with("/Engine/") || Request.Stage == EShaderStage::Vertex ||
			(Only && std::string(Type.GetName()).find(Only) == std::string::npos))
		{
			return;
		}
		const std::shared_ptr<const FShaderReflection> Reflection = GetShaderReflection(Shader);
		FInspectedShader Inspected(Request, *Reflection, true);
		FPerturbation::Prepare(Inspected.GetProgram());
		for (const EMadePictures Pictures : {EMadePictures::Smooth, EMadePictures::Noisy})
		{
			const std::string Name = std::string(Type.GetName()) + " permutation " + std::to_string(Id) +
									 (Pictures == EMadePictures::Smooth ? " smooth" : " noisy");
			const std::vector<double> Ours = RunModel(Inspected, *Reflection, Pictures, 0);
			std::vector<std::vector<double>> Perturbed;
			for (uint32_t Seed = 1; Seed <= NumPerturbed; ++Seed)
			{
				Perturbed.push_back(RunModel(Inspected, *Reflection, Pictures, Seed));
			}
			std::map<std::string, std::vector<double>> Theirs;
			for (FVulkanDriver* const Driver : Drivers)
			{
				FMadeArguments Made(*Reflection, Pictures, 1);
				const std::string Fault = Driver->Backend->Run(Request, Reflection, Made.GetArgs(), Made.GetWhole());
				if (Fault.empty())
				{
					Theirs[Driver->Name] = Made.ReadResults();
				}
				else
				{
					Refused.insert(std::string(Type.GetName()) + " on " + Driver->Name + ": " + Fault);
				}
			}
			const FTally Tally = Compare(Ours, Perturbed, Theirs, FindWritten(Inspected, *Reflection, Ours.size()));
			AddTo(Sum, Tally);
			for (const auto& [Who, Count] : Tally.Alone)
			{
				std::printf("%s: %s stands alone in %llu of %llu numbers; %s\n", Name.c_str(), Who.c_str(),
					static_cast<unsigned long long>(Count), static_cast<unsigned long long>(Tally.Numbers),
					Tally.First.at(Who).c_str());
			}
			EXPECT_EQ(0u, Tally.Alone.count("drydock")) << Name << ": " << Tally.First.at("drydock");
		}
		++NumShaders;
	};
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			for (const int32 Id : ListPermutations(Type))
			{
				CompareShader(Type, Id);
			}
		});
	for (const std::string& Line : Refused)
	{
		std::printf("not compared: %s\n", Line.c_str());
	}
	std::printf("%d shaders, %llu numbers compared, %llu of them loosely, %llu not finite\n", NumShaders,
		static_cast<unsigned long long>(Sum.Numbers), static_cast<unsigned long long>(Sum.Loose),
		static_cast<unsigned long long>(Sum.NotFinite));
	for (const auto& [Who, Count] : Sum.Alone)
	{
		std::printf("%s stands alone in %llu\n", Who.c_str(), static_cast<unsigned long long>(Count));
	}
	std::printf("largest difference: %.2f of the tolerance\n", Sum.LargestShare);
	if (!Only)
	{
		EXPECT_GT(NumShaders, 40); // there are that many classes in passes/
		EXPECT_GT(Sum.Numbers, 100'000u);
	}
	EXPECT_LT(Sum.Loose, Sum.Numbers / 4);
}
