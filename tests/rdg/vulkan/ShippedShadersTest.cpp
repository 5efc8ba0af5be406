// Every shipped shader by three makers: drydock's interpreter, which kernels equal bit for bit, lavapipe and
// SwiftShader. Who stands alone is named. A driver's number may be as far from ours as operations within Vulkan's
// bounds can move it (Perturbation.h), and no farther: as far as one of six runs that are moved by chance, else as all
// operations of its thread together (MovedModel.h). Environment: DRYDOCK_ORACLES is the most permutations of a class,
// DRYDOCK_ORACLES_SEED draws them, DRYDOCK_ORACLES_ONLY is a part of a class's name. docs/oracles.md says what was
// found.
#include <gtest/gtest.h>

#include "MovedModel.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "ShaderCompiler.h"
#include "VulkanDrivers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <map>
#include <set>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr uint32_t NumWalks = 6;

int GetNumber(const char* Variable, int Default)
{
	const char* const Text = std::getenv(Variable);
	return Text ? std::atoi(Text) : Default;
}

/** All, or the last, which has most switched on, and others that are drawn for the class. */
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
	const size_t Most = size_t(std::max(GetNumber("DRYDOCK_ORACLES", 2), 1));
	if (Ids.size() > Most)
	{
		const std::string Name = Type.GetName();
		std::vector<int> Seeds(Name.begin(), Name.end());
		Seeds.push_back(GetNumber("DRYDOCK_ORACLES_SEED", 1));
		std::seed_seq Sequence(Seeds.begin(), Seeds.end());
		std::mt19937 Random(Sequence);
		std::swap(Ids.front(), Ids.back());
		for (size_t i = 1; i < Most; ++i)
		{
			std::swap(Ids[i], Ids[i + Random() % (Ids.size() - i)]);
		}
		Ids.resize(Most);
	}
	return Ids;
}

std::string Print(double Number)
{
	char Text[32];
	std::snprintf(Text, sizeof(Text), "%.9g", Number);
	return Text;
}

/** What came of a comparison of all numbers of one run. */
struct FTally
{
	uint64_t Numbers = 0;   // compared
	uint64_t NotFinite = 0; // NaN or infinity here, or within the bounds of it: Vulkan promises nothing of these
	uint64_t Loose = 0;     // compared, but within the bounds anything from a tenth of the value on is right
	uint64_t Measured = 0;  // farther than the runs by chance went: each operation was moved alone
	std::map<std::string, uint64_t> Alone;
	std::map<std::string, std::string> First; // of those, the first number
	double LargestShare = 0;                  // of the tolerance
};

void AddTo(FTally& Sum, const FTally& One)
{
	Sum.Numbers += One.Numbers;
	Sum.NotFinite += One.NotFinite;
	Sum.Loose += One.Loose;
	Sum.Measured += One.Measured;
	Sum.LargestShare = std::max(Sum.LargestShare, One.LargestShare);
	for (const auto& [Name, Count] : One.Alone)
	{
		Sum.Alone[Name] += Count;
	}
}

FTally Compare(const FMovedModel& Model, const std::map<std::string, std::vector<double>>& Theirs)
{
	FTally Tally;
	const std::vector<double>& Ours = Model.GetNumbers();
	std::vector<std::vector<double>> Walks;
	for (uint32_t Seed = 1; Seed <= NumWalks; ++Seed)
	{
		Walks.push_back(Model.Walk(Seed));
	}
	for (size_t i = 0; i < Ours.size(); ++i)
	{
		if (!Model.GetWritten()[i])
		{
			continue;
		}
		double Farthest = 0;
		for (const std::vector<double>& One : Walks)
		{
			Farthest = std::max(Farthest, std::isfinite(One[i]) ? std::fabs(One[i] - Ours[i]) : INFINITY);
		}
		if (!std::isfinite(Ours[i]) || !std::isfinite(Farthest))
		{
			++Tally.NotFinite;
			continue;
		}
		const double Rounding = 0x1p-23 * std::fabs(Ours[i]) + 0x1p-126; // of ours; numbers below that may be flushed
		double Largest = 0;
		for (const auto& [Name, Results] : Theirs)
		{
			const double Difference = std::fabs(Results[i] - Ours[i]);
			Largest = std::isfinite(Difference) ? std::max(Largest, Difference) : INFINITY;
		}
		if (Largest > Farthest + Rounding)
		{
			++Tally.Measured;
			Farthest = std::max(Farthest, Model.FindFarthest(i));
		}
		const double Tolerance = Farthest + Rounding;
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
			std::string Text = std::to_string(i) + ": drydock " + Print(Ours[i]) + " +- " + Print(Tolerance);
			for (const auto& [Other, Results] : Theirs)
			{
				Text += ", " + Other + " " + Print(Results[i]);
			}
			Tally.First[Name] = Text;
		}
	}
	return Tally;
}

/** The drivers that are here; of the others it is said. */
std::vector<FVulkanDriver*> FindDrivers()
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
	return Drivers;
}

