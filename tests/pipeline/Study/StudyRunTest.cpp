// Studies as a config asks for them: what is varied, what is measured (the figures: StudyFiguresTest.cpp), that it is
// the same twice, and what a run takes from it.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "Budget/BudgetChoice.h"
#include "Budget/StudyRequest.h"
#include "Run/Run.h"
#include "Run/RunOutputs.h"
#include "Study/BlurAlgorithms.h"
#include "Study/StudyReport.h"
#include "Study/StudyRun.h"
#include "Study/StudySubject.h"
#include "Text/ConfigErrors.h"
#include "Text/Json.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

FRunOptions MakeOptions(const std::string& More)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/test_study.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, )" + More + "}";
	return Options;
}

std::string ErrorOf(const std::string& More)
{
	try
	{
		CheckConfig(MakeOptions(More));
	}
	catch (const FError& Error)
	{
		const FDiagnostic& First = Error.GetDiagnostics().front();
		return std::to_string(First.Code) + " " + First.Where + ": " + First.Message;
	}
	return "";
}

FStudy Read(const std::string& More)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(*MakeOptions(More).ConfigText, "configs/a.json", Diagnostics);
	const std::optional<FStudy> Study = ReadStudy(Config, Diagnostics);
	EXPECT_FALSE(HasErrors(Diagnostics));
	return Study.value_or(FStudy());
}

const char* const GBlurStudy = R"("study": {"axes": [
	{"name": "algorithm", "values": ["Separable", "DualKawase", "Pyramid", "Direct"]},
	{"name": "sigma", "values": [2, 12]}, {"name": "input", "values": ["scene", "point"]}],
	"region": [300, 140, 348, 180], "repetitions": 1, "current": {"algorithm": "DualKawase"}})";

const char* const GFrameStudy = R"("volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 1}}],
	"study": {"axes": [{"name": "r.BloomQuality", "values": [1, 5]}], "repetitions": 1})";

const FStudyVariant& Find(const FStudyResult& Result, const std::string& Job, const std::string& Variant)
{
	for (const FStudyVariant& Candidate : Result.Variants)
	{
		if (Candidate.Label == Variant && Result.Jobs[Candidate.Case].Case.Label == Job)
		{
			return Candidate;
		}
	}
	ADD_FAILURE() << Job << " " << Variant;
	return Result.Variants[0];
}

class StudyFolder : public testing::Test
{
protected:
	StudyFolder()
		: Folder(Files::temp_directory_path() / ("drydock_study_" + std::to_string(getpid())))
	{
		Files::remove_all(Folder);
		Files::create_directories(Folder);
	}
	~StudyFolder() override { Files::remove_all(Folder); }

	const Files::path Folder;
};

} // namespace

TEST(StudyConfig, JobsAndChoicesAreAllCombinations)
{
	const FStudy Study = Read(GBlurStudy);
	EXPECT_TRUE(Study.bBlur);
	ASSERT_EQ(4u, Study.GetCases().size());
	EXPECT_EQ("sigma 2, scene", Study.GetCases()[0].Label);
	EXPECT_EQ("sigma 12, point", Study.GetCases()[3].Label);
	ASSERT_EQ(4u, Study.GetChoices().size());
	EXPECT_EQ("DualKawase", Study.GetChoices()[1].Label);
	EXPECT_EQ("exact", Study.ReferenceName);
	EXPECT_TRUE(Study.Budget.bDefault);
}

TEST(StudyConfig, FramesHaveADoubleReferenceThatAnObjectAddsTo)
{
	const FStudy Study = Read(
		R"("study": {"axes": [{"name": "r.BloomQuality", "values": [1, 2]}], "reference": {"r.BloomQuality": 5}})");
	EXPECT_FALSE(Study.bBlur);
	EXPECT_EQ("double", GetAssigned(Study.Reference, "precision", ""));
	EXPECT_EQ("5", GetAssigned(Study.Reference, "r.BloomQuality", ""));
	EXPECT_EQ("BloomQuality 2", Study.GetChoices()[1].Label);
}

TEST(StudyConfig, OneValueMaySetSeveralThings)
{
	const FStudy Study = Read(R"("study": {"axes": [{"name": "look", "each": true, "values": [
		{"label": "soft", "set": {"BloomIntensity": 2, "r.BloomQuality": 3}}]}]})");
	ASSERT_EQ(1u, Study.GetCases().size());
	EXPECT_EQ("soft", Study.GetCases()[0].Label);
	EXPECT_EQ("3", GetAssigned(Study.GetCases()[0].Set, "r.BloomQuality", ""));
}

