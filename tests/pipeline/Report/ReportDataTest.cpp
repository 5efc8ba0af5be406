// What a report says: its form, its pictures and their values, its size, and the page it stands in.
#include <gtest/gtest.h>

#include "Report/PortablePaths.h"
#include "Report/ReportData.h"
#include "Report/ReportPage.h"
#include "Report/ReportPicture.h"
#include "Run/Run.h"
#include "Run/RunJson.h"
#include "SchemaCheck.h"
#include "SequenceTestUtils.h"
#include "Text/TextFormat.h"

#include <half.h>
#include <limits>
#include <zlib.h>

using namespace Drydock;
using namespace ReportTest;
using SequenceTest::FTemporaryFolder;

namespace
{

FRunResult RunForReport(const std::string& ConfigText)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText = ConfigText;
	Options.bKeepForReport = true;
	return RunConfig(Options);
}

const FRunResult& GetSmallRun()
{
	static const FRunResult Result =
		RunForReport(R"({"scene": {"file": "scenes/two_boxes.exr"}, "outputs": {"dump": ["Tonemap", "Bloom1X"]},
						 "cvars": {"r.FilmGrain": 0}, "camera": {"Settings": {"BloomIntensity": 1.25}}})");
	return Result;
}

FReportInputs MakeInputs(const FRunResult& Result, const FTemporaryFolder& Temporary)
{
	return {.Result = Result,
		.Name = "small",
		.When = "2025-01-31T12:00:00Z",
		.TimingJson = MakeTimingJson(Result, 1.0),
		.ExplainJson = "",
		.BlendJson = "",
		.WalkJson = "",
		.Touched = {},
		.Folder = Temporary.Path.string(),
		.Before = {}};
}

const FJson& FindPicture(const FJson& Report, const std::string& Id)
{
	for (const FJson& Picture : Report["pictures"])
	{
		if (Picture["id"] == Id)
		{
			return Picture;
		}
	}
	throw std::out_of_range(Id);
}

/** The inverse of EncodeBase64, by the alphabet's definition. */
std::string DecodeBase64(const std::string& Text)
{
	std::string Bytes;
	uint32_t Group = 0;
	int NumBits = 0;
	for (const char Digit : Text)
	{
		const int Value = Digit >= 'A' && Digit <= 'Z'   ? Digit - 'A'
						  : Digit >= 'a' && Digit <= 'z' ? Digit - 'a' + 26
						  : Digit >= '0' && Digit <= '9' ? Digit - '0' + 52
						  : Digit == '+'                 ? 62
						  : Digit == '/'                 ? 63
														 : -1;
		if (Value >= 0)
		{
			Group = Group << 6 | static_cast<uint32_t>(Value);
			NumBits += 6;
			if (NumBits >= 8)
			{
				NumBits -= 8;
				Bytes += static_cast<char>(Group >> NumBits & 255);
			}
		}
	}
	return Bytes;
}

std::string Inflate(const std::string& Packed, size_t Size)
{
	std::string Bytes(Size, '\0');
	uLongf NumBytes = static_cast<uLongf>(Size);
	EXPECT_EQ(Z_OK, uncompress(reinterpret_cast<Bytef*>(Bytes.data()), &NumBytes,
						reinterpret_cast<const Bytef*>(Packed.data()), static_cast<uLong>(Packed.size())));
	EXPECT_EQ(Size, NumBytes);
	return Bytes;
}

/** A value of planes as FPackedValues describes them. */
uint32_t GetBits(const std::string& Planes, size_t Pixel, size_t Channel, size_t NumPixels, size_t BytesPerValue)
{
	uint32_t Bits = 0;
	for (size_t Byte = 0; Byte < BytesPerValue; ++Byte)
	{
		Bits = Bits << 8 | static_cast<uint8_t>(Planes[(Channel * BytesPerValue + Byte) * NumPixels + Pixel]);
	}
	return Bits;
}

/** 2 x 1 texels, red and green of 32-bit floats. */
FPicture MakeFloats(const std::array<float, 4>& Values)
{
	const FRHITextureDesc Desc =
		FRHITextureDesc::Create2D(FIntPoint(2, 1), PF_G32R32F, FClearValueBinding::None, ETextureCreateFlags::None);
	TRefCountPtr<FRHITexture> Texture = new FRHITexture(Desc, TEXT("Floats"));
	Texture->EnsureMemory();
	std::memcpy(Texture->GetTexel(0, 0), Values.data(), sizeof(Values));
	return FPicture(Texture, FIntRect(0, 0, 2, 1), 2);
}

} // namespace

TEST(ReportData, IsOfTheFormThatItsSchemaStates)
{
	const FTemporaryFolder Temporary("drydock_report_schema");
	FReportInputs Inputs = MakeInputs(GetSmallRun(), Temporary);
	Inputs.bFull = true;
	Inputs.Before.RunJson = GetSmallRun().RunJson;
	Inputs.Before.When = "2025-01-30T12:00:00Z";
	const FJson Report = FJson::parse(MakeReportData(Inputs));
	const FJson Schema = ReadSchemaFile("report.schema.json");
	EXPECT_EQ(std::vector<std::string>(), FSchemaCheck(Schema).Check(Report));

	FJson Wrong = Report;
	Wrong["pictures"][0]["role"] = "portrait";
	Wrong["pictures"][1].erase("png");
	Wrong["surplus"] = 1;
	EXPECT_EQ(3u, FSchemaCheck(Schema).Check(Wrong).size());
}

