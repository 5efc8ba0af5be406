// Takes a frame, or the frames of a sequence, through the steps of an import.
#include "Import/Import.h"

#include "Extensions/PublishedSchema.h"
#include "Config/FrameSequence.h"
#include "Import/ImportErrors.h"
#include "Import/ImportFigures.h"
#include "Import/ImportReport.h"
#include "Import/ImportWrite.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** The files of one frame, and where its scene goes. */
struct FImportJob
{
	std::vector<std::string> Paths;
	std::optional<int> Frame; // of a sequence
	std::string Scene;
};

/** "walk.####.exr" and 7: "walk.0007.exr". */
std::string FillNumber(const std::string& Pattern, int Number)
{
	const size_t Last = Pattern.rfind('#');
	const size_t Before = Pattern.find_last_not_of('#', Last);
	const size_t First = Before == std::string::npos ? 0 : Before + 1;
	return Pattern.substr(0, First) + fmt::format("{:0{}d}", Number, Last + 1 - First) + Pattern.substr(Last + 1);
}

FError MakeOptionError(const char* Where, const std::string& Message)
{
	return FError({.Code = ErrorImportOption, .Message = Message, .Where = Where}, ExitUsage);
}

FError MakeFramesError(const std::string& File, const std::string& Message)
{
	return FError({.Code = ErrorImportFrames, .Message = Message, .File = File}, ExitFiles);
}

void CheckOutputName(const FImportOptions& Options, bool bSequence)
{
	const std::string& Name = Options.OutputFile;
	if (Name.empty() && Options.bDryRun)
	{
		return;
	}
	if (Files::path(Name).extension() != ".exr")
	{
		throw MakeOptionError("--out", "\"" + Name + "\": expected a file that ends in .exr");
	}
	if (bSequence != IsFrameSequence(Name))
	{
		throw MakeOptionError("--out", "\"" + Name +
										   (bSequence ? "\": the frames of a sequence need a name with #### too"
													  : "\": one frame has a name without #"));
	}
}

/** Frames that the first sequence has; every other has to have them too. */
std::vector<FImportJob> FindJobs(const FImportOptions& Options)
{
	const auto First = std::ranges::find_if(Options.Inputs, IsFrameSequence);
	const bool bSequence = First != Options.Inputs.end();
	CheckOutputName(Options, bSequence);
	if (!bSequence)
	{
		return {{Options.Inputs, std::nullopt, Options.OutputFile}};
	}
	const std::vector<FSequenceFrame> Frames = FindSequenceFrames(*First);
	if (Frames.empty())
	{
		throw MakeFramesError(*First, "no file has this name");
	}
	std::vector<std::vector<FSequenceFrame>> AllFrames; // of each input
	for (const std::string& Input : Options.Inputs)
	{
		AllFrames.push_back(FindSequenceFrames(Input));
	}
	std::vector<FImportJob> Jobs;
	for (const FSequenceFrame& Frame : Frames)
	{
		FImportJob Job;
		Job.Frame = Frame.Number;
		Job.Scene = Options.bDryRun ? "" : FillNumber(Options.OutputFile, Frame.Number);
		for (size_t Index = 0; Index < Options.Inputs.size(); ++Index)
		{
			const std::string& Input = Options.Inputs[Index];
			const std::vector<FSequenceFrame>& Others = AllFrames[Index];
			const auto Same = std::ranges::find(Others, Frame.Number, &FSequenceFrame::Number);
			if (IsFrameSequence(Input) && Same == Others.end())
			{
				throw MakeFramesError(Input, fmt::format("there is no frame {}, which {} has", Frame.Number, *First));
			}
			Job.Paths.push_back(IsFrameSequence(Input) ? Same->Path : Input);
		}
		Jobs.push_back(std::move(Job));
	}
	return Jobs;
}

/** The decisions that the first frame makes for all frames. */
struct FDecided
{
	FImportLayers Layers;
	FImportPlan Plan;
	std::vector<FImportMatte> Mattes;
	FImportChoices Choices;
};

/** All that is wrong with the options, together. */
FDecided Decide(const std::vector<std::string>& Paths, const FImportAsked& Asked, std::vector<FDiagnostic>& Diagnostics)
{
	FDecided Decided;
	Decided.Layers = ReadImportLayers(Paths);
	std::vector<FDiagnostic> Errors;
	Decided.Mattes = FindImportMattes(Decided.Layers, Diagnostics);
	Decided.Choices = ChooseImportObjects(Asked, Decided.Mattes, Errors);
	try
	{
		Decided.Plan = GuessImport(Decided.Layers, Asked, Diagnostics);
	}
	catch (const FError& Error)
	{
		Errors.insert(Errors.begin(), Error.GetDiagnostics().begin(), Error.GetDiagnostics().end());
	}
	if (!Errors.empty())
	{
		throw FError(Errors, ExitUsage);
	}
	return Decided;
}

/** Whether the layers of another frame are those of the first. */
bool AreSameLayers(const FImportLayers& A, const FImportLayers& B)
{
	const auto IsSame = [](const FImportLayer& One, const FImportLayer& Other)
	{
		return One.Name == Other.Name && One.File == Other.File && One.Part == Other.Part &&
			   std::ranges::equal(One.Channels, Other.Channels,
				   [](const FImportChannel& X, const FImportChannel& Y)
				   { return X.Name == Y.Name && X.Index == Y.Index; });
	};
	const auto IsSameSize = [](const FImportFile& One, const FImportFile& Other)
	{
		return One.Parts[0].GetFullWidth() == Other.Parts[0].GetFullWidth() &&
			   One.Parts[0].GetFullHeight() == Other.Parts[0].GetFullHeight();
	};
	return std::ranges::equal(A.Layers, B.Layers, IsSame) && std::ranges::equal(A.Files, B.Files, IsSameSize);
}