TEST(StudyConfig, MistakesAreNamedWithTheNearestName)
{
	EXPECT_EQ(
		"1007 /study/axes/0/values/0: there is no algorithm \"DualKawaze\": Exact, Direct, Separable, GaussianSum, "
		"Kawase, DualKawase, Pyramid, FFT; did you mean DualKawase?",
		ErrorOf(R"("study": {"axes": [{"name": "algorithm", "values": ["DualKawaze"]}]})"));
	EXPECT_EQ(
		"1007 /study/axes/0/name: \"r.BloomQualty\" is not a setting, a console variable, precision, storage or a "
		"place such as /objects/UMySettings/Intensity; did you mean r.BloomQuality?",
		ErrorOf(R"("study": {"axes": [{"name": "r.BloomQualty", "values": [1]}]})"));
	EXPECT_EQ(
		"1007 /study/metrics/0: there is no metric \"rsm\": max, rms, relative, psnr, ssim, flip; did you mean rms?",
		ErrorOf(R"("study": {"axes": [{"name": "r.BloomQuality", "values": [1]}], "metrics": ["rsm"]})"));
	EXPECT_EQ("1006 /study/axes/0/values: \"values\" must be an array of at least one value",
		ErrorOf(R"("study": {"axes": [{"name": "r.BloomQuality", "values": 3}]})"));
	EXPECT_EQ("1010 /study/axes/1/values/0: sigma must be a number of pixels, 0.5 to 1000",
		ErrorOf(
			R"("study": {"axes": [{"name": "algorithm", "values": ["Kawase"]}, {"name": "sigma", "values": [0]}]})"));
	EXPECT_EQ("1008 /budget: the budget has neither \"max\" nor \"ms\"", ErrorOf(R"("budget": {"metric": "rms"})"));
}

TEST(StudyBlur, SaysWhatIsNotRunAndWhatItWouldCost)
{
	const FStudyResult Result = RunStudy(MakeOptions(GBlurStudy));
	const FStudyVariant& Direct = Find(Result, "sigma 12, scene", "Direct");
	EXPECT_FALSE(Direct.bRan);
	EXPECT_EQ("not run: it would take 5329 taps per pixel", Direct.Excluded); // (2 * 36 + 1)^2
	EXPECT_TRUE(Find(Result, "sigma 2, scene", "Direct").bRan);
	EXPECT_TRUE(Find(Result, "sigma 2, scene", "DualKawase").bCurrent);
	EXPECT_FALSE(Find(Result, "sigma 2, scene", "Pyramid").bCurrent);
	EXPECT_NEAR(12.0, Find(Result, "sigma 12, point", "Separable").MeasuredSigma, 0.01);
}

TEST(StudyBlur, TwiceIsTheSameBytesButForTheTimes)
{
	const FStudyResult First = RunStudy(MakeOptions(GBlurStudy));
	const FStudyResult Second = RunStudy(MakeOptions(GBlurStudy));
	EXPECT_EQ(MakeStudyJson(First), MakeStudyJson(Second));
	EXPECT_EQ(MakeStudyCsv(First, false), MakeStudyCsv(Second, false));
}

TEST(StudyBlur, PointIsAsBrightAsMakesTheExactPeakOne)
{
	const FImage Input = MakeBlurInput("point", FImage{101, 101, 4, std::vector<double>(101 * 101 * 4, 0.0)}, 5.0);
	EXPECT_NEAR(2.0 * 3.14159265358979 * 25.0, Input.Get(40, 60, 0), 1e-9);
	const FImage Edge = MakeBlurInput("edge", Input, 5.0);
	EXPECT_EQ(0.0, Edge.Get(0, 50, 0));
	EXPECT_EQ(1.0, Edge.Get(100, 50, 0));
}

TEST(StudyFrame, LowerQualityIsFurtherOff)
{
	const FStudyResult Result = RunStudy(MakeOptions(GFrameStudy));
	const FStudyVariant& Low = Find(Result, "", "BloomQuality 1");
	const FStudyVariant& High = Find(Result, "", "BloomQuality 5");
	EXPECT_GT(Low.Error.Rms, High.Error.Rms);
	EXPECT_LT(Low.Taps, High.Taps);
	EXPECT_GT(Low.Error.Rms, 0.0);
	EXPECT_TRUE(High.bCurrent);
	EXPECT_FALSE(Low.bCurrent);
	EXPECT_EQ(641, Result.Width);
	EXPECT_EQ(1u, High.Time.Runs.size());
}

