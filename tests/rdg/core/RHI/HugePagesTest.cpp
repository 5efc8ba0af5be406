// Large textures and the graph's heap lie on pages of 2 MB where the system gives them: what it notes of their memory.
#include "HugePages.h"
#include "RHITexture.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

using namespace Drydock;

namespace
{

/** Whether the system notes the wish for huge pages ("hg") of the mapping that holds an address. */
bool IsAskedFor(const void* Address)
{
	std::ifstream Mappings("/proc/self/smaps");
	bool bHere = false;
	for (std::string Line; std::getline(Mappings, Line);)
	{
		unsigned long long Begin = 0;
		unsigned long long End = 0;
		char Dash = 0;
		std::istringstream Words(Line);
		if (Words >> std::hex >> Begin >> Dash >> End && Dash == '-')
		{
			const auto Place = reinterpret_cast<uintptr_t>(Address);
			bHere = Place >= Begin && Place < End;
		}
		else if (bHere && Line.starts_with("VmFlags:"))
		{
			return (Line + " ").find(" hg ") != std::string::npos;
		}
	}
	return false;
}

bool HasHugePages()
{
	return access("/sys/kernel/mm/transparent_hugepage/enabled", R_OK) == 0;
}

constexpr size_t GPage = 2 << 20;

TEST(HugePages, OnlyWholePagesAreAskedFor)
{
	if (!HasHugePages())
	{
		GTEST_SKIP() << "the system has no pages of 2 MB to ask for";
	}
	std::vector<uint8> Memory(6 * GPage);
	uint8* const Begin = Memory.data() + GPage - reinterpret_cast<uintptr_t>(Memory.data()) % GPage;
	AskForHugePages(Begin + 64, 3 * GPage);
	EXPECT_FALSE(IsAskedFor(Begin + 64));
	EXPECT_TRUE(IsAskedFor(Begin + GPage));
	EXPECT_TRUE(IsAskedFor(Begin + 3 * GPage - 1));
	EXPECT_FALSE(IsAskedFor(Begin + 3 * GPage));
}

TEST(HugePages, LessThanAPageIsLeftAlone)
{
	std::vector<uint8> Memory(3 * GPage);
	uint8* const Begin = Memory.data() + GPage - reinterpret_cast<uintptr_t>(Memory.data()) % GPage;
	AskForHugePages(Begin + 1, GPage);
	EXPECT_FALSE(IsAskedFor(Begin));
	EXPECT_FALSE(IsAskedFor(Begin + GPage));
}

TEST(HugePages, LargeTexturesLieOnThem)
{
	if (!HasHugePages())
	{
		GTEST_SKIP() << "the system has no pages of 2 MB to ask for";
	}
	const FTextureRHIRef Texture = new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(1024, 1024), PF_A32B32G32R32F,
													   FClearValueBinding::None, TexCreate_ShaderResource),
		TEXT("Large"));
	EXPECT_TRUE(IsAskedFor(Texture->GetTexel(512, 512)));
}

} // namespace
