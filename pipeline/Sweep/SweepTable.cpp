// Reads results in the order of the plan, and compares their pictures.
#include "Sweep/SweepTable.h"

#include "Picture/ImageMetrics.h"
#include "RangeTools.h"
#include "Sweep/SweepErrors.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>
#include <limits>
#include <set>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

void RequireResults(const FSweepFolder& Folder, const FSweepPlan& Plan)
{
	constexpr size_t MostNamed = 5;
	std::vector<std::string> Missing;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		const bool bThere = Folder.HasResult(Task);
		if (!bThere || !Folder.HasGoodResult(Task))
		{
			Missing.push_back(Task.Hash.substr(0, 12) + " (" + DescribeTask(Plan, Task) +
							  (bThere                        ? ") damaged"
								  : Folder.ReadFailure(Task) ? ") failed"
															 : ") missing"));
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

FSweepRow ReadRow(const FSweepFolder& Folder, const FSweepTask& Task)
{
	const Files::path Path = Folder.GetResult(Task);
	const FJsonValue Root = ParseSweepJson(ReadTextFile(Path / "result.json")).value_or(FJsonValue());
	FSweepRow Row;
	Row.Task = &Task;
	const FJsonValue* const Figures = Root.Find("figures");
	for (const FJsonMember& One : Figures != nullptr ? Figures->Members : std::vector<FJsonMember>())
	{
		Row.Figures[One.Key] = One.Value.Number;
	}
	for (const FJsonValue& Frame : Root.GetElements("frames"))
	{
		Row.Pictures.push_back({int(Frame.GetNumber("frame", -1.0)),
			(Path / Frame.GetString("file")).lexically_relative(Folder.GetPath()).generic_string(),
			Frame.GetString("picture")});
	}
	Row.Messages = ToVector<std::string>(Root.GetElements("messages"), &FJsonValue::String);
	Row.Seconds = Folder.ReadSeconds(Task).value_or(0.0);
	return Row;
}

/** Compares rows frame by frame. */
class FSweepComparison
{
public:
	FSweepComparison(const FSweepFolder& InFolder, const FSweepPlan& InPlan)
		: Folder(InFolder)
		, bExr(InPlan.bExr)
	{
	}

	FSweepPiece Compare(const FSweepRow& Row, const FSweepRow& Reference) const
	{
		FSweepPiece Piece;
		Piece.Task = Row.Task;
		for (const FSweepPicture& Picture : Row.Pictures)
		{
			const FSweepPicture* const Other = FindItem(Reference.Pictures, Picture.Frame, &FSweepPicture::Frame);
			if (Other != nullptr && Other->Fingerprint != Picture.Fingerprint)
			{
				const FImageError Error = ComparePictures(Picture, *Other);
				++Piece.NumDifferent;
				Piece.Max = std::max(Piece.Max, Error.Max);
				Piece.Rms = std::max(Piece.Rms, Error.Rms);
			}
		}
		return Piece;
	}

private:
	FComparedImage Read(const FSweepPicture& Picture) const
	{
		Files::path File = Folder.GetPath() / Picture.File;
		return ReadComparedImage((bExr ? File.replace_extension("exr") : File).string());
	}

	FImageError ComparePictures(const FSweepPicture& A, const FSweepPicture& B) const
	{
		const FComparedImage Left = Read(A), Right = Read(B);
		FImageError Error;
		Error.Max = Error.Rms = std::numeric_limits<double>::infinity(); // of pictures of different sizes
		return Left.Image.Width == Right.Image.Width && Left.Image.Height == Right.Image.Height
				   ? CompareImages(
						 Left.Image, Right.Image, {.Encoding = Left.Encoding, .NumChannels = 0, .bPerceived = false})
				   : Error;
	}

	const FSweepFolder& Folder;
	const bool bExr;
};

void AddErrors(const FSweepPlan& Plan, const FSweepComparison& Comparison, std::vector<FSweepRow>& Rows)
{
	std::map<std::vector<std::string>, const FSweepRow*> ByValues;
	std::ranges::for_each(Rows, [&](const FSweepRow& Row) { ByValues[Row.Task->Values] = &Row; });
	for (FSweepRow& Row : Rows)
	{
		std::vector<std::string> Values = Row.Task->Values;
		for (const auto& [Name, Value] : Plan.Against)
		{
			Values[size_t(FindItem(Plan.Axes, Name, &FSweepAxis::Name) - Plan.Axes.data())] = Value;
		}
		const auto Reference = ByValues.find(Values);
		if (Reference != ByValues.end()) // else it is excluded
		{
			const FSweepPiece Error = Comparison.Compare(Row, *Reference->second);
			Row.Figures["error max"] = Error.Max;
			Row.Figures["error rms"] = Error.Rms;
		}
	}
}

/** Pieces of the unsplit cut, and a note on their error. */
void ComparePieces(const FSweepRow& Whole, const FSweepComparison& Comparison, FSweepTable& Table)
{
	size_t NumFrames = 0, NumDifferent = 0;
	double Max = 0.0, Rms = 0.0;
	for (const FSweepRow& Row : Table.Rows)
	{
		if (std::equal(Row.Task->Values.begin(), Row.Task->Values.end() - 1, Whole.Task->Values.begin()))
		{
			Table.Pieces.push_back(Comparison.Compare(Row, Whole));
			NumFrames += Row.Pictures.size();
			NumDifferent += Table.Pieces.back().NumDifferent;
			Max = std::max(Max, Table.Pieces.back().Max);
			Rms = std::max(Rms, Table.Pieces.back().Rms);
		}
	}
	Table.Notes.push_back(
		NumDifferent == 0
			? fmt::format("All {} frames of the first cut are the same bits in pieces and unsplit.", NumFrames)
			: fmt::format(
				  "In pieces {} of {} frames of the first cut differ from the unsplit cut: by {:.3g} RMS in the worst "
				  "frame, by {:.3g} at most.",
				  NumDifferent, NumFrames, Rms, Max));
}

/** All that could show a difference. */
std::string DescribeOutcome(const FSweepRow& Row)
{
	std::string Text = JoinText(Row.Pictures, " ", &FSweepPicture::Fingerprint);
	for (const auto& [Name, Value] : Row.Figures)
	{
		Text += Name.starts_with("error ") ? "" : " " + Name + FormatShortest(Value);
	}
	return Text;
}

/** Axes over which every outcome is the same where the other axes have the same values. */
void NoteIdleAxes(const FSweepPlan& Plan, FSweepTable& Table)
{
	for (size_t Axis = 0; Axis < Plan.Axes.size(); ++Axis)
	{
		std::map<std::vector<std::string>, std::set<std::string>> Outcomes;
		for (const FSweepRow& Row : Table.Rows)
		{
			std::vector<std::string> Others = Row.Task->Values;
			Others[Axis].clear();
			Outcomes[Others].insert(DescribeOutcome(Row));
		}
		if (Outcomes.size() < Table.Rows.size() &&
			std::ranges::all_of(Outcomes, [](const auto& One) { return One.second.size() == 1; }))
		{
			Table.Notes.push_back("The axis " + Plan.Axes[Axis].Name +
								  " changes nothing: pictures and figures are the same for all its values.");
		}
	}
}

} // namespace

FSweepTable MakeSweepTable(const FSweepFolder& Folder, const FSweepPlan& Plan)
{
	RequireResults(Folder, Plan);
	FSweepTable Table;
	std::optional<FSweepRow> Whole;
	for (const FSweepTask& Task : Plan.Tasks)
	{
		FSweepRow Row = ReadRow(Folder, Task);
		Task.bUnsplit ? void(Whole = std::move(Row)) : Table.Rows.push_back(std::move(Row));
	}
	const FSweepComparison Comparison(Folder, Plan);
	if (!Plan.Against.empty())
	{
		AddErrors(Plan, Comparison, Table.Rows);
	}
	NoteIdleAxes(Plan, Table);
	if (Whole)
	{
		ComparePieces(*Whole, Comparison, Table);
	}
	std::set<std::string> Names;
	for (const FSweepRow& Row : Table.Rows)
	{
		std::ranges::for_each(Row.Figures, [&](const auto& One) { Names.insert(One.first); });
	}
	Table.Figures.assign(Names.begin(), Names.end());
	std::stable_partition(
		Table.Figures.begin(), Table.Figures.end(), [](const std::string& Name) { return Name.starts_with("error "); });
	return Table;
}

std::string MakeSweepTableJson(const FSweepPlan& Plan, const FSweepTable& Table)
{
	FJsonWriter Writer('{');
	const auto WriteMember = [&](const auto& One)
	{
		Writer.Member(One.first, One.second);
	};
	Writer.Members(
		{{"version", GetVersion()}, {"config", Files::path(Plan.Config).filename().string()}, {"task", Plan.Kind}});
	Writer.Objects("axes", Plan.Axes,
		[&](const FSweepAxis& Axis) {
			Writer.Members({{"name", Axis.Name}, {"values", Axis.Values}});
		});
	Writer.Object("against", Plan.Against, WriteMember);
	Writer.Members({{"comparedBy", Plan.bExr ? "final.exr" : "final.png"}, {"figures", Table.Figures}});
	Writer.Objects("rows", Table.Rows,
		[&](const FSweepRow& Row)
		{
			Writer.Members({{"task", Row.Task->Hash}, {"values", Row.Task->Values}});
			Writer.Object("set", Row.Task->Set, WriteMember);
			Writer.MemberIfAny("frames", Row.Task->Frames);
			Writer.Object("figures", Row.Figures, WriteMember);
			Writer.Member("pictures", ToVector<std::string>(Row.Pictures, &FSweepPicture::File));
			Writer.Member("messages", Row.Messages);
		});
	Writer.Objects("pieces", Table.Pieces,
		[&](const FSweepPiece& Piece)
		{
			Writer.Members(
				{{"task", Piece.Task->Hash}, {"frames", Piece.Task->Frames}, {"lead", Piece.Task->LeadFrames},
					{"different", uint64_t(Piece.NumDifferent)}, {"max", Piece.Max}, {"rms", Piece.Rms}});
		});
	Writer.Member("notes", Table.Notes);
	return Writer.GetText();
}

std::string MakeSweepCsv(const FSweepPlan& Plan, const FSweepTable& Table, bool bTiming)
{
	const std::vector<std::string> Figures = bTiming ? std::vector<std::string>{"seconds"} : Table.Figures;
	std::string Text = "task," +
					   JoinText(Plan.Axes, "", [](const FSweepAxis& Axis) { return CsvText(Axis.Name) + ","; }) +
					   JoinText(Figures, ",", CsvText) + "\n";
	for (const FSweepRow& Row : Table.Rows)
	{
		Text += Row.Task->Hash;
		std::ranges::for_each(Row.Task->Values, [&](const std::string& Value) { Text += "," + CsvText(Value); });
		for (const std::string& Figure : Figures)
		{
			const auto Found = Row.Figures.find(Figure);
			Text += "," + (bTiming                         ? FormatShortest(Row.Seconds)
							  : Found == Row.Figures.end() ? ""
														   : FormatShortest(Found->second));
		}
		Text += "\n";
	}
	return Text;
}

} // namespace Drydock
