// Hands dispatches to those who look at them, and writes what they saw.
#include "Inspect/RunInspection.h"

#include "Inspect/InspectPictures.h"
#include "Run/RunDump.h"
#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"
#include "Text/TextTable.h"

#include <algorithm>

namespace Drydock
{

namespace
{

FLineRequest MakeLineRequest(const FInspectOptions& Options)
{
	FLineRequest Request;
	for (const std::string& Place : Options.Show)
	{
		Request.Show.push_back(ParseLinePlace(Place));
	}
	Request.bCoverage = Options.bCoverage;
	Request.bCost = Options.bCost;
	Request.bRanges = Options.bRanges;
	Request.bAllThreads = Options.bAllThreads;
	Request.Passes = Options.Passes;
	return Request;
}

std::optional<std::array<int32_t, 3>> GetPrintAt(const FInspectOptions& Options)
{
	if (Options.PrintAt.empty())
	{
		return std::nullopt;
	}
	return std::array<int32_t, 3>{Options.PrintAt.at(0), Options.PrintAt.at(1), 0};
}

std::string GetFileName(const std::string& Path)
{
	return Path.substr(Path.rfind('/') + 1);
}

/** "01.Blur.Blur_usf.41.Weight" */
std::string MakeName(size_t Index, const std::string& Pass, const std::string& File, int Line, const std::string& What)
{
	return fmt::format("{:02}.{}.{}.{}.{}", Index + 1, MakeFileNamePart(GetShortPassName(Pass)),
		MakeFileNamePart(GetFileName(File)), Line, MakeFileNamePart(What));
}

std::vector<std::string> GetNames(int NumChannels)
{
	const std::vector<std::string> Names = {"R", "G", "B", "A"};
	return NumChannels == 1 ? std::vector<std::string>{"Y"}
							: std::vector<std::string>(Names.begin(), Names.begin() + NumChannels);
}

/** True for a file that a person edits: not for the headers that the engine ships. */
bool IsAuthors(const std::string& File)
{
	return File.ends_with(".usf") || !File.starts_with("/Engine/");
}

} // namespace

FRunInspection::FRunInspection(const FInspectOptions& InOptions)
	: Options(InOptions)
	, Checks(MakeCheckSet(Options.Checks), {Options.Passes, Options.bAllThreads, true, false})
	, Lines(MakeLineRequest(Options))
	, Prints(GetPrintAt(Options), Options.Passes)
	, Debug(Options.Debug ? std::make_unique<FDebugCapture>(*Options.Debug) : nullptr)
{
}

FRunInspection::~FRunInspection() = default;

void FRunInspection::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	if (!Options.Checks.empty())
	{
		Checks.BeforeDispatch(Shader, Args, Whole);
	}
	Lines.BeforeDispatch(Shader, Args, Whole);
	if (Options.bPrint)
	{
		Prints.BeforeDispatch(Shader, Args, Whole);
	}
	if (Debug)
	{
		Debug->BeforeDispatch(Shader, Args, Whole);
	}
}

void FRunInspection::AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	if (!Options.Checks.empty())
	{
		Checks.AfterDispatch(Shader, Args, Whole);
	}
}

std::vector<FDiagnostic> FRunInspection::GetDiagnostics() const
{
	std::vector<FDiagnostic> Diagnostics = Checks.GetDiagnostics();
	if (Options.bPrint && !Prints.CanPrint())
	{
		Diagnostics.push_back({.Severity = ESeverity::Warning,
			.Code = WarnNothingPrinted,
			.Message = "no shader that ran prints anything; expected DrydockPrint or the engine's ShaderPrint",
			.Where = "--print"});
	}
	const std::vector<FDiagnostic> Debugged = Debug ? Debug->GetDiagnostics() : std::vector<FDiagnostic>();
	Diagnostics.insert(Diagnostics.end(), Debugged.begin(), Debugged.end());
	return Diagnostics;
}

void FRunInspection::WriteFindings(const std::filesystem::path& Folder) const
{
	size_t Index = 0;
	for (const FPassFinding& Found : Checks.GetFindings())
	{
		const std::string Name =
			MakeName(Index++, Found.Pass, Found.Finding.File, Found.Finding.Line, GetCheckName(Found.Finding.Check));
		WritePng((Folder / (Name + ".png")).string(), MakeMask(Found));
	}
}

std::string FRunInspection::WriteLines(const std::filesystem::path& Folder) const
{
	std::string Text;
	size_t Index = 0;
	for (const FShownLine& Shown : Lines.GetShown())
	{
		const FLineValues& Values = Shown.Values;
		const FValueRange Range = FindRange(Values);
		const std::string Name = MakeName(Index++, Shown.Pass, Values.File, Shown.Line, Values.Variable);
		WriteExr((Folder / (Name + ".exr")).string(), MakeValueImage(Values), GetNames(Values.NumChannels));
		WritePng((Folder / (Name + ".png")).string(), MakeStretched(Values, Range));
		const std::string Part = Values.NumNumbers > uint32_t(Values.NumChannels)
									 ? fmt::format(" (the first 4 of {} numbers)", Values.NumNumbers)
									 : std::string();
		Text += fmt::format("{}:{} {}{} in {}: from {} to {}, of {} of {} pixels{} -> {}/{}.png\n",
			GetFileName(Values.File), Shown.Line, Values.Variable, Part, Shown.Pass, NumberText(float(Range.Least)),
			NumberText(float(Range.Most)), Range.Reached, Values.bReached.size(),
			Range.NotFinite ? fmt::format(", {} not finite", Range.NotFinite) : std::string(), InspectFolderName, Name);
	}
	return Text;
}