TEST(StudyFrame, ErrorIsThatOfTwoRuns)
{
	// Quality 1 in float against quality 1 in double, as two runs of their own have it.
	FRunOptions Options = MakeOptions(GFrameStudy);
	Options.Variables = {"r.BloomQuality=1"};
	const FImage Float = RunConfig(Options).Final.ToImage();
	Options.bDouble = true;
	Options.Variables.push_back("r.Drydock.SampleBits=0");
	const FImage Double = RunConfig(Options).Final.ToImage();
	double Largest = 0.0;
	for (int Y = 0; Y < Float.Height; ++Y)
	{
		for (int X = 0; X < Float.Width; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				Largest = std::max(Largest, std::abs(Float.Get(X, Y, Channel) - Double.Get(X, Y, Channel)));
			}
		}
	}
	const FStudyResult Result = RunStudy(MakeOptions(
		R"("volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 1}}], "cvars": {"r.BloomQuality": 1},
		"study": {"axes": [{"name": "precision", "values": ["float"]}], "repetitions": 1})"));
	EXPECT_DOUBLE_EQ(Largest, Result.Variants[0].Error.Max);
}

TEST(StudyRegion, BeyondThePictureIsAnError)
{
	for (const char* Study : {R"({"axes": [{"name": "algorithm", "values": ["Pyramid"]}], "region": [0, 0, 642, 359]})",
			 R"({"axes": [{"name": "precision", "values": ["float"]}], "region": [0, 0, 641, 360]})"})
	{
		try
		{
			RunStudy(MakeOptions(std::string(R"("study": )") + Study));
			ADD_FAILURE() << Study;
		}
		catch (const FError& Error)
		{
			EXPECT_EQ("the region leaves the picture, which is 641 x 359 pixels", Error.GetDiagnostics()[0].Message);
		}
	}
}

TEST(StudyRegion, OfAFrameIsOnlyCompared)
{
	const std::string Axes = R"("axes": [{"name": "r.BloomQuality", "values": [1, 5]}], "repetitions": 1)";
	const FStudyResult All = RunStudy(MakeOptions("\"study\": {" + Axes + "}"));
	const FStudyResult Part = RunStudy(MakeOptions("\"study\": {" + Axes + R"(, "region": [300, 140, 348, 180]})"));
	EXPECT_EQ(All.Variants[0].Error.Relative, Part.Variants[0].RelativeWithBorder);
	EXPECT_NE(All.Variants[0].Error.Relative, Part.Variants[0].Error.Relative);
	EXPECT_EQ(All.Variants[0].Taps, Part.Variants[0].Taps);
}

TEST(StudyRegion, PicturesToLookAtAreThatPartOfTheWhole)
{
	const std::string Axes = R"("axes": [{"name": "algorithm", "values": ["Pyramid"]}], "repetitions": 1)";
	FStudyRun All(MakeOptions("\"study\": {" + Axes + "}"));
	FStudyRun Part(MakeOptions("\"study\": {" + Axes + R"(, "region": [300, 140, 348, 180]})"));
	const FStudyResult OfAll = All.Measure();
	const FStudyResult OfPart = Part.Measure();
	const FImage Whole = All.RunVariant(OfAll, OfAll.Variants[0]).Image;
	const FImage Cut = Part.RunVariant(OfPart, OfPart.Variants[0]).Image;
	ASSERT_EQ(48, Cut.Width);
	ASSERT_EQ(40, Cut.Height);
	for (int Y = 0; Y < Cut.Height; ++Y)
	{
		for (int X = 0; X < Cut.Width; ++X)
		{
			ASSERT_EQ(Whole.Get(300 + X, 140 + Y, 1), Cut.Get(X, Y, 1)) << X << ", " << Y;
		}
	}
	EXPECT_EQ(48, Part.RunReference(OfPart.Jobs[0]).Image.Width);
}

TEST(StudyFrame, ConfigWithoutAStudyIsAnError)
{
	EXPECT_THROW(RunStudy(MakeOptions(R"("cvars": {})")), FError);
}

TEST(StudyFingerprint, LeavesOutBudgetAndComments)
{
	const std::string A = R"({"scene": {"file": "a.exr"}, "study": {"axes": []}})";
	const std::string B = "// x\n"
						  R"({"scene": {"file": "a.exr"},   "study": {"axes": []}, "budget": {"max": 1}})";
	const std::string C = R"({"scene": {"file": "b.exr"}, "study": {"axes": []}})";
	EXPECT_EQ(GetStudyFingerprint(A), GetStudyFingerprint(B));
	EXPECT_NE(GetStudyFingerprint(A), GetStudyFingerprint(C));
}

