// Which files a run writes: those that the config, the command line or the caller asks for.
#include <gtest/gtest.h>

#include "Run/Run.h"
#include "Run/RunOutputs.h"
#include "SequenceTestUtils.h"
#include "Text/ConfigErrors.h"

using namespace Drydock;
using namespace SequenceTest;

namespace
{

FRunOptions SmallScene(const std::string& Outputs = "")
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/two_boxes.exr"}, "outputs": {"dump": ["Tonemap"])" + Outputs + "}}";
	return Options;
}

/** Names of what a run writes, sorted; those that begin with a dot are drydock's own. */
std::set<std::string> GetWritten(const FRunOptions& Options)
{
	const FTemporaryFolder Temporary("drydock_write");
	WriteRunOutputs(RunConfig(Options), (Temporary.Path / "out").string());
	std::set<std::string> Names;
	for (const Files::directory_entry& Entry : Files::recursive_directory_iterator(Temporary.Path / "out"))
	{
		const std::string Name = Entry.path().filename().string();
		if (Entry.is_regular_file() && Name[0] != '.')
		{
			Names.insert(Entry.path().extension().string() == ".json" ? Name : Entry.path().extension().string());
		}
	}
	return Names;
}

using FNames = std::set<std::string>;

} // namespace

TEST(RunOutputKinds, AreAllByDefault)
{
	EXPECT_EQ((FNames{".png", ".exr", ".dot", "run.json", "timing.json", "trace.json"}), GetWritten(SmallScene()));
}

TEST(RunOutputKinds, OfTheConfigAndOfTheCommandLineWhichBeatsIt)
{
	FRunOptions Options = SmallScene(R"(, "write": ["png", "dot"])");
	EXPECT_EQ((FNames{".png", ".dot", "run.json"}), GetWritten(Options));
	Options.Write = FOutputKinds{EOutputKind::Exr};
	EXPECT_EQ((FNames{".exr", "run.json"}), GetWritten(Options));
}

TEST(RunOutputKinds, OfTheCallerOnlyWhereNobodySaysMore)
{
	FRunOptions Options = SmallScene();
	Options.WriteByDefault = {EOutputKind::Png};
	EXPECT_EQ((FNames{".png", "run.json"}), GetWritten(Options));
	Options = SmallScene(R"(, "write": ["json"])");
	Options.WriteByDefault = {EOutputKind::Png};
	EXPECT_EQ((FNames{"run.json", "timing.json", "trace.json"}), GetWritten(Options));
}

TEST(RunOutputKinds, RunJsonNamesWhatIsThere)
{
	FRunOptions Options = SmallScene();
	Options.Write = FOutputKinds{EOutputKind::Png};
	const std::string RunJson = RunConfig(Options).RunJson;
	EXPECT_NE(std::string::npos, RunJson.find("final.png"));
	EXPECT_NE(std::string::npos, RunJson.find(".Tonemap.ViewFamilyTexture.png"))
		<< RunJson.substr(RunJson.find("\"outputs\""), 400);
	EXPECT_EQ(std::string::npos, RunJson.find(".exr\"", RunJson.find("\"outputs\"")));
	EXPECT_EQ(std::string::npos, RunJson.find("timing.json"));
}

TEST(RunOutputKinds, UnknownOnesAreToldWithTheNearest)
{
	try
	{
		RunConfig(SmallScene(R"(, "write": ["png", "ext"])"));
		FAIL();
	}
	catch (const FError& Error)
	{
		const FDiagnostic& Said = Error.GetDiagnostics().at(0);
		EXPECT_EQ(ErrorUnknownValue, Said.Code);
		EXPECT_NE(std::string::npos, Said.ToString().find("/outputs/write/1")) << Said.ToString();
		EXPECT_NE(std::string::npos, Said.Message.find("did you mean exr?")) << Said.Message;
	}
}
