// A config that inserts 20,000 passes takes ten times as long as one of 2,000, not a hundred times.
#include <gtest/gtest.h>

#include "Run/Run.h"

#include <ctime>
#include <string>

using namespace Drydock;

namespace
{

std::string MakeConfig(int NumPasses)
{
	std::string Text = R"({"scene": {"file": "scenes/hazards.exr"}, "passes": [)";
	for (int Pass = 0; Pass < NumPasses; ++Pass)
	{
		Text += Pass == 0 ? "" : ",\n";
		Text += R"({"type": "Tint", "at": "MotionBlur"})";
	}
	return Text + "]}";
}

/** Seconds of this process's own until the graph is compiled and described. */
double Compile(int NumPasses)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/many_passes.json";
	Options.ConfigText = MakeConfig(NumPasses);
	Options.bExecute = false;
	const std::clock_t Begin = std::clock();
	const FRunResult Result = RunConfig(Options);
	EXPECT_LT(static_cast<size_t>(NumPasses), Result.Graph.Passes.size());
	return static_cast<double>(std::clock() - Begin) / CLOCKS_PER_SEC;
}

} // namespace

TEST(ManyPasses, TakeTimeByTheirNumber)
{
	const double OfFew = Compile(2'000);
	EXPECT_LT(Compile(20'000), 40.0 * OfFew) << "2,000 passes: " << OfFew << " s";
}
