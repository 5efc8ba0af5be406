// Builds side by side, runs one after the other, and compares each version with the one before.
#include "Matrix/Matrix.h"

#include "ChildProcess.h"
#include "Config/ReadConfig.h"
#include "Diagnostics.h"
#include "Matrix/MatrixCompare.h"
#include "Matrix/MatrixErrors.h"
#include "Matrix/MatrixRunReport.h"
#include "Matrix/MatrixTable.h"
#include "Matrix/MatrixVersions.h"
#include "Patch/BuildLog.h"
#include "Patch/PatchTemplate.h"
#include "Patch/EngineApi.h"
#include "Patch/PluginBuild.h"
#include "Patch/PluginBuildErrors.h"
#include "RangeTools.h"
#include "Picture/ContactSheet.h"
#include "Picture/ImageMetrics.h"
#include "Picture/PictureFile.h"
#include "RangeTools.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr int RunSeconds = 1800;

const FOutputNames& GetMatrixOutputNames()
{
	static const FOutputNames Names = {.Name = "matrix",
		.Files = {"matrix.txt", "matrix.json", "matrix.html"},
		.Last = "matrix.json",
		.Folders = {},
		.Unsteady = {"matrix.html"}};
	return Names;
}

[[noreturn]] void Fail(EMatrixError Code, EExitCode ExitCode, const std::string& File, const std::string& Message)
{
	throw FError({.Code = Code, .Message = Message, .File = File}, ExitCode);
}

bool IsOfPlugin(const Files::path& File)
{
	const std::string Name = File.filename().string();
	return Name.ends_with(".uplugin") || Name.ends_with(".Build.cs") || Name.ends_with(".cpp");
}