/** One shader by all makers, with both kinds of pictures. */
FTally CompareShader(const std::string& Name, const FShaderCompileRequest& Request,
	const std::shared_ptr<const FShaderReflection>& Reflection, std::set<std::string>& OutRefused)
{
	FTally Sum;
	const std::vector<FVulkanDriver*> Drivers = FindDrivers();
	FInspectedShader Inspected(Request, *Reflection, true);
	for (const EMadePictures Pictures : {EMadePictures::Smooth, EMadePictures::Noisy})
	{
		std::map<std::string, std::vector<double>> Theirs;
		std::vector<std::future<std::string>> Faults; // the drivers run while the model does
		for (FVulkanDriver* const Driver : Drivers)
		{
			Faults.push_back(std::async(std::launch::async,
				[&Request, &Reflection, Driver, Pictures, &Numbers = Theirs[Driver->Name]]
				{
					FMadeArguments Made(*Reflection, Pictures, 1);
					const std::string Fault =
						Driver->Backend->Run(Request, Reflection, Made.GetArgs(), Made.GetWhole());
					Numbers = Made.ReadResults();
					return Fault;
				}));
		}
		const FMovedModel Model(Inspected, *Reflection, Pictures);
		for (size_t i = 0; i < Drivers.size(); ++i)
		{
			if (const std::string Fault = Faults[i].get(); !Fault.empty())
			{
				OutRefused.insert(Name + " on " + Drivers[i]->Name + ": " + Fault);
				Theirs.erase(Drivers[i]->Name);
			}
		}
		const FTally Tally = Compare(Model, Theirs);
		AddTo(Sum, Tally);
		const std::string Which = Name + (Pictures == EMadePictures::Smooth ? " smooth" : " noisy");
		for (const auto& [Who, Count] : Tally.Alone)
		{
			std::printf("%s: %s stands alone in %llu of %llu numbers; %s\n", Which.c_str(), Who.c_str(),
				static_cast<unsigned long long>(Count), static_cast<unsigned long long>(Tally.Numbers),
				Tally.First.at(Who).c_str());
		}
		EXPECT_EQ(0u, Tally.Alone.count("drydock")) << Which << ": " << Tally.First.at("drydock");
	}
	for (FVulkanDriver* const Driver : Drivers)
	{
		Driver->Backend->ForgetShaders(); // thousands of pipelines would take gigabytes
	}
	return Sum;
}

void PrintTally(int NumShaders, const FTally& Sum, const std::set<std::string>& Refused)
{
	for (const std::string& Line : Refused)
	{
		std::printf("not compared: %s\n", Line.c_str());
	}
	std::printf("%d shaders, %llu numbers compared, %llu of them loosely, %llu not finite, %llu measured\n", NumShaders,
		static_cast<unsigned long long>(Sum.Numbers), static_cast<unsigned long long>(Sum.Loose),
		static_cast<unsigned long long>(Sum.NotFinite), static_cast<unsigned long long>(Sum.Measured));
	for (const auto& [Who, Count] : Sum.Alone)
	{
		std::printf("%s stands alone in %llu\n", Who.c_str(), static_cast<unsigned long long>(Count));
	}
	std::printf("largest difference: %.2f of the tolerance\n", Sum.LargestShare);
}

/** Skipped with a message where no driver is here. */
class VulkanOracles : public testing::Test
{
protected:
	void SetUp() override
	{
		if (FindDrivers().empty())
		{
			GTEST_SKIP() << "no Vulkan driver of a CPU is here";
		}
	}
};

} // namespace

TEST_F(VulkanOracles, EveryShippedShaderByThreeMakers)
{
	int NumShaders = 0;
	std::set<std::string> Refused;
	FTally Sum;
	const char* const Only = std::getenv("DRYDOCK_ORACLES_ONLY"); // part of a class's name
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			const std::string Name = Type.GetName();
			const std::string File = Type.GetShaderFilename();
			if (Type.GetFrequency() == SF_Vertex || (Only && Name.find(Only) == std::string::npos) ||
				(!File.starts_with("/Engine/") && !File.starts_with("/Drydock/")))
			{
				return;
			}
			for (const int32 Id : ListPermutations(Type))
			{
				const FShaderRef Shader(Type.FindOrCreateShader(Id));
				const FShaderCompileRequest Request =
					MakeShaderCompileRequest(Shader, Type.GetRootParametersMetadata());
				AddTo(Sum, CompareShader(Name + " permutation " + std::to_string(Id), Request,
							   GetShaderReflection(Shader), Refused));
				++NumShaders;
			}
		});
	PrintTally(NumShaders, Sum, Refused);
	if (!Only)
	{
		EXPECT_GT(NumShaders, 40); // there are that many classes in passes/
		EXPECT_GT(Sum.Numbers, 100'000u);
	}
	EXPECT_LT(Sum.Loose, Sum.Numbers / 4);
}

TEST_F(VulkanOracles, ThreadsThatWorkTogetherByThreeMakers)
{
	AddShaderDirectory("/Samples", DRYDOCK_TEST_SOURCE_DIR "/tests/Shaders");
	std::set<std::string> Refused;
	FTally Sum;
	for (const char* const Entry : {"GaussianCS", "HistogramCS"})
	{
		const FShaderCompileRequest Request =
			MakeShaderCompileRequest("/Samples/Samples.usf", Entry, EShaderStage::Compute);
		AddTo(Sum, CompareShader(Entry, Request, std::make_shared<FShaderReflection>(ReflectShader(Request)), Refused));
	}
	PrintTally(2, Sum, Refused);
	EXPECT_TRUE(Refused.empty());
	EXPECT_GT(Sum.Numbers, 3000u);
	EXPECT_LT(Sum.Loose, Sum.Numbers / 4);
}
