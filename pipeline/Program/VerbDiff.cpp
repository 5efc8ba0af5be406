// `drydock diff`. Source: drydock.
#include "Picture/ImageMetrics.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

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
	FDiagnostic Diagnostic;
	Diagnostic.Code = Code;
	Diagnostic.File = File;
	Diagnostic.Message = Message;
	return FError(Diagnostic, ExitCode);
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
	if (Files::is_directory(Files::path(Folder) / "passes"))
	{
		for (const Files::directory_entry& Entry : Files::directory_iterator(Files::path(Folder) / "passes"))
		{
			if (Entry.path().extension() == ".exr")
			{
				Passes.push_back(Entry.path());
			}
		}
	}
	std::sort(Passes.begin(), Passes.end());
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
		if (Files::is_regular_file(File))
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
		const auto Found =
			std::find_if(Pairs.begin(), Pairs.end(), [&Name = Name](const FPair& Pair) { return Pair.Name == Name; });
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
	std::string Names;
	for (const std::string& Channel : Image.Channels)
	{
		Names += (Names.empty() ? "" : ",") + Channel;
	}
	return std::to_string(Image.Image.Width) + " x " + std::to_string(Image.Image.Height) + " (" + Names + ")";
}

/** HeatMap: a file to write, or empty. */
void Compare(FPair& Pair, const std::string& HeatMap)
{
	const FComparedImage A = ReadComparedImage(Pair.A);
	const FComparedImage B = ReadComparedImage(Pair.B);
	if (A.Image.Width != B.Image.Width || A.Image.Height != B.Image.Height || A.Channels != B.Channels)
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
	FImageErrorOptions Options;
	Options.Encoding = A.Encoding;
	Pair.Channels = A.Channels;
	Pair.Error = CompareImages(A.Image, B.Image, Options);
	if (!HeatMap.empty())
	{
		const double Full = std::isfinite(Pair.Error.Max) ? Pair.Error.Max : Pair.Error.Peak;
		std::error_code Ignored;
		if (Files::path(HeatMap).has_parent_path())
		{
			Files::create_directories(Files::path(HeatMap).parent_path(), Ignored);
		}
		WritePng(HeatMap, MakeHeatMap(A.Image, B.Image, Full));
	}
}

std::string MakeTable(const std::vector<FPair>& Pairs)
{
	std::vector<std::vector<std::string>> Rows = {{"image", "max", "rms", "relative", "PSNR dB", "SSIM", "largest at"}};
	for (const FPair& Pair : Pairs)
	{
		if (Pair.A.empty() || Pair.B.empty())
		{
			Rows.push_back({Pair.Name, Pair.A.empty() ? "only in B" : "only in A", "", "", "", "", ""});
			continue;
		}
		const FImageError& Error = Pair.Error;
		const std::string Where = Error.Max == 0.0
									  ? "equal"
									  : "(" + std::to_string(Error.MaxX) + ", " + std::to_string(Error.MaxY) + ") " +
											Pair.Channels[static_cast<size_t>(Error.MaxChannel)] + ": " +
											Format("%.6g", Error.MaxA) + " against " + Format("%.6g", Error.MaxB);
		Rows.push_back({Pair.Name, Format("%.4g", Error.Max), Format("%.4g", Error.Rms), Format("%.4g", Error.Relative),
			Format("%.2f", Error.Psnr), Format("%.6f", Error.Ssim), Where});
	}
	std::vector<size_t> Widths(Rows[0].size(), 0);
	for (const std::vector<std::string>& Row : Rows)
	{
		for (size_t Column = 0; Column < Row.size(); ++Column)
		{
			Widths[Column] = std::max(Widths[Column], Row[Column].size());
		}
	}
	std::string Text;
	for (const std::vector<std::string>& Row : Rows)
	{
		std::string Line;
		for (size_t Column = 0; Column < Row.size(); ++Column)
		{
			const std::string Padding(Widths[Column] - Row[Column].size(), ' ');
			const bool bText = Column == 0 || Column + 1 == Row.size();
			Line += (Column > 0 ? "  " : "") + (bText ? Row[Column] + Padding : Padding + Row[Column]);
		}
		Text += Line.substr(0, Line.find_last_not_of(' ') + 1) + "\n";
	}
	return Text;
}

/** {max: number or null, passed, images: [{name, a, b, max, rms, relative, psnr, ssim, nonFinite, at, channel}]} */
std::string MakeJson(const std::vector<FPair>& Pairs, const FDiffOptions& Options, bool bPassed)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Options.Max ? Writer.Member("allowed", *Options.Max) : Writer.Key("allowed").Null();
	Writer.Member("passed", bPassed);
	Writer.Key("images").BeginArray();
	for (const FPair& Pair : Pairs)
	{
		Writer.BeginObject(true);
		Writer.Member("name", Pair.Name);
		Writer.Member("a", Pair.A);
		Writer.Member("b", Pair.B);
		if (!Pair.A.empty() && !Pair.B.empty())
		{
			for (const std::string& Metric : GetMetricNames())
			{
				Writer.Member(Metric, GetMetric(Pair.Error, Metric));
			}
			Writer.Member("nonFinite", Pair.Error.NumNonFinite);
			Writer.Key("at").BeginArray(true);
			Writer.Value(Pair.Error.MaxX);
			Writer.Value(Pair.Error.MaxY);
			Writer.EndArray();
			Writer.Member("channel", Pair.Channels[static_cast<size_t>(Pair.Error.MaxChannel)]);
		}
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
	return Writer.GetText();
}

std::string GetHeatMapFile(const std::string& HeatMap, const FPair& Pair, bool bFolders)
{
	return HeatMap.empty() || !bFolders ? HeatMap : (Files::path(HeatMap) / (Pair.Name + ".png")).string();
}

} // namespace

int DiffVerb(const FDiffOptions& Options)
{
	const bool bFolders = Files::is_directory(Options.A) && Files::is_directory(Options.B);
	if (!bFolders && (Files::is_directory(Options.A) || Files::is_directory(Options.B)))
	{
		throw MakeError(ErrorImagesDiffer, Files::is_directory(Options.A) ? Options.B : Options.A,
			"a folder of a run can be compared with another one only, an image with an image", ExitUsage);
	}
	std::vector<FPair> Pairs =
		bFolders ? PairRuns(Options.A, Options.B)
				 : std::vector<FPair>{{Files::path(Options.A).filename().string(), Options.A, Options.B, {}, {}}};
	bool bPassed = true;
	for (FPair& Pair : Pairs)
	{
		if (Pair.A.empty() || Pair.B.empty())
		{
			bPassed = false;
			continue;
		}
		Compare(Pair, GetHeatMapFile(Options.HeatMap, Pair, bFolders));
		bPassed = bPassed && Pair.Error.Max <= Options.Max.value_or(HUGE_VAL);
	}
	bPassed = bPassed || !Options.Max;
	std::fputs((Options.bJson ? MakeJson(Pairs, Options, bPassed) : MakeTable(Pairs)).c_str(), stdout);
	if (!bPassed)
	{
		std::fprintf(stderr, "the images differ by more than %g\n", *Options.Max);
	}
	return bPassed ? ExitDone : ExitPolicy;
}

} // namespace Drydock
