// Reads results in the order of the plan, and compares their pictures.
#include "Sweep/SweepTable.h"

#include "Picture/ImageMetrics.h"
#include "RangeTools.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepRun.h"
#include "Text/Fmt.inl"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"
#include "Text/TextTable.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Throws where a result is missing or damaged, with the first of them. */
void RequireResults(const FSweepFolder& Folder, const FSweepPlan& Plan)
{
	constexpr size_t MostNamed = 5;
	std::vector<std::string> Missing;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		const bool bThere = Folder.HasResult(Task);
		const std::string Fault = bThere ? Folder.FindFault(Task) : "";
		if (!bThere || !Fault.empty())
		{
			const char* const Why = bThere ? "damaged" : Folder.ReadFailure(Task) ? "failed" : "missing";
			Missing.push_back(Task.Hash.substr(0, 12) + " (" + DescribeTask(Plan, Task) + ") " + Why);
		}
	}
	if (!Missing.empty())
	{
		throw FError({.Code = ErrorSweepMissing,
						 .Message = fmt::format("{} of {} results are not there: {}; `drydock sweep submit` runs them",
							 Missing.size(), Plan.Tasks.size(), ListSome(Missing, MostNamed)),
						 .File = Folder.GetPath().string()},
			ExitPolicy);
	}
}

FSweepRow ReadRow(const FSweepFolder& Folder, const FSweepPlan& Plan, size_t Index)
{
	const FSweepTask& Task = Plan.Tasks[Index];
	const Files::path Path = Folder.GetResult(Task);
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(ReadTextFile((Path / "result.json").string()), "", Ignored, bSyntaxError);
	FSweepRow Row;
	Row.Task = Index;
	if (const FJsonValue* const Figures = Root.Find("figures"))
	{
		for (const auto& [Name, Value] : Figures->Members)
		{
			Row.Figures[Name] = Value.Number;
		}
	}
	for (const FJsonValue& Frame : Root.GetElements("frames"))
	{
		const FJsonValue* const Number = Frame.Find("frame");
		const bool bNumber = Number != nullptr && Number->Type == EJsonType::Number;
		Row.Pictures.push_back({bNumber ? std::optional(static_cast<int>(Number->Number)) : std::nullopt,
			(Path / Frame.GetString("file")).lexically_relative(Folder.GetPath()).generic_string(),
			Frame.GetString("picture")});
	}
	Row.Messages = ToVector<std::string>(Root.GetElements("messages"), &FJsonValue::String);
	const std::optional<FSweepTime> Time = Folder.ReadTime(Task);
	Row.Seconds = Time ? Time->Seconds : 0.0;
	return Row;
}

FImageError ComparePictures(
	const FSweepFolder& Folder, const FSweepPlan& Plan, const FSweepPicture& A, const FSweepPicture& B)
{
	const auto Read = [&](const FSweepPicture& Picture)
	{
		Files::path File = Folder.GetPath() / Picture.File;
		return ReadComparedImage((Plan.bExr ? File.replace_extension("exr") : File).string());
	};
	const FComparedImage Left = Read(A), Right = Read(B);
	if (Left.Image.Width != Right.Image.Width || Left.Image.Height != Right.Image.Height)
	{
		FImageError Other;
		Other.Max = Other.Rms = std::numeric_limits<double>::infinity();
		return Other;
	}
	return CompareImages(Left.Image, Right.Image, {.Encoding = Left.Encoding, .NumChannels = 0, .bPerceived = false});
}

const FSweepPicture* FindPicture(const FSweepRow& Row, std::optional<int> Frame)
{
	return FindItem(Row.Pictures, Frame, &FSweepPicture::Frame);
}

/** The task whose values are those of Task but for what "against" names. */
std::vector<std::string> MakeReferenceValues(const FSweepPlan& Plan, const FSweepTask& Task)
{
	std::vector<std::string> Values = Task.Values;
	for (size_t Axis = 0; Axis < Plan.Axes.size(); ++Axis)
	{
		for (const auto& [Name, Value] : Plan.Against)
		{
			Values[Axis] = Plan.Axes[Axis].Name == Name ? Value : Values[Axis];
		}
	}
	return Values;
}