TEST(ReportData, SaysWhatDiffersFromDefaultsAndWhatPassesWereGiven)
{
	const FTemporaryFolder Temporary("drydock_report_passes");
	const FJson Report = FJson::parse(MakeReportData(MakeInputs(GetSmallRun(), Temporary)));
	bool bFound = false;
	for (const FJson& Setting : Report["settings"])
	{
		EXPECT_NE(Setting["value"], Setting["default"]) << Setting["name"];
		bFound =
			bFound || (Setting["name"] == "BloomIntensity" && Setting["value"] == 1.25 && Setting["effect"] == "Bloom");
	}
	EXPECT_TRUE(bFound);

	size_t NumParameters = 0;
	for (const FJson& Pass : Report["passes"])
	{
		NumParameters += Pass["parameters"].size();
		if (Pass["index"] == GetSmallRun().Dumps.back().PassIndex)
		{
			EXPECT_EQ("/Engine/Private/PostProcessTonemap.usf", Pass["shaderFile"]);
			EXPECT_FALSE(Pass["permutations"].empty());
		}
	}
	EXPECT_GT(NumParameters, Report["passes"].size());
}

TEST(ReportData, EveryTextureThatAPassWroteIsDumpedOrHasAThumbnail)
{
	const FTemporaryFolder Temporary("drydock_report_thumbnails");
	const FJson Report = FJson::parse(MakeReportData(MakeInputs(GetSmallRun(), Temporary)));
	std::set<std::pair<int, std::string>> Shown;
	for (const FJson& Picture : Report["pictures"])
	{
		Shown.insert({Picture["pass"].get<int>(), Picture["resource"].get<std::string>()});
		EXPECT_EQ("\x89PNG", DecodeBase64(Picture["png"]).substr(0, 4)) << Picture["id"];
	}
	for (const FRunPass& Pass : GetSmallRun().Passes)
	{
		for (const FRDGUse& Use : GetSmallRun().Graph.Passes[static_cast<size_t>(Pass.Index)].Uses)
		{
			const FRDGCompiledResource& Resource = GetSmallRun().Graph.Resources[static_cast<size_t>(Use.Resource)];
			if (Use.IsWrite() && Resource.Kind == ERDGResourceKind::Texture)
			{
				EXPECT_TRUE(Shown.count({Pass.Index, Resource.Name})) << Pass.Index << " " << Resource.Name;
			}
		}
	}
	EXPECT_TRUE(std::filesystem::is_empty(Temporary.Path)) << "what was made in passing is left";
}

TEST(ReportData, FullCarriesTheValuesOfThePictures)
{
	const FTemporaryFolder Temporary("drydock_report_full");
	FReportInputs Inputs = MakeInputs(GetSmallRun(), Temporary);
	EXPECT_FALSE(FindPicture(FJson::parse(MakeReportData(Inputs)), "scene").contains("values"));
	Inputs.bFull = true;
	const FJson Report = FJson::parse(MakeReportData(Inputs));
	const FJson& Picture = FindPicture(Report, "scene");
	const FPicture& Scene = GetSmallRun().SceneLinear;
	const size_t NumPixels = static_cast<size_t>(Scene.Width) * static_cast<size_t>(Scene.Height);
	ASSERT_EQ("half", Picture["values"]["type"]);
	const std::string Planes = Inflate(DecodeBase64(Picture["values"]["zlib"]), NumPixels * 3 * 2);
	for (const auto& [X, Y] : {std::pair(0, 0), std::pair(17, 5), std::pair(Scene.Width - 1, Scene.Height - 1)})
	{
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			half Value;
			Value.setBits(static_cast<uint16_t>(
				GetBits(Planes, static_cast<size_t>(Y * Scene.Width + X), static_cast<size_t>(Channel), NumPixels, 2)));
			EXPECT_EQ(Scene.Get(X, Y, Channel), static_cast<double>(Value)) << X << " " << Y << " " << Channel;
		}
	}
}

