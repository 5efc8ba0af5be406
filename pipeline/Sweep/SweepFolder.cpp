// Writes and reads the files of a sweep's folder.
#include "Sweep/SweepFolder.h"

#include "RangeTools.h"
#include "Sweep/SweepErrors.h"
#include "Text/FileList.h"
#include "Text/JsonWriter.h"
#include "Text/OutputErrors.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

void WriteSet(FJsonWriter& Writer, const char* Key, const FSweepSet& Set)
{
	Writer.Object(Key, Set, [&](const auto& One) { Writer.Member(One.first, One.second); });
}

FSweepSet ReadSet(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* const Value = Object.Find(Key);
	return ToVector<FSweepSet::value_type>(Value != nullptr ? Value->Members : std::vector<FJsonMember>(),
		[](const FJsonMember& One) { return std::pair(One.Key, One.Value.String); });
}

bool ReadFlag(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* const Value = Object.Find(Key);
	return Value != nullptr && Value->Bool;
}

std::vector<std::string> ReadStrings(const FJsonValue& Object, const char* Key)
{
	return ToVector<std::string>(Object.GetElements(Key), &FJsonValue::String);
}

std::string MakePlanJson(const FSweepPlan& Plan)
{
	FJsonWriter Writer('{');
	Writer.Members({{"version", GetVersion()}, {"config", Plan.Config}, {"task", Plan.Kind}, {"pass", Plan.Pass},
		{"exr", Plan.bExr}, {"measureEffects", Plan.bMeasure}, {"tasks", uint64_t(Plan.Tasks.size())},
		{"secondsPerFrame", Plan.SecondsPerFrame}, {"bytesPerFrame", Plan.BytesPerFrame}});
	Writer.Objects("axes", Plan.Axes,
		[&](const FSweepAxis& Axis) {
			Writer.Members({{"name", Axis.Name}, {"values", Axis.Values}});
		});
	WriteSet(Writer, "against", Plan.Against);
	Writer.Key("inputs").BeginObject();
	for (const auto& [Key, Inputs] : Plan.Inputs)
	{
		WriteSet(Writer, Key.c_str(), {Inputs.begin(), Inputs.end()});
	}
	Writer.EndObject();
	return Writer.GetText();
}

FSweepPlan ReadPlanJson(const FJsonValue& Root)
{
	FSweepPlan Plan;
	Plan.Config = Root.GetString("config");
	Plan.Kind = Root.GetString("task");
	Plan.Pass = Root.GetString("pass");
	Plan.bExr = ReadFlag(Root, "exr");
	Plan.bMeasure = ReadFlag(Root, "measureEffects");
	Plan.SecondsPerFrame = Root.GetNumber("secondsPerFrame", 0.0);
	Plan.BytesPerFrame = static_cast<uint64_t>(Root.GetNumber("bytesPerFrame", 0.0));
	Plan.Against = ReadSet(Root, "against");
	for (const FJsonValue& Axis : Root.GetElements("axes"))
	{
		Plan.Axes.push_back({Axis.GetString("name"), ReadStrings(Axis, "values")});
	}
	const FJsonValue* const Inputs = Root.Find("inputs");
	for (const FJsonMember& One : Inputs != nullptr ? Inputs->Members : std::vector<FJsonMember>())
	{
		const FSweepSet Set = ReadSet(*Inputs, One.Key.c_str());
		Plan.Inputs[One.Key] = FRunInputs(Set.begin(), Set.end());
	}
	return Plan;
}

std::string MakeTaskLine(const FSweepTask& Task)
{
	FJsonWriter Writer;
	Writer.BeginObject(true);
	Writer.Members({{"hash", Task.Hash}, {"values", Task.Values}});
	WriteSet(Writer, "set", Task.Set);
	Writer.MemberIfAny("frames", Task.Frames);
	Writer.MemberIfAny("lead", Task.LeadFrames);
	Writer.MemberIfAny("unsplit", Task.bUnsplit);
	return Writer.GetText();
}

/** The parent of results or times: a folder with thousands of entries is slow to search. */
Files::path GetPart(const Files::path& Folder, const FSweepTask& Task)
{
	return Folder / Task.Hash.substr(0, 2);
}

/** Whether the folder of a task has a lock, and whether a process holds it. */
std::pair<bool, bool> FindLock(const Files::path& Folder)
{
	const int File = open((Folder / ".drydock.lock").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
	const bool bHeld = File >= 0 && flock(File, LOCK_SH | LOCK_NB) != 0;
	if (File >= 0)
	{
		close(File);
	}
	return {File >= 0, bHeld};
}

} // namespace

void FSweepFolder::WritePlan(const FSweepPlan& Plan) const
{
	const FOutputNames Names = {
		.Name = "plan", .Files = {"plan.json", "tasks.jsonl"}, .Last = "plan.json", .Folders = {}, .Unsteady = {}};
	FOutputFolder Output(Path, Names);
	WriteWholeFile(Output.GetAside() / "tasks.jsonl", JoinText(Plan.Tasks, "", MakeTaskLine));
	WriteWholeFile(Output.GetAside() / "plan.json", MakePlanJson(Plan));
	Output.PutInPlace();
}

