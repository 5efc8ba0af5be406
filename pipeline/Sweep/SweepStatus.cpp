// Counts results, locks and failures.
#include "Sweep/SweepStatus.h"

#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace Drydock
{

namespace
{

/** Tasks whose times are read: enough for a mean. */
constexpr size_t MostTimes = 200;

std::string DescribeShare(size_t Count, size_t Total)
{
	return fmt::format("{:.1f} %", 100.0 * static_cast<double>(Count) / static_cast<double>(std::max<size_t>(1, Total)));
}

} // namespace

std::string DescribeDuration(double Seconds)
{
	const long Whole = std::lround(std::min(std::max(Seconds, 0.0), 1e12));
	return Whole >= 172'800 ? fmt::format("{} d {} h", Whole / 86'400, Whole % 86'400 / 3600)
		   : Whole >= 3600  ? fmt::format("{} h {} min", Whole / 3600, Whole % 3600 / 60)
		   : Whole >= 60    ? fmt::format("{} min {} s", Whole / 60, Whole % 60)
		   : Whole >= 10    ? fmt::format("{} s", Whole)
							: fmt::format("{:.1f} s", Seconds);
}

std::string DescribeBytes(double Bytes)
{
	return Bytes >= 1e12   ? fmt::format("{:.1f} TB", Bytes / 1e12)
		   : Bytes >= 1e9 ? fmt::format("{:.1f} GB", Bytes / 1e9)
		   : Bytes >= 1e6 ? fmt::format("{:.1f} MB", Bytes / 1e6)
						  : fmt::format("{:.0f} kB", std::ceil(Bytes / 1e3));
}

size_t CountDone(const FSweepFolder& Folder, const FSweepPlan& Plan)
{
	return static_cast<size_t>(
		std::ranges::count_if(Plan.Tasks, [&](const FSweepTask& Task) { return Folder.HasResult(Task); }));
}

FSweepStatus FindSweepStatus(const FSweepFolder& Folder, const FSweepPlan& Plan)
{
	FSweepStatus Status;
	Status.NumTasks = Plan.Tasks.size();
	const std::vector<std::string> Running = Folder.FindRunning();
	const std::set<std::string> IsRunning(Running.begin(), Running.end());
	double Seconds = 0.0;
	size_t NumTimes = 0;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		const std::string Name = Task.Hash.substr(0, 12) + "  " + DescribeTask(Plan, Task);
		if (Folder.HasResult(Task))
		{
			++Status.NumDone;
			const std::optional<FSweepTime> Time = NumTimes < MostTimes ? Folder.ReadTime(Task) : std::nullopt;
			Seconds += Time ? Time->Seconds : 0.0;
			NumTimes += Time ? 1 : 0;
		}
		else if (IsRunning.count(Task.Hash) > 0)
		{
			++Status.NumRunning;
			Status.Unfinished.push_back(Name);
		}
		else if (const std::optional<std::vector<FDiagnostic>> Messages = Folder.ReadFailure(Task))
		{
			++Status.NumFailed;
			Status.Failures.push_back(Name + ": " + (Messages->empty() ? "" : Messages->front().ToString()));
		}
		else
		{
			++Status.NumMissing;
			Status.Unfinished.push_back(Name);
		}
	}
	Status.SecondsPerTask = NumTimes > 0 ? Seconds / static_cast<double>(NumTimes)
										 : Plan.GetSeconds() / static_cast<double>(std::max<size_t>(1, Status.NumTasks));
	if (Status.NumRunning > 0)
	{
		Status.SecondsLeft = Status.SecondsPerTask * static_cast<double>(Status.Unfinished.size()) /
							 static_cast<double>(Status.NumRunning);
	}
	return Status;
}

std::string MakeStatusText(const FSweepStatus& Status, int Width, bool bBar)
{
	constexpr size_t BarWidth = 40, MostFailures = 20;
	std::string Text;
	if (bBar)
	{
		const size_t Filled = Status.NumDone * BarWidth / std::max<size_t>(1, Status.NumTasks);
		Text = "[" + std::string(Filled, '#') + std::string(BarWidth - Filled, '.') + "]\n";
	}
	FTextTable Table{{{ETextColumn::Name}, {ETextColumn::Number}, {ETextColumn::Number}}, {{"", "tasks", ""}}};
	for (const auto& [Name, Count] : {std::pair("done", Status.NumDone), {"running", Status.NumRunning},
			 {"failed", Status.NumFailed}, {"missing", Status.NumMissing}, {"all", Status.NumTasks}})
	{
		Table.Rows.push_back({Name, std::to_string(Count), DescribeShare(Count, Status.NumTasks)});
	}
	Text += Table.Format(Width);
	Text += "a task takes " + DescribeDuration(Status.SecondsPerTask) +
			(Status.SecondsLeft        ? ", " + DescribeDuration(*Status.SecondsLeft) + " left"
			 : Status.Unfinished.empty() ? ""
										: "; none runs now") +
			"\n";
	for (size_t Index = 0; Index < std::min(Status.Failures.size(), MostFailures); ++Index)
	{
		Text += "failed " + Status.Failures[Index] + "\n";
	}
	return Status.Failures.size() > MostFailures
			   ? Text + fmt::format("and {} more\n", Status.Failures.size() - MostFailures)
			   : Text;
}

std::string MakeStatusJson(const FSweepStatus& Status)
{
	FJsonWriter Writer('{');
	const auto Count = [](size_t Number)
	{
		return static_cast<uint64_t>(Number);
	};
	Writer.Members({{"tasks", Count(Status.NumTasks)}, {"done", Count(Status.NumDone)},
		{"running", Count(Status.NumRunning)}, {"failed", Count(Status.NumFailed)},
		{"missing", Count(Status.NumMissing)}, {"secondsPerTask", Status.SecondsPerTask},
		{"secondsLeft", Status.SecondsLeft}});
	Writer.Key("failures").BeginArray();
	std::ranges::for_each(Status.Failures, [&](const std::string& Failure) { Writer.Value(Failure); });
	Writer.EndArray();
	return Writer.GetText();
}

} // namespace Drydock