/** Whether an entry of a list sets what "against" names. */
bool IsReferenceCase(const FSweepPlan& Plan, const FSweepTask& Task)
{
	return std::ranges::all_of(
		Plan.Against, [&](const auto& One) { return GetTaskValue(Task, One.first) == One.second; });
}

void AddErrors(const FSweepFolder& Folder, FSweepTable& Table)
{
	const FSweepPlan& Plan = Table.Plan;
	if (Plan.Against.empty())
	{
		return;
	}
	const bool bList = Plan.Axes[0].Name == "case";
	std::map<std::vector<std::string>, const FSweepRow*> ByValues;
	const FSweepRow* Case = nullptr;
	for (const FSweepRow& Row : Table.Rows)
	{
		ByValues[Plan.Tasks[Row.Task].Values] = &Row;
		Case = Case == nullptr && IsReferenceCase(Plan, Plan.Tasks[Row.Task]) ? &Row : Case;
	}
	for (FSweepRow& Row : Table.Rows)
	{
		std::vector<std::string> Values = MakeReferenceValues(Plan, Plan.Tasks[Row.Task]);
		if (bList && Case != nullptr)
		{
			Values[0] = Plan.Tasks[Case->Task].Values[0];
		}
		const auto Reference = ByValues.find(Values);
		if (Reference == ByValues.end())
		{
			continue; // it was excluded
		}
		double Max = 0.0, Rms = 0.0;
		for (const FSweepPicture& Picture : Row.Pictures)
		{
			const FSweepPicture* const Other = FindPicture(*Reference->second, Picture.Frame);
			if (Other != nullptr && Other->Fingerprint != Picture.Fingerprint)
			{
				const FImageError Error = ComparePictures(Folder, Plan, Picture, *Other);
				Max = std::max(Max, Error.Max);
				Rms = std::max(Rms, Error.Rms);
			}
		}
		Row.Figures["error max"] = Max;
		Row.Figures["error rms"] = Rms;
	}
}

/** Compares pieces with the frames of Whole, the unsplit cut of the same values. */
void ComparePieces(const FSweepFolder& Folder, const FSweepRow& Whole, FSweepTable& Table)
{
	const FSweepPlan& Plan = Table.Plan;
	const auto WithoutPiece = [&](const FSweepTask& Task)
	{
		return std::vector<std::string>(Task.Values.begin(), Task.Values.end() - 1);
	};
	for (const FSweepRow& Row : Table.Rows)
	{
		if (WithoutPiece(Plan.Tasks[Row.Task]) != WithoutPiece(Plan.Tasks[Whole.Task]))
		{
			continue;
		}
		FSweepPiece Piece;
		Piece.Task = Row.Task;
		Piece.NumFrames = Row.Pictures.size();
		for (const FSweepPicture& Picture : Row.Pictures)
		{
			const FSweepPicture* const Other = FindPicture(Whole, Picture.Frame);
			if (Other == nullptr || Other->Fingerprint == Picture.Fingerprint)
			{
				++Piece.NumSame;
				continue;
			}
			const FImageError Error = ComparePictures(Folder, Plan, Picture, *Other);
			Piece.Worst = !Piece.Worst || Error.Rms > Piece.Rms ? Picture.Frame : Piece.Worst;
			Piece.Max = std::max(Piece.Max, Error.Max);
			Piece.Rms = std::max(Piece.Rms, Error.Rms);
		}
		Table.Pieces.push_back(Piece);
	}
}

