// The fuzzers' checks over their corpus, so that they run without clang too; and over every cut of it.
#include <gtest/gtest.h>

#include "SceneFile/SceneFile.h"
#include "fuzz/FuzzChecks.h"
#include "fuzz/FuzzImageChecks.h"
#include "fuzz/FuzzIniChecks.h"
#include "fuzz/FuzzOtherChecks.h"
#include "fuzz/FuzzSpirvChecks.h"
#include "fuzz/FuzzViewStateChecks.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

using namespace Drydock;

namespace
{

std::vector<std::filesystem::path> FindCorpus(const char* Name)
{
	std::vector<std::filesystem::path> Files;
	for (const auto& Entry :
		std::filesystem::directory_iterator(std::string(DRYDOCK_TEST_SOURCE_DIR "/tests/fuzz/corpus/") + Name))
	{
		Files.push_back(Entry.path());
	}
	std::sort(Files.begin(), Files.end());
	return Files;
}

std::string Read(const std::filesystem::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

std::string GetName(const testing::TestParamInfo<std::filesystem::path>& Info)
{
	return Info.param.stem().string();
}

using FPath = std::filesystem::path;

class SettingsTextCorpus : public testing::TestWithParam<FPath>
{
};

class ConfigJsonCorpus : public testing::TestWithParam<FPath>
{
};

class IniCorpus : public testing::TestWithParam<FPath>
{
};

class OtherTextCorpus : public testing::TestWithParam<FPath>
{
};

/** Files whose names begin with what they are: "forged_window.exr". */
class FNamedCorpus : public testing::TestWithParam<FPath>
{
protected:
	bool Is(const char* Kind) const { return GetParam().stem().string().starts_with(Kind); }
};

class ExrCorpus : public FNamedCorpus
{
};

class PictureCorpus : public FNamedCorpus
{
};

class SpirvCorpus : public FNamedCorpus
{
};

class ViewStateCorpus : public FNamedCorpus
{
};

/** Cuts and flips at a stride that makes about Number of them. */
std::vector<std::string> Damage(const std::string& Bytes, size_t Number)
{
	std::vector<std::string> Result;
	const size_t Stride = std::max<size_t>(1, Bytes.size() / Number);
	for (size_t At = 0; At < Bytes.size(); At += Stride)
	{
		Result.push_back(Bytes.substr(0, At));
		for (const int Flip : {0xFF, 0x01, 0x80})
		{
			Result.push_back(Bytes);
			Result.back()[At] = static_cast<char>(Result.back()[At] ^ Flip);
		}
	}
	return Result;
}

} // namespace

TEST_P(SettingsTextCorpus, Holds)
{
	EXPECT_EQ("", CheckSettingsText(Read(GetParam())));
}

TEST_P(SettingsTextCorpus, HoldsCutAnywhere)
{
	const std::string Text = Read(GetParam());
	for (size_t Length = 0; Length < Text.size(); ++Length)
	{
		ASSERT_EQ("", CheckSettingsText(Text.substr(0, Length))) << Length;
	}
}

TEST_P(ConfigJsonCorpus, Holds)
{
	EXPECT_EQ("", CheckConfigJson(Read(GetParam())));
}

TEST_P(ConfigJsonCorpus, HoldsCutAnywhere)
{
	const std::string Text = Read(GetParam());
	for (size_t Length = 0; Length < Text.size(); ++Length)
	{
		ASSERT_EQ("", CheckConfigJson(Text.substr(0, Length))) << Length;
	}
}

TEST_P(IniCorpus, HoldsWholeAndCutAnywhere)
{
	const std::string Text = Read(GetParam());
	for (size_t Length = 0; Length <= Text.size(); ++Length)
	{
		ASSERT_EQ("", CheckIniText(Text.substr(0, Length))) << Length;
	}
}

TEST_P(OtherTextCorpus, HoldsWholeAndDamaged)
{
	EXPECT_EQ("", CheckOtherText(Read(GetParam())));
	for (const std::string& Text : Damage(Read(GetParam()), 100))
	{
		ASSERT_EQ("", CheckOtherText(Text)) << Text;
	}
}

TEST_P(ViewStateCorpus, HoldsWholeAndDamaged)
{
	EXPECT_EQ("", CheckViewStateBytes(Read(GetParam())));
	for (const std::string& Bytes : Damage(Read(GetParam()), 200))
	{
		ASSERT_EQ("", CheckViewStateBytes(Bytes));
	}
}

TEST_P(ViewStateCorpus, IsReadUnlessForged)
{
	bool bRead = true;
	try
	{
		UnpackViewStates(SealViewState(Read(GetParam())), "view_state.bin");
	}
	catch (const FError&)
	{
		bRead = false;
	}
	EXPECT_EQ(!Is("forged"), bRead);
}

TEST_P(ExrCorpus, Holds)
{
	EXPECT_EQ("", CheckImageFile(GetParam().string()));
}

TEST_P(ExrCorpus, HoldsDamaged)
{
	for (const std::string& Bytes : Damage(Read(GetParam()), 15))
	{
		ASSERT_EQ("", CheckExrBytes(Bytes));
	}
}

TEST_P(ExrCorpus, IsASceneUnlessForged)
{
	if (Is("cut") || Is("found"))
	{
		GTEST_SKIP() << "its header may be whole";
	}
	FConfig Config;
	Config.Scene.File.Value = GetParam().string();
	Config.Scene.File.Place.Line = 1;
	bool bScene = false;
	try
	{
		bScene = FSceneFile(Config).GetExtent().X > 0;
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
	}
	EXPECT_EQ(!Is("forged"), bScene);
}

TEST_P(PictureCorpus, IsReadFromFileAndMemory)
{
	EXPECT_EQ("", CheckImageFile(GetParam().string()));
	EXPECT_EQ("", CheckPictureBytes(Read(GetParam())));
	if (!Is("found"))
	{
		EXPECT_LE(1, FImageFile(GetParam().string()).GetWidth());
	}
}

TEST_P(PictureCorpus, HoldsDamaged)
{
	for (const std::string& Bytes : Damage(Read(GetParam()), 50))
	{
		ASSERT_EQ("", CheckPictureBytes(Bytes));
	}
}

TEST_P(SpirvCorpus, Holds)
{
	EXPECT_EQ("", CheckSpirvBytes(Read(GetParam())));
}

TEST_P(SpirvCorpus, HoldsDamaged)
{
	for (const std::string& Bytes : Damage(Read(GetParam()), 200))
	{
		ASSERT_EQ("", CheckSpirvBytes(Bytes));
	}
}

TEST_P(SpirvCorpus, RunsUnlessItWasFoundByTheFuzzer)
{
	const std::string Bytes = Read(GetParam());
	std::vector<uint32_t> Words(Bytes.size() / 4);
	std::copy_n(Bytes.data(), Words.size() * 4, reinterpret_cast<char*>(Words.data()));
	std::string Message;
	const ESpirvWalk Walk = WalkSpirv(Words, Message);
	EXPECT_TRUE(Is("found") || Walk == ESpirvWalk::Run) << Message;
	EXPECT_EQ(Is("found_pointer_to_nowhere"), Message.find("a pointer to nowhere") != std::string::npos) << Message;
}

INSTANTIATE_TEST_SUITE_P(Files, SettingsTextCorpus, testing::ValuesIn(FindCorpus("settings")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, ConfigJsonCorpus, testing::ValuesIn(FindCorpus("config")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, ExrCorpus, testing::ValuesIn(FindCorpus("exr")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, PictureCorpus, testing::ValuesIn(FindCorpus("image")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, SpirvCorpus, testing::ValuesIn(FindCorpus("spirv")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, IniCorpus, testing::ValuesIn(FindCorpus("ini")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, OtherTextCorpus, testing::ValuesIn(FindCorpus("text")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, ViewStateCorpus, testing::ValuesIn(FindCorpus("state")), GetName);

// Each fuzzer has a corpus, and each corpus is read by tests: those of this file, and two others.
TEST(FuzzCorpus, EveryFolderIsReplayed)
{
	const std::string Fuzz = DRYDOCK_TEST_SOURCE_DIR "/tests/fuzz/";
	std::set<std::string> Folders;
	for (const auto& Entry : std::filesystem::directory_iterator(Fuzz + "corpus"))
	{
		Folders.insert(Entry.path().filename().string());
	}
	std::set<std::string> OfFuzzers;
	std::istringstream Rows(Read(Fuzz + "fuzzers.txt"));
	for (std::string Row; std::getline(Rows, Row);)
	{
		std::string Name, Source, Corpus;
		std::istringstream(Row) >> Name >> Source >> Corpus;
		if (Name != "#")
		{
			OfFuzzers.insert(Corpus);
		}
	}
	EXPECT_EQ(Folders, OfFuzzers);
	const std::set<std::string> Replayed = {"settings", "config", "exr", "image", "spirv", "ini", "text", "state",
		"graph", // tests/rdg/graph/GraphUtils/GraphCallsTest.cpp
		"usf"};  // tests/rdg/shader/Compiler/UsfFuzzCorpusTest.cpp
	EXPECT_EQ(Folders, Replayed);
}
