// `drydock diff`: prints how far two images are apart, or two runs picture by picture.
#include "Picture/ImageFlip.h"
#include "Picture/ImageMetrics.h"
#include "Picture/PictureFile.h"
#include "PrintText.h"
#include "Program/Baseline.h"
#include "Program/FindingsOption.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/ReportOption.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Report/DiffPage.h"
#include "Report/ReportData.h"
#include "Report/ReportPage.h"
#include "Run/Run.h"
#include "Run/RunAgain.h"
#include "Run/RunDifference.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "Text/TextTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

struct FDiffOptions
{
	std::string A;          // an image, or the folder of a run
	std::string B;          // what A is measured against, of the same kind
	bool bBaseline = false; // B must be a baseline
	std::optional<double> Max;
	std::string FlipMap; // PNG to write of FLIP; of two folders the folder for one of each image; empty: none
	std::string HeatMap; // PNG to write; of two folders the folder for one of each image; empty: none
	bool bJson = false;
	int NumRepeats = 0;                    // runs of each side, to measure times; 0: none
	std::string Report;                    // "on", "off"; empty: off
	std::string OutputFolder = "out/diff"; // of the page
	FFindingsOptions Findings;
};

struct FPair
{
	std::string Name; // for the table
	std::string A;    // files; empty where that side has none
	std::string B;
	FImageError Error;
	std::vector<std::string> Channels;
};

FError MakeError(EConfigError Code, const std::string& File, const std::string& Message, EExitCode ExitCode)
{
	return FError({.Code = Code, .Message = Message, .File = File}, ExitCode);
}

/** "BloomSetup.BloomSetup" of "007.BloomSetup.BloomSetup.exr": an inserted pass moves the number of all that follow. */
std::string GetPassKey(const Files::path& File)
{
	const std::string Stem = File.stem().string();
	const size_t Dot = Stem.find('.');
	const bool bNumbered = Dot != std::string::npos && Dot > 0 &&
						   std::all_of(Stem.begin(), Stem.begin() + static_cast<long>(Dot),
							   [](char Character) { return Character >= '0' && Character <= '9'; });
	return bNumbered ? Stem.substr(Dot + 1) : Stem;
}

