// Every cell of the stability table, and that the table has a row for everything there is.
#include <gtest/gtest.h>

#include "CheckPass.h"
#include "Runs.h"

#include "ExtensionFactory.h"
#include "PassFactory.h"

#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace Stability
{

namespace
{

/** A name that gtest accepts. */
std::string MakeName(std::string Name)
{
	for (char& Letter : Name)
	{
		Letter = std::isalnum(static_cast<unsigned char>(Letter)) ? Letter : '_';
	}
	return Name;
}

struct FTestedCell
{
	const FRow* Row;
	EHazard Hazard;

	const FCell& Get() const { return Row->Cells[Hazard]; }
};

void PrintTo(const FTestedCell& Cell, std::ostream* Stream)
{
	const char* Meaning = Expectations[static_cast<size_t>(Cell.Get().Expect)].Meaning;
	*Stream << Cell.Get().Place << ": " << Meaning << ", because: " << Cell.Get().Reason;
}

std::vector<FTestedCell> GetCells(const char* Folder)
{
	std::vector<FTestedCell> Cells;
	for (const FRow* Row : GetRows(Folder))
	{
		for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
		{
			if (Row->Cells.at(Hazard).Expect != EExpect::DoesNotApply)
			{
				Cells.push_back({Row, static_cast<EHazard>(Hazard)});
			}
		}
	}
	return Cells;
}

std::string GetCellName(const testing::TestParamInfo<FTestedCell>& Info)
{
	return MakeName(Info.param.Row->Name) + "__" + Hazards[static_cast<size_t>(Info.param.Hazard)].Name;
}

using PassCells = testing::TestWithParam<FTestedCell>;

class BlendCells : public PassCells
{
};

} // namespace

TEST_P(PassCells, AreAsTheTableSays)
{
	EXPECT_EQ("", CheckPass(*GetParam().Row, GetParam().Hazard));
}

TEST_P(BlendCells, AreAsTheTableSays)
{
	EXPECT_EQ("", CheckBlend(*GetParam().Row, GetParam().Hazard));
}

INSTANTIATE_TEST_SUITE_P(Frame, PassCells, testing::ValuesIn(GetCells("pipeline/")), GetCellName);
INSTANTIATE_TEST_SUITE_P(Table, PassCells, testing::ValuesIn(GetCells("passes/")), GetCellName);
INSTANTIATE_TEST_SUITE_P(Table, BlendCells, testing::ValuesIn(GetCells("settings/")), GetCellName);

TEST(StabilityTable, HasARowForEveryPassAndExtensionOfAConfig)
{
	std::set<std::string> Types;
	for (const Drydock::FPassFactory* Factory : Drydock::GetPassFactories())
	{
		Types.insert(Factory->Type);
	}
	for (const Drydock::FExtensionFactory* Factory : Drydock::GetExtensionFactories())
	{
		Types.insert(Factory->Type);
	}
	std::set<std::string> Covered;
	for (const FRow* Row : GetRows("passes/"))
	{
		Covered.insert(Row->Words.begin(), Row->Words.end());
	}
	EXPECT_EQ(Types, Covered);
}

/** Headers of passes/ that add no pass, or are a part of one whose own header has a row. */
TEST(StabilityTable, HasARowForEveryHeaderOfPasses)
{
	const std::filesystem::path Passes = DRYDOCK_TEST_SOURCE_DIR "/passes";
	std::set<std::string> Headers;
	for (const char* Room : {"Screen", "Blur", "Exposure", "Bloom", "Tonemap", "Lens", "Toon"})
	{
		for (const auto& Entry : std::filesystem::directory_iterator(Passes / Room))
		{
			const std::string Name = Entry.path().lexically_relative(Passes).string();
			if (Name.ends_with(".h") && !Name.ends_with("Shaders.h")) // classes that passes and native kernels share
			{
				Headers.insert(Name);
			}
		}
	}
	for (const char* Name : {"Bloom/PostProcessFFTBloomKernel.h", "Blur/DualKawaseBlur.h",
			 "Blur/DualKawaseBlurErrors.h", "Blur/DualKawaseBlurOutput.h", "Blur/DualKawaseBlurWidth.h",
			 "Blur/KernelAudit.h", "Blur/KernelAuditErrors.h", "Exposure/ExposureFactory.h",
			 "Exposure/ExposureMetering.h", "Exposure/PostProcessEyeAdaptationParameters.h", "Screen/BuiltinTextures.h",
			 "Screen/DrawRegion.h", "Screen/LimitErrors.h", "Screen/RasterTarget.h", "Screen/SampleSteps.h",
			 "Screen/ScreenShaderPass.h", "Screen/TextureAssets.h", "Tonemap/ColorGrading.h", "Tonemap/ColorMatrix.h",
			 "Tonemap/TonemapLens.h", "Tonemap/TonemapOutputDevice.h"})
	{
		EXPECT_EQ(1u, Headers.erase(Name)) << Name << " is no longer there";
	}
	std::set<std::string> Covered;
	for (const FRow* Row : GetRows("passes/"))
	{
		Covered.insert(Row->Header.substr(std::string("passes/").size()));
	}
	EXPECT_EQ(Headers, Covered);
}

TEST(StabilityTable, HasARunForEveryRowOfAPass)
{
	std::set<std::string> Rows;
	for (const char* Folder : {"pipeline/", "passes/"})
	{
		for (const FRow* Row : GetRows(Folder))
		{
			EXPECT_TRUE(Rows.insert(Row->Name).second) << Row->Name << " has two rows";
			EXPECT_EQ(1u, GetRuns().count(Row->Name)) << Row->Name << " has no run";
		}
	}
	for (const auto& [Name, Run] : GetRuns())
	{
		EXPECT_EQ(1u, Rows.count(Name)) << Name << " has no row";
	}
}

TEST(StabilityTable, NamesTheLineOfAMistake)
{
	const auto GetMistake = [](const std::string& Lines) -> std::string
	{
		try
		{
			ReadTable({{"File", "# A comment.\nAll = NaN..TenThousand Finite:\n\t\ta reason\n" + Lines}});
			return "";
		}
		catch (const std::runtime_error& Mistake)
		{
			return Mistake.what();
		}
	};
	EXPECT_EQ("", GetMistake("[A: b] H.h Word: All\n\tNaN Zero 1e-3: own cells replace\n[C] H.h: [A: b] All"));
	const std::pair<const char*, const char*> Mistakes[] = {
		{"Name: NaN", "File:4: expected [Row] Header.h, or Name = cells, or a tab and cells"},
		{"\tNaN Zero: a reason", "File:4: there is no row above"},
		{"[A] H.h", "File:4: A has no cell for NaN"},
		{"[A]", "File:4: expected a header after [Row]"},
		{"[A] : All", "File:4: expected a header after [Row]"},
		{"[A] H.h: All\n[B] H.h: [C] All", "File:5: there is no row C"},
		{"[A] H.h: Al", "File:4: there are no cells of the name Al"},
		{"A = All\nA = Huge Zero: a reason", "File:5: Huge is given twice, first at File:2"},
		{"[A] H.h: All\n\tHuge Zero: a reason\n\tHuge Zero: a reason", "File:6: Huge is given twice, first at File:5"},
		{"A = NaN Zero: a reason.", "File:4: expected a colon and a reason without a full stop"},
		{"A = 1: a reason", "File:4: expected hazards, an expectation and perhaps a bound: 1"},
		{"A = Zero: a reason", "File:4: expected hazards, an expectation and perhaps a bound: Zero"},
		{"A = NaN Zer: a reason", "File:4: there is no expectation Zer"},
		{"A = NaN..Hug Zero: a reason", "File:4: there is no hazard Hug"},
	};
	for (const auto& [Lines, Expected] : Mistakes)
	{
		EXPECT_EQ(Expected, GetMistake(Lines));
	}
}

} // namespace Stability