/** Reports a folder without anything to build before anything is written. */
void RequirePlugin(const std::string& Folder)
{
	std::error_code Error;
	if (!Files::is_directory(Folder, Error))
	{
		Fail(ErrorMatrixFolder, ExitUsage, Folder,
			"is not a folder; expected the folder of a plugin, with its .uplugin");
	}
	for (Files::recursive_directory_iterator Entry(Folder, Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		if (IsOfPlugin(Entry->path()))
		{
			return;
		}
	}
	Fail(ErrorMatrixFolder, ExitUsage, Folder,
		"holds no .uplugin, no .Build.cs and no .cpp file; expected a plugin's folder");
}

void RequireCompiler(const std::string& Compiler)
{
	if (!Compiler.empty() && FindProgram(Compiler).empty())
	{
		Fail(ErrorMatrixCompiler, ExitUsage, "", "there is no compiler " + Compiler);
	}
	const char* const Chosen = std::getenv("CXX");
	for (const std::string& Name :
		{std::string(Chosen != nullptr ? Chosen : ""), std::string("c++"), std::string("g++"), std::string("clang++")})
	{
		if (!Compiler.empty() || !FindProgram(Name).empty())
		{
			return;
		}
	}
	Fail(ErrorMatrixCompiler, ExitUsage, "",
		"there is no C++ compiler in PATH: c++, g++ and clang++ were looked for; --compiler names another");
}

/** Reports a config that cannot be read before minutes of building. */
void RequireConfig(const std::string& Config)
{
	const FConfigDocument Document = LoadConfigDocument(Config);
	if (Document.bSyntaxError)
	{
		throw FError(Document.Diagnostics, ExitUsage);
	}
}

/** Empty rows for all versions. */
FVersionMatrix PlanMatrix(const FMatrixRequest& Request)
{
	FVersionMatrix Matrix;
	Matrix.Name = FindPluginName(Request.Folder);
	Matrix.Folder = Files::absolute(Request.Folder / Files::path(".")).lexically_normal().parent_path().string();
	Matrix.bStockConfig = Request.Config.empty();
	Matrix.Config = Matrix.bStockConfig ? FindStockConfig() : Request.Config;
	Matrix.OutputFolder = Request.OutputFolder.empty() ? "build/" + Matrix.Name + "-matrix" : Request.OutputFolder;
	for (const int Minor : Request.Minors)
	{
		FMatrixRow Row;
		Row.Minor = Minor;
		Row.Build.Log = Matrix.OutputFolder + "/" + DescribeVersion(Minor) + "/build.log";
		Matrix.Rows.push_back(std::move(Row));
	}
	return Matrix;
}

/** A plugin that does not compile is a finding; what else is wrong is thrown. */
void BuildOnce(const FPluginBuild& Build, FMatrixBuild& Made)
{
	try
	{
		const FBuiltPlugin Built = BuildPlugin(Build);
		Made.bBuilt = true;
		Made.Library = Built.Library;
		Made.Notes = Built.Notes;
	}
	catch (const FError& Error)
	{
		const FDiagnostic& First = Error.GetDiagnostics().front();
		if (First.Code != ErrorPluginNotCompiled)
		{
			throw;
		}
		Made.FirstError = FMatrixMessage{.Text = First.Message.substr(0, First.Message.find('\n'))};
	}
}

FMatrixBuild BuildVersion(
	const FMatrixRequest& Request, const FVersionMatrix& Matrix, const FMatrixRow& Row, int NumJobs)
{
	FMatrixBuild Made = Row.Build;
	FPluginBuild Build;
	Build.Folder = Matrix.Folder;
	Build.BuildFolder = Matrix.OutputFolder + "/" + DescribeVersion(Row.Minor);
	Build.EngineMinor = Row.Minor;
	Build.EngineNames = 2;
	Build.Excludes = Request.Excludes;
	Build.Compiler = Request.Compiler;
	Build.NumJobs = NumJobs;
	BuildOnce(Build, Made);
	const std::string Log = RememberBuildSteps(Build.BuildFolder);
	Made.InEngine = FindVersionMessages(Log);
	std::erase_if(Made.Notes, [&Made](const std::string& Note) { return Contains(Made.InEngine, Note); });
	if (!Made.bBuilt && !Made.InEngine.empty())
	{
		// The picture with these names is of interest all the same.
		Build.EngineNames = 1;
		Made.FirstError.reset();
		BuildOnce(Build, Made);
	}
	const std::string Steps = RememberBuildSteps(Build.BuildFolder);
	const auto Convert = [](const FCompilerMessage& Message)
	{
		return FMatrixMessage{.File = Message.File, .Line = Message.Line, .Text = Message.Text};
	};
	const std::vector<FCompilerMessage> Errors = ReadCompilerMessages(Steps, ECompilerMessage::Error, Matrix.Folder);
	if (!Made.bBuilt && !Errors.empty())
	{
		Made.FirstError = Convert(Errors.front());
	}
	Made.Warnings =
		ToVector<FMatrixMessage>(ReadCompilerMessages(Steps, ECompilerMessage::Warning, Matrix.Folder), Convert);
	return Made;
}

/** Counts what is done, from any thread. */
class FMatrixProgress
{
public:
	FMatrixProgress(const FMatrixRequest& InRequest, size_t InTotal)
		: Request(InRequest)
		, Total(static_cast<int>(InTotal))
	{
	}

	void Show(const std::string& What, int NumDone = 0)
	{
		const std::lock_guard Lock(Mutex);
		Done += NumDone;
		if (Request.Progress)
		{
			Request.Progress(Done, Total, What);
		}
	}

private:
	const FMatrixRequest& Request;
	const int Total;
	int Done = 0;
	std::mutex Mutex;
};

/** As many compilers as there are cores, over all versions. */
void BuildAll(const FMatrixRequest& Request, FVersionMatrix& Matrix, FMatrixProgress& Progress)
{
	const size_t NumRows = Matrix.Rows.size();
	const size_t NumCores = std::max(1u, std::thread::hardware_concurrency());
	const size_t NumThreads = std::min(NumRows, NumCores);
	const int NumJobs = static_cast<int>(std::max<size_t>(1, NumCores / std::max<size_t>(1, NumThreads)));
	std::vector<std::exception_ptr> Failures(NumRows);
	std::atomic<size_t> Next = 0;
	const auto Work = [&]
	{
		for (size_t Index; (Index = Next++) < NumRows;)
		{
			FMatrixRow& Row = Matrix.Rows[Index];
			try
			{
				Progress.Show("building for " + DescribeVersion(Row.Minor));
				Row.Build = BuildVersion(Request, Matrix, Row, NumJobs);
			}
			catch (...)
			{
				Failures[Index] = std::current_exception();
				Next = NumRows; // what is wrong for one is wrong for all
			}
			Progress.Show("built for " + DescribeVersion(Row.Minor), 1);
		}
	};
	{
		std::vector<std::jthread> Threads;
		for (size_t Index = 0; Index < NumThreads; ++Index)
		{
			Threads.emplace_back(Work);
		}
	}
	for (const std::exception_ptr& Failure : Failures)
	{
		if (Failure)
		{
			std::rethrow_exception(Failure);
		}
	}
}

std::string GetRunFolder(const FVersionMatrix& Matrix, const FMatrixRow& Row)
{
	return Matrix.OutputFolder + "/" + DescribeVersion(Row.Minor) + "/run";
}

FMatrixRun RunVersion(const std::string& Program, const FVersionMatrix& Matrix, const FMatrixRow& Row)
{
	const FChildResult Child = RunChild(MakeRunArguments(Program, Matrix, Row), RunSeconds);
	if (!Child.bStarted)
	{
		Fail(ErrorMatrixProgram, ExitFiles, Program,
			"cannot be started for engine " + DescribeVersion(Row.Minor) + "; it runs each version by itself");
	}
	constexpr int KillSignal = 9;
	constexpr int FirstSignal = 128;
	const int Signal = Child.bTimedOut ? KillSignal : Child.Signal;
	const int ExitCode = Signal > 0 ? FirstSignal + Signal : Child.ExitCode;
	const std::string Folder = GetRunFolder(Matrix, Row);
	const std::string RunJson = ExitCode == ExitDone ? ReadTextFile(Folder + "/run.json") : "";
	FMatrixRun Run = ReadMatrixRun(ExitCode, Child.Output, RunJson);
	if (Child.bTimedOut)
	{
		Run.FirstError = FMatrixMessage{.Text = Child.Describe(RunSeconds)};
	}
	Run.Folder = Folder;
	return Run;
}

/** Each version that ran beside the one before it that ran. */
void CompareAll(FVersionMatrix& Matrix)
{
	const FMatrixRow* Before = nullptr;
	FImage PictureBefore;
	for (FMatrixRow& Row : Matrix.Rows)
	{
		if (!Row.Succeeded())
		{
			continue;
		}
		FImage Picture = ReadComparedImage(Row.Run->Folder + "/final.exr").Image;
		FMatrixPicture Compared;
		Compared.Fingerprint = FingerprintPicture(Picture);
		if (Before != nullptr)
		{
			Compared.Before = Before->Minor;
			Compared.Difference = ComparePictures(PictureBefore, Picture);
			Row.FirstDifference = FindFirstDifference(Before->Run->Passes, Row.Run->Passes);
		}
		for (const FMatrixRow& Other : Matrix.Rows)
		{
			const bool bOlder = Other.Minor < Row.Minor && Other.Picture;
			if (Compared.Difference && bOlder && Other.Picture->Fingerprint == Compared.Fingerprint)
			{
				Compared.SameAs = Other.Minor;
			}
		}
		Row.Picture = Compared;
		Before = &Row;
		PictureBefore = std::move(Picture);
	}
}

/** The pictures side by side; nothing where there are none. */
void WriteSheet(const FVersionMatrix& Matrix, const std::string& File)
{
	std::vector<FSheetTile> Tiles;
	for (const FMatrixRow& Row : Matrix.Rows)
	{
		if (Row.Picture)
		{
			const bool bSame = Row.Picture->Before && !Row.Picture->Difference;
			const std::string Same = bSame ? " same as " + DescribeVersion(*Row.Picture->Before) : std::string();
			Tiles.push_back({ReadPicture(Row.Run->Folder + "/final.png"), DescribeVersion(Row.Minor) + Same});
		}
	}
	if (!Tiles.empty())
	{
		constexpr int MostColumns = 4;
		FSheetOptions Options;
		Options.Columns = std::min(static_cast<int>(Tiles.size()), MostColumns);
		WritePicture(File, MakeContactSheet(Tiles, Options));
	}
}

} // namespace

