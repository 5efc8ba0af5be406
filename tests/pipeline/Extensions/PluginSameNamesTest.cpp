// A plugin whose global classes and functions bear all the names that drydock's effects have, the articles' and the
// engine's among them (tests/plugins/SameNames), gets its own, and drydock's effects still work beside it.
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "Run/Run.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

using namespace Drydock;

namespace
{

const std::string OwnBlur = R"(, "extensions": [{"type": "DualKawaseBlur", "pass": "MotionBlur", "PassNum": 3}])";
const std::string SameNames =
	R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libSameNames.so"], "cvars": {"r.SameNames": 1})";

FImage RunWith(const std::string& More)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText =
		R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, "showFlags": {"Bloom": false})" + More + "}";
	return RunConfig(Options).SceneLinear.ToImage();
}

/** Half of Picture plus one, within what two half floats of up to 32 resolve. */
void ExpectHalfPlusOne(const FImage& Picture, const FImage& Result)
{
	ASSERT_EQ(Picture.Width, Result.Width);
	ASSERT_EQ(Picture.Height, Result.Height);
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		for (int X = 0; X < Picture.Width; ++X)
		{
			const double Expected = 0.5 * static_cast<double>(Picture.Get(X, Y, 1)) + 1.0;
			ASSERT_NEAR(Expected, Result.Get(X, Y, 1), Expected / 256) << "pixel (" << X << ", " << Y << ")";
		}
	}
}

namespace Files = std::filesystem;

void AddWords(const Files::path& Path, std::set<std::string>& Words)
{
	std::ifstream Stream(Path);
	const std::string Text((std::istreambuf_iterator<char>(Stream)), {});
	static const std::regex Word("[A-Za-z_][A-Za-z_0-9]*");
	for (std::sregex_iterator Each(Text.begin(), Text.end(), Word), End; Each != End; ++Each)
	{
		Words.insert(Each->str());
	}
}

/** Words of all headers below a folder of the tree. */
void AddWordsOfHeaders(const std::string& Folder, std::set<std::string>& Words)
{
	for (const auto& Entry : Files::recursive_directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/" + Folder))
	{
		if (Entry.path().extension() == ".h" || Entry.path().extension() == ".inl")
		{
			AddWords(Entry.path(), Words);
		}
	}
}

/** Classes and functions that a library exports, those of namespace Drydock without it. */
std::set<std::string> ReadExportedNames(const std::string& Library)
{
	std::set<std::string> Names;
	FILE* const Pipe = popen(("nm -DC --defined-only '" + Library + "'").c_str(), "r");
	const std::regex Symbol(
		"[0-9a-f]+ [A-Za-z] (?:(?:vtable|typeinfo) for )?(?:Drydock::)?([A-Z][A-Za-z0-9]*)(?:\\(|::|\n).*\n");
	char Line[1 << 16];
	while (Pipe != nullptr && std::fgets(Line, sizeof(Line), Pipe) != nullptr)
	{
		const std::string Text = Line;
		std::smatch Match;
		if (std::regex_match(Text, Match, Symbol))
		{
			Names.insert(Match[1]);
		}
	}
	EXPECT_TRUE(Pipe != nullptr && pclose(Pipe) == 0) << "nm cannot read " << Library;
	return Names;
}

} // namespace

// The other way round than its list is made: what the effects export, but for what other rooms declare too.
TEST(PluginSameNames, ThePluginHasEveryNameThatAnEffectExports)
{
	std::set<std::string> Known;
	AddWords(DRYDOCK_TEST_BINARY_DIR "/tests/plugins/names/EffectNames.inl", Known);
	for (const char* Name : {"FDualKawaseBlur", "FUnityBloomInputs", "FREDPostProcessPS", "FToonBloomParameters",
			 "FBloomSetupPS", "AddTonemapPass", "AddREDPostProcessPass", "GetToonBloomMode"})
	{
		EXPECT_EQ(1u, Known.count(Name)) << Name;
	}
	for (const char* Folder : {"rdg", "settings", "passes/World", "passes/Scene"})
	{
		AddWordsOfHeaders(Folder, Known);
	}
	Known.insert("DiaphragmDOF"); // a namespace, which no class can be called
	const std::set<std::string> Exported = ReadExportedNames(DRYDOCK_TEST_BINARY_DIR "/lib/libdrydock_passes.so");
	EXPECT_GT(Exported.size(), 100u);
	for (const std::string& Name : Exported)
	{
		EXPECT_EQ(1u, Known.count(Name)) << "SameNames lacks " << Name << ": see ListEffectNames.cmake";
	}
}

TEST(PluginSameNames, APluginGetsItsOwnClassesAndFunctions)
{
	ExpectHalfPlusOne(RunWith(""), RunWith(SameNames));
}

TEST(PluginSameNames, DrydocksEffectOfTheNameWorksInTheSameFrame)
{
	ExpectHalfPlusOne(RunWith(OwnBlur), RunWith(OwnBlur + SameNames));
}

TEST(PluginSameNames, DrydocksEffectOfTheNameIsTheSameAfterwards)
{
	const FImage Before = RunWith(OwnBlur);
	RunWith(SameNames);
	EXPECT_EQ(Before.Values, RunWith(OwnBlur).Values);
	EXPECT_NE(Before.Values, RunWith("").Values);
}
