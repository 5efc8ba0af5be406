// Textures of a scene file's own channels, bound by name: what a plugin finds under the name, what an inserted pass
// reads, and mistakes. The plugin has the files and functions of the article on blurred toon shadows (tests/plugins).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/ProgramTestUtils.h"

#include "Picture/ImagePlane.h"

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;

namespace
{

constexpr int Width = 64;
constexpr int Height = 8;

/** Writes a scene whose channel "lit" is Lit(X), and a config with More. */
template<typename F>
void WriteScene(const FProgramFolder& Folder, const F& Lit, const std::string& More)
{
	Drydock::FImage Image{Width, Height, 4, {}};
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		Image.Values.insert(Image.Values.end(), {0.25, 0.5, 0.75, Lit(Pixel % Width)});
	}
	Drydock::WriteExr((Folder.Path / "scene.exr").string(), Image, {"R", "G", "B", "lit"});
	Folder.Write("frame.json", R"({"showFlags": {"Bloom": false}, )" + More + "}");
}

const std::string Bound = R"("scene": {"file": "scene.exr", "textures": {"CharacterShadow": "lit"}})";
const std::string Plugin = R"(, "plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libCharacterShadow.so"])";

/** A row of red of the tonemapper's input. */
std::vector<double> RunRow(const FProgramFolder& Folder)
{
	const FOutcome Run = Folder.Call("run frame.json --out out");
	EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
	Drydock::FImageFile Picture((Folder.Path / "out/scene_linear.exr").string(), Drydock::EImageExtent::Display);
	const std::vector<Drydock::FImagePlane> Planes = Picture.ReadPlanes({Picture.FindChannel("R")});
	std::vector<double> Row;
	for (int X = 0; X < Picture.GetWidth(); ++X)
	{
		Row.push_back(static_cast<double>(Planes[0].Get(size_t(Height / 2 * Picture.GetWidth() + X))));
	}
	return Row;
}

} // namespace

TEST(NamedTextures, APluginBlursAShadowOfTheFilesOwnAndKeepsItsMean)
{
	const FProgramFolder Folder("named_textures");
	for (const double Flat : {0.0, 0.1, 1.0})
	{
		WriteScene(
			Folder, [&](int) { return Flat; }, Bound + Plugin);
		for (const double Value : RunRow(Folder))
		{
			// Half a step of 8 bits in the root, which is up to 1 here, is one step in its square.
			EXPECT_NEAR(Flat, Value, 1.0 / 255);
		}
	}
	WriteScene(
		Folder, [](int X) { return X < Width / 2 ? 0.0 : 1.0; }, Bound + Plugin);
	const std::vector<double> Edge = RunRow(Folder);
	ASSERT_EQ(size_t(Width), Edge.size());
	EXPECT_TRUE(std::is_sorted(Edge.begin(), Edge.end()));
	EXPECT_NEAR(0.0, Edge.front(), 1.0 / 255);
	EXPECT_NEAR(1.0, Edge.back(), 1.0 / 255);
	EXPECT_GT(Edge[Width / 2 - 1], 0.05) << "the edge is blurred";
	EXPECT_LT(Edge[Width / 2], 0.95);
}

TEST(NamedTextures, WithoutTheNameThePluginDoesNothing)
{
	const FProgramFolder Folder("named_textures_none");
	WriteScene(
		Folder, [](int) { return 1.0; }, R"("scene": {"file": "scene.exr"})" + Plugin);
	EXPECT_EQ(std::vector<double>(Width, 0.25), RunRow(Folder));
}

TEST(NamedTextures, AnInsertedPassReadsOneOfSeveralChannels)
{
	const FProgramFolder Folder("named_textures_pass");
	WriteScene(
		Folder, [](int X) { return X / 64.0; },
		R"("scene": {"file": "scene.exr", "textures": {"Mine": "lit, G"}},
		   "passes": [{"type": "Tint", "at": "MotionBlur", "inputs": {"Input": "Mine"}}])");
	const std::vector<double> Row = RunRow(Folder);
	ASSERT_EQ(size_t(Width), Row.size());
	EXPECT_EQ(0.0, Row[0]);
	EXPECT_EQ(0.5, Row[32]);
}

TEST(NamedTextures, MistakesAreNamed)
{
	const FProgramFolder Folder("named_textures_wrong");
	WriteScene(
		Folder, [](int) { return 1.0; }, R"("scene": {"file": "scene.exr", "textures": {
		"Mine": "lid", "GBufferA": "lit", "Many": "R,G,B,lit,R", "None": ""}})");
	const FOutcome Run = Folder.Call("run frame.json");
	EXPECT_EQ(2, Run.ExitCode);
	EXPECT_THAT(Run.Printed, HasSubstr("has no channel \"lid\"; did you mean lit?"));
	EXPECT_THAT(Run.Printed, HasSubstr("drydock has a scene texture GBufferA; choose another name"));
	EXPECT_THAT(Run.Printed, HasSubstr("a texture must have 1 to 4 channels, but Many has 5"));
	EXPECT_THAT(Run.Printed, HasSubstr("a texture must have 1 to 4 channels, but None has 0"));
}
