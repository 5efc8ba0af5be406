// Writes and reads the files of a sweep's folder.
#include "Sweep/SweepFolder.h"

#include "RangeTools.h"
#include "Sweep/SweepErrors.h"
#include "Text/AsideFile.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/OutputErrors.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const FOutputNames& GetPlanOutputNames()
{
	static const FOutputNames Names = {
		.Name = "plan", .Files = {"plan.json", "tasks.jsonl"}, .Last = "plan.json", .Folders = {}, .Unsteady = {}};
	return Names;
}

using FPairs = std::vector<std::pair<std::string, std::string>>;

void WritePairs(FJsonWriter& Writer, const char* Key, const FPairs& Pairs)
{
	Writer.Object(Key, Pairs, [&](const auto& One) { Writer.Member(One.first, One.second); });
}

FPairs ReadPairs(const FJsonValue& Object, const char* Key)
{
	FPairs Pairs;
	if (const FJsonValue* const Value = Object.Find(Key))
	{
		for (const auto& [Name, Text] : Value->Members)
		{
			Pairs.push_back({Name, Text.String});
		}
	}
	return Pairs;
}

std::vector<std::string> ReadStrings(const FJsonValue& Object, const char* Key)
{
	return ToVector<std::string>(Object.GetElements(Key), &FJsonValue::String);
}

bool ReadFlag(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* const Value = Object.Find(Key);
	return Value != nullptr && Value->Bool;
}

std::string MakePlanJson(const FSweepPlan& Plan)
{
	FJsonWriter Writer('{');
	Writer.Members({{"version", GetVersion()}, {"config", Plan.Config},
		{"task", GetSweepTaskNames()[static_cast<size_t>(Plan.Task)]}, {"pass", Plan.Pass}, {"exr", Plan.bExr},
		{"measureEffects", Plan.bMeasure}, {"tasks", static_cast<uint64_t>(Plan.Tasks.size())},
		{"secondsPerFrame", Plan.Cost.Seconds}, {"bytesPerFrame", Plan.Cost.Bytes}});
	Writer.Objects("axes", Plan.Axes,
		[&](const FSweepAxis& Axis) { Writer.Members({{"name", Axis.Name}, {"values", Axis.Values}}); });
	WritePairs(Writer, "against", Plan.Against);
	Writer.Array("inputs", Plan.Inputs,
		[&](const auto& Of)
		{
			Writer.BeginObject();
			Writer.Member("of", Of.first);
			WritePairs(Writer, "inputs", {Of.second.begin(), Of.second.end()});
			Writer.EndObject();
		});
	return Writer.GetText();
}

FSweepPlan ReadPlanJson(const FJsonValue& Root)
{
	FSweepPlan Plan;
	Plan.Config = Root.GetString("config");
	Plan.Pass = Root.GetString("pass");
	const auto& Names = GetSweepTaskNames();
	Plan.Task = static_cast<ESweepTask>(std::ranges::find(Names, Root.GetString("task")) - Names.begin());
	Plan.bExr = ReadFlag(Root, "exr");
	Plan.bMeasure = ReadFlag(Root, "measureEffects");
	Plan.Cost.Seconds = Root.GetNumber("secondsPerFrame", 0.0);
	Plan.Cost.Bytes = static_cast<uint64_t>(Root.GetNumber("bytesPerFrame", 0.0));
	for (const FJsonValue& Axis : Root.GetElements("axes"))
	{
		Plan.Axes.push_back({Axis.GetString("name"), ReadStrings(Axis, "values")});
	}
	Plan.Against = ReadPairs(Root, "against");
	for (const FJsonValue& Of : Root.GetElements("inputs"))
	{
		const FPairs Pairs = ReadPairs(Of, "inputs");
		Plan.Inputs[Of.GetString("of")] = FRunInputs(Pairs.begin(), Pairs.end());
	}
	return Plan;
}

/** Nothing where the text is not JSON. */
std::optional<FJsonValue> ParseOwn(const std::string& Text)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(Text, "", Ignored, bSyntaxError);
	return bSyntaxError || Root.Type != EJsonType::Object ? std::nullopt : std::optional(std::move(Root));
}