void NotePieces(FSweepTable& Table)
{
	if (Table.Pieces.empty())
	{
		return;
	}
	size_t NumFrames = 0, NumSame = 0;
	const FSweepPiece* Worst = &Table.Pieces[0];
	for (const FSweepPiece& Piece : Table.Pieces)
	{
		NumFrames += Piece.NumFrames;
		NumSame += Piece.NumSame;
		Worst = Piece.Rms > Worst->Rms ? &Piece : Worst;
	}
	Table.Notes.push_back(NumSame == NumFrames
							  ? fmt::format("All {} frames in pieces are the same bits as in the unsplit cut.", NumFrames)
							  : fmt::format("{} of {} frames in pieces differ from the unsplit cut, by {:.3g} RMS and {:.3g} "
											"at most; the worst is frame {}.",
									NumFrames - NumSame, NumFrames, Worst->Rms,
									std::ranges::max(Table.Pieces, {}, &FSweepPiece::Max).Max, Worst->Worst.value_or(0)));
}

/** All that could show a difference. */
std::string DescribeOutcome(const FSweepRow& Row)
{
	std::string Text;
	for (const FSweepPicture& Picture : Row.Pictures)
	{
		Text += Picture.Fingerprint + " ";
	}
	for (const auto& [Name, Value] : Row.Figures)
	{
		Text += Name.starts_with("error ") ? "" : Name + FormatShortest(Value) + " ";
	}
	return Text;
}

/** Axes over which every outcome is the same where the other axes have the same values. */
void NoteIdleAxes(FSweepTable& Table)
{
	for (size_t Axis = 0; Axis < Table.Plan.Axes.size(); ++Axis)
	{
		const std::string& Name = Table.Plan.Axes[Axis].Name;
		if (Table.Plan.Axes[Axis].Values.size() < 2 || Name == "piece" || Name == "frames" || Name == "scene")
		{
			continue;
		}
		std::map<std::vector<std::string>, std::set<std::string>> Outcomes;
		size_t Most = 0;
		std::map<std::vector<std::string>, size_t> Counts;
		for (const FSweepRow& Row : Table.Rows)
		{
			std::vector<std::string> Others = Table.Plan.Tasks[Row.Task].Values;
			Others[Axis].clear();
			Outcomes[Others].insert(DescribeOutcome(Row));
			Most = std::max(Most, ++Counts[Others]);
		}
		if (Most > 1 && std::ranges::all_of(Outcomes, [](const auto& One) { return One.second.size() == 1; }))
		{
			Table.Notes.push_back("The axis " + Name + " changes nothing: all its pictures and figures are the same.");
		}
	}
}

void ListFigures(FSweepTable& Table)
{
	std::set<std::string> Names;
	for (const FSweepRow& Row : Table.Rows)
	{
		for (const auto& [Name, Value] : Row.Figures)
		{
			Names.insert(Name);
		}
	}
	Table.Figures.assign(Names.begin(), Names.end());
	std::ranges::stable_partition(Table.Figures, [](const std::string& Name) { return Name.starts_with("error "); });
}

std::string FormatFigure(const FSweepRow& Row, const std::string& Name)
{
	const auto Found = Row.Figures.find(Name);
	return Found == Row.Figures.end() ? "" : FormatShortest(Found->second);
}

} // namespace

FSweepTable MakeSweepTable(const FSweepFolder& Folder, const FSweepPlan& Plan)
{
	RequireResults(Folder, Plan);
	FSweepTable Table;
	Table.Plan = Plan;
	std::vector<FSweepRow> Unsplit;
	for (size_t Index = 0; Index < Plan.Tasks.size(); ++Index)
	{
		(Plan.Tasks[Index].bUnsplit ? Unsplit : Table.Rows).push_back(ReadRow(Folder, Plan, Index));
	}
	AddErrors(Folder, Table);
	for (const FSweepRow& Whole : Unsplit)
	{
		ComparePieces(Folder, Whole, Table);
	}
	NoteIdleAxes(Table);
	NotePieces(Table);
	ListFigures(Table);
	return Table;
}