/** The pictures of a run by name: the dumped passes in their order, then what the run ends with. */
std::vector<std::pair<std::string, std::string>> ListRun(const std::string& Folder)
{
	std::vector<Files::path> Passes;
	std::error_code Error;
	const Files::path PassFolder = Files::path(Folder) / "passes";
	for (Files::directory_iterator Entry(PassFolder, Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		if (Entry->path().extension() == ".exr")
		{
			Passes.push_back(Entry->path());
		}
	}
	if (Error && Error != std::errc::no_such_file_or_directory)
	{
		throw MakeError(ErrorFileMissing, PassFolder.string(), "cannot be listed: " + Error.message(), ExitFiles);
	}
	std::ranges::sort(Passes);
	std::vector<std::pair<std::string, std::string>> Images;
	std::map<std::string, int> Seen;
	for (const Files::path& Pass : Passes)
	{
		const std::string Key = GetPassKey(Pass);
		const int Count = ++Seen[Key];
		Images.emplace_back(Count > 1 ? Key + " #" + std::to_string(Count) : Key, Pass.string());
	}
	for (const char* Name : {"scene_linear", "final"})
	{
		const Files::path File = Files::path(Folder) / (std::string(Name) + ".exr");
		if (Files::is_regular_file(File, Error))
		{
			Images.emplace_back(Name, File.string());
		}
	}
	return Images;
}

std::vector<FPair> PairRuns(const std::string& FolderA, const std::string& FolderB)
{
	std::vector<FPair> Pairs;
	for (const auto& [Name, File] : ListRun(FolderA))
	{
		Pairs.push_back({Name, File, "", {}, {}});
	}
	for (const auto& [Name, File] : ListRun(FolderB))
	{
		const auto Found = std::ranges::find(Pairs, Name, &FPair::Name);
		if (Found != Pairs.end())
		{
			Found->B = File;
		}
		else
		{
			Pairs.push_back({Name, "", File, {}, {}});
		}
	}
	if (Pairs.empty())
	{
		throw MakeError(
			ErrorFileMissing, FolderA, "neither folder holds a run: no final.exr and no passes/", ExitFiles);
	}
	return Pairs;
}

std::string Describe(const FComparedImage& Image)
{
	const FImageWindow& Window = Image.Window;
	const bool bPart = Window.FullWidth != Image.Image.Width || Window.FullHeight != Image.Image.Height;
	const std::string Where =
		bPart ? fmt::format(" at ({}, {}) of {} x {}", Window.X, Window.Y, Window.FullWidth, Window.FullHeight)
			  : std::string();
	return fmt::format("{} x {}{} ({})", Image.Image.Width, Image.Image.Height, Where, fmt::join(Image.Channels, ","));
}

bool LiesInWhole(const FComparedImage& Part)
{
	return Part.Window.X >= 0 && Part.Window.Y >= 0 && Part.Window.X + Part.Image.Width <= Part.Window.FullWidth &&
		   Part.Window.Y + Part.Image.Height <= Part.Window.FullHeight;
}

/** The image with zeros around it: a resource holds 0 where nothing was drawn. */
FImage Widen(const FComparedImage& Part, const FImageWindow& Corner, int Width, int Height)
{
	FImage Wide{Width, Height, Part.Image.NumChannels, {}};
	const size_t NumChannels = static_cast<size_t>(Wide.NumChannels);
	Wide.Values.resize(static_cast<size_t>(Width) * static_cast<size_t>(Height) * NumChannels);
	const size_t RowSize = static_cast<size_t>(Part.Image.Width) * NumChannels;
	for (int Y = 0; Y < Part.Image.Height; ++Y)
	{
		const size_t To = (static_cast<size_t>(Part.Window.Y - Corner.Y + Y) * static_cast<size_t>(Width) +
							  static_cast<size_t>(Part.Window.X - Corner.X)) *
						  NumChannels;
		std::copy_n(Part.Image.Values.begin() + static_cast<std::ptrdiff_t>(static_cast<size_t>(Y) * RowSize), RowSize,
			Wide.Values.begin() + static_cast<std::ptrdiff_t>(To));
	}
	return Wide;
}

/** Two parts of pictures of one size become what covers both. */
void WidenToBoth(FComparedImage& A, FComparedImage& B)
{
	FImageWindow Both = A.Window;
	Both.X = std::min(A.Window.X, B.Window.X);
	Both.Y = std::min(A.Window.Y, B.Window.Y);
	const int Width = std::max(A.Window.X + A.Image.Width, B.Window.X + B.Image.Width) - Both.X;
	const int Height = std::max(A.Window.Y + A.Image.Height, B.Window.Y + B.Image.Height) - Both.Y;
	A.Image = Widen(A, Both, Width, Height);
	B.Image = Widen(B, Both, Width, Height);
	A.Window = B.Window = Both;
}

/** HeatMap, FlipMap: files to write, or empty. Page: where the pictures go, too; or none. */
void Compare(FPair& Pair, const std::string& HeatMap, const std::string& FlipMap, std::optional<FDiffPage>& Page)
{
	FComparedImage A = ReadComparedImage(Pair.A);
	FComparedImage B = ReadComparedImage(Pair.B);
	const bool bSameWhole = A.Window.FullWidth == B.Window.FullWidth && A.Window.FullHeight == B.Window.FullHeight;
	const bool bSamePart = A.Window == B.Window && A.Image.Width == B.Image.Width && A.Image.Height == B.Image.Height;
	if (!bSameWhole || (!bSamePart && !(LiesInWhole(A) && LiesInWhole(B))) || A.Channels != B.Channels)
	{
		throw MakeError(ErrorImagesDiffer, Pair.A,
			"the images cannot be compared: this one is " + Describe(A) + ", " + Pair.B + " is " + Describe(B),
			ExitUsage);
	}
	if (A.Encoding != B.Encoding)
	{
		throw MakeError(ErrorImagesDiffer, Pair.A,
			"the images cannot be compared: one is display-encoded, the other linear light (" + Pair.B + ")",
			ExitUsage);
	}
	if (!bSamePart)
	{
		WidenToBoth(A, B);
	}
	FImageErrorOptions Options;
	Options.Encoding = A.Encoding;
	Pair.Channels = A.Channels;
	Pair.Error = CompareImages(A.Image, B.Image, Options);
	if (Page)
	{
		Page->AddPair(Pair.Name, A, B, Pair.Error);
	}
	Pair.Error.MaxX += A.Window.X;
	Pair.Error.MaxY += A.Window.Y;
	if (!HeatMap.empty())
	{
		const double Full = std::isfinite(Pair.Error.Max) ? Pair.Error.Max : Pair.Error.Peak;
		WritePicture(HeatMap, MakeHeatMap(A.Image, B.Image, Full));
	}
	if (!FlipMap.empty())
	{
		WritePicture(FlipMap, MakeFlipMap(A.Image, B.Image, A.Encoding));
	}
}

std::string MakeDiffTable(const std::vector<FPair>& Pairs)
{
	std::vector<std::vector<std::string>> Rows = {
		{"image", "max", "rms", "relative", "PSNR dB", "SSIM", "FLIP", "largest at"}};
	for (const FPair& Pair : Pairs)
	{
		if (Pair.A.empty() || Pair.B.empty())
		{
			Rows.push_back({Pair.Name, Pair.A.empty() ? "only in B" : "only in A", "", "", "", "", "", ""});
			continue;
		}
		const FImageError& Error = Pair.Error;
		const std::string Where =
			Error.Max == 0.0 ? "equal"
							 : fmt::format("({}, {}) {}: {:.6g} against {:.6g}", Error.MaxX, Error.MaxY,
								   Pair.Channels[static_cast<size_t>(Error.MaxChannel)], Error.MaxA, Error.MaxB);
		Rows.push_back({Pair.Name, fmt::format("{:.4g}", Error.Max), fmt::format("{:.4g}", Error.Rms),
			fmt::format("{:.4g}", Error.Relative), fmt::format("{:.2f}", Error.Psnr), fmt::format("{:.6f}", Error.Ssim),
			fmt::format("{:.5f}", Error.Flip), Where});
	}
	constexpr ETextColumn Number = ETextColumn::Number;
	return FTextTable{
		{{ETextColumn::Name}, {Number}, {Number}, {Number, 2}, {Number}, {Number, 1}, {Number}, {ETextColumn::Text}},
		Rows}
		.Format(GetOutputWidth());
}

/** Fails where a difference is above Max, or an image is there once only, and Max is given. */
FJUnitCase MakeCase(const FPair& Pair, const FDiffOptions& Options)
{
	const bool bBoth = !Pair.A.empty() && !Pair.B.empty();
	FJUnitCase Case{.Name = Pair.Name, .Rule = "difference"};
	if (!bBoth)
	{
		Case.Output = Pair.A.empty() ? "only in " + Options.B : "only in " + Options.A;
	}
	else
	{
		Case.Output =
			fmt::format("max {:.6g} at ({}, {}), rms {:.6g}, relative {:.6g}, PSNR {:.2f} dB, SSIM {:.6f}, FLIP {:.5f}",
				Pair.Error.Max, Pair.Error.MaxX, Pair.Error.MaxY, Pair.Error.Rms, Pair.Error.Relative, Pair.Error.Psnr,
				Pair.Error.Ssim, Pair.Error.Flip);
	}
	if (Options.Max && !(bBoth && Pair.Error.Max <= *Options.Max))
	{
		Case.Outcome = EJUnitOutcome::Failed;
		Case.Message =
			bBoth ? fmt::format("differs by {:.6g}, more than the allowed {:.6g}", Pair.Error.Max, *Options.Max)
				  : Case.Output;
	}
	return Case;
}

/** The comparison of two records. */
struct FRunsCompared
{
	std::vector<FRunDifference> Differences;
	FTimeSpread A; // of all passes
	FTimeSpread B;
	int NumRepeats = 0;
};

/** Runs both in turn, as their records say; nothing is written. */
void Measure(const FDiffOptions& Options, FRunsCompared& Compared)
{
	std::array<FRunAgain, 2> Runs = {ReadRunAgain((Files::path(Options.A) / "run.json").string()),
		ReadRunAgain((Files::path(Options.B) / "run.json").string())};
	std::array<std::vector<double>, 2> Samples;
	FProgressBar Bar;
	for (int Turn = 0; Turn <= Options.NumRepeats; ++Turn) // the first one fills caches, and does not count
	{
		for (size_t Side = 0; Side < Runs.size(); ++Side)
		{
			Bar.Show(Turn, Options.NumRepeats + 1, Side == 0 ? "A" : "B");
			const double Milliseconds = RunConfig(Runs[Side].Options).Times.Execute;
			if (Turn > 0)
			{
				Samples[Side].push_back(Milliseconds);
			}
		}
	}
	Bar.Clear();
	Compared.NumRepeats = Options.NumRepeats;
	Compared.A = MakeTimeSpread(Samples[0]);
	Compared.B = MakeTimeSpread(Samples[1]);
}

/** Nothing where a folder has no run.json. */
std::optional<FRunsCompared> CompareRecords(const FDiffOptions& Options)
{
	const std::string A = ReadReportBefore(Options.A).RunJson;
	const std::string B = ReadReportBefore(Options.B).RunJson;
	if (A.empty() || B.empty())
	{
		return std::nullopt;
	}
	FRunsCompared Compared{CompareRuns(A, B), {}, {}, 0};
	if (Options.NumRepeats > 0)
	{
		Measure(Options, Compared);
	}
	return Compared;
}

/** {max: number or null, passed, images: [{name, a, b, max, rms, relative, psnr, ssim, flip, nonFinite, at, channel}],
 * and of two runs differences: [{kind, name, a, b}], times} */
std::string MakeDiffJson(const std::vector<FPair>& Pairs, const FDiffOptions& Options,
	const std::optional<FRunsCompared>& Runs, bool bPassed)
{
	FJsonWriter Writer('{');
	Writer.Members({{"allowed", Options.Max}, {"passed", bPassed}});
	Writer.Objects("images", Pairs,
		[&](const FPair& Pair)
		{
			Writer.Members({{"name", Pair.Name}, {"a", Pair.A}, {"b", Pair.B}});
			if (!Pair.A.empty() && !Pair.B.empty())
			{
				for (const std::string& Metric : GetMetricNames())
				{
					Writer.Member(Metric, GetMetric(Pair.Error, Metric));
				}
				Writer.Members(
					{{"nonFinite", Pair.Error.NumNonFinite}, {"at", std::array{Pair.Error.MaxX, Pair.Error.MaxY}},
						{"channel", Pair.Channels[static_cast<size_t>(Pair.Error.MaxChannel)]}});
			}
		});
	if (Runs)
	{
		WriteRunDifferences(Writer, "differences", Runs->Differences);
		Writer.Key("times").Object(
			{{"repeats", Runs->NumRepeats}, {"a", std::array{Runs->A.Low, Runs->A.Median, Runs->A.High}},
				{"b", std::array{Runs->B.Low, Runs->B.Median, Runs->B.High}},
				{"sentence", DescribeTimes(Runs->A, Runs->B, Runs->NumRepeats)}});
	}
	return Writer.GetText();
}

std::string MakeRunsText(const FRunsCompared& Runs)
{
	constexpr size_t MaxRows = 20;
	const std::string Times =
		Runs.NumRepeats > 0 ? "times    " + DescribeTimes(Runs.A, Runs.B, Runs.NumRepeats) + "\n" : std::string();
	return "\n" + FormatRunDifferences(Runs.Differences, MaxRows, GetOutputWidth()) + Times;
}

std::string GetMapFile(const std::string& Map, const FPair& Pair, bool bFolders)
{
	return Map.empty() || !bFolders ? Map : (Files::path(Map) / (Pair.Name + ".png")).string();
}

const FOutputNames& GetDiffOutputNames()
{
	static const FOutputNames Names = {
		.Name = "diff", .Files = {"diff.html"}, .Last = "diff.html", .Folders = {}, .Unsteady = {"diff.html"}};
	return Names;
}

/** ExitPolicy where a difference is above Max, or an image is there once only. Throws FError when they cannot be
 * compared. */
int Diff(const FDiffOptions& Options, FJUnitSuite& Suite)
{
	std::error_code Ignored; // what cannot be looked at cannot be opened either, which is reported there
	const bool bFolderA = Files::is_directory(Options.A, Ignored);
	const bool bFolderB = Files::is_directory(Options.B, Ignored);
	const bool bFolders = bFolderA && bFolderB;
	if (bFolderA != bFolderB)
	{
		throw MakeError(ErrorImagesDiffer, bFolderA ? Options.B : Options.A,
			"a run's folder can be compared only with a run's folder, an image only with an image", ExitUsage);
	}
	if (Options.NumRepeats > 0 && !bFolders)
	{
		throw BadArgument("runs both again: it needs the folders of two runs", "--repeat");
	}
	if (Options.bBaseline || (bFolders && IsBaseline(Options.B)))
	{
		CheckBaseline(Options.B);
	}
	std::vector<FPair> Pairs =
		bFolders ? PairRuns(Options.A, Options.B)
				 : std::vector<FPair>{{Files::path(Options.A).filename().string(), Options.A, Options.B, {}, {}}};
	std::optional<FOutputFolder> Folder;
	std::optional<FDiffPage> Page;
	if (!Options.Report.empty() && Options.Report != "off")
	{
		Folder.emplace(Options.OutputFolder, GetDiffOutputNames());
		Page.emplace();
	}
	bool bPassed = true;
	for (FPair& Pair : Pairs)
	{
		if (!Pair.A.empty() && !Pair.B.empty())
		{
			Compare(
				Pair, GetMapFile(Options.HeatMap, Pair, bFolders), GetMapFile(Options.FlipMap, Pair, bFolders), Page);
		}
		Suite.Cases.push_back(MakeCase(Pair, Options));
		bPassed = bPassed && Suite.Cases.back().Outcome == EJUnitOutcome::Passed;
	}
	const std::optional<FRunsCompared> Runs = bFolders ? CompareRecords(Options) : std::nullopt;
	const std::string Json = MakeDiffJson(Pairs, Options, Runs, bPassed);
	if (Page)
	{
		const std::string Data = Page->MakeData(Options.A, Options.B, Json, FormatReportTime(std::time(nullptr)));
		WriteWholeFile((Folder->GetAside() / "diff.html").string(), MakeReportPage(Data));
		Folder->PutInPlace();
	}
	PrintResult(Options.bJson ? Json : MakeDiffTable(Pairs) + (Runs ? MakeRunsText(*Runs) : ""), Options.bJson);
	if (Page && !Options.bJson)
	{
		PrintPage(Folder->GetPath() / "diff.html");
	}
	if (!bPassed)
	{
		PrintText(stderr, fmt::format("the images differ by more than {:g}\n", *Options.Max));
	}
	return bPassed ? ExitDone : ExitPolicy;
}

} // namespace

