// Tables of .cube files: read as the specification has them, refused with the line that is wrong, and the table of a
// config's grade held against the tonemapper that evaluates the grade for each pixel.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../ProgramTestUtils.h"

#include "Diagnostics.h"
#include "Picture/ColorCube.h"
#include "Picture/ImagePlane.h"

#include <cmath>

using namespace Drydock;
using namespace ProgramTest;
using testing::HasSubstr;

namespace
{

static_assert(sizeof(DRYDOCK_TEST_BINARY_DIR) > 1); // which files that name it are given: the program is there

class ColorCube : public testing::Test
{
protected:
	std::string MistakeOf(const std::string& Text) const
	{
		Folder.Write("a.cube", Text);
		try
		{
			ReadColorCube((Folder.Path / "a.cube").string());
			return "";
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitFiles, Error.GetExitCode());
			EXPECT_EQ(5035, Error.GetDiagnostics()[0].Code);
			return std::to_string(Error.GetDiagnostics()[0].Line) + ": " + Error.GetDiagnostics()[0].Message;
		}
	}

	/** A row of Count greys, as linear light, that a config of this name shows with the grade alone. */
	std::vector<double> GradeGreys(const std::vector<double>& Light, const std::string& Settings) const
	{
		FImage Image{static_cast<int>(Light.size()), 1, 3, {}};
		for (const double Value : Light)
		{
			Image.Values.insert(Image.Values.end(), 3, Value);
		}
		WriteExr((Folder.Path / "greys.exr").string(), Image, {"R", "G", "B"});
		Folder.Write("greys.json",
			R"({"scene": {"file": "greys.exr"}, "view": {"exposure": 1}, "camera": {"Settings": {)" + Settings + "}}}");
		const FOutcome Run = Folder.Call("run greys.json --storage float32 --set r.Drydock.TonemapLUT=0 --report off");
		EXPECT_EQ(0, Run.ExitCode) << Run.Printed;
		FImageFile Final((Folder.Path / "out/greys/final.exr").string());
		const std::vector<float> Red = Final.Read({Final.FindChannel("R")})[0];
		return std::vector<double>(Red.begin(), Red.end());
	}

	const FProgramFolder Folder{"cube"};
};

const std::string Identity2 = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";
const std::string NoLens = R"("BloomIntensity": 0, "VignetteIntensity": 0, "LensFlareIntensity": 0)";

} // namespace

TEST_F(ColorCube, IsReadAsTheSpecificationHasIt)
{
	Folder.Write("a.cube", "# comment\r\nTITLE \"a b\"\r\nLUT_3D_SIZE 2\r\nDOMAIN_MIN 0 0 -1\nDOMAIN_MAX 1 2 1\n\n" +
							   std::string("0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 .5e0\n"));
	const FColorCube Cube = ReadColorCube((Folder.Path / "a.cube").string());
	EXPECT_EQ(2, Cube.Size);
	EXPECT_EQ((std::array<double, 3>{1, 0, 0}), Cube.Sample({1, 0, -1})); // red is the fastest
	EXPECT_EQ((std::array<double, 3>{0, 0.5, 0.5}), Cube.Sample({0, 1, 0}));
	EXPECT_EQ((std::array<double, 3>{1, 1, 0.5}), Cube.Sample({9, 9, 9})); // the border
}

TEST_F(ColorCube, MistakesNameTheLine)
{
	EXPECT_THAT(MistakeOf("LUT_1D_SIZE 2\n0 0 0\n1 1 1\n"), HasSubstr("1: the table has one dimension"));
	EXPECT_THAT(MistakeOf("LUT_3D_SIZE 300\n"), HasSubstr("1: LUT_3D_SIZE must be 2 to 256, but is 300"));
	EXPECT_THAT(MistakeOf("LUT_3D_SIZE 2\n0 0\n"), HasSubstr("2: expected three numbers, found \"0 0\""));
	EXPECT_THAT(MistakeOf("LUT_3D_SIZE 2\n0 0 nan\n"), HasSubstr("2: expected three numbers"));
	EXPECT_THAT(MistakeOf("LUT_3D_SIZE 2\n0 0 0\n"), HasSubstr("has 8 colours, and the file has 1"));
	EXPECT_THAT(MistakeOf("LUT_3D_SIZE 2\n" + Identity2 + "0 0 0\n"),
		HasSubstr("10: a line that is not known, or a colour too"));
	EXPECT_THAT(MistakeOf("0 0 0\n"), HasSubstr("1: a line that is not known"));
	EXPECT_THAT(MistakeOf(""), HasSubstr("LUT_3D_SIZE is missing"));
	EXPECT_EQ("", MistakeOf("LUT_3D_SIZE 2\n" + Identity2));
}

