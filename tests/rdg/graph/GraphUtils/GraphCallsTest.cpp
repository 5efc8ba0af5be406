// The graph fuzzer's checks over its corpus, and over calls drawn at random, so that they run without clang too.
#include <gtest/gtest.h>

#include "fuzz/FuzzGraphChecks.h"

#include <filesystem>
#include <fstream>
#include <random>

TEST(GraphCalls, TheFuzzersCorpusEndsInARunOrInMessages)
{
	size_t NumFiles = 0;
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/tests/fuzz/corpus/graph"))
	{
		std::ifstream Stream(Entry.path(), std::ios::binary);
		const std::string Bytes(std::istreambuf_iterator<char>(Stream), {});
		EXPECT_EQ("", Drydock::CheckGraphCalls(reinterpret_cast<const uint8_t*>(Bytes.data()), Bytes.size()))
			<< Entry.path();
		++NumFiles;
	}
	EXPECT_GE(NumFiles, 10u);
}

TEST(GraphCalls, CallsDrawnAtRandomEndInARunOrInMessages)
{
	std::mt19937 Random(20261122);
	for (int Round = 0; Round < 2000; ++Round)
	{
		std::vector<uint8_t> Bytes(20 + Random() % 300);
		for (uint8_t& Byte : Bytes)
		{
			Byte = uint8_t(Random());
		}
		ASSERT_EQ("", Drydock::CheckGraphCalls(Bytes.data(), Bytes.size())) << "round " << Round;
	}
}
