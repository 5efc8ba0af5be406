// Writes a run's pictures and reports aside and moves them into place.
#include "Run/RunOutputs.h"

#include "Picture/ExrWriter.h"
#include "Picture/Preview.h"
#include "Picture/TextureImage.h"
#include "RenderGraphDump.h"
#include "Run/RunDump.h"
#include "Run/RunJson.h"
#include "Text/AsideFile.h"
#include "Text/TextFile.h"
#include "TileExecutor.h"

#include <chrono>
#include <filesystem>
#include <functional>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Milliseconds are in them. */
const std::set<std::string> TimedFiles = {"timing.json", "trace.json", "report.html"};

void MakeFolder(const Files::path& Folder)
{
	std::error_code Error;
	Files::create_directory(Folder, Error);
	if (Error)
	{
		throw MakeWriteError(Folder.string(), Error.message());
	}
}

using FJobs = std::vector<std::function<void()>>;

/** Attributes by which other programs know the meaning of a picture's numbers. Encoding: as GetEncodingName has it. */
std::map<std::string, std::string> MakeColorAttributes(const std::string& Encoding)
{
	const bool bWide = Encoding.find("2020") != std::string::npos;
	return {{ChromaticitiesName, bWide ? "Rec.2020" : "Rec.709"}, {"drydock:encoding", Encoding}};
}

void AddPictures(const FRunResult& Result, const Files::path& Folder, EOutputKind Kind, FJobs& Jobs)
{
	if (Kind == EOutputKind::Png)
	{
		Jobs.push_back([&Result, File = (Folder / "final.png").string()]
			{ WriteDisplayPng(File, Result.Final, Result.OutputDevice); });
		for (const auto& [Id, Figures] : Result.Figures)
		{
			for (const FEffectPicture& Picture : Figures.Pictures)
			{
				Jobs.push_back([&Picture, File = (Folder / (Picture.File + ".png")).string()]
					{ Picture.bLinear ? WritePreviewPng(File, Picture.Image) : WritePng(File, Picture.Image); });
			}
		}
		return;
	}
	Jobs.push_back(
		[&Result, File = (Folder / "scene_linear.exr").string()] {
			WriteExr(
				File, Result.SceneLinear, GetChannelNames(4), MakeColorAttributes("linear Rec.709, scene-referred"));
		});
	Jobs.push_back([&Result, File = (Folder / "final.exr").string()] { WriteFinalExr(Result, File); });
}

void AddDumps(const FRunResult& Result, const Files::path& Folder, EOutputKind Kind, FJobs& Jobs)
{
	for (const FRunDump& Dump : Result.Dumps)
	{
		Jobs.push_back(
			[&Dump, Kind, Name = (Folder / GetDumpFileName(Dump)).string()]
			{
				const FPicture Part = Dump.Image.Crop(Dump.Window);
				if (Kind == EOutputKind::Png)
				{
					WritePreviewPng(Name + ".png", Part);
					return;
				}
				WriteExr(Name + ".exr", Part, Dump.Channels, {},
					{Dump.Window.Min.X, Dump.Window.Min.Y, Dump.Image.Width, Dump.Image.Height});
			});
	}
}

/** All but timing.json. The slowest file goes first, in parallel with the rest. */
void WriteFiles(const FRunResult& Result, const Files::path& Folder)
{
	FJobs Jobs;
	for (const EOutputKind Kind : {EOutputKind::Exr, EOutputKind::Png})
	{
		if (Result.Write.count(Kind) == 0)
		{
			continue;
		}
		AddPictures(Result, Folder, Kind, Jobs);
		if (!Result.Dumps.empty())
		{
			MakeFolder(Folder / "passes");
		}
		AddDumps(Result, Folder / "passes", Kind, Jobs);
	}
	if (Result.Write.count(EOutputKind::Dot) > 0)
	{
		Jobs.push_back([&] { WriteWholeFile(Folder / "graph.dot", DumpDot(Result.Graph)); });
	}
	if (Result.Write.count(EOutputKind::Json) > 0)
	{
		Jobs.push_back([&] { WriteWholeFile(Folder / "trace.json", MakeTraceJson(Result)); });
	}
	ForEachTile(FKernelTile{0, 0, 0, static_cast<int32>(Jobs.size()), 1, 1}, FIntPoint(1, 1),
		[&](const FKernelTile& Tile) { Jobs[static_cast<size_t>(Tile.MinX)](); });
	WriteWholeFile(Folder / "run.json", Result.RunJson);
}

/** Fills the folder, which becomes Target; further files are by name. Returns the milliseconds it took. */
double FillFolder(const FRunResult& Result, const Files::path& Folder, const Files::path& Target,
	const std::map<std::string, std::string>& Further = {})
{
	const auto Begin = std::chrono::steady_clock::now();
	WriteFiles(Result, Folder);
	for (const auto& [Name, Contents] : Further)
	{
		WriteWholeFile((Folder / Name).string(), Contents);
	}
	const double SaveMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
	if (Result.Write.count(EOutputKind::Json) > 0)
	{
		const Files::path Config = Files::absolute(Result.Config.File).lexically_normal();
		const Files::path From = (Files::absolute(Target) / "").lexically_normal();
		WriteWholeFile((Folder / "timing.json").string(),
			MakeTimingJson(Result, SaveMs, Config.lexically_relative(From).generic_string()));
	}
	return SaveMs;
}

} // namespace

const FOutputNames& GetRunOutputNames()
{
	static const FOutputNames Names = {.Name = "run",
		.Files = {"final.png", "final.exr", "scene_linear.exr", "run.json", "timing.json", "graph.dot", "trace.json",
			"report.html"},
		.Last = "run.json",
		.Folders = {"passes", "inspect"},
		.Unsteady = TimedFiles};
	return Names;
}

void WriteFinalExr(const FRunResult& Result, const std::string& File)
{
	WriteExr(File, Result.Final.Take(3), GetChannelNames(3), MakeColorAttributes(GetEncodingName(Result.OutputDevice)));
}

double WriteRunOutputs(const FRunResult& Result, FOutputFolder& Folder, const FFurtherOutputs& Further)
{
	const double SaveMs = FillFolder(Result, Folder.GetAside(), Folder.GetPath());
	if (Further)
	{
		Further(Folder.GetAside(), SaveMs);
	}
	Folder.PutInPlace();
	return SaveMs;
}

double WriteRunOutputs(const FRunResult& Result, const std::string& Folder)
{
	FOutputFolder Output(Folder, GetRunOutputNames());
	return WriteRunOutputs(Result, Output);
}

double WriteNewRunFolder(
	const FRunResult& Result, const std::string& Folder, const std::map<std::string, std::string>& Further)
{
	const Files::path Target = Files::path(Folder).lexically_normal();
	if (Files::exists(Target))
	{
		throw MakeWriteError(Target, "it already exists");
	}
	FAsideFile Aside(Target);
	MakeFolder(Aside.GetPath());
	const double SaveMs = FillFolder(Result, Aside.GetPath(), Target, Further);
	WriteWholeFile(
		(Aside.GetPath() / RunFolderListName).string(), FFileList::Make(Aside.GetPath(), TimedFiles).GetText());
	Aside.PutInPlace();
	return SaveMs;
}

} // namespace Drydock
