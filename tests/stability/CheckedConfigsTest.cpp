// Every shipped config under `--check`, in a part of its picture: what is found is stated (Inspect/StatedFindings.h),
// and nothing else is.
#include <gtest/gtest.h>

#include "Inspect/StatedFindings.h"

#include "Inspect/CheckCapture.h"
#include "Run/Run.h"

#include <algorithm>
#include <filesystem>

namespace Stability
{

using Drydock::FStatedFinding;
using Drydock::StatedFindings;

namespace
{

std::vector<std::string> FindShippedConfigs()
{
	std::vector<std::string> Configs;
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/configs"))
	{
		if (Entry.path().extension() == ".json")
		{
			Configs.push_back(Entry.path().string());
		}
	}
	std::sort(Configs.begin(), Configs.end());
	return Configs;
}

bool IsStated(const std::string& Check, const std::string& File)
{
	return std::any_of(std::begin(StatedFindings), std::end(StatedFindings),
		[&](const FStatedFinding& Stated) { return Stated.Check == Check && Stated.File == File; });
}

class CheckedConfig : public testing::TestWithParam<std::string>
{
};

} // namespace

TEST_P(CheckedConfig, HasNothingThatIsNotStated)
{
	Drydock::FRunOptions Options;
	Options.ConfigFile = GetParam();
	Options.bUseBudget = false;
	Options.bExecute = false;
	const FIntRect View = Drydock::RunConfig(Options).ViewRect;
	const int X = View.Width() / 2 - 32, Y = View.Height() / 2 - 24; // the middle, where characters stand
	Options.bExecute = true;
	Options.ViewRects = {{X, Y, X + 64, Y + 48}};
	Drydock::FCheckCapture Capture(Drydock::MakeCheckSet({"all"}));
	{
		const Drydock::FScopedDispatchObserver Scope(Capture);
		Drydock::RunConfig(Options);
	}
	for (const Drydock::FPassFinding& Found : Capture.GetFindings())
	{
		const std::string Check = Drydock::GetCheckName(Found.Finding.Check);
		const std::string File = std::filesystem::path(Found.Finding.File).filename().string();
		EXPECT_TRUE(IsStated(Check, File))
			<< Check << " " << File << ":" << Found.Finding.Line << " in " << Found.Pass << ": " << Found.Finding.What;
	}
}

INSTANTIATE_TEST_SUITE_P(Shipped, CheckedConfig, testing::ValuesIn(FindShippedConfigs()),
	[](const testing::TestParamInfo<std::string>& Info) { return std::filesystem::path(Info.param).stem().string(); });

} // namespace Stability