std::map<std::string, std::string> JoinAttributes(const FImportLayers& Layers)
{
	std::map<std::string, std::string> All;
	for (const FImportFile& File : Layers.Files)
	{
		All.insert(File.Attributes.begin(), File.Attributes.end());
	}
	return All;
}

void ReportMissing(const FImportScene& Scene, std::vector<FDiagnostic>& Diagnostics)
{
	std::string List = JoinText(
		FindMissingChannels(Scene), ", ", [&](const std::string& Name) { return Name.substr(0, Name.find('.')); });
	if (!List.empty())
	{
		Diagnostics.push_back({.Severity = ESeverity::Warning,
			.Code = WarnImportMissing,
			.Message =
				"no layer gives " + List +
				": a pass that reads them is refused, or reads the defaults of the config (docs/your-frame.md)"});
	}
	const std::vector<float>* const Ids = Scene.Find("shadingmodel.ID");
	if (Ids != nullptr && std::find(Ids->begin(), Ids->end(), 8.0f) == Ids->end())
	{
		Diagnostics.push_back({.Severity = ESeverity::Note,
			.Code = WarnImportMissing,
			.Message = "no pixel has shading model 8, which marks toon shading: --toon OBJECT gives it to objects"});
	}
}

/** Beside the config, where no other file has the name. */
void WriteSchema(const std::string& ConfigPath)
{
	const std::string Path = (Files::path(ConfigPath).parent_path() / ImportSchemaName).string();
	const std::optional<std::string> There = TryReadTextFile(Path);
	std::error_code Ignored;
	const bool bOurs = There && There->find("\"title\": \"drydock config\"") != std::string::npos;
	if (bOurs || !Files::exists(Path, Ignored))
	{
		WriteTextFile(Path, MakePublishedSchema());
	}
}

void WriteConfig(const FImportOptions& Options, const FImportScene& Scene, FImportResult& Result)
{
	const std::string Path = GetImportConfigPath(Options.OutputFile);
	const std::string Text = MakeImportConfig(Options.OutputFile, Scene, Options.Inputs);
	const std::optional<std::string> There = TryReadTextFile(Path);
	std::error_code Ignored;
	if (Files::exists(Path, Ignored) && There != Text && !Options.bForce)
	{
		Result.Diagnostics.push_back({.Severity = ESeverity::Note,
			.Code = NoteImportConfigKept,
			.Message = "already exists and is kept; --force replaces it",
			.File = Path});
		return;
	}
	WriteTextFile(Path, Text);
	WriteSchema(Path);
	Result.Config = Path;
}

} // namespace

FImportResult ImportFrame(const FImportOptions& Options)
{
	FImportResult Result;
	const std::vector<FImportJob> Jobs = FindJobs(Options);
	for (const FImportJob& Job : Jobs)
	{
		if (!Options.bDryRun)
		{
			CheckImportTarget(Job.Scene, Job.Paths, Options.bForce);
		}
	}
	FDecided Decided = Decide(Jobs.front().Paths, Options.Asked, Result.Diagnostics);
	for (const FImportJob& Job : Jobs)
	{
		const bool bFirst = &Job == &Jobs.front();
		std::vector<FDiagnostic> Repeated; // what the first frame's reader knows already
		std::vector<FDiagnostic>& Diagnostics = bFirst ? Result.Diagnostics : Repeated;
		const FImportLayers Layers = bFirst ? Decided.Layers : ReadImportLayers(Job.Paths);
		if (!AreSameLayers(Decided.Layers, Layers))
		{
			throw MakeFramesError(
				Job.Paths.front(), "has other layers or another size than " + Jobs.front().Paths.front());
		}
		const FImportPlanes Planes = ReadImportPlanes(Layers, Decided.Plan, Decided.Choices.GetSources(), Diagnostics);
		if (bFirst)
		{
			LookAtValues(Decided.Plan, Planes, Options.Asked, Diagnostics);
		}
		const FImportCamera Camera = ReadImportCamera(JoinAttributes(Layers), Options.Asked);
		FImportScene Scene = ConvertImport(Layers, Decided.Plan, Planes, Decided.Choices, Camera, Diagnostics);
		Scene.CameraJson = MakeCameraJson(Camera, Scene.Width, Scene.Height, Job.Frame);
		if (bFirst)
		{
			CheckFigures(Scene, Decided.Plan, Planes, Diagnostics);
			ReportMissing(Scene, Diagnostics);
			const FImportStory Story{Layers, Decided.Plan, Scene, Decided.Choices, Decided.Mattes};
			Result.Report = Options.bJson ? FormatImportJson(Story) : FormatImportTable(Story, Options.Width);
		}
		if (Options.bDryRun)
		{
			break;
		}
		WriteImportedScene(Job.Scene, Scene, Options.bForce);
		Result.Scenes.push_back(Job.Scene);
		if (bFirst)
		{
			WriteConfig(Options, Scene, Result);
		}
	}
	return Result;
}

} // namespace Drydock