FVerbCall AddDiffOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FDiffOptions>();
	Verb.Add("A", Options->A, "First image, or folder of a run").Require();
	Verb.Add("B", Options->B, "Second image or folder, of the same kind and size").Require();
	Verb.AddFlag("--baseline", Options->bBaseline, "Refuse a B that is not a baseline, as drydock bless makes it");
	Verb.Add("--max", Options->Max, "Exit with code 1 if a value differs by more than this")
		.RequireNonNegative()
		.SetType("M");
	Verb.Add("--heatmap", Options->HeatMap,
			"Write a PNG that shows the error, over four decades; for two runs a folder with a PNG for each picture")
		.SetType("FILE");
	Verb.Add("--flipmap", Options->FlipMap,
			"Write a PNG of FLIP, the difference that a person sees between the pictures; for two runs a folder")
		.SetType("FILE");
	Verb.Add("--out", Options->OutputFolder, "Folder for the page; out/diff by default").SetType("DIR");
	Verb.Add("--repeat", Options->NumRepeats,
			"Run both again in turn, this many times, to say whether one is faster; for two runs")
		.RequireRange(3, 1000)
		.SetType("N");
	AddReport(
		Verb, Options->Report, "diff.html, both pictures over each other and the differences in their making", false);
	AddFindings(Verb, Options->Findings, "a case for each pair of pictures");
	Verb.AddFlag("--json", Options->bJson, "Print the error figures as JSON");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "diff", Options->A + " against " + Options->B,
			[&Options](FJUnitSuite& Suite) { return Diff(*Options, Suite); });
	};
}

} // namespace Drydock