Files::path GetInFolders(const Files::path& Folder, const FSweepTask& Task)
{
	return Folder / Task.Hash.substr(0, 2) / Task.Hash; // a folder with thousands of entries is slow to search
}

/** Whether a process holds the lock in the folder of a task. */
bool IsLocked(const Files::path& Folder)
{
	const int File = open((Folder / ".drydock.lock").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
	if (File < 0)
	{
		return false;
	}
	const bool bLocked = flock(File, LOCK_SH | LOCK_NB) != 0;
	close(File);
	return bLocked;
}

} // namespace

std::string MakeTaskLine(const FSweepTask& Task)
{
	FJsonWriter Writer;
	Writer.BeginObject(true);
	Writer.Members({{"hash", Task.Hash}, {"values", Task.Values}});
	WritePairs(Writer, "set", Task.Set);
	Writer.MemberIfAny("frames", Task.Frames);
	Writer.MemberIfAny("lead", Task.LeadFrames);
	Writer.MemberIfAny("unsplit", Task.bUnsplit);
	return Writer.GetText();
}

FSweepFolder::FSweepFolder(Files::path InPath)
	: Path(std::move(InPath))
{
}

void FSweepFolder::WritePlan(const FSweepPlan& Plan) const
{
	FOutputFolder Output(Path, GetPlanOutputNames());
	std::string Lines;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		Lines += MakeTaskLine(Task);
	}
	WriteWholeFile((Output.GetAside() / "tasks.jsonl").string(), Lines);
	WriteWholeFile((Output.GetAside() / "plan.json").string(), MakePlanJson(Plan));
	Output.PutInPlace();
}

FSweepPlan FSweepFolder::ReadPlan() const
{
	const auto Fail = [&](const std::string& Why)
	{
		return FError({.Code = ErrorSweepNoPlan, .Message = Why, .File = (Path / "plan.json").string()}, ExitUsage);
	};
	const std::optional<std::string> Text = TryReadTextFile((Path / "plan.json").string());
	if (!Text)
	{
		throw Fail("there is no plan here: `drydock sweep plan CONFIG --out DIR` makes one");
	}
	const std::optional<FJsonValue> Root = ParseOwn(*Text);
	FSweepPlan Plan = Root ? ReadPlanJson(*Root) : FSweepPlan();
	const std::string Lines = TryReadTextFile((Path / "tasks.jsonl").string(), MaxBinaryBytes).value_or("");
	for (const std::string& Line : SplitText(Lines))
	{
		const std::optional<FJsonValue> Task = ParseOwn(Line);
		if (!Task)
		{
			break;
		}
		Plan.Tasks.push_back({Task->GetString("hash"), ReadStrings(*Task, "values"), ReadPairs(*Task, "set"),
			Task->GetString("frames"), Task->GetString("lead"), ReadFlag(*Task, "unsplit")});
	}
	if (!Root || static_cast<double>(Plan.Tasks.size()) != Root->GetNumber("tasks", -1.0) ||
		static_cast<size_t>(Plan.Task) >= GetSweepTaskNames().size())
	{
		throw Fail("the plan is damaged, or of another drydock: `drydock sweep plan` makes it again, and keeps results");
	}
	return Plan;
}

Files::path FSweepFolder::GetResult(const FSweepTask& Task) const
{
	return GetInFolders(Path / "results", Task);
}

bool FSweepFolder::HasResult(const FSweepTask& Task) const
{
	std::error_code Ignored;
	return Files::exists(GetResult(Task) / SweepResultListName, Ignored);
}

std::string FSweepFolder::FindFault(const FSweepTask& Task) const
{
	const Files::path Folder = GetResult(Task);
	const FFileList Written = FFileList::Read(Folder / SweepResultListName);
	for (const std::string& Name : Written.GetNames())
	{
		const std::string Fault = Written.FindFault(Folder, Name);
		if (!Fault.empty())
		{
			return Name + " " + Fault;
		}
	}
	return Written.IsEmpty() ? "it has no files" : "";
}

