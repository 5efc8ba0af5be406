// The fuzzers' checks over their corpus, so that they run without clang too; and over every cut of it.
#include <gtest/gtest.h>

#include "fuzz/FuzzChecks.h"

#include <filesystem>
#include <fstream>
#include <iterator>

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

INSTANTIATE_TEST_SUITE_P(Files, SettingsTextCorpus, testing::ValuesIn(FindCorpus("settings")), GetName);
INSTANTIATE_TEST_SUITE_P(Files, ConfigJsonCorpus, testing::ValuesIn(FindCorpus("config")), GetName);