TEST_F(ColorCube, TheTableOfASettingGivesThePictureOfItsPng)
{
	FImageFile Png(DRYDOCK_TEST_SOURCE_DIR "/configs/textures/teal_orange.png");
	const std::vector<FImagePlane> Planes = Png.ReadPart(0, {0, 1, 2});
	FColorCube Cube;
	Cube.Size = 16;
	for (int Index = 0; Index < 4096; ++Index)
	{
		const size_t Texel = static_cast<size_t>(Index / 16 % 16 * 256 + Index / 256 * 16 + Index % 16);
		Cube.Colors.push_back({Planes[0].Get(Texel), Planes[1].Get(Texel), Planes[2].Get(Texel)});
	}
	Folder.Write("teal.cube", MakeColorCubeText(Cube, "teal", {}));
	for (const std::string Table : {"teal.cube", DRYDOCK_TEST_SOURCE_DIR "/configs/textures/teal_orange.png"})
	{
		const std::string Name = Table == "teal.cube" ? "cube" : "png";
		Folder.WriteFrame(Name + ".json", R"(, "camera": {"Settings": {"ColorGradingLUT": ")" + Table + "\"}}");
		EXPECT_EQ(0, Folder.Call("run " + Name + ".json").ExitCode);
	}
	Folder.WriteFrame("none.json", "");
	EXPECT_EQ(0, Folder.Call("run none.json").ExitCode);
	EXPECT_EQ(0, Folder.Call("diff out/cube/final.exr out/png/final.exr --max 0").ExitCode);
	EXPECT_EQ(1, Folder.Call("diff out/none/final.exr out/png/final.exr --max 0.01").ExitCode);
	Folder.WriteFrame("bad.json", R"(, "camera": {"Settings": {"ColorGradingLUT": "no.cube"}})");
	const FOutcome Bad = Folder.Call("check bad.json");
	EXPECT_EQ(3, Bad.ExitCode) << Bad.Printed;
	EXPECT_THAT(Bad.Printed, HasSubstr("no.cube"));
}

TEST_F(ColorCube, TheWrittenTableIsTheGradeOfEachPixel)
{
	const std::string Settings = NoLens + R"(, "ColorGain": [1.3, 0.8, 1.1, 1], "FilmSlope": 0.7)";
	for (const std::string Input : {"log", "display"})
	{
		for (const int Size : {33, 65})
		{
			std::vector<double> Light;
			for (int Index = 0; Index < Size; ++Index)
			{
				const double X = Index / (Size - 1.0);
				Light.push_back(Input == "display" ? (X <= 0.04045 ? X / 12.92 : std::pow((X + 0.055) / 1.055, 2.4))
												   : std::max(0.0, 0.18 * std::exp2(14.0 * (X - 444.0 / 1023.0)) -
																	   0.18 * std::exp2(-14.0 * 444.0 / 1023.0)));
			}
			const std::vector<double> Expected = GradeGreys(Light, Settings);
			const FOutcome Made = Folder.Call(
				"settings cube greys.json --out g.cube --size " + std::to_string(Size) + " --input " + Input);
			ASSERT_EQ(0, Made.ExitCode) << Made.Printed;
			EXPECT_THAT(Folder.Read("g.cube"), HasSubstr("# Input: " + Input));
			const FColorCube Cube = ReadColorCube((Folder.Path / "g.cube").string());
			ASSERT_EQ(Size, Cube.Size);
			for (int Index = 0; Index < Size; ++Index)
			{
				const double Red = Cube.Colors[static_cast<size_t>(Index * (1 + Size + Size * Size))][0];
				EXPECT_NEAR(std::clamp(Expected[static_cast<size_t>(Index)], 0.0, 1.0), Red, 2e-5)
					<< Input << " " << Index;
			}
		}
	}
}

TEST_F(ColorCube, FinalSaysWhatItsNumbersAre)
{
	Folder.WriteFrame("a.json", "");
	// The grade of each pixel: a table of light is interpolated otherwise than one of codes.
	const std::string Exact = " --set r.Drydock.TonemapLUT=0";
	Folder.Call("run a.json --csv a.csv" + Exact);
	Folder.Call("run a.json --final linear --out out/l" + Exact);
	const auto Encoding = [&](const char* Name)
	{
		return FImageFile((Folder.Path / Name).string()).GetAttribute("drydock:encoding");
	};
	EXPECT_EQ("sRGB", Encoding("out/a/final.exr"));
	EXPECT_EQ("linear Rec.709, display-referred", Encoding("out/l/final.exr"));
	for (const char* Name : {"out/a/final.exr", "out/a/scene_linear.exr", "out/l/final.exr"})
	{
		EXPECT_THAT(Folder.Read(Name), HasSubstr(std::string("chromaticities\0chromaticities\0", 30))) << Name;
	}
	// The light that a display shows of one is that of the other, but for the rounding to 8 bits.
	FImageFile Codes((Folder.Path / "out/a/final.exr").string());
	FImageFile Light((Folder.Path / "out/l/final.exr").string());
	const std::vector<float> A = Codes.Read({Codes.FindChannel("R")})[0];
	const std::vector<float> B = Light.Read({Light.FindChannel("R")})[0];
	for (size_t Index = 0; Index < A.size(); ++Index)
	{
		const double Code = B[Index] <= 0.0031308 ? 12.92 * B[Index] : 1.055 * std::pow(B[Index], 1 / 2.4) - 0.055;
		EXPECT_NEAR(A[Index], Code, 0.6 / 255) << Index;
	}
	const std::string Csv = Folder.Read("a.csv");
	EXPECT_TRUE(Csv.starts_with("index,pass,effect,plugin,shader,runs_as,ms,pixels,taps,bytes_read,bytes_written\n"));
	EXPECT_THAT(Csv, HasSubstr("Tonemap"));
}
