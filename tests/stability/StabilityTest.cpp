// Every cell of the stability table, and that the table has a row for everything there is.
#include <gtest/gtest.h>

#include "Cases.h"
#include "CheckPass.h"

#include "ExtensionFactory.h"
#include "PassFactory.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>

namespace Stability
{

namespace
{

std::vector<const FPassRow*> GetPassRows()
{
	std::vector<const FPassRow*> Rows;
	for (const auto GetRows : {GetSamplingRows, GetBloomRows, GetBlurRows, GetToonRows, GetREDRows, GetLensRows,
			 GetExposureRows, GetDisplayRows})
	{
		for (const FPassRow& Row : GetRows())
		{
			Rows.push_back(&Row);
		}
	}
	return Rows;
}

std::vector<const FPassRow*> GetFrameRowPointers()
{
	std::vector<const FPassRow*> Rows;
	for (const FPassRow& Row : GetFrameRows())
	{
		Rows.push_back(&Row);
	}
	return Rows;
}

std::vector<const FBlendRow*> GetBlendRowPointers()
{
	std::vector<const FBlendRow*> Rows;
	for (const FBlendRow& Row : GetBlendRows())
	{
		Rows.push_back(&Row);
	}
	return Rows;
}

/** What gtest takes for a name. */
std::string MakeName(const char* Name)
{
	std::string Text;
	for (const char* At = Name; *At != 0; ++At)
	{
		Text += std::isalnum(static_cast<unsigned char>(*At)) ? *At : '_';
	}
	return Text;
}

template<typename TRow>
std::vector<std::pair<const TRow*, EHazard>> MakeCells(const std::vector<const TRow*>& Rows)
{
	std::vector<std::pair<const TRow*, EHazard>> Cells;
	for (const TRow* Row : Rows)
	{
		for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
		{
			if (Row->Cells[static_cast<EHazard>(Hazard)].Expect != EExpect::DoesNotApply)
			{
				Cells.emplace_back(Row, static_cast<EHazard>(Hazard));
			}
		}
	}
	return Cells;
}

struct FCellName
{
	template<typename TInfo>
	std::string operator()(const TInfo& Info) const
	{
		return MakeName(Info.param.first->Name) + "__" + Hazards[static_cast<size_t>(Info.param.second)].Name;
	}
};

template<typename TRow>
std::string Describe(const TRow& Row, EHazard Hazard)
{
	const FCell& Cell = Row.Cells[Hazard];
	return std::string(Expectations[static_cast<size_t>(Cell.Expect)].Meaning) +
		   ", because: " + std::string(Cell.Reason);
}

class PassCells : public testing::TestWithParam<std::pair<const FPassRow*, EHazard>>
{
};

class BlendCells : public testing::TestWithParam<std::pair<const FBlendRow*, EHazard>>
{
};

} // namespace

void PrintTo(const std::pair<const FPassRow*, EHazard>& Cell, std::ostream* Stream)
{
	*Stream << FCellName()(testing::TestParamInfo(Cell, 0));
}

void PrintTo(const std::pair<const FBlendRow*, EHazard>& Cell, std::ostream* Stream)
{
	*Stream << FCellName()(testing::TestParamInfo(Cell, 0));
}

TEST_P(PassCells, AreAsTheTableSays)
{
	const auto& [Row, Hazard] = GetParam();
	EXPECT_EQ("", CheckPass(*Row, Hazard))
		<< Row->Name << ", " << Hazards[static_cast<size_t>(Hazard)].Title << ": " << Describe(*Row, Hazard);
}

TEST_P(BlendCells, AreAsTheTableSays)
{
	const auto& [Row, Hazard] = GetParam();
	EXPECT_EQ("", CheckBlend(*Row, Hazard))
		<< Row->Name << ", " << Hazards[static_cast<size_t>(Hazard)].Title << ": " << Describe(*Row, Hazard);
}

INSTANTIATE_TEST_SUITE_P(Frame, PassCells, testing::ValuesIn(MakeCells(GetFrameRowPointers())), FCellName());
INSTANTIATE_TEST_SUITE_P(Table, PassCells, testing::ValuesIn(MakeCells(GetPassRows())), FCellName());
INSTANTIATE_TEST_SUITE_P(Table, BlendCells, testing::ValuesIn(MakeCells(GetBlendRowPointers())), FCellName());

namespace
{

std::set<std::string> GetCoveredFactories()
{
	std::set<std::string> Covered;
	for (const FPassRow* Row : GetPassRows())
	{
		std::istringstream Names(Row->Factories);
		for (std::string Name; Names >> Name;)
		{
			Covered.insert(Name);
		}
	}
	return Covered;
}

} // namespace

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
	EXPECT_EQ(Types, GetCoveredFactories());
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
			 "Screen/ScreenShaderPass.h", "Screen/TextureAssets.h", "Tonemap/ColorGrading.h", "Tonemap/TonemapLens.h",
			 "Tonemap/TonemapOutputDevice.h"})
	{
		EXPECT_EQ(1u, Headers.erase(Name)) << Name << " is no longer there";
	}
	std::set<std::string> Covered;
	for (const FPassRow* Row : GetPassRows())
	{
		Covered.insert(Row->Header);
	}
	EXPECT_EQ(Headers, Covered);
}

} // namespace Stability