FSweepPlan FSweepFolder::ReadPlan() const
{
	const std::string File = (Path / "plan.json").string();
	const std::optional<std::string> Text = TryReadTextFile(File);
	const std::optional<FJsonValue> Root = ParseSweepJson(Text.value_or(""));
	FSweepPlan Plan = Root ? ReadPlanJson(*Root) : FSweepPlan();
	for (const std::string& Line : SplitText(TryReadTextFile(Path / "tasks.jsonl", MaxBinaryBytes).value_or("")))
	{
		if (const std::optional<FJsonValue> Task = ParseSweepJson(Line))
		{
			Plan.Tasks.push_back({Task->GetString("hash"), ReadStrings(*Task, "values"), ReadSet(*Task, "set"),
				Task->GetString("frames"), Task->GetString("lead"), ReadFlag(*Task, "unsplit")});
		}
	}
	if (!Root || Plan.Tasks.empty() || double(Plan.Tasks.size()) != Root->GetNumber("tasks", 0.0))
	{
		throw FError({.Code = ErrorSweepNoPlan,
						 .Message = std::string(Text ? "the plan is damaged" : "there is no plan here") +
									": `drydock sweep plan CONFIG --out DIR` makes it, and keeps results",
						 .File = File},
			ExitUsage);
	}
	return Plan;
}

Files::path FSweepFolder::GetResult(const FSweepTask& Task) const
{
	return GetPart(Path / "results", Task) / Task.Hash;
}

Files::path FSweepFolder::GetTime(const FSweepTask& Task) const
{
	return GetPart(Path / "times", Task) / (Task.Hash + ".json");
}

bool FSweepFolder::HasResult(const FSweepTask& Task) const
{
	std::error_code Ignored;
	return Files::exists(GetResult(Task) / SweepResultListName, Ignored);
}

bool FSweepFolder::HasGoodResult(const FSweepTask& Task) const
{
	const FFileList Written = FFileList::Read(GetResult(Task) / SweepResultListName);
	return !Written.IsEmpty() && std::ranges::all_of(Written.GetNames(), [&](const std::string& Name)
									 { return Written.FindFault(GetResult(Task), Name).empty(); });
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

void FSweepFolder::WriteTime(const FSweepTask& Task, double Seconds, const std::string& StudyTiming) const
{
	FJsonWriter Writer('{');
	Writer.Member("seconds", Seconds);
	Writer.RawMember("study", StudyTiming);
	WriteTextFile(GetTime(Task), Writer.GetText());
}

std::optional<double> FSweepFolder::ReadSeconds(const FSweepTask& Task) const
{
	const std::optional<FJsonValue> Root = ParseSweepJson(TryReadTextFile(GetTime(Task)).value_or(""));
	return Root ? std::optional(Root->GetNumber("seconds", 0.0)) : std::nullopt;
}

void FSweepFolder::WriteFailure(const FSweepTask& Task, const std::vector<FDiagnostic>& Messages) const
{
	FJsonWriter Writer('{');
	Writer.Member("messages", ToVector<std::string>(Messages, &FDiagnostic::ToString));
	WriteTextFile(Path / "failed" / (Task.Hash + ".json"), Writer.GetText());
}

std::optional<std::string> FSweepFolder::ReadFailure(const FSweepTask& Task) const
{
	const std::optional<std::string> Text = TryReadTextFile(Path / "failed" / (Task.Hash + ".json"));
	const std::optional<FJsonValue> Root = ParseSweepJson(Text.value_or(""));
	return Root ? std::optional(JoinText(ReadStrings(*Root, "messages"), "\n")) : std::nullopt;
}

void FSweepFolder::RemoveFailure(const FSweepTask& Task) const
{
	std::error_code Ignored;
	Files::remove(Path / "failed" / (Task.Hash + ".json"), Ignored);
}

std::unique_ptr<FFolderLock> FSweepFolder::TryLock(const FSweepTask& Task) const
{
	std::error_code Ignored;
	Files::create_directories(Path / "running", Ignored); // which no lock takes away, as it would if it had made it
	try
	{
		return std::make_unique<FFolderLock>(GetRunning(Task));
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

bool FSweepFolder::IsRunning(const FSweepTask& Task) const
{
	return FindLock(GetRunning(Task)).second;
}

bool FSweepFolder::WasAbandoned(const FSweepTask& Task) const
{
	return FindLock(GetRunning(Task)) == std::pair(true, false);
}

size_t FSweepFolder::CountDone(const FSweepPlan& Plan) const
{
	return size_t(std::ranges::count_if(Plan.Tasks, [this](const FSweepTask& Task) { return HasResult(Task); }));
}

FSweepStatus FSweepFolder::FindStatus(const FSweepPlan& Plan) const
{
	constexpr size_t MostTimes = 200; // enough for a mean
	FSweepStatus Status;
	Status.NumTasks = Plan.Tasks.size();
	double Seconds = 0.0;
	size_t NumTimes = 0;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		if (HasResult(Task))
		{
			++Status.NumDone;
			const std::optional<double> Time = NumTimes < MostTimes ? ReadSeconds(Task) : std::nullopt;
			Seconds += Time.value_or(0.0);
			NumTimes += Time ? 1 : 0;
		}
		else if (IsRunning(Task))
		{
			++Status.NumRunning;
		}
		else if (const std::optional<std::string> Failure = ReadFailure(Task))
		{
			++Status.NumFailed;
			Status.Failures.push_back(Task.Hash.substr(0, 12) + " " + DescribeTask(Plan, Task) + ": " +
									  Failure->substr(0, Failure->find('\n')));
		}
		else
		{
			++Status.NumMissing;
		}
	}
	Status.SecondsPerTask = NumTimes > 0 ? Seconds / double(NumTimes) : Plan.GetSeconds() / double(Status.NumTasks);
	if (Status.NumRunning > 0)
	{
		Status.SecondsLeft =
			Status.SecondsPerTask * double(Status.NumRunning + Status.NumMissing) / double(Status.NumRunning);
	}
	return Status;
}

} // namespace Drydock