std::string FindStockConfig()
{
	const Files::path Config = Files::path(FindTemplates()) / "matrix.json";
	std::error_code Error;
	if (!Files::is_regular_file(Config, Error))
	{
		Fail(ErrorMatrixFrame, ExitFiles, Config.string(),
			"drydock's own frame is missing: is it installed completely? A config behind PLUGIN_DIR does as well");
	}
	return Config.string();
}

std::string FindThisProgram()
{
	std::error_code Error;
	const Files::path Program = Files::read_symlink("/proc/self/exe", Error);
	if (Error)
	{
		Fail(ErrorMatrixProgram, ExitFiles, "/proc/self/exe",
			"drydock cannot find its own program, which it starts for each version: " + Error.message());
	}
	return Program.string();
}

std::vector<std::string> MakeRunArguments(
	const std::string& Program, const FVersionMatrix& Matrix, const FMatrixRow& Row)
{
	return {Program, "run", Matrix.Config, "--engine", DescribeVersion(Row.Minor), "--plugin", Row.Build.Library,
		"--fingerprints", "--out", GetRunFolder(Matrix, Row)};
}

FVersionMatrix RunMatrix(const FMatrixRequest& Request)
{
	RequirePlugin(Request.Folder);
	RequireCompiler(Request.Compiler);
	FVersionMatrix Matrix = PlanMatrix(Request);
	RequireConfig(Matrix.Config);
	const std::string Program = Request.Program.empty() ? FindThisProgram() : Request.Program;
	FOutputFolder Output(Matrix.OutputFolder, GetMatrixOutputNames());
	FMatrixProgress Progress(Request, 2 * Matrix.Rows.size());
	BuildAll(Request, Matrix, Progress);
	for (FMatrixRow& Row : Matrix.Rows)
	{
		if (Row.Build.bBuilt)
		{
			Progress.Show("running under " + DescribeVersion(Row.Minor));
			Row.Run = RunVersion(Program, Matrix, Row);
		}
		Progress.Show("ran under " + DescribeVersion(Row.Minor), 1);
	}
	CompareAll(Matrix);
	WriteWholeFile((Output.GetAside() / "matrix.txt").string(), FormatMatrix(Matrix));
	WriteWholeFile((Output.GetAside() / "matrix.json").string(), MakeMatrixJson(Matrix));
	WriteSheet(Matrix, (Output.GetAside() / "matrix.png").string());
	if (Request.MakePage)
	{
		WriteWholeFile((Output.GetAside() / "matrix.html").string(), Request.MakePage(Matrix));
	}
	Output.PutInPlace();
	return Matrix;
}

} // namespace Drydock