TEST_F(StudyFolder, RunTakesWhatTheBudgetAllows)
{
	const auto WithBudget = [&](const std::string& Budget)
	{
		return MakeOptions(
			std::string(GFrameStudy) + R"(, "budget": {"study": ")" + Folder.string() + "\", " + Budget + "}");
	};
	const FStudyResult Result = RunStudy(WithBudget(R"("max": 1)"));
	WriteTextFile((Folder / "study.json").string(), MakeStudyJson(Result));
	WriteTextFile((Folder / "study_timing.json").string(), MakeStudyTimingJson(Result));
	// Quality 1 has 3 blurs and quality 5 six; only the error decides between them when it must be small.
	const double Small = Find(Result, "", "BloomQuality 5").Error.Rms * 1.5;
	const FRunOptions Options = WithBudget("\"max\": " + std::to_string(Small));
	const FRunResult Run = RunConfig(Options);
	EXPECT_NE(std::string::npos, Run.RunJson.find("\"budget\": \"BloomQuality 5 (rms "));
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(*Options.ConfigText, Options.ConfigFile, Diagnostics);
	const std::optional<FBudgetChoice> Choice = ReadBudgetChoice(Config, Options, Diagnostics);
	ASSERT_TRUE(Choice.has_value());
	EXPECT_EQ("5", GetAssigned(Choice->Set, "r.BloomQuality", ""));
	EXPECT_TRUE(Diagnostics.empty());
}

TEST_F(StudyFolder, RunTakesWhatTheStudyRecommends)
{
	const auto WithBudget = [&](const std::string& Budget)
	{
		return MakeOptions(
			std::string(GFrameStudy) + R"(, "budget": {"study": ")" + Folder.string() + "\", " + Budget + "}");
	};
	for (const char* const Budget : {R"("max": 10)", R"("ms": 1000)"})
	{
		const FRunOptions Options = WithBudget(Budget);
		FStudyResult Result = RunStudy(Options);
		ASSERT_LE(2u, Result.Jobs[0].Variants.size());
		for (const size_t Index : Result.Jobs[0].Variants)
		{
			// Each is a little cheaper than the one before it, within noise.
			const double Median = 10.0 - 0.1 * static_cast<double>(Index);
			Result.Variants[Index].Time = {{Median}, Median, Median - 1.0, Median + 1.0};
		}
		RankStudy(Result);
		WriteTextFile((Folder / "study.json").string(), MakeStudyJson(Result));
		WriteTextFile((Folder / "study_timing.json").string(), MakeStudyTimingJson(Result));
		std::vector<FDiagnostic> Diagnostics;
		const FConfig Config = ReadConfig(*Options.ConfigText, Options.ConfigFile, Diagnostics);
		const std::string Reason = ReadBudgetChoice(Config, Options, Diagnostics)->Reason;
		for (const size_t Index : Result.Jobs[0].Variants)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			EXPECT_EQ(Variant.bRecommended, Reason.find(Variant.Label + " (rms ") == 0) << Budget << ": " << Reason;
		}
	}
}

TEST_F(StudyFolder, RunWithoutAStudySaysSoAndKeepsItsValues)
{
	FRunOptions Options =
		MakeOptions(std::string(GFrameStudy) + R"(, "budget": {"study": ")" + Folder.string() + R"(", "max": 1})");
	Options.bExecute = false;
	const FRunResult Run = RunConfig(Options);
	ASSERT_EQ(1u, Run.Diagnostics.size());
	EXPECT_EQ(NoteBudgetWithoutChoice, Run.Diagnostics[0].Code);
	EXPECT_EQ(ESeverity::Note, Run.Diagnostics[0].Severity);
}

TEST_F(StudyFolder, StudyOfAnotherConfigIsNotUsed)
{
	WriteTextFile((Folder / "study.json").string(), R"({"fingerprint": "0", "jobs": []})");
	WriteTextFile((Folder / "study_timing.json").string(), R"({"jobs": []})");
	const FRunOptions Options =
		MakeOptions(std::string(GFrameStudy) + R"(, "budget": {"study": ")" + Folder.string() + R"(", "max": 1})");
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(*Options.ConfigText, Options.ConfigFile, Diagnostics);
	EXPECT_TRUE(ReadBudgetChoice(Config, Options, Diagnostics)->Set.empty());
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_NE(std::string::npos, Diagnostics[0].Message.find("earlier form"));
}