TEST(ReportData, AFrameOfManyPassesHasThumbnailsOfSomeAndIsPacked)
{
	std::string Passes;
	for (int Pass = 0; Pass < 400; ++Pass)
	{
		Passes += std::string(Pass ? ", " : "") + R"({"type": "Tint", "at": "MotionBlur"})";
	}
	const FRunResult Result = RunForReport(R"({"scene": {"file": "scenes/hazards.exr"}, "passes": [)" + Passes + "]}");
	const FTemporaryFolder Temporary("drydock_report_many");
	FReportInputs Inputs = MakeInputs(Result, Temporary);
	const auto CountThumbnails = [](const FJson& Report)
	{
		return std::count_if(Report["pictures"].begin(), Report["pictures"].end(),
			[](const FJson& Picture) { return Picture["role"] == "thumbnail"; });
	};
	const FJson All = FJson::parse(MakeReportData(Inputs));
	EXPECT_EQ(0, All["thumbnailsLeftOut"]);
	EXPECT_LT(400, CountThumbnails(All));
	Inputs.MaxThumbnailBytes = 40'000;
	const std::string Data = MakeReportData(Inputs);
	const FJson Some = FJson::parse(Data);
	EXPECT_EQ(std::vector<std::string>(), FSchemaCheck(ReadSchemaFile("report.schema.json")).Check(Some));
	EXPECT_EQ(CountThumbnails(All), CountThumbnails(Some) + Some["thumbnailsLeftOut"].get<int>());
	EXPECT_LT(50, CountThumbnails(Some));
	EXPECT_GT(150, CountThumbnails(Some));

	const std::string Page = MakeReportPage(Data, 1'000'000);
	EXPECT_NE(std::string::npos, MakeReportPage(Data).find(Data.substr(0, 100)));
	const size_t From = Page.find("id=\"data\">\"") + 11;
	const std::string Packed = Page.substr(From, Page.find('"', From) - From);
	EXPECT_GT(Data.size() / 4, Packed.size());
	const std::string Sent = MakePathsPortable(Data);
	EXPECT_EQ(Sent, Inflate(DecodeBase64(Packed), Sent.size()));
}

TEST(ReportData, ANonsenseFileOfAnEarlierRunIsNoEarlierRun)
{
	const FTemporaryFolder Temporary("drydock_report_before");
	EXPECT_EQ("", ReadReportBefore(Temporary.Path.string()).RunJson);
	std::ofstream(Temporary.Path / "run.json") << "{\"version\": ";
	EXPECT_EQ("", ReadReportBefore(Temporary.Path.string()).RunJson);
	std::ofstream(Temporary.Path / "run.json") << GetSmallRun().RunJson;
	EXPECT_EQ(GetSmallRun().RunJson, ReadReportBefore(Temporary.Path.string()).RunJson);
}

TEST(ReportPicture, FiguresCountWhatIsNotFiniteAndWhatIsNegative)
{
	constexpr float Nan = std::numeric_limits<float>::quiet_NaN(), Infinity = std::numeric_limits<float>::infinity();
	const FPictureFigures Figures = MeasurePicture(MakeFloats({-Infinity, 0.5f, -2.0f, Nan}));
	EXPECT_EQ(1u, Figures.NumNaN);
	EXPECT_EQ(1u, Figures.NumInfinite);
	EXPECT_EQ(2u, Figures.NumNegative);
	EXPECT_EQ((std::vector<double>{-2.0, 0.5}), Figures.Min);
	EXPECT_EQ((std::vector<double>{-2.0, 0.5}), Figures.Max);
	EXPECT_FALSE(Figures.IsInDisplayRange());
	EXPECT_TRUE(MeasurePicture(MakeFloats({0.0f, 0.5f, 1.0f, 0.25f})).IsInDisplayRange());
}

TEST(ReportPicture, ValuesThatNoHalfHoldsArePackedAsFloats)
{
	const std::array<float, 4> Values = {1.0f / 3.0f, -70000.0f, 1e-20f, 0.0f};
	const FPackedValues Packed = PackValues(MakeFloats(Values));
	ASSERT_EQ("float", Packed.Type);
	const std::string Planes = Inflate(Packed.Bytes, 2 * 2 * 4);
	for (size_t Pixel = 0; Pixel < 2; ++Pixel)
	{
		for (size_t Channel = 0; Channel < 2; ++Channel)
		{
			const uint32_t Bits = GetBits(Planes, Pixel, Channel, 2, 4);
			float Value;
			std::memcpy(&Value, &Bits, sizeof(Value));
			EXPECT_EQ(Values[Pixel * 2 + Channel], Value);
		}
	}
}

// RFC 4648, section 10.
TEST(ReportPicture, Base64IsThatOfTheStandard)
{
	EXPECT_EQ("", EncodeBase64(""));
	EXPECT_EQ("Zg==", EncodeBase64("f"));
	EXPECT_EQ("Zm8=", EncodeBase64("fo"));
	EXPECT_EQ("Zm9v", EncodeBase64("foo"));
	EXPECT_EQ("Zm9vYmFy", EncodeBase64("foobar"));
	const std::string Bytes("\xff\x00\x80", 3);
	EXPECT_EQ(Bytes, DecodeBase64(EncodeBase64(Bytes)));
}

TEST(ReportPage, NothingInTheDataEndsTheElementItStandsIn)
{
	const FJson Nasty = {{"name", "</script><script>alert(1)</script>"}, {"comment", "<!-- <script>"}};
	const std::string Escaped = EscapeForScript(Nasty.dump());
	EXPECT_EQ(std::string::npos, Escaped.find('<'));
	EXPECT_EQ(Nasty, FJson::parse(Escaped));
	const std::string Page = MakeReportPage(Nasty.dump());
	EXPECT_NE(std::string::npos, Page.find("id=\"data\">" + Escaped + "</script>"));
}