std::string MakeSweepTableJson(const FSweepTable& Table)
{
	const FSweepPlan& Plan = Table.Plan;
	FJsonWriter Writer('{');
	Writer.Members({{"version", GetVersion()}, {"config", Files::path(Plan.Config).filename().string()},
		{"task", GetSweepTaskNames()[static_cast<size_t>(Plan.Task)]}});
	Writer.Objects("axes", Plan.Axes,
		[&](const FSweepAxis& Axis) { Writer.Members({{"name", Axis.Name}, {"values", Axis.Values}}); });
	Writer.Object("against", Plan.Against, [&](const auto& One) { Writer.Member(One.first, One.second); });
	Writer.Members({{"comparedBy", Plan.bExr ? "final.exr" : "final.png"}, {"figures", Table.Figures}});
	Writer.Objects("rows", Table.Rows,
		[&](const FSweepRow& Row)
		{
			const FSweepTask& Task = Plan.Tasks[Row.Task];
			Writer.Members({{"task", Task.Hash}, {"values", Task.Values}});
			Writer.Object("set", Task.Set, [&](const auto& One) { Writer.Member(One.first, One.second); });
			Writer.MemberIfAny("frames", Task.Frames);
			Writer.Object("figures", Row.Figures, [&](const auto& One) { Writer.Member(One.first, One.second); });
			Writer.Member("pictures", ToVector<std::string>(Row.Pictures, &FSweepPicture::File));
			Writer.Member("messages", Row.Messages);
		});
	Writer.Objects("pieces", Table.Pieces,
		[&](const FSweepPiece& Piece)
		{
			Writer.Members({{"task", Plan.Tasks[Piece.Task].Hash}, {"values", Plan.Tasks[Piece.Task].Values},
				{"frames", static_cast<uint64_t>(Piece.NumFrames)}, {"same", static_cast<uint64_t>(Piece.NumSame)},
				{"max", Piece.Max}, {"rms", Piece.Rms}, {"worst", Piece.Worst}});
		});
	Writer.Member("notes", Table.Notes);
	return Writer.GetText();
}

std::string MakeSweepCsv(const FSweepTable& Table, bool bTiming)
{
	std::string Text = "task";
	for (const FSweepAxis& Axis : Table.Plan.Axes)
	{
		Text += "," + CsvText(Axis.Name);
	}
	for (const std::string& Figure : bTiming ? std::vector<std::string>{"seconds"} : Table.Figures)
	{
		Text += "," + CsvText(Figure);
	}
	Text += "\n";
	for (const FSweepRow& Row : Table.Rows)
	{
		Text += Table.Plan.Tasks[Row.Task].Hash;
		for (const std::string& Value : Table.Plan.Tasks[Row.Task].Values)
		{
			Text += "," + CsvText(Value);
		}
		Text += bTiming ? "," + FormatShortest(Row.Seconds) : "";
		for (const std::string& Figure : bTiming ? std::vector<std::string>() : Table.Figures)
		{
			Text += "," + FormatFigure(Row, Figure);
		}
		Text += "\n";
	}
	return Text;
}

std::string MakeSweepText(const FSweepTable& Table, int Width)
{
	FTextTable Text{{{ETextColumn::Name}, {ETextColumn::Number}, {ETextColumn::Number}, {ETextColumn::Number}},
		{{"figure", "least", "mean", "most"}}};
	for (const std::string& Figure : Table.Figures)
	{
		std::vector<double> Values;
		for (const FSweepRow& Row : Table.Rows)
		{
			const auto Found = Row.Figures.find(Figure);
			if (Found != Row.Figures.end())
			{
				Values.push_back(Found->second);
			}
		}
		double Sum = 0.0;
		std::ranges::for_each(Values, [&](double Value) { Sum += Value; });
		Text.Rows.push_back({Figure, fmt::format("{:.5g}", std::ranges::min(Values)),
			fmt::format("{:.5g}", Sum / static_cast<double>(Values.size())),
			fmt::format("{:.5g}", std::ranges::max(Values))});
	}
	return fmt::format("{} tasks\n", Table.Rows.size()) + Text.Format(Width) + JoinText(Table.Notes, "", [](const std::string& Note) { return Note + "\n"; });
}

} // namespace Drydock