std::string FRunInspection::WriteCosts(const std::filesystem::path& Folder, int Width) const
{
	std::vector<std::vector<std::string>> Rows = {
		{"cost of a pixel", "taps", "most", "operations", "least", "most", "picture"}};
	size_t Index = 0;
	for (const FPassCost& Cost : Lines.GetCosts())
	{
		const FCostMap& Map = Cost.Map;
		const std::string Name =
			fmt::format("{:02}.{}.cost", Index++ + 1, MakeFileNamePart(GetShortPassName(Cost.Pass)));
		WriteExr((Folder / (Name + ".exr")).string(), MakeCostImage(Map), {"taps", "operations"});
		WritePng((Folder / (Name + ".png")).string(), MakeCostPreview(Map));
		const auto Mean = [](const std::vector<uint64_t>& Counts)
		{
			double Sum = 0;
			for (const uint64_t Count : Counts)
			{
				Sum += double(Count);
			}
			return fmt::format("{:.1f}", Counts.empty() ? 0.0 : Sum / double(Counts.size()));
		};
		const auto Least = std::ranges::min_element(Map.Operations);
		const auto Most = std::ranges::max_element(Map.Operations);
		const auto MostTaps = std::ranges::max_element(Map.Taps);
		const bool bAny = !Map.Operations.empty();
		Rows.push_back({Cost.Pass, Mean(Map.Taps), bAny ? std::to_string(*MostTaps) : "0", Mean(Map.Operations),
			bAny ? std::to_string(*Least) : "0", bAny ? std::to_string(*Most) : "0", Name + ".png"});
	}
	constexpr ETextColumn Number = ETextColumn::Number;
	const std::vector<FTextColumn> Columns = {
		{ETextColumn::Name}, {Number}, {Number}, {Number}, {Number}, {Number}, {ETextColumn::Name}};
	return Rows.size() == 1 ? std::string() : FTextTable{Columns, Rows}.Format(Width);
}

std::string FRunInspection::FormatRanges(int Width) const
{
	std::string Text;
	for (const FPassRanges& Pass : Lines.GetRanges())
	{
		std::vector<std::vector<std::string>> Rows = {
			{"line", "variable", "least", "most", "NaN, Inf", "what it does"}};
		for (const FLineRange& Range : Pass.Lines)
		{
			const bool bFinite = Range.Least <= Range.Most;
			Rows.push_back({fmt::format("{}:{}", GetFileName(Range.File), Range.Line), Range.Variable,
				bFinite ? NumberText(float(Range.Least)) : "", bFinite ? NumberText(float(Range.Most)) : "",
				Range.NotFinite ? std::to_string(Range.NotFinite) : "", Range.Source});
		}
		constexpr ETextColumn Number = ETextColumn::Number;
		const std::vector<FTextColumn> Columns = {
			{ETextColumn::Name}, {ETextColumn::Name}, {Number}, {Number}, {Number}, {ETextColumn::Text}};
		Text += fmt::format("{}  ({})\n", Pass.Pass, Pass.Shader) + FTextTable{Columns, Rows}.Format(Width, "  ");
	}
	return Text;
}

std::string FRunInspection::WriteCoverage(const std::filesystem::path& Folder) const
{
	const FLineCoverage& Coverage = Lines.GetCoverage();
	WriteWholeFile((Folder / "coverage.txt").string(), MakeCoverageText(Coverage));
	std::string Text;
	for (const auto& [File, Counts] : Coverage.Files)
	{
		if (!IsAuthors(File))
		{
			continue;
		}
		const auto NumRun = std::ranges::count_if(Counts, [](const auto& Entry) { return Entry.second.Threads != 0; });
		Text += fmt::format("{}: {} of {} lines ran\n", GetFileName(File), NumRun, Counts.size());
		for (const auto& [Line, Count] : Counts)
		{
			if (!Count.Threads)
			{
				Text += fmt::format("  line {} never ran: {}\n", Line, Count.Source);
			}
		}
	}
	return Text + fmt::format("all lines: {}/coverage.txt\n", InspectFolderName);
}

std::string FRunInspection::Write(const std::filesystem::path& RunFolder, int Width) const
{
	const std::filesystem::path Folder = RunFolder / InspectFolderName;
	if (!Checks.GetFindings().empty() || !Options.Show.empty() || Options.bCoverage || Options.bCost)
	{
		std::error_code Error;
		std::filesystem::create_directory(Folder, Error);
		if (Error)
		{
			throw MakeWriteError(Folder.string(), Error.message());
		}
	}
	WriteFindings(Folder);
	return MakePrintText(Prints.GetPrints()) + WriteLines(Folder) + WriteCosts(Folder, Width) + FormatRanges(Width) +
		   (Options.bCoverage ? WriteCoverage(Folder) : std::string());
}

} // namespace Drydock