void FSweepFolder::RemoveResult(const FSweepTask& Task) const
{
	const Files::path Folder = GetResult(Task);
	const FFileList Written = FFileList::Read(Folder / SweepResultListName);
	const std::string Foreign = Written.FindForeign(Folder, "", {SweepResultListName});
	if (!Foreign.empty())
	{
		throw MakeForeignError(Folder / Foreign, "drydock did not write this");
	}
	RemoveFiles(Folder, Written.GetNames());
	RemoveFiles(Folder, {SweepResultListName}); // last: without it, what is left would be nobody's
	RemoveFiles(Folder.parent_path(), {Task.Hash});
}

void FSweepFolder::WriteTime(const FSweepTask& Task, const FSweepTime& Time) const
{
	FJsonWriter Writer('{');
	Writer.Members({{"seconds", Time.Seconds}, {"threads", Time.Threads}, {"host", Time.Host}});
	Writer.RawMember("study", Time.More);
	WriteTextFile(GetInFolders(Path / "times", Task).string() + ".json", Writer.GetText());
}

std::optional<FSweepTime> FSweepFolder::ReadTime(const FSweepTask& Task) const
{
	const std::optional<FJsonValue> Root =
		ParseOwn(TryReadTextFile(GetInFolders(Path / "times", Task).string() + ".json").value_or(""));
	return Root ? std::optional(FSweepTime{Root->GetNumber("seconds", 0.0),
					  static_cast<int>(Root->GetNumber("threads", 0.0)), Root->GetString("host")})
				: std::nullopt;
}

void FSweepFolder::WriteFailure(const FSweepTask& Task, const std::vector<FDiagnostic>& Messages) const
{
	FJsonWriter Writer('{');
	Writer.Objects("messages", Messages,
		[&](const FDiagnostic& One)
		{
			Writer.Members({{"severity", static_cast<int>(One.Severity)}, {"code", One.Code}, {"message", One.Message},
				{"file", One.File}, {"line", One.Line}, {"column", One.Column}, {"where", One.Where}});
		});
	WriteTextFile((Path / "failed" / (Task.Hash + ".json")).string(), Writer.GetText());
}

std::optional<std::vector<FDiagnostic>> FSweepFolder::ReadFailure(const FSweepTask& Task) const
{
	const std::optional<FJsonValue> Root =
		ParseOwn(TryReadTextFile((Path / "failed" / (Task.Hash + ".json")).string()).value_or(""));
	if (!Root)
	{
		return std::nullopt;
	}
	return ToVector<FDiagnostic>(Root->GetElements("messages"),
		[](const FJsonValue& One)
		{
			return FDiagnostic{static_cast<ESeverity>(One.GetNumber("severity", 0.0)),
				static_cast<int>(One.GetNumber("code", 0.0)), One.GetString("message"), One.GetString("file"),
				static_cast<int>(One.GetNumber("line", 0.0)), static_cast<int>(One.GetNumber("column", 0.0)),
				One.GetString("where")};
		});
}

void FSweepFolder::RemoveFailure(const FSweepTask& Task) const
{
	std::error_code Ignored;
	Files::remove(Path / "failed" / (Task.Hash + ".json"), Ignored);
}

std::unique_ptr<FFolderLock> FSweepFolder::TryLock(const FSweepTask& Task) const
{
	try
	{
		return std::make_unique<FFolderLock>(Path / "running" / Task.Hash);
	}
	catch (const FError& Error)
	{
		if (Error.GetDiagnostics()[0].Code == ErrorFolderInUse)
		{
			return nullptr;
		}
		throw;
	}
}

std::vector<std::string> FSweepFolder::FindRunning() const
{
	std::vector<std::string> Hashes;
	std::error_code Ignored;
	for (const Files::directory_entry& Entry : Files::directory_iterator(Path / "running", Ignored))
	{
		if (IsLocked(Entry.path()))
		{
			Hashes.push_back(Entry.path().filename().string());
		}
	}
	return Hashes;
}

bool FSweepFolder::WasAbandoned(const FSweepTask& Task) const
{
	std::error_code Ignored;
	const Files::path Folder = Path / "running" / Task.Hash;
	return Files::exists(Folder / ".drydock.lock", Ignored) && !IsLocked(Folder);
}

} // namespace Drydock
