// The table of pass functions: it has every pass of the engine's name, and what replaces a function is called in its
// place while it is active.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "PassFunctions.h"
#include "PassTestUtils.h"

#include "Screen/PostProcessDownsample.h"
#include "Tonemap/PostProcessCombineLUTs.h"

#include <dlfcn.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

using namespace Drydock;
using namespace PassTest;

namespace
{

namespace Files = std::filesystem;

/** Names of pass functions that a header declares outside of drydock's namespace. */
void AddEngineNames(const Files::path& Header, std::set<std::string>& Names)
{
	static const std::regex Declaration(R"(\b(Add\w*Pass(?:es)?)\()");
	std::ifstream Stream(Header);
	bool bOwn = false;
	std::string Scope;
	for (std::string Line; std::getline(Stream, Line);)
	{
		bOwn = Line == "namespace Drydock" || (bOwn && Line != "} // namespace Drydock");
		Scope = Line == "namespace DiaphragmDOF"        ? "DiaphragmDOF::"
				: Line == "} // namespace DiaphragmDOF" ? ""
														: Scope;
		std::smatch Found;
		if (!bOwn && !Line.starts_with("//") && !Line.starts_with(" *") && !Line.starts_with("/**") &&
			std::regex_search(Line, Found, Declaration))
		{
			Names.insert(Scope + Found[1].str());
		}
	}
}

std::string GetOwnPath()
{
	Dl_info Info = {};
	dladdr(reinterpret_cast<const void*>(&GetOwnPath), &Info);
	return Info.dli_fname;
}

FRDGTextureRef GReplacedTexture = nullptr;
FDownsamplePassInputs GSeen;

FRDGTextureRef ReplacedLUT(FRDGBuilder&, const FViewInfo&)
{
	return GReplacedTexture;
}

FScreenPassTexture ReplacedDownsample(FRDGBuilder&, const FViewInfo&, const void* const* Members)
{
	GSeen.Name = *static_cast<const TCHAR* const*>(Members[0]);
	GSeen.SceneColor = *static_cast<const FScreenPassTexture*>(Members[1]);
	GSeen.Quality = *static_cast<const EDownsampleQuality*>(Members[2]);
	return GSeen.SceneColor;
}

const FPassReplacement GLUT(
	"AddCombineLUTPass", reinterpret_cast<FAnyFunction>(&ReplacedLUT), reinterpret_cast<FAnyFunction>(&ReplacedLUT));
const FPassReplacement GDownsample("AddDownsamplePass", reinterpret_cast<FAnyFunction>(&ReplacedDownsample),
	reinterpret_cast<FAnyFunction>(&ReplacedDownsample));

} // namespace

TEST(PassFunctions, TheTableHasEveryPassOfTheEnginesName)
{
	std::set<std::string> Declared;
	for (const char* const Room : {"Screen", "Blur", "Exposure", "Bloom", "Tonemap", "Lens", "Toon"})
	{
		for (const auto& Entry : Files::directory_iterator(Files::path(DRYDOCK_TEST_SOURCE_DIR) / "passes" / Room))
		{
			if (Entry.path().extension() == ".h")
			{
				AddEngineNames(Entry.path(), Declared);
			}
		}
	}
	std::set<std::string> Listed;
	for (const FPassFunction& Pass : GetPassFunctions())
	{
		if (!std::string_view(Pass.Name).starts_with("Drydock::")) // an article's
		{
			Listed.insert(Pass.Name);
		}
	}
	EXPECT_EQ(Declared, Listed);
}

TEST(PassFunctions, AReplacementIsCalledWhileItIsActive)
{
	FPassRun Run(FImage(4, 4, {1, 1, 1, 1}), EArithmetic::Native);
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Half");
	Inputs.SceneColor = Run.Input;
	Inputs.Quality = EDownsampleQuality::High;
	EXPECT_EQ(nullptr, FindPassReplacement("AddDownsamplePass"));
	{
		const FScopedPassReplacements Active({GetOwnPath()});
		GReplacedTexture = Run.Input.Texture;
		EXPECT_EQ(GReplacedTexture, AddCombineLUTPass(Run.GraphBuilder, Run.View));
		EXPECT_EQ(Run.Input, AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs));
		EXPECT_STREQ(TEXT("Half"), GSeen.Name);
		EXPECT_EQ(EDownsampleQuality::High, GSeen.Quality);
		const FScopedPassReplacements None({"elsewhere.so"});
		EXPECT_EQ(nullptr, FindPassReplacement("AddDownsamplePass"));
	}
	EXPECT_EQ(nullptr, FindPassReplacement("AddDownsamplePass"));
	EXPECT_EQ(FIntPoint(2, 2), AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs).ViewRect.Size());
	Run.Execute(Run.Input);
}
